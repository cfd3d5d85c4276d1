"""What a drawing looks like: its pixels as one number, and a sketch by which drawings are compared."""

import hashlib
from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from threading import Lock
from typing import Final

import numpy as np
from numpy.typing import NDArray

from kagezou.errors import InputProblem
from kagezou.importing.progress import LoadPhase, Progress, no_progress
from kagezou.io.images.reading import Cel, read_cel
from kagezou.picture_source import PictureSource

_READERS: Final = 2
"""Decoding runs on so many threads; more would leave nothing for the window."""

SKETCH: Final = 32
"""Cells of a sketch, across and down."""

_DIGEST_BYTES: Final = 16


@dataclass(frozen=True, slots=True)
class Print:
    """What a drawing looks like.

    Parameters
    ----------
    digest
        The same for the same pixels, in whatever file.
    sketch
        (SKETCH, SKETCH, 4), 0 to 1: colours times alpha, and alpha, of the figure's own box.
    ratio
        Width of that box by its height; 0 where nothing is solid.
    """

    digest: bytes
    sketch: NDArray[np.float32] = field(compare=False, repr=False)
    ratio: float


def prints_of(sources: Iterable[PictureSource], progress: Progress = no_progress) -> Mapping[PictureSource, Print]:
    """Return the prints of drawings, each decoded once; one that cannot be read has none."""
    each_once = list(dict.fromkeys(sources))
    done, lock = 0, Lock()

    def look(source: PictureSource) -> Print | None:
        nonlocal done
        try:
            found = print_of(read_cel(source))
        except InputProblem:
            # Whoever brings or draws it says what is wrong with it.
            return None
        with lock:
            done += 1
            progress(LoadPhase.COMPARING, done, len(each_once))
        return found

    with ThreadPoolExecutor(_READERS) as pool:
        found = zip(each_once, pool.map(look, each_once), strict=True)
        return {source: each for source, each in found if each is not None}


def print_of(cel: Cel) -> Print:
    """Return what a decoded drawing looks like."""
    rgba = cel.rgba
    shape = f"{rgba.shape} {rgba.dtype.str}".encode()
    digest = hashlib.blake2b(shape + np.ascontiguousarray(rgba).tobytes(), digest_size=_DIGEST_BYTES).digest()
    box = cel.matte.box
    if box is None:
        return Print(digest, np.zeros((SKETCH, SKETCH, 4), np.float32), 0.0)
    part = rgba[box.top : box.bottom, box.left : box.right].astype(np.float32)
    part /= np.float32(np.iinfo(rgba.dtype).max)
    part[..., :3] *= part[..., 3:]
    return Print(digest, _averaged(part), box.width / box.height)


def likeness(before: Sequence[Print], after: Sequence[Print]) -> NDArray[np.float64]:
    """Return how alike drawings are, (before, after): 1 for the same, 0 for nothing in common."""
    found = np.zeros((len(before), len(after)))
    for row, old in enumerate(before):
        for column, new in enumerate(after):
            found[row, column] = _alike(old, new)
    return found


def _alike(one: Print, other: Print) -> float:
    if not one.ratio or not other.ratio:
        return float(one.ratio == other.ratio)
    whole = float(np.maximum(one.sketch, other.sketch).sum())
    apart = float(np.abs(one.sketch - other.sketch).sum())
    return (1.0 - apart / whole) * min(one.ratio / other.ratio, other.ratio / one.ratio)


def _averaged(part: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return the means over the cells of a sketch, of a picture of any size."""
    for axis in (0, 1):
        size = part.shape[axis]
        starts = np.arange(SKETCH) * size // SKETCH
        ends = np.maximum((np.arange(SKETCH) + 1) * size // SKETCH, starts + 1)
        sums = np.concatenate([np.zeros_like(part.take([0], axis)), np.cumsum(part, axis=axis, dtype=np.float64)], axis)
        widths = (ends - starts).reshape([-1 if each == axis else 1 for each in range(3)])
        part = ((sums.take(ends, axis) - sums.take(starts, axis)) / widths).astype(np.float32)
    return part
