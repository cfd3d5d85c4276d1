"""The numbers of a filtered shadow as ``passes/shape.frag`` wants them."""

from functools import lru_cache
from statistics import NormalDist

import numpy as np

from kagezou.geometry.bands import FINEST_SIGMA_PX, SHARP_SIGMA_PX
from kagezou.geometry.box import Box
from kagezou.geometry.ground import canvas_from_plane
from kagezou.geometry.polygon import box_polygon, clipped, distance_form, shifted
from kagezou.geometry.vectors import Matrix
from kagezou.render.prepare.band_atlas import Strip
from kagezou.render.prepare.cast_uniforms import FULL_STRENGTH, Frame, Grazing
from kagezou.render.prepare.filter_job import BlurView, FilterJob
from kagezou.render.prepare.uniforms import Uniform
from kagezou.render.prepare.wave_uniforms import wave_uniforms
from kagezou.scene.filters import Edge

MAX_BANDS = 48
MAX_JOINS = 16
_NONE: frozenset[str] = frozenset()

JOINED = frozenset({"JOINED"})
"""The switch of ``passes/shape.frag`` for what other charts have near seams."""

Uniforms = dict[str, Uniform]


def width_uniforms(job: FilterJob) -> Uniforms:
    """Return what ``passes/blur_width.glsl`` wants."""
    blur = job.blur
    return {
        "u_amount_px": blur.amount_px,
        "u_distance_px": blur.distance_px,
        "u_base_px": blur.base_px,
        "u_slope": blur.slope,
    }


def strength(view: BlurView, box: Box) -> tuple[frozenset[str], Uniforms]:
    """Return switches and uniforms of ``common/grazing.glsl``; the lights of one cast are too close to differ."""
    job, receiver = view.job, view.receiver
    light = job.cast.lights[0]
    frame = _frame(view, box)
    grazing = FULL_STRENGTH if view.is_silhouette else Grazing.of(receiver, light)
    receiver_from_canvas = inverse(canvas_from_plane(job.cast.camera, receiver))
    uniforms: Uniforms = {"u_origin_px": frame.origin}
    return grazing.switches(receiver_from_canvas, frame), uniforms | grazing.uniforms(receiver_from_canvas, frame)


def shape_uniforms(view: BlurView, box: Box, level: float) -> tuple[frozenset[str], Uniforms]:
    """Return the switches and uniforms of ``passes/shape.frag`` but for the light's strength."""
    job = view.job
    uniforms: Uniforms = {
        "u_blurred": 0,
        "u_sharp": 1,
        "u_plane_from_pixel": _plane_from_pixel(view, box),
        "u_pass_over_px": (SHARP_SIGMA_PX, FINEST_SIGMA_PX),
        **width_uniforms(job),
        "u_bands": tuple(float(number) for number in job.bands_of(view.chart)),
        **_band_uniforms(job.strips, whole=job.blur.is_even),
    }
    switches = _NONE
    if view.joins:
        switches |= JOINED
        uniforms |= join_uniforms(view)
    if job.cast.water is not None and job.cast.water.ripples:
        switches |= {"WAVES"}
        anchor = job.cast.water.anchor_px / float(job.ground_from_blurred[1, 1])
        uniforms |= wave_uniforms(job.cast.water, job.receiver_from_blurred, anchor)
    if job.cast.edge is not None:
        switches |= {"EDGE"}
        uniforms |= _edge_uniforms(job, job.cast.edge, level)
    else:
        uniforms["u_level"] = level
    return switches, uniforms


