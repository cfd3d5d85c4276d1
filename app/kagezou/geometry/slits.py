"""Gaps in a shadow on water: rows of long lenses along the crests of waves, as painters leave them open.

Rows lie one behind the other where crests go, and go with them. A row is cut into lengths, each with one gap: its two
edges are parabolas that meet in points at both ends. Where it lies in its length, how long, wide and bowed it is, and
how it opens and closes on its way depend on the numbers of row and length alone.

``shaders/common/slits.glsl`` is the same formula in a pixel.
"""

from dataclasses import dataclass, replace
from math import cos, pi, radians, sin

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.waves import Ripple

LENGTH_SPACINGS = 26.0
"""How long a length with one gap is, in spacings of rows."""

LEAST_WIDTH = 0.3
"""How wide a gap is where it begins, as a part of the spacing; it grows from there with the distance."""

MOST_WIDTH = 0.6
"""How wide a gap becomes at most, as a part of the spacing."""

LONGER, WIDER, BOW = 0.35, 0.35, 0.6
"""By which part a gap is longer or shorter and wider or narrower than others, and how far it is bowed."""

SWAY, SWAY_ALONG, SWAY_ACROSS = 0.12, 6.1, 8.7
"""How far rows sway from straight lines, in spacings, and over how many along the crests and from row to row."""

BREATH, BREATH_SPACINGS = 0.2, 7.3
"""By which part of its width a gap opens and closes on its way, and over how many spacings."""

_MANY_ROWS = 1 << 20
_LOOPS_WITHIN = 1e-6

Numbers = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Slits:
    """The gaps at one moment.

    Parameters
    ----------
    share
        How much of a crest's length is open, 0 to 1.
    spacing_px
        From row to row on the ground.
    growth
        How much wider a gap is with every px of distance from where gaps begin.
    clear_px
        Up to this distance from the contact line there are none.
    direction_deg
        Where rows go on the ground: 0 along u, 90 along v.
    moved_px
        How far they have gone.
    rows
        After so many the same rows come again.
    seed
        Another one has other gaps.
    """

    share: float
    spacing_px: float
    growth: float
    clear_px: float
    direction_deg: float = 90.0
    moved_px: float = 0.0
    rows: int = _MANY_ROWS
    seed: int = 0

    def upon(self, ripple: Ripple, frame: float, length_frames: int) -> "Slits":
        """Return the gaps as they go with waves: ``ripple`` is the first moment's, ``frame`` counts from it.

        Without a spacing rows lie a wavelength apart. If whole crests pass in the cut, it loops: the same rows come
        again after as many as pass in it, and the spacing is the nearest of which a whole number does.
        """
        wave = ripple.wave
        spacing = self.spacing_px or wave.wavelength_px
        way = abs(wave.velocity_px) * length_frames
        crests, rows = way / wave.wavelength_px, _MANY_ROWS
        if round(crests) >= 1 and abs(crests - round(crests)) < _LOOPS_WITHIN * max(crests, 1.0):
            rows = max(round(way / spacing), 1)
            spacing = way / rows
        moved = wave.velocity_px * frame + ripple.phase * wave.wavelength_px / (2 * pi)
        return replace(self, spacing_px=spacing, direction_deg=wave.direction_deg, moved_px=moved, rows=rows)

    @property
    def first_row(self) -> int:
        """What is added to the number of a row, so that it is over 0 and counts from where rows were at first."""
        most = -(-_MANY_ROWS // self.rows) * self.rows
        return most - int(np.floor(self.moved_px / self.spacing_px)) % self.rows

    @property
    def moved_part(self) -> float:
        """How far rows have gone beyond whole spacings, as a part of the spacing."""
        return self.moved_px / self.spacing_px % 1.0

    @property
    def across_from_ground(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """The rows of the matrix from the ground's (u, v) to (along the crests, where they go)."""
        angle = radians(self.direction_deg)
        return ((-sin(angle), cos(angle)), (cos(angle), sin(angle)))

    def inside_px(self, u: Numbers, v: Numbers, away_px: Numbers) -> Numbers:
        """Return how far places of the ground lie within a gap across it, ground px; below 0 in the shadow.

        Parameters
        ----------
        u, v
            The places, px.
        away_px
            How far they lie from the contact line, px.
        """
        (to_right, to_near), (onto_right, onto_near) = self.across_from_ground
        along, across = to_right * u + to_near * v, onto_right * u + onto_near * v
        spacing, length = self.spacing_px, LENGTH_SPACINGS * self.spacing_px
        across = across + SWAY * spacing * np.sin(2 * pi * (along / SWAY_ALONG + across / SWAY_ACROSS) / spacing)
        row = np.floor(across / spacing - self.moved_part)
        middle = (row + 0.5 + self.moved_part) * spacing
        number = (row.astype(np.int64) + self.first_row) % self.rows
        along = along + length * self._chance(number, np.zeros_like(number), 0)
        part = np.floor(along / length)
        of_row, of_part = number, part.astype(np.int64)
        longer, place, wider, bow, beside, breath = (self._chance(of_row, of_part, each) for each in range(1, 7))
        half = length / 2 * self.share * (1 + self.spread * (2 * longer - 1))
        start = half + (length - 2 * half) * place
        thin = 1 - ((along - part * length - start) / half) ** 2
        width = self._half_width(away_px) * (1 + WIDER * (2 * wider - 1))
        width = width * (1 - BREATH + BREATH * np.cos(2 * pi * (breath + middle / (BREATH_SPACINGS * spacing))))
        width = np.minimum(width, MOST_WIDTH / 2 * spacing)
        bowed = BOW * (2 * bow - 1)
        shift = (spacing / 2 - width * (1 + np.abs(bowed))) * (2 * beside - 1)
        return np.asarray(width * thin - np.abs(across - middle - shift - bowed * width * thin))

    @property
    def spread(self) -> float:
        """By which part lengths differ, so that none is longer than its place and the mean is the share."""
        return min(LONGER, (1 - self.share) / self.share)

    def _half_width(self, away_px: Numbers) -> Numbers:
        beyond = away_px - self.clear_px
        part = np.clip(beyond / self.spacing_px, 0.0, 1.0)
        risen = part * part * (3 - 2 * part)
        return risen * (LEAST_WIDTH * self.spacing_px + self.growth * np.maximum(beyond, 0.0)) / 2

    def _chance(self, row: NDArray[np.int64], part: NDArray[np.int64], which: int) -> Numbers:
        """Return numbers of [0, 1) that depend on row, length, kind and seed alone: 32 bit, as shaders have them."""
        state = np.full(row.shape, self.seed & 0xFFFFFFFF, np.uint32)
        for each in (row, part, np.full_like(row, which)):
            state = _mixed(state ^ (each & 0xFFFFFFFF).astype(np.uint32))
        return (state >> np.uint32(8)) / np.float64(1 << 24)


def _mixed(state: NDArray[np.uint32]) -> NDArray[np.uint32]:
    """Return bits that each depend on all bits (lowbias32 of C. Wellons, after a step by the golden ratio)."""
    state = state + np.uint32(0x9E3779B9)
    state = (state ^ (state >> np.uint32(16))) * np.uint32(0x7FEB352D)
    state = (state ^ (state >> np.uint32(15))) * np.uint32(0x846CA68B)
    return state ^ (state >> np.uint32(16))
