"""The heads of PLY files: which elements follow, with which properties, as text or as bytes in which order."""

from dataclasses import dataclass
from pathlib import Path
from typing import Final

import numpy as np

from kagezou.io.files.faults import input_problem
from kagezou.message import Message

_KINDS: Final = {
    "char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4", "float": "f4",
    "double": "f8", "int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2", "int32": "i4", "uint32": "u4",
    "int64": "i8", "uint64": "u8", "float32": "f4", "float64": "f8",
}  # fmt: skip
_ORDERS: Final = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}
_MAX_BYTES: Final = 1 << 20


@dataclass(frozen=True, slots=True)
class Property:
    """A property of an element: its name, the kind of its numbers, and that of its length where it is a list."""

    name: str
    kind: np.dtype
    length: np.dtype | None = None


@dataclass(frozen=True, slots=True)
class Element:
    """So many rows of the same properties."""

    name: str
    count: int
    properties: tuple[Property, ...]


@dataclass(frozen=True, slots=True)
class PlyHead:
    """What a head says; the elements follow from the byte ``end`` on.

    Parameters
    ----------
    is_text
        Whether the numbers are written out; they are then looked at as float64, whatever their kinds.
    """

    is_text: bool
    elements: tuple[Element, ...]
    end: int


def ply_head(path: Path, data: bytes) -> PlyHead:
    """Read the head of a file.

    Raises
    ------
    InputProblem
        It is not one of a PLY file.
    """
    try:
        lines, end = _lines(data)
        return _head(lines, end)
    except (ValueError, KeyError, IndexError) as error:
        raise input_problem(
            path, Message("it cannot be read as a set: the file is damaged or not what its name says")
        ) from error


def _lines(data: bytes) -> tuple[list[list[str]], int]:
    """Return the words of the lines of a head, and where it ends."""
    start = data.find(b"ply", 0, 8)
    found = data.find(b"end_header", 0, _MAX_BYTES)
    if start < 0 or found < 0:
        raise ValueError(start, found)
    end = found + len(b"end_header")
    while data[end : end + 1] in (b" ", b"\t"):
        end += 1
    end += 2 if data[end : end + 2] == b"\r\n" else 1
    text = data[start:found].decode("utf-8", "replace")
    return [words for line in text.splitlines() if (words := line.split())], end


def _head(lines: list[list[str]], end: int) -> PlyHead:
    order: str | None = None
    elements: list[Element] = []
    for words in lines:
        if words[0] == "format":
            order = _ORDERS[words[1]]
        elif words[0] == "element":
            elements.append(Element(words[1], int(words[2]), ()))
        elif words[0] == "property":
            last = elements.pop()
            made = _property(words, order or "")
            elements.append(Element(last.name, last.count, (*last.properties, made)))
    if order is None or any(each.count < 0 for each in elements):
        raise ValueError(lines)
    return PlyHead(not order, tuple(elements), end)


def _property(words: list[str], order: str) -> Property:
    def kind(name: str) -> np.dtype:
        written = order + _KINDS[name]
        return np.dtype(written if order else "f8")

    if words[1] == "list":
        return Property(words[4], kind(words[3]), kind(words[2]))
    return Property(words[2], kind(words[1]))
