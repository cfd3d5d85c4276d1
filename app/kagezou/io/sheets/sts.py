"""ShiraheiTimeSheet (STS), read only: every frame's cel number, column by column.

Layout, as three independent readers agree: a length byte and the name of the format, the number of columns, the number
of frames (16 bits, little end first), two zero bytes; then for each column and frame a cel number of 16 bits, 0 for an
empty cel; then for each column a length byte and its name in Shift-JIS.
"""

from typing import Final

import numpy as np

from kagezou.errors import ProjectProblem
from kagezou.io.sheets.timesheet import SheetTrack, Timesheet
from kagezou.message import Message

_MAGIC: Final = b"\x11ShiraheiTimeSheet"
_HEAD_BYTES: Final = 23


def is_sts(data: bytes) -> bool:
    """Return whether data begins as an STS file does."""
    return data.startswith(_MAGIC)


def sts_sheet(data: bytes) -> Timesheet:
    """Return the timesheet that an STS file holds.

    Raises
    ------
    ProjectProblem
        It is cut off, or has no frames.
    """
    if len(data) < _HEAD_BYTES:
        raise ProjectProblem(Message("the STS timesheet is cut off"))
    columns, length = data[18], int.from_bytes(data[19:21], "little")
    end = _HEAD_BYTES + 2 * columns * length
    if not length:
        raise ProjectProblem(Message("the STS timesheet has no frames"))
    if len(data) < end:
        raise ProjectProblem(
            Message(
                "the STS timesheet is cut off: {columns} columns of {length} frames do not fit",
                columns=columns,
                length=length,
            )
        )
    cels = np.frombuffer(data, "<u2", columns * length, _HEAD_BYTES).reshape(columns, length)
    names = _names(data[end:], columns)
    return Timesheet("", length, tuple(SheetTrack(name, _entries(row)) for name, row in zip(names, cels, strict=True)))


def _entries(cels: np.ndarray[tuple[int], np.dtype[np.uint16]]) -> tuple[tuple[int, str | None], ...]:
    changes = np.flatnonzero(np.diff(cels)) + 1
    return tuple((int(frame), str(cels[frame]) if cels[frame] else None) for frame in (0, *changes))


def _names(rest: bytes, columns: int) -> list[str]:
    """Return the names of the columns; where they are cut off, columns have letters as on paper."""
    names = []
    for number in range(columns):
        size = rest[0] if rest else 0
        raw, rest = rest[1 : 1 + size], rest[1 + size :]
        name = raw.decode("shift_jis", "replace").strip("\0 ")
        names.append(name or chr(ord("A") + number % 26))
    return names
