"""A shadow that is painted into a drawing: dark, half-transparent, at the figure's base."""

from typing import Final

import numpy as np
from numpy.typing import NDArray

_ALPHA: Final = (0.08, 0.9)
"""Between these a pixel is half-transparent; what line art has of that is thin."""

_DARKEST_LIGHT: Final = 0.45
"""Lighter than this, 0 to 1, nobody paints a shadow."""

_BASE_OF_FIGURE: Final = 0.35
"""Over this part of the figure's height from below shadows are painted."""

_THIN_PX: Final = 2
"""What is no wider than twice this and one is the edge of a line."""

_LUMA: Final = (0.2126, 0.7152, 0.0722)


def painted_shadow(rgba: NDArray[np.unsignedinteger]) -> NDArray[np.bool_]:
    """Return which pixels of a figure (H, W, 4), straight, are a shadow that was painted with it, (H, W)."""
    most = float(np.iinfo(rgba.dtype).max)
    alpha = rgba[..., 3] / most
    light = rgba[..., :3] @ np.array(_LUMA) / most
    dark = (alpha >= _ALPHA[0]) & (alpha <= _ALPHA[1]) & (light <= _DARKEST_LIGHT)
    dark[: int((1 - _BASE_OF_FIGURE) * len(dark))] = False
    core = _narrowed(dark, _THIN_PX)
    if not core.any():
        return core
    # Its own soft rim goes with it: what hangs together with its core, step by step.
    whole = core
    for _ in range(4 * _THIN_PX):
        whole = ~_narrowed(~whole, 1) & dark
    return whole


def _narrowed(mask: NDArray[np.bool_], by_px: int) -> NDArray[np.bool_]:
    """Return the pixels of a mask (H, W) that lie at least so far from what is not in it; the border is no edge."""
    for axis in (0, 1):
        rim = np.pad(mask, [(by_px, by_px) if each == axis else (0, 0) for each in (0, 1)], mode="edge")
        parts = [np.take(rim, range(step, step + mask.shape[axis]), axis) for step in range(2 * by_px + 1)]
        mask = np.logical_and.reduce(parts)
    return mask
