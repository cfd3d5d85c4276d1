"""Smoke and glass that the border of the picture cuts: their alpha fades out there instead of ending in a line."""

from typing import Final

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.box import Box

_FADE_OF_PICTURE: Final = 0.08
"""So wide the fade is, as a part of the picture's shorter side."""


def cut_sides(alpha: NDArray[np.unsignedinteger], box: Box, width_px: int, height_px: int) -> tuple[bool, ...]:
    """Return at which sides of a picture its figure is cut: left, top, right, bottom.

    ``alpha`` (box.height, box.width) is that of the figure, in a box of the picture.
    """
    return (
        box.left == 0 and bool(alpha[:, 0].any()),
        box.top == 0 and bool(alpha[0].any()),
        box.right == width_px and bool(alpha[:, -1].any()),
        box.bottom == height_px and bool(alpha[-1].any()),
    )


def fade_at(sides: tuple[bool, ...], box: Box, width_px: int, height_px: int) -> NDArray[np.float32]:
    """Return what is left of the alpha in a box of a picture that is cut at some sides, (box.height, box.width)."""
    reach = max(_FADE_OF_PICTURE * min(width_px, height_px), 1.0)
    x, y = np.arange(box.left, box.right) + 0.5, np.arange(box.top, box.bottom) + 0.5
    from_sides = (x, y, width_px - x, height_px - y)
    across, down = np.ones_like(x), np.ones_like(y)
    for number, (is_cut, away) in enumerate(zip(sides, from_sides, strict=True)):
        if is_cut:
            t = np.clip(away / reach, 0, 1)
            risen = t * t * (3 - 2 * t)
            if number % 2 == 0:
                across = across * risen
            else:
                down = down * risen
    return (down[:, np.newaxis] * across).astype(np.float32)
