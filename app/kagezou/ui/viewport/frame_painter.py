"""What is on screen: the renderer of the current context, and the picture it drew last."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from time import perf_counter

from kagezou.document.model import Document
from kagezou.document.scaling import scaled, usable_divisor
from kagezou.errors import Problem
from kagezou.geometry.box import Box
from kagezou.io.images.cel_cache import CelCache
from kagezou.io.images.reading import Steps
from kagezou.io.images.smaller_cels import SmallerCels
from kagezou.io.sets.mesh_cache import MeshCache
from kagezou.picture_source import PictureSource, file_of
from kagezou.render.gpu.presenter import WindowView
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.render.renderer import Renderer
from kagezou.scene.companions import without_companions
from kagezou.scene.evaluate import evaluate
from kagezou.scene.heavy_sets import MOST_AT_HAND, beyond, too_many_at_hand
from kagezou.scene.known_layers import KnownLayers
from kagezou.scene.left_out import without_pieces
from kagezou.scene.receiving import without_drawings
from kagezou.scene.scene import Scene
from kagezou.ui.viewport.picture_view import PictureView, seen
from kagezou.ui.viewport.resolution import FULL, PreviewFineness


@dataclass(frozen=True, slots=True)
class Broken:
    """A file that cannot be shown, or ``"set"``, and why."""

    source: PictureSource | str
    problem: Problem


@dataclass(frozen=True, slots=True)
class _Evaluated:
    document: Document
    frame: int
    divisor: int
    scene: Scene


@dataclass(frozen=True, slots=True)
class _Smaller:
    """What draws a canvas at a part of its resolution."""

    canvas: Box
    cels: SmallerCels
    renderer: Renderer


class FramePainter:
    """Draws a frame where its scene or backdrop changed, and shows it as often as asked.

    Made with the context current, thrown away before the context goes.

    Parameters
    ----------
    cels, meshes
        Where decoded drawings and sets come from.
    """

    def __init__(self, cels: CelCache, meshes: MeshCache) -> None:
        self._cels = cels
        self._meshes = meshes
        self._renderer = self._front = Renderer(cels, meshes)
        self._smaller: dict[int, _Smaller] = {}
        self._evaluated: _Evaluated | None = None
        self.layers = KnownLayers()
        self._drawn: tuple[Scene, int, Backdrop, PictureView, int] | None = None
        self._draw_again: Callable[[], None] | None = None
        self.divisor = 1
        self.took_s = 0.0
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
        at: PreviewFineness = FULL,
    ) -> bool:
        """Draw a frame unless it is the one drawn last; false where it was.

        Drawings that cannot be read are left out and noted. At a part of its resolution it is drawn as far as the
        canvas can be divided; in haste, once the smaller drawings are there.
        """
        self.divisor = usable_divisor(document.canvas, at.divisor)
        scene = self._scene(document, frame)
        if self.divisor > 1 and at.in_haste and not self._is_ready(document, scene):
            self.divisor = 1
            scene = self._scene(document, frame)
        wanted = (scene, self.divisor, backdrop, view, line_px)
        if self._drawn == wanted:
            return False
        whole = self._readable(scene)
        self._front = self._renderer if self.divisor == 1 else self._smaller_for(document.canvas.box).renderer
        began_s = perf_counter()
        line_px = -(-line_px // self.divisor)
        self._draw_again = partial(
            self._front.draw_picture, seen(whole, view), backdrop, line_px=line_px, wireframes=True
        )
        self._draw_again()
        self._front.finish()
        self.took_s = perf_counter() - began_s
        self.pictures_drawn += 1
        self._drawn = wanted
        return True

    def present(self, view: WindowView) -> Steps | None:
        """Place the picture in the window, or return what would fill it, as the renderer does."""
        self._bring_back()
        return self._front.present(replace(view, divisor=self.divisor))

    def read_picture(self) -> Steps:
        """Return the picture drawn last, (H, W, 4) straight sRGB; at full resolution as the command line writes it."""
        self._bring_back()
        return self._front.read_picture()

    def layer_picture(self, document: Document, frame: int, layer_id: str, *, with_shadow: bool) -> Steps:
        """Return a layer alone on nothing, (H, W, 4); what is on screen is drawn anew next time."""
        scene = self._readable(evaluate(document, frame))
        layers = tuple(
            layer if with_shadow else without_companions(layer) for layer in scene.layers if layer.id == layer_id
        )
        self._renderer.draw_picture(replace(scene, background=None, layers=layers), Backdrop.TRANSPARENT)
        self._drawn = None
        return self._renderer.read_picture()

    def close(self) -> None:
        """Give the memory back; the context must be current."""
        self._renderer.close()
        for smaller in self._smaller.values():
            smaller.renderer.close()

    def _bring_back(self) -> None:
        """Draw the picture again where a layer alone was drawn in its place."""
        if self._drawn is None and self._draw_again is not None and self._front is self._renderer:
            self._draw_again()

    def _scene(self, document: Document, frame: int) -> Scene:
        known, divisor = self._evaluated, self.divisor
        if known is not None and known.document is document and (known.frame, known.divisor) == (frame, divisor):
            return known.scene
        scene = evaluate(scaled(document, divisor), frame, self.layers)
        self._evaluated = _Evaluated(document, frame, divisor, scene)
        return scene

    def _is_ready(self, document: Document, scene: Scene) -> bool:
        drawings = [layer.drawing.source for layer in scene.layers if layer.drawing is not None]
        try:
            return self._smaller_for(document.canvas.box).cels.is_ready(
                drawings, None if scene.background is None else scene.background.source
            )
        except Problem:
            return False

    def _smaller_for(self, canvas: Box) -> _Smaller:
        known = self._smaller.get(self.divisor)
        if known is None or known.canvas != canvas:
            if known is not None:
                known.renderer.close()
            cels = SmallerCels(self._cels, canvas, self.divisor)
            known = self._smaller[self.divisor] = _Smaller(canvas, cels, Renderer(cels, self._meshes, self.divisor))
        return known

    def _readable(self, scene: Scene) -> Scene:
        broken: list[Broken] = []

        def can_be_read(source: PictureSource, read: Callable[[PictureSource], object] = self._cels.cel) -> bool:
            try:
                read(source)
            except Problem as problem:
                broken.append(Broken(source, problem))
                return False
            return True

        drawings = [layer.drawing.source for layer in scene.layers if layer.drawing is not None]
        casting = [source for layer in scene.layers if layer.cast is not None for source in layer.cast.sources]
        mirrored = [source for layer in scene.layers if layer.reflection for source in layer.reflection.sources]
        for source in dict.fromkeys((*drawings, *casting, *mirrored)):
            can_be_read(source)
        lost = {
            piece.id
            for piece in scene.pieces
            if piece.mesh is not None
            and not can_be_read(piece.mesh.path, lambda each: self._meshes.mesh(file_of(each)))
        }
        left = beyond(scene.pieces, MOST_AT_HAND)
        if left:
            broken.append(Broken("set", too_many_at_hand(scene.pieces, left)))
            lost |= {piece.id for piece in left}
        scene = without_pieces(scene, lost) if lost else scene
        behind = scene.background
        background = behind if behind and can_be_read(behind.source, self._cels.background) else None
        unread = {each.source for each in broken if not isinstance(each.source, str)}
        layers = tuple(without_drawings(layer, unread) for layer in scene.layers)
        self.broken = tuple(broken)
        return replace(scene, layers=layers, background=background) if broken else scene
