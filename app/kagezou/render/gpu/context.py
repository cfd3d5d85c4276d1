"""Where a context comes from when there is no window."""

import sys
from collections.abc import Callable
from types import TracebackType
from typing import Protocol, Self

from kagezou.errors import GraphicsProblem
from kagezou.message import Message
from kagezou.render.gpu.info import GraphicsInfo


class GraphicsContext(Protocol):
    """An OpenGL context that is current inside a ``with`` block."""

    @property
    def info(self) -> GraphicsInfo:
        """What draws; the context must be current."""
        ...

    def make_current(self) -> None:
        """Make the context current again on the thread that entered it; one that is closed is left alone."""
        ...

    def __enter__(self) -> Self:
        """Make the context current on this thread."""
        ...

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Release and destroy the context."""
        ...


OpenContext = Callable[[], GraphicsContext]
"""Makes a context; called on the thread that will draw."""


def open_headless_context() -> GraphicsContext:
    """Return a context without a display.

    Raises
    ------
    GraphicsProblem
        Where there is none: on systems other than Linux a window system's offscreen surface must serve, which only
        the window's room can make.
    """
    if not sys.platform.startswith("linux"):
        raise GraphicsProblem(Message("OpenGL without a window system is available on Linux only"))
    from kagezou.render.gpu.egl import EglContext

    return EglContext()
