"""Carrying a plan out: from what was chosen to what each kind of export is asked for with."""

import os
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from kagezou.document.model import Document
from kagezou.errors import UsageProblem
from kagezou.export.after_effects.export import HandOffRequest, export_to_after_effects
from kagezou.export.farm import FarmRequest, write_bundle
from kagezou.export.frames import export_frames
from kagezou.export.plan import ExportKind, ExportPlan, Place, frames_request, video_request
from kagezou.export.request import Cancelled, Progress, Summary
from kagezou.export.video import export_video
from kagezou.io.files.faults import output_problem
from kagezou.message import Message
from kagezou.render.gpu.context import OpenContext


@dataclass(frozen=True, slots=True)
class ExportOutcome:
    """What came of it: files asked for and new, whether it was stopped, the first problem, where to look, and notes."""

    files: int
    written: int
    cancelled: bool
    problem: Message | None
    where: Path
    notes: tuple[Message, ...] = ()


Work = Callable[[OpenContext, Progress, Cancelled], ExportOutcome]


def work_of(document: Document, plan: ExportPlan, place: Place) -> Work:
    """Return what carries a plan out, on any thread; it may raise a Problem."""

    def work(open_context: OpenContext, progress: Progress, cancelled: Cancelled) -> ExportOutcome:
        match plan.kind:
            case ExportKind.LAYERS | ExportKind.LAYERED:
                request = frames_request(document, plan, place.folder, _workers())
                return _outcome((export_frames(document, request, open_context, progress, cancelled),), place.folder)
            case ExportKind.VIDEO:
                return _film(document, plan, place)(open_context, progress, cancelled)
            case ExportKind.AFTER_EFFECTS:
                done = export_to_after_effects(document, _hand_off(plan, place), open_context, progress, cancelled)
                return replace(_outcome(done.exports, done.script or place.folder), notes=done.notes)
            case ExportKind.FARM:
                files = write_bundle(document, _farm(document, plan, place), place.folder)
                return ExportOutcome(len(files), len(files), cancelled=False, problem=None, where=place.folder)

    return work


def _film(document: Document, plan: ExportPlan, place: Place) -> Work:
    def work(open_context: OpenContext, progress: Progress, cancelled: Cancelled) -> ExportOutcome:
        try:
            place.folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise output_problem(place.folder, error) from error
        request = video_request(document, plan, place, _workers())
        done = export_video(document, request, open_context, progress, cancelled)
        return ExportOutcome(1, int(done.is_whole), cancelled=not done.is_whole, problem=None, where=done.path)

    return work


def _outcome(summaries: tuple[Summary, ...], where: Path) -> ExportOutcome:
    failures = [failure.message for summary in summaries for failure in summary.failures]
    return ExportOutcome(
        files=sum(summary.files for summary in summaries),
        written=sum(summary.written for summary in summaries),
        cancelled=any(summary.cancelled for summary in summaries),
        problem=failures[0] if failures else None,
        where=where,
    )


def _hand_off(plan: ExportPlan, place: Place) -> HandOffRequest:
    return HandOffRequest(
        folder=place.folder,
        name=place.name,
        per_drawing=plan.per_drawing,
        copies=plan.copies,
        mattes=plan.mattes,
        format=plan.format,
        depth=plan.depth if plan.format == "png" else 8,
        skip_existing=plan.skip_existing,
        workers=_workers(),
    )


def _farm(document: Document, plan: ExportPlan, place: Place) -> FarmRequest:
    if place.project is None:
        raise UsageProblem(Message("a farm renders a saved project; save this one first"))
    output = place.project.with_name(f"{place.project.stem}_shadows")
    return FarmRequest(place.project, frames_request(document, plan, output, _workers()), plan.chunk)


def _workers() -> int:
    """Return how many threads write: one core is left to the window."""
    return max((os.cpu_count() or 2) - 1, 1)
