"""Timesheets written as XDTS, as OpenToonz writes them."""

import json
import re
from pathlib import Path
from typing import Any, Final

from kagezou.errors import ProjectProblem
from kagezou.io.files.atomic import write_bytes
from kagezou.io.files.json_text import parse
from kagezou.io.names.runs import number_in
from kagezou.io.sheets.timesheet import SheetTrack, Timesheet
from kagezou.io.sheets.xdts import CELS, CELS_OF_TDTS, EMPTY_CEL, FIRST_LINE, TABLES, numbers_of
from kagezou.io.sheets.xdts_values import MAX_COLUMNS, NO_NUMBERS, SYMBOL
from kagezou.message import Message

_VERSION: Final = 5
_ALIKE: Final = (3, 5)
_NUMBER: Final = re.compile(r"[0-9]{1,4}")
Tree = dict[str, Any]
"""An object of JSON."""
_Kept = tuple[str, dict[int, Tree] | None]
"""The name of a column and its rows by frames; None where it has no place for rows."""


def xdts_text(sheet: Timesheet) -> str:
    """Return a timesheet as the text of an XDTS file, as OpenToonz writes it.

    A column that does not begin on the first frame begins with an empty cel, unless it was read without one; columns
    without a name have an empty one, so that the others keep their places. What the sheet has kept of a file stays as
    it is: its name, scene and cut, dialogue, camera work, marks in columns of the same name, and what is unknown here.
    """
    tree, table = _kept(sheet.kept)
    columns = _columns(sheet, _kept_columns(table))
    tracks = [{"trackNo": number, "frames": rows} for number, (_, rows) in enumerate(columns) if rows is not None]
    names = [name for name, _ in columns]
    made = {
        **table,
        "name": table.get("name") or sheet.name,
        "duration": sheet.length_frames,
        "timeTableHeaders": [{"fieldId": CELS, "names": names}, *_others(table, "timeTableHeaders")],
        "fields": [{"fieldId": CELS, "tracks": tracks}, *_others(table, "fields")],
    }
    whole = {**tree, **_header(sheet, tree), TABLES: [made]}
    whole["version"] = tree.get("version", _VERSION)
    return f"{FIRST_LINE}\n{json.dumps(whole, ensure_ascii=False, indent=1)}\n"


def notes_on_head(sheet: Timesheet) -> tuple[Message, ...]:
    """Return what is to be said of the numbers that a written sheet has in its head."""
    return tuple(
        Message(
            "{word!r} is written as {which!r} of the timesheet, where some programs take digits alone, four at most",
            word=word,
            which=which,
        )
        for which, word in (("scene", sheet.scene), ("cut", sheet.cut))
        if word and not _NUMBER.fullmatch(word)
    )


def _header(sheet: Timesheet, tree: Tree) -> Tree:
    """Return the head: what is said of scene and cut wins over what was kept. A sheet read without one has none."""
    kept = tree.get("header")
    before = dict(zip(("scene", "cut"), numbers_of(tree), strict=True))
    said = {key: word for key, word in (("cut", sheet.cut), ("scene", sheet.scene)) if word and word != before[key]}
    if isinstance(kept, dict):
        return {"header": {**kept, **said}}
    return {"header": {**NO_NUMBERS, **said}} if said or not tree else {}


def _kept(text: str) -> tuple[Tree, Tree]:
    """Return what was kept of a file and the table in it, both empty where it is nothing that a reader kept."""
    try:
        tree = parse(text) if text else {}
    except ProjectProblem:
        return {}, {}
    tables = tree.get(TABLES) if isinstance(tree, dict) else None
    if not isinstance(tree, dict) or not isinstance(tables, list) or not tables or not isinstance(tables[0], dict):
        return {}, {}
    return tree, tables[0]


def _others(table: Tree, key: str) -> list[Tree]:
    """Return the parts of a table that are about dialogue and camera work, which all programs number alike.

    Of XDTS the others, too, but for cels; TDTS has other numbers for them.
    """
    parts = _parts(table, key)
    if any(part.get("fieldId") == CELS_OF_TDTS for part in parts):
        return [part for part in parts if part.get("fieldId") in _ALIKE]
    return [part for part in parts if part.get("fieldId") != CELS]


def _parts(tree: Tree, key: str) -> list[Tree]:
    listed = tree.get(key)
    return [part for part in listed if isinstance(part, dict)] if isinstance(listed, list) else []


