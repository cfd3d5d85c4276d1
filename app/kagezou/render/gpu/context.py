"""Where a context comes from when there is no window."""

import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from types import TracebackType
from typing import TYPE_CHECKING, Protocol, Self

from kagezou.errors import GraphicsProblem
from kagezou.message import Message

if TYPE_CHECKING:
    from kagezou.render.gpu.info import GraphicsInfo


class GraphicsContext(Protocol):
    """An OpenGL context that is current inside a ``with`` block."""

    @property
    def info(self) -> "GraphicsInfo":
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


def another(context: GraphicsContext) -> OpenContext | None:
    """Return what opens one more context of the same driver for another thread to draw with; None where none helps.

    A graphics card is kept busy by one thread, and a context of a window system belongs to that system's thread.
    """
    if not sys.platform.startswith("linux"):
        return None
    from kagezou.render.gpu.egl import EglContext

    return EglContext if isinstance(context, EglContext) and context.info.is_software else None


@contextmanager
def loading_driver() -> Iterator[None]:
    """Load the driver on another thread beside what is done within the block: it takes long for the first context.

    Whether there is one is for whoever opens it to find out.
    """

    def load() -> None:
        with suppress(GraphicsProblem), open_headless_context():
            pass

    thread = threading.Thread(target=load, name="driver")
    thread.start()
    try:
        yield
    finally:
        thread.join()
