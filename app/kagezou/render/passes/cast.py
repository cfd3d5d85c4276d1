"""The pass that casts: a drawing's alpha through the light onto the receivers, as covered parts of canvas pixels."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from enum import Enum
from itertools import product
from typing import Final

import numpy as np

from kagezou.geometry.box import Box, around
from kagezou.geometry.ground import Plane
from kagezou.geometry.polygon import bounding_box
from kagezou.geometry.shadow import Cast
from kagezou.geometry.vectors import Matrix, Vector4
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.gl import GL
from kagezou.render.gpu.mattes import PlacedMatte
from kagezou.render.gpu.program import Program, Variants
from kagezou.render.gpu.scratches import Scratches
from kagezou.render.gpu.targets import Target
from kagezou.render.passes.joined import MOST_PIECES, Joined, JoinedPass
from kagezou.render.prepare.cast_uniforms import FULL_STRENGTH, TRANSLUCENT, Edges, Frame, Grazing
from kagezou.render.prepare.shadow_tiles import CELLS, Fineness, TileGrid, Tiling, tile_grid
from kagezou.render.prepare.uniforms import Uniform
from kagezou.scene.scene import ShadowCast

_FEW: Final = 3
"""Pieces that are drawn one by one."""

CELLS_A_TEXEL = 1.25
"""An edge is integrated over its cell as if it were straight there, so little more than one cell a texel does."""

CELLS_A_TEXEL_SAMPLED = 3.0
"""Plain alpha is only sampled in its cells, and wants more of them."""


@dataclass(frozen=True, slots=True, eq=False)
class Window:
    """The part of a target that is drawn, and which picture of the receivers it shows.

    Parameters
    ----------
    box
        In px of the target.
    canvas_from_target
        (3, 3); None where the target is the canvas.
    max_cells
        Into how many cells a pixel may be split each way; beyond them the mean of the drawing is taken.
    is_shape_only
        Whether shadows are drawn in full strength, however low their light stands.
    """

    box: Box
    canvas_from_target: Matrix | None = None
    max_cells: int = CELLS[-1]
    is_shape_only: bool = False

    def cast(self, on_canvas: Cast) -> Cast:
        """Return a cast as this window shows it."""
        return on_canvas if self.canvas_from_target is None else on_canvas.seen_through(self.canvas_from_target)

    def moved(self, box: Box, by_px: tuple[int, int]) -> "Window":
        """Return the window in which a box of the target shows what was so many px before it."""
        assert self.canvas_from_target is not None
        back = np.eye(3)
        back[:2, 2] = (-by_px[0], -by_px[1])
        return replace(self, box=box, canvas_from_target=self.canvas_from_target @ back)

    def seen_through(self, canvas_from_plane: Matrix) -> "Window":
        """Return this window onto a plane as one onto the canvas, by a (3, 3) map."""
        assert self.canvas_from_target is not None
        return replace(self, canvas_from_target=canvas_from_plane @ self.canvas_from_target)


class Laying(Enum):
    """How a stroke is laid on what its target holds."""

    ADDED = "added"
    UNITED = "united by maximum"
    INSTEAD = "instead of it"


@dataclass(frozen=True, slots=True, eq=False)
class Stroke:
    """The shadow of one card piece from one light on one receiver, sorted into tiles.

    Parameters
    ----------
    cast, frame, grid
        Where it lies, the part of the target it may touch, and what it does in each tile there.
    grazing
        How strong it is.
    matte, is_translucent
        The drawing, and whether its alpha casts as it is.
    """

    cast: Cast
    frame: Frame
    grid: TileGrid
    grazing: Grazing
    matte: PlacedMatte
    is_translucent: bool


@dataclass(frozen=True, slots=True, eq=False)
class Drawing:
    """What is drawn of a cast: its shadow from one light on one receiver, in a window."""

    cast: ShadowCast
    pair: tuple[Plane, Vector4]
    matte: PlacedMatte
    window: Window

    @property
    def grazing(self) -> Grazing:
        """How strong it is."""
        return FULL_STRENGTH if self.window.is_shape_only else Grazing.of(*self.pair)

    @property
    def fineness(self) -> Fineness:
        """Into how many cells a pixel is split."""
        return Fineness(CELLS_A_TEXEL_SAMPLED if self.cast.translucent else CELLS_A_TEXEL, self.window.max_cells)

    def strokes(self, casts: Iterable[Cast]) -> Iterator[Stroke]:
        """Yield the strokes of pieces, their casts as the window shows them."""
        grazing, fineness = self.grazing, self.fineness
        for each in casts:
            frame = Frame(each.region(self.window.box, self.matte.box))
            around = bounding_box(frame.region)
            if around is not None:
                grid = tile_grid(each, around, self.matte, fineness)
                yield Stroke(each, frame, grid, grazing, self.matte, self.cast.translucent)

    def joined(self, casts: Sequence[Cast]) -> Joined:
        """Return many pieces to be drawn together."""
        return Joined(casts, self.cast, self.matte, self.grazing, self.fineness)


def strokes(cast: ShadowCast, pair: tuple[Plane, Vector4], matte: PlacedMatte, window: Window) -> Iterator[Stroke]:
    """Return the strokes of all pieces of a card from one light on one receiver."""
    return Drawing(cast, pair, matte, window).strokes(window.cast(each) for each in cast.on(*pair))


class CastPass:
    """Draws the shadows of all pieces, lights and receivers of a cast, united by maximum."""

    def __init__(self, boxes: Boxes) -> None:
        self._boxes = boxes
        self._edge = Variants("common/box.vert", "passes/cast.frag")
        self._full = Variants("common/box.vert", "common/full.frag")
        self._copy = Program("common/box.vert", "common/shade.frag")
        self._threshold = Program("common/box.vert", "passes/threshold.frag")
        self._joined = JoinedPass(boxes)
        self._scratches = Scratches()

    def draw(self, cast: ShadowCast, matte: PlacedMatte | None, target: Target, old: Box | None) -> Box | None:
        """Draw into ``target``, clearing ``old``; return the box that may hold shadow, None for none."""
        if old is not None:
            target.clear(old)
        if matte is None:
            return None
        return self.unite(cast, matte, target, Window(target.box))

    def unite(self, cast: ShadowCast, matte: PlacedMatte, target: Target, window: Window) -> Box | None:
        """Unite all shadows with what is in a window of ``target``; return the box that may hold shadow."""
        pairs = tuple(product(cast.receivers, cast.lights))
        # The pieces of a card add up along their edges; before such a sum may unite with another light's by maximum
        # it has to be whole, in a target of its own.
        apart = len(cast.card.pieces) > 1 and len(pairs) > 1
        drawn: Box | None = None
        for receiver, light in pairs:
            own = self._scratches.like("apart", target) if apart else target
            box = self._draw_light(cast, (receiver, light), matte, own, window)
            if box is not None:
                if apart:
                    self.merge(own, target, box)
                drawn = around(drawn, box)
        return drawn

    def merge(self, source: Target, target: Target, box: Box) -> None:
        """Unite a box of ``source`` with ``target`` by maximum, and empty it."""
        target.bind(box)
        GL.glEnable(GL.GL_BLEND)
        GL.glBlendEquation(GL.GL_MAX)
        source.texture.bind(0)
        self._copy.use({"u_target_size_px": target.size_px, "u_coverage": 0, "u_opacity": 1.0})
        self._boxes.draw_one(box)
        source.clear(box)

    def close(self) -> None:
        """Give the memory back."""
        self._edge.close()
        self._full.close()
        self._copy.close()
        self._threshold.close()
        self._joined.close()
        self._scratches.close()

    def _draw_light(
        self, cast: ShadowCast, pair: tuple[Plane, Vector4], matte: PlacedMatte, target: Target, window: Window
    ) -> Box | None:
        """Draw what one light casts on one receiver; return the box that may hold it.

        A sheet of a card that is folded back over itself has to be whole, aside, before it may unite with the others.
        """
        sheets: dict[int, list[Cast]] = {}
        for on_canvas in cast.on(*pair):
            sheets.setdefault(on_canvas.sheet, []).append(window.cast(on_canvas))
        drawn: Box | None = None
        for casts in sheets.values():
            drawing = Drawing(cast, pair, matte, window)
            own = target if drawn is None or len(casts) == 1 else self._scratches.like("sheet", target)
            box = self._draw_sheet(casts, drawing, own)
            if box is not None and own is not target:
                self.merge(own, target, box)
            drawn = around(drawn, box)
        return drawn

    def _draw_sheet(self, casts: Sequence[Cast], drawing: "Drawing", target: Target) -> Box | None:
        """Draw shadows that continue one another; a single one unites with what is there."""
        drawn: Box | None = None
        if len(casts) > _FEW:
            for first in range(0, len(casts), MOST_PIECES):
                joined = drawing.joined(casts[first : first + MOST_PIECES])
                drawn = around(drawn, self._joined.add(joined, target, drawing.window.box))
            return drawn
        how = Laying.UNITED if len(casts) == 1 else Laying.ADDED
        for stroke in drawing.strokes(casts):
            tiling = stroke.grid.tiling(drawing.window.box)
            self.paint(stroke, tiling, target, how)
            drawn = around(drawn, tiling.box)
        return drawn

    def paint(self, stroke: Stroke, tiling: Tiling, target: Target, how: Laying) -> None:
        """Draw some tiles of a stroke."""
        each, frame, matte, box = stroke.cast, stroke.frame, stroke.matte, tiling.box
        if box is None:
            return
        if any(kind.is_squeezed for kind in tiling.edges):
            matte.on_gpu.means(self._boxes, self._threshold, translucent=stroke.is_translucent).bind(1)
        target.bind(box)
        if how is not Laying.INSTEAD:
            GL.glEnable(GL.GL_BLEND)
            GL.glBlendFunc(GL.GL_ONE, GL.GL_ONE)
            GL.glBlendEquation(GL.GL_FUNC_ADD if how is Laying.ADDED else GL.GL_MAX)
        switches = stroke.grazing.switches(each.receiver_from_canvas, frame)
        uniforms: dict[str, Uniform] = {"u_target_size_px": target.size_px, "u_origin_px": frame.origin}
        uniforms |= stroke.grazing.uniforms(each.receiver_from_canvas, frame)
        if len(tiling.full):
            self._full[switches].use(uniforms)
            self._boxes.draw(tiling.full)
        if stroke.is_translucent:
            switches |= TRANSLUCENT
        matte.texture.bind(0)
        self._draw_edges(tiling, Edges(each, matte, frame), switches, uniforms)

    def _draw_edges(self, tiling: Tiling, edges: Edges, switches: frozenset[str], uniforms: dict[str, Uniform]) -> None:
        uniforms = uniforms | edges.uniforms()
        limits = edges.limits()
        for kind, boxes in tiling.edges.items():
            if kind.is_at_limit:
                self._edge[switches | kind.switches | edges.limit_switches()].use(uniforms | limits)
            else:
                self._edge[switches | kind.switches].use(uniforms)
            self._boxes.draw(boxes)
