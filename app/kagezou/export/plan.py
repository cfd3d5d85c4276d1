"""What an export from the window is to make, as a value that can be remembered and previewed."""

import json
from collections.abc import Iterator
from dataclasses import asdict, dataclass, fields, replace
from enum import StrEnum
from pathlib import Path
from typing import Final

from kagezou.document.model import Document
from kagezou.errors import UsageProblem
from kagezou.export.after_effects.drawings import exposed
from kagezou.export.after_effects.mattes import MATTES, at_full_opacity
from kagezou.export.after_effects.renderings import matte_renderings
from kagezou.export.farm import ASSETS, PARAMETERS, TEMPLATE
from kagezou.export.layered import LayeredContent
from kagezou.export.names import safe_names
from kagezou.export.planning import Plan, planned
from kagezou.export.request import DEPTHS, LAYERED_SUFFIXES, SUFFIXES, ExportRequest
from kagezou.export.sequences import sequences_of
from kagezou.export.video import VideoRequest, video_jobs


class ExportKind(StrEnum):
    """Whom the export is for."""

    LAYERS = "layers"
    LAYERED = "layered"
    VIDEO = "video"
    AFTER_EFFECTS = "after effects"
    FARM = "farm"


_FORMATS: Final[dict[ExportKind, tuple[str, ...]]] = {
    ExportKind.LAYERS: tuple(SUFFIXES),
    ExportKind.LAYERED: tuple(LAYERED_SUFFIXES),
    ExportKind.VIDEO: ("mp4", "mov"),
    ExportKind.AFTER_EFFECTS: ("png", "exr"),
    ExportKind.FARM: tuple(SUFFIXES),
}


@dataclass(frozen=True, slots=True)
class ExportPlan:
    """One way to export; what a kind does not know is left alone.

    Parameters
    ----------
    kind
        Whom it is for.
    only_work_area
        Whether frames outside the work area are left out; a hand-off to After Effects always has them all.
    format
        One of those of its kind.
    depth, composite, receivers, skip_existing
        As of `ExportRequest`.
    in_one
        Whether a farm makes frames of layers, as `ExportKind.LAYERED` does, instead of shadow layers.
    per_drawing, copies, mattes
        As of `HandOffRequest`.
    chunk
        Frames a task of a farm.
    video_layer
        The name of the layer whose shadow a video shows; empty for the finished picture.
    """

    kind: ExportKind = ExportKind.LAYERS
    only_work_area: bool = False
    format: str = "png"
    depth: int = 8
    composite: bool = False
    receivers: bool = False
    in_one: bool = False
    skip_existing: bool = True
    per_drawing: bool = False
    copies: bool = True
    mattes: tuple[str, ...] = ()
    chunk: int = 10
    video_layer: str = ""

    @property
    def is_layered(self) -> bool:
        """Whether each frame is one file that holds all layers."""
        return self.kind is ExportKind.LAYERED or (self.kind is ExportKind.FARM and self.in_one)

    @property
    def formats(self) -> tuple[str, ...]:
        """The formats it may have, the usual one first."""
        return _FORMATS[ExportKind.LAYERED if self.is_layered else self.kind]


@dataclass(frozen=True, slots=True)
class Place:
    """Where an export goes, and what it is of: the project's file, if there is one, and its name."""

    folder: Path
    project: Path | None
    name: str


def dumps_plan(plan: ExportPlan) -> str:
    """Return a plan as text to remember it by."""
    return json.dumps(asdict(plan), ensure_ascii=False)


def loads_plan(text: str) -> ExportPlan:
    """Return a remembered plan; whatever is not understood has its usual value."""
    try:
        return plan_of(json.loads(text))
    except ValueError:
        return ExportPlan()


def plan_of(found: object) -> ExportPlan:
    """Return the plan that JSON was made of; whatever is not understood has its usual value."""
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


def depths_of(form: str) -> tuple[int, ...]:
    """Return the bits a channel that a format may have, the usual one first."""
    return DEPTHS.get(form, (8,))


def sound(plan: ExportPlan) -> ExportPlan:
    """Return the plan with a format that it may have and a depth that its format has."""
    form = plan.format if plan.format in plan.formats else plan.formats[0]
    depth = plan.depth if plan.depth in depths_of(form) else depths_of(form)[0]
    return replace(plan, format=form, depth=depth, chunk=min(max(plan.chunk, 1), 1000))


