"""The layers of united shadows within one file: a group for each look, and what makes of it the maximum of them."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.box import Box, around
from kagezou.io.pixels.layers import LayerPart, PartGroup, Pixels
from kagezou.scene.scene import ShadowLook


def as_group(name: str, parts: Sequence[LayerPart], look: ShadowLook, *, keeps_opacity: bool) -> list[LayerPart]:
    """Return shadows of one look as the layers of a group.

    Parameters
    ----------
    name
        What the group is called.
    parts
        From the bottom, in one depth, at full opacity where the file keeps opacity.
    look
        How the group is laid.
    keeps_opacity
        Whether the file keeps opacity and groups: then both are the group's, and its layers lie plainly on each other.
    """
    if not keeps_opacity:
        group = PartGroup(name)
        # Those without a pixel, too: whoever lays the group asks any of them.
        return [replace(part, multiply=look.multiply, group=group) for part in parts]
    found = _mask([part for part in parts if not part.box.is_empty])
    mask, box = found or (None, None)
    group = PartGroup(name, look.opacity, look.multiply, mask, box)
    return [replace(part, opacity=1.0, multiply=False, group=group) for part in parts]


def _mask(parts: Sequence[LayerPart]) -> tuple[Pixels, Box] | None:
    """Return which part of layers laid on each other is to be seen, and where that is not all of them.

    Alphas a and b laid on each other are a + b - ab, united max(a, b): the mask is the one as a part of the other. It
    is full but where soft or faded edges lie on each other, so that each layer stays whole.
    """
    box = around(*[part.box for part in parts])
    if box is None or len(parts) < 2:
        return None
    most, clear = np.zeros((box.height, box.width), np.float32), np.ones((box.height, box.width), np.float32)
    for part in parts:
        own = part.box.moved(-box.left, -box.top)
        place = (slice(own.top, own.bottom), slice(own.left, own.right))
        alpha = part.pixels[..., 3] / np.float32(np.iinfo(part.pixels.dtype).max)
        most[place] = np.maximum(most[place], alpha)
        clear[place] *= 1 - alpha
    full = np.iinfo(parts[0].pixels.dtype).max
    seen = np.rint(most / np.maximum(1 - clear, np.maximum(most, 1e-6)) * full)
    mask = np.where(most > 0, seen, full).astype(parts[0].pixels.dtype)
    return _cropped(mask, box, full)


def _cropped(mask: NDArray[Any], box: Box, full: int) -> tuple[Pixels, Box] | None:
    """Return the part of a mask that is not full, and its box; None where all is."""
    partly = mask < full
    rows, columns = np.flatnonzero(partly.any(1)), np.flatnonzero(partly.any(0))
    if not rows.size:
        return None
    top, left, bottom, right = int(rows[0]), int(columns[0]), int(rows[-1]) + 1, int(columns[-1]) + 1
    kept = np.ascontiguousarray(mask[top:bottom, left:right])
    return kept, Box(left, top, right, bottom).moved(box.left, box.top)
