"""Digital timesheets (XDTS, as Clip Studio Paint and OpenToonz write them): when which cel is exposed.

Programs bend the specification, so whatever is not needed here is ignored: other columns, unknown keys, a missing
header, frames out of order and frames before the first one.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from kagezou.errors import ProjectProblem
from kagezou.io.faults import input_problem
from kagezou.io.project_json import Reader, parse

MAX_BYTES: Final = 32 << 20
_MAX_FRAMES: Final = 1_000_000
_MAX_COLUMNS: Final = 1000
_FIRST_LINE: Final = "exchangeDigitalTimeSheet Save Data"
_OTHER_FIRST_LINE: Final = "toeiDigitalTimeSheet Save Data"
_CELS: Final = 0
"""The field of cel columns; dialogue and camera work are others."""

_EMPTY: Final = "SYMBOL_NULL_CELL"
_SYMBOL: Final = "SYMBOL_"
"""Every other symbol is a mark on a cel that goes on: inbetween, reverse sheet, hyphen."""


@dataclass(frozen=True, slots=True)
class SheetTrack:
    """One cel column.

    Parameters
    ----------
    name
        As the sheet has it, trimmed; other columns may have the same.
    entries
        ``(frame, cel)`` in order, one a frame, the frame counted from 0: from there on this cel is seen, or none.
    """

    name: str
    entries: tuple[tuple[int, str | None], ...]


@dataclass(frozen=True, slots=True)
class Timesheet:
    """The first sheet of a file: its name, its length, its cel columns from the lowest to the topmost."""

    name: str
    length_frames: int
    tracks: tuple[SheetTrack, ...]


def read_xdts(path: Path) -> Timesheet:
    """Return the timesheet at ``path``.

    Raises
    ------
    InputProblem
        It cannot be read or is no XDTS file: one sentence with the place of what is wrong.
    """
    try:
        if path.exists() and not path.is_file():
            raise input_problem(path, "it is not a file")
        with path.open("rb") as stream:
            data = stream.read(MAX_BYTES + 1)
        if len(data) > MAX_BYTES:
            raise input_problem(path, f"it is larger than {MAX_BYTES >> 20} MB, which no timesheet is")
        return sheet_of(data.decode("utf-8-sig"))
    except OSError as error:
        raise input_problem(path, error) from error
    except UnicodeDecodeError as error:
        raise input_problem(path, "it is not UTF-8 text") from error
    except ProjectProblem as problem:
        raise input_problem(path, str(problem)) from problem
    except ValueError as error:  # a NUL in the name
        raise input_problem(path, "it cannot be a file name") from error


def sheet_of(text: str) -> Timesheet:
    """Return the timesheet that ``text`` holds.

    Raises
    ------
    ProjectProblem
        It is not one, with the JSON path of what is wrong.
    """
    first, _, rest = text.partition("\n")
    if first.strip() == _OTHER_FIRST_LINE:
        raise ProjectProblem("it is a TDTS timesheet; please export it as XDTS")
    if first.strip() != _FIRST_LINE:
        raise ProjectProblem("it is not an XDTS timesheet")
    tables = _member(Reader(parse(rest)), "timeTables").items(_MAX_COLUMNS, least=1)
    table = next(tables)
    length = _member(table, "duration").whole(1, _MAX_FRAMES)
    names = _names(table)
    columns = sorted(_columns(table), key=lambda column: column[0])
    tracks = tuple(
        SheetTrack(names[number] if number < len(names) else "", _entries(frames, length)) for number, frames in columns
    )
    return Timesheet(_text(table.members().get("name")), length, tracks)


def _member(reader: Reader, name: str) -> Reader:
    found = reader.members().get(name)
    if found is None:
        raise reader.problem(f"the key {name!r} is missing")
    return found


def _text(reader: Reader | None) -> str:
    """Return a text trimmed; some writers put numbers where texts belong."""
    if reader is None or isinstance(reader.value, (bool, dict, list, float)) or reader.value is None:
        return ""
    return str(reader.value).strip()


def _of_cels(table: Reader, key: str) -> Iterator[Reader]:
    """Yield the parts of a table that are about cel columns."""
    listed = table.members().get(key)
    for part in listed.items(_MAX_COLUMNS) if listed is not None else ():
        field = part.members().get("fieldId")
        if field is not None and field.value == _CELS:
            yield part


def _names(table: Reader) -> list[str]:
    for header in _of_cels(table, "timeTableHeaders"):
        return [_text(name) for name in _member(header, "names").items(_MAX_COLUMNS)]
    return []


def _columns(table: Reader) -> Iterator[tuple[int, Reader]]:
    for field in _of_cels(table, "fields"):
        for track in _member(field, "tracks").items(_MAX_COLUMNS):
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
