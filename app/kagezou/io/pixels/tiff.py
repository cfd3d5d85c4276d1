"""TIFF packed in memory: straight RGBA in deflated strips, the same bytes for the same picture."""

import struct
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from kagezou.io.pixels.deflating import packed_small

Pixels = NDArray[Any]
_STRIP_ROWS: Final = 64
_SHORT: Final = 3
_LONG: Final = 4
_FORMATS: Final = {_SHORT: "H", _LONG: "I"}
_HEADER: Final = struct.Struct("<2sHI")
_DEFLATE: Final = 8
_RGB: Final = 2
_STRAIGHT_ALPHA: Final = 2


def pack_rgba(rgba: Pixels) -> bytes:
    """Return a TIFF of straight sRGB (H, W, 4) ``uint8`` or ``uint16``, little-endian."""
    height, width = rgba.shape[:2]
    pixels = np.ascontiguousarray(rgba, rgba.dtype.newbyteorder("<"))
    strips = [packed_small(pixels[top : top + _STRIP_ROWS]) for top in range(0, height, _STRIP_ROWS)]
    sizes = [len(strip) for strip in strips]
    offsets = [_HEADER.size + sum(sizes[:index]) for index in range(len(sizes))]
    data = b"".join(strips)
    data += b"\0" * (len(data) % 2)
    tags = (
        (256, _LONG, [width]),
        (257, _LONG, [height]),
        (258, _SHORT, [rgba.dtype.itemsize * 8] * 4),
        (259, _SHORT, [_DEFLATE]),
        (262, _SHORT, [_RGB]),
        (273, _LONG, offsets),
        (277, _SHORT, [4]),
        (278, _LONG, [_STRIP_ROWS]),
        (279, _LONG, sizes),
        (284, _SHORT, [1]),
        (338, _SHORT, [_STRAIGHT_ALPHA]),
    )
    directory_at = _HEADER.size + len(data)
    return _HEADER.pack(b"II", 42, directory_at) + data + _directory(tags, directory_at)


def _directory(tags: tuple[tuple[int, int, list[int]], ...], at: int) -> bytes:
    """Return the directory that starts ``at`` this byte, with values too long for their entry behind it."""
    entries, behind = struct.pack("<H", len(tags)), b""
    behind_at = at + 2 + 12 * len(tags) + 4
    for tag, kind, values in tags:
        body = struct.pack(f"<{len(values)}{_FORMATS[kind]}", *values)
        if len(body) > 4:
            field = struct.pack("<I", behind_at + len(behind))
            behind += body
        else:
            field = body.ljust(4, b"\0")
        entries += struct.pack("<HHI", tag, kind, len(values)) + field
    return entries + struct.pack("<I", 0) + behind
