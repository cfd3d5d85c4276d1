"""Edits of what people say about a cut: its work area, markers and notes."""

from dataclasses import replace

from kagezou.document.address import Address
from kagezou.document.model import Document, Marker
from kagezou.document.note import Note, NoteAnswer
from kagezou.errors import UsageProblem
from kagezou.message import Message

MAX_TEXT_CHARACTERS = 4000
MAX_ANSWERS = 200


def set_work_area(document: Document, first: int | None, last: int | None) -> Document:
    """Play and work on the frames from ``first`` to ``last``; None reaches to the end of the cut on that side.

    The ends change places if they lie the other way round; the whole cut is no work area.
    """
    length = document.canvas.length_frames
    ends = sorted(min(max(frame, 1), length) for frame in (first or 1, last or length))
    area = None if ends == [1, length] else (ends[0], ends[1])
    return document if area == document.work_area else replace(document, work_area=area)


def set_marker(document: Document, marker: Marker) -> Document:
    """Put a marker on its frame, in the place of one that is there.

    Raises
    ------
    UsageProblem
        If it lies before frame 1, lasts less than nothing, or says too much.
    """
    if marker.frame < 1 or marker.duration_frames < 0:
        raise UsageProblem(
            Message(
                "a marker cannot lie on frame {frame} for {duration_frames} frames",
                frame=marker.frame,
                duration_frames=marker.duration_frames,
            )
        )
    _check_text(marker.comment)
    others = [other for other in document.markers if other.frame != marker.frame]
    markers = tuple(sorted((*others, marker), key=lambda each: each.frame))
    return document if markers == document.markers else replace(document, markers=markers)


def remove_marker(document: Document, frame: int) -> Document:
    """Take the marker on a frame away."""
    markers = tuple(marker for marker in document.markers if marker.frame != frame)
    return document if markers == document.markers else replace(document, markers=markers)


def move_marker(document: Document, frame: int, to: int) -> Document:
    """Put the marker of one frame on another, not before frame 1."""
    marker = next((each for each in document.markers if each.frame == frame), None)
    if marker is None or frame == to:
        return document
    return set_marker(remove_marker(document, frame), replace(marker, frame=max(to, 1)))


def add_note(document: Document, address: Address, frame: int, text: str, author: str = "") -> Document:
    """Pin a note to a property and a frame.

    Raises
    ------
    UsageProblem
        If it says nothing or too much, or lies before frame 1.
    """
    if not text.strip() or frame < 1:
        raise UsageProblem(Message("a note needs words and a frame from 1 on"))
    _check_text(text)
    note = Note(frame, address.property.name, text, address.layer_id, author)
    return replace(document, notes=(*document.notes, note))


def change_note(document: Document, note: Note, text: str) -> Document:
    """Give a note other words; none take it away."""
    _check_text(text)
    if not text.strip():
        return replace(document, notes=tuple(each for each in document.notes if each != note))
    return _exchanged(document, note, replace(note, text=text))


def answer_note(document: Document, note: Note, text: str, author: str = "") -> Document:
    """Say something to a note, after what was said before.

    Raises
    ------
    UsageProblem
        If it says nothing or too much, or there are too many answers.
    """
    if not text.strip() or len(note.answers) >= MAX_ANSWERS:
        raise UsageProblem(Message("an answer needs words, and a note has at most {most} answers", most=MAX_ANSWERS))
    _check_text(text)
    return _exchanged(document, note, replace(note, answers=(*note.answers, NoteAnswer(text, author))))


def tick_note(document: Document, note: Note, *, done: bool) -> Document:
    """Tick a note off, or take the tick away."""
    return _exchanged(document, note, replace(note, is_done=done))


def _exchanged(document: Document, note: Note, other: Note) -> Document:
    """Return the document with another note in the place of one."""
    notes = tuple(other if each == note else each for each in document.notes)
    return document if notes == document.notes else replace(document, notes=notes)


def _check_text(text: str) -> None:
    if len(text) > MAX_TEXT_CHARACTERS:
        raise UsageProblem(
            Message(
                "a text of {count} characters is longer than the {most_text_characters} allowed",
                count=len(text),
                most_text_characters=MAX_TEXT_CHARACTERS,
            )
        )
