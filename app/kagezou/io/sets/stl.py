"""STL files, as text and as bytes; every triangle has its own corners."""

import re
import struct
from array import array
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray

from kagezou.io.files.faults import input_problem
from kagezou.io.sets.plain_text import bad_line, utf8_of
from kagezou.io.sets.triangle_count import too_many
from kagezou.io.sets.triangles import Triangles
from kagezou.message import Message

_HEAD_BYTES: Final = 84
_FACET: Final = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("colour", "<u2")])
_NUMBERS: Final = 9
_TAIL_BYTES: Final = 300
_CORNER: Final = re.compile(rb"\bvertex\s+(\S+)\s+(\S+)\s+(\S+)|\bendloop\b", re.IGNORECASE)


def read_stl(path: Path, data: bytes, most: int) -> Triangles:
    """Return the triangles of an STL file; those of which a corner is no number are left out, as each is by itself.

    Parameters
    ----------
    path
        For sentences.
    data
        What is in it.
    most
        So many triangles may be in it.

    Raises
    ------
    InputProblem
        It is cut off or damaged, or there are more triangles.
    """
    facets, notes = _of_bytes(path, data, most) if _is_binary(data) else _of_text(path, utf8_of(data), most)
    is_whole = np.isfinite(facets).all(axis=(1, 2))
    missing = len(facets) - int(is_whole.sum())
    if missing:
        facets = facets[is_whole]
        notes = (*notes, Message("{count} of its triangles have a corner that is not a number", count=missing))
    # As coarse as in the file: each point is there several times still.
    points = facets.reshape(-1, 3)
    return Triangles(points, np.arange(len(points), dtype=np.int32).reshape(-1, 3), notes)


def _is_binary(data: bytes) -> bool:
    """Whether it is no text; the word with which text begins is in the heads of many binary files as well."""
    if len(data) >= _HEAD_BYTES and len(data) == _HEAD_BYTES + _FACET.itemsize * _claimed(data):
        return True
    text = utf8_of(data[:1000]).lower()
    return not text.lstrip().startswith(b"solid") or b"\0" in text


def _claimed(data: bytes) -> int:
    return int(struct.unpack_from("<I", data, _HEAD_BYTES - 4)[0])


def _of_bytes(path: Path, data: bytes, most: int) -> tuple[NDArray[np.floating], tuple[Message, ...]]:
    if len(data) < _HEAD_BYTES:
        raise input_problem(path, Message("it cannot be read as a set: the file is damaged or not what its name says"))
    count = _claimed(data)
    there = len(data) - _HEAD_BYTES
    if there < count * _FACET.itemsize:
        raise input_problem(path, Message("it is cut off"))
    if count > most:
        raise too_many(path, count, most)
    beyond = there - count * _FACET.itemsize
    notes = (Message("{count} bytes behind its last triangle are not used", count=beyond),) if beyond else ()
    return np.frombuffer(data, _FACET, count, _HEAD_BYTES)["corners"], notes


def _of_text(path: Path, text: bytes, most: int) -> tuple[NDArray[np.floating], tuple[Message, ...]]:
    places = array("d")
    start = wrong = 0
    for found in _CORNER.finditer(text):
        if found[1] is None:
            # A facet of STL is a triangle; whatever else is between two of its ends is none.
            if len(places) - start == _NUMBERS:
                start = len(places)
            else:
                del places[start:]
                wrong += 1
            continue
        try:
            places.extend(map(float, found.groups()))
        except ValueError as error:
            raise bad_line(path, text.count(b"\n", 0, found.start()) + 1, found[0]) from error
    if start < len(places):
        raise input_problem(path, Message("it is cut off"))
    if len(places) // _NUMBERS > most:
        raise too_many(path, len(places) // _NUMBERS, most)
    notes = (Message("{count} of its facets are no triangles and are not used", count=wrong),) if wrong else ()
    if b"endsolid" not in b"".join(text[-_TAIL_BYTES:].lower().split()):
        notes = (*notes, Message("it ends within a solid: something may be missing"))
    return np.array(places, np.float64).reshape(-1, 3, 3), notes
