"""Finished pictures: what is laid over what, from the backdrop up."""

from typing import TYPE_CHECKING

from kagezou.errors import GraphicsProblem
from kagezou.geometry.box import Box
from kagezou.io.images.cel_cache import CelSource
from kagezou.message import Message
from kagezou.render.coverage_cache import CoverageCache
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.targets import Format
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.scene.companions import contact_layer
from kagezou.scene.scene import Scene

if TYPE_CHECKING:  # what lays pictures together is loaded by whoever wants more than shadows
    from kagezou.render.mirrors import Mirrors
    from kagezou.render.passes.picture import PicturePass
    from kagezou.render.united_shadows import UnitedShadows

_SQUARE_PX = 16
"""The checkered backdrop's, canvas px."""


class Composites:
    """Draws pictures; the last one stays until the next.

    Parameters
    ----------
    boxes
        What draws.
    cels
        Where drawings come from.
    shadows
        Where the covered parts of shadows come from.
    divisor
        As of `Renderer`.
    """

    def __init__(self, boxes: Boxes, cels: CelSource, shadows: CoverageCache, divisor: int) -> None:
        self._boxes, self._cels, self._shadows, self._divisor = boxes, cels, shadows, divisor
        self._picture: PicturePass | None = None
        self._made_united: UnitedShadows | None = None
        self._made_mirrors: Mirrors | None = None

    @property
    def united(self) -> "UnitedShadows":
        """What makes shadows of one look one."""
        if self._made_united is None:
            from kagezou.render.united_shadows import UnitedShadows

            self._made_united = UnitedShadows(self._boxes, self._shadows)
        return self._made_united

    @property
    def mirrors(self) -> "Mirrors":
        """What mirrors figures in the ground."""
        if self._made_mirrors is None:
            from kagezou.render.mirrors import Mirrors

            self._made_mirrors = Mirrors(self._boxes, self._cels, self._shadows)
        return self._made_mirrors

    @property
    def drawn(self) -> "PicturePass":
        """The picture drawn last.

        Raises
        ------
        GraphicsProblem
            There is none yet.
        """
        if self._picture is None:
            raise GraphicsProblem(Message("there is no picture yet"))
        return self._picture

    def draw(self, scene: Scene, backdrop: Backdrop, depth: int, line_px: int, *, wireframes: bool) -> None:
        """Draw a scene as `Renderer.draw_picture` says."""
        from kagezou.render.meshes.display import Display

        form = Format.RGBA8 if depth == 8 else Format.RGBA16
        picture = self._picture_for(scene.canvas, form)
        displays = (Display.CLAY, Display.WIREFRAME) if wireframes else (Display.CLAY,)
        picture.begin(backdrop, scene.background, self._shadows.set_pictures(scene, displays))
        self._lay_set_shadow(picture, scene)
        self._shadows.forget_except(scene)
        self.mirrors.forget_except(scene.layers)
        # Whole drawings first: each then serves its matte too, and no file is read twice.
        cels = {each.id: self._cels.cel(each.drawing.source) for each in scene.layers if each.drawing is not None}
        if not line_px:
            self.united.lay(picture, scene)
            self._lay_beside(picture, scene)
        for layer in scene.layers:
            if layer.drawing is not None:
                picture.lay_cel(cels[layer.id], layer.drawing.placement)
            for shade in () if line_px else self._shadows.received(scene, layer):
                if shade.box is not None:
                    picture.lay_shadow(shade.target.texture, shade.box, None, shade.look)
        if line_px:
            self._lay_outlines(picture, scene, line_px)

    def draw_clay(self, scene: Scene, depth: int, *, is_under: bool) -> None:
        """Draw a scene's sets as clay alone: those under the background picture, or those over it."""
        from kagezou.render.meshes.display import Display

        picture = self._picture_for(scene.canvas, Format.RGBA8 if depth == 8 else Format.RGBA16)
        sets = self._shadows.set_pictures(scene, (Display.CLAY,))
        picture.begin(Backdrop.TRANSPARENT, None, tuple(each for each in sets if each.is_under == is_under))

    def close(self) -> None:
        """Give the memory back."""
        for made in (self._picture, self._made_mirrors, self._made_united):
            if made is not None:
                made.close()

    def _lay_set_shadow(self, picture: "PicturePass", scene: Scene) -> None:
        coverage = self._shadows.set_coverage(scene)
        if coverage is not None and coverage.box is not None and scene.set_shadow is not None:
            picture.lay_shadow(coverage.target.texture, coverage.box, None, scene.set_shadow.look)

    def _lay_outlines(self, picture: "PicturePass", scene: Scene, line_px: int) -> None:
        """Lay the outlines of shadows over everything, each as soon as it is there."""
        for texture, box in self.united.outlined(scene):
            picture.lay_outline(texture, box, line_px)
        for layer in scene.layers:
            for shade in self._shadows.received(scene, layer):
                if shade.box is not None:
                    picture.lay_outline(shade.target.texture, shade.box, line_px)

    def _lay_beside(self, picture: "PicturePass", scene: Scene) -> None:
        """Lay what figures have beside their shadows: patches under their feet, and over them their reflections."""
        for patches in map(contact_layer, scene.layers):
            coverage = None if patches is None else self._shadows.coverage(scene, patches)
            if patches is not None and coverage is not None and coverage.box is not None:
                picture.lay_shadow(coverage.target.texture, coverage.box, patches.cast, patches.look)
        for layer in scene.layers:
            mirrored = self.mirrors.mirrored(scene, layer)
            if mirrored is not None and mirrored.box is not None:
                picture.lay_reflection(mirrored.target.texture, mirrored.box)

    def _picture_for(self, canvas: Box, form: Format) -> "PicturePass":
        old = self._picture
        if old is not None and (old.target.box != canvas or old.target.texture.form is not form):
            old.close()
            self._picture = None
        if self._picture is None:
            from kagezou.render.passes.picture import PicturePass

            self._picture = PicturePass(self._boxes, canvas, form, self._cels, _SQUARE_PX // self._divisor)
        return self._picture
