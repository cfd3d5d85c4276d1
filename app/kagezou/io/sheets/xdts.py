"""Digital timesheets (XDTS, as Clip Studio Paint and OpenToonz write them; TDTS read only): when which cel is exposed.

Programs bend the specification, so whatever is not needed here is passed over: other columns, unknown keys, a missing
header, a missing line break, frames out of order and frames before the first one. What of it could have mattered is
said.
"""

import json
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import Final

from kagezou.errors import ProjectProblem
from kagezou.io.files.json_text import Reader
from kagezou.io.sheets.sheet_text import json_in
from kagezou.io.sheets.timesheet import SheetTrack, Timesheet
from kagezou.io.sheets.xdts_marks import CAMERA_WORK, DIALOGUE, marks_of
from kagezou.io.sheets.xdts_values import MAX_COLUMNS, MAX_FRAMES, SYMBOL, member, text_of_value, texts_of, whole
from kagezou.message import Message

MAX_KEPT_CHARACTERS: Final = 1 << 20
FIRST_LINE: Final = "exchangeDigitalTimeSheet Save Data"
_OTHER_FIRST_LINE: Final = "toeiDigitalTimeSheet Save Data"
TABLES: Final = "timeTables"
_SHEETS: Final = "timeSheets"

CELS: Final = 0
"""The field of cel columns; dialogue and camera work are others."""

CELS_OF_TDTS: Final = 4
"""There the field 0 is for key drawings."""

_KEY_DRAWINGS: Final = Message("its columns of key drawings are not used")

EMPTY_CEL: Final = "SYMBOL_NULL_CELL"
_MARKS: Final = ("SYMBOL_TICK_1", "SYMBOL_TICK_2")
_HYPHEN: Final = "SYMBOL_HYPHEN"


@dataclass(slots=True)
class _Unused:
    """Counts of what a table has and this program does not use."""

    counts: Counter[str] = field(default_factory=Counter)

    def notes(self) -> list[Message]:
        """Return what is to be said of them."""
        counts = self.counts
        known = {
            "marks": Message(
                "marks of inbetweens and reverse sheets (○ ●) are not used: {count}", count=counts["marks"]
            ),
            "unknown": Message("marks of a kind not known here are passed over: {count}", count=counts["unknown"]),
            "several": Message("of several cels on one frame the first counts: {count} times", count=counts["several"]),
            "behind": Message("what lies behind its last frame is not used: {count} entries", count=counts["behind"]),
        }
        return [note for name, note in known.items() if counts[name]]


def sheets_of(text: str) -> tuple[Timesheet, ...]:
    """Return all timesheets that ``text`` holds, at least one.

    Raises
    ------
    ProjectProblem
        It is none, with the JSON path of what is wrong.
    """
    rest, is_tdts, notes = _behind_first_line(text)
    tree, more = json_in(rest)
    root = Reader(tree)
    if notes and not {TABLES, _SHEETS} & set(tree if isinstance(tree, dict) else ()):
        raise _no_sheet()
    found = ((owner, table, _sheet(table, is_tdts=is_tdts, notes=(*notes, *more))) for owner, table in _tables(root))
    return tuple(_with_kept(sheet, owner, table) for owner, table, sheet in found)


def _with_kept(sheet: Timesheet, owner: Reader, table: Reader) -> Timesheet:
    """Return a sheet with what the file says of it, unless that is too much to be kept."""
    scene, cut = numbers_of(owner.value)
    sheet = replace(sheet, scene=scene, cut=cut)
    own = {name: reader.value for name, reader in owner.members().items() if name != TABLES}
    text = json.dumps({**own, TABLES: [table.value]}, ensure_ascii=False, separators=(",", ":"))
    if len(text) > MAX_KEPT_CHARACTERS:
        note = Message("it is too large for what is not used of it to be kept for writing")
        return replace(sheet, notes=(*sheet.notes, note))
    return replace(sheet, kept=text)


def numbers_of(sheet: object) -> tuple[str, str]:
    """Return the scene and the cut that stand in the head of a sheet, as texts; empty where nothing does."""
    header = sheet.get("header") if isinstance(sheet, dict) else None
    known = header if isinstance(header, dict) else {}
    scene, cut = (text_of_value(Reader(known.get(key), key)) for key in ("scene", "cut"))
    return scene, cut


def _behind_first_line(text: str) -> tuple[str, bool, tuple[Message, ...]]:
    """Return what follows the line that names the format, whether it is TDTS, and what is to be said."""
    whole = text.lstrip("\ufeff \t\r\n")
    for line in (FIRST_LINE, _OTHER_FIRST_LINE):
        if whole[: len(line)].casefold() == line.casefold():
            return whole[len(line) :], line == _OTHER_FIRST_LINE, ()
    if not whole.startswith("{"):
        raise _no_sheet()
    return whole, f'"{_SHEETS}"' in whole, (Message("the line that names its format is missing"),)


def _no_sheet() -> ProjectProblem:
    return ProjectProblem(Message("it is not a timesheet (XDTS, TDTS or STS)"))


