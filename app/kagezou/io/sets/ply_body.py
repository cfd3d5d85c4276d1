"""The rows of PLY files: numbers, and lists of which each row may have its own length."""

import struct
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from kagezou.io.sets.ply_head import Element, Property

SHAPELESS: Final = (ValueError, KeyError, IndexError, TypeError, OverflowError, struct.error, DeprecationWarning)
"""How rows show that they are not what a head says."""

_CODES: Final = {"i1": "b", "u1": "B", "i2": "h", "u2": "H", "i4": "i", "u4": "I", "i8": "q", "u8": "Q",
                "f4": "f", "f8": "d"}  # fmt: skip
_PIECE: Final = 1 << 18


@dataclass(frozen=True, slots=True, eq=False)
class Lists:
    """Lists of numbers: how long each is (F,), and the numbers of all (C,)."""

    counts: NDArray[np.int64]
    numbers: NDArray[Any]

    @staticmethod
    def none() -> "Lists":
        """Return no list at all."""
        return Lists(np.zeros(0, np.int64), np.zeros(0, np.int64))


@dataclass(slots=True)
class PlyBody:
    """The bytes behind a head, read element by element in their order."""

    data: bytes
    at: int = 0

    def columns(self, element: Element) -> dict[str, Any]:
        """Return the properties of the next element by name: arrays (F,) of numbers, or `Lists`.

        Raises
        ------
        Exception
            One of `SHAPELESS`: the rows are not what the element says.
        """
        least = sum((prop.length or prop.kind).itemsize for prop in element.properties)
        if least * element.count > len(self.data) - self.at:
            raise ValueError(element)
        if not least or not element.count:
            return {prop.name: np.zeros(0) if prop.length is None else Lists.none() for prop in element.properties}
        alike = self._rows_alike(element)
        return self._rows_unlike(element) if alike is None else alike

    def _rows_alike(self, element: Element) -> dict[str, Any] | None:
        """Return rows of which every list is as long as in the first; None for others."""
        fields: list[tuple[Any, ...]] = []
        at = self.at
        for place, prop in enumerate(element.properties):
            if prop.length is None:
                fields.append((str(place), prop.kind))
            else:
                size = self._length(prop, at)
                fields += [(f"of {place}", prop.length), (str(place), prop.kind, (size,))]
            at = self.at + np.dtype(fields).itemsize
            if at > len(self.data):
                raise ValueError(element)
        kind = np.dtype(fields)
        if self.at + kind.itemsize * element.count > len(self.data):
            return None
        rows = np.frombuffer(self.data, kind, element.count, self.at)
        made: dict[str, Any] = {}
        for place, prop in enumerate(element.properties):
            numbers = rows[str(place)]
            if prop.length is None:
                made[prop.name] = numbers
                continue
            if (rows[f"of {place}"] != numbers.shape[1]).any():
                return None
            made[prop.name] = Lists(np.full(len(rows), numbers.shape[1], np.int64), numbers.reshape(-1))
        self.at += rows.nbytes
        return made

    def _rows_unlike(self, element: Element) -> dict[str, Any]:
        starts = np.empty((len(element.properties), element.count), np.int64)
        counts = np.ones_like(starts)
        at = self.at
        for row in range(element.count):
            for place, prop in enumerate(element.properties):
                if prop.length is not None:
                    counts[place, row] = size = self._length(prop, at)
                    at += prop.length.itemsize
                else:
                    size = 1
                starts[place, row] = at
                at += size * prop.kind.itemsize
        if at > len(self.data):
            raise ValueError(element)
        self.at = at
        made: dict[str, Any] = {}
        for place, prop in enumerate(element.properties):
            numbers = self._gathered(prop, starts[place], counts[place])
            made[prop.name] = numbers if prop.length is None else Lists(counts[place], numbers)
        return made

    def _length(self, prop: Property, at: int) -> int:
        kind = "|u1" if prop.length is None else prop.length.str
        (size,) = struct.unpack_from(kind[0].replace("|", "=") + _CODES[kind[1:]], self.data, at)
        if size != int(size) or not 0 <= size <= len(self.data):
            raise ValueError(size)
        return int(size)

    def _gathered(self, prop: Property, starts: NDArray[np.int64], counts: NDArray[np.int64]) -> NDArray[Any]:
        """Return all numbers of rows that begin at these bytes and are so long."""
        whole = np.frombuffer(self.data, np.uint8)
        width = prop.kind.itemsize
        made = [np.zeros(0, prop.kind)]
        for first in range(0, len(starts), _PIECE):
            own = counts[first : first + _PIECE]
            before = np.cumsum(own) - own
            at = np.repeat(starts[first : first + _PIECE] - before * width, own) + np.arange(own.sum()) * width
            made.append(whole[at[:, np.newaxis] + np.arange(width)].view(prop.kind)[:, 0])
        return np.concatenate(made)
