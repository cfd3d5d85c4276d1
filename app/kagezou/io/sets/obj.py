"""OBJ files reduced to their points and faces: groups, materials and files they name cost time and are not needed."""

import re
from typing import Final

_OF_CORNER: Final = re.compile(rb"/\S*")


def bare_obj(data: bytes) -> bytes:
    """Return the text of an OBJ file with its points and faces alone, every corner by its point's number from 1.

    Raises
    ------
    ValueError
        A corner is not a number.
    """
    kept: list[bytes] = []
    points = 0
    for line in data.replace(b"\\\r\n", b" ").replace(b"\\\n", b" ").splitlines():
        words = line.lstrip()
        if words[:2] in (b"v ", b"v\t"):
            points += 1
            kept.append(words)
        elif words[:2] in (b"f ", b"f\t"):
            face = _OF_CORNER.sub(b"", words) if b"/" in words else words
            kept.append(_counted_from_the_first(face, points) if b"-" in face else face)
    return b"\n".join(kept) + b"\n"


def _counted_from_the_first(face: bytes, points: int) -> bytes:
    """Return a face whose corners below 0, counted back from the last point before it, are counted from the first."""
    corners = [int(word) for word in face.split()[1:]]
    return b"f " + b" ".join(b"%d" % (corner + points + 1 if corner < 0 else corner) for corner in corners)