def slit_uniforms(view: BlurView, box: Box) -> tuple[frozenset[str], Uniforms]:
    """Return the switch of the gaps that waves leave open, and what ``common/slits.glsl`` wants; nothing without them.

    Each receiver has them in its own look at the flat shadow: over a seam that is folded they go on, where paper is cut
    they do not.
    """
    water, job = view.job.cast.water, view.job
    if water is None or water.slits is None:
        return _NONE, {}
    slits = water.slits
    along_and_on = np.array(slits.across_from_ground) @ job.receiver_from_blurred
    away = (0.0, float(job.ground_from_blurred[1, 1]), 0.0)
    uniforms: Uniforms = {
        "u_plane_from_pixel": _plane_from_pixel(view, box),
        "u_slits_from_plane": np.vstack([along_and_on, away]),
        "u_slits": (slits.share, slits.spacing_px, slits.growth, slits.clear_px),
        "u_slits_moved": (slits.moved_part, slits.spread),
        "u_slit_rows": (float(slits.first_row), float(slits.rows), float(slits.seed)),
    }
    return frozenset({"SLITS"}), uniforms


def join_uniforms(view: BlurView) -> Uniforms:
    """Return what ``passes/joins.glsl`` wants."""
    seams, bands, turns, shifts = (np.zeros((MAX_JOINS, 4)) for _ in range(4))
    joins = view.joins[:MAX_JOINS]
    for index, join in enumerate(joins):
        seams[index] = view.seam_of(join).ravel()
        bands[index] = (*view.job.bands_of(join.chart), view.reach_of(join), join.most)
        map_there = view.there_from_here(join)
        turns[index] = map_there[:2, :2].ravel()
        shifts[index, :2] = map_there[:2, 2]
    return {
        "u_join_count": len(joins),
        "u_seams": seams,
        "u_join_bands": bands,
        "u_join_turns": turns,
        "u_join_shifts": shifts,
    }


def inverse(matrix: Matrix) -> Matrix:
    """Return the map back; that of a homography has its w positive where it is seen."""
    return np.asarray(np.linalg.inv(matrix), np.float64)


def _frame(view: BlurView, box: Box) -> Frame:
    """Return the part of a canvas box in which the receiver is seen."""
    return Frame(clipped(box_polygon(box), shifted(distance_form(view.blurred_from_canvas[2]), -0.01)))


def _plane_from_pixel(view: BlurView, box: Box) -> Matrix:
    """Return the (3, 3) map from a pixel of the box's frame to (u, v) of the blur."""
    plane_from_pixel = view.blurred_from_canvas @ _frame(view, box).canvas_from_pixel
    return np.asarray(plane_from_pixel / np.abs(plane_from_pixel[2]).max())


def _edge_uniforms(job: FilterJob, edge: Edge, level: float) -> Uniforms:
    """Return what ``passes/wide_edge.glsl`` wants."""
    return {
        "u_softness_px": edge.softness_px,
        "u_penumbra": edge.penumbra * float(job.ground_from_blurred[1, 1]),
        "u_grow_px": edge.grow_px,
        "u_level_deviations": NormalDist().inv_cdf(min(max(level, 1e-5), 1 - 1e-5)),
        "u_blurred_from_ground": inverse(job.ground_from_blurred).ravel(),
    }


@lru_cache(maxsize=4)
def _band_uniforms(strips: tuple[Strip, ...], *, whole: bool) -> Uniforms:
    """Return the arrays of ``passes/shape.frag``, not to be changed; kept, as all receivers of a job want the same."""
    cores, places, sizes = (np.zeros((MAX_BANDS, 4)) for _ in range(3))
    for index, strip in enumerate(strips):
        core, shown = strip.band.core, strip.shown
        ends = sorted((abs(core.low), abs(core.high)))
        side = 0.0 if whole else (1.0 if core.high > 0 else -1.0)
        texel = strip.band.texel_px
        corner = strip.plane_from_atlas @ np.array([shown.left, shown.top, 1.0])
        cores[index] = (ends[0], ends[1], side, texel)
        places[index] = (corner[0], corner[1], shown.left, shown.top)
        sizes[index] = (shown.width, shown.height, 0.0, 0.0)
    return {"u_cores": cores, "u_places": places, "u_sizes": sizes}
