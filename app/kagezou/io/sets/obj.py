"""OBJ files: their points and faces, as they are written in the wild; groups and materials do not matter here."""

import re
from array import array
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

import numpy as np

from kagezou.io.files.faults import input_problem
from kagezou.io.sets.plain_text import bad_line, lines_of, utf8_of
from kagezou.io.sets.polygons import triangulated
from kagezou.io.sets.triangle_count import too_many
from kagezou.io.sets.triangles import Triangles
from kagezou.message import Message

_COMMENT: Final = re.compile(rb"#[^\r\n]*")
_UNUSED: Final = {
    b"l": Message("its lines are not used"),
    b"p": Message("its single points are not used"),
    b"curv": Message("its curves are not used"),
    b"curv2": Message("its curves are not used"),
    b"surf": Message("its curved surfaces are not used"),
    b"bzp": Message("its curved surfaces are not used"),
    b"bsp": Message("its curved surfaces are not used"),
    b"cdp": Message("its curved surfaces are not used"),
    b"call": Message("other files that it calls are not read"),
}
"""Statements that make something to be seen which is not made here."""


def read_obj(path: Path, data: bytes, most: int) -> Triangles:
    """Return the faces of an OBJ file as triangles.

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
        A line of it says nothing sensible, or there are more triangles.
    """
    text = utf8_of(data)
    del data
    # A comment may end with a backslash without going on.
    text = _COMMENT.sub(b"", text) if b"#" in text else text
    reading = _Reading(path)
    for number, words in _statements(text):
        act = _ACTS.get(words[0])
        if act is not None:
            try:
                act(reading, words)
            except (ValueError, IndexError, OverflowError) as error:
                raise bad_line(path, number, b" ".join(words)) from error
    made = sum(reading.counts) - 2 * len(reading.counts)
    if made > most:
        raise too_many(path, made, most)
    if reading.corners and max(reading.corners) >= len(reading.places) // 3:
        raise input_problem(path, Message("it is damaged: a triangle names a missing corner"))
    found = triangulated(
        np.frombuffer(reading.places, np.float64).reshape(-1, 3) if reading.places else np.zeros((0, 3)),
        np.array(reading.counts, np.int64),
        np.array(reading.corners, np.int64),
    )
    unused = tuple(dict.fromkeys(_UNUSED[word] for word in reading.unused))
    return Triangles(found.points, found.corners, (*found.notes, *unused))


@dataclass(slots=True)
class _Reading:
    """What has been read so far: places three by three, faces by their numbers of corners, corners from 0."""

    path: Path
    places: "array[float]" = field(default_factory=lambda: array("d"))
    counts: "array[int]" = field(default_factory=lambda: array("q"))
    corners: "array[int]" = field(default_factory=lambda: array("q"))
    unused: Counter[bytes] = field(default_factory=Counter)

    def point(self, words: list[bytes]) -> None:
        # Behind it there may be a weight or a colour.
        _, x, y, z = words[:4]
        self.places.extend((float(x), float(y), float(z)))

    def face(self, words: list[bytes]) -> None:
        count = len(self.places) // 3
        before = len(self.corners)
        for word in words[1:]:
            corner = int(word.partition(b"/")[0]) if word[0] != _SLASH else None
            # What stands behind a slash alone belongs to the word before.
            if corner is not None:
                self.corners.append(corner - 1 if corner > 0 else _back(corner, count))
        self.counts.append(len(self.corners) - before)

    def leave_out(self, words: list[bytes]) -> None:
        self.unused[words[0]] += 1


_SLASH: Final = ord("/")
_ACTS: Final[dict[bytes, Callable[[_Reading, list[bytes]], None]]] = {
    b"v": _Reading.point,
    b"f": _Reading.face,
    b"fo": _Reading.face,
    **dict.fromkeys(_UNUSED, _Reading.leave_out),
}


def _back(corner: int, count: int) -> int:
    """Return a corner that is counted back from the last of so many points, or that is 0, counted from 0."""
    if not -count <= corner < 0:
        raise ValueError(corner)
    return corner + count


def _statements(text: bytes) -> Iterator[tuple[int, list[bytes]]]:
    """Yield the words of every statement with the number of its line; a backslash at its end goes on with the next."""
    held: list[bytes] = []
    for number, line in enumerate(lines_of(text), start=1):
        words = line.split()
        if not words:
            if held:
                yield number, held
                held = []
            continue
        if held:
            words = held + words
            held = []
        if words[-1][-1:] == b"\\":
            last = words.pop()[:-1]
            held = [*words, last] if last else words
        else:
            yield number, words
    if held:
        yield number, held
