"""Putting a retake into a document: files are read first, beside the window; the document is changed in one step."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from math import dist
from types import MappingProxyType
from typing import Final

from kagezou.animation.track import Key, Track
from kagezou.document.edits import set_canvas
from kagezou.document.model import Cels, Document, Layer, Marker
from kagezou.document.paper import on_paper, paper_of
from kagezou.document.review import set_marker
from kagezou.errors import UsageProblem
from kagezou.geometry.box import Box
from kagezou.importing.feet import FeetOfLayer, feet_in, with_feet
from kagezou.importing.imported import Imported
from kagezou.importing.new_cels import CharacterSource
from kagezou.importing.progress import Progress, no_progress
from kagezou.importing.retakes.matching import How, Known, Match, matched
from kagezou.importing.retakes.pins import kept_pins
from kagezou.importing.retakes.prints import prints_of
from kagezou.importing.retakes.report import MovedContact, Report, Row
from kagezou.importing.retakes.timing import Retimed, retimed
from kagezou.importing.staging import Brought, brought
from kagezou.io.names.runs import number_in
from kagezou.message import Message, first_names
from kagezou.scene.stances import stances_of

_MOVED: Final = 0.01
"""A contact further away than this part of the height has moved."""

_MOST_MARKERS: Final = 100


@dataclass(frozen=True, slots=True)
class RetakeRead:
    """What was read for a retake of a layer.

    Parameters
    ----------
    layer
        The layer as it was then.
    brought
        The files; the first character counts.
    cels
        The new drawings.
    matches
        Which old drawing became which of them.
    feet
        What was found in them; None where nobody looked for feet before.
    """

    layer: Layer
    brought: Brought
    cels: Cels
    matches: tuple[Match, ...]
    feet: FeetOfLayer | None


@dataclass(frozen=True, slots=True)
class Retaken:
    """A document with a retake in it, what came of it, and what is odd about the files; both are in its notes."""

    imported: Imported
    report: Report
    notes_of_files: tuple[Message, ...]


def read_retake(
    document: Document, layer_id: str, sources: Sequence[CharacterSource], progress: Progress = no_progress
) -> RetakeRead:
    """Return other drawings for a layer, read and matched with those it has.

    Raises
    ------
    InputProblem
        A file that was asked for cannot be found or opened, or is too large.
    UsageProblem
        There are no drawings in the sources.
    """
    read = brought(sources, document.canvas, progress)
    if not read.characters:
        raise UsageProblem(Message("there are no drawings that could take the place of those of the layer"))
    layer = document.layer(layer_id)
    cels = on_paper(read.characters[0].cels, paper_of(layer))
    old, new = layer.cels.drawings, cels.drawings
    prints = prints_of((each.source for each in (*old, *new)), progress)
    before, after = (
        [Known(number_in(each.name) or each.name, prints.get(each.source)) for each in drawings]
        for drawings in (old, new)
    )
    matches = matched(before, after)
    timed = replace(cels, exposures=_timed(document, layer, cels, matches).exposures)
    looked = any(drawing.feet is not None for drawing in old)
    feet = feet_in(replace(layer, cels=timed), progress) if looked else None
    return RetakeRead(layer, read, cels, matches, feet)


def retaken(document: Document, layer_id: str, read: RetakeRead) -> Retaken:
    """Return the document with a retake in a layer: what was set stays where it makes sense, and all else is said."""
    layer = document.layer(layer_id)
    if layer.cels.drawings != read.layer.cels.drawings:
        # It got others while the files were read; what was matched are those of then.
        layer = replace(layer, cels=read.layer.cels)
    timing = _timed(document, layer, read.cels, read.matches)
    cels = replace(read.cels, exposures=timing.exposures)
    changed = replace(layer, cels=cels, figure=_figure(document, layer, read))
    after = _with_layer(document, changed)
    if read.feet is not None:
        after = with_feet(after, layer_id, read.feet)
    after, kept, dropped = _with_pins(after, layer, read.matches)
    after, moved, lost = _with_keys(after, layer_id, timing)
    longer = max(document.canvas.length_frames, timing.length_frames)
    after = set_canvas(after, replace(after.canvas, length_frames=longer))
    report = Report(
        layer.name,
        _rows(layer.cels, read.cels, read.matches),
        _moved_contacts(document, after, layer_id, timing),
        pins_kept=kept,
        pins_dropped=dropped,
        keys_moved=moved,
        keys_dropped=lost,
        gone_frames=() if timing.closes_up else timing.gone,
        unseen=tuple(read.cels.drawings[number].name for number in timing.unseen),
    )
    report = replace(report, frames=_to_look_at(after, layer_id, read.matches, report.contacts))
    marked = _marked(after, report)
    of_files = _notes_of_files(layer.name, read.brought)
    return Retaken(Imported(marked, (*report.messages, *of_files), (layer_id,)), report, of_files)


def _timed(document: Document, layer: Layer, cels: Cels, matches: Iterable[Match]) -> Retimed:
    became = {match.before: match.after for match in matches}
    return retimed(layer.cels, cels, became, document.canvas.length_frames)


def _figure(document: Document, layer: Layer, read: RetakeRead) -> Box:
    """Return the figure of the first drawing; that of before where the first drawing is as it was."""
    first = next((match for match in read.matches if match.before == match.after == 0), None)
    seen = read.brought.figures_seen[0].figure
    if first is not None and first.how is How.SAME:
        return layer.figure
    return document.canvas.box if seen is None else seen.on(document.canvas.box).box


def _with_layer(document: Document, layer: Layer) -> Document:
    return replace(document, layers=tuple(layer if each.id == layer.id else each for each in document.layers))


def _with_pins(
    document: Document, before: Layer, matches: Iterable[Match]
) -> tuple[Document, int, tuple[tuple[str, int], ...]]:
    """Return the document with the pins that stay, how many they are, and on which old drawings how many do not."""
    layer = document.layer(before.id)
    drawings = list(layer.cels.drawings)
    became = {match.before: match.after for match in matches}
    kept, dropped = 0, []
    for number, old in enumerate(before.cels.drawings):
        new = became.get(number)
        if not old.pins:
            continue
        stays = None if new is None else kept_pins(old, drawings[new])
        if stays is not None and new is not None:
            drawings[new] = replace(drawings[new], pins=stays.pins)
            kept += len(stays.pins)
        lost = len(old.pins) if stays is None else stays.dropped
        if lost:
            dropped.append((old.name, lost))
    cels = replace(layer.cels, drawings=tuple(drawings))
    return _with_layer(document, replace(layer, cels=cels)), kept, tuple(dropped)


def _with_keys(document: Document, layer_id: str, timing: Retimed) -> tuple[Document, int, tuple[tuple[str, int], ...]]:
    """Return the document with keys and notes of a layer moved along with its drawings, how many, and those lost.

    Properties that are linked are of all layers, and stay.
    """
    if not timing.moves:
        return document, 0, ()
    layer = document.layer(layer_id)
    tracks = dict(layer.tracks)
    moved, lost = 0, []
    for name, track in layer.tracks.items():
        if track.keys and name not in document.linked:
            keys, left = _moved_keys(track, timing)
            tracks[name] = replace(track, keys=tuple(keys))
            moved += sum(timing.moved(key.frame) != key.frame for key in track.keys if key.frame not in left)
            lost += [(name, frame) for frame in left]
    notes = tuple(
        replace(note, frame=timing.moved(note.frame)) if note.layer_id == layer_id else note for note in document.notes
    )
    changed = replace(layer, tracks=MappingProxyType(tracks))
    return replace(_with_layer(document, changed), notes=notes), moved, tuple(lost)


def _moved_keys(track: Track, timing: Retimed) -> tuple[list[Key], list[int]]:
    """Return the keys where their drawings went, and the frames of before of those that came upon another one."""
    keys: dict[int, Key] = {}
    lost: list[int] = []
    # Those of drawings that are still there come first: on one frame they win.
    for key in sorted(track.keys, key=lambda key: not timing.stays(key.frame)):
        frame = timing.moved(key.frame)
        if frame in keys:
            lost.append(key.frame)
        else:
            keys[frame] = replace(key, frame=frame)
    return [keys[frame] for frame in sorted(keys)], lost


def _rows(before: Cels, after: Cels, matches: Iterable[Match]) -> tuple[Row, ...]:
    by_new = {match.after: match for match in matches}
    rows = []
    for number, drawing in enumerate(after.drawings):
        match = by_new.get(number)
        old = None if match is None else before.drawings[match.before].name
        rows.append(Row(old, drawing.name, None if match is None else match.how))
    known = {match.before for match in by_new.values()}
    gone = (Row(drawing.name, None, None) for number, drawing in enumerate(before.drawings) if number not in known)
    return (*rows, *gone)


def _moved_contacts(before: Document, after: Document, layer_id: str, timing: Retimed) -> tuple[MovedContact, ...]:
    """Return the contacts of before that are elsewhere now, or none any more; a drawing that is gone has none."""
    figure_id = before.layer(layer_id).joins or layer_id
    old, new = stances_of(before, figure_id), stances_of(after, figure_id)
    if old is None or new is None:
        return ()
    found: dict[int, MovedContact] = {}
    gone = set(timing.gone)
    for start, stance in zip(old.frames, old.stances, strict=True):
        frame = timing.moved(start)
        drawing = after.layer(layer_id).cels.drawing_at(frame)
        if start in gone or drawing is None or frame in found:
            continue
        stands = [foot.place for foot in new.at(frame).feet if foot.is_planted]
        for foot in stance.feet:
            away = min((dist(foot.place, place) for place in stands), default=None)
            if foot.is_planted and (away is None or away > _MOVED * old.height_px):
                part = None if away is None else away / old.height_px
                found[frame] = MovedContact(frame, drawing.name, part)
    return tuple(found[frame] for frame in sorted(found))


def _to_look_at(
    document: Document, layer_id: str, matches: Iterable[Match], contacts: Iterable[MovedContact]
) -> tuple[int, ...]:
    """Return the frames on which a drawing begins that is new or another picture, or a contact moved."""
    as_before = {match.after for match in matches if match.how in (How.SAME, How.PICTURE)}
    exposures = document.layer(layer_id).cels.exposures
    other = {each.frame for each in exposures if each.drawing is not None and each.drawing not in as_before}
    return tuple(sorted(other | {each.frame for each in contacts}))


def _marked(document: Document, report: Report) -> Document:
    """Return the document with a marker where each run of frames to look at begins; markers that are there stay."""
    taken = {marker.frame for marker in document.markers}
    starts = [frame for frame in report.frames if frame - 1 not in report.frames and frame not in taken]
    for frame in starts[:_MOST_MARKERS]:
        document = set_marker(document, Marker(frame, f"retake: {report.name}"))
    return document


def _notes_of_files(name: str, read: Brought) -> tuple[Message, ...]:
    new, seen = read.characters[0], read.figures_seen[0]
    notes = [*read.notes, *new.notes, *(note for note in seen.notes if note not in new.notes)]
    if len(read.characters) > 1:
        others = first_names(each.name for each in read.characters[1:])
        notes.append(Message("{name}: a layer holds one character; left out: {names}", name=name, names=others))
    return tuple(notes)
