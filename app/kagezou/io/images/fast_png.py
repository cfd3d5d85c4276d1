"""The one door to kornia-rs, which decodes 8-bit PNG in colours in a sixth of the time of OpenImageIO.

It sees only files whose chunks have the right checksums, and does not look at the checksum of the packed pixels, so
that is asked for here. Whatever it does not read or refuses is for OpenImageIO to read, or to say what is wrong.
"""

import struct
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Final

import kornia_rs
import numpy as np
from numpy.typing import NDArray
from zlib_ng import zlib_ng

from kagezou.io.images.header import Header

Pixels = NDArray[Any]
_CHANNELS: Final = {2: 3, 6: 4}
"""Of the kinds of PNG that are read: colours, and colours with alpha."""

_MODES: Final = {3: "rgb", 4: "rgba"}
_MOST_PIXELS: Final = 1 << 24
"""It lets no other thread of Python go on meanwhile, so that a picture must not take long."""

_MOST_BYTES: Final = 64 << 20
_NOT_UNPACKED: Final[type[Exception]] = zlib_ng.error  # type: ignore[assignment]  # stubbed as an instance
_SIGNATURE_BYTES: Final = 8
_DEPTH_AT, _KIND_AT = 24, 25
_IN_BYTES, _OUT_BYTES = 1 << 13, 1 << 16
"""What is unpacked at a time: so little that it stays in the processor's cache."""


def fast_pixels(path: Path, header: Header) -> Pixels | None:
    """Return all stored pixels of a picture, (H, W, C) ``uint8``, or None where they are to be had otherwise alone.

    Parameters
    ----------
    path
        A file whose chunks were found to be whole.
    header
        What it says.
    """
    width, height = header.data[2:]
    if header.format != "png" or header.channels not in _MODES or width * height > _MOST_PIXELS:
        return None
    try:
        if path.stat().st_size > _MOST_BYTES:
            return None
        data = path.read_bytes()
    except OSError:
        return None
    if data[_DEPTH_AT] != 8 or _CHANNELS.get(data[_KIND_AT]) != header.channels or not _is_unpacked_whole(data):
        return None
    try:
        pixels = kornia_rs.io.decode_image_png_u8(data, (height, width), _MODES[header.channels])
    except Exception:  # it has no kinds of errors
        return None
    found = np.asarray(pixels)
    return found if found.shape == (height, width, header.channels) and found.dtype == np.uint8 else None


def _is_unpacked_whole(data: bytes) -> bool:
    """Return whether the packed pixels come to their end with the right checksum."""
    unpacker = zlib_ng.decompressobj()
    try:
        for packed in _packed_pieces(data):
            rest: bytes | memoryview = packed
            while rest and not unpacker.eof:
                unpacker.decompress(rest, _OUT_BYTES)
                rest = unpacker.unconsumed_tail
        # What is given back in pieces may be known already when all has been taken in.
        while not unpacker.eof and unpacker.decompress(b"", _OUT_BYTES):
            pass
    except _NOT_UNPACKED:
        return False
    return bool(unpacker.eof)


def _packed_pieces(data: bytes) -> Iterator[memoryview]:
    """Yield the packed pixels of a PNG file in pieces."""
    view, at = memoryview(data), _SIGNATURE_BYTES
    while at + 8 <= len(data):
        length, kind = struct.unpack_from(">I4s", data, at)
        if kind == b"IDAT":
            body = view[at + 8 : at + 8 + length]
            for first in range(0, length, _IN_BYTES):
                yield body[first : first + _IN_BYTES]
        at += 12 + length
