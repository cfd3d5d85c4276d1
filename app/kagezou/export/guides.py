"""Ground, set and feet drawn over a picture, for looking at it: a light line in a dark one, seen on any picture."""

from collections.abc import Iterable
from itertools import pairwise
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.vectors import Matrix, Point2
from kagezou.scene.guide_lines import GuideLines
from kagezou.scene.set_outlines import Line

_WIDTH_PX: Final = 1.5
_SHADE_PX: Final = 3.5
_EDGE, _FLOOR, _GROUND, _CONTACT = (0.55, 0.35), (0.9, 0.6), (0.45, 0.3), (1.0, 0.75)
"""Opacity of the light line and of the dark one around it: of an edge, of where a piece meets the ground, of the ground
itself, and of a contact."""
_HEIGHT_PX: Final = 1080
"""The height of a picture up to which lines have these widths; in a larger one they are wider with it."""

_WHITE, _BLACK = 1.0, 0.0


def with_guides(pixels: NDArray[Any], lines: GuideLines) -> NDArray[Any]:
    """Return a picture with lines over it.

    Parameters
    ----------
    pixels
        Straight sRGB, (H, W, 4) ``uint8`` or ``uint16``.
    lines
        Canvas px; what lies outside is left out.
    """
    size = (pixels.shape[1], pixels.shape[0])
    drawn = ((lines.ground, _GROUND), (lines.edges, _EDGE), (lines.floor, _FLOOR), (lines.contacts, _CONTACT))
    larger = max(size[1] / _HEIGHT_PX, 1.0)
    light, shade = (
        np.maximum.reduce([opacity[tone] * coverage(of_kind, *size, width_px) for of_kind, opacity in drawn])
        for tone, width_px in enumerate((_WIDTH_PX * larger, _SHADE_PX * larger))
    )
    top = np.iinfo(pixels.dtype).max
    made = pixels.copy()
    at = (shade > 0) | (light > 0)
    rgba = made[at] / top
    for alpha, tone in ((shade[at], _BLACK), (light[at], _WHITE)):
        rgba = _over(rgba, alpha, tone)
    made[at] = np.rint(rgba * top).astype(pixels.dtype)
    return made


def coverage(lines: Iterable[Line], width: int, height: int, width_px: float) -> Matrix:
    """Return how much of each pixel (H, W) lines of a width cover, 0 to 1; where they cross, the most counts."""
    covered = np.zeros((height, width))
    for line in lines:
        for start, end in pairwise(line):
            if abs(end[0] - start[0]) >= abs(end[1] - start[1]):
                _draw(covered, start, end, width_px)
            else:
                _draw(covered.T, start[::-1], end[::-1], width_px)
    return covered


def _draw(covered: Matrix, start: Point2, end: Point2, width_px: float) -> None:
    """Draw a segment that goes along x at least as far as along y: in each column the rows around its middle."""
    (x0, y0), (x1, y1) = sorted((start, end))
    rows, columns = covered.shape
    first, last = int(np.floor(max(x0, 0.0))), int(np.ceil(min(x1, float(columns))))
    if last <= first:
        return
    slope = (y1 - y0) / (x1 - x0) if x1 > x0 else 0.0
    x = np.arange(first, last)
    middle = y0 + slope * (np.clip(x + 0.5, x0, x1) - x0)
    # A line that slants covers more of a column than its width.
    steep = np.hypot(1.0, slope)
    reach = int(np.ceil((width_px / 2 + 0.5) * steep))
    y = np.floor(middle)[:, None] + np.arange(-reach, reach + 1)
    part = np.clip(width_px / 2 + 0.5 - np.abs(y + 0.5 - middle[:, None]) / steep, 0.0, 1.0)
    inside = (y >= 0) & (y < rows)
    at = (y[inside].astype(np.intp), np.broadcast_to(x[:, None], y.shape)[inside])
    covered[at] = np.maximum(covered[at], part[inside])


def _over(rgba: Matrix, alpha: Matrix, tone: float) -> Matrix:
    """Return straight colours (N, 4) with a gray of some opacity (N,) over them."""
    below = rgba[:, 3] * (1 - alpha)
    whole = alpha + below
    color = (tone * alpha[:, None] + rgba[:, :3] * below[:, None]) / np.where(whole > 0, whole, 1.0)[:, None]
    return np.column_stack([color, whole])
