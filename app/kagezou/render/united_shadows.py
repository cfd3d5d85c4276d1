"""The shadows of a scene by what is laid at once: one alone, or several of like look that unite before opacity."""

from collections.abc import Iterator, Sequence
from itertools import chain

from kagezou.geometry.box import Box
from kagezou.render.coverage_cache import CoverageCache
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.targets import Target, Texture
from kagezou.render.passes.picture import PicturePass
from kagezou.render.passes.unite import Member, UnitePass
from kagezou.scene.scene import LayerScene, Scene
from kagezou.scene.uniting import shadow_groups


class UnitedShadows:
    """Lays the shadows of characters on pictures.

    Parameters
    ----------
    boxes
        What draws.
    shadows
        Where the covered parts of each character's shadow come from.
    """

    def __init__(self, boxes: Boxes, shadows: CoverageCache) -> None:
        self._shadows = shadows
        self._unite = UnitePass(boxes)

    def lay(self, picture: PicturePass, scene: Scene) -> None:
        """Lay all of them, each group in the place of its lowest layer."""
        for group in shadow_groups(scene):
            members = self._members(scene, group)
            alone, second, look = next(members, None), next(members, None), group[0].look
            if alone is not None and second is None:
                picture.lay_shadow(alone.coverage, alone.box, alone.cast, look, alone.measured)
            elif alone is not None and second is not None:
                target, box = self._unite.unite(scene.canvas, chain((alone, second), members), look)
                picture.lay_united(target.texture, box, look)

    def outlined(self, scene: Scene) -> Iterator[tuple[Texture, Box]]:
        """Yield the covered parts whose outlines can be drawn, each character's on its own, to be drawn one by one."""
        yield from ((member.coverage, member.box) for member in self._members(scene, scene.layers))

    def drawn(self, scene: Scene, layers: Sequence[LayerScene]) -> tuple[Target, Box] | None:
        """Return what layers of one look take together, see `UnitePass.unite`; None where no shadow is seen."""
        members = self._members(scene, layers)
        first = next(members, None)
        return None if first is None else self._unite.unite(scene.canvas, chain((first,), members), layers[0].look)

    def close(self) -> None:
        """Give the memory back."""
        self._unite.close()

    def _members(self, scene: Scene, layers: Sequence[LayerScene]) -> Iterator[Member]:
        for layer in layers:
            coverage = self._shadows.coverage(scene, layer)
            if coverage is not None and coverage.box is not None and layer.cast is not None:
                yield Member(coverage.target.texture, coverage.box, layer.cast, coverage.measured)
