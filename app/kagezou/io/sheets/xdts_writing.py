"""Timesheets written as XDTS, as OpenToonz writes them."""

import json
from pathlib import Path
from typing import Any, Final

from kagezou.errors import ProjectProblem
from kagezou.io.files.atomic import write_bytes
from kagezou.io.files.json_text import parse
from kagezou.io.names.runs import number_in
from kagezou.io.sheets.timesheet import SheetTrack, Timesheet
from kagezou.io.sheets.xdts import CELS, CELS_OF_TDTS, EMPTY_CEL, FIRST_LINE, TABLES
from kagezou.io.sheets.xdts_values import SYMBOL

_VERSION: Final = 5
_ALIKE: Final = (3, 5)
Tree = dict[str, Any]
"""An object of JSON."""


def xdts_text(sheet: Timesheet) -> str:
    """Return a timesheet as the text of an XDTS file, as OpenToonz writes it.

    A column that does not begin on the first frame begins with an empty cel; columns without a name have an empty one,
    so that the others keep their places. What the sheet has kept of a file stays as it is: its name, scene and cut,
    dialogue, camera work, marks in columns of the same name, and keys that are not known here.
    """
    tree, table = _kept(sheet.kept)
    columns = _columns(sheet, _kept_columns(table))
    tracks = [{"trackNo": number, "frames": rows} for number, (_, rows) in enumerate(columns) if rows]
    names = [name for name, _ in columns]
    made = {
        **table,
        "name": table.get("name") or sheet.name,
        "duration": sheet.length_frames,
        "timeTableHeaders": [{"fieldId": CELS, "names": names}, *_others(table, "timeTableHeaders")],
        "fields": [{"fieldId": CELS, "tracks": tracks}, *_others(table, "fields")],
    }
    whole = {**tree, "header": _header(sheet, tree), TABLES: [made]}
    whole["version"] = tree.get("version", _VERSION)
    return f"{FIRST_LINE}\n{json.dumps(whole, ensure_ascii=False, indent=1)}\n"


def _header(sheet: Timesheet, tree: Tree) -> Tree:
    """Return the head: what is said of scene and cut wins over what was kept."""
    kept = tree.get("header")
    said = {key: word for key, word in (("cut", sheet.cut), ("scene", sheet.scene)) if word}
    return {**(kept if isinstance(kept, dict) else {"cut": "1", "scene": "1"}), **said}


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
    """Return the parts of a table that are about dialogue and camera work, which all programs number alike."""
    return [part for part in _parts(table, key) if part.get("fieldId") in _ALIKE]


def _parts(tree: Tree, key: str) -> list[Tree]:
    listed = tree.get(key)
    return [part for part in listed if isinstance(part, dict)] if isinstance(listed, list) else []


def _columns(sheet: Timesheet, kept: list[tuple[str, dict[int, Tree]]]) -> list[tuple[str, list[Tree]]]:
    """Return the names and rows of all columns: the sheet's, and kept ones that it lacks behind their neighbours."""
    left = list(enumerate(kept))
    made: list[tuple[int, str, list[Tree]]] = []
    for track in sheet.tracks:
        mine = next((each for each in left if each[1][0] == track.name), (-1, ("", {})))
        left = [each for each in left if each[0] != mine[0]]
        made.append((mine[0], track.name, _rows(track, mine[1][1], sheet.length_frames)))
    for at, (name, rows) in left:
        places = [place for place, (other, _, _) in enumerate(made) if 0 <= other < at]
        shown = [rows[frame] for frame in sorted(rows) if frame < sheet.length_frames]
        made.insert(places[-1] + 1 if places else 0, (at, name, shown))
    return [(name, rows) for _, name, rows in made]


def _kept_columns(table: Tree) -> list[tuple[str, dict[int, Tree]]]:
    """Return the names of the kept cel columns and their rows by frames, in the order of the columns."""
    for header, part in zip(_cels(table, "timeTableHeaders"), _cels(table, "fields"), strict=False):
        names = header.get("names")
        if isinstance(names, list):
            numbered = [track for track in _parts(part, "tracks") if _is_whole(track.get("trackNo"))]
            rows = {track["trackNo"]: _by_frame(track) for track in numbered}
            return [(str(name).strip(), rows.get(number, {})) for number, name in enumerate(names)]
    return []


def _by_frame(track: Tree) -> dict[int, Tree]:
    return {row["frame"]: row for row in _parts(track, "frames") if _is_whole(row.get("frame"))}


def _is_whole(value: object) -> bool:
    return isinstance(value, int) and not isinstance(value, bool)


def _cels(table: Tree, key: str) -> list[Tree]:
    """Return the parts of a table that are about cel columns; TDTS, which has another field for them, comes first."""
    return sorted(
        (part for part in _parts(table, key) if part.get("fieldId") in (CELS, CELS_OF_TDTS)),
        key=lambda part: part["fieldId"] != CELS_OF_TDTS,
    )[:1]


def _rows(track: SheetTrack, before: dict[int, Tree], length_frames: int) -> list[Tree]:
    """Return a column's rows: those that say the same as before stay, and marks where nothing changes."""
    entries = dict(track.entries)
    if entries and min(entries) > 0:
        entries[0] = None
    rows = {frame: row for frame, row in before.items() if 0 <= frame < length_frames and _is_mark(_said(row))}
    for frame, cel in entries.items():
        old = before.get(frame, {})
        text = EMPTY_CEL if cel is None else cel
        is_same = _said(old) == text or (cel is not None and _is_cel(_said(old), cel))
        rows[frame] = old if is_same else {"frame": frame, "data": [{"id": 0, "values": [text]}]}
    return [rows[frame] for frame in sorted(rows)] if entries else []


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