def _tables(root: Reader) -> Iterator[tuple[Reader, Reader]]:
    """Yield all tables, each with what it lies in; TDTS has sheets around its tables, but for its oldest writers."""
    sheets = [root]
    if _SHEETS in root.members():
        sheets = list(member(root, _SHEETS).items(MAX_COLUMNS, least=1))
    for sheet in sheets:
        yield from ((sheet, table) for table in member(sheet, TABLES).items(MAX_COLUMNS, least=1))


def _sheet(table: Reader, *, is_tdts: bool, notes: tuple[Message, ...]) -> Timesheet:
    wanted = CELS_OF_TDTS if is_tdts and any(_columns(table, CELS_OF_TDTS)) else CELS
    names = _names(table, wanted)
    columns = sorted(_columns(table, wanted), key=lambda column: column[0])
    unused = _Unused()
    duration = table.members().get("duration")
    length = _length(columns) if duration is None else whole(duration, 1, MAX_FRAMES)
    guessed = () if duration else (Message("its length is missing; it ends with its last entry"),)
    tracks = tuple(
        SheetTrack(names[number] if number < len(names) else "", _entries(frames, length, unused))
        for number, frames in columns
    )
    marks, unread = marks_of(table, length)
    said = (*notes, *guessed, *unread, *_other_fields(table, wanted), *unused.notes())
    return Timesheet(text_of_value(table.members().get("name")), length, tracks, said, marks=marks)


def _length(columns: list[tuple[int, Reader]]) -> int:
    """Return the length of a sheet that does not say it: up to the last entry of a column."""
    rows = (row for _, frames in columns for row in frames.items(MAX_FRAMES))
    return max((whole(member(row, "frame"), -MAX_FRAMES, MAX_FRAMES - 1) + 1 for row in rows), default=1)


def _other_fields(table: Reader, wanted: int) -> list[Message]:
    """Return what is said of columns that are about something else and hold something."""
    listed = table.members().get("fields")
    found: dict[Message, None] = {}
    for part in listed.items(MAX_COLUMNS) if listed is not None else ():
        kind = part.members().get("fieldId")
        if kind is None or kind.value in (wanted, DIALOGUE, CAMERA_WORK) or not _holds_something(part):
            continue
        number = kind.value if isinstance(kind.value, int) else None
        unknown = Message("its columns of the kind {kind} are not used", kind=kind.value)
        found[_KEY_DRAWINGS if number == CELS else unknown] = None
    return list(found)


def _holds_something(part: Reader) -> bool:
    tracks = part.members().get("tracks")
    rows = tracks.value if tracks is not None else None
    return isinstance(rows, list) and any(isinstance(track, dict) and track.get("frames") for track in rows)


def _of_cels(table: Reader, key: str, wanted: int) -> Iterator[Reader]:
    """Yield the parts of a table that are about cel columns."""
    listed = table.members().get(key)
    for part in listed.items(MAX_COLUMNS) if listed is not None else ():
        kind = part.members().get("fieldId")
        if kind is not None and kind.value == wanted:
            yield part


def _names(table: Reader, wanted: int) -> list[str]:
    for header in _of_cels(table, "timeTableHeaders", wanted):
        return [text_of_value(name) for name in member(header, "names").items(MAX_COLUMNS)]
    return []


def _columns(table: Reader, wanted: int) -> Iterator[tuple[int, Reader]]:
    for part in _of_cels(table, "fields", wanted):
        for track in member(part, "tracks").items(MAX_COLUMNS):
            number = whole(member(track, "trackNo"), 0, MAX_COLUMNS)
            yield number, member(track, "frames")


def _entries(frames: Reader, length: int, unused: _Unused) -> tuple[tuple[int, str | None], ...]:
    """Return what is seen from which frame on; the last entry before the first frame is what the sheet begins with."""
    seen: dict[int, str | None] = {}
    early: tuple[int, str | None] | None = None
    for row in frames.items(MAX_FRAMES):
        frame = whole(member(row, "frame"), -MAX_FRAMES, MAX_FRAMES)
        cel = _cel(row, unused)
        if cel == "":
            continue
        if frame < 0:
            early = (frame, cel or None) if early is None or frame >= early[0] else early
        elif frame < length:
            seen[frame] = cel or None
        elif cel is not None:
            unused.counts["behind"] += 1
    if early is not None:
        seen.setdefault(0, early[1])
    return tuple(sorted(seen.items(), key=lambda entry: entry[0]))


def _cel(row: Reader, unused: _Unused) -> str | None:
    """Return the cel of a row, None for an empty one, or an empty text where the cel before goes on."""
    texts = texts_of(row)
    unused.counts["marks"] += sum(text in _MARKS for text in texts)
    known = (EMPTY_CEL, _HYPHEN, *_MARKS)
    unused.counts["unknown"] += sum(text.startswith(SYMBOL) and text not in known for text in texts)
    unused.counts["several"] += sum(bool(text) and not text.startswith(SYMBOL) for text in texts) > 1
    if not texts or texts[0] == EMPTY_CEL:
        return None if texts else ""
    return "" if texts[0].startswith(SYMBOL) else texts[0]
