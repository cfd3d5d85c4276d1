"""Effects of After Effects that move, tint and blur, on straight pixels from 0 to 1: (H, W, 4)."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.export.after_effects.extendscript import driven_at, pair_at, value_at

Numbers = NDArray[np.float64]


def resampled(
    pixels: Numbers, shape: tuple[int, ...], linear: Numbers, anchor: tuple[float, float], place: tuple[float, float]
) -> Numbers:
    """Return pixels that are moved, scaled and turned, sampled between texels and weighted by alpha."""
    rows, columns = np.indices(shape)
    away = np.stack([columns + 0.5, rows + 0.5]) - np.reshape(place, (2, 1, 1))
    x, y = np.einsum("ij,jrc->irc", np.linalg.inv(linear), away) + np.reshape(anchor, (2, 1, 1)) - 0.5
    x, y = np.round(x, 9), np.round(y, 9)
    light = _premultiplied(pixels)
    height, width = pixels.shape[:2]
    taken = np.zeros((*shape, 4))
    left, top = np.floor(x).astype(int), np.floor(y).astype(int)
    for down in (0, 1):
        for over in (0, 1):
            column, row = left + over, top + down
            part = (1 - np.abs(x - column)) * (1 - np.abs(y - row))
            part[(column < 0) | (row < 0) | (column >= width) | (row >= height)] = 0
            taken += part[..., np.newaxis] * light[row.clip(0, height - 1), column.clip(0, width - 1)]
    return _straight(taken)


def with_control(effect: dict[str, Any], pixels: Numbers, time: float) -> Numbers:
    """Return pixels with an effect that the script adds for its controls."""
    parts, name = effect["children"], effect["matchName"]
    if name == "ADBE Tint":
        return _tinted(parts, pixels, time)
    if name == "ADBE Gaussian Blur 2":
        return _blurred(pixels, value_at(parts[f"{name}-0001"], time))
    if name == "ADBE Geometry2":
        assert parts[f"{name}-0011"]["value"], "one scale for both sides"
        anchor, place = (pair_at(parts[f"{name}-000{number}"], time) for number in (1, 2))
        return resampled(
            pixels, pixels.shape[:2], np.eye(2) * value_at(parts[f"{name}-0003"], time) / 100, anchor, place
        )
    assert name == "ADBE Point Control", name
    return pixels


def _tinted(parts: dict[str, Any], pixels: Numbers, time: float) -> Numbers:
    """Return colours mixed with one between two by their lightness."""
    black, white = (_color_at(parts[f"ADBE Tint-000{number}"], time) for number in (1, 2))
    amount = value_at(parts["ADBE Tint-0003"], time) / 100
    light = pixels[..., :3] @ np.array([0.299, 0.587, 0.114])
    tint = black + (white - black) * light[..., np.newaxis]
    return np.concatenate([pixels[..., :3] * (1 - amount) + tint * amount, pixels[..., 3:]], -1)


def _color_at(channel: dict[str, Any], time: float) -> Numbers:
    color = driven_at(channel, time) if "driven" in channel else channel["value"]
    return np.array(color[:3], float)


def _blurred(pixels: Numbers, blurriness: float) -> Numbers:
    """Return pixels blurred; how wide a blurriness is, is written nowhere, so here its half is the deviation."""
    if blurriness == 0:
        return pixels
    reach = int(np.ceil(blurriness * 2))
    weights = np.exp(-0.5 * (np.arange(-reach, reach + 1) / (blurriness / 2)) ** 2)
    light = _premultiplied(pixels)
    for axis in (0, 1):
        light = np.apply_along_axis(np.convolve, axis, light, weights / weights.sum(), mode="same")
    return _straight(light)


def _premultiplied(pixels: Numbers) -> Numbers:
    return np.concatenate([pixels[..., :3] * pixels[..., 3:], pixels[..., 3:]], -1)


def _straight(light: Numbers) -> Numbers:
    return np.concatenate([light[..., :3] / np.where(light[..., 3:] > 0, light[..., 3:], 1), light[..., 3:]], -1)
