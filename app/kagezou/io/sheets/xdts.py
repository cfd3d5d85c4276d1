"""Digital timesheets (XDTS, as Clip Studio Paint and OpenToonz write them; TDTS read only): when which cel is exposed.

Programs bend the specification, so whatever is not needed here is ignored: other columns, unknown keys, a missing
header, frames out of order and frames before the first one.
"""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Final

from kagezou.errors import ProjectProblem
from kagezou.io.files.atomic import write_bytes
from kagezou.io.files.faults import input_problem
from kagezou.io.files.json_text import Reader, parse
from kagezou.io.sheets.sts import is_sts, sts_sheet
from kagezou.io.sheets.timesheet import SheetTrack, Timesheet
from kagezou.message import Message

MAX_BYTES: Final = 32 << 20
_MAX_FRAMES: Final = 1_000_000
_MAX_COLUMNS: Final = 1000
_FIRST_LINE: Final = "exchangeDigitalTimeSheet Save Data"
_OTHER_FIRST_LINE: Final = "toeiDigitalTimeSheet Save Data"
_CELS: Final = 0
"""The field of cel columns; dialogue and camera work are others."""

_CELS_OF_TDTS: Final = 4
"""There the field 0 is for key drawings."""

_VERSION: Final = 5

_EMPTY: Final = "SYMBOL_NULL_CELL"
_SYMBOL: Final = "SYMBOL_"
"""Every other symbol is a mark on a cel that goes on: inbetween, reverse sheet, hyphen."""


def read_timesheet(path: Path) -> Timesheet:
    """Return the timesheet at ``path``: XDTS, TDTS or STS, told apart by what is in it.

    Raises
    ------
    InputProblem
        It cannot be read or is no timesheet: one sentence with the place of what is wrong.
    """
    try:
        if path.exists() and not path.is_file():
            raise input_problem(path, Message("it is not a file"))
        with path.open("rb") as stream:
            data = stream.read(MAX_BYTES + 1)
        if len(data) > MAX_BYTES:
            raise input_problem(
                path, Message("it is larger than {megabytes} MB, too large for a timesheet", megabytes=MAX_BYTES >> 20)
            )
        return sts_sheet(data) if is_sts(data) else sheet_of(data.decode("utf-8-sig"))
    except OSError as error:
        raise input_problem(path, error) from error
    except UnicodeDecodeError as error:
        raise input_problem(path, Message("it is not UTF-8 text")) from error
    except ProjectProblem as problem:
        raise input_problem(path, problem.message) from problem
    except ValueError as error:  # a NUL in the name
        raise input_problem(path, Message("it cannot be a file name")) from error


def sheet_of(text: str) -> Timesheet:
    """Return the timesheet that ``text`` holds.

    Raises
    ------
    ProjectProblem
        It is not one, with the JSON path of what is wrong.
    """
    first, _, rest = text.partition("\n")
    if first.strip() not in (_FIRST_LINE, _OTHER_FIRST_LINE):
        raise ProjectProblem(Message("it is not a timesheet (XDTS, TDTS or STS)"))
    is_tdts = first.strip() == _OTHER_FIRST_LINE
    table = _table(Reader(parse(rest)))
    field = _CELS_OF_TDTS if is_tdts and any(_columns(table, _CELS_OF_TDTS)) else _CELS
    length = _member(table, "duration").whole(1, _MAX_FRAMES)
    names = _names(table, field)
    columns = sorted(_columns(table, field), key=lambda column: column[0])
    tracks = tuple(
        SheetTrack(names[number] if number < len(names) else "", _entries(frames, length)) for number, frames in columns
    )
    return Timesheet(_text(table.members().get("name")), length, tracks)


def _table(root: Reader) -> Reader:
    """Return the first table; TDTS has sheets around its tables, but for its oldest writers."""
    if "timeSheets" in root.members():
        root = next(_member(root, "timeSheets").items(_MAX_COLUMNS, least=1))
    return next(_member(root, "timeTables").items(_MAX_COLUMNS, least=1))


