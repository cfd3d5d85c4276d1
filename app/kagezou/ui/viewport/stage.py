"""What is on screen: the renderer of the current context, and the picture it drew last."""

from dataclasses import dataclass, replace

from kagezou.document.model import Document, PictureSource
from kagezou.errors import Problem
from kagezou.io.cels import CelCache
from kagezou.io.images import Steps
from kagezou.render.backdrop import Backdrop
from kagezou.render.presenter import WindowView
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from kagezou.scene.receiving import without_drawings
from kagezou.scene.scene import LayerScene, Scene
from kagezou.ui.viewport.picture_view import PictureView, seen


@dataclass(frozen=True, slots=True)
class Broken:
    """A picture that cannot be shown, and why."""

    source: PictureSource
    problem: Problem


class Stage:
    """Draws a frame where its scene or backdrop changed, and shows it as often as asked.

    Made with the context current, thrown away before the context goes.

    Parameters
    ----------
    cels
        Where decoded drawings come from.
    """

    def __init__(self, cels: CelCache) -> None:
        self._cels = cels
        self._renderer = Renderer(cels)
        self._evaluated: tuple[Document, int, Scene] | None = None
        self._drawn: tuple[Scene, Backdrop, PictureView, int] | None = None
        self.broken: tuple[Broken, ...] = ()
        self.pictures_drawn = 0

    @property
    def device(self) -> str:
        """The name of what draws."""
        return self._renderer.info.renderer

    @property
    def is_software(self) -> bool:
        """Whether the processor draws, not a graphics card."""
        return self._renderer.info.is_software

    def forget_picture(self) -> None:
        """Draw anew next time, because files may have changed."""
        self._evaluated = self._drawn = None

    def draw(
        self,
        document: Document,
        frame: int,
        backdrop: Backdrop,
        view: PictureView = PictureView.COMPOSITE,
        line_px: int = 0,
    ) -> None:
        """Draw a frame unless it is the one drawn last; drawings that cannot be read are left out and noted."""
        scene = self._scene(document, frame)
        if self._drawn == (scene, backdrop, view, line_px):
            return
        whole = self._readable(scene)
        self._renderer.draw_picture(seen(whole, view), backdrop, line_px=line_px)
        self.pictures_drawn += 1
        self._drawn = (scene, backdrop, view, line_px)

    def present(self, view: WindowView) -> None:
        """Place the picture in the window."""
        self._renderer.present(view)

    def read_picture(self) -> Steps:
        """Return the picture drawn last, (H, W, 4) straight sRGB, as the command line would write it."""
        return self._renderer.read_picture()

    def layer_picture(self, document: Document, frame: int, layer_id: str, *, with_shadow: bool) -> Steps:
        """Return a layer alone on nothing, (H, W, 4); what is on screen is drawn anew next time."""
        scene = self._readable(evaluate(document, frame))
        layers = tuple(
            layer if with_shadow else replace(layer, cast=None, received=None)
            for layer in scene.layers
            if layer.id == layer_id
        )
        self._renderer.draw_picture(replace(scene, background=None, layers=layers), Backdrop.TRANSPARENT)
        self._drawn = None
        return self._renderer.read_picture()

    def close(self) -> None:
        """Give the memory back; the context must be current."""
        self._renderer.close()

    def _scene(self, document: Document, frame: int) -> Scene:
        known = self._evaluated
        if known is not None and known[0] is document and known[1] == frame:
            return known[2]
        scene = evaluate(document, frame)
        self._evaluated = (document, frame, scene)
        return scene

    def _readable(self, scene: Scene) -> Scene:
        broken: list[Broken] = []

        def can_be_read(source: PictureSource) -> bool:
            try:
                self._cels.cel(source)
            except Problem as problem:
                broken.append(Broken(source, problem))
                return False
            return True

        def shown(layer: LayerScene) -> LayerScene:
            if layer.drawing is None or can_be_read(layer.drawing.source):
                return layer
            return replace(layer, drawing=None, cast=None, received=None)

        layers = tuple(shown(layer) for layer in scene.layers)
        lost = {each.source for each in broken}
        layers = tuple(without_drawings(layer, lost) for layer in layers)
        background = scene.background if scene.background is None or can_be_read(scene.background) else None
        self.broken = tuple(broken)
        return replace(scene, layers=layers, background=background) if broken else scene