def preview(document: Document, plan: ExportPlan, place: Place) -> tuple[str, ...]:
    """Return what would be written, folder by folder; below it, indented, what is in its files or comes of its tasks.

    Raises
    ------
    UsageProblem
        There is nothing to export, or the project must be saved first.
    """
    if plan.kind is ExportKind.VIDEO:
        return _video_preview(document, plan, place)
    if plan.kind is ExportKind.AFTER_EFFECTS:
        # There opacity is a property of the layers.
        document = at_full_opacity(document)
    made = planned(document, frames_request(document, plan, place.folder, workers=1))
    length = len(made.jobs) and made.files // max(len(made.folders), 1)
    suffix = (LAYERED_SUFFIXES if plan.is_layered else SUFFIXES)[plan.format]
    match plan.kind:
        case ExportKind.LAYERS:
            return tuple(f"{folder.name}/  {length} × {suffix}" for folder in made.folders)
        case ExportKind.LAYERED:
            content = made.jobs[0].content
            names = content.part_names if isinstance(content, LayeredContent) else ()
            # As a list of layers has them: the uppermost first.
            return (f"{made.folders[0].name}/  {length} × {suffix}", *(f"    {name}" for name in reversed(names)))
        case ExportKind.AFTER_EFFECTS:
            script = f"{safe_names([place.name])[place.name]}.jsx"
            return (script, *_shadow_lines(document, plan, made, suffix), *_copy_lines(document, plan))
        case ExportKind.FARM:
            if place.project is None:
                raise UsageProblem("a farm renders a saved project; save this one first")
            tasks = -(-length // plan.chunk)
            files = (TEMPLATE, PARAMETERS, ASSETS, f"{tasks} × {plan.chunk}")
            return (*files, *(f"    {folder.name}/  {length} × {suffix}" for folder in made.folders))


def _shadow_lines(document: Document, plan: ExportPlan, made: Plan, suffix: str) -> Iterator[str]:
    """Yield the folders of a hand-off's shadows and mattes, with how many files each gets where that is known."""
    length = document.canvas.length_frames
    for sequence in made.sequences:
        count = max(made.pictures_of(sequence)) + 1 if plan.per_drawing else length
        yield f"shadows/{sequence.label}/  {count} × {suffix}"
    each = suffix if plan.per_drawing else f"{length} × {suffix}"
    request = frames_request(document, plan, Path(), workers=1)
    for matte in matte_renderings(plan.mattes):
        sequences = sequences_of(document, replace(request, only=matte.only))
        yield from (f"{matte.folder}/{sequence.label}/  {each}" for sequence in sequences)


def _copy_lines(document: Document, plan: ExportPlan) -> Iterator[str]:
    """Yield what a hand-off copies."""
    if not plan.copies:
        return
    names = safe_names(layer.name for layer in document.layers)
    for layer in document.layers:
        if count := len(exposed(layer, document.canvas.length_frames)):
            yield f"characters/{names[layer.name]}/  {count} × .png"
    if document.background is not None:
        yield "background/background.png"


def _video_preview(document: Document, plan: ExportPlan, place: Place) -> tuple[str, ...]:
    request = video_request(document, plan, place, workers=1)
    length = sum(len(job.targets) for job in video_jobs(document, request))
    canvas = document.canvas
    rate = f"{float(canvas.frame_rate):.6g}"
    return (f"{request.path.name}  {length} @ {rate} fps  {canvas.width_px} × {canvas.height_px}",)


def video_request(document: Document, plan: ExportPlan, place: Place, workers: int) -> VideoRequest:
    """Return what a video is asked for with; it is called as the project, and as the layer it shows."""
    wanted = f"{place.name}_{plan.video_layer}_shadow" if plan.video_layer else place.name
    path = place.folder / f"{safe_names([wanted])[wanted]}.{plan.format}"
    return VideoRequest(path, _frames(document, plan), plan.video_layer or None, workers)


def frames_request(document: Document, plan: ExportPlan, folder: Path, workers: int) -> ExportRequest:
    """Return what numbered frames are asked for with."""
    apart = plan.kind in (ExportKind.LAYERS, ExportKind.FARM) and not plan.is_layered
    return ExportRequest(
        folder=folder,
        frames=None if plan.kind is ExportKind.AFTER_EFFECTS else _frames(document, plan),
        format=plan.format,
        depth=plan.depth,
        composite=plan.composite and apart,
        receivers=plan.receivers and apart,
        skip_existing=plan.skip_existing,
        workers=workers,
        layered=plan.is_layered,
    )


def _frames(document: Document, plan: ExportPlan) -> tuple[int, ...] | None:
    if not plan.only_work_area or document.work_area is None:
        return None
    first, last = document.played
    return tuple(range(first, last + 1))
