"""An OpenGL context without a window, through Qt: for exports beside the window, and where there is no EGL."""

from types import TracebackType
from typing import Self

from PySide6.QtGui import QOffscreenSurface, QOpenGLContext, QSurfaceFormat

from kagezou.errors import GraphicsProblem
from kagezou.message import Message
from kagezou.render.gpu.info import GraphicsInfo, read_info


def surface_format() -> QSurfaceFormat:
    """Return what every context of the program asks for: OpenGL 3.3 core, no multisampling, no depth of its own."""
    wanted = QSurfaceFormat()
    wanted.setRenderableType(QSurfaceFormat.RenderableType.OpenGL)
    wanted.setVersion(3, 3)
    wanted.setProfile(QSurfaceFormat.OpenGLContextProfile.CoreProfile)
    wanted.setSamples(0)
    wanted.setDepthBufferSize(0)
    wanted.setStencilBufferSize(0)
    return wanted


class OffscreenSurface:
    """A place to be current on. Make it on the GUI's thread, as some systems need; ``open`` contexts anywhere."""

    def __init__(self) -> None:
        self._surface = QOffscreenSurface()
        self._surface.setFormat(surface_format())
        self._surface.create()

    def open(self) -> "OffscreenContext":
        """Return a context for the thread that asks."""
        return OffscreenContext(self._surface)


class OffscreenContext:
    """A context that is current inside a ``with`` block, on the thread that enters it.

    Parameters
    ----------
    surface
        Where it is current.
    """

    def __init__(self, surface: QOffscreenSurface) -> None:
        self._surface = surface
        self._context: QOpenGLContext | None = None

    @property
    def info(self) -> GraphicsInfo:
        """What draws; the context must be current."""
        return read_info()

    def make_current(self) -> None:
        """Make the context current again on the thread that entered it; one that is closed is left alone."""
        if self._context is not None and not self._context.makeCurrent(self._surface):
            raise GraphicsProblem(Message("the graphics driver gives no OpenGL context beside the window"))

    def release(self) -> None:
        """Let no context be current on this thread."""
        if self._context is not None:
            self._context.doneCurrent()

    def __enter__(self) -> Self:
        context = QOpenGLContext()
        context.setFormat(surface_format())
        if not context.create() or not context.makeCurrent(self._surface):
            raise GraphicsProblem(Message("the graphics driver gives no OpenGL context beside the window"))
        self._context = context
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._context is not None:
            self._context.doneCurrent()
            # Destroyed on the thread it lived on.
            self._context = None
