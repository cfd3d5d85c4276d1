"""The pass that gives a shadow its shape: the united one is blurred on its receiver and brought back to its area.

Simplification (paper 3.6.1), waves (3.6.2) and wide or moved edges all read this one blurred shadow.
"""

from dataclasses import replace
from math import ceil, floor, log2
from statistics import NormalDist

import numpy as np

from kagezou.geometry.bands import FINEST_SIGMA_PX, bands_of
from kagezou.geometry.box import Box
from kagezou.geometry.contact import contact_plane
from kagezou.geometry.ground import canvas_from_plane
from kagezou.geometry.polygon import bounding_box, seen_rectangle
from kagezou.geometry.vectors import Matrix
from kagezou.render.atlas import Strip, laid_out
from kagezou.render.boxes import Boxes
from kagezou.render.cast_pass import CastPass, Window
from kagezou.render.gl import GL
from kagezou.render.level import Counted, area_preserving_level
from kagezou.render.level import Floats as Texels
from kagezou.render.mattes import PlacedMatte
from kagezou.render.outline import Reach, outline_tiles
from kagezou.render.program import Program, Variants
from kagezou.render.shape_job import LARGEST_PLANE_PX, Job, blur_of, elongated, extent_of, stretched
from kagezou.render.shape_uniforms import inverse, shape_uniforms, strength, width_uniforms
from kagezou.render.targets import LAST_LEVEL, Format, Target
from kagezou.render.tiles import CELLS
from kagezou.render.tiles import Boxes as TileBoxes
from kagezou.scene.scene import ShadowCast

_MARGIN_TEXELS = 2
_LEAST_SIGMA_TEXELS = 0.3
_OUTLINED_TEXELS = 64
_FAINT = 1e-5
_SAFELY, _SAFELY_BESIDES = 1.15, 0.05
"""By how much an edge is taken for wider than it is, as the width of the blur changes over the receiver."""

_REACHES = (8, 16, 32, 48, 64, 96, 128, 192, 256, 384, 512, 1024, 2048)
"""Over how many texels either way a blur may be summed up; each is a program of its own."""

_ALONG_V, _ALONG_U = frozenset({"ALONG_V"}), frozenset({"ALONG_U"})


