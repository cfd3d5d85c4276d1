"""PNG files that need no more than the fast decoder: 8-bit colours, and nothing in their chunks but what is known here.

Most drawings are such files, and for them OpenImageIO is not even loaded.
"""

import struct
from pathlib import Path
from typing import Final

from kagezou.io.files.faults import input_problem
from kagezou.io.images.fast_png import Pixels, fast_pixels
from kagezou.io.images.header import Header
from kagezou.io.images.picture_size import check_size
from kagezou.io.pixels.png_chunks import png_chunks
from kagezou.message import Message

_CHANNELS: Final = {2: 3, 6: 4}
_KNOWN: Final = frozenset({b"IHDR", b"cICP", b"sRGB", b"gAMA", b"cHRM", b"pHYs", b"tIME", b"bKGD", b"IDAT", b"IEND"})
"""Chunks that say nothing of the picture but what `png_chunks` tells."""

_SIGNATURE_BYTES: Final = 8
_HEAD_BYTES: Final = 13


class PlainPng:
    """An open picture whose file has been looked through; it has no pictures beside itself.

    Parameters
    ----------
    path
        A file whose chunks were found to be whole.
    header
        What it says.
    """

    def __init__(self, path: Path, header: Header) -> None:
        self._path = path
        self.header = header

    def used(self) -> Pixels:
        """Return the channels that are used, (H, W, C), all there are; raises InputProblem."""
        found = fast_pixels(self._path, self.header)
        if found is not None:
            return found
        from kagezou.io.images.oiio_guard import DecodedPicture

        with DecodedPicture(self._path) as picture:
            return picture.used()

    def alpha(self) -> Pixels:
        """Return the alpha alone, (H, W), where there is one; raises InputProblem."""
        assert self.header.alpha is not None
        return self.used()[..., self.header.alpha]

    def pictures(self) -> int:
        """Return one."""
        return 1


def plain_png(path: Path) -> PlainPng | None:
    """Return an open picture, or None where its file may hold more than is known here.

    Parameters
    ----------
    path
        A PNG file; its chunks must have been found to be whole where its pixels will be wanted.

    Raises
    ------
    InputProblem
        It cannot be read, or is too large.
    """
    try:
        names, head = _chunks(path)
        if not names <= _KNOWN or len(head) < _HEAD_BYTES:
            return None
        width, height, bits, kind = struct.unpack_from(">IIBB", head)
        if bits != 8 or kind not in _CHANNELS:
            return None
        change = png_chunks(path).colour_change()
    except OSError as error:
        raise input_problem(path, error) from error
    channels = _CHANNELS[kind]
    header = Header(
        format="png",
        data=(0, 0, width, height),
        display=(0, 0, width, height),
        channels=channels,
        colour=(0, 1, 2),
        alpha=3 if channels == 4 else None,
        dtype="uint8",
        bit_depth=8,
        change=None if isinstance(change, Message) else change,
        notes=(change,) if isinstance(change, Message) else (),
    )
    check_size(path, header)
    return PlainPng(path, header)


def _chunks(path: Path) -> tuple[set[bytes], bytes]:
    """Return the names of the chunks of a file, and the body of its first."""
    names: set[bytes] = set()
    head = b""
    with path.open("rb") as stream:
        stream.seek(_SIGNATURE_BYTES)
        while len(start := stream.read(8)) == 8:
            length, name = struct.unpack(">I4s", start)
            names.add(name)
            if name == b"IHDR":
                head = stream.read(min(length, _HEAD_BYTES))
                length -= len(head)
            stream.seek(length + 4, 1)
            if name == b"IEND":
                break
    return names, head
