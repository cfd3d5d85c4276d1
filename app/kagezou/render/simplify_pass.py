"""The pass that simplifies: the united shadow is blurred on its receiver and brought back to its area (paper 3.6.1)."""

from dataclasses import dataclass, replace
from math import ceil

import numpy as np

from kagezou.geometry.bands import FINEST_SIGMA_PX, SHARP_SIGMA_PX, Blur, Extent, bands_of
from kagezou.geometry.box import Box
from kagezou.geometry.contact import contact_plane
from kagezou.geometry.ground import Plane, canvas_from_plane
from kagezou.geometry.polygon import bounding_box, box_polygon, clipped, distance_form, seen_rectangle, shifted
from kagezou.geometry.shadow import cast_card
from kagezou.geometry.vectors import Matrix
from kagezou.render.atlas import Strip, laid_out
from kagezou.render.boxes import Boxes
from kagezou.render.cast_pass import CastPass, Window
from kagezou.render.cast_uniforms import Frame, Grazing
from kagezou.render.gl import GL
from kagezou.render.level import Counted, area_preserving_level
from kagezou.render.level import Floats as Texels
from kagezou.render.mattes import PlacedMatte
from kagezou.render.outline import outline_tiles
from kagezou.render.program import Uniform, Variants
from kagezou.render.targets import LAST_LEVEL, Format, Target
from kagezou.render.tiles import CELLS
from kagezou.render.tiles import Boxes as TileBoxes
from kagezou.scene.scene import ShadowCast

LARGEST_PLANE_PX = 8192
"""A shadow that runs out further than this on its receiver is cut off there."""

_MAX_BANDS = 20
_MARGIN_TEXELS = 2
_LEAST_SIGMA_TEXELS = 0.3
_REACHES = (8, 16, 32, 48, 64, 96, 128, 192, 256, 384, 512, 1024, 2048)
"""Over how many texels either way a blur may be summed up; each is a program of its own."""

_ALONG_V, _ALONG_U = frozenset({"ALONG_V"}), frozenset({"ALONG_U"})


@dataclass(frozen=True, slots=True, eq=False)
class _Job:
    """A cast on one receiver, how it is blurred, and the strips it is blurred in."""

    cast: ShadowCast
    matte: PlacedMatte
    plane: Plane
    blur: Blur
    strips: tuple[Strip, ...]

    @property
    def canvas_from_plane(self) -> Matrix:
        """The (3, 3) map from (u, v) of the receiver to canvas px."""
        return canvas_from_plane(self.cast.camera, self.plane)