class ShapePass:
    """Draws filtered shadows, of shadows that another pass casts for it."""

    def __init__(self, boxes: Boxes, caster: CastPass) -> None:
        self._boxes = boxes
        self._caster = caster
        self._blur = Variants("box.vert", "blur.frag")
        self._show = Variants("box.vert", "shape.frag")
        self._fill = Variants("box.vert", "full.frag")
        self._reduce = Program("box.vert", "reduce.frag")
        self._whole: Target | None = None
        self._atlases: tuple[Target, Target, Target] | None = None
        self._sharp: Target | None = None
        self._sharp_box: Box | None = None

    def draw(self, cast: ShadowCast, matte: PlacedMatte | None, target: Target, old: Box | None) -> Box | None:
        """Draw into ``target``, clearing ``old``; return the box that may hold shadow, None for none."""
        if old is not None:
            target.clear(old)
        if matte is None or not cast.is_filtered:
            return None
        drawn: Box | None = None
        for receiver in cast.receivers:
            job = self._job(replace(cast, receivers=(receiver,)), matte)
            box = None if job is None else self._draw_one(job, target)
            if box is not None:
                drawn = box if drawn is None else drawn.union(box)
        return drawn

    def close(self) -> None:
        """Give the memory back."""
        self._blur.close()
        self._show.close()
        self._fill.close()
        self._reduce.close()
        for target in (*(self._atlases or ()), self._sharp, self._whole):
            if target is not None:
                target.close()

    def _job(self, cast: ShadowCast, matte: PlacedMatte) -> Job | None:
        """Return what is to be done for a cast on one receiver, None where its shadow falls nowhere."""
        plane = contact_plane(cast.card, cast.receivers[0])
        on_canvas = canvas_from_plane(cast.camera, plane)
        stretch = np.eye(2)
        if cast.simplify is not None and cast.simplify.elongation > 0:
            stretch = elongated(self._outlined(cast, matte, on_canvas), cast.simplify.elongation)
        extent = extent_of(cast, matte, stretched(on_canvas, stretch))
        if extent is None:
            return None
        blur = blur_of(cast, float(stretch[1, 1]))
        return Job(cast, matte, plane, stretch, extent, blur, laid_out(bands_of(blur, extent)))

    def _outlined(self, cast: ShadowCast, matte: PlacedMatte, canvas_from_plane: Matrix) -> Texels:
        """Return the whole shadow on its receiver in few texels, to see how long it is."""
        extent = extent_of(cast, matte, canvas_from_plane)
        if extent is None:
            return np.zeros((0, 0), np.float32)
        texel = max(extent.right - extent.left, extent.high - extent.low) / _OUTLINED_TEXELS
        box = Box(0, 0, *(ceil(side / texel) for side in (extent.right - extent.left, extent.high - extent.low)))
        shadow = self._atlases_of(box.width, box.height)[0]
        shadow.clear(box)
        plane_from_texel = np.array([[texel, 0.0, extent.left], [0.0, texel, extent.low], [0.0, 0.0, 1.0]])
        cells = _cells_at(max(ceil(log2(texel)), 0))
        self._caster.unite(
            cast, matte, shadow, Window(box, canvas_from_plane @ plane_from_texel, cells, is_shape_only=True)
        )
        return shadow.read_floats(box)

    def _draw_one(self, job: Job, target: Target) -> Box | None:
        shadow, half, blurred = self._atlases_for(job.strips)
        sharp_box = self._cast_sharp(job, target)
        used = Box(0, 0, max((s.box.right for s in job.strips), default=0), sum(s.box.height for s in job.strips))
        shadow.clear(used)
        self._cast_strips(job, shadow)
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
            reach = _reach(job, level)
            full, outline = outline_tiles(pairs, reach, job.blur, inverse(job.canvas_from_plane), box)
            self._show_tiles(job, target, box, (full, outline), level)
        return box

    def _cast_strips(self, job: Job, shadow: Target) -> None:
        """Cast the shadow once, as fine as any strip wants it, and fill the strips with means of it."""
        level = min((strip.band.level for strip in job.strips), default=0)
        texel = 2.0**level
        low, high = (job.extent.left, job.extent.low), (job.extent.right, job.extent.high)
        first = tuple(floor(each / texel) - 1 for each in low)
        width, height = (ceil(end / texel) + 1 - start for end, start in zip(high, first, strict=True))
        box = Box(0, 0, width, height)
        whole = self._whole_of(width, height)
        whole.clear(box)
        plane_from_whole = np.array([[texel, 0.0, first[0] * texel], [0.0, texel, first[1] * texel], [0.0, 0.0, 1.0]])
        # The shape alone is filtered; how strong it is under a low light is told where it is shown.
        window = Window(box, job.canvas_from_plane @ plane_from_whole, _cells_at(level), is_shape_only=True)
        self._caster.unite(job.cast, job.matte, whole, window)
        for strip in job.strips:
            corner = (round(strip.band.needed.left / texel) - first[0], round(strip.band.needed.low / texel) - first[1])
            shadow.bind(strip.box)
            whole.texture.bind(0)
            self._reduce.use(
                {
                    "u_target_size_px": shadow.size_px,
                    "u_source": 0,
                    "u_corner": (float(corner[0]), float(corner[1])),
                    "u_first": (float(strip.box.left), float(strip.box.top)),
                    "u_known": (0.0, 0.0, float(width - 1), float(height - 1)),
                    "u_side": 1 << (strip.band.level - level),
                }
            )
            self._boxes.draw_one(strip.box)

    def _cast_sharp(self, job: Job, like: Target) -> Box | None:
        """Cast the shadow as it is, for where it stays so; return its box."""
        if self._sharp is not None and self._sharp.box != like.box:
            self._sharp.close()
            self._sharp = None
            self._sharp_box = None
        if self._sharp is None:
            self._sharp = Target(like.box.width, like.box.height, Format.ALPHA16)
            self._sharp.clear()
        if self._sharp_box is not None:
            self._sharp.clear(self._sharp_box)
        self._sharp_box = self._box_near_contact(job, like.box)
        if self._sharp_box is None:
            return None
        return self._caster.unite(job.cast, job.matte, self._sharp, Window(self._sharp_box, is_shape_only=True))

    def _box_near_contact(self, job: Job, canvas: Box) -> Box | None:
        """Return where on the canvas the shadow is not wholly blurred."""
        if job.blur.sigma_at(0.0) >= FINEST_SIGMA_PX:
            return None
        away = min(job.blur.distance_of(FINEST_SIGMA_PX), LARGEST_PLANE_PX)
        ends = (job.extent.left, max(job.extent.low, -away)), (job.extent.right, min(job.extent.high, away))
        seen = bounding_box(seen_rectangle(canvas, inverse(job.canvas_from_plane), *ends))
        return None if seen is None else seen.grown(1).intersection(canvas)

    def _blur_strips(self, job: Job, way: tuple[Target, Target], direction: frozenset[str]) -> None:
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
                    "u_least_sigma": _LEAST_SIGMA_TEXELS,
                    **width_uniforms(job),
                }
            )
            self._boxes.draw_one(strip.shown)

    def _box_of(self, job: Job, canvas: Box, sharp_box: Box | None) -> Box | None:
        """Return the box of the canvas in which the simplified shadow can be seen."""
        plane_from_canvas = inverse(job.canvas_from_plane)
        u, v = job.moved_px
        box = sharp_box
        for strip in job.strips:
            core = strip.band.core
            low, high = (core.left - u, core.low - v), (core.right + u, core.high + v)
            polygon = seen_rectangle(canvas, plane_from_canvas, low, high)
            seen = bounding_box(polygon)
            if seen is not None:
                box = seen if box is None else box.union(seen)
        return None if box is None else box.intersection(canvas)

    def _show_tiles(self, job: Job, target: Target, box: Box, tiles: tuple[TileBoxes, TileBoxes], level: float) -> None:
        """Draw the tiles within the shape, and those its outline crosses, as strong as the light makes them."""
        assert self._sharp is not None
        full, outline = tiles
        switches, common = strength(job, box)
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
            wanted, uniforms = shape_uniforms(job, box, level)
            self._show[switches | wanted].use(common | uniforms)
            self._boxes.draw(outline)

    def _whole_of(self, width: int, height: int) -> Target:
        """Return a target of at least a size for the shadow before it is blurred."""
        old = self._whole
        if old is None or old.box.width < width or old.box.height < height:
            if old is not None:
                width, height = max(width, old.box.width), max(height, old.box.height)
                old.close()
            self._whole = Target(width, height, Format.ALPHA16)
        assert self._whole is not None
        return self._whole

    def _atlases_for(self, strips: tuple[Strip, ...]) -> tuple[Target, Target, Target]:
        """Return targets of at least the strips' size: for the shadow, and for it blurred one way and both ways."""
        width = max((strip.box.right for strip in strips), default=1)
        height = max((strip.box.bottom for strip in strips), default=1)
        return self._atlases_of(width, height)

    def _atlases_of(self, width: int, height: int) -> tuple[Target, Target, Target]:
        """Return targets of at least a size.

        A wide blur of a small shadow leaves values so small that only floating point keeps them apart.
        """
        old = self._atlases
        if old is None or old[0].box.width < width or old[0].box.height < height:
            for target in old or ():
                width, height = max(width, target.box.width), max(height, target.box.height)
                target.close()
            forms = (Format.ALPHA16, Format.FLOAT, Format.FLOAT)
            shadow, half, blurred = (Target(width, height, form) for form in forms)
            self._atlases = (shadow, half, blurred)
        assert self._atlases is not None
        return self._atlases


def _reach(job: Job, level: float) -> Reach:
    """Return which values are surely no shadow and which surely nothing else.

    No blurred shape changes faster than a straight edge does: counted by the inverse normal distribution, a value so
    many standard deviations from the level is at least as far from the outline.
    """
    if job.cast.edge is None:
        return Reach(level, level, job.moved_px)
    normal, deviations = NormalDist(), job.edge_deviations * _SAFELY + _SAFELY_BESIDES
    middle = normal.inv_cdf(min(max(level, _FAINT), 1 - _FAINT))
    return Reach(normal.cdf(middle - deviations), normal.cdf(middle + deviations), job.moved_px)


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
