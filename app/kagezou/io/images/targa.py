"""TGA files whose alpha lies in their palette or in the top bit of 16, which no decoder at hand gives.

Their header is changed in memory so that the stored numbers come out as gray, and palette and bits are taken apart
here.
"""

import struct
from dataclasses import replace
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from kagezou.io.files.faults import input_problem
from kagezou.io.images.header import Header
from kagezou.io.images.pillow_guard import PillowFile
from kagezou.message import Message

_HEADER: Final = struct.Struct("<BBBHHBHHHHBB")
_PALETTE: Final = 1
_COLOUR: Final = 2
_GRAY: Final = 3
_RLE: Final = 8
_ORIGIN: Final = 0x30
_ATTRIBUTE_BITS: Final = 0x0F


class TargaPicture:
    """A TGA file of that kind; ``header`` is that of its pixels as (H, W, 4).

    Raises
    ------
    InputProblem
        It cannot be read.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        data = path.read_bytes()
        self._head = _HEADER.unpack_from(data)
        ident, _, kind, first, count, bits, left, top, width, height, depth, descriptor = self._head
        colours_at = _HEADER.size + ident
        pixels_at = colours_at + count * ((bits + 7) // 8) * bool(self._head[1])
        self._colours, self._first, self._bits = data[colours_at:pixels_at], first, bits
        # Gray of 16 bits is gray and alpha, one byte each.
        stored = 16 if depth > 8 else 8
        gray = _HEADER.pack(
            0, 0, _GRAY | kind & _RLE, 0, 0, 0, left, top, width, height, stored, descriptor & _ORIGIN | stored - 8
        )
        self._file = PillowFile(path, gray + data[pixels_at:])
        self.header: Header = replace(
            self._file.header,
            format="targa",
            channels=4,
            colour=(0, 1, 2),
            alpha=3,
            alpha_declared=False,
            bit_depth=8 if depth == 8 or bits > 16 else 5,
        )

    def read(self) -> NDArray[Any]:
        """Return its pixels, (H, W, 4) ``uint8``; raises InputProblem."""
        stored = self._file.read(0)
        numbers = stored[..., 0] if stored.shape[2] == 1 else stored.view("<u2")[..., 0]
        if self._head[2] & ~_RLE == _COLOUR:
            return _taken_apart(numbers)
        palette = _palette(self._colours, self._bits)
        if int(numbers.min()) < self._first or int(numbers.max()) >= self._first + len(palette):
            raise input_problem(self._path, Message("the file is damaged (a colour is not in its palette)"))
        by_number = np.concatenate([np.zeros((self._first, 4), np.uint8), palette])
        found: NDArray[np.uint8] = by_number[numbers]
        return found


def is_needed(path: Path) -> bool:
    """Return whether the TGA file at ``path`` is of that kind; raises OSError."""
    with path.open("rb") as stream:
        start = stream.read(_HEADER.size)
    if len(start) < _HEADER.size:
        return False
    _, has_palette, kind, _, _, bits, *_, width, height, depth, descriptor = _HEADER.unpack(start)
    if not width or not height:
        return False
    attributes = descriptor & _ATTRIBUTE_BITS
    match kind & ~_RLE:
        case value if value == _PALETTE:
            return bool(has_palette == 1 and depth in {8, 16} and (bits == 32 or (bits == 16 and attributes > 0)))
        case value if value == _COLOUR:
            return bool(depth == 16 and attributes > 0)
        case _:
            return False


def _palette(data: bytes, bits: int) -> NDArray[np.uint8]:
    """Return the colours of a palette as RGBA, (N, 4)."""
    if bits == 32:
        stored = np.frombuffer(data[: len(data) // 4 * 4], np.uint8).reshape(-1, 4)
        return stored[:, [2, 1, 0, 3]]
    return _taken_apart(np.frombuffer(data[: len(data) // 2 * 2], "<u2").astype(np.uint16))


def _taken_apart(numbers: NDArray[np.uint16]) -> NDArray[np.uint8]:
    """Return numbers of any shape, in which the top bit is alpha and 5 each are red, green and blue, as (…, 4)."""
    found = np.empty((*numbers.shape, 4), np.uint8)
    for place, shift in enumerate((10, 5, 0)):
        five = ((numbers >> shift) & 31).astype(np.uint8)
        # As OpenImageIO widens them: the upper bits again as the lower ones.
        found[..., place] = five << 3 | five >> 2
    found[..., 3] = np.where(numbers >> 15, 255, 0)
    return found