class SimplifyPass:
    """Draws simplified shadows, of shadows that another pass casts for it."""

    def __init__(self, boxes: Boxes, caster: CastPass) -> None:
        self._boxes = boxes
        self._caster = caster
        self._blur = Variants("box.vert", "blur.frag")
        self._show = Variants("box.vert", "simplify.frag")
        self._fill = Variants("box.vert", "full.frag")
        self._atlases: tuple[Target, Target, Target] | None = None
        self._sharp: Target | None = None

    def draw(self, cast: ShadowCast, matte: PlacedMatte | None, target: Target, old: Box | None) -> Box | None:
        """Draw into ``target``, clearing ``old``; return the box that may hold shadow, None for none."""
        if old is not None:
            target.clear(old)
        if matte is None or cast.simplify is None:
            return None
        blur = Blur(cast.simplify.amount_px, cast.simplify.distance_px)
        drawn: Box | None = None
        for receiver in cast.receivers:
            one = replace(cast, receivers=(receiver,), simplify=None)
            plane = contact_plane(cast.card, receiver)
            extent = _extent(one, matte, plane)
            if extent is None:
                continue
            job = _Job(one, matte, plane, blur, laid_out(bands_of(blur, extent)))
            box = self._draw_one(job, target)
            if box is not None:
                drawn = box if drawn is None else drawn.union(box)
        return drawn

    def close(self) -> None:
        """Give the memory back."""
        self._blur.close()
        self._show.close()
        self._fill.close()
        for target in (*(self._atlases or ()), self._sharp):
            if target is not None:
                target.close()

    def _draw_one(self, job: _Job, target: Target) -> Box | None:
        shadow, half, blurred = self._atlases_for(job.strips)
        sharp_box = self._cast_sharp(job, target)
        used = Box(0, 0, max((s.box.right for s in job.strips), default=0), sum(s.box.height for s in job.strips))
        shadow.clear(used)
        for strip in job.strips:
            canvas_from_atlas = job.canvas_from_plane @ strip.plane_from_atlas
            # The shape alone is simplified; how strong it is under a low light is told where it is shown.
            window = Window(strip.box, canvas_from_atlas, _cells_at(strip.band.level), is_shape_only=True)
            self._caster.unite(job.cast, job.matte, shadow, window)
        # All strips are read at once: each reading waits for everything drawn before it.
        before = shadow.read_floats(used)
        self._blur_strips(job, (shadow, half), _ALONG_V)
        self._blur_strips(job, (half, blurred), _ALONG_U)
        after = blurred.read_floats(used)
        counted = [_counted(strip, before, after) for strip in job.strips]
        level = area_preserving_level(counted)
        box = self._box_of(job, target.box, sharp_box)
        if box is not None:
            pairs = [(strip, each.blurred) for strip, each in zip(job.strips, counted, strict=True)]
            full, outline = outline_tiles(pairs, level, job.blur, _inverse(job.canvas_from_plane), box)
            self._show_tiles(job, target, box, (full, outline), level)
        return box

    def _cast_sharp(self, job: _Job, like: Target) -> Box | None:
        """Cast the shadow as it is, for where it stays so; return its box."""
        if self._sharp is not None and self._sharp.box != like.box:
            self._sharp.close()
            self._sharp = None
        if self._sharp is None:
            self._sharp = Target(like.box.width, like.box.height, Format.ALPHA16)
        self._sharp.clear()
        if job.blur.distance_px <= 0 and job.blur.amount_px >= FINEST_SIGMA_PX:
            return None
        return self._caster.unite(job.cast, job.matte, self._sharp, Window(like.box, is_shape_only=True))

    def _blur_strips(self, job: _Job, way: tuple[Target, Target], direction: frozenset[str]) -> None:
        """Blur every strip from one atlas into the other: first across the contact line, then along it."""
        source, goal = way
        for strip in job.strips:
            reach = next(each for each in _REACHES if each >= min(ceil(strip.band.reach_texels), _REACHES[-1]))
            program = self._blur[direction | {f"REACH {reach}"}]
            known = strip.box if direction == _ALONG_V else strip.shown
            goal.bind(strip.shown)
            source.texture.bind(0)
            program.use(
                {
                    "u_target_size_px": goal.size_px,
                    "u_source": 0,
                    "u_band": (float(known.left), float(known.top), float(known.right - 1), float(known.bottom - 1)),
                    "u_first_v_px": strip.band.needed.low,
                    "u_first_row": float(strip.box.top),
                    "u_texel_px": strip.band.texel_px,
                    "u_amount_px": job.blur.amount_px,
                    "u_distance_px": job.blur.distance_px,
                    "u_least_sigma": _LEAST_SIGMA_TEXELS,
                }
            )
            self._boxes.draw_one(strip.shown)

    def _box_of(self, job: _Job, canvas: Box, sharp_box: Box | None) -> Box | None:
        """Return the box of the canvas in which the simplified shadow can be seen."""
        plane_from_canvas = _inverse(job.canvas_from_plane)
        box = sharp_box
        for strip in job.strips:
            core = strip.band.core
            polygon = seen_rectangle(canvas, plane_from_canvas, (core.left, core.low), (core.right, core.high))
            seen = bounding_box(polygon)
            if seen is not None:
                box = seen if box is None else box.union(seen)
        return None if box is None else box.intersection(canvas)

    def _show_tiles(
        self, job: _Job, target: Target, box: Box, tiles: tuple[TileBoxes, TileBoxes], level: float
    ) -> None:
        """Draw the tiles within the shape, and those its outline crosses, as strong as the light makes them."""
        assert self._sharp is not None
        full, outline = tiles
        switches, common = _strength(job, box)
        common["u_target_size_px"] = target.size_px
        target.bind()
        GL.glEnable(GL.GL_BLEND)
        GL.glBlendEquation(GL.GL_MAX)
        if len(full):
            self._fill[switches].use(common)
            self._boxes.draw(full)
        if len(outline):
            self._atlases_for(job.strips)[2].texture.bind(0)
            self._sharp.texture.bind(1)
            self._show[switches].use(common | _show_uniforms(job, box, level))
            self._boxes.draw(outline)

    def _atlases_for(self, strips: tuple[Strip, ...]) -> tuple[Target, Target, Target]:
        """Return targets of at least the strips' size: for the shadow, and for it blurred one way and both ways.

        A wide blur of a small shadow leaves values so small that only floating point keeps them apart.
        """
        width = max((strip.box.right for strip in strips), default=1)
        height = max((strip.box.bottom for strip in strips), default=1)
        old = self._atlases
        if old is None or old[0].box.width < width or old[0].box.height < height:
            for target in old or ():
                target.close()
            forms = (Format.ALPHA16, Format.FLOAT, Format.FLOAT)
            shadow, half, blurred = (Target(width, height, form) for form in forms)
            self._atlases = (shadow, half, blurred)
        assert self._atlases is not None
        return self._atlases


