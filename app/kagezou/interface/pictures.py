"""Pictures of a cut as arrays, drawn one after the other on the thread that takes them."""

from collections.abc import Generator
from contextlib import closing
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from threading import get_ident
from typing import Any, Literal, NamedTuple, TypeAlias, get_args

import numpy as np
from numpy.typing import NDArray

from kagezou.document.model import Document
from kagezou.errors import UsageProblem
from kagezou.export.checks import check_sources
from kagezou.export.frames import CEL_BUDGET_BYTES, decode, stops_of
from kagezou.export.painters import Painters, are_worth_two
from kagezou.export.pictures import Picture
from kagezou.export.pipeline import PipelineSteps, flow, window_for
from kagezou.export.planning import FrameJob, in_order, jobs_of
from kagezou.export.request import ExportRequest
from kagezou.export.selection import chosen_frames
from kagezou.export.sequences import OutputSequence, sequences_of
from kagezou.interface.values import ProgressCallback, StopCallback
from kagezou.io.files.processors import processors
from kagezou.io.images.cel_cache import CelCache
from kagezou.message import Message
from kagezou.render.gpu.context import GraphicsContext, OpenContext

PixelType: TypeAlias = Literal["uint8", "uint16", "float32"]
"""How numbers of pixels are given: 0 to 255, 0 to 65535, or 0.0 to 1.0 from 16 bits."""


class RenderedFrame(NamedTuple):
    """One picture.

    Attributes
    ----------
    frame
        Counted from 1.
    pixels
        Straight (unmultiplied) sRGB and alpha, (H, W, 4) of the canvas, y down; read-only, as frames that hold one
        picture share it.
    """

    frame: int
    pixels: NDArray[Any]


@dataclass(frozen=True, slots=True)
class PictureWish:
    """Which pictures: of a sequence by its name, on frames from 1 (None for all), and as which numbers."""

    name: str
    frames: tuple[int, ...] | None
    numbers: PixelType


def sequence_names(document: Document) -> tuple[str, ...]:
    """Return what can be drawn, by the names of the folders that ``kagezou render`` writes.

    Raises
    ------
    UsageProblem
        There is nothing to draw.
    """
    return tuple(each.label for each in _sequences(document))


def rendered(
    document: Document, wish: PictureWish, open_context: OpenContext, progress: ProgressCallback, stop: StopCallback
) -> Generator[RenderedFrame, None, None]:
    """Yield the pictures in the order of their frames; drawings are read ahead by other threads.

    Raises
    ------
    UsageProblem
        There is no such sequence or frame, or the pictures are taken on several threads.
    InputProblem
        A drawing is missing or cannot be read.
    GraphicsProblem
        There is no OpenGL, or it failed.
    """
    if wish.numbers not in (known := get_args(PixelType)):
        words = ", ".join(known)
        raise UsageProblem(
            Message("pixels are not given as {numbers!r}, only as {known}", numbers=wish.numbers, known=words)
        )
    sequence = _named(document, wish.name)
    request = ExportRequest(Path(), frames=wish.frames)
    jobs = in_order(jobs_of(document, chosen_frames(document, request), (sequence,)))
    check_sources(jobs)
    return _taken(document, jobs, wish, _Thread(open_context), (progress, stop))


class _Thread:
    """The contexts of one iteration and the thread that they belong to.

    Between two pictures a script may do anything on that thread, also draw other pictures in a context of its own.
    """

    def __init__(self, open_context: OpenContext) -> None:
        self._open = open_context
        self._id = get_ident()
        self._contexts: list[GraphicsContext] = []

    def open(self) -> GraphicsContext:
        """Return a context."""
        self._contexts.append(self._open())
        return self._contexts[-1]

    def resume(self) -> None:
        """Go on where the last picture was drawn."""
        if get_ident() != self._id:
            raise UsageProblem(Message("pictures are taken on the thread that took the first one"))
        for context in self._contexts:
            context.make_current()


def _taken(
    document: Document,
    jobs: tuple[FrameJob, ...],
    wish: PictureWish,
    thread: _Thread,
    told: tuple[ProgressCallback, StopCallback],
) -> Generator[RenderedFrame, None, None]:
    progress, stop = told
    canvas, numbers = document.canvas, wish.numbers
    cels = CelCache(CEL_BUDGET_BYTES)
    depth = 8 if numbers == "uint8" else 16
    painters = Painters(
        cels, depth, thread.open, stops_of(document, stop), are_two=are_worth_two(document, jobs, processors())
    )
    steps: PipelineSteps[NDArray[Any]] = PipelineSteps(
        decode=partial(decode, cels, in_color=any(job.content.sources.cels for job in jobs)),
        drawing=painters.drawing,
        write=lambda _job, picture: _pixels(picture, numbers),
        drawing_beside=painters.drawing_beside,
    )
    done, length = 0, sum(len(job.targets) for job in jobs)
    thread.resume()
    with closing(
        flow(jobs, steps, processors(), window_for(canvas.width_px, canvas.height_px, processors()), stop)
    ) as came:
        try:
            while (outcome := next(came, None)) is not None:
                if outcome.problem is not None:
                    raise outcome.problem
                assert outcome.written is not None
                for target in outcome.job.targets:
                    done += 1
                    progress(done, length)
                    yield RenderedFrame(target.frame, outcome.written)
                thread.resume()
        finally:
            thread.resume()


def _pixels(picture: Picture, numbers: PixelType) -> NDArray[Any]:
    pixels = picture.rgba()
    if numbers == "float32":
        pixels = pixels.astype(np.float32) / np.float32(np.iinfo(pixels.dtype).max)
    pixels.flags.writeable = False
    return pixels


def _named(document: Document, name: str) -> OutputSequence:
    found = _sequences(document)
    for each in found:
        if each.label == name:
            return each
    known = ", ".join(each.label for each in found)
    raise UsageProblem(Message("there are no pictures {name!r}, only {known}", name=name, known=known))


def _sequences(document: Document) -> tuple[OutputSequence, ...]:
    return sequences_of(document, ExportRequest(Path(), composite=True, united=True, receivers=True))
