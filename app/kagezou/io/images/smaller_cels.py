"""Drawings made smaller for previews: each pixel the mean of those it stands for, where they lie on the canvas."""

import threading
from collections.abc import Iterable
from math import ceil
from typing import Any, Final
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.box import Box, centred_offset
from kagezou.io.images.cel_cache import CelCache
from kagezou.io.images.reading import Cel, Matte, matte_of
from kagezou.picture_source import PictureSource

_WIDE: Final = {1: np.uint32, 2: np.uint64}
"""By the bytes of a channel: what holds the sum of colour times alpha over sixteen pixels."""


class SmallerCels:
    """Drawings of a canvas at a part of its resolution; any thread may ask.

    Parameters
    ----------
    source
        Where whole drawings come from.
    canvas
        The canvas they lie centred on, px.
    divisor
        How many pixels across become one; divides both sides of the canvas.
    """

    def __init__(self, source: CelCache, canvas: Box, divisor: int) -> None:
        self._source = source
        self._canvas = canvas
        self._divisor = divisor
        self._made: WeakKeyDictionary[Cel, Cel] = WeakKeyDictionary()
        self._coming: set[Cel] = set()
        self._lock = threading.Lock()

    def cel(self, source: PictureSource) -> Cel:
        """Return the drawing from ``source``, smaller.

        Raises
        ------
        InputProblem
            It cannot be read.
        """
        return self._smaller(self._source.cel(source))

    def matte(self, source: PictureSource) -> Matte:
        """Return the matte of the drawing from ``source``, smaller.

        Raises
        ------
        InputProblem
            It cannot be read.
        """
        return self.cel(source).matte

    def background(self, source: PictureSource) -> Cel:
        """Return the opaque picture from ``source``, smaller.

        Raises
        ------
        InputProblem
            It cannot be read.
        """
        return self._smaller(self._source.background(source))

    def is_ready(self, drawings: Iterable[PictureSource], background: PictureSource | None) -> bool:
        """Whether these are there without any work; if not, the work is begun on another thread."""
        wholes = [self._source.cel(source) for source in drawings]
        wholes += [self._source.background(background)] if background is not None else []
        with self._lock:
            missing = [whole for whole in wholes if whole not in self._made and whole not in self._coming]
            self._coming.update(missing)
            ready = all(whole in self._made for whole in wholes)
        if missing:
            threading.Thread(target=self._make, args=(missing,), daemon=True, name="smaller").start()
        return ready

    def _make(self, wholes: Iterable[Cel]) -> None:
        for whole in wholes:
            self._smaller(whole)
            with self._lock:
                self._coming.discard(whole)

    def _smaller(self, whole: Cel) -> Cel:
        with self._lock:
            known = self._made.get(whole)
        if known is None:
            known = reduced(whole, self._canvas, self._divisor)
            with self._lock:
                self._made[whole] = known
        return known


def reduced(cel: Cel, canvas: Box, divisor: int) -> Cel:
    """Return a drawing that lies centred on the canvas as one that lies so on the smaller canvas, looking alike.

    Parameters
    ----------
    cel
        The whole drawing.
    canvas
        Where it lies, px; both sides can be divided.
    divisor
        How many pixels across become one.
    """
    height, width = cel.rgba.shape[:2]
    left, top = centred_offset(canvas, width, height)
    # As much on both sides, so that the smaller drawing is centred as well and no texel lies between two pixels.
    over_x = ceil(max(-left, left + width - canvas.width, 0) / divisor)
    over_y = ceil(max(-top, top + height - canvas.height, 0) / divisor)
    shape = (canvas.height // divisor + 2 * over_y, canvas.width // divisor + 2 * over_x, 4)
    rgba: NDArray[Any] = np.zeros(shape, cel.rgba.dtype)
    if cel.matte.box is not None:
        shift = (left + over_x * divisor, top + over_y * divisor)
        _put_means(cel.rgba, cel.matte.box, shift, divisor, rgba)
    matte = matte_of(rgba[..., 3])
    rgba.setflags(write=False)
    return Cel(rgba, matte, cel.notes)


def _put_means(whole: NDArray[Any], box: Box, shift: tuple[int, int], divisor: int, small: NDArray[Any]) -> None:
    """Put the means of ``box`` of the whole drawing into the small one, ``shift`` px further right and down."""
    placed = box.moved(*shift)
    cells = Box(
        placed.left // divisor, placed.top // divisor, ceil(placed.right / divisor), ceil(placed.bottom / divisor)
    )
    part = np.zeros((cells.height * divisor, cells.width * divisor, 4), whole.dtype)
    x, y = placed.left - cells.left * divisor, placed.top - cells.top * divisor
    part[y : y + box.height, x : x + box.width] = whole[box.top : box.bottom, box.left : box.right]
    wide = _WIDE[whole.dtype.itemsize]
    alpha = np.zeros((cells.height, cells.width), wide)
    colour = np.zeros((cells.height, cells.width, 3), wide)
    for row in range(divisor):
        for column in range(divisor):
            texels = part[row::divisor, column::divisor].astype(wide)
            alpha += texels[..., 3]
            colour += texels[..., :3] * texels[..., 3:]
    into = small[cells.top : cells.bottom, cells.left : cells.right]
    into[..., :3] = colour // np.maximum(alpha, 1)[..., None]
    into[..., 3] = (alpha + divisor * divisor // 2) // (divisor * divisor)
