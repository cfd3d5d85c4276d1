"""Where an OpenGL context comes from: EGL on Linux, elsewhere, or where EGL fails beside a display, the window system.

The one place below the front door that knows the window's room; nothing of it is imported before it is needed.
"""

import os
import sys
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Final, Self

from kagezou.errors import GraphicsProblem
from kagezou.message import Message

if TYPE_CHECKING:
    from kagezou.render.gpu.context import GraphicsContext
    from kagezou.render.gpu.info import GraphicsInfo


_ANSWER_S: Final = 2.0


def has_display() -> bool:
    """Return whether a window could be seen here."""
    if not sys.platform.startswith("linux"):
        return True
    return bool(os.environ.get("DISPLAY")) or _has_compositor()


def avoid_dead_compositor() -> None:
    """Have Qt use X11 where the environment names a Wayland compositor that is gone, unless it was told what to use.

    So it is after `sudo`, within `ssh` and in a terminal that outlived its session; Qt itself would end the program.
    """
    named = os.environ.get("WAYLAND_DISPLAY")
    if named and os.environ.get("DISPLAY") and not os.environ.get("QT_QPA_PLATFORM") and not _has_compositor():
        os.environ["QT_QPA_PLATFORM"] = "xcb"


def _has_compositor() -> bool:
    """Return whether a Wayland compositor answers where the environment says that one is."""
    named = os.environ.get("WAYLAND_DISPLAY")
    if not named:
        return False
    place = Path(os.environ.get("XDG_RUNTIME_DIR", ""), named)
    if not place.is_absolute():
        return False
    import socket  # few have a compositor, and no verb has another use for it

    with socket.socket(socket.AF_UNIX) as door:
        door.settimeout(_ANSWER_S)
        try:
            door.connect(str(place))
        except OSError:
            return False
    return True


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
        avoid_dead_compositor()
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
