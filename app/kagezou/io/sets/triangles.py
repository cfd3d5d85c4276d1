"""What every reader of sets makes: triangles, and what is to be said of them."""

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.vectors import Matrix
from kagezou.message import Message

Indices = NDArray[np.integer]


@dataclass(frozen=True, slots=True, eq=False)
class Triangles:
    """The triangles of a file, not yet checked.

    Parameters
    ----------
    points
        (N, 3) float64, in the file's units and axes.
    corners
        (M, 3) whole numbers, indices of points.
    notes
        What of the file is not used and what had to be assumed, without the file's name.
    """

    points: Matrix
    corners: Indices
    notes: tuple[Message, ...] = ()


def joined(parts: Iterable[Triangles]) -> Triangles:
    """Return triangles of several parts as one, every note once."""
    kept = list(parts)
    starts = np.cumsum([0, *(len(part.points) for part in kept)])
    return Triangles(
        np.concatenate([np.zeros((0, 3)), *(part.points for part in kept)]),
        np.concatenate(
            [np.zeros((0, 3), np.int64), *(part.corners + start for part, start in zip(kept, starts, strict=False))]
        ),
        tuple(dict.fromkeys(note for part in kept for note in part.notes)),
    )


def listed(names: Iterable[str], most: int = 4) -> str:
    """Return names as one enumeration, each once with how often it is there, the most frequent first."""
    counts = Counter(name if name.isprintable() else repr(name) for name in names).most_common()
    told = [name[:60] if count == 1 else f"{name[:60]} (×{count})" for name, count in counts[:most]]
    return ", ".join(told) + (", …" if len(counts) > most else "")
