"""Several shadows of different looks as one layer."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.box import Box
from kagezou.io.images.writing import ShadowImage


def mixed(images: Sequence[ShadowImage], *, multiply: bool) -> ShadowImage:
    """Return one layer that does to what is under it what shadows do one after the other.

    Parameters
    ----------
    images
        At least one, of one size and depth, from the lowest up; those without any pixels change nothing.
    multiply
        Whether they multiply what is under them; else they lie over it.
    """
    first, full = images[0], np.iinfo(images[0].alpha.dtype).max
    seen = [image for image in images if not image.box.is_empty]
    if len(seen) < 2:
        return seen[0] if seen else first
    box = Box(
        min(image.box.left for image in seen),
        min(image.box.top for image in seen),
        max(image.box.right for image in seen),
        max(image.box.bottom for image in seen),
    )
    # What is left of white paper under it, and how much of the paper is seen at all.
    paper = np.ones((box.height, box.width, 3))
    clear = np.ones((box.height, box.width, 1))
    for image in seen:
        alpha = _alpha_on(box, image)
        color = np.array(image.color) / 255
        paper = paper * (1 - alpha + alpha * color) if multiply else paper * (1 - alpha) + alpha * color
        clear = clear * (1 - alpha)
    covered = 1 - clear
    color = np.where(covered > 0, (paper - clear) / np.where(covered > 0, covered, 1), np.array(first.color) / 255)
    steps = (np.rint(np.clip(each, 0, 1) * full).astype(first.alpha.dtype) for each in (covered[..., 0], color))
    return ShadowImage(first.width_px, first.height_px, first.color, next(steps), box, next(steps))


def _alpha_on(box: Box, image: ShadowImage) -> NDArray[np.float64]:
    """Return the alpha of an image, (h, w, 1) of a larger box, 0 to 1."""
    alpha = np.zeros((box.height, box.width, 1))
    own = image.box.moved(-box.left, -box.top)
    alpha[own.top : own.bottom, own.left : own.right, 0] = image.alpha / np.iinfo(image.alpha.dtype).max
    return alpha