def _member(reader: Reader, name: str) -> Reader:
    found = reader.members().get(name)
    if found is None:
        raise reader.problem(Message("the key {name!r} is missing", name=name))
    return found


def _text(reader: Reader | None) -> str:
    """Return a text trimmed; some writers put numbers where texts belong."""
    if reader is None or isinstance(reader.value, (bool, dict, list, float)) or reader.value is None:
        return ""
    return str(reader.value).strip()


def _of_cels(table: Reader, key: str, wanted: int) -> Iterator[Reader]:
    """Yield the parts of a table that are about cel columns."""
    listed = table.members().get(key)
    for part in listed.items(_MAX_COLUMNS) if listed is not None else ():
        field = part.members().get("fieldId")
        if field is not None and field.value == wanted:
            yield part


def _names(table: Reader, field: int) -> list[str]:
    for header in _of_cels(table, "timeTableHeaders", field):
        return [_text(name) for name in _member(header, "names").items(_MAX_COLUMNS)]
    return []


def _columns(table: Reader, field: int) -> Iterator[tuple[int, Reader]]:
    for part in _of_cels(table, "fields", field):
        for track in _member(part, "tracks").items(_MAX_COLUMNS):
            number = _member(track, "trackNo").whole(0, _MAX_COLUMNS)
            yield number, _member(track, "frames")


def _entries(frames: Reader, length: int) -> tuple[tuple[int, str | None], ...]:
    """Return what is seen from which frame on; the last entry before the first frame is what the sheet begins with."""
    seen: dict[int, str | None] = {}
    early: tuple[int, str | None] | None = None
    for row in frames.items(_MAX_FRAMES):
        frame = _member(row, "frame").whole(-_MAX_FRAMES, _MAX_FRAMES)
        cel = _cel(row)
        if cel == "":
            continue
        if frame < 0:
            early = (frame, cel or None) if early is None or frame >= early[0] else early
        elif frame < length:
            seen[frame] = cel or None
    if early is not None:
        seen.setdefault(0, early[1])
    return tuple(sorted(seen.items(), key=lambda entry: entry[0]))


def _cel(row: Reader) -> str | None:
    """Return the cel of a row, None for an empty one, or an empty text where the cel before goes on."""
    data = row.members().get("data")
    for item in data.items(_MAX_COLUMNS) if data is not None else ():
        values = item.members().get("values")
        for value in values.items(_MAX_COLUMNS) if values is not None else ():
            text = _text(value)
            if text == _EMPTY:
                return None
            return "" if text.startswith(_SYMBOL) else text
    return ""


def xdts_text(sheet: Timesheet) -> str:
    """Return a timesheet as the text of an XDTS file, as OpenToonz writes it.

    A column that does not begin on the first frame begins with an empty cel; columns without a name have an empty one,
    so that the others keep their places.
    """
    tracks = []
    for number, track in enumerate(sheet.tracks):
        entries = track.entries
        if entries and entries[0][0] > 0:
            entries = ((0, None), *entries)
        if entries:
            frames = [
                {"frame": frame, "data": [{"id": 0, "values": [_EMPTY if cel is None else cel]}]}
                for frame, cel in entries
            ]
            tracks.append({"trackNo": number, "frames": frames})
    table = {
        "name": sheet.name,
        "duration": sheet.length_frames,
        "timeTableHeaders": [{"fieldId": _CELS, "names": [track.name for track in sheet.tracks]}],
        "fields": [{"fieldId": _CELS, "tracks": tracks}],
    }
    tree = {"header": {"cut": "1", "scene": "1"}, "timeTables": [table], "version": _VERSION}
    return f"{_FIRST_LINE}\n{json.dumps(tree, ensure_ascii=False, indent=1)}\n"


def write_xdts(path: Path, sheet: Timesheet) -> None:
    """Write a timesheet as XDTS, as a whole or not at all.

    Raises
    ------
    DiskFullProblem, OutputProblem
        It cannot be written.
    """
    # Names of files may hold what no UTF-8 text can.
    write_bytes(path, xdts_text(sheet).encode("utf-8", "replace"))
