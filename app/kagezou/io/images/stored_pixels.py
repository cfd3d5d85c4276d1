"""Pixels as a file stores them, made straight RGBA that stands upright on its canvas."""

from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.box import Box
from kagezou.io.images.header import Header
from kagezou.io.pixels.colour import coded_from_light, steps_from_unit, straight_from_associated

_ROWS: Final = 256
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


def alpha_of(header: Header, alpha: NDArray[Any], colour: NDArray[Any]) -> NDArray[Any] | None:
    """Return a stored alpha (H, W) as integers, or None where it means nothing beside its ``colour`` (H, W, C)."""
    if alpha.dtype.kind == "f":
        return steps_from_unit(alpha)
    if not header.alpha_declared and not alpha.any() and colour.any():
        return None  # a file of four channels whose writer left the fourth unused
    return alpha


def assembled(header: Header, used: NDArray[Any], alpha: NDArray[Any] | None) -> NDArray[Any]:
    """Return the channels that are used as straight sRGB (H, W, 4); where ``alpha`` is None it is full."""
    count = len(header.colour)
    floating = used.dtype.kind == "f"
    is_plain = header.straight and count == 3 and alpha is not None and used.shape[2] == 4
    if not floating and is_plain and header.change is None:
        return np.ascontiguousarray(used)
    rgba = np.empty((*used.shape[:2], 4), np.uint16 if floating else used.dtype)
    colour = rgba[..., :3]
    if floating:
        _put_light(header, used, alpha, colour)
    else:
        colour[...] = used[..., :count] if count else 0
        if header.white_is_zero:
            np.invert(colour, out=colour)
        if alpha is not None and not header.straight:
            straight_from_associated(colour, alpha)
        if header.change is not None:
            header.change.put_on(colour)
    rgba[..., 3] = full(rgba) if alpha is None else alpha
    return rgba


def _put_light(header: Header, used: NDArray[Any], alpha: NDArray[Any] | None, colour: NDArray[Any]) -> None:
    """Put the linear light of ``used`` into ``colour`` as sRGB; what was multiplied by an alpha of 0 is black."""
    count = len(header.colour)
    divided = not header.straight and alpha is not None
    box = box_of(alpha) if divided and alpha is not None else Box(0, 0, colour.shape[1], colour.shape[0])
    colour[...] = 0
    if box is None or not count:
        return
    part = used[box.top : box.bottom, box.left : box.right]
    whole = part[..., count] if divided else None
    change = header.change.lit if header.change is not None and count == 3 else None
    colour[box.top : box.bottom, box.left : box.right] = coded_from_light(part[..., :count], whole, change)


def glowing(header: Header, used: NDArray[Any]) -> NDArray[np.bool_] | None:
    """Return where colour was multiplied by an alpha of 0 and yet is there, (H, W): light without cover.

    None where there is none, or where colours are stored without being multiplied.
    """
    count = len(header.colour)
    if header.straight or header.alpha is None or not count:
        return None
    found = np.zeros(used.shape[:2], np.bool_)
    with np.errstate(invalid="ignore"):
        for top in range(0, len(used), _ROWS):
            part = used[top : top + _ROWS]
            clear = part[..., count] <= 0
            if clear.any():
                found[top : top + _ROWS] = clear & (part[..., :count] > 0).any(axis=-1)
    return found if found.any() else None


def put_glow(header: Header, used: NDArray[Any], glow: NDArray[np.bool_], rgba: NDArray[Any]) -> None:
    """Put light without cover into ``rgba`` (H, W, 4): as little cover of it as shows the same light over black."""
    count = len(header.colour)
    light = used[..., :count][glow]
    if light.dtype.kind == "f":
        light = np.clip(np.nan_to_num(light.astype(np.float32), nan=0.0, posinf=1.0, neginf=0.0), 0.0, 1.0)
        cover = light.max(axis=-1)
        changed = header.change.lit if header.change is not None and count == 3 else None
        rgba[glow, :3] = coded_from_light(light[None], cover[None], changed)[0]
        rgba[glow, 3] = steps_from_unit(cover)
        return
    cover = light.max(axis=-1)
    straight = np.repeat(light, 3 // count, axis=-1)[:, None]
    straight_from_associated(straight, cover[:, None])
    rgba[glow, :3], rgba[glow, 3] = straight[:, 0], cover


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
