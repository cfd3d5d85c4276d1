"""The face of the viewport: the part of it that bears the picture, drawn by a graphics card or by the processor.

A widget of OpenGL makes Qt put the whole window together by OpenGL. Where the processor draws, that costs more than the
picture itself, with every blink of a cursor; there the picture is drawn beside the window and painted like all else,
and only what changed goes to the screen.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

from PySide6.QtCore import Qt, QTimer, SignalInstance
from PySide6.QtGui import QGuiApplication, QImage, QOpenGLContext, QPainter, QPaintEvent
from PySide6.QtOpenGLWidgets import QOpenGLWidget
from PySide6.QtWidgets import QWidget

from kagezou.errors import Problem
from kagezou.ui.system.offscreen_context import OffscreenContext, OffscreenSurface


class Painted(Protocol):
    """What a face shows, and who is told when it did."""

    @property
    def shown(self) -> SignalInstance:
        """To be sent when a picture is on screen."""
        ...

    def begin(self, version: tuple[int, int]) -> None:
        """Take note that a context of a version is current, and will be whenever something is to be drawn."""
        ...

    def draw_into(self, framebuffer: int) -> None:
        """Fill a framebuffer with the picture."""
        ...

    def image(self) -> QImage | None:
        """Return the picture as it fills the face; None where there is none."""
        ...

    def end(self) -> None:
        """Give up what belongs to the context; it is current for the last time."""
        ...


class PictureFace(Protocol):
    """The part of the viewport that bears the picture; a widget."""

    def update(self) -> None:
        """Paint soon."""
        ...

    def within(self, do: Callable[[], None]) -> None:
        """Do something with the context current."""
        ...


@dataclass(frozen=True, slots=True)
class _Beside:
    """A context beside the window, and where it is current."""

    surface: OffscreenSurface
    context: OffscreenContext


def made_face(parent: QWidget, painted: Painted) -> "CardFace | RasterFace":
    """Return the face that suits what draws here; without any OpenGL one that will say so."""
    beside = software_beside()
    return CardFace(parent, painted) if beside is None else RasterFace(parent, painted, beside)


def software_beside() -> _Beside | None:
    """Return a context beside the window where the processor draws; None where a graphics card does, or nothing."""
    if QGuiApplication.platformName() == "offscreen":
        return None
    surface = OffscreenSurface()
    context = surface.open()
    try:
        context.__enter__()
        if context.info.is_software:
            context.release()
            return _Beside(surface, context)
    except Problem:
        # The widget of OpenGL meets the same, and tells it where someone listens.
        pass
    context.__exit__(None, None, None)
    return None


class CardFace(QOpenGLWidget):
    """A face that a graphics card draws, into the window itself; every new context draws anew."""

    def __init__(self, parent: QWidget, painted: Painted) -> None:
        super().__init__(parent)
        self._painted = painted
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.frameSwapped.connect(painted.shown)

    def within(self, do: Callable[[], None]) -> None:
        """Do something with the context current."""
        self.makeCurrent()
        try:
            do()
        finally:
            self.doneCurrent()

    def initializeGL(self) -> None:
        context = self.context()
        context.aboutToBeDestroyed.connect(self._release, Qt.ConnectionType.DirectConnection)
        self._painted.begin(_version(context))

    def paintGL(self) -> None:
        self._painted.draw_into(self.defaultFramebufferObject())

    def _release(self) -> None:
        """Give everything up before the context goes; Qt makes another and calls initializeGL again."""
        self.within(self._painted.end)


class RasterFace(QWidget):
    """A face that is painted from a picture the processor drew beside the window."""

    def __init__(self, parent: QWidget, painted: Painted, beside: _Beside) -> None:
        super().__init__(parent)
        self._painted, self._beside = painted, beside
        self._has_begun = False
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)

    def within(self, do: Callable[[], None]) -> None:
        """Do something with the context current."""
        self._beside.context.make_current()
        try:
            do()
        finally:
            self._beside.context.release()

    def paintEvent(self, event: QPaintEvent) -> None:
        images: list[QImage | None] = []
        self.within(lambda: images.append(self._image()))
        painter = QPainter(self)
        if images[0] is not None:
            painter.drawImage(0, 0, images[0])
        painter.end()
        # Painting only fills a picture of the window; it goes to the screen when all that waited is painted.
        QTimer.singleShot(0, self, self._tell)

    def _image(self) -> QImage | None:
        if not self._has_begun:
            self._has_begun = True
            context = QOpenGLContext.currentContext()
            self._painted.begin((0, 0) if context is None else _version(context))
        return self._painted.image()

    def _tell(self) -> None:
        self._painted.shown.emit()


def _version(context: QOpenGLContext) -> tuple[int, int]:
    return context.format().majorVersion(), context.format().minorVersion()
