"""What is to be filtered: a cast, the coordinates it is blurred in, and how; and what a receiver shows of it."""

from dataclasses import dataclass, replace
from math import ceil, isfinite

import numpy as np

from kagezou.geometry.bands import FINEST_SIGMA_PX, REACH_SIGMAS, Blur, Extent
from kagezou.geometry.box import Box
from kagezou.geometry.ground import Plane, canvas_from_plane
from kagezou.geometry.polygon import bounding_box
from kagezou.geometry.sets.laid_flat import FLAT, GROUND, Development, Join, narrowest
from kagezou.geometry.vectors import Matrix
from kagezou.render.prepare.band_atlas import Strip
from kagezou.render.prepare.matte_on_canvas import MatteOnCanvas
from kagezou.scene.scene import ShadowCast

LARGEST_PLANE_PX = 8192
"""A shadow that runs out further than this on its receiver is cut off there."""

RAMP = 0.75
"""How much of its width a soft edge takes up on either side."""

_EDGE_SIGMAS = 2.5
"""How many standard deviations of its own blur an edge may be away from the outline."""

_STEP_PX = 16.0

_FULL_AT_ONCE = 2.5
"""Already half a px of growth, softness or waves has the finest blur, so that nothing of the sharp shadow is left."""


GROUND_CHART = 0
"""The number of the chart that shows the ground alone."""

_BEYOND_SIGMAS = 2.5
"""How far, in standard deviations of its blur, a face that is laid flat goes on beyond its free edges."""


@dataclass(frozen=True, slots=True, eq=False)
class Chart:
    """A picture of the flat shadow: the ground, with some faces of a set laid over it.

    Parameters
    ----------
    extent
        The part that is known, in u and v of the blur.
    strips
        Those of the atlas that it is blurred in.
    number
        Of the development.
    """

    extent: Extent
    strips: tuple[Strip, ...]
    number: int = GROUND_CHART


