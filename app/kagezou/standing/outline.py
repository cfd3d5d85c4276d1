"""The little that is kept of a drawing to find feet in it: where its figure ends below."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.box import Box

_THICK = 4  # of the figure's height, the part below: more than a foot


@dataclass(frozen=True, eq=False, slots=True)
class Outline:
    """The lower edge of a drawing's figure.

    Attributes
    ----------
    box
        The smallest box that holds every solid pixel (alpha of one half or more), drawing px.
    lower
        (box.width,) ``int32``, read-only: for each column of the box the row below its lowest solid pixel, drawing px,
        y down; `box.top` where the column has none.
    thickness
        (box.width,) ``int32``, read-only: how many pixels from the lowest one up are solid one after the other, of
        those in the lowest quarter of the figure; 0 where the column has none there.
    cut_px
        The longest row of solid pixels that touch the lower edge of the drawing.
    """

    box: Box
    lower: NDArray[np.int32]
    thickness: NDArray[np.int32]
    cut_px: int

    @property
    def height_px(self) -> int:
        """The figure's height."""
        return self.box.height


def outline_of(alpha: NDArray[Any], left: int, top: int, drawing_height_px: int) -> Outline | None:
    """Return the outline of a drawing, or None where nothing of it is solid.

    Parameters
    ----------
    alpha
        (H, W) ``uint8`` or ``uint16``: the part of the drawing that holds its figure; the largest number is opaque.
    left, top
        Where that part lies in the drawing, px.
    drawing_height_px
        The whole drawing, px.
    """
    height = alpha.shape[0]
    if not alpha.size:
        return None
    solid = alpha > np.iinfo(alpha.dtype).max // 2
    # A product and a maximum run through memory in its order, which a search down each column would not.
    steps = np.arange(1, height + 1, dtype=np.int32 if height > np.iinfo(np.uint16).max else np.uint16)
    lowest = (solid * steps[:, None]).max(axis=0).astype(np.int32)
    columns = np.flatnonzero(lowest)
    if not columns.size:
        return None
    first, last = int(columns[0]), int(columns[-1]) + 1
    upper = int(np.flatnonzero(solid.any(axis=1))[0])
    lower = np.maximum(lowest[first:last], upper) + np.int32(top)
    lower.setflags(write=False)
    box = Box(left + first, top + upper, left + last, int(lower.max()))
    thickness = _thickness(solid[: int(lowest.max()), first:last][-max(1, box.height // _THICK) :])
    return Outline(box, lower, thickness, longest_run(lower == drawing_height_px))


def _thickness(solid: NDArray[np.bool_]) -> NDArray[np.int32]:
    """Return (W,) how many of ``solid`` (H, W) are true one after the other from the lowest one of each column up."""
    rows = np.arange(1, solid.shape[0] + 1, dtype=np.int32)[:, None]
    lowest = (solid * rows).max(axis=0)
    over = (~solid & (rows < lowest)) * rows
    thickness: NDArray[np.int32] = lowest - over.max(axis=0)
    thickness.setflags(write=False)
    return thickness


def longest_run(flags: NDArray[np.bool_]) -> int:
    """Return how many of ``flags`` (N,) are true one after the other at most."""
    ends = np.flatnonzero(np.diff(flags, prepend=False, append=False))
    return int((ends[1::2] - ends[::2]).max(initial=0))
