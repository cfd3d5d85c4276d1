"""A timesheet on a document: its columns find their layers by name, its cels their drawings by number."""

import re
import unicodedata
from collections.abc import Iterable
from dataclasses import replace

from kagezou.document.edits import set_canvas, set_exposures
from kagezou.document.model import Document, Drawing, Exposure, Layer, Marker
from kagezou.document.review import MAX_TEXT_CHARACTERS
from kagezou.document.slate import NO_SLATE, Slate, checked_slate
from kagezou.errors import UsageProblem
from kagezou.importing.new_cels import printable
from kagezou.io.names.runs import number_in
from kagezou.io.sheets.timesheet import SheetTrack, Timesheet
from kagezou.io.sheets.xdts_values import NO_NUMBERS
from kagezou.message import Message, first_names

_SHOWN_CELS = 5
_BETWEEN = "_-. "
_BETWEEN_MARKS = " / "


def timed(document: Document, sheet: Timesheet) -> tuple[Document, list[Message]]:
    """Return the document exposed as the sheet says and as long, and notes about what does not match.

    A cel that no drawing has stays empty. A layer without a column keeps its exposures.
    """
    notes = [Message("the timesheet: {note}", note=note) for note in sheet.notes]
    free = list(document.layers)
    for track in sheet.tracks:
        layer = _layer_for(track.name, free)
        if layer is None:
            if track.entries:
                notes.append(Message("there is no layer for the timesheet's column {track!r}", track=track.name))
            continue
        free.remove(layer)
        exposures, missing = _exposed(layer, track)
        document = set_exposures(document, layer.id, exposures)
        if missing:
            notes.append(
                Message(
                    "{layer}: the timesheet names cels without a drawing; they stay empty: {missing}",
                    layer=layer.name,
                    missing=first_names(missing, _SHOWN_CELS),
                )
            )
    notes += [
        Message("{layer}: the timesheet has no column for it; it keeps its timing", layer=layer.name) for layer in free
    ]
    document = _marked(replace(document, timesheet=sheet.kept), sheet)
    document, more = _numbered(document, sheet)
    notes += more
    return set_canvas(document, replace(document.canvas, length_frames=sheet.length_frames)), notes


def _numbered(document: Document, sheet: Timesheet) -> tuple[Document, list[Message]]:
    """Return the document with the sheet's scene and cut where it has none, and what is said where they differ."""
    told = Slate(scene=sheet.scene, cut=sheet.cut)
    if told == NO_SLATE or told == Slate(scene=NO_NUMBERS["scene"], cut=NO_NUMBERS["cut"]):
        return document, []
    own = document.slate
    if not own.scene and not own.cut:
        try:
            return replace(document, slate=checked_slate(replace(told, name=own.name))), []
        except UsageProblem as problem:
            return document, [Message("the timesheet: {note}", note=problem.message)]
    if (own.scene, own.cut) == (told.scene, told.cut):
        return document, []
    words = Message(
        "the timesheet is of scene {scene!r}, cut {cut!r}; the project keeps {own_scene!r} and {own_cut!r}",
        scene=told.scene,
        cut=told.cut,
        own_scene=own.scene,
        own_cut=own.cut,
    )
    return document, [words]


def _marked(document: Document, sheet: Timesheet) -> Document:
    """Return the document with the sheet's dialogue and camera work as markers, beside those that are there."""
    words: dict[int, list[str]] = {}
    lengths: dict[int, int] = {}
    for mark in sheet.marks:
        words.setdefault(mark.frame + 1, []).append(mark.text)
        lengths[mark.frame + 1] = max(mark.length_frames, lengths.get(mark.frame + 1, 0))
    known = {marker.frame: marker for marker in document.markers}
    for frame, lines in words.items():
        before = known.get(frame)
        told = [] if before is None or not before.comment else before.comment.split(_BETWEEN_MARKS)
        comment = _BETWEEN_MARKS.join(dict.fromkeys((*told, *lines)))
        known[frame] = Marker(frame, comment[:MAX_TEXT_CHARACTERS], lengths[frame])
    return replace(document, markers=tuple(known[frame] for frame in sorted(known)))


