"""What every reader of sets makes: triangles, and what is to be said of them."""

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kagezou.message import Message

Indices = NDArray[np.integer]


@dataclass(frozen=True, slots=True, eq=False)
class Triangles:
    """The triangles of a file, not yet checked.

    Parameters
    ----------
    points
        (N, 3) float64 or float32, in the file's units and axes.
    corners
        (M, 3) int32, indices of points.
    notes
        What of the file is not used and what had to be assumed, without the file's name.
    """

    points: NDArray[np.float64] | NDArray[np.float32]
    corners: Indices
    notes: tuple[Message, ...] = ()


def joined(parts: Iterable[Triangles]) -> Triangles:
    """Return triangles of several parts as one, every note once."""
    kept = list(parts)
    if len(kept) == 1:
        return kept[0]
    starts = np.cumsum([0, *(len(part.points) for part in kept)])
    return Triangles(
        np.concatenate([np.zeros((0, 3)), *(part.points for part in kept)]),
        np.concatenate(
            [
                np.zeros((0, 3), np.int32),
                *(part.corners + np.int32(start) for part, start in zip(kept, starts, strict=False)),
            ]
        ),
        tuple(dict.fromkeys(note for part in kept for note in part.notes)),
    )


def listed(names: Iterable[str], most: int = 4) -> str:
    """Return names as one enumeration, each once with how often it is there, the most frequent first."""
    counts = Counter(name if name.isprintable() else repr(name) for name in names).most_common()
    told = [name[:60] if count == 1 else f"{name[:60]} (×{count})" for name, count in counts[:most]]
    return ", ".join(told) + (", …" if len(counts) > most else "")
