"""The widget with the OpenGL context: it shows the session's frame, and is made anew with every context."""

import sys
from collections.abc import Callable
from functools import partial

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtOpenGLWidgets import QOpenGLWidget

from kagezou.document.model import Document
from kagezou.errors import GraphicsProblem, Problem
from kagezou.io.images.cel_cache import CelCache
from kagezou.io.images.reading import Steps
from kagezou.io.sets.mesh_cache import MeshCache
from kagezou.message import Message
from kagezou.render.gpu.presenter import WindowView
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.words import translated
from kagezou.ui.viewport.frame_painter import Broken, FramePainter
from kagezou.ui.viewport.picture_view import PictureView, behind, line_px
from kagezou.ui.viewport.reading import Reading
from kagezou.ui.viewport.resolution import Pace, Resolution
from kagezou.ui.viewport.viewpoint import Viewpoint

NEEDED_VERSION = (3, 3)
REST_MS = 150
"""A hand that has not moved for so long rests, though it may still hold something."""


class PictureWidget(QOpenGLWidget):
    """Shows the frame; knows nothing of hands.

    Parameters
    ----------
    bridge
        The session shown.
    cels, meshes
        Where decoded drawings and sets come from.
    viewpoint
        How the canvas is looked at.
    """

    failed = Signal(str)
    """OpenGL itself does not serve; connect queued, it may be sent while painting."""
    broken_changed = Signal(object)
    """The picture files that cannot be shown now, a tuple of Broken; connect queued."""

    divisor_changed = Signal(int)
    """How many px of the canvas are one of the picture, from now on; connect queued."""

    started = Signal(str, bool)
    """What draws, by name, and whether it is the processor; connect queued."""

    def __init__(self, bridge: Bridge, cels: CelCache, meshes: MeshCache, viewpoint: Viewpoint) -> None:
        super().__init__()
        self.viewpoint = viewpoint
        self._bridge = bridge
        self._cels = cels
        self._meshes = meshes
        self._frame_painter: FramePainter | None = None
        self._broken: tuple[Broken, ...] = ()
        self.pace = Pace()
        self._reading = Reading(cels)
        self._reading.arrived.connect(self.update, Qt.ConnectionType.QueuedConnection)
        self._is_current = False
        self._rest = QTimer(self)
        self._rest.setSingleShot(True)
        self._rest.setInterval(REST_MS)
        self._rest.timeout.connect(self._refine)
        self._backdrop = Backdrop.BACKGROUND
        self._view = PictureView.COMPOSITE
        bridge.document_changed.connect(self._document_changed)
        bridge.shown_changed.connect(self.update)
        bridge.frame_changed.connect(self.update)
        bridge.session_replaced.connect(viewpoint.fit)
        bridge.session_replaced.connect(self.pace.forget)
        viewpoint.changed.connect(self.update)
        self._document_changed()

    @property
    def backdrop(self) -> Backdrop:
        """What is shown where nothing is drawn."""
        return self._backdrop

    @property
    def view(self) -> PictureView:
        """What of the frame is looked at."""
        return self._view

    def show_view(self, view: PictureView) -> None:
        """Choose what of the frame is looked at."""
        self._view = view
        self.update()

    @property
    def resolution(self) -> Resolution:
        """At which part of its resolution the picture is drawn."""
        return self.pace.resolution

    def show_resolution(self, resolution: Resolution) -> None:
        """Choose at which part of its resolution the picture is drawn."""
        self.pace.resolution = resolution
        self.update()

    @property
    def is_current(self) -> bool:
        """Whether the picture shown is that of the session's frame; its drawings may still be on their way."""
        return self._is_current

    @property
    def frame_painter(self) -> FramePainter | None:
        """What draws; None before the first painting and while there is no context."""
        return self._frame_painter

    @property
    def device(self) -> str:
        """The name of what draws, empty where nothing does."""
        return self._frame_painter.device if self._frame_painter else ""

    def show_backdrop(self, backdrop: Backdrop) -> None:
        """Choose what is shown where nothing is drawn."""
        self._backdrop = backdrop
        self.update()

    def reread(self) -> None:
        """Draw anew, because files may have changed."""
        if self._frame_painter is not None:
            self._frame_painter.forget_picture()
        self.update()

    def read_picture(self) -> Steps | None:
        """Return the picture on screen, (H, W, 4), or None before there is one."""
        frame_painter = self._frame_painter
        if frame_painter is None or not frame_painter.pictures_drawn:
            return None
        return self._with_context(frame_painter.read_picture)

    def layer_picture(self, document: Document, frame: int, layer_id: str, *, with_shadow: bool) -> Steps | None:
        """Return a layer alone on nothing, (H, W, 4), or None if it cannot be drawn."""
        frame_painter = self._frame_painter
        if frame_painter is None:
            return None
        return self._with_context(
            partial(frame_painter.layer_picture, document, frame, layer_id, with_shadow=with_shadow)
        )

    def finish(self) -> None:
        """Read nothing any more, before the window goes."""
        self._reading.finish()

    def initializeGL(self) -> None:
        try:
            self._begin()
        except Problem as problem:
            self.failed.emit(translated(problem))
        except Exception:
            # Qt would lose what leaves this method; a defect of ours must be heard of.
            sys.excepthook(*sys.exc_info())

    def paintGL(self) -> None:
        if self._frame_painter is None:
            return
        try:
            self._paint(self._frame_painter)
        except Problem as problem:
            self.failed.emit(translated(problem))
        except Exception:
            sys.excepthook(*sys.exc_info())

    def resizeGL(self, width: int, height: int) -> None:
        self.viewpoint.resize((float(self.width()), float(self.height())), self.devicePixelRatioF())

    def _with_context(self, draw: Callable[[], Steps]) -> Steps | None:
        self.makeCurrent()
        try:
            return draw()
        except Problem as problem:
            self.failed.emit(translated(problem))
            return None
        finally:
            self.doneCurrent()

    def _begin(self) -> None:
        context = self.context()
        context.aboutToBeDestroyed.connect(self._release, Qt.ConnectionType.DirectConnection)
        major, minor = context.format().majorVersion(), context.format().minorVersion()
        if (major, minor) < NEEDED_VERSION:
            raise _too_old(f"{major}.{minor}")
        self._frame_painter = FramePainter(self._cels, self._meshes)
        self.started.emit(self._frame_painter.device, self._frame_painter.is_software)

    def _paint(self, frame_painter: FramePainter) -> None:
        document, view = self._bridge.shown, self._view
        self._is_current = self._reading.has_drawings_of(document, self._bridge.frame)
        if not self._is_current and frame_painter.pictures_drawn:
            frame_painter.present(_window_view(self, self.viewpoint))
            return
        backdrop = behind(view, self._backdrop, has_background=document.background is not None)
        line = line_px(view, self.viewpoint.view.zoom)
        is_moving = self._rest.isActive() and self._bridge.session.is_in_gesture
        at, before = self.pace.next(moving=is_moving), frame_painter.divisor
        if frame_painter.draw(document, self._bridge.frame, backdrop, view, line, at):
            self.pace.took(frame_painter.divisor, frame_painter.took_s)
        frame_painter.present(_window_view(self, self.viewpoint))
        if frame_painter.divisor != before:
            self.divisor_changed.emit(frame_painter.divisor)
        if frame_painter.broken != self._broken:
            self._broken = frame_painter.broken
            self.broken_changed.emit(frame_painter.broken)

    def _document_changed(self) -> None:
        if self._bridge.session.is_in_gesture:
            self._rest.start()
        canvas = self._bridge.document.canvas
        self.viewpoint.set_canvas((float(canvas.width_px), float(canvas.height_px)))
        self.update()

    def _refine(self) -> None:
        """Draw what was drawn in haste again, now that the hand rests."""
        if self._frame_painter is not None and self._frame_painter.divisor != self.pace.next(moving=False).divisor:
            self.update()

    def _release(self) -> None:
        """Give the renderer up before its context goes; Qt makes another and calls initializeGL again."""
        if self._frame_painter is not None:
            self.makeCurrent()
            self._frame_painter.close()
            self._frame_painter = None
            self.doneCurrent()


def _window_view(widget: QOpenGLWidget, viewpoint: Viewpoint) -> WindowView:
    """Return how the picture lies in the framebuffer of a widget."""
    ratio = widget.devicePixelRatioF()
    view, surround = viewpoint.view, viewpoint.surround
    x, y = view.origin_view_px
    return WindowView(
        framebuffer=widget.defaultFramebufferObject(),
        # Halves go up, as Qt makes its framebuffer.
        width_px=int(widget.width() * ratio + 0.5),
        height_px=int(widget.height() * ratio + 0.5),
        zoom=view.zoom * ratio,
        # On whole device pixels, so that at 100 % nothing is blurred by half a pixel.
        origin_px=(float(round(x * ratio)), float(round(y * ratio))),
        surround=(surround.redF(), surround.greenF(), surround.blueF()),
    )


def _too_old(version: str) -> GraphicsProblem:
    words = Message(
        "the graphics driver offers OpenGL {version}; Kagezou needs 3.3: update the driver", version=version
    )
    return GraphicsProblem(words)