def _layer_for(name: str, layers: Iterable[Layer]) -> Layer | None:
    """Return the layer of that name, or else the only one whose name ends with it as a word."""
    wanted = _plain(printable(name)) if name else ""
    exact = [layer for layer in layers if _plain(layer.name) == wanted]
    if exact or not wanted:
        return exact[0] if exact else None
    near = [layer for layer in layers if _plain(layer.name).endswith(f" {wanted}")]
    numbered = [layer for layer in layers if re.fullmatch(re.escape(wanted) + r" [0-9]+", _plain(layer.name))]
    if len(near) == 1:
        return near[0]
    return numbered[0] if numbered else None


def _plain(name: str) -> str:
    # A sheet may have full-width letters and figures.
    return unicodedata.normalize("NFKC", name).strip().casefold()


def _exposed(layer: Layer, track: SheetTrack) -> tuple[tuple[Exposure, ...], list[str]]:
    """Return the exposures of a column and the cels, once each, that the layer has no drawing of."""
    drawings = _Drawings(layer.cels.drawings)
    exposures: list[Exposure] = []
    missing: list[str] = []
    for frame, cel in track.entries:
        index = None if cel is None else drawings.index_of(cel, track.name)
        if cel is not None and index is None and cel not in missing:
            missing.append(cel)
        if not exposures or exposures[-1].drawing != index:
            exposures.append(Exposure(frame + 1, index))
    return tuple(exposures), missing


class _Drawings:
    """The drawings of a layer by all that a sheet may call them; the first of two with one name counts."""

    def __init__(self, drawings: tuple[Drawing, ...]) -> None:
        self._by_name: dict[str, int] = {}
        self._by_number: dict[tuple[int, str], int] = {}
        for index, drawing in enumerate(drawings):
            for name in {_plain(drawing.name), _plain(drawing.name if drawing.part else drawing.path.stem)}:
                self._by_name.setdefault(name, index)
            number = number_in(drawing.name)
            if number is not None:
                self._by_number.setdefault(number, index)

    def index_of(self, cel: str, column: str) -> int | None:
        """Return the drawing that a column's cel is: by name, else by number with or without the column's name."""
        name = _plain(cel)
        if name in self._by_name:
            return self._by_name[name]
        number = number_in(_behind(column, name)) or number_in(name)
        if number is None or number in self._by_number:
            return None if number is None else self._by_number[number]
        # Drawings that all have a letter, 1A and 2A, are asked for without it.
        near = [index for (each, _), index in self._by_number.items() if each == number[0] and not number[1]]
        return near[0] if len(near) == 1 else None


def _behind(column: str, cel: str) -> str:
    """Return what of a cel's name is not its column's; a column that ends with a figure is no part of a number."""
    rest = cel.removeprefix(_plain(column))
    is_cut = rest[:1].isdigit() and _plain(column)[-1:].isdigit()
    return cel if is_cut else rest.lstrip(_BETWEEN)


def sheet_of(document: Document, name: str) -> Timesheet:
    """Return the timesheet of a document: a column a layer, its drawings by their names."""
    length = document.canvas.length_frames
    tracks = tuple(SheetTrack(layer.name, _entries(layer, length)) for layer in document.layers)
    slate = document.slate
    return Timesheet(name, length, tracks, kept=document.timesheet, scene=slate.scene, cut=slate.cut)


def _entries(layer: Layer, length: int) -> tuple[tuple[int, str | None], ...]:
    """Return the entries within the cut; what was exposed before it began is what it begins with."""
    found: dict[int, str | None] = {}
    for exposure in layer.cels.exposures:
        if exposure.frame > length:
            break
        cel = None if exposure.drawing is None else layer.cels.drawings[exposure.drawing].name
        found[max(exposure.frame - 1, 0)] = cel
    return tuple(sorted(found.items()))
