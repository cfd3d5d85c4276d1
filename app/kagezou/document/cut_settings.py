"""The settings of a whole cut, changed as one edit, and what is to be said of the change before it is made."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

from kagezou.animation.timecode import rate_text
from kagezou.document.address import addresses, track_of
from kagezou.document.edits import set_canvas
from kagezou.document.invariants import check_canvas
from kagezou.document.linking import is_linked
from kagezou.document.model import Canvas, Document
from kagezou.document.properties import FOV
from kagezou.document.refitting import Refit, refit_map, refitted
from kagezou.document.slate import Slate, checked_slate
from kagezou.errors import ProjectProblem, UsageProblem
from kagezou.message import Message


@dataclass(frozen=True, slots=True)
class CutSettings:
    """What is set for a whole cut."""

    canvas: Canvas
    slate: Slate

    @classmethod
    def of(cls, document: Document) -> "CutSettings":
        """Return the settings of a document."""
        return cls(document.canvas, document.slate)


@dataclass(frozen=True, slots=True)
class ChangedCut:
    """A document with other settings, and one sentence for each thing that comes of it."""

    document: Document
    notes: tuple[Message, ...]


def with_settings(document: Document, settings: CutSettings, refit: Refit) -> ChangedCut:
    """Return a document with other settings.

    Parameters
    ----------
    document
        The document.
    settings
        All of them; those that are as they were change nothing.
    refit
        What becomes of drawings, light, ground and set on a canvas of another size.

    Raises
    ------
    UsageProblem
        A setting is beyond what a cut can have.
    """
    wanted = settings.canvas
    try:
        check_canvas(wanted)
    except ProjectProblem as problem:
        raise UsageProblem(problem.message) from problem
    slate = checked_slate(settings.slate)
    sized = refitted(document, wanted.width_px, wanted.height_px, refit)
    changed = set_canvas(sized.document, wanted)
    if slate != document.slate:
        changed = replace(changed, slate=slate)
    notes = (*_on_size(document, wanted, refit, sized.limited), *_on_time(document, wanted))
    return ChangedCut(changed, notes)


def _on_size(document: Document, wanted: Canvas, refit: Refit, limited: int) -> Iterator[Message]:
    canvas = document.canvas
    if (canvas.width_px, canvas.height_px) == (wanted.width_px, wanted.height_px) or document.is_blank:
        return
    how = refit_map(canvas, wanted.width_px, wanted.height_px, refit)
    if refit is Refit.SCALE:
        yield Message("drawings and all lengths become {percent:.4g} % of what they were", percent=100 * how.factor)
        if wanted.width_px * canvas.height_px != wanted.height_px * canvas.width_px:
            yield Message(
                "the sides have another proportion: what was the picture is now the middle {width} × {height} px",
                width=round(canvas.width_px * how.factor),
                height=round(canvas.height_px * how.factor),
            )
        if document.background is not None:
            yield Message("the picture of the background keeps its own size in px")
    elif wanted.width_px < canvas.width_px or wanted.height_px < canvas.height_px:
        yield Message("what lies beyond the smaller picture is kept and not seen")
    elif document.background is not None:
        yield Message("the picture of the background keeps its own size in px")
    if limited:
        yield Message("lengths that would leave their range and are kept at its end: {count}", count=limited)
    if refit is Refit.STAY and _has_perspective(document):
        yield Message("the camera looks at the middle of the new picture: shadows in perspective change a little")


def _has_perspective(document: Document) -> bool:
    track = document.tracks.get(FOV.name)
    return track is not None and any(value != 0.0 for value in (track.constant, *(key.value for key in track.keys)))


def _on_time(document: Document, wanted: Canvas) -> Iterator[Message]:
    canvas = document.canvas
    if wanted.length_frames < canvas.length_frames:
        yield from _behind(document, wanted.length_frames)
    if wanted.frame_rate != canvas.frame_rate:
        yield Message(
            "at {rate} frames a second the cut lasts {after} instead of {before} s; keys and drawings stay on their "
            "frames",
            rate=rate_text(wanted.frame_rate),
            after=f"{float(wanted.length_frames / wanted.frame_rate):.2f}",
            before=f"{float(canvas.length_frames / canvas.frame_rate):.2f}",
        )
    if wanted.first_frame not in (canvas.first_frame, 1):
        yield Message(
            "the first frame is shown as {first}; files that are exported and the command line count from 1",
            first=wanted.first_frame,
        )


def _behind(document: Document, last: int) -> Iterator[Message]:
    """Yield what lies behind a new end."""
    keys = _keys_behind(document, last)
    if keys:
        yield Message("keys behind the new end, kept and not reached: {count}", count=keys)
    exposures = [
        exposure.frame > last and exposure.drawing is not None
        for layer in document.layers
        for exposure in layer.cels.exposures
    ]
    if any(exposures):
        yield Message("drawings exposed behind the new end, kept and not seen: {count}", count=sum(exposures))
    frames = (*(marker.frame for marker in document.markers), *(note.frame for note in document.notes))
    said = sum(frame > last for frame in frames)
    if said:
        yield Message("markers and notes behind the new end: {count}", count=said)


def _keys_behind(document: Document, last: int) -> int:
    first_id = document.layers[0].id if document.layers else None
    return sum(
        key.frame > last
        for address in addresses(document)
        # A linked property's keys are in every layer, and one to a person.
        if not (is_linked(document, address) and address.layer_id != first_id)
        for key in track_of(document, address).keys
    )
