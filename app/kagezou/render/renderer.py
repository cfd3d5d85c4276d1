"""The renderer: the one way from a scene to pixels, for the window, the command line and a farm alike."""

from collections.abc import Callable, Sequence

import numpy as np

from kagezou.errors import Stopped
from kagezou.geometry.box import Box
from kagezou.io.images.cel_cache import CelSource
from kagezou.io.images.reading import Steps
from kagezou.io.images.writing import ShadowImage
from kagezou.io.sets.mesh_cache import MeshCache
from kagezou.render.composites import Composites
from kagezou.render.coverage_cache import Budgets, Coverage, CoverageCache
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.gl import GL, check
from kagezou.render.gpu.info import read_info
from kagezou.render.gpu.presenter import Presenter, WindowView
from kagezou.render.passes.received import ReceivedCoverage
from kagezou.render.passes.shadow_image import Coloring, Drawn, ShadowImages
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.scene.companions import contact_layer
from kagezou.scene.pieces import SetCast
from kagezou.scene.scene import LayerScene, Scene, SetShadow, ShadowLook

_WHITE_MATTE = ShadowLook((255, 255, 255), 1.0, multiply=False)


class Renderer:
    """Draws scenes into targets of its own, with the context that is current when it is made and used.

    Lost with its context; whoever holds it throws it away and makes another. Every draw states the whole OpenGL state
    it relies on, so that nothing another user of the context leaves behind changes a pixel.

    Parameters
    ----------
    cels, meshes
        Where decoded drawings and meshes come from.
    divisor
        How many px of the cut's own canvas are one of the scenes that are drawn, for previews.
    budgets
        What may be kept for the next picture.

    Raises
    ------
    GraphicsProblem
        If the context is older than OpenGL 3.3 or the driver fails.
    """

    def __init__(
        self,
        cels: CelSource,
        meshes: MeshCache | None = None,
        divisor: int = 1,
        budgets: Budgets = Budgets(),  # noqa: B008 - frozen
    ) -> None:
        self.info = read_info()
        self._boxes = Boxes()
        self._shadows = CoverageCache(self._boxes, cels, meshes or MeshCache(), budgets)
        self._composites = Composites(self._boxes, cels, self._shadows, divisor)
        self._images = ShadowImages(self._boxes)
        self._presenter = Presenter(self._boxes)
        check("setting up")

    def stop_when(self, stops: Callable[[], bool]) -> None:
        """Have it ask before each face of a set whether to stop; drawing raises `Stopped` then."""

        def between() -> None:
            if stops():
                raise Stopped

        self._shadows.call_between(between)

    @property
    def casts_drawn(self) -> int:
        """How many shadows have been cast so far; a shadow that stays as it was is not cast again."""
        return self._shadows.casts_drawn

    @property
    def filters_drawn(self) -> int:
        """How many of those shadows have been simplified."""
        return self._shadows.filters_drawn

    @property
    def meshes_seen(self) -> tuple[int, int]:
        """How often the camera's view of meshes has been drawn, and how many lights' views; kept while they stay."""
        return self._shadows.meshes_seen

    def shadow(self, scene: Scene, layer: LayerScene, depth: int = 8) -> ShadowImage:
        """Return a layer's shadow: straight alpha = covered part × opacity (spec 6), one colour unless it has a tip.

        Parameters
        ----------
        scene
            The frame.
        layer
            One of its layers; an empty cel gives an empty shadow.
        depth
            Bits of alpha, 8 or 16.
        """
        coverage = self._shadows.coverage(scene, layer)
        measured = None if coverage is None else coverage.measured
        return self._images.image(scene.canvas, drawn(coverage), Coloring(layer.look, layer.cast, measured), depth)

    def united_shadow(self, scene: Scene, layers: Sequence[LayerScene], depth: int = 8) -> ShadowImage:
        """Return the shadows of layers of one look, at least one, as one, otherwise as :meth:`shadow` does."""
        return self._images.united(scene.canvas, self._composites.united.drawn(scene, layers), layers[0].look, depth)

    def received(self, scene: Scene, layer: LayerScene, depth: int = 8, *, multiply: bool = True) -> ShadowImage:
        """Return what others cast on a layer as :meth:`shadow` does its own; of one colour where their shadows are.

        ``multiply`` says which of the two layers is wanted: some may multiply and others not, see `mixed`.
        """
        shades = [(drawn(shade), shade.look) for shade in self._shadows.received(scene, layer)]
        if shades:
            return self._images.mixed(scene.canvas, shades, depth, multiply=multiply)
        looks = [shade.look for shade in layer.received.shades] if layer.received else []
        return self._images.image(scene.canvas, None, Coloring(looks[0] if looks else layer.look), depth)

    def contact(self, scene: Scene, layer: LayerScene, depth: int = 8) -> ShadowImage:
        """Return the patches under a figure's feet as :meth:`shadow` does its shadow."""
        patches = contact_layer(layer)
        if patches is None:
            return self._images.image(scene.canvas, None, Coloring(layer.look), depth)
        return self.shadow(scene, patches, depth)

    def reflection(self, scene: Scene, layer: LayerScene, depth: int = 8) -> Steps:
        """Return a figure as the ground mirrors it, (H, W, 4), straight sRGB, 8 or 16 bit."""
        mirrored = self._composites.mirrors.mirrored(scene, layer)
        shape = (scene.canvas.height, scene.canvas.width, 4)
        shown: Steps = np.zeros(shape, np.uint8) if depth == 8 else np.zeros(shape, np.uint16)
        if mirrored is not None and mirrored.box is not None:
            box, pixels = mirrored.box, mirrored.target.read(mirrored.box)
            shown[box.top : box.bottom, box.left : box.right] = pixels if depth == 16 else (pixels + 128.0) // 257
            check("mirroring a figure")
        return shown

    def clay(self, scene: Scene, depth: int = 8, *, is_under: bool = False) -> Steps:
        """Return sets that are drawn as clay, those under the background picture or those over it.

        (H, W, 4), straight sRGB, 8 or 16 bit; it becomes the picture drawn last.
        """
        self._composites.draw_clay(scene, depth, is_under=is_under)
        check("drawing a set")
        return self.read_picture()

    def set_shadow(self, scene: Scene, shadow: SetShadow, depth: int = 8) -> ShadowImage:
        """Return the shadow of the set itself as :meth:`shadow` does a layer's; ``shadow`` is the scene's."""
        return self._images.image(scene.canvas, drawn(self._shadows.set_coverage(scene)), Coloring(shadow.look), depth)

    def receiver_matte(self, canvas: Box, cast: SetCast, depth: int = 8) -> ShadowImage:
        """Return where the pieces that cast are seen, or, where none does, the ground: white, straight alpha.

        ``cast`` needs no lights.
        """
        return self._images.image(canvas, drawn(self._shadows.seen_of_set(canvas, cast)), Coloring(_WHITE_MATTE), depth)

    def depth_map_coverage(self, scene: Scene, layer: LayerScene, map_px: int = 4096) -> Steps:
        """Return a layer's covered parts, (H, W) 16 bit, found by a literal depth map: a cross-check, not a picture."""
        from kagezou.render.passes.depth_map import mapped_coverage

        matte = None if layer.cast is None else self._shadows.silhouette(scene, layer.cast)
        return mapped_coverage(self._boxes, scene.canvas, (layer.cast, matte), map_px)

    def received_coverage(self, scene: Scene, layer: LayerScene) -> Steps:
        """Return the part of every pixel of a layer that others shade before opacity, (H, W) 16 bit."""
        most = np.zeros((scene.canvas.height, scene.canvas.width), np.uint16)
        for each in self._shadows.received(scene, layer):
            np.maximum(most, each.target.read(scene.canvas), out=most)
        return most

    def set_coverage(self, scene: Scene) -> Steps:
        """Return the covered parts of the shadow of the set itself before opacity, (H, W) 16 bit."""
        return _read(self._shadows.set_coverage(scene), scene.canvas)

    def coverage(self, scene: Scene, layer: LayerScene) -> Steps:
        """Return a layer's covered parts before opacity, (H, W) 16 bit."""
        return _read(self._shadows.coverage(scene, layer), scene.canvas)

    def draw_picture(
        self,
        scene: Scene,
        backdrop: Backdrop = Backdrop.BACKGROUND,
        depth: int = 8,
        line_px: int = 0,
        *,
        wireframes: bool = False,
    ) -> None:
        """Draw backdrop, shadows and characters; the result stays in the renderer until the next picture.

        With ``line_px`` over 0 the shadows are drawn as their outlines over everything, of twice that width. With
        ``wireframes`` imported sets show theirs, where that is asked of them.
        """
        self._composites.draw(scene, backdrop, depth, line_px, wireframes=wireframes)
        check("drawing the picture")

    def read_picture(self) -> Steps:
        """Return the picture drawn last, (H, W, 4), straight sRGB, in the depth it was drawn with."""
        target = self._composites.drawn.target
        return target.read(target.box)

    def present(self, view: WindowView) -> Steps | None:
        """Place the picture drawn last in a window, or where that has no framebuffer return what would fill it."""
        return self._presenter.draw(self._composites.drawn.target.texture, view)

    def copy_picture(self) -> None:
        """Draw the whole picture once into another target, one texel a pixel: the unit of cost of a benchmark."""
        self._composites.drawn.copy_whole()

    def finish(self) -> None:
        """Wait until everything asked for is drawn."""
        GL.glFinish()

    def close(self) -> None:
        """Give the memory back; the context must be current."""
        self._composites.close()
        self._shadows.close()
        self._images.close()
        self._presenter.close()
        self._boxes.close()


def drawn(coverage: Coverage | ReceivedCoverage | None) -> Drawn | None:
    """Return where a coverage is and its box; None where there is none."""
    return None if coverage is None or coverage.box is None else (coverage.target, coverage.box)


def _read(coverage: Coverage | None, canvas: Box) -> Steps:
    return np.zeros((canvas.height, canvas.width), np.uint16) if coverage is None else coverage.target.read(canvas)
