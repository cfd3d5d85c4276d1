"""Several shadows of different looks as one layer, or as two where some multiply what is under them and some do not."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.box import Box, around
from kagezou.io.images.writing import ShadowImage

_DEPTHS = {8: np.uint8, 16: np.uint16}


class Laid(NamedTuple):
    """A shadow, and whether it multiplies what is under it; else it lies over it."""

    image: ShadowImage
    multiply: bool


def mixed(shadows: Sequence[Laid], *, multiply: bool, depth: int) -> ShadowImage:
    """Return the layer of one blend mode that does its part of what shadows do one after the other.

    Where there are both, the layer of those that multiply is laid first, and that of the others over it: together they
    do to opaque pixels what all of them do, in whatever order they lie.

    Parameters
    ----------
    shadows
        At least one, of one size, from the lowest up; those without any pixels change nothing.
    multiply
        Which of the two layers is wanted.
    depth
        Bits of the layer, 8 or 16.
    """
    first = shadows[0].image
    seen = [each for each in shadows if not each.image.box.is_empty]
    wanted = [each for each in seen if each.multiply == multiply]
    box = around(*(each.image.box for each in seen))
    if not wanted or box is None:
        return ShadowImage(first.width_px, first.height_px, first.color, np.zeros((0, 0), _DEPTHS[depth]), _NOTHING)
    if len(seen) == 1:
        return _in_depth(seen[0].image, depth)
    covered, color = (_multiplied if multiply else _covered)(box, seen)
    base = wanted[0].image
    color = np.where(covered > 0, color, np.array(base.color) / 255)
    most = (1 << depth) - 1
    alpha, colors = (np.rint(np.clip(each, 0, 1) * most).astype(_DEPTHS[depth]) for each in (covered[..., 0], color))
    return ShadowImage(base.width_px, base.height_px, base.color, alpha, box, colors)


_NOTHING = Box(0, 0, 0, 0)


def _multiplied(box: Box, shadows: Sequence[Laid]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return what those that multiply cover (h, w, 1) of a box, and in which colour (h, w, 3)."""
    left, clear = np.ones((box.height, box.width, 3)), np.ones((box.height, box.width, 1))
    for image, _ in (each for each in shadows if each.multiply):
        alpha, color = _on(box, image)
        left *= 1 - alpha + alpha * color
        clear *= 1 - alpha
    return _divided(1 - clear, left - clear)


def _covered(box: Box, shadows: Sequence[Laid]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return what those that do not multiply cover, and in which colour, with those that multiply over them."""
    light, clear = np.zeros((box.height, box.width, 3)), np.ones((box.height, box.width, 1))
    for image, multiply in shadows:
        alpha, color = _on(box, image)
        if multiply:
            light *= 1 - alpha + alpha * color
        else:
            light = light * (1 - alpha) + alpha * color
            clear *= 1 - alpha
    return _divided(1 - clear, light)


def _divided(
    covered: NDArray[np.float64], light: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    return covered, light / np.where(covered > 0, covered, 1)


def _on(box: Box, image: ShadowImage) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the alpha of an image, (h, w, 1) of a larger box, 0 to 1, and its colours, (h, w, 3)."""
    full = np.iinfo(image.alpha.dtype).max
    alpha, color = np.zeros((box.height, box.width, 1)), np.ones((box.height, box.width, 3)) * image.color / 255
    own = image.box.moved(-box.left, -box.top)
    place = (slice(own.top, own.bottom), slice(own.left, own.right))
    alpha[(*place, 0)] = image.alpha / full
    if image.colors is not None:
        color[place] = image.colors / full
    return alpha, color


def _in_depth(image: ShadowImage, depth: int) -> ShadowImage:
    if image.alpha.dtype == _DEPTHS[depth]:
        return image
    assert depth == 8, "shadows are drawn in no less than they are wanted in"
    alpha, colors = (
        None if each is None else ((each.astype(np.uint32) + 128) // 257).astype(np.uint8)
        for each in (image.alpha, image.colors)
    )
    assert alpha is not None
    return ShadowImage(image.width_px, image.height_px, image.color, alpha, image.box, colors)
