"""Between the colours files hold: sRGB coded or linear light, multiplied by alpha or straight."""

import functools
from collections.abc import Callable
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

Pixels = NDArray[Any]
_ROWS: Final = 128
_LINEAR_BELOW: Final = 0.0031308
_CODED_BELOW: Final = 0.04045


def coded_from_linear(linear: NDArray[np.float32]) -> NDArray[np.uint16]:
    """Return linear light 0..1 of any shape as sRGB coded 16 bit; below and above are clipped, NaN gives 0."""
    light = np.clip(np.nan_to_num(linear, nan=0.0, posinf=1.0, neginf=0.0), 0.0, 1.0)
    bent = 1.055 * np.power(np.maximum(light, _LINEAR_BELOW), 1 / 2.4) - 0.055
    return steps_from_unit(np.where(light <= _LINEAR_BELOW, 12.92 * light, bent))


def steps_from_unit(values: NDArray[Any]) -> NDArray[np.uint16]:
    """Return 0..1 of any shape as 0..65535, rounded; below and above are clipped, NaN gives 0."""
    steps = np.empty(values.shape, np.uint16)
    for top in range(0, len(values), _ROWS):
        part = values[top : top + _ROWS].astype(np.float32)
        unit = np.clip(np.nan_to_num(part, nan=0.0, posinf=1.0, neginf=0.0), 0.0, 1.0)
        steps[top : top + _ROWS] = unit * np.float32(65535) + np.float32(0.5)
    return steps


def linear_from_coded(coded: Pixels) -> NDArray[np.float32]:
    """Return sRGB coded ``uint8`` or ``uint16`` of any shape as linear light 0..1."""
    return _light_of(coded.dtype.name)[coded]


@functools.cache
def _light_of(dtype: str) -> NDArray[np.float32]:
    """Return the linear light of every code of ``dtype``."""
    codes = np.linspace(0.0, 1.0, np.iinfo(dtype).max + 1)
    bent = ((codes + 0.055) / 1.055) ** 2.4
    return np.where(codes <= _CODED_BELOW, codes / 12.92, bent).astype(np.float32)


def straight_from_associated(colour: Pixels, alpha: Pixels) -> None:
    """Divide coded integer ``colour`` (H, W, C) by ``alpha`` (H, W) in place; where alpha is 0 it becomes 0."""
    full = np.uint64(np.iinfo(colour.dtype).max)
    for top in range(0, colour.shape[0], _ROWS):
        rows = slice(top, top + _ROWS)
        whole = alpha[rows, :, None].astype(np.uint64)
        divided = (colour[rows] * full + whole // 2) // np.maximum(whole, 1)
        colour[rows] = np.where(whole > 0, np.minimum(divided, full), 0)


def coded_from_light(
    light: NDArray[Any],
    alpha: NDArray[Any] | None,
    changed: Callable[[NDArray[np.float32]], NDArray[np.float32]] | None = None,
) -> NDArray[np.uint16]:
    """Return linear light (H, W, C) of any floating numbers as straight sRGB 16 bit.

    Parameters
    ----------
    light
        Of each pixel.
    alpha
        (H, W), by which it is divided where it is given.
    changed
        What gives the light of sRGB for some rows of straight light.
    """
    coded = np.empty(light.shape, np.uint16)
    for top in range(0, light.shape[0], _ROWS):
        rows = slice(top, top + _ROWS)
        part = light[rows].astype(np.float32)
        if alpha is not None:
            whole = alpha[rows, :, None].astype(np.float32)
            with np.errstate(all="ignore"):
                part = np.where(whole > 0, part / np.where(whole > 0, whole, 1), 0).astype(np.float32)
        coded[rows] = coded_from_linear(part if changed is None else changed(part))
    return coded


def light_from_rgba(rgba: Pixels) -> NDArray[np.float16]:
    """Return straight sRGB coded (H, W, 4) ``uint8`` or ``uint16`` as linear light multiplied by alpha, in halves."""
    full = np.float32(np.iinfo(rgba.dtype).max)
    light = np.empty(rgba.shape, np.float16)
    for top in range(0, rgba.shape[0], _ROWS):
        rows = slice(top, top + _ROWS)
        alpha = rgba[rows, :, 3:].astype(np.float32) / full
        light[rows, :, :3] = linear_from_coded(rgba[rows, :, :3]) * alpha
        light[rows, :, 3:] = alpha
    return light