def _frame(job: _Job, box: Box) -> Frame:
    """Return the part of a canvas box in which the receiver is seen."""
    lift = _inverse(job.canvas_from_plane)
    return Frame(clipped(box_polygon(box), shifted(distance_form(lift[2]), -0.01)))


def _strength(job: _Job, box: Box) -> tuple[frozenset[str], dict[str, Uniform]]:
    """Return switches and uniforms of ``grazing.glsl``; the lights of one cast stand too close to differ in it."""
    receiver, light = job.cast.receivers[0], job.cast.lights[0]
    frame = _frame(job, box)
    grazing = Grazing.of(receiver, light)
    receiver_from_canvas = _inverse(canvas_from_plane(job.cast.camera, receiver))
    uniforms: dict[str, Uniform] = {"u_origin_px": frame.origin}
    return grazing.switches(receiver_from_canvas, frame), uniforms | grazing.uniforms(receiver_from_canvas, frame)


def _show_uniforms(job: _Job, box: Box, level: float) -> dict[str, Uniform]:
    """Return what ``simplify.frag`` wants but for the light's strength."""
    plane_from_pixel = _inverse(job.canvas_from_plane) @ _frame(job, box).canvas_from_pixel
    return {
        "u_blurred": 0,
        "u_sharp": 1,
        "u_plane_from_pixel": plane_from_pixel / np.abs(plane_from_pixel[2]).max(),
        "u_level": level,
        "u_amount_px": job.blur.amount_px,
        "u_distance_px": job.blur.distance_px,
        "u_pass_over_px": (SHARP_SIGMA_PX, FINEST_SIGMA_PX),
        **_band_uniforms(job.strips, whole=job.blur.distance_px <= 0),
    }


def _cells_at(level: int) -> int:
    """Return into how many cells a texel of a level may be split.

    Coarse texels, to be blurred anyway, are means of few cells; where squares of the matte's coarsest mipmap no longer
    fill a cell there have to be more of them again.
    """
    return CELLS[-1] if level < 2 else min(max(16, 1 << max(level - LAST_LEVEL + 3, 0)), CELLS[-1])


def _counted(strip: Strip, before: Texels, after: Texels) -> Counted:
    shown = strip.shown
    part = (slice(shown.top, shown.bottom), slice(shown.left, shown.right))
    return Counted(before[part], after[part], strip.row_areas(_MARGIN_TEXELS), _MARGIN_TEXELS)


def _extent(cast: ShadowCast, matte: PlacedMatte, plane: Plane) -> Extent | None:
    """Return where on a plane a cast's shadow lies, None where there is none."""
    limit = Box(-LARGEST_PLANE_PX, -LARGEST_PLANE_PX, LARGEST_PLANE_PX, LARGEST_PLANE_PX)
    around: Box | None = None
    seen_from_above = canvas_from_plane(cast.camera, plane)
    for light in cast.lights:
        for each in cast_card(cast.camera, cast.receivers[0], cast.card, light):
            box = bounding_box(each.seen_through(seen_from_above).region(limit, matte.box))
            if box is not None:
                around = box if around is None else around.union(box)
    return None if around is None else Extent(around.left, around.top, around.right, around.bottom)


def _inverse(canvas_from_plane: Matrix) -> Matrix:
    """Return the map back, its w positive where the plane is seen."""
    return np.asarray(np.linalg.inv(canvas_from_plane))


def _band_uniforms(strips: tuple[Strip, ...], *, whole: bool) -> dict[str, Uniform]:
    """Return the arrays of ``simplify.frag``."""
    cores, places, sizes = (np.zeros((_MAX_BANDS, 4)) for _ in range(3))
    for index, strip in enumerate(strips):
        core, shown = strip.band.core, strip.shown
        ends = sorted((abs(core.low), abs(core.high)))
        side = 0.0 if whole else (1.0 if core.high > 0 else -1.0)
        texel = strip.band.texel_px
        corner = strip.plane_from_atlas @ np.array([shown.left, shown.top, 1.0])
        cores[index] = (ends[0], ends[1], side, texel)
        places[index] = (corner[0], corner[1], shown.left, shown.top)
        sizes[index] = (shown.width, shown.height, 0.0, 0.0)
    return {"u_band_count": len(strips), "u_cores": cores, "u_places": places, "u_sizes": sizes}