def _columns(sheet: Timesheet, kept: list[_Kept]) -> list[tuple[str, list[Tree] | None]]:
    """Return the names and rows of all columns: the sheet's, and kept ones that it lacks behind their neighbours.

    None for a column without rows that had no place for any.
    """
    left = list(enumerate(kept))
    made: list[tuple[int, str, list[Tree] | None]] = []
    for track in sheet.tracks:
        alike = [each for each in left if each[1][0] == track.name]
        # Of columns of one name those that have a place for rows come first, as they do in a sheet that was read.
        at, (_, before) = min(alike, key=lambda each: each[1][1] is None, default=(-1, ("", None)))
        left = [each for each in left if each[0] != at]
        rows = _rows(track, before or {}, sheet.length_frames)
        made.append((at, track.name, None if before is None and not rows else rows))
    for at, (name, before) in left:
        places = [place for place, (other, _, _) in enumerate(made) if 0 <= other < at]
        shown = None if before is None else [before[each] for each in sorted(before) if each < sheet.length_frames]
        made.insert(places[-1] + 1 if places else 0, (at, name, shown))
    return [(name, rows) for _, name, rows in made]


def _kept_columns(table: Tree) -> list[_Kept]:
    """Return the names of the kept cel columns and their rows by frames, in the order of the columns."""
    headed = next((part.get("names") for part in _cels(table, "timeTableHeaders")), None)
    names = [str(name).strip() for name in headed] if isinstance(headed, list) else []
    tracks = [track for part in _cels(table, "fields") for track in _parts(part, "tracks")]
    rows = {track["trackNo"]: _by_frame(track) for track in tracks if _is_place(track.get("trackNo"))}
    count = max(len(names), *(number + 1 for number in rows), 0)
    return [(names[number] if number < len(names) else "", rows.get(number)) for number in range(count)]


def _by_frame(track: Tree) -> dict[int, Tree]:
    return {row["frame"]: row for row in _parts(track, "frames") if _is_whole(row.get("frame"))}


def _is_place(value: object) -> bool:
    return _is_whole(value) and isinstance(value, int) and 0 <= value < MAX_COLUMNS


def _is_whole(value: object) -> bool:
    return isinstance(value, int) and not isinstance(value, bool)


def _cels(table: Tree, key: str) -> list[Tree]:
    """Return the parts of a table that are about cel columns; of TDTS, which has another field for them, those."""
    parts = _parts(table, key)
    wanted = CELS_OF_TDTS if any(part.get("fieldId") == CELS_OF_TDTS for part in parts) else CELS
    return [part for part in parts if part.get("fieldId") == wanted]


def _rows(track: SheetTrack, before: dict[int, Tree], length_frames: int) -> list[Tree]:
    """Return a column's rows: those that say the same as before stay, and marks where nothing changes."""
    entries = dict(track.entries)
    said_before = [frame for frame in before if frame >= 0 and not _is_mark(_said(before[frame]))]
    if entries and min(entries) > 0 and min(said_before, default=0) == 0:
        entries[0] = None
    rows = {frame: row for frame, row in before.items() if 0 <= frame < length_frames and _is_mark(_said(row))}
    early = {frame: row for frame, row in before.items() if frame < 0}
    if 0 in entries and 0 not in said_before and _begins_with(early, entries[0]):
        # It is said before the first frame, as some programs do, and there may be a mark on that.
        rows |= early
        del entries[0]
    for frame, cel in entries.items():
        old = before.get(frame, {})
        is_same = frame in before and _says(old, cel)
        rows[frame] = old if is_same else {"frame": frame, "data": [{"id": 0, "values": [cel or EMPTY_CEL]}]}
    return [rows[frame] for frame in sorted(rows)]


def _begins_with(early: dict[int, Tree], cel: str | None) -> bool:
    """Whether the last of the rows before the first frame that says a cel says this one."""
    last = max((frame for frame, row in early.items() if _said(row) and not _is_mark(_said(row))), default=None)
    return last is not None and _says(early[last], cel)


def _says(row: Tree, cel: str | None) -> bool:
    text = EMPTY_CEL if cel is None else cel
    return _said(row) == text or (cel is not None and _is_cel(_said(row), cel))


def _is_cel(said: str, cel: str) -> bool:
    """Whether a row names a drawing by its number in another way: ``A02`` for 2."""
    return "." not in said and not said.startswith(SYMBOL) and number_in(said) == number_in(cel) is not None


def _is_mark(said: str) -> bool:
    return said.startswith(SYMBOL) and said != EMPTY_CEL


def _said(row: Tree) -> str:
    """Return the first thing that a row says; empty where it says nothing."""
    for part in _parts(row, "data"):
        values = part.get("values")
        if isinstance(values, list) and values:
            return str(values[0]).strip()
    return ""


def write_xdts(path: Path, sheet: Timesheet) -> None:
    """Write a timesheet as XDTS, as a whole or not at all.

    Raises
    ------
    DiskFullProblem, OutputProblem
        It cannot be written.
    """
    # Names of files may hold what no UTF-8 text can.
    write_bytes(path, xdts_text(sheet).encode("utf-8", "replace"))
