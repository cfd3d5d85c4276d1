"""The pass of joined pieces: the shadows of a card's pieces that continue one another, drawn together."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from kagezou.geometry.box import Box
from kagezou.geometry.card import Card
from kagezou.geometry.placement import Placement
from kagezou.geometry.polygon import box_polygon, clipped, shifted
from kagezou.geometry.shadow import Cast
from kagezou.geometry.vectors import Matrix
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.gl import GL
from kagezou.render.gpu.mattes import PlacedMatte
from kagezou.render.gpu.program import Program, Variants
from kagezou.render.gpu.targets import Target
from kagezou.render.prepare.cast_uniforms import TRANSLUCENT, Frame, Grazing, JoinedEdges
from kagezou.render.prepare.piece_tiles import regions_of
from kagezou.render.prepare.shadow_tiles import Fineness
from kagezou.render.prepare.uniforms import Uniform
from kagezou.scene.scene import ShadowCast

if TYPE_CHECKING:
    from kagezou.render.prepare.joined_tiles import JoinedTiling

MOST_PIECES = 24
"""As many are drawn together as the uniforms of any driver hold."""

_TABLE_SIZES = (12, MOST_PIECES)


@dataclass(frozen=True, slots=True, eq=False)
class Joined:
    """Shadows that continue one another.

    Parameters
    ----------
    casts
        Of pieces of a card, from one light on one receiver.
    of, matte
        What casts.
    grazing
        How strong they are.
    fineness
        Into how many cells a pixel is to be split.
    """

    casts: Sequence[Cast]
    of: ShadowCast
    matte: PlacedMatte
    grazing: Grazing
    fineness: Fineness


class JoinedPass:
    """Draws the shadows of many pieces with as few calls as those of one."""

    def __init__(self, boxes: Boxes) -> None:
        self._boxes = boxes
        self._edge = Variants("passes/cast_pieces.vert", "passes/cast.frag")
        self._full = Variants("common/box.vert", "common/full.frag")
        self._threshold = Program("common/box.vert", "passes/threshold.frag")

    def close(self) -> None:
        """Give the memory back."""
        self._edge.close()
        self._full.close()
        self._threshold.close()

    def add(self, joined: Joined, target: Target, canvas: Box) -> Box | None:
        """Add shadows to a box of ``target``; return the box that may hold them, None for none."""
        matte = joined.matte
        parts = _parts_of(joined.of.card, matte.box, joined.of.placement)
        casts = [cast for cast in joined.casts if len(parts[cast.number])]
        if not casts:
            return None
        regions = regions_of(casts, [parts[cast.number] for cast in casts], matte.box, canvas)
        found = [(cast, region) for cast, region in zip(casts, regions, strict=True) if region is not None]
        if not found:
            return None
        casts, boxes = [cast for cast, _ in found], [region for _, region in found]
        # Few cards are of so many pieces.
        from kagezou.render.prepare.joined_tiles import joined_tiling

        tiling = joined_tiling(casts, boxes, matte, joined.fineness, canvas)
        if tiling.box is not None:
            region = clipped(box_polygon(tiling.box.grown(1)), shifted(casts[0].horizon, -0.01))
            self._paint(joined, tiling, JoinedEdges(tuple(casts), matte, Frame(region)), target)
        return tiling.box

    def _paint(self, joined: Joined, tiling: "JoinedTiling", edges: JoinedEdges, target: Target) -> None:
        frame, matte, first = edges.frame, joined.matte, edges.casts[0]
        if any(kind.edge.is_squeezed for kind in tiling.edges):
            matte.on_gpu.means(self._boxes, self._threshold, translucent=joined.of.translucent).bind(1)
        target.bind(tiling.box)
        GL.glEnable(GL.GL_BLEND)
        GL.glBlendFunc(GL.GL_ONE, GL.GL_ONE)
        switches = joined.grazing.switches(first.receiver_from_canvas, frame)
        uniforms: dict[str, Uniform] = {"u_target_size_px": target.size_px, "u_origin_px": frame.origin}
        uniforms |= joined.grazing.uniforms(first.receiver_from_canvas, frame)
        if len(tiling.full):
            self._full[switches].use(uniforms)
            self._boxes.draw(tiling.full)
        matte.texture.bind(0)
        uniforms |= edges.uniforms()
        limits = edges.limits()
        size = next(each for each in _TABLE_SIZES if each >= len(edges.casts))
        switches |= {f"PIECES {size}"} | (TRANSLUCENT if joined.of.translucent else frozenset())
        if not tiling.edges:
            return
        boxes, numbers = (np.concatenate(each) for each in zip(*tiling.edges.values(), strict=True))
        self._boxes.load_numbered(boxes, numbers)
        start = 0
        for kind, (own, _) in tiling.edges.items():
            self._edge[switches | kind.switches].use(uniforms | limits if kind.edge.is_at_limit else uniforms)
            self._boxes.draw_loaded(start, len(own))
            start += len(own)


@lru_cache(maxsize=16)
def _parts_of(card: Card, art: Box, placement: Placement | None) -> tuple[Matrix, ...]:
    """Return the polygons (N, 2) of a drawing's box that lie on each piece, in its own px; not to be changed."""
    if placement is None:
        return tuple(piece.part_of(art) for piece in card.pieces)
    there, back = placement.canvas_from_centred(), placement.centred_from_canvas()
    seen = _moved(there, box_polygon(art))
    # Mirrored, a polygon runs the other way round; a part of it is clipped as any.
    return tuple(_moved(back, piece.part_of_polygon(seen)) for piece in card.pieces)


def _moved(affine: Matrix, polygon: Matrix) -> Matrix:
    return np.asarray(polygon @ affine[:2, :2].T + affine[:2, 2])
