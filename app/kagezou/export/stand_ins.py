"""What stands in for drawings that are missing, where an export is to be made without them."""

from collections.abc import Collection, Iterable
from dataclasses import dataclass, replace
from functools import cache
from itertools import chain
from typing import Final

from kagezou.animation.frames import format_frames
from kagezou.document.edits import set_background_cels, set_exposures
from kagezou.document.model import Cels, Document, Exposure
from kagezou.export.checks import missing_pictures, missing_pictures_of
from kagezou.export.planning import FrameJob, Plan, planned
from kagezou.export.request import ExportRequest, Missing
from kagezou.message import Message, first_names
from kagezou.picture_source import PictureSource

_BEHIND: Final = Message("background")


@dataclass(frozen=True, slots=True)
class Filled:
    """A document in which something stands in for drawings that are missing, and what is to be said of each layer."""

    document: Document
    notes: tuple[Message, ...] = ()


def planned_without_missing(document: Document, request: ExportRequest) -> Plan:
    """Return what an export is to make, with something else in place of drawings that are not there.

    What stands in is said in the plan's notes. Where nothing of a layer is there, nothing stands in for it: that is a
    folder that has gone, and checking the plan's sources says so.

    Raises
    ------
    UsageProblem
        As of `planned`.
    InputProblem
        A file of which a layer is needed cannot be read at all.
    """
    plan = planned(document, request)
    filled = filled_for(document, plan.jobs, request.missing)
    if not filled.notes:
        return plan
    again = planned(filled.document, request)
    return replace(again, notes=(*filled.notes, *again.notes))


def filled_for(document: Document, jobs: Collection[FrameJob], way: Missing) -> Filled:
    """Return a document with stand-ins for what its jobs need and is not there; InputProblem as above."""
    if way is Missing.FAIL:
        return Filled(document)
    needed = missing_pictures(jobs)
    return _filled(document, needed, dict.fromkeys(target.frame for job in jobs for target in job.targets), way)


def filled_throughout(document: Document, way: Missing) -> Filled:
    """Return a document with stand-ins for every drawing that is exposed in the cut and is not there.

    For what hands on the drawings themselves, whether a shadow is made of them or not. InputProblem as above.
    """
    if way is Missing.FAIL:
        return Filled(document)
    frames = range(1, document.canvas.length_frames + 1)
    shown = [
        cels.drawing_at(frame)
        for cels in (*(each.cels for each in document.layers), document.behind)
        for frame in frames
    ]
    sources = dict.fromkeys(drawing.source for drawing in shown if drawing is not None)
    return _filled(document, missing_pictures_of(sources), frames, way)


def _filled(document: Document, lost: Iterable[PictureSource], frames: Collection[int], way: Missing) -> Filled:
    """Return the document with stand-ins on every layer and background that lacks something needed."""
    needed = frozenset(lost)
    notes: list[Message] = []
    for layer in document.layers:
        shown = _shown(layer.cels, needed, way)
        if shown != layer.cels.exposures:
            notes.append(_said(layer.name, layer.cels, needed, frames, way))
            document = set_exposures(document, layer.id, shown)
    shown = _shown(document.behind, needed, way)
    if shown != document.behind.exposures:
        notes.append(_said(_BEHIND, document.behind, needed, frames, way))
        document = set_background_cels(document, replace(document.behind, exposures=shown))
    return Filled(document, tuple(notes))


def _shown(cels: Cels, needed: frozenset[PictureSource], way: Missing) -> tuple[Exposure, ...]:
    """Return exposures without what is missing; as they are where nothing needed is, or nothing else is there."""
    if not any(drawing.source in needed for drawing in cels.drawings):
        return cels.exposures

    @cache
    def is_there(drawing: int) -> bool:
        # What stands in may lie outside the frames that were asked for, and be missing as well.
        source = cels.drawings[drawing].source
        return source not in needed and not missing_pictures_of((source,))

    there = [each.drawing is not None and is_there(each.drawing) for each in cels.exposures]
    if not any(there):
        return cels.exposures
    return tuple(
        each if each.drawing is None or is_at else replace(each, drawing=_stand_in(cels.exposures, there, place, way))
        for place, (each, is_at) in enumerate(zip(cels.exposures, there, strict=True))
    )


def _stand_in(exposures: tuple[Exposure, ...], there: list[bool], place: int, way: Missing) -> int | None:
    """Return the drawing that is seen instead: the last one before, else the first one after; None for nothing."""
    if way is Missing.EMPTY:
        return None
    for each in chain(range(place - 1, -1, -1), range(place + 1, len(exposures))):
        if there[each]:
            return exposures[each].drawing
    return None


def _said(name: object, cels: Cels, needed: frozenset[PictureSource], frames: Iterable[int], way: Missing) -> Message:
    """Return what is said of a layer: what is missing of it, and on which of the frames."""
    seen = [(frame, cels.drawing_at(frame)) for frame in frames]
    lost = [(frame, drawing.path.name) for frame, drawing in seen if drawing is not None and drawing.source in needed]
    names, on = first_names(dict.fromkeys(each for _, each in lost)), format_frames(frame for frame, _ in lost)
    if way is Missing.EMPTY:
        return Message("{name}: missing, so left empty on frames {frames}: {names}", name=name, frames=on, names=names)
    return Message(
        "{name}: missing, so the nearest drawing is held on frames {frames}: {names}", name=name, frames=on, names=names
    )
