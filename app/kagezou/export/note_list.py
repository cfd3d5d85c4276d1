"""The notes of a cut as a list to be handed on: lines to read, or a table."""

import csv
import io
from dataclasses import dataclass
from typing import Final

from kagezou.animation.timecode import sheet_text
from kagezou.document.model import Document
from kagezou.document.note import Note
from kagezou.document.properties import OF_DOCUMENT, OF_LAYER
from kagezou.document.property import AnyProperty
from kagezou.message import Message, Translate

SUFFIXES: Final = {"csv": ".csv", "text": ".txt"}
"""The forms a list may have, and the suffix of their files."""

_COLUMNS: Final = (
    Message("frame"),
    Message("time"),
    Message("layer"),
    Message("property"),
    Message("note"),
    Message("author"),
    Message("answers"),
    Message("done"),
)
_BYTE_ORDER_MARK: Final = "\ufeff"
"""By it spreadsheets know that a table is UTF-8; without it Japanese is garbled."""


@dataclass(frozen=True, slots=True)
class NoteRow:
    """A note with the names that people know; ``layer`` is empty for one about the scene."""

    note: Note
    time: str
    layer: str
    property: AnyProperty

    def place(self, translate: Translate) -> str:
        """Return what it is about: layer and property."""
        label = self.property.label.sentence(translate)
        return f"{self.layer} · {label}" if self.layer else label


def note_rows(document: Document) -> tuple[NoteRow, ...]:
    """Return the notes in the order of their frames."""
    names = {layer.id: layer.name for layer in document.layers}
    rate = document.canvas.frame_rate
    return tuple(
        NoteRow(
            note,
            sheet_text(note.frame, rate),
            "" if note.layer_id is None else names[note.layer_id],
            (OF_DOCUMENT if note.layer_id is None else OF_LAYER)[note.property],
        )
        for note in sorted(document.notes, key=lambda each: each.frame)
    )


def notes_as_text(document: Document, translate: Translate) -> str:
    """Return the notes as lines to read: each with a box, its answers below it."""
    blocks = []
    for row in note_rows(document):
        note = row.note
        author = f" ({note.author})" if note.author else ""
        lines = [f"[{'x' if note.is_done else ' '}] {note.frame} ({row.time})  {row.place(translate)}{author}"]
        lines += [f"    {line}" for line in note.text.splitlines()]
        for answer in note.answers:
            first, *rest = answer.text.splitlines()
            lines.append(f"    > {answer.author}{': ' if answer.author else ''}{first}")
            lines += [f"      {line}" for line in rest]
        blocks.append("\n".join(lines) + "\n")
    return "\n".join(blocks)


def notes_as_csv(document: Document, translate: Translate) -> str:
    """Return the notes as a table with a heading, which spreadsheets open as it is."""
    made = io.StringIO(newline="")
    table = csv.writer(made)
    table.writerow([column.sentence(translate) for column in _COLUMNS])
    for row in note_rows(document):
        note = row.note
        answers = "\n".join(f"{each.author}{': ' if each.author else ''}{each.text}" for each in note.answers)
        words = (row.layer, row.property.label.sentence(translate), note.text, note.author, answers)
        table.writerow([note.frame, row.time, *map(_no_formula, words), int(note.is_done)])
    return _BYTE_ORDER_MARK + made.getvalue()


def _no_formula(text: str) -> str:
    """Return words that a spreadsheet takes for words: those that begin as a formula get an apostrophe before them."""
    return f"'{text}" if text.startswith(("=", "+", "-", "@", "\t")) else text
