"""The widget that shows the session's frame."""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from functools import partial

from PySide6.QtCore import Qt, QTimer, Signal, SignalInstance
from PySide6.QtGui import QImage, QResizeEvent
from PySide6.QtWidgets import QWidget

from kagezou.document.model import Document
from kagezou.errors import GraphicsProblem, Problem
from kagezou.io.images.cel_cache import CelCache
from kagezou.io.images.reading import Steps
from kagezou.io.sets.mesh_cache import MeshCache
from kagezou.message import Message
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.words import translated
from kagezou.ui.viewport.faces import made_face
from kagezou.ui.viewport.following import Following
from kagezou.ui.viewport.frame_painter import Broken, FramePainter
from kagezou.ui.viewport.picture_view import PictureView
from kagezou.ui.viewport.reading import Reading
from kagezou.ui.viewport.resolution import Resolution
from kagezou.ui.viewport.showing import Showing, window_view
from kagezou.ui.viewport.viewpoint import Viewpoint

NEEDED_VERSION = (3, 3)
REST_MS = 150
"""A hand that has not moved for so long rests, though it may still hold something."""


class PictureWidget(QWidget):
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
    shown = Signal()
    """A picture is on screen; not always another one."""
    started = Signal(str, bool)
    """What draws, by name, and whether it is the processor; connect queued."""

    def __init__(self, bridge: Bridge, cels: CelCache, meshes: MeshCache, viewpoint: Viewpoint) -> None:
        super().__init__()
        self._face = made_face(self, self)
        self.viewpoint = viewpoint
        self._bridge = bridge
        self._cels = cels
        self._meshes = meshes
        self._frame_painter: FramePainter | None = None
        self._broken: tuple[Broken, ...] = ()
        self._reading = Reading(cels)
        self._showing = Showing(bridge, viewpoint, self._reading)
        self.pace, self.finished = self._showing.pace, self._showing.finished
        self._reading.arrived.connect(self._face.update, Qt.ConnectionType.QueuedConnection)
        self._rest = QTimer(self)
        self._rest.setSingleShot(True)
        self._rest.setInterval(REST_MS)
        self._rest.timeout.connect(self._refine)
        self.following = Following(bridge, lambda: self._showing.took_s)
        self.following.due.connect(self._face.update)
        self.following.scrubbed.connect(self._rest.start)
        bridge.document_changed.connect(self._document_changed)
        bridge.shown_changed.connect(self._face.update)
        bridge.session_replaced.connect(viewpoint.fit)
        bridge.session_replaced.connect(self.pace.forget)
        viewpoint.changed.connect(self._face.update)
        self._document_changed()

    @property
    def backdrop(self) -> Backdrop:
        """What is shown where nothing is drawn."""
        return self._showing.backdrop

    @property
    def view(self) -> PictureView:
        """What of the frame is looked at."""
        return self._showing.view

    def show_view(self, view: PictureView) -> None:
        """Choose what of the frame is looked at."""
        self._showing.view = view
        self._face.update()

    @property
    def resolution(self) -> Resolution:
        """At which part of its resolution the picture is drawn."""
        return self.pace.resolution

    def show_resolution(self, resolution: Resolution) -> None:
        """Choose at which part of its resolution the picture is drawn."""
        self.pace.resolution = resolution
        self._face.update()

    @property
    def is_current(self) -> bool:
        """Whether the picture shown is that of the session's frame; its drawings may still be on their way."""
        return self._showing.is_current

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
        self._showing.backdrop = backdrop
        self._face.update()

    def reread(self) -> None:
        """Draw anew, because files may have changed."""
        self.finished.forget()
        if self._frame_painter is not None:
            self._frame_painter.forget_picture()
        self._face.update()

    def read_picture(self) -> Steps | None:
        """Return the picture on screen, (H, W, 4), or None before there is one."""
        frame_painter = self._frame_painter
        if frame_painter is None or not frame_painter.pictures_drawn:
            return None

        def read() -> Steps:
            # What is seen may have been kept; it is drawn to be read.
            self._showing.draw(frame_painter, moving=self._is_moving)
            return frame_painter.read_picture()

        return self._with_context(read)

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

    def begin(self, version: tuple[int, int]) -> None:
        """Begin to draw with the context that is current, of a version of OpenGL."""
        with _told(self.failed):
            if version < NEEDED_VERSION:
                raise _too_old("{}.{}".format(*version))
            self._frame_painter = FramePainter(self._cels, self._meshes)
            self.started.emit(self._frame_painter.device, self._frame_painter.is_software)

    def draw_into(self, framebuffer: int) -> None:
        """Fill a framebuffer with the picture."""
        if self._frame_painter is None:
            return
        with _told(self.failed):
            divisor = self._frame_painter.divisor
            view = replace(window_view(self, self.viewpoint), framebuffer=framebuffer)
            self._showing.draw_into(self._frame_painter, view, moving=self._is_moving)
            self._tell(self._frame_painter, divisor)

    def image(self) -> QImage | None:
        """Return the picture as it fills the widget: as it was kept, or drawn now; None where nothing draws."""
        if self._frame_painter is None:
            return None
        with _told(self.failed):
            divisor = self._frame_painter.divisor
            self._showing.find(self._frame_painter, window_view(self, self.viewpoint), moving=self._is_moving)
            self._tell(self._frame_painter, divisor)
        return self._showing.image

    def end(self) -> None:
        """Give the renderer up before its context goes."""
        if self._frame_painter is not None:
            self._frame_painter.close()
            self._frame_painter = None

    def resizeEvent(self, event: QResizeEvent) -> None:
        self.viewpoint.resize((float(self.width()), float(self.height())), self.devicePixelRatioF())
        self._face.resize(self.size())

    def _with_context(self, draw: Callable[[], Steps]) -> Steps | None:
        found: list[Steps] = []
        try:
            self._face.within(lambda: found.append(draw()))
        except Problem as problem:
            self.failed.emit(translated(problem))
        return found[0] if found else None

    def _tell(self, frame_painter: FramePainter, divisor: int) -> None:
        """Tell what has become of the picture, which was drawn with a divisor before."""
        if frame_painter.divisor != divisor:
            self.divisor_changed.emit(frame_painter.divisor)
        if frame_painter.broken != self._broken:
            self._broken = frame_painter.broken
            self.broken_changed.emit(frame_painter.broken)

    @property
    def _is_moving(self) -> bool:
        return self._rest.isActive() and (self._bridge.session.is_in_gesture or self._bridge.is_passing)

    def _document_changed(self) -> None:
        self.finished.forget()
        if self._bridge.session.is_in_gesture:
            self._rest.start()
        canvas = self._bridge.document.canvas
        self.viewpoint.set_canvas((float(canvas.width_px), float(canvas.height_px)))
        self.following.follow()

    def _refine(self) -> None:
        """Draw what was drawn in haste again, now that the hand rests."""
        if self._frame_painter is not None and self._frame_painter.divisor != self.pace.next(moving=False).divisor:
            self._face.update()


@contextmanager
def _told(failed: SignalInstance) -> Iterator[None]:
    """Tell what goes wrong in here, as Qt would lose what leaves a painting."""
    try:
        yield
    except Problem as problem:
        failed.emit(translated(problem))
    except Exception:
        # A defect of ours must be heard of.
        sys.excepthook(*sys.exc_info())


def _too_old(version: str) -> GraphicsProblem:
    words = Message(
        "the graphics driver offers OpenGL {version}; Kagezou needs 3.3: update the driver", version=version
    )
    return GraphicsProblem(words)
