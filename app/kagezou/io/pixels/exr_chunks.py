"""Where the pixels of an OpenEXR file lie, by the table behind its header."""

import struct
from dataclasses import dataclass, field
from typing import BinaryIO, Final

import numpy as np

_MOST_CHUNKS: Final = 1 << 20
_MOST_ATTRIBUTES: Final = 1000
_TILED: Final = 0x200
_DEEP: Final = 0x800
_PARTS: Final = 0x1000
_ROWS: Final = (1, 1, 1, 16, 32, 16, 32, 32, 32, 256)
"""Rows of a chunk, by the number of the compression."""


@dataclass(slots=True)
class _Part:
    values: dict[bytes, bytes] = field(default_factory=dict)

    def chunks(self, *, is_tiled: bool) -> int | None:
        """Return how many chunks it has, None where that takes more than a look."""
        if b"chunkCount" in self.values:
            return int(struct.unpack("<i", self.values[b"chunkCount"])[0])
        left, top, right, bottom = struct.unpack("<4i", self.values[b"dataWindow"])
        if is_tiled:
            across, down, mode = struct.unpack("<IIB", self.values[b"tiles"])
            if mode & 15:
                return None
            return int(-(-(right - left + 1) // max(across, 1)) * -(-(bottom - top + 1) // max(down, 1)))
        rows = _ROWS[self.values[b"compression"][0]]
        return int(-(-(bottom - top + 1) // rows))


def ends_within(stream: BinaryIO, size: int) -> bool:
    """Return whether every chunk of pixels that the table names begins in the file, and the last one ends in it.

    Raises
    ------
    struct.error, IndexError
        The header ends too early.
    """
    (flags,) = struct.unpack("<4xI", stream.read(8))
    try:
        parts = _parts(stream, has_several=bool(flags & _PARTS))
        counts = [part.chunks(is_tiled=bool(flags & _TILED)) for part in parts]
    except KeyError:
        return True  # not as it should be: the decoder says more
    known = [count for count in counts if count is not None]
    if len(known) < len(counts) or not 0 < sum(known) <= _MOST_CHUNKS or min(known) < 0:
        return True
    table = stream.read(8 * sum(known))
    if len(table) < 8 * sum(known):
        return False
    offsets = np.frombuffer(table, "<u8")
    if int(offsets.min()) == 0 or int(offsets.max()) >= size:
        return False
    # Deep chunks are larger than they say here, so that less is asked of them.
    head = 4 * bool(flags & _PARTS) + (16 if flags & _TILED else 4)
    stream.seek(int(offsets.max()) + head)
    (length,) = struct.unpack("<i", stream.read(4))
    if flags & _DEEP or any(b"tiles" in part.values for part in parts) != bool(flags & _TILED):
        return True
    return int(offsets.max()) + head + 4 + max(int(length), 0) <= size


def _parts(stream: BinaryIO, *, has_several: bool) -> list[_Part]:
    parts: list[_Part] = []
    while True:
        part = _Part()
        for _ in range(_MOST_ATTRIBUTES):
            name = _text(stream)
            if not name:
                break
            _text(stream)
            (length,) = struct.unpack("<I", stream.read(4))
            part.values[name] = stream.read(length) if length < 1 << 16 else b""
            if length >= 1 << 16:
                stream.seek(length, 1)
        if not part.values:
            return parts
        parts.append(part)
        if not has_several:
            return parts


def _text(stream: BinaryIO) -> bytes:
    found = bytearray()
    while (each := stream.read(1)) != b"\0" and len(found) < 256:
        if not each:
            raise IndexError
        found += each
    return bytes(found)
