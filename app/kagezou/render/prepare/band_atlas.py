"""Bands of a receiver laid out below each other in one target."""

from collections.abc import Iterable
from dataclasses import dataclass
from math import ceil

import numpy as np

from kagezou.geometry.bands import Band, Extent
from kagezou.geometry.box import Box
from kagezou.geometry.vectors import Matrix


@dataclass(frozen=True, slots=True)
class Strip:
    """A band and where it lies in the atlas."""

    band: Band
    box: Box

    @property
    def shown(self) -> Box:
        """The texels in which the blur has to be known."""
        return self._texels(self.band.shown)

    @property
    def plane_from_atlas(self) -> Matrix:
        """The (3, 3) map from px of the atlas to (u, v) of the receiver."""
        texel, needed = self.band.texel_px, self.band.needed
        return np.array(
            [
                [texel, 0.0, needed.left - texel * self.box.left],
                [0.0, texel, needed.low - texel * self.box.top],
                [0.0, 0.0, 1.0],
            ]
        )

    def row_areas(self, margin: int) -> Matrix:
        """Return how much area of the core a texel stands for in each row of ``shown`` but ``margin`` rows, px²."""
        texel, core = self.band.texel_px, self.band.core
        rows = np.arange(self.shown.top + margin, self.shown.bottom - margin)
        low = self.band.needed.low + (rows - self.box.top) * texel
        inside = np.minimum(low + texel, core.high) - np.maximum(low, core.low)
        return np.asarray(np.clip(inside, 0.0, texel) * texel)

    def _texels(self, extent: Extent) -> Box:
        texel, needed = self.band.texel_px, self.band.needed
        top = self.box.top + int((extent.low - needed.low) / texel)
        bottom = self.box.top + ceil((extent.high - needed.low) / texel)
        return Box(self.box.left, top, self.box.right, min(bottom, self.box.bottom))


def laid_out(bands: Iterable[Band]) -> tuple[Strip, ...]:
    """Return the bands below each other, each on whole texels."""
    strips: list[Strip] = []
    top = 0
    for band in bands:
        width = ceil((band.needed.right - band.needed.left) / band.texel_px)
        height = ceil((band.needed.high - band.needed.low) / band.texel_px)
        strips.append(Strip(band, Box(0, top, width, top + height)))
        top += height
    return tuple(strips)
