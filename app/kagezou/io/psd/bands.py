"""Bands of rows in which layers are put together, so that floats of a whole canvas are never held at once."""

from collections.abc import Iterable, Iterator
from typing import Any, Final

from kagezou.io.psd.masks import Box

_BAND_PX: Final = 2 << 20
_OVER_ROWS: Final = frozenset({"gradientfill", "patternfill", "solidcolorfill", "shape"})
"""Kinds whose drawing may reach over rows, as effects do."""


def bands(reach: Box, layers: Iterable[Any]) -> Iterator[Box]:
    """Yield the box ``reach`` in bands from the top; as one where something in the layers reaches over rows."""
    left, top, right, bottom = reach
    if left >= right or top >= bottom:
        return
    whole = any(each.kind in _OVER_ROWS or each.has_effects() for each in layers)
    rows = bottom - top if whole else max(_BAND_PX // (right - left), 1)
    for row in range(top, bottom, rows):
        yield (left, row, right, min(row + rows, bottom))
