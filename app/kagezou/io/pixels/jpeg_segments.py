"""What lies before the pixels of a JPEG file: whether it holds other pictures, and a gain map for bright screens."""

import struct
from pathlib import Path
from typing import Final

from kagezou.io.files.faults import input_problem
from kagezou.io.pixels.signatures import FORMATS
from kagezou.message import Message

_MOST_BYTES: Final = 1 << 20
_GAIN_MAPS: Final = (b"hdrgm:", b"GainMap", b"HDRGainMap", b"urn:iso:std:iso:ts:21496")
_PICTURES: Final = b"MPF\0"
_COUNT_TAG: Final = 0xB001
GAIN_MAP: Final = Message("its gain map for bright screens is not used: it is seen as on other screens")


def notes_on_jpeg(path: Path) -> tuple[Message, ...]:
    """Return what of the file at ``path`` is not used, nothing for other formats; raises InputProblem."""
    if FORMATS.get(path.suffix.lower()) != "jpeg":
        return ()
    try:
        with path.open("rb") as stream:
            data = stream.read(_MOST_BYTES)
    except OSError as error:
        raise input_problem(path, error) from error
    segments = _segments(data)
    if any(mark in body for body in segments for mark in _GAIN_MAPS):
        return (GAIN_MAP,)
    pictures = max((_pictures(body) for body in segments if body.startswith(_PICTURES)), default=1)
    return (Message("of its {count} pictures the first alone is used", count=pictures),) if pictures > 1 else ()


def _segments(data: bytes) -> list[bytes]:
    """Return the bodies of the segments that programs put in: APP1 and APP2."""
    found, at = [], 2
    while at + 4 <= len(data) and data[at] == 0xFF and data[at + 1] != 0xDA:
        length = int.from_bytes(data[at + 2 : at + 4])
        if data[at + 1] in {0xE1, 0xE2}:
            found.append(data[at + 4 : at + 2 + length])
        at += 2 + length
    return found


def _pictures(body: bytes) -> int:
    """Return how many pictures an index of several says that there are, as CIPA DC-007 has it."""
    order = ">" if body[4:6] == b"MM" else "<"
    try:
        (at,) = struct.unpack_from(f"{order}I", body, 8)
        (count,) = struct.unpack_from(f"{order}H", body, 4 + at)
        for index in range(count):
            tag, _, _, value = struct.unpack_from(f"{order}HHII", body, 6 + at + 12 * index)
            if tag == _COUNT_TAG:
                return min(int(value), 1000)
    except struct.error:
        pass
    return 1
