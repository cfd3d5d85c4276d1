"""Who draws an export: the calling thread and, where the processor does the work of a graphics card, one beside it."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Final

from kagezou.document.model import Document
from kagezou.export.painter import Painter
from kagezou.export.pipeline import Draw
from kagezou.export.planning import FrameJob
from kagezou.export.request import Cancelled
from kagezou.export.second_painter import Drawing
from kagezou.io.images.cel_cache import CelCache
from kagezou.render.coverage_cache import Budgets
from kagezou.render.gpu.context import OpenContext, another
from kagezou.render.renderer import Renderer

_WORTH_TWO: Final = 6
"""Frames that are drawn sooner by two, whose second has to be set up as the first."""


@dataclass(slots=True)
class Painters:
    """What sets up the drawing of an export on each of its threads.

    Parameters
    ----------
    cels
        Where decoded drawings come from.
    depth, keeps_opacity
        As for `Painter`.
    open_context
        Opens OpenGL for the first.
    stops
        Asked within a frame that takes minutes.
    are_two
        Whether there may be a second.
    processes
        How many processes draw, each with painters of its own, and share what memory there is.
    """

    cels: CelCache
    depth: int
    open_context: OpenContext
    stops: Cancelled
    keeps_opacity: bool = False
    are_two: bool = False
    processes: int = 1
    _open_another: OpenContext | None = field(default=None, init=False)

    @contextmanager
    def drawing(self) -> Iterator[Draw]:
        """Open OpenGL for the block, on the calling thread, and give what draws a job."""
        with self.open_context() as context:
            self._open_another = another(context) if self.are_two else None
            with self._drawing() as draw:
                yield draw

    @property
    def drawing_beside(self) -> Drawing | None:
        """What does so on another thread, to be called within the first one's block; None where one alone draws."""
        return self._beside if self.are_two else None

    @contextmanager
    def _beside(self) -> Iterator[Draw | None]:
        if self._open_another is None:
            yield None
            return
        with self._open_another(), self._drawing() as draw:
            yield draw

    @contextmanager
    def _drawing(self) -> Iterator[Draw]:
        # What a renderer may keep is shared by as many as there are.
        whole = Budgets()
        sharers = 2 if self.are_two else self.processes
        part = Budgets(whole.shadows // sharers, whole.mattes // sharers)
        renderer = Renderer(self.cels, budgets=part)
        renderer.stop_when(self.stops)
        painter = Painter(renderer, self.cels, self.depth, self.keeps_opacity)
        try:
            yield lambda job: job.content.draw(painter)
        finally:
            renderer.close()


def are_worth_two(document: Document, jobs: tuple[FrameJob, ...] | list[FrameJob], workers: int) -> bool:
    """Return whether two may draw some jobs: enough frames, and no set, of which each would keep all that is known."""
    frames = {id(job.content.scene) for job in jobs}
    return workers > 1 and not document.pieces and len(frames) >= _WORTH_TWO
