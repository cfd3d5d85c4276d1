"""The covered parts of each layer's shadow, kept as long as nothing that shapes them changes."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from kagezou.geometry.box import Box
from kagezou.geometry.mesh import Mesh
from kagezou.io.images.cel_cache import CelSource
from kagezou.io.images.reading import Matte
from kagezou.io.sets.mesh_cache import MeshCache
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.budget import Budget
from kagezou.render.gpu.mattes import Mattes, PlacedMatte
from kagezou.render.gpu.targets import Format, Target, Texture
from kagezou.render.passes.cast import CastPass
from kagezou.render.passes.figure_mattes import FigureMattes
from kagezou.render.passes.filter import ShapePass
from kagezou.render.passes.hardening import HardeningPass
from kagezou.render.passes.received import ReceivedCoverage, ReceivedLayers
from kagezou.render.prepare.least_parts import without_least_parts
from kagezou.scene.companions import contact_layer
from kagezou.scene.pieces import PieceScene, SetCast
from kagezou.scene.scene import LayerScene, Scene, ShadowCast

if TYPE_CHECKING:  # what draws sets is loaded with the first one
    from kagezou.render.meshes.display import Display, SetPicture
    from kagezou.render.sets.distance import DistancePass
    from kagezou.render.sets.set_pass import SetPass

COVERAGE_BUDGET_BYTES = 384 << 20
"""What the shadows of all layers may take together; those of 90 layers at 1920 × 1080 px fit."""


@dataclass(frozen=True, slots=True)
class Budgets:
    """What a renderer may keep on the graphics card, bytes.

    Parameters
    ----------
    shadows
        For the shadows of layers.
    mattes
        For the drawings that cast them.
    """

    shadows: int = COVERAGE_BUDGET_BYTES
    mattes: int = 256 << 20


@dataclass(slots=True)
class Coverage:
    """A target (16 bit, canvas size) and the box within it that may hold shadow.

    ``distances`` are those on a set, from the contact line of a cast, where a look asks for them.
    """

    target: Target
    box: Box | None = None
    cast: ShadowCast | None = None
    mattes: tuple[Matte, ...] = ()
    meshes: tuple[Mesh, ...] = ()
    distances: Target | None = None
    measured_cast: ShadowCast | None = None

    @property
    def measured(self) -> Texture | None:
        """The distances of the cast that is drawn."""
        return self.distances.texture if self.distances is not None and self.measured_cast is self.cast else None

    @property
    def nbytes(self) -> int:
        """The memory it takes."""
        return self.target.texture.nbytes + (0 if self.distances is None else self.distances.texture.nbytes)

    def close(self) -> None:
        """Give the memory back."""
        self.target.close()
        if self.distances is not None:
            self.distances.close()


class CoverageCache:
    """Casts a layer's shadow unless the last one of the same cast is still there.

    Whoever gets one uses it before asking for the one after the next: by then its memory may have gone to others.
    """

    def __init__(self, boxes: Boxes, cels: CelSource, meshes: MeshCache, budgets: Budgets) -> None:
        self._mattes = Mattes(boxes, budgets.mattes)
        self._figures = FigureMattes(boxes, cels, self._mattes)
        self._cast = CastPass(boxes)
        self._shape = ShapePass(boxes, self._cast)
        self._boxes = boxes
        self._made_set: SetPass | None = None
        self._made_distance: DistancePass | None = None
        self._between: Callable[[], None] | None = None
        self._hardening = HardeningPass(boxes)
        self._received = ReceivedLayers(boxes, (self._cast, self._hardening), cels, self._figures)
        self._of_set: Coverage | None = None
        self._seen: Coverage | None = None
        self._meshes = meshes
        self._set_cast: tuple[SetCast, tuple[Mesh, ...]] | None = None
        self._by_layer: Budget[str, Coverage] = Budget(budgets.shadows)
        self.casts_drawn = 0
        self.filters_drawn = 0

    def call_between(self, between: Callable[[], None]) -> None:
        """Have something called before each face of a set is drawn; what it raises ends the drawing."""
        self._between = between
        if self._made_set is not None:
            self._made_set.call_between(between)

    @property
    def meshes_seen(self) -> tuple[int, int]:
        """How often the camera's view of meshes has been drawn, and how many lights' views."""
        return (0, 0) if self._made_set is None else self._made_set.meshes_seen

    def silhouette(self, scene: Scene, cast: ShadowCast) -> PlacedMatte | None:
        """Return what casts a shadow, in px before its placement moves it; None where all cels are empty."""
        return self._figures.placed(cast, scene.canvas)

    def coverage(self, scene: Scene, layer: LayerScene) -> Coverage | None:
        """Return the covered parts of a layer's shadow, or None where it has none."""
        if layer.cast is None:
            return None
        kept = self._kept(scene.canvas, layer.id)
        mattes = self._figures.mattes_of(layer.cast)
        meshes = self._meshes_of(layer.cast.pieces)
        if kept.cast != layer.cast or kept.mattes != mattes or kept.meshes != meshes:
            placed = self._figures.placed(layer.cast, scene.canvas)
            # Until the new one is whole the target holds no one knows what: a failure half-way leaves it to be cleared.
            old, kept.box, kept.cast = kept.box, scene.canvas, None
            plain = self._shape.draw if layer.cast.is_filtered else self._cast.draw
            draw = self._set.draw if layer.cast.pieces else plain
            kept.box = draw(layer.cast, placed, kept.target, old)
            if layer.cast.least_part_px2 > 0 and kept.box is not None:
                _leave_out_least_parts(kept.target, kept.box, layer.cast.least_part_px2)
            if layer.cast.is_hard and not layer.cast.translucent and kept.box is not None:
                self._hardening.harden(kept.target, kept.box)
            kept.cast, kept.mattes, kept.meshes = layer.cast, mattes, meshes
            self.casts_drawn += 1
            self.filters_drawn += layer.cast.is_filtered
        if layer.cast.pieces and not layer.look.is_plain and kept.box is not None:
            self._measure(kept)
        return kept if kept.box is not None else None

    def received(self, scene: Scene, layer: LayerScene) -> tuple[ReceivedCoverage, ...]:
        """Return the covered parts of a character, on which others cast, by the looks of their shadows."""
        return self._received.coverages(scene, layer)

    def set_coverage(self, scene: Scene) -> Coverage | None:
        """Return the covered parts of the shadow of the set itself, or None where it has none."""
        if scene.set_shadow is None:
            return None
        kept = _fitting(self._of_set, scene.canvas)
        cast = (scene.set_shadow.cast, self._meshes_of(scene.set_shadow.cast.pieces))
        if kept is not self._of_set or self._set_cast != cast:
            self._of_set = kept
            old, kept.box, self._set_cast = kept.box, scene.canvas, None
            kept.box = self._set.own.draw(scene.set_shadow.cast, kept.target, old)
            self._set_cast = cast
            self.casts_drawn += 1
        return kept if kept.box is not None else None

    def seen_of_set(self, canvas: Box, cast: SetCast) -> Coverage:
        """Return where the pieces that cast are seen, or, where none does, the ground."""
        kept = self._seen = _fitting(self._seen, canvas)
        kept.box = self._set.own.draw_seen(cast, kept.target)
        return kept

    def set_pictures(self, scene: Scene, displays: "Sequence[Display]") -> "tuple[SetPicture, ...]":
        """Return what is to be shown of meshes themselves, those under the background first."""
        if not any(piece.mesh for piece in scene.pieces):
            return ()
        return self._set.pictures(SetCast(scene.camera, scene.ground, scene.pieces, ()), scene.canvas, displays)

    def forget_except(self, scene: Scene) -> None:
        """Give back the memory of layers that the scene no longer has, and of meshes where it has none."""
        if self._made_set is not None and not any(piece.mesh for piece in scene.pieces):
            self._made_set.forget_meshes()
        patches = map(contact_layer, scene.layers)
        alive = {layer.id for layer in (*scene.layers, *patches) if layer is not None}
        self._by_layer.forget(each for each in self._by_layer.names if each not in alive)
        self._received.forget_except(alive)

    def close(self) -> None:
        """Give the memory back."""
        self._by_layer.close()
        for kept in (self._of_set, self._seen):
            if kept is not None:
                kept.target.close()
        self._received.close()
        self._hardening.close()
        for made in (self._made_distance, self._made_set):
            if made is not None:
                made.close()
        self._shape.close()
        self._cast.close()
        self._figures.close()
        self._mattes.close()

    @property
    def _set(self) -> "SetPass":
        if self._made_set is None:
            from kagezou.render.sets.set_pass import SetPass

            self._made_set = SetPass(self._boxes, self._cast, self._shape, self._meshes)
            if self._between is not None:
                self._made_set.call_between(self._between)
        return self._made_set

    @property
    def _distance(self) -> "DistancePass":
        if self._made_distance is None:
            from kagezou.render.sets.distance import DistancePass

            self._made_distance = DistancePass(self._boxes, self._cast)
        return self._made_distance

    def _measure(self, kept: Coverage) -> None:
        """Find how far from the contact line each pixel is, unless that is known."""
        if kept.cast is None or kept.measured_cast is kept.cast:
            return
        if kept.distances is None:
            kept.distances = Target(kept.target.box.width, kept.target.box.height, Format.FLOAT)
        self._distance.draw(kept.cast, kept.distances)
        kept.measured_cast = kept.cast

    def _meshes_of(self, pieces: tuple[PieceScene, ...]) -> tuple[Mesh, ...]:
        """Return the meshes of pieces, which are compared by identity: a changed file gives another one."""
        return tuple(self._meshes.mesh(piece.mesh.path) for piece in pieces if piece.mesh is not None)

    def _kept(self, canvas: Box, layer_id: str) -> Coverage:
        return self._by_layer.latest(layer_id, lambda kept: _fitting(kept, canvas))


def _leave_out_least_parts(target: Target, box: Box, least_px2: float) -> None:
    """Take islands and holes out of what has been drawn into a box, looking one px beyond it where there is any."""
    seen = box.grown(1).intersection(target.box)
    if seen is None:
        return
    rows = Box(0, seen.top, target.box.right, seen.bottom)
    covered = target.read(rows).astype(np.uint16, copy=False)
    part = covered[:, seen.left : seen.right]
    kept = without_least_parts(part, least_px2)
    if kept is not part:
        part[:] = kept
        target.texture.upload(covered, rows.top)


def _fitting(kept: Coverage | None, canvas: Box) -> Coverage:
    """Return what was kept, or an empty one where nothing was or the canvas has another size."""
    if kept is not None and kept.target.box == canvas:
        return kept
    if kept is not None:
        kept.close()
    target = Target(canvas.width, canvas.height, Format.ALPHA16)
    target.clear()
    return Coverage(target)
