"""What the shaders that fill and blur all strips of a job at once want to know of each of them."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.box import Box
from kagezou.render.prepare.band_atlas import Strip
from kagezou.render.prepare.cast_parts import steps_to
from kagezou.render.prepare.filter_job import Chart, FilterJob
from kagezou.render.prepare.filter_uniforms import MAX_BANDS, Uniforms, width_uniforms
from kagezou.render.prepare.shadow_levels import ShadowLevels, variance_of

if TYPE_CHECKING:
    from kagezou.render.prepare.sheet_slots import SheetSlot

STRIPS = frozenset({f"STRIPS {MAX_BANDS}"})

_SPLINE_VARIANCE = 1 / 3
"""The variance of a cubic B-spline, texels squared."""

_SPREAD_TEXELS = 2
"""How far what halving has spread of a shadow may lie beyond it."""

Boxes = NDArray[np.float64]


def crop_uniforms(levels: ShadowLevels, strips: Sequence[Strip]) -> Uniforms:
    """Return the arrays of ``passes/crop.frag`` for the strips of one chart."""
    shifts, pictures = (np.zeros((MAX_BANDS, 4)) for _ in range(2))
    for index, strip in enumerate(strips):
        level, needed = strip.band.level, strip.band.needed
        picture, texel = levels.box_of(level), strip.band.texel_px
        first = (round(needed.left / texel), round(needed.low / texel))
        own, place = (picture.left, picture.top), (strip.box.left, strip.box.top)
        for axis, corner in enumerate(levels.corner_of(level)):
            shifts[index, axis] = first[axis] - corner + own[axis] - place[axis]
        pictures[index] = (picture.left, picture.top, picture.right - 1, picture.bottom - 1)
    return {"u_shifts": shifts, "u_pictures": pictures}


def slot_uniforms(slots: "Sequence[SheetSlot]") -> Uniforms:
    """Return the arrays of ``passes/crop.frag`` for sheets that were cast aside."""
    shifts, pictures = (np.zeros((MAX_BANDS, 4)) for _ in range(2))
    for index, slot in enumerate(slots):
        shifts[index, :2] = slot.shift
        pictures[index] = (slot.box.left, slot.box.top, slot.box.right - 1, slot.box.bottom - 1)
    return {"u_shifts": shifts, "u_pictures": pictures}


def blur_uniforms(job: FilterJob) -> Uniforms:
    """Return what ``passes/blur.frag`` wants."""
    told, ranges = (np.zeros((MAX_BANDS, 4)) for _ in range(2))
    index = 0
    for chart in job.charts:
        steps = steps_to(chart)
        for strip in chart.strips:
            band, box = strip.band, strip.box
            taken = variance_of(steps[strip]) + _SPLINE_VARIANCE
            told[index] = (band.needed.low, box.top, band.texel_px, taken)
            held = held_box(chart, strip)
            ranges[index] = (held.left, box.top, held.right - 1, box.bottom - 1)
            index += 1
    return {"u_source": 0, "u_strips": told, "u_ranges": ranges, **width_uniforms(job)}


def held_box(chart: Chart, strip: Strip) -> Box:
    """Return the part of a strip's shown texels whose columns may hold shadow."""
    texel, left = strip.band.texel_px, strip.band.needed.left
    first = int((chart.extent.left - left) / texel) - _SPREAD_TEXELS
    last = int((chart.extent.right - left) / texel) + 1 + _SPREAD_TEXELS
    shown = strip.shown
    first, last = max(shown.left + first, shown.left), min(shown.left + last, shown.right)
    return Box(first, shown.top, max(last, first + 1), shown.bottom)


def numbered(boxes: Sequence[Boxes]) -> tuple[Boxes, NDArray[np.int64]]:
    """Return the boxes (N, 4) of all strips together, and the number of the strip of each."""
    counts = [len(each) for each in boxes]
    return np.concatenate(boxes), np.repeat(np.arange(len(boxes)), counts)


def box_array(box: Box) -> Boxes:
    """Return a box as an array (1, 4)."""
    return np.array([[box.left, box.top, box.right, box.bottom]], np.float64)
