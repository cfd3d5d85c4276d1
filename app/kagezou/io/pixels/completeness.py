"""Whether a picture file is there to its end, told by its structure without decoding it.

Of formats that are not here the decoder looks at the length itself when it opens a file.
"""

import os
import struct
from collections.abc import Callable
from pathlib import Path
from typing import BinaryIO, Final

from kagezou.io.files.faults import input_problem
from kagezou.io.pixels.exr_chunks import ends_within
from kagezou.io.pixels.signatures import FORMATS
from kagezou.message import Message

_PNG_END: Final = b"\0\0\0\0IEND\xaeB`\x82"
_PNG_SIGNATURE_BYTES: Final = 8
_TGA_END: Final = b"TRUEVISION-XFILE.\0"
_JPEG_END: Final = b"\xff\xd9"
_JPEG_SCAN: Final = 0xDA
_BMP_PLAIN: Final = frozenset({0, 3, 6})
"""Compressions of BMP without any: as they are, and by masks."""


def check_end(path: Path) -> None:
    """Raise InputProblem where the picture file at ``path`` ends before its pixels do, or cannot be read."""
    check = _CHECKS.get(FORMATS.get(path.suffix.lower(), ""))
    if check is None:
        return
    try:
        with path.open("rb") as stream:
            ends = check(stream, os.fstat(stream.fileno()).st_size)
    except OSError as error:
        raise input_problem(path, error) from error
    except (struct.error, IndexError):
        ends = False
    if not ends:
        raise input_problem(path, Message("the file is cut short"))


def is_written_whole(path: Path) -> bool:
    """Return whether a picture file that was just written has all that its format ends with.

    More is asked than of a file to be read, which may lack what no reader needs: a writer puts it there, and where it
    is missing the last bytes never reached the disk. OSError where the file cannot be read.
    """
    check = {**_CHECKS, "targa": _tga_has_footer}.get(FORMATS.get(path.suffix.lower(), ""))
    with path.open("rb") as stream:
        try:
            return check is None or check(stream, os.fstat(stream.fileno()).st_size)
        except (struct.error, IndexError):
            return False


def _tga_has_footer(stream: BinaryIO, size: int) -> bool:
    stream.seek(max(size - len(_TGA_END), 0))
    return stream.read() == _TGA_END


def _png_ends(stream: BinaryIO, size: int) -> bool:
    stream.seek(max(size - len(_PNG_END), 0))
    if stream.read() == _PNG_END:
        return True
    at = _PNG_SIGNATURE_BYTES
    while True:
        stream.seek(at)
        length, name = struct.unpack(">I4s", stream.read(8))
        at += 12 + length
        if name == b"IEND" or at > size:
            return bool(at <= size)


def _jpeg_ends(stream: BinaryIO, size: int) -> bool:
    """Look for the end mark behind the first scan, whose data never hold one; a preview before it may."""
    stream.seek(max(size - len(_JPEG_END), 0))
    if stream.read() == _JPEG_END:
        return True
    stream.seek(0)
    data = stream.read()
    at = 2
    while data[at] == 0xFF:
        kind = data[at + 1]
        if kind == _JPEG_SCAN:
            return data.find(_JPEG_END, at) >= 0
        at += 1 if kind == 0xFF else 2 + int.from_bytes(data[at + 2 : at + 4])
    return True  # not as it should be: the decoder says more


def _bmp_ends(stream: BinaryIO, size: int) -> bool:
    head = stream.read(34)
    pixels_at, head_bytes = struct.unpack_from("<II", head, 10)
    if head_bytes < 40:
        return True
    width, height, _, bits, packing = struct.unpack_from("<iiHHI", head, 18)
    row = (abs(width) * bits + 31) // 32 * 4
    return packing not in _BMP_PLAIN or bool(pixels_at + row * abs(height) <= size)


def _gif_ends(stream: BinaryIO, _size: int) -> bool:
    """Walk through the blocks of the pictures; the mark behind them may be missing."""
    head = stream.read(13)
    stream.seek(3 << ((head[10] & 7) + 1) if head[10] & 0x80 else 0, 1)
    pictures = 0
    while True:
        kind = stream.read(1)
        if kind in {b"", b";"}:
            return pictures > 0
        if kind == b"!":
            stream.seek(1, 1)
        elif kind == b",":
            flags = stream.read(9)[8]
            stream.seek((3 << ((flags & 7) + 1) if flags & 0x80 else 0) + 1, 1)
            pictures += 1
        else:
            return True  # not as it should be: the decoder says more
        # What ends between two blocks may lack its marks alone.
        while (length := int.from_bytes(stream.read(1))) > 0:
            if len(stream.read(length)) < length:
                return False


_CHECKS: Final[dict[str, Callable[[BinaryIO, int], bool]]] = {
    "png": _png_ends,
    "jpeg": _jpeg_ends,
    "bmp": _bmp_ends,
    "gif": _gif_ends,
    "openexr": ends_within,
}
