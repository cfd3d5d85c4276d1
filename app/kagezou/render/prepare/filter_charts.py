"""The charts of a job: which faces of a set its shadow reaches, laid flat, and how much of each picture is known."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.bands import REACH_SIGMAS, Band, Blur, Extent, bands_of, felt_by
from kagezou.geometry.ground import canvas_from_plane
from kagezou.geometry.sets.laid_flat import GROUND, FlatFace, FlatSheet, Join, lines_of, moved
from kagezou.geometry.vectors import Matrix, height_over
from kagezou.render.prepare.band_atlas import Strip, laid_out
from kagezou.render.prepare.filter_job import BlurView, Chart, FilterJob, beyond_of, extent_of
from kagezou.render.prepare.filter_uniforms import MAX_BANDS, inverse
from kagezou.render.prepare.matte_on_canvas import MatteOnCanvas
from kagezou.scene.scene import ShadowCast

if TYPE_CHECKING:  # what sets are made of is loaded with the first one
    from kagezou.geometry.sets.bodies import Body, Facet
    from kagezou.geometry.sets.regions import Group

_MOST_CHARTS = 6

_APART = 0.6
"""How far apart faces lie on a chart, as a part of how far they go on beyond their edges."""

_TALLEST_TEXELS = 8192
"""No driver's textures are smaller; under a low light there is room for few charts, or none but the ground's."""

_MARGIN_PX = 4.0


@dataclass(frozen=True, slots=True, eq=False)
class Receivers:
    """The bodies whose faces receive, by their numbers, and what blockers take of the ground, on the canvas."""

    bodies: "dict[int, Body]"
    unlit: "tuple[Group, ...]" = ()


def flat_faces(cast: ShadowCast, receivers: Receivers) -> list[FlatFace]:
    """Return the flat faces that are lit by any light; a sheet's side that the eye sees."""
    if not receivers.bodies:
        return []
    from kagezou.geometry.sets.bodies import Solid

    found: list[FlatFace] = []
    for index, body in receivers.bodies.items():
        if not isinstance(body, Solid):
            continue
        for facet in body.facets:
            is_turned = body.is_sheet and float(np.dot(facet.equation, cast.camera.eye)) < 0
            face = _flat_face(index, facet, is_turned=is_turned)
            if any(height_over(face.plane.equation, light) > 0 for light in cast.lights):
                found.append(face)
    return found


@lru_cache(maxsize=1024)
def _flat_face(index: int, facet: "Facet", *, is_turned: bool) -> FlatFace:
    """Return a facet as a receiver; kept, as what is known of it is."""
    return FlatFace(index, facet.plane(is_turned=is_turned), np.array(facet.corners))


def charted(job: FilterJob, receivers: Receivers) -> FilterJob:
    """Return a job with its charts: the ground alone, and those with the faces that its shadow reaches laid flat."""
    flat = laid_out(bands_of(job.blur, job.extent))
    alone = replace(job, charts=(Chart(job.extent, flat),))
    faces = tuple(face for face in flat_faces(job.cast, receivers) if _is_reached(job, face))
    if not faces:
        return alone
    from kagezou.geometry.sets.unfolding import unfolded

    for most in range(_MOST_CHARTS, 1, -1):
        development = unfolded(job.plane, faces, most, _APART * beyond_of(job, alone.charts[0]))
        if len(development.charts) == 1:
            return alone
        job = replace(job, development=development)
        shown = [_shown(job, number) for number in range(1, len(development.charts))]
        extents = [job.extent, *(felt_by(job.blur, each) for each in shown)]
        seen = (None, *((each.low, each.high) for each in shown))
        bands = [bands_of(job.blur, extent, part) for extent, part in zip(extents, seen, strict=True)]
        strips = laid_out(band for each in bands for band in each)
        if strips and len(strips) <= MAX_BANDS and strips[-1].box.bottom <= _TALLEST_TEXELS:
            return replace(job, charts=tuple(_split(extents, bands, strips)))
    return alone


def counted_texels(
    job: FilterJob, receivers: Receivers, chart: Chart, strip: Strip, margin: int
) -> NDArray[np.bool_] | None:
    """Return which texels of a strip's shown part, without a margin, belong to the whole unfolded shadow; None for all.

    Of the ground alone what is lit, of every other chart the sheets that are looked up on it.
    """
    if len(job.charts) == 1:
        return None
    shown = strip.shown
    columns = np.arange(shown.left + margin, shown.right - margin) + 0.5
    rows = (np.arange(shown.top + margin, shown.bottom - margin) + 0.5)[:, np.newaxis]
    if chart.number == 0:
        return ~_within(receivers.unlit, _Forms(columns, rows, job.canvas_from_plane @ strip.plane_from_atlas))
    stretch = np.eye(3)
    stretch[:2, :2] = job.ground_from_blurred
    places = _Forms(columns, rows, stretch @ strip.plane_from_atlas)
    result = np.zeros(places.shape, np.bool_)
    for sheet in job.development.sheets:
        if sheet.chart == chart.number and sheet.is_looked_up:
            result |= np.logical_and.reduce([places.of(line) >= 0 for line in _lines_of(sheet)])
    return result


@lru_cache(maxsize=1024)
def _lines_of(sheet: FlatSheet) -> Matrix:
    """Return the sides of a sheet; kept, as they are flat and the light does not move them."""
    return lines_of(sheet.corners)