@dataclass(frozen=True, slots=True, eq=False)
class FilterJob:
    """A cast on one receiver and on what is laid flat beside it, how it is blurred, and on which charts.

    The blur is round in coordinates of its own: u along the contact line and v away from it, for an elongated one
    stretched and sheared so that v alone still says how far from the line a place is.

    Parameters
    ----------
    cast
        With one receiver.
    plane
        The receiver with its u axis along the contact line.
    ground_from_blurred
        (2, 2): u and v of ``plane`` from those of the blur, its lower left corner 0.
    extent
        Where the shadow lies on the receiver alone, in u and v of the blur.
    charts
        The receiver alone, then those with ``development``'s sheets.
    slide
        How much farther in u and v of the blur a place of the receiver is read, px; known when the shape is.
    """

    cast: ShadowCast
    matte: MatteOnCanvas
    plane: Plane
    ground_from_blurred: Matrix
    extent: Extent
    blur: Blur
    charts: tuple[Chart, ...] = ()
    development: Development = FLAT
    slide: tuple[float, float] = (0.0, 0.0)

    @property
    def strips(self) -> tuple[Strip, ...]:
        """Those of all charts."""
        return tuple(strip for chart in self.charts for strip in chart.strips)

    def bands_of(self, chart: int) -> tuple[int, int]:
        """Return the number of a chart's first strip, and of the one behind its last."""
        first = sum(len(each.strips) for each in self.charts[:chart])
        return first, first + len(self.charts[chart].strips)

    @property
    def canvas_from_plane(self) -> Matrix:
        """The (3, 3) map from (u, v) of the blur to canvas px."""
        return stretched(canvas_from_plane(self.cast.camera, self.plane), self.ground_from_blurred)

    @property
    def canvas_from_read(self) -> Matrix:
        """The (3, 3) map from (u, v) of the blur to where on the canvas what is there is seen: slid to the feet."""
        return self.slid(self.canvas_from_plane)

    def slid(self, from_blurred: Matrix) -> Matrix:
        """Return a map from (u, v, 1) of the blur for what is read there, which is seen that much nearer."""
        back = np.eye(3)
        back[:2, 2] = (-self.slide[0], -self.slide[1])
        return np.asarray(from_blurred @ back)

    @property
    def receiver_from_blurred(self) -> Matrix:
        """The (2, 3) map from (u, v, 1) of the blur to the receiver's own (u, v), where what is read there is seen."""
        receiver, plane = self.cast.receivers[0], self.plane
        axes = np.array([receiver.u, receiver.v])
        turn = axes @ np.array([plane.u, plane.v]).T
        shift = axes @ (np.array(plane.origin) - np.array(receiver.origin))
        return self.slid(np.column_stack([turn @ self.ground_from_blurred, shift]))

    @property
    def heave(self) -> Matrix:
        """The (2, 2) map from a displacement on the receiver to one in u and v of the blur."""
        return np.asarray(np.linalg.inv(self.receiver_from_blurred[:, :2]))

    @property
    def moved_px(self) -> tuple[float, float]:
        """How far waves may move a place, in u and v of the blur."""
        if self.cast.water is None:
            return (0.0, 0.0)
        moved = np.zeros(2)
        for ripple in self.cast.water.ripples:
            from_circle = self.heave @ np.reshape(ripple.wave.matrix, (2, 2)).T
            moved += np.hypot(*from_circle.T) * ripple.wave.amplitude_px
        return (float(moved[0]), float(moved[1]))

    @property
    def edge_deviations(self) -> float:
        """How many standard deviations of the blur the edge reaches from the outline."""
        edge = self.cast.edge
        if edge is None:
            return 0.0
        scale = float(self.ground_from_blurred[1, 1])
        farthest = max(max(abs(chart.extent.low), abs(chart.extent.high)) for chart in self.charts)
        # The narrowest blur of what is blurred at all, its kink, and the far end.
        places = (self.blur.distance_of(FINEST_SIGMA_PX), self.blur.distance_px, farthest)
        return max(
            (RAMP * (edge.softness_px + edge.penumbra * scale * v) + abs(edge.grow_px)) / self.blur.sigma_at(v)
            for v in places
            if isfinite(v) and self.blur.sigma_at(v) > 0
        )


def beyond_of(job: FilterJob, chart: Chart) -> float:
    """Return how far a face that is laid flat goes on beyond its free edges: as far as it is felt, px."""
    farthest = max(abs(chart.extent.low), abs(chart.extent.high))
    beyond = _BEYOND_SIGMAS * job.blur.sigma_at(farthest) * float(np.abs(job.ground_from_blurred).max()) + 2.0
    # In steps, so that what is known of a set laid flat holds while a light is dragged.
    return ceil(beyond / _STEP_PX) * _STEP_PX


