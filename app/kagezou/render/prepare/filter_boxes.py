"""Where on the canvas a filtered shadow may be seen, and which of its values are surely shadow or surely none."""

from statistics import NormalDist

from kagezou.geometry.bands import FINEST_SIGMA_PX
from kagezou.geometry.box import Box, around
from kagezou.geometry.polygon import bounding_box, seen_rectangle
from kagezou.render.prepare.filter_job import LARGEST_PLANE_PX, BlurView, FilterJob
from kagezou.render.prepare.outline_tiles import Reach

_FAINT = 1e-5
_SAFELY, _SAFELY_BESIDES = 1.15, 0.05
"""By how much an edge is taken for wider than it is, as the width of the blur changes over the receiver."""


def sure_values(job: FilterJob, level: float) -> Reach:
    """Return which values are surely no shadow and which surely nothing else.

    No blurred shape changes faster than a straight edge does: counted by the inverse normal distribution, a value so
    many standard deviations from the level is at least as far from the outline.
    """
    if job.cast.edge is None:
        return Reach(level, level, job.moved_px)
    normal, deviations = NormalDist(), job.edge_deviations * _SAFELY + _SAFELY_BESIDES
    middle = normal.inv_cdf(min(max(level, _FAINT), 1 - _FAINT))
    return Reach(normal.cdf(middle - deviations), normal.cdf(middle + deviations), job.moved_px)


def box_near_contact(view: BlurView) -> Box | None:
    """Return where on the canvas the shadow is not wholly blurred."""
    blur, extent = view.job.blur, view.job.charts[view.chart].extent
    if blur.sigma_at(0.0) >= FINEST_SIGMA_PX:
        return None
    away = min(blur.distance_of(FINEST_SIGMA_PX), LARGEST_PLANE_PX)
    low, high = max(extent.low, -away), min(extent.high, away)
    if low >= high:
        return None
    seen = bounding_box(seen_rectangle(view.box, view.blurred_from_canvas, (extent.left, low), (extent.right, high)))
    return None if seen is None else seen.grown(1).intersection(view.box)


def box_seen(view: BlurView, sharp_box: Box | None) -> Box | None:
    """Return the box of the canvas in which a receiver's part of the shadow can be seen."""
    if any(join.most < 1 for join in view.joins):
        return view.box
    u, v = view.job.moved_px
    box = sharp_box
    charts = {view.chart, *(join.chart for join in view.joins)}
    cores = [strip.band.core for chart in charts for strip in view.job.charts[chart].strips]
    if cores:
        low = (min(core.left for core in cores) - u, min(core.low for core in cores) - v)
        high = (max(core.right for core in cores) + u, max(core.high for core in cores) + v)
        box = around(box, bounding_box(seen_rectangle(view.box, view.blurred_from_canvas, low, high)))
    return None if box is None else box.intersection(view.box)
