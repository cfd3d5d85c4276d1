"""What people say about a cut, in the project file: work area, markers and notes."""

from collections.abc import Mapping, Set
from dataclasses import dataclass
from itertools import pairwise
from typing import Final

from kagezou.document.model import Document, Marker
from kagezou.document.note import Note, NoteAnswer
from kagezou.document.properties import OF_DOCUMENT, OF_LAYER
from kagezou.document.review import MAX_ANSWERS, MAX_TEXT_CHARACTERS
from kagezou.io.files.json_text import JsonRow, Reader
from kagezou.io.project import fields as fields
from kagezou.io.project.versions import Tree
from kagezou.message import Message

_MAX_FRAME: Final = 1_000_000


@dataclass(frozen=True, slots=True)
class Review:
    """The parts of a document that are read here."""

    work_area: tuple[int, int] | None
    markers: tuple[Marker, ...]
    notes: tuple[Note, ...]


def review_tree(document: Document) -> Tree:
    """Return what is said about the cut; what nobody said is not written."""
    said: Tree = {}
    if document.work_area is not None:
        said["work_area"] = JsonRow(list(document.work_area))
    if document.markers:
        said["markers"] = [JsonRow([each.frame, each.comment, each.duration_frames]) for each in document.markers]
    if document.notes:
        said["notes"] = [_note_row(note) for note in document.notes]
    return said


def read_review(found: Mapping[str, Reader], layer_ids: Set[str]) -> Review:
    """Return what is said about the cut, from the members of a project.

    Raises
    ------
    ProjectProblem
        With the JSON path of the first thing that is wrong.
    """
    area = _work_area(found["work_area"]) if "work_area" in found else None
    markers = _markers(found["markers"]) if "markers" in found else ()
    notes = found["notes"].items(fields.MAX_ROWS) if "notes" in found else ()
    return Review(area, markers, tuple(_note(each, layer_ids) for each in notes))


def _note_row(note: Note) -> JsonRow:
    row: Tree = {
        "frame": note.frame,
        "layer": note.layer_id,
        "property": note.property,
        "text": note.text,
        "author": note.author,
    }
    if note.answers:
        row["answers"] = [[each.author, each.text] for each in note.answers]
    if note.is_done:
        row["done"] = True
    return JsonRow(row)


def _work_area(reader: Reader) -> tuple[int, int]:
    first, last = (end.whole(1, _MAX_FRAME) for end in reader.items(2, least=2))
    if last < first:
        raise reader.problem(Message("frame {last} does not come after frame {first}", last=last, first=first))
    return first, last


def _markers(reader: Reader) -> tuple[Marker, ...]:
    markers = []
    for row in reader.items(fields.MAX_ROWS):
        frame, comment, duration = row.items(3, least=3)
        said = comment.text(MAX_TEXT_CHARACTERS, least=0)
        markers.append(Marker(frame.whole(1, _MAX_FRAME), said, duration.whole(0, _MAX_FRAME)))
    for index, (before, after) in enumerate(pairwise(markers), start=1):
        if after.frame <= before.frame:
            place = Reader(after.frame, f"{reader.place}[{index}][0]")
            raise place.problem(
                Message("frame {frame} does not come after frame {frame_2}", frame=after.frame, frame_2=before.frame)
            )
    return tuple(markers)


def _note(reader: Reader, layer_ids: Set[str]) -> Note:
    optional = [name for name, field in fields.NOTE.items() if field.optional]
    found = reader.record([name for name in fields.NOTE if name not in optional], optional)
    layer = None if found["layer"].value is None else found["layer"].text(fields.MAX_NAME_CHARACTERS)
    if layer is not None and layer not in layer_ids:
        raise found["layer"].problem(Message("there is no such layer"))
    return Note(
        frame=found["frame"].whole(1, _MAX_FRAME),
        property=found["property"].word(list(OF_DOCUMENT if layer is None else OF_LAYER)),
        text=found["text"].text(MAX_TEXT_CHARACTERS),
        layer_id=layer,
        author=found["author"].text(fields.MAX_NAME_CHARACTERS, least=0),
        answers=tuple(map(_answer, found["answers"].items(MAX_ANSWERS))) if "answers" in found else (),
        is_done=found["done"].switch() if "done" in found else False,
    )


def _answer(reader: Reader) -> NoteAnswer:
    author, text = reader.items(2, least=2)
    return NoteAnswer(text.text(MAX_TEXT_CHARACTERS), author.text(fields.MAX_NAME_CHARACTERS, least=0))
