"""Whether a step leaves a project that can be saved and loads again; asked before the step is taken for made.

What a step changed is written and read as in a project's file, so that the reader's rules are the only ones. What all
of it comes to is summed up step by step, and measured only where the sum could be too much.
"""

from dataclasses import dataclass, replace
from pathlib import Path
from types import MappingProxyType
from typing import Final

from kagezou.animation.track import Track
from kagezou.document.invariants import check_structure
from kagezou.document.model import NO_TRACKS, BroughtLight, Cels, Document, Exposure, Layer, Piece, Tracks
from kagezou.document.set_pieces import MAX_PIECES
from kagezou.errors import ProjectProblem
from kagezou.io.files.json_text import MOST_VALUES, Reader, formatted, parse, value_count
from kagezou.io.project.fields import MAX_LAYERS, MAX_ROWS
from kagezou.io.project.file import MAX_BYTES
from kagezou.io.project.reading import document_of, row_count
from kagezou.io.project.versions import upgraded
from kagezou.io.project.writing import tree_of
from kagezou.message import Message

_FOLDER: Final = Path(Path.home().anchor)
_PATH_BYTES: Final = 3
"""A character of a path takes at most so many bytes, but for those that no text has."""


@dataclass(frozen=True, slots=True)
class Weight:
    """How much of what a project may have at most: bytes of text, and its lists, objects and commas."""

    size: int = 0
    values: int = 0

    def __add__(self, other: "Weight") -> "Weight":
        """Return both together."""
        return Weight(self.size + other.size, self.values + other.values)

    @property
    def is_too_much(self) -> bool:
        """Whether no project can hold it."""
        return self.size > MAX_BYTES or self.values > MOST_VALUES


class Savable:
    """Follows a document from step to step and refuses those after which it could not be saved.

    Parameters
    ----------
    document
        The document before the first step, which can be saved.
    """

    def __init__(self, document: Document) -> None:
        self._last, self._weight = document, weight_of(document)
        # What was ever there or added is more than any document of the history, whichever undo goes back to.
        self._ever = self._weight

    def admit(self, before: Document, after: Document) -> None:
        """Take a step for made.

        Raises
        ------
        ProjectProblem
            The document after it could not be saved, or would not load again; the step is not counted.
        """
        try:
            added = _checked(before, after)
            ever, weight = self._ever + added, (self._weight if before is self._last else self._ever) + added
            if weight.is_too_much:
                weight = weight_of(after)
                if weight.is_too_much:
                    raise ProjectProblem(
                        Message(
                            "a project holds at most {megabytes} MB and {most} values",
                            megabytes=MAX_BYTES >> 20,
                            most=MOST_VALUES,
                        )
                    )
        except ProjectProblem as problem:
            raise ProjectProblem(
                Message("this was not done, as the project could not be saved any more: {cause}", cause=problem)
            ) from problem
        self._last, self._ever, self._weight = after, ever, weight


def weight_of(document: Document) -> Weight:
    """Return how much a document comes to in a project; what of it no project can name weighs nothing."""
    try:
        return _weight(formatted(tree_of(document, _FOLDER)))
    except ProjectProblem:  # said when it is saved, as another place may do
        return Weight()


def _checked(before: Document, after: Document) -> Weight:
    """Return the weight of what a step added, read as from a file."""
    check_structure(after)
    if len(after.layers) > MAX_LAYERS:
        raise ProjectProblem(Message("more than {most} layers", most=MAX_LAYERS))
    if len(after.pieces) > MAX_PIECES:
        raise ProjectProblem(Message("a set has at most {most_pieces} pieces", most_pieces=MAX_PIECES))
    if row_count(after) > MAX_ROWS:
        raise ProjectProblem(Message("more than {most_rows} drawings, exposures and keys", most_rows=MAX_ROWS))
    added = _added(before, after)
    text = formatted(tree_of(_without_paths(added), _FOLDER))
    document_of(Reader(upgraded(parse(text))), _FOLDER)
    named = (drawing.path for cels in _cels_of(added) for drawing in cels.drawings)
    return _weight(text) + Weight(_PATH_BYTES * sum(len(str(path)) for path in named))


def _weight(text: str) -> Weight:
    return Weight(len(text.encode("utf-8")), value_count(text))


def _cels_of(document: Document) -> tuple[Cels, ...]:
    return (document.behind, *(layer.cels for layer in document.layers))


def _added(before: Document, after: Document) -> Document:
    """Return the document with nothing but what ``before`` has not, by identity: what is equal may be there too."""
    layers = {each.id: each for each in before.layers}
    pieces = {each.id: each for each in before.pieces}
    notes = after.notes if after.notes is not before.notes else ()
    noted = {note.layer_id for note in notes}
    return replace(
        after,
        behind=_added_cels(before.behind, after.behind),
        layers=tuple(
            _added_layer(layers.get(each.id), each)
            for each in after.layers
            if layers.get(each.id) is not each or each.id in noted
        ),
        tracks=_added_tracks(before.tracks, after.tracks),
        markers=after.markers if after.markers is not before.markers else (),
        notes=notes,
        pieces=tuple(
            _added_piece(pieces.get(each.id), each) for each in after.pieces if pieces.get(each.id) is not each
        ),
        brought_light=_added_light(before.brought_light, after.brought_light),
        timesheet=after.timesheet if after.timesheet is not before.timesheet else "",
    )


def _added_layer(before: Layer | None, layer: Layer) -> Layer:
    if before is None:
        return layer
    tracks = _added_tracks(before.tracks, layer.tracks)
    return replace(layer, cels=_added_cels(before.cels, layer.cels), tracks=tracks)


def _added_piece(before: Piece | None, piece: Piece) -> Piece:
    return piece if before is None else replace(piece, tracks=_added_tracks(before.tracks, piece.tracks))


def _added_light(before: BroughtLight | None, light: BroughtLight | None) -> BroughtLight | None:
    return None if light is before else light


def _added_cels(before: Cels, cels: Cels) -> Cels:
    if cels is before:
        return Cels()
    known = {id(drawing) for drawing in before.drawings}
    # Only how far they reach can be wrong of exposures; in between they are in order.
    ends = {exposure.frame: Exposure(exposure.frame, None) for exposure in (*cels.exposures[:1], *cels.exposures[-1:])}
    return Cels(tuple(drawing for drawing in cels.drawings if id(drawing) not in known), tuple(ends.values()))


def _added_tracks(before: Tracks, tracks: Tracks) -> Tracks:
    if tracks is before:
        return NO_TRACKS
    changed = {name: track for name, track in tracks.items() if before.get(name) is not track}
    return MappingProxyType({name: _added_keys(before.get(name), track) for name, track in changed.items()})


def _added_keys(before: Track | None, track: Track) -> Track:
    if before is None:
        return track
    known = {id(key) for key in before.keys}
    return Track(track.constant, tuple(key for key in track.keys if id(key) not in known))


def _without_paths(document: Document) -> Document:
    """Return the document with one short path for all; whether a project can name one depends on where it is saved."""
    short = _FOLDER / "a"

    def shortened(cels: Cels) -> Cels:
        drawings = tuple(replace(drawing, path=short) for drawing in cels.drawings)
        return Cels(drawings, cels.exposures) if drawings else cels

    return replace(
        document,
        behind=shortened(document.behind),
        layers=tuple(replace(layer, cels=shortened(layer.cels)) for layer in document.layers),
        pieces=tuple(replace(piece, source=piece.source and short) for piece in document.pieces),
    )
