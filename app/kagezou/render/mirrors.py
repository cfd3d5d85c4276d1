"""The figures of a scene as the ground mirrors them, kept as long as nothing about them changes."""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from weakref import ref

from kagezou.geometry.box import Box
from kagezou.io.images.cel_cache import CelSource
from kagezou.io.images.reading import Cel
from kagezou.render.coverage_cache import CoverageCache
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.budget import Budget
from kagezou.render.gpu.targets import Format, Target, Texture
from kagezou.render.passes.mirror import MirrorPass
from kagezou.scene.pieces import SetCast
from kagezou.scene.scene import LayerScene, Reflection, Scene

_BUDGET_BYTES = 256 << 20


@dataclass(slots=True)
class MirroredFigure:
    """A picture of the canvas' size, 16 bit straight colour and alpha, and the box within it that may hold anything.

    ``reflection`` and ``cels``, which are not kept alive, say what it was drawn of.
    """

    target: Target
    box: Box | None = None
    reflection: Reflection | None = None
    cels: tuple[ref[Cel], ...] = ()

    @property
    def nbytes(self) -> int:
        """The memory it takes."""
        return self.target.texture.nbytes

    def close(self) -> None:
        """Give the memory back."""
        self.target.close()


class Mirrors:
    """Mirrors a layer's figure unless the last one of the same is still there.

    Parameters
    ----------
    boxes
        What draws.
    cels
        Where drawings come from.
    shadows
        What knows where the ground is seen between the pieces of a set.
    """

    def __init__(self, boxes: Boxes, cels: CelSource, shadows: CoverageCache) -> None:
        self._cels, self._shadows = cels, shadows
        self._mirror = MirrorPass(boxes)
        self._kept: Budget[str, MirroredFigure] = Budget(_BUDGET_BYTES)
        self.drawn = 0

    def mirrored(self, scene: Scene, layer: LayerScene) -> MirroredFigure | None:
        """Return the reflection of a layer's figure; None where it has none or nothing of it is seen.

        Raises
        ------
        InputProblem
            A cel cannot be read.
        """
        reflection = layer.reflection
        if reflection is None or not reflection.ground_receives:
            return None
        cels = tuple(self._cels.cel(cel.source) for cel in reflection.figure)
        kept = self._kept.latest(layer.id, lambda known: _fitting(known, scene.canvas))
        if kept.reflection != reflection or [each() for each in kept.cels] != list(cels):
            # Until the new one is whole no one knows what the target holds.
            if kept.box is not None:
                kept.target.clear(kept.box)
            kept.box, kept.reflection = scene.canvas, None
            ground = self._ground(scene, reflection)
            kept.box = self._mirror.draw(reflection, cels, ground, kept.target)
            kept.reflection, kept.cels = reflection, tuple(ref(cel) for cel in cels)
            self.drawn += 1
        return None if kept.box is None else kept

    def forget_except(self, layers: Iterable[LayerScene]) -> None:
        """Give the memory of layers back that are gone or mirrored no more."""
        alive = {layer.id for layer in layers if layer.reflection is not None}
        self._kept.forget(each for each in self._kept.names if each not in alive)

    def close(self) -> None:
        """Give the memory back."""
        self.forget_except(())
        self._mirror.close()

    def _ground(self, scene: Scene, reflection: Reflection) -> Texture | None:
        if not reflection.pieces:
            return None
        idle = tuple(replace(piece, casts=False, blocks=False, receives=False) for piece in reflection.pieces)
        return self._shadows.seen_of_set(scene.canvas, SetCast(scene.camera, scene.ground, idle, ())).target.texture


def _fitting(kept: MirroredFigure | None, canvas: Box) -> MirroredFigure:
    """Return what was kept, or an empty one where nothing was or the canvas has another size."""
    if kept is not None and kept.target.box == canvas:
        return kept
    if kept is not None:
        kept.close()
    target = Target(canvas.width, canvas.height, Format.RGBA16)
    target.clear()
    return MirroredFigure(target)