@dataclass(frozen=True, slots=True, eq=False)
class _Forms:
    """Linear forms of places, asked for all texels of a grid at once.

    Parameters
    ----------
    columns, rows
        (W,) and (H, 1): the texels' middles.
    place_from_texel
        (3, 3).
    """

    columns: NDArray[np.floating]
    rows: NDArray[np.floating]
    place_from_texel: Matrix

    @property
    def shape(self) -> tuple[int, int]:
        """That of the grid, (H, W)."""
        return len(self.rows), len(self.columns)

    def of(self, line: Matrix) -> Matrix:
        """Return line · place of every texel, (H, W)."""
        a, b, c = line @ self.place_from_texel
        return np.asarray(a * self.columns + (b * self.rows + c))


_W = np.array([0.0, 0.0, 1.0])


def _within(groups: "Sequence[Group]", places: _Forms) -> NDArray[np.bool_]:
    """Return which homogeneous canvas places lie within any of some groups."""
    result = np.zeros(places.shape, np.bool_)
    for region in (region for group in groups for region in group.regions):
        inside = places.of(_W) > 0
        for line in region.lines:
            inside &= places.of(line) >= 0
        if region.conic is not None:
            coordinates = np.stack([places.of(axis) for axis in np.eye(3)])
            inside &= np.einsum("ihw,ij,jhw->hw", coordinates, region.conic, coordinates) >= 0
        result |= inside
    return result


def _split(extents: Sequence[Extent], bands: Sequence[tuple[Band, ...]], strips: Sequence[Strip]) -> Iterator[Chart]:
    first = 0
    for number, (extent, each) in enumerate(zip(extents, bands, strict=True)):
        yield Chart(extent, tuple(strips[first : first + len(each)]), number)
        first += len(each)


def _reach(blur: Blur, farthest: float) -> float:
    return REACH_SIGMAS * blur.sigma_at(farthest) + _MARGIN_PX


def _is_reached(job: FilterJob, face: FlatFace) -> bool:
    """Whether the shadow, or its blur, may lie on a face."""
    corners = face.local(face.corners)
    shadow = _shadow_on(job.cast, job.matte, face, np.eye(3))
    if shadow is None:
        return False
    farthest = max(abs(job.extent.low), abs(job.extent.high)) + float(np.ptp(corners, axis=0).sum())
    return _cut(corners, _grown(shadow, _reach(job.blur, farthest))) is not None


def _shadow_on(cast: ShadowCast, matte: MatteOnCanvas, face: FlatFace, plane_from_flat: Matrix) -> Extent | None:
    """Return where the shadow lies on a face's plane."""
    on_canvas = canvas_from_plane(cast.camera, face.plane) @ plane_from_flat
    return extent_of(replace(cast, receivers=(face.plane,)), matte, on_canvas)


def _shown(job: FilterJob, number: int) -> Extent:
    """Return the part of a chart that is looked at: the reached part of its sheets, and near seams what is beside."""
    development = job.development
    stretch = job.ground_from_blurred
    parts: list[Extent] = []
    for index in development.charts[number]:
        sheet = development.sheets[index]
        if sheet.chart != number or not sheet.is_looked_up:
            continue
        view = BlurView.of_sheet(job, index, job.matte.box)
        cast = replace(job.cast, receivers=(view.receiver,))
        corners = sheet.corners @ inverse(stretch).T
        shadow = extent_of(cast, job.matte, view.canvas_from_blurred)
        farthest = float(np.abs(corners[:, 1]).max())
        reached = None if shadow is None else _cut(corners, _grown(shadow, _reach(job.blur, farthest)))
        if reached is not None:
            parts.append(reached)
    parts += filter(None, (_looked_at(job, join) for join in development.joins if join.chart == number))
    if not parts:
        return Extent(0.0, 0.0, 1.0, 1.0)
    u, v = job.moved_px
    return _grown(_around(parts), max(u, v) + _MARGIN_PX)


def _looked_at(job: FilterJob, join: Join) -> Extent | None:
    """Return the part of a join's chart that the receiver looks at near the seam; None where no shadow comes near."""
    if join.sheet == GROUND:
        view, farthest = BlurView.of_ground(job, job.matte.box), max(abs(job.extent.low), abs(job.extent.high))
        whole = _corners_of(_grown(job.extent, _reach(job.blur, farthest)))
    else:
        view = BlurView.of_sheet(job, join.sheet, job.matte.box)
        whole = job.development.sheets[join.sheet].corners @ inverse(job.ground_from_blurred).T
    part = _cut(whole, _grown(_box_of(view.seam_of(join)), view.reach_of(join)))
    return None if part is None else _box_of(moved(view.there_from_here(join), _corners_of(part)))


def _corners_of(extent: Extent) -> Matrix:
    left, low, right, high = extent.left, extent.low, extent.right, extent.high
    return np.array([[left, low], [right, low], [right, high], [left, high]])


def _box_of(places: Matrix) -> Extent:
    (left, low), (right, high) = places.min(axis=0), places.max(axis=0)
    return Extent(float(left), float(low), float(right), float(high))


def _around(parts: Sequence[Extent]) -> Extent:
    return Extent(
        min(each.left for each in parts),
        min(each.low for each in parts),
        max(each.right for each in parts),
        max(each.high for each in parts),
    )


def _grown(extent: Extent, by: float) -> Extent:
    return Extent(extent.left - by, extent.low - by, extent.right + by, extent.high + by)


def _cut(corners: Matrix, extent: Extent) -> Extent | None:
    """Return the part of an extent that the box around corners (N, 2) holds."""
    low, high = corners.min(axis=0), corners.max(axis=0)
    cut = Extent(
        max(extent.left, float(low[0])),
        max(extent.low, float(low[1])),
        min(extent.right, float(high[0])),
        min(extent.high, float(high[1])),
    )
    return cut if cut.right > cut.left and cut.high > cut.low else None
