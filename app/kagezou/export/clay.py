"""Imported sets that are drawn as clay, as a layer of their own; wireframes are for the window alone."""

from dataclasses import dataclass
from typing import Self

from kagezou.export.contents import Content, clay_in, sets_in
from kagezou.export.painter import Painter
from kagezou.export.pictures import FlatPicture, Picture
from kagezou.export.sources import Sources
from kagezou.geometry.camera import Camera
from kagezou.scene.pieces import PieceScene
from kagezou.scene.scene import Scene


@dataclass(frozen=True, slots=True)
class ClayContent(Content):
    """Sets drawn as clay, over the background picture or under it.

    Parameters
    ----------
    camera, meshes
        What sets are seen with, and all there are, as each hides others.
    is_under
        Whether it is those under the background picture.
    """

    camera: Camera
    meshes: tuple[PieceScene, ...]
    is_under: bool

    @classmethod
    def of(cls, scene: Scene, *, is_under: bool) -> Self | None:
        """Return the content of a scene's sets; None where none of them is drawn there as clay."""
        found = clay_in(scene)
        if found is None or not any(each.display == "clay" and each.is_under == is_under for each in found[1]):
            return None
        return cls(scene, *found, is_under)

    def draw(self, painter: Painter) -> Picture:
        """Draw the sets."""
        return FlatPicture(painter.renderer.clay(self.scene, painter.depth, is_under=self.is_under))

    @property
    def sources(self) -> Sources:
        """The sets."""
        return Sources(sets=sets_in(self.scene))

    @property
    def is_filled(self) -> bool:
        """Whether it may fill the picture: always."""
        return True