@dataclass(frozen=True, slots=True, eq=False)
class BlurView:
    """What one receiver shows of a job.

    Parameters
    ----------
    receiver
        The ground, or a face that is laid flat.
    canvas_from_blurred
        (3, 3): from (u, v) of the blur to the canvas.
    box
        Where on the canvas it may be seen.
    chart
        The one it is looked up on.
    joins
        Where it passes over into others.
    is_silhouette
        Whether it is no receiver that is drawn, but the silhouette that casts the shadow, which no light weakens.
    """

    job: FilterJob
    receiver: Plane
    canvas_from_blurred: Matrix
    box: Box
    chart: int = 0
    joins: tuple[Join, ...] = ()
    is_silhouette: bool = False

    @staticmethod
    def of_ground(job: FilterJob, box: Box) -> "BlurView":
        """Return what the job's receiver itself shows."""
        return BlurView(job, job.cast.receivers[0], job.canvas_from_read, box, 0, job.development.joins_of(GROUND))

    @staticmethod
    def of_sheet(job: FilterJob, number: int, box: Box) -> "BlurView":
        """Return what a face that is laid flat shows."""
        sheet = job.development.sheets[number]
        canvas_from_flat = canvas_from_plane(job.cast.camera, sheet.face.plane) @ np.linalg.inv(sheet.flat_from_plane)
        on_canvas = job.slid(stretched(canvas_from_flat, job.ground_from_blurred))
        return BlurView(job, sheet.face.plane, on_canvas, box, sheet.chart, job.development.joins_of(number))

    @property
    def cast(self) -> ShadowCast:
        """That of the job, on this receiver."""
        return replace(self.job.cast, receivers=(self.receiver,))

    @property
    def strips(self) -> tuple[Strip, ...]:
        """Those of its chart."""
        return self.job.charts[self.chart].strips

    @property
    def blurred_from_canvas(self) -> Matrix:
        """The map back, its w positive where the receiver is seen."""
        return np.asarray(np.linalg.inv(self.canvas_from_blurred))

    def there_from_here(self, join: Join) -> Matrix:
        """Return the (3, 3) map of a join in u and v of the blur."""
        stretch = np.eye(3)
        stretch[:2, :2] = self.job.ground_from_blurred
        return np.asarray(np.linalg.inv(stretch) @ join.there_from_here @ stretch)

    def seam_of(self, join: Join) -> Matrix:
        """Return the ends (2, 2) of a join in u and v of the blur, where what is seen there is read."""
        return np.asarray(join.seam @ np.linalg.inv(self.job.ground_from_blurred).T + self.job.slide)

    def reach_of(self, join: Join) -> float:
        """Return how far from its seam a join is felt: as far as the blur reaches there, px of the blur.

        Where paper is cut, no farther than half of the face: the other chart knows less of it than its own.
        """
        reach = REACH_SIGMAS * max(self.job.blur.sigma_at(float(v)) for v in self.seam_of(join)[:, 1]) + 2.0
        if join.most == 1 or join.sheet == GROUND:
            return reach
        return min(reach, narrowest(self.job.development.sheets[join.sheet].corners) / 2 + 2.0)


def stretched(canvas_from_plane: Matrix, ground_from_blurred: Matrix) -> Matrix:
    """Return the (3, 3) map from (u, v) of a blur to the canvas."""
    whole = np.eye(3)
    whole[:2, :2] = ground_from_blurred
    return np.asarray(canvas_from_plane @ whole)


def blur_of(cast: ShadowCast, away_scale: float) -> Blur:
    """Return the blur that simplifying, edges and waves need together.

    Parameters
    ----------
    away_scale
        How many px of the receiver one px of v is.
    """
    amount = 0.0 if cast.simplify is None else cast.simplify.amount_px
    distance = 0.0 if cast.simplify is None else cast.simplify.distance_px / away_scale
    width = slope = grow = moved = 0.0
    if cast.edge is not None:
        width, grow = cast.edge.softness_px, abs(cast.edge.grow_px)
        slope = RAMP * cast.edge.penumbra / _EDGE_SIGMAS * away_scale
    if cast.water is not None:
        moved = cast.water.reach_px
    needed = (RAMP * width + grow) / _EDGE_SIGMAS
    finest = min(FINEST_SIGMA_PX, _FULL_AT_ONCE * (width + grow + moved))
    return Blur(amount, distance, max(needed, finest), slope if slope > 1e-6 else 0.0)


def extent_of(cast: ShadowCast, matte: MatteOnCanvas, canvas_from_blurred: Matrix) -> Extent | None:
    """Return where on its receiver a cast's shadow lies, in (u, v) of the blur; None where there is none."""
    limit = Box(-LARGEST_PLANE_PX, -LARGEST_PLANE_PX, LARGEST_PLANE_PX, LARGEST_PLANE_PX)
    around: Box | None = None
    for light in cast.lights:
        for each in cast.on(cast.receivers[0], light):
            box = bounding_box(each.seen_through(canvas_from_blurred).region(limit, matte.box))
            if box is not None:
                around = box if around is None else around.union(box)
    return None if around is None else Extent(around.left, around.top, around.right, around.bottom)
