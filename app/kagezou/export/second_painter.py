"""A second thread that draws, with an OpenGL context of its own, where the processor does the work of a graphics card.

Half of a frame is numbers, which Python makes on one thread at a time, and half is drawn by the driver's own threads:
two that draw in turn keep both going.
"""

from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import AbstractContextManager, ExitStack
from types import TracebackType
from typing import Final, TypeAlias

from kagezou.errors import GraphicsProblem
from kagezou.export.pictures import Picture
from kagezou.export.planning import FrameJob

_Draw: TypeAlias = Callable[[FrameJob], Picture]
Drawing: TypeAlias = Callable[[], AbstractContextManager[_Draw | None]]
"""Sets up what draws, on the thread that will draw, for the time of a block; None where that shall not."""

_QUEUED: Final = 2
"""So many groups of jobs may be its own, so that it does not wait for the first thread to finish a frame."""


class SecondPainter:
    """Draws groups of jobs on a thread of its own, once it is set up; a context manager.

    Parameters
    ----------
    drawing
        What it draws with. Where that gives none or ends in a GraphicsProblem, nothing is ever taken; None for no such
        thread.
    """

    def __init__(self, drawing: Drawing | None) -> None:
        self._stack = ExitStack()
        self._groups: list[Future[Picture]] = []
        self._pool = None if drawing is None else ThreadPoolExecutor(1, thread_name_prefix="frames-painter")
        self._draw: Future[_Draw | None] | None = None
        if self._pool is not None and drawing is not None:
            self._draw = self._pool.submit(lambda: self._stack.enter_context(drawing()))

    def __enter__(self) -> "SecondPainter":
        """Return it."""
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Finish what is being drawn, leave the rest, and give everything back."""
        if self._pool is not None:
            # What was drawn with goes on the thread whose it is, after the frame in hand.
            for waiting in self._groups:
                waiting.cancel()
            closing = self._pool.submit(self._stack.close)
            self._pool.shutdown(wait=True)
            closing.result()
            if error is None and self._draw is not None:
                self._check(self._draw)

    def is_free(self) -> bool:
        """Return whether it draws and can take another group.

        Raises
        ------
        Exception
            Whatever kept it from being set up but a GraphicsProblem.
        """
        if self._draw is None or not self._draw.done():
            return False
        if not self._check(self._draw):
            self._draw = None
            return False
        self._groups = [last for last in self._groups if not last.done()]
        return len(self._groups) < _QUEUED

    @staticmethod
    def _check(draw: Future[_Draw | None]) -> bool:
        """Return whether it was set up to draw; raises what is wrong beyond the driver."""
        error = draw.exception()
        if error is not None and not isinstance(error, GraphicsProblem):
            raise error
        return error is None and draw.result() is not None

    def take(self, group: list[tuple[FrameJob, Future[None]]]) -> list[Future[Picture]]:
        """Draw jobs, at least one, when they are decoded; only when it is free."""
        assert self._pool is not None
        assert self._draw is not None
        draw = self._draw.result()
        assert draw is not None

        def drawn(job: FrameJob, decoded: Future[None]) -> Picture:
            decoded.result()
            return draw(job)

        pictures = [self._pool.submit(drawn, job, decoded) for job, decoded in group]
        self._groups.append(pictures[-1])
        return pictures
