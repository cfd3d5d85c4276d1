"""What an export from the window is to make, as a value that can be remembered, previewed and run."""

import json
import os
from collections.abc import Callable
from dataclasses import asdict, dataclass, fields, replace
from enum import StrEnum
from pathlib import Path

from kagezou.document.model import Document
from kagezou.errors import UsageProblem
from kagezou.export.after_effects.export import HandOffRequest, export_to_after_effects
from kagezou.export.after_effects.mattes import MATTES
from kagezou.export.farm import FarmRequest, write_bundle
from kagezou.export.frames import export_frames
from kagezou.export.jobs import planned
from kagezou.export.names import safe_names
from kagezou.export.request import DEPTHS, SUFFIXES, Cancelled, ExportRequest, Progress, Summary
from kagezou.render.context import OpenContext


class ExportKind(StrEnum):
    """Whom the export is for."""

    LAYERS = "layers"
    AFTER_EFFECTS = "after effects"
    FARM = "farm"


@dataclass(frozen=True, slots=True)
class ExportPlan:
    """One way to export; what a kind does not know is left alone.

    Parameters
    ----------
    kind
        Whom it is for.
    only_work_area
        Whether frames outside the work area are left out; a hand-off to After Effects always has them all.
    format, depth, composite, skip_existing
        As of `ExportRequest`.
    per_drawing, copies, mattes
        As of `HandOffRequest`.
    chunk
        Frames a task of a farm.
    """

    kind: ExportKind = ExportKind.LAYERS
    only_work_area: bool = False
    format: str = "png"
    depth: int = 8
    composite: bool = False
    skip_existing: bool = True
    per_drawing: bool = False
    copies: bool = True
    mattes: tuple[str, ...] = ()
    chunk: int = 10


@dataclass(frozen=True, slots=True)
class ExportOutcome:
    """What came of it: files asked for and new, whether it was stopped, the first problem, and where to look."""

    files: int
    written: int
    cancelled: bool
    problem: str
    where: Path


@dataclass(frozen=True, slots=True)
class Place:
    """Where an export goes, and what it is of: the project's file, if there is one, and its name."""

    folder: Path
    project: Path | None
    name: str


def dumps_plan(plan: ExportPlan) -> str:
    """Return a plan as text to remember it by."""
    return json.dumps(asdict(plan))


def loads_plan(text: str) -> ExportPlan:
    """Return a remembered plan; whatever is not understood has its usual value."""
    try:
        found = json.loads(text)
    except ValueError:
        return ExportPlan()
    usual = ExportPlan()
    given = found if isinstance(found, dict) else {}
    plain = {
        field.name: given[field.name]
        for field in fields(ExportPlan)
        if type(given.get(field.name)) is type(getattr(usual, field.name))
    }
    kind, mattes = given.get("kind"), given.get("mattes")
    return sound(
        replace(
            usual,
            **plain,
            kind=ExportKind(kind) if kind in list(ExportKind) else usual.kind,
            mattes=tuple(each for each in MATTES if isinstance(mattes, list) and each in mattes),
        )
    )


def sound(plan: ExportPlan) -> ExportPlan:
    """Return the plan with a format that its kind has and a depth that its format has."""
    formats = tuple(SUFFIXES) if plan.kind is not ExportKind.AFTER_EFFECTS else ("png", "exr")
    form = plan.format if plan.format in formats else "png"
    depth = plan.depth if plan.depth in DEPTHS[form] else DEPTHS[form][0]
    return replace(plan, format=form, depth=depth, chunk=min(max(plan.chunk, 1), 1000))


def preview(document: Document, plan: ExportPlan, place: Place) -> tuple[str, ...]:
    """Return what would be written, folder by folder.

    Raises
    ------
    UsageProblem
        There is nothing to export, or the project must be saved first.
    """
    made = planned(document, _request(document, plan, place))
    length = len(made.jobs) and made.files // max(len(made.folders), 1)
    suffix = SUFFIXES[plan.format]
    match plan.kind:
        case ExportKind.LAYERS:
            return tuple(f"{folder.name}/  {length} × {suffix}" for folder in made.folders)
        case ExportKind.AFTER_EFFECTS:
            script = f"{safe_names([place.name])[place.name]}.jsx"
            lines = [f"shadows/{folder.name}/  {suffix}" for folder in made.folders]
            lines += [f"matte_{'shadow' if matte == 'lit' else matte}/  {suffix}" for matte in plan.mattes]
            return (script, *dict.fromkeys(lines), *(("characters/", "background/") if plan.copies else ()))
        case ExportKind.FARM:
            if place.project is None:
                raise UsageProblem("a farm renders a saved project; save this one first")
            tasks = -(-length // plan.chunk)
            return ("template.json", "parameter_values.json", "asset_references.json", f"{tasks} × {plan.chunk}")


Work = Callable[[OpenContext, Progress, Cancelled], ExportOutcome]


def work_of(document: Document, plan: ExportPlan, place: Place) -> Work:
    """Return what carries a plan out, on any thread; it may raise a Problem."""

    def work(open_context: OpenContext, progress: Progress, cancelled: Cancelled) -> ExportOutcome:
        match plan.kind:
            case ExportKind.LAYERS:
                summary = export_frames(document, _request(document, plan, place), open_context, progress, cancelled)
                return _outcome((summary,), place.folder)
            case ExportKind.AFTER_EFFECTS:
                done = export_to_after_effects(document, _hand_off(plan, place), open_context, progress, cancelled)
                return _outcome(done.exports, done.script or place.folder)
            case ExportKind.FARM:
                files = write_bundle(document, _farm(document, plan, place), place.folder)
                return ExportOutcome(len(files), len(files), cancelled=False, problem="", where=place.folder)

    return work


def _outcome(summaries: tuple[Summary, ...], where: Path) -> ExportOutcome:
    failures = [failure.sentence for summary in summaries for failure in summary.failures]
    return ExportOutcome(
        files=sum(summary.files for summary in summaries),
        written=sum(summary.written for summary in summaries),
        cancelled=any(summary.cancelled for summary in summaries),
        problem=failures[0] if failures else "",
        where=where,
    )


def _request(document: Document, plan: ExportPlan, place: Place) -> ExportRequest:
    first, last = document.played
    partly = plan.only_work_area and plan.kind is not ExportKind.AFTER_EFFECTS and document.work_area is not None
    return ExportRequest(
        folder=place.folder,
        frames=tuple(range(first, last + 1)) if partly else None,
        format=plan.format,
        depth=plan.depth,
        composite=plan.composite and plan.kind is not ExportKind.AFTER_EFFECTS,
        skip_existing=plan.skip_existing,
        workers=_workers(),
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
        raise UsageProblem("a farm renders a saved project; save this one first")
    output = place.project.with_name(f"{place.project.stem}_shadows")
    return FarmRequest(place.project, replace(_request(document, plan, place), folder=output), plan.chunk)


def _workers() -> int:
    """Return how many threads write: one core is left to the window."""
    return max((os.cpu_count() or 2) - 1, 1)
