"""A cut as a video: the finished picture, or one layer's shadow with its alpha."""

import time
from contextlib import closing, suppress
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any, Final

from kagezou.document.model import Document
from kagezou.errors import Stopped
from kagezou.export.checks import check_sources
from kagezou.export.frames import CEL_BUDGET_BYTES, decode, stops_of
from kagezou.export.painters import Painters, are_worth_two
from kagezou.export.pipeline import PipelineSteps, flow, window_for
from kagezou.export.planning import FrameJob, in_order, jobs_of
from kagezou.export.request import SHADOWS, Cancelled, ExportRequest, Missing, Progress
from kagezou.export.selection import chosen_frames
from kagezou.export.sequences import OutputSequence, sequences_of
from kagezou.export.stand_ins import filled_for
from kagezou.export.subjects import CompositeSubject
from kagezou.io.files.atomic import replace_by
from kagezou.io.files.faults import output_problem
from kagezou.io.images.cel_cache import CelCache
from kagezou.io.images.video import VideoKind, VideoWriter, converted, frames_in, kind_of
from kagezou.message import Message
from kagezou.render.gpu.context import OpenContext

_DEPTH: Final = 8


@dataclass(frozen=True, slots=True)
class VideoRequest:
    """Which video to make.

    Parameters
    ----------
    path
        The file; its suffix, .mp4 or .mov, says how it is coded.
    frames
        Frame numbers, upward; None for the whole cut.
    layer
        The layer whose shadow is shown alone; None for the finished picture.
    workers
        Threads that decode drawings and convert pictures.
    missing
        What stands in for a drawing that is not there.
    """

    path: Path
    frames: tuple[int, ...] | None = None
    layer: str | None = None
    workers: int = 2
    missing: Missing = Missing.FAIL


@dataclass(frozen=True, slots=True)
class VideoSummary:
    """What came of it: the file, how many frames it was to have, whether it is there, how long it took, and notes."""

    path: Path
    frames: int
    is_whole: bool
    seconds: float
    notes: tuple[Message, ...] = ()


def export_video(
    document: Document, request: VideoRequest, open_context: OpenContext, progress: Progress, cancelled: Cancelled
) -> VideoSummary:
    """Write a video; it is whole or not there. Its last step is that it was read back and is in its place.

    Raises
    ------
    UsageProblem
        The request does not fit the document, the suffix is no video's, or what writes videos is not installed.
    InputProblem
        A drawing is missing and nothing stands in for it, or cannot be read.
    DiskFullProblem, OutputProblem
        The file cannot be written.
    GraphicsProblem
        There is no OpenGL, or it failed.
    """
    started = time.monotonic()
    path = request.path.absolute()
    kind = kind_of(path)
    filled = filled_for(document, video_jobs(document, request), request.missing)
    document = filled.document
    jobs = video_jobs(document, request)
    check_sources(jobs)
    length = sum(len(job.targets) for job in jobs)
    film = _Film(document, jobs, kind, request)
    is_whole = False
    with suppress(Stopped):
        replace_by(path, lambda temp: film.write(temp, open_context, progress, cancelled))
        is_whole = True
        progress(length + 1, length + 1)
    return VideoSummary(path, length, is_whole, time.monotonic() - started, filled.notes)


def video_jobs(document: Document, request: VideoRequest) -> tuple[FrameJob, ...]:
    """Return the pictures of a video one after the other, each with the frames that hold it.

    Raises
    ------
    UsageProblem
        The request does not fit the document.
    """
    sequence, frames = _sequence(document, request)
    return in_order(jobs_of(document, frames, (sequence,)))


def _sequence(document: Document, request: VideoRequest) -> tuple[OutputSequence, tuple[int, ...]]:
    """Return what is shown, and on which frames."""
    wanted = ExportRequest(request.path.parent, frames=request.frames, workers=request.workers)
    if request.layer is None:
        wanted = replace(wanted, composite=True)
        shown = next(each for each in sequences_of(document, wanted) if each.subject == CompositeSubject())
    else:
        wanted = replace(wanted, layers=(request.layer,), only=SHADOWS)
        (shown,) = sequences_of(document, wanted)
    return shown, chosen_frames(document, wanted)


@dataclass(frozen=True, slots=True)
class _Film:
    """A video to be written: its pictures in their order."""

    document: Document
    jobs: tuple[FrameJob, ...]
    kind: VideoKind
    request: VideoRequest

    def write(self, temp: Path, open_context: OpenContext, progress: Progress, cancelled: Cancelled) -> None:
        """Write it to ``temp``."""
        canvas = self.document.canvas
        cels = CelCache(CEL_BUDGET_BYTES)
        stops, are_two = (
            stops_of(self.document, cancelled),
            are_worth_two(self.document, self.jobs, self.request.workers),
        )
        painters = Painters(cels, _DEPTH, open_context, stops, are_two=are_two)
        steps: PipelineSteps[Any] = PipelineSteps(
            decode=partial(decode, cels, in_color=self.request.layer is None),
            drawing=painters.drawing,
            write=lambda _, picture: converted(picture.rgba(), self.kind),
            drawing_beside=painters.drawing_beside,
        )
        length, done = sum(len(job.targets) for job in self.jobs), 0
        window = window_for(canvas.width_px, canvas.height_px, self.request.workers)
        size_px = (canvas.width_px, canvas.height_px)
        with (
            VideoWriter(temp, self.request.path, size_px, canvas.frame_rate, self.kind) as video,
            closing(flow(self.jobs, steps, self.request.workers, window, cancelled)) as outcomes,
        ):
            for outcome in outcomes:
                if outcome.problem is not None:
                    raise outcome.problem
                for _ in outcome.job.targets:
                    video.add(outcome.written)
                done += len(outcome.job.targets)
                progress(done, length + 1)
            if done < length:
                raise Stopped
        if frames_in(temp) != length:
            raise output_problem(
                self.request.path, Message("cannot be written: it reads back with other frames than it got")
            )
