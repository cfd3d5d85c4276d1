"""What of a drawing casts where that is not its whole alpha."""

from typing import Final
from weakref import WeakKeyDictionary

import numpy as np

from kagezou.io.images.cel_cache import CelSource
from kagezou.io.images.reading import Cel, Matte, matte_of
from kagezou.io.pixels.cut_edges import cut_sides, fade_at
from kagezou.io.pixels.painted_shadow import painted_shadow
from kagezou.picture_source import PictureSource

_NOTEWORTHY: Final = 0.01
"""A painted shadow of less, as a part of the figure, is not worth a word."""


class CastingMattes:
    """Mattes as they cast; each is made once of a drawing that is kept in memory, and goes with it.

    Parameters
    ----------
    cels
        Where drawings come from.
    """

    def __init__(self, cels: CelSource) -> None:
        self._cels = cels
        self._bare: WeakKeyDictionary[Cel, Matte] = WeakKeyDictionary()
        self._faded: WeakKeyDictionary[Matte, Matte] = WeakKeyDictionary()

    def matte(self, source: PictureSource, *, translucent: bool, without_painted: bool) -> Matte:
        """Return the matte that a drawing casts by.

        Parameters
        ----------
        source
            The drawing.
        translucent
            Whether its alpha casts as it is: then it fades out where the picture's border cuts it.
        without_painted
            Whether a shadow that is painted into the drawing is left out.

        Raises
        ------
        InputProblem
            It cannot be read.
        """
        matte = self._without_painted(self._cels.cel(source)) if without_painted else self._cels.matte(source)
        return self._fading(matte) if translucent else matte

    def _without_painted(self, cel: Cel) -> Matte:
        known = self._bare.get(cel)
        if known is None:
            known = self._bare[cel] = without_painted_shadow(cel)
        return known

    def _fading(self, matte: Matte) -> Matte:
        known = self._faded.get(matte)
        if known is None:
            known = faded_at_cuts(matte)
            # A matte that is kept by itself would never go.
            if known is not matte:
                self._faded[matte] = known
        return known


def without_painted_shadow(cel: Cel) -> Matte:
    """Return the matte of a drawing without the shadow that is painted into it; its own where there is none."""
    box = cel.matte.box
    if box is None:
        return cel.matte
    painted = painted_shadow(cel.rgba[box.top : box.bottom, box.left : box.right])
    if not painted.any():
        return cel.matte
    alpha = cel.matte.whole()
    alpha[box.top : box.bottom, box.left : box.right][painted] = 0
    return matte_of(alpha)


def faded_at_cuts(matte: Matte) -> Matte:
    """Return a matte whose alpha fades out toward the borders of the picture that cut it; itself where none does."""
    box = matte.box
    if box is None:
        return matte
    sides = cut_sides(matte.alpha, box, matte.width_px, matte.height_px)
    if not any(sides):
        return matte
    alpha = matte.whole()
    part = alpha[box.top : box.bottom, box.left : box.right]
    part[:] = np.rint(part * fade_at(sides, box, matte.width_px, matte.height_px))
    return matte_of(alpha)


def painted_part(cel: Cel) -> float:
    """Return how much of a drawing's figure is a shadow painted with it, 0 to 1; 0 for what is not worth a word."""
    box = cel.matte.box
    if box is None:
        return 0.0
    painted = painted_shadow(cel.rgba[box.top : box.bottom, box.left : box.right])
    part = float(np.count_nonzero(painted)) / max(int(np.count_nonzero(cel.matte.alpha)), 1)
    return part if part >= _NOTEWORTHY else 0.0
