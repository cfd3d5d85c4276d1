"""A filtered shadow as a silhouette: seen from the light it stands on the card, in the place of the drawing.

Round bodies and meshes have no plane to be laid flat in. What falls on them is cast anew, by the drawing whose shadow
on the ground would be the filtered one: so it goes on over every receiver without a seam.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from kagezou.geometry.box import Box
from kagezou.geometry.card import CardPiece
from kagezou.geometry.placement import around_placed, canvas_from_centred
from kagezou.geometry.polygon import bounding_box
from kagezou.geometry.shadow import Cast, cast_on
from kagezou.geometry.vectors import Matrix
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.gl import GL
from kagezou.render.gpu.mattes import MatteTexture, PlacedMatte, drawn_from
from kagezou.render.gpu.program import Program, Variants
from kagezou.render.gpu.scratches import Scratches
from kagezou.render.gpu.targets import Format, Target
from kagezou.render.passes.blur import Blurred
from kagezou.render.passes.filter import ShapePass
from kagezou.render.prepare.cast_uniforms import piece_limits
from kagezou.render.prepare.filter_job import LARGEST_PLANE_PX, BlurView, FilterJob
from kagezou.render.prepare.moved import MOVED_ALPHA, moved_by, moved_uniforms
from kagezou.render.prepare.occupancy import Occupancy
from kagezou.render.prepare.uniforms import Uniform
from kagezou.scene.scene import ShadowCast

_AROUND_PX = 256
"""How far beyond the canvas a silhouette may reach."""

_RIM_PX = 2
_SQUARE_PX = 32


@dataclass(frozen=True, slots=True)
class Silhouette:
    """A cast whose drawing has been replaced by its filtered silhouette."""

    cast: ShadowCast
    matte: PlacedMatte


class SilhouettePass:
    """Draws the silhouettes of filtered shadows; the last one is kept until the next."""

    def __init__(self, boxes: Boxes, shaper: ShapePass) -> None:
        self._boxes = boxes
        self._shaper = shaper
        self._placed = Variants("common/box.vert", "passes/placed.frag")
        self._neighbours = Program("common/box.vert", "common/neighbours.frag")
        self._on_piece = Variants("common/box.vert", "passes/on_piece.frag")
        self._scratches = Scratches()
        self._shape: Target | None = None
        self._sharp: Target | None = None
        self._on_gpu: MatteTexture | None = None

    def close(self) -> None:
        """Give the memory back."""
        self._placed.close()
        self._neighbours.close()
        self._on_piece.close()
        self._scratches.close()
        for each in (self._shape, self._sharp, self._on_gpu):
            if each is not None:
                each.close()

    def drawn(self, blurred: Blurred, canvas: Box) -> Silhouette | None:
        """Return the silhouette of a filtered shadow; None where it has none.

        Several lights have no common one. What is about as high as the lamp or higher casts no shadow on the ground
        that could be filtered, or one that runs out so far that it is cut off: its silhouette would be headless.
        """
        job = blurred.job
        views = list(_views(job, canvas)) if len(job.cast.lights) == 1 else []
        if not views or None in views:
            return None
        shape, sharp = self._targets(canvas)
        shape.clear()
        self._place(blurred, sharp)
        for found in views:
            assert found is not None
            self._draw_piece(blurred, found, (shape, sharp))
        # The outermost texels are what is found beyond.
        size = shape.box
        for rim in (
            Box(0, 0, size.right, _RIM_PX),
            Box(0, size.bottom - _RIM_PX, size.right, size.bottom),
            Box(0, 0, _RIM_PX, size.bottom),
            Box(size.right - _RIM_PX, 0, size.right, size.bottom),
        ):
            shape.clear(rim)
        if self._on_gpu is not None:
            self._on_gpu.close()
        texture = drawn_from(shape.texture, Format.RGBA16, self._boxes, self._neighbours, {})
        self._on_gpu = MatteTexture(texture, Occupancy(shape.read(size), 0))
        placed = PlacedMatte(self._on_gpu, size.moved(-_AROUND_PX, -_AROUND_PX))
        return Silhouette(_with_its_edge(job.cast), placed)

    def _draw_piece(self, blurred: Blurred, found: "_PieceView", targets: tuple[Target, Target]) -> None:
        """Draw what of the silhouette lies on a piece of the card."""
        shape, sharp = targets
        if not found.piece.limits:
            self._shaper.show(blurred, found.view, shape, sharp)
            return
        alone = self._scratches.like("alone", shape)
        box = self._shaper.show(blurred, found.view, alone, sharp)
        if box is None:
            return
        shape.bind(box)
        GL.glEnable(GL.GL_BLEND)
        GL.glBlendEquation(GL.GL_MAX)
        alone.texture.bind(0)
        switches, limits = piece_limits(found.piece, (-_AROUND_PX, -_AROUND_PX))
        self._on_piece[switches].use({"u_target_size_px": shape.size_px, "u_source": 0, **limits})
        self._boxes.draw_one(box)
        alone.clear(box)

    def _place(self, blurred: Blurred, sharp: Target) -> None:
        """Draw the drawing itself, for where the shadow is left as it is."""
        sharp.bind()
        matte, placement = blurred.matte, blurred.job.cast.placement
        matte.texture.bind(0)
        uniforms: dict[str, Uniform] = {"u_target_size_px": sharp.size_px, "u_matte": 0}
        if placement is None:
            corner = (float(matte.box.left + _AROUND_PX), float(matte.box.top + _AROUND_PX))
            self._placed[frozenset()].use(uniforms | {"u_corner_px": corner})
        else:
            on_target = moved_by(_AROUND_PX, _AROUND_PX) @ placement.canvas_from_centred()
            way = on_target @ moved_by(matte.box.left, matte.box.top)
            self._placed[MOVED_ALPHA].use(uniforms | moved_uniforms(way))
        self._boxes.draw_one(sharp.box)

    def _targets(self, canvas: Box) -> tuple[Target, Target]:
        width, height = (
            -(-(side + 2 * _AROUND_PX) // _SQUARE_PX) * _SQUARE_PX for side in (canvas.width, canvas.height)
        )
        if self._shape is None or self._sharp is None or self._shape.box != Box(0, 0, width, height):
            for old in (self._shape, self._sharp):
                if old is not None:
                    old.close()
            self._shape, self._sharp = (Target(width, height, Format.ALPHA16) for _ in range(2))
        assert self._sharp is not None
        return self._shape, self._sharp


@dataclass(frozen=True, slots=True, eq=False)
class _PieceView:
    piece: CardPiece
    view: BlurView


def _views(job: FilterJob, canvas: Box) -> Iterator[_PieceView | None]:
    """Yield how each piece that holds any of the drawing shows the ground's shadow, seen from the light.

    None for one whose part does not cast wholly.
    """
    cast = job.cast
    # The silhouette is put where the drawing is seen; from there on it is not moved any more.
    seen = around_placed(job.matte.box, canvas_from_centred(cast.placement))
    around = canvas.grown(_AROUND_PX)
    for piece in cast.card.pieces:
        part, beyond = piece.part_of(seen), bounding_box(piece.part_of(around))
        if len(part) == 0 or beyond is None:
            continue
        found = cast_on(cast.camera, cast.receivers[0], piece, cast.lights[0])
        if found is None or not _casts_wholly(job, found, part):
            yield None
            return
        box = beyond.moved(_AROUND_PX - canvas.left, _AROUND_PX - canvas.top)
        shift = np.array([[1.0, 0.0, _AROUND_PX], [0.0, 1.0, _AROUND_PX], [0.0, 0.0, 1.0]])
        on_shape = shift @ _art_from_blurred(found, job)
        yield _PieceView(piece, BlurView(job, cast.receivers[0], on_shape, box, is_silhouette=True))


def _casts_wholly(job: FilterJob, found: Cast, part: Matrix) -> bool:
    """Return whether the shadow of a part (N, 2) of the drawing lies where it can be filtered."""
    corners = np.column_stack([part, np.ones(len(part))]).T
    u, v, w = np.linalg.inv(_art_from_blurred(found, job)) @ corners
    is_near = w > 1e-6 * np.abs(w).max()
    return bool((is_near & (np.maximum(np.abs(u), np.abs(v)) <= LARGEST_PLANE_PX * w)).all())


def _art_from_blurred(found: Cast, job: FilterJob) -> Matrix:
    return np.asarray(found.art_from_canvas @ job.canvas_from_read)


def _with_its_edge(cast: ShadowCast) -> ShadowCast:
    """Return the cast with its alpha taken as it is where its edge is soft, which a level would make crisp again."""
    still = tuple(replace(part, placement=None) for part in cast.figure)
    return replace(cast, figure=still, translucent=cast.edge is not None)
