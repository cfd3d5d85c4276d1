"""Where an OpenGL context comes from: EGL on Linux, elsewhere, or where EGL fails beside a display, the window system.

The one place below the front door that knows the window's room; nothing of it is imported before it is needed.
"""

import os
import platform
from types import TracebackType
from typing import TYPE_CHECKING, Self

from kagezou.errors import GraphicsProblem
from kagezou.message import Message

if TYPE_CHECKING:
    from kagezou.render.gpu.context import GraphicsContext
    from kagezou.render.gpu.info import GraphicsInfo


def has_display() -> bool:
    """Return whether a window could be seen here."""
    if platform.system() != "Linux":
        return True
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def open_context() -> "GraphicsContext":
    """Return an OpenGL context without a window: EGL, or the window system's offscreen surface.

    Raises
    ------
    GraphicsProblem
        Neither is available.
    """
    from kagezou.render.gpu.context import open_headless_context

    try:
        return open_headless_context()
    except GraphicsProblem:
        if not has_display():
            raise
    return _WindowSystemContext()


class _WindowSystemContext:
    """A context on an offscreen surface of the window system, with the Qt application that such a surface needs."""

    def __init__(self) -> None:
        try:
            from PySide6.QtGui import QGuiApplication

            from kagezou.ui.system.offscreen_context import OffscreenSurface
        except ImportError as error:
            raise GraphicsProblem(
                Message("OpenGL is not available: the window's libraries cannot be loaded: {error}", error=error)
            ) from error
        self._application = None if QGuiApplication.instance() else QGuiApplication(["kagezou"])
        self._context = OffscreenSurface().open()

    @property
    def info(self) -> "GraphicsInfo":
        """What draws; the context must be current."""
        return self._context.info

    def make_current(self) -> None:
        """Make the context current again on the thread that entered it; one that is closed is left alone."""
        self._context.make_current()

    def __enter__(self) -> Self:
        """Make the context current on this thread."""
        self._context.__enter__()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Destroy the context; an application of our own gives way to the window's."""
        self._context.__exit__(kind, error, trace)
        if self._application is not None:
            self._application.shutdown()
            self._application = None
