"""Columns of dialogue and of camera work: who says what, and what the camera does, from which frame to which."""

from collections.abc import Iterator
from typing import Final

from kagezou.errors import ProjectProblem
from kagezou.io.files.json_text import Reader
from kagezou.io.sheets.timesheet import SheetMark
from kagezou.io.sheets.xdts_values import MAX_COLUMNS, MAX_FRAMES, SYMBOL, member, texts_of, whole
from kagezou.message import Message

DIALOGUE: Final = 3
CAMERA_WORK: Final = 5

_HYPHEN: Final = "SYMBOL_HYPHEN"
_UNREADABLE: Final = Message("a column of dialogue or camera work cannot be read")


def marks_of(table: Reader, length: int) -> tuple[tuple[SheetMark, ...], tuple[Message, ...]]:
    """Return what a table's columns of dialogue and camera work say within a sheet's length, and what cannot be read.

    A line is the speaker and the words, ``Taro: Good morning``, or what the camera does, ``PAN``. It goes on until an
    empty cel, the next one, or for as long as its column says that it goes on. The marks come by frames.
    """
    found: list[SheetMark] = []
    notes: dict[Message, None] = {}
    for track in _tracks(table):
        try:
            found += _column(member(track, "frames"), length)
        except ProjectProblem:
            if track.members().get("frames") is not None:
                notes[_UNREADABLE] = None
    return tuple(sorted(found, key=lambda mark: mark.frame)), tuple(notes)


def _tracks(table: Reader) -> Iterator[Reader]:
    listed = table.members().get("fields")
    for part in listed.items(MAX_COLUMNS) if listed is not None else ():
        kind = part.members().get("fieldId")
        tracks = part.members().get("tracks")
        if kind is not None and kind.value in (DIALOGUE, CAMERA_WORK) and tracks is not None:
            yield from tracks.items(MAX_COLUMNS)


def _column(frames: Reader, length: int) -> list[SheetMark]:
    rows = {whole(member(row, "frame"), -MAX_FRAMES, MAX_FRAMES): texts_of(row) for row in frames.items(MAX_FRAMES)}
    found: list[SheetMark] = []
    said, began, last = "", 0, -1
    for frame in (*sorted(rows), length):
        texts = rows.get(frame, []) if frame < length else []
        goes_on = bool(texts) and texts[0] == _HYPHEN
        if said and not goes_on:
            found.append(SheetMark(began, max(min(last + 1, length) - began, 1), said))
            said = ""
        # On one line, however it is written in its cell of the sheet.
        words = [" ".join(text.split()) for text in texts if text.strip() and not text.startswith(SYMBOL)]
        if words and frame >= 0:
            said, began = ": ".join(words), frame
        last = frame
    return found
