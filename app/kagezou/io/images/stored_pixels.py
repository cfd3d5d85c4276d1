"""Pixels as a file stores them, made straight RGBA that stands upright on its canvas."""

from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.box import Box
from kagezou.io.images.oiio_guard import Header
from kagezou.io.pixels.colour import coded_from_light, steps_from_unit, straight_from_associated

TURNED: Final = 5
"""From this Exif orientation on, rows are columns."""


def box_of(alpha: NDArray[Any]) -> Box | None:
    """Return the box of what is not 0 in (H, W), None where all is."""
    rows = np.flatnonzero(alpha.max(axis=1, initial=0))
    if rows.size == 0:
        return None
    top, bottom = int(rows[0]), int(rows[-1]) + 1
    columns = np.flatnonzero(alpha[top:bottom].max(axis=0))
    return Box(int(columns[0]), top, int(columns[-1]) + 1, bottom)


def full(pixels: NDArray[Any]) -> int:
    """Return the value of integer pixels that stands for 1."""
    return int(np.iinfo(pixels.dtype).max)


def alpha_plane(header: Header, stored: NDArray[Any], index: int | None) -> NDArray[Any] | None:
    """Return channel ``index`` of (H, W, C) as integer (H, W), or None where it means nothing."""
    if index is None:
        return None
    plane: NDArray[Any] = stored[..., index]
    if plane.dtype.kind == "f":
        return steps_from_unit(plane)
    if not header.alpha_declared and not plane.any() and stored.any():
        return None  # a 32-bit file whose writer left the fourth byte unused
    return plane


def assembled(header: Header, stored: NDArray[Any], alpha: NDArray[Any] | None) -> NDArray[Any]:
    """Return the stored pixels as straight (H, W, 4); where ``alpha`` is None it is full."""
    chosen = _colour_channels(header)
    floating = stored.dtype.kind == "f"
    if not floating and header.straight and alpha is not None and (*chosen, header.alpha) == (0, 1, 2, 3):
        return np.ascontiguousarray(stored[..., :4])
    dtype = np.uint16 if floating else stored.dtype
    rgba = np.empty((*stored.shape[:2], 4), dtype)
    colour = rgba[..., :3]
    if floating:
        _put_light(header, stored, alpha, colour)
    else:
        colour[...] = stored[..., chosen] if chosen else 0
        if alpha is not None and not header.straight:
            straight_from_associated(colour, alpha)
    rgba[..., 3] = full(rgba) if alpha is None else alpha
    return rgba


def _put_light(header: Header, stored: NDArray[Any], alpha: NDArray[Any] | None, colour: NDArray[Any]) -> None:
    """Put the linear light of ``stored`` into ``colour`` as sRGB; what was multiplied by an alpha of 0 is black."""
    chosen = _colour_channels(header)
    divided = not header.straight and header.alpha is not None and alpha is not None
    box = box_of(alpha) if divided and alpha is not None else Box(0, 0, colour.shape[1], colour.shape[0])
    colour[...] = 0
    if box is None or not chosen:
        return
    part = stored[box.top : box.bottom, box.left : box.right]
    whole = part[..., header.alpha] if divided else None
    colour[box.top : box.bottom, box.left : box.right] = coded_from_light(part[..., chosen], whole)


def _colour_channels(header: Header) -> list[int]:
    """Return the indices of red, green and blue, one gray index, or none."""
    names = [name.rpartition(".")[2].lower() for name in header.channels]
    if {"r", "g", "b"} <= set(names):
        return [names.index("r"), names.index("g"), names.index("b")]
    others = [index for index in range(len(names)) if index != header.alpha]
    return others[:3] if len(others) >= 3 else others[:1]


def on_canvas(pixels: NDArray[Any], header: Header) -> NDArray[Any]:
    """Return the stored pixels cut or padded with clear to the display window."""
    if header.data == header.display:
        return pixels
    left, top, width, height = header.display
    x, y = header.data[0] - left, header.data[1] - top
    canvas = np.zeros((height, width, *pixels.shape[2:]), pixels.dtype)
    x0, y0 = max(x, 0), max(y, 0)
    x1, y1 = min(x + pixels.shape[1], width), min(y + pixels.shape[0], height)
    if x0 < x1 and y0 < y1:
        canvas[y0:y1, x0:x1] = pixels[y0 - y : y1 - y, x0 - x : x1 - x]
    return canvas


def upright(pixels: NDArray[Any], orientation: int) -> NDArray[Any]:
    """Return the pixels turned as the Exif number 1..8 tells a viewer to."""
    if orientation in {2, 3}:
        pixels = pixels[:, ::-1]
    if orientation in {3, 4}:
        pixels = pixels[::-1]
    if orientation >= TURNED:
        pixels = pixels.swapaxes(0, 1)
        pixels = pixels[:, ::-1] if orientation in {6, 7} else pixels
        pixels = pixels[::-1] if orientation in {7, 8} else pixels
    return np.ascontiguousarray(pixels)
