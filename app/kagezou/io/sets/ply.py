"""PLY files: their vertices, faces and strips of triangles, whatever else stands between them."""

import re
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.vectors import Matrix
from kagezou.io.files.faults import input_problem
from kagezou.io.sets.plain_text import bad_line, utf8_of
from kagezou.io.sets.ply_body import SHAPELESS, Lists, PlyBody
from kagezou.io.sets.ply_head import Element, PlyHead, ply_head
from kagezou.io.sets.polygons import triangulated
from kagezou.io.sets.strips import of_strip
from kagezou.io.sets.triangle_count import too_many
from kagezou.io.sets.triangles import Triangles, joined, listed
from kagezou.message import Message

_CORNERS: Final = ("vertex_indices", "vertex_index", "vertex_ids")
_POINTS, _FACES, _STRIPS = "vertex", "face", "tristrips"
_NO_NUMBER: Final = re.compile(rb"(?<!\S)(?![-+]?(?:[0-9.]|nan|inf))\S+|(?<=[0-9]),[0-9]+", re.IGNORECASE)


def read_ply(path: Path, data: bytes, most: int) -> Triangles:
    """Return the faces and strips of triangles of a PLY file.

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
    # In a file of bytes only the head is text.
    data = data if data[:3] == b"ply" else utf8_of(data)
    head = ply_head(path, data)
    try:
        body = PlyBody(_numbers(path, data, head.end) if head.is_text else data[head.end :])
        return _read(path, head, body, most)
    except SHAPELESS as error:
        raise input_problem(
            path, Message("it cannot be read as a set: the file is damaged or not what its name says")
        ) from error


def _read(path: Path, head: PlyHead, body: PlyBody, most: int) -> Triangles:
    points: Matrix = np.zeros((0, 3))
    faces = strips = Lists.none()
    unused = []
    for element in head.elements:
        columns = body.columns(element)
        if element.name == _POINTS:
            points = np.stack([np.asarray(columns[axis], np.float64) for axis in ("x", "y", "z")], axis=1)
        elif element.name in (_FACES, _STRIPS) and (name := _corners_in(element)) is not None:
            found = columns[name]
            faces, strips = (found, strips) if element.name == _FACES else (faces, found)
        elif element.count:
            unused.append(element.name)
    notes = (Message("its elements {names} are not used", names=listed(unused)),) if unused else ()
    return _made(path, points, faces, strips, most, notes)


def _corners_in(element: Element) -> str | None:
    """Return the list of an element that names corners."""
    lists = [prop.name for prop in element.properties if prop.length is not None]
    return next((name for name in lists if name.lower() in _CORNERS), lists[0] if len(lists) == 1 else None)


def _made(path: Path, points: Matrix, faces: Lists, strips: Lists, most: int, notes: tuple[Message, ...]) -> Triangles:
    made = sum(int(np.maximum(each.counts - 2, 0).sum()) for each in (faces, strips))
    if made > most:
        raise too_many(path, made, most)
    corners, along = _whole(faces.numbers), _whole(strips.numbers)
    ends = np.cumsum(strips.counts)
    # A corner of -1 ends a strip.
    runs = [of_strip(run[run >= 0]) for part in np.split(along, ends[:-1]) for run in _cut_behind_ends(part)]
    every = np.concatenate([corners, along[along >= 0]])
    if len(every) and not 0 <= every.min() <= every.max() < len(points):
        raise input_problem(path, Message("it is damaged: a triangle names a missing corner"))
    cut = triangulated(points, faces.counts, corners)
    whole = joined([cut, *(Triangles(np.zeros((0, 3)), run - len(cut.points)) for run in runs if len(run))])
    return Triangles(whole.points, whole.corners, (*whole.notes, *notes))


def _cut_behind_ends(strip: NDArray[np.int64]) -> list[NDArray[np.int64]]:
    return np.split(strip, np.flatnonzero(strip < 0))


def _whole(numbers: NDArray[Any]) -> NDArray[np.int64]:
    """Return whole numbers, which a text has among others."""
    made = numbers.astype(np.int64)
    if (made != numbers).any():
        raise ValueError(numbers)
    return made


def _numbers(path: Path, data: bytes, start: int) -> bytes:
    """Return the numbers of a text from a byte on as those of float64."""
    wrong = _NO_NUMBER.search(data, start)
    if wrong is not None:
        raise bad_line(path, data.count(b"\n", 0, wrong.start()) + 1, wrong[0])
    return np.fromstring(data[start:].decode("ascii"), np.float64, sep=" ").tobytes()
