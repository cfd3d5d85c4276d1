"""The finished picture: backdrop, background, shadows and characters, laid one over the other in that order."""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import TYPE_CHECKING

from kagezou.geometry.box import Box, centred_offset
from kagezou.geometry.placement import Placement, around_placed
from kagezou.io.images.cel_cache import CelSource
from kagezou.io.images.reading import Cel
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.gl import GL
from kagezou.render.gpu.program import Program, Variants
from kagezou.render.gpu.targets import Format, Target, Texture
from kagezou.render.passes.cel_textures import CelTextures
from kagezou.render.passes.fade_and_tip import look_uniforms, unit_rgb
from kagezou.render.passes.unite import MOST_TAKEN
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.render.prepare.moved import MOVED, moved_by, moved_uniforms
from kagezou.render.prepare.uniforms import Uniform
from kagezou.scene.scene import PlacedDrawing, ShadowCast, ShadowLook

if TYPE_CHECKING:
    from kagezou.render.meshes.display import SetPicture

COLOR_BUDGET_BYTES = 256 << 20

_NO_COLOR = (0.0, 0.0, 0.0)
_AS_IT_IS: Mapping[str, Uniform] = MappingProxyType(
    {"u_is_picture": True, "u_color": _NO_COLOR, "u_opacity": 1.0, "u_multiply": False}
)
"""How a picture is laid that has colours and alpha of its own."""

_LINE_COLOR = (0xD5 / 255, 0x5E / 255, 0.0)
"""Vermilion: seen on paper, on dark drawings and by those who see few colours."""


_WIRE_OPACITY = 0.8


@dataclass(frozen=True, slots=True)
class _Base:
    """What the lowest layer of the picture was made of."""

    backdrop: Backdrop
    background: PlacedDrawing | None
    sets: "tuple[SetPicture, ...]"


class PicturePass:
    """A canvas-sized target of straight sRGB, drawn from the base up. Only what was drawn over is restored."""

    def __init__(self, boxes: Boxes, canvas: Box, form: Format, cels: CelSource, square_px: int) -> None:
        self._boxes = boxes
        self._cels = cels
        self._square_px = square_px
        self._backdrop_program = Program("common/box.vert", "picture/backdrop.frag")
        self._lay_programs = Variants("common/box.vert", "picture/lay.frag")
        self._copy_program = Program("common/box.vert", "picture/copy.frag")
        self._target = Target(canvas.width, canvas.height, form)
        self._base_target = Target(canvas.width, canvas.height, form)
        self._under_target = Target(canvas.width, canvas.height, form)
        self._colors = CelTextures(COLOR_BUDGET_BYTES)
        self._base: _Base | None = None
        self._drawn_over: list[Box] = []

    @property
    def target(self) -> Target:
        """Where the picture is."""
        return self._target

    def begin(self, backdrop: Backdrop, background: PlacedDrawing | None, sets: "tuple[SetPicture, ...]" = ()) -> None:
        """Start over from the base: the backdrop, the background picture where it is asked for, and sets."""
        base = _Base(backdrop, background if backdrop is Backdrop.BACKGROUND else None, sets)
        if base != self._base:
            self._base = None
            self._make_base(base)
            self._base, self._drawn_over = base, [self._target.box]
        for box in self._drawn_over:
            self._copy_base(box)
        self._drawn_over = []

    def lay_shadow(
        self,
        coverage: Texture,
        box: Box,
        cast: ShadowCast | None,
        look: ShadowLook,
        distances: Texture | None = None,
    ) -> None:
        """Lay a shadow over the picture; ``coverage`` is of the canvas' size, ``cast`` None for the set's own."""
        switches, uniforms = look_uniforms(cast, look, box, distances)
        self._lay(
            self._target,
            box,
            coverage,
            {
                "u_source_corner_px": (0.0, 0.0),
                "u_is_picture": False,
                "u_color": unit_rgb(look.color),
                "u_multiply": look.multiply,
                **uniforms,
            },
            switches,
        )

    def lay_united(self, united: Texture, box: Box, look: ShadowLook) -> None:
        """Lay several shadows of one look over the picture as one, see `UnitePass`."""
        uniforms: dict[str, Uniform] = {
            "u_source_corner_px": (0.0, 0.0),
            "u_is_picture": False,
            "u_color": unit_rgb(look.color),
            "u_opacity": look.opacity,
            "u_multiply": look.multiply,
        }
        self._lay(self._target, box, united, uniforms, MOST_TAKEN if look.tip else frozenset())

    def lay_reflection(self, mirrored: Texture, box: Box) -> None:
        """Lay a picture of the canvas' size, straight colour and alpha, over the picture."""
        self._lay(self._target, box, mirrored, {**_AS_IT_IS, "u_source_corner_px": (0.0, 0.0)})

    def lay_outline(self, coverage: Texture, box: Box, line_px: int) -> None:
        """Lay a shadow's outline over the picture as a line that reaches ``line_px`` to both sides of it."""
        uniforms: dict[str, Uniform] = {
            "u_source_corner_px": (0.0, 0.0),
            "u_is_picture": False,
            "u_color": _LINE_COLOR,
            "u_opacity": 1.0,
            "u_multiply": False,
            "u_line_px": line_px,
        }
        around = box.grown(line_px).intersection(self._target.box)
        if around is not None:
            self._lay(self._target, around, coverage, uniforms, frozenset({"OUTLINED"}))

    def lay_cel(self, cel: Cel, placement: Placement | None = None) -> None:
        """Lay a drawing over the picture: centred, pixel for pixel, unless a placement moves it."""
        self._lay_cel(self._target, cel, placement)

    def copy_whole(self) -> None:
        """Draw the whole picture once into another target, one texel a pixel: the unit of cost of a benchmark."""
        self._under_target.bind()
        self._target.texture.bind(0)
        self._copy_program.use({"u_target_size_px": self._target.size_px, "u_source": 0})
        self._boxes.draw_one(self._target.box)

    def close(self) -> None:
        """Give the memory back."""
        self._colors.close()
        self._under_target.close()
        self._base_target.close()
        self._target.close()
        self._lay_programs.close()
        self._copy_program.close()
        self._backdrop_program.close()

    def _make_base(self, base: _Base) -> None:
        self._base_target.bind()
        tone, other = base.backdrop.tones
        self._backdrop_program.use(
            {
                "u_target_size_px": self._target.size_px,
                "u_tone": tone,
                "u_other_tone": other,
                "u_square_px": self._square_px,
            }
        )
        self._boxes.draw_one(self._base_target.box)
        for picture in base.sets:
            if picture.is_under:
                self._lay_set(picture)
        if base.background is not None:
            behind = base.background
            self._lay_cel(self._base_target, self._cels.background(behind.source), behind.placement)
        for picture in base.sets:
            if not picture.is_under:
                self._lay_set(picture)

    def _lay_set(self, picture: "SetPicture") -> None:
        from kagezou.render.meshes.display import Display

        is_wire = picture.display is Display.WIREFRAME
        uniforms: dict[str, Uniform] = {
            "u_source_corner_px": (0.0, 0.0),
            "u_is_picture": not is_wire,
            "u_color": _NO_COLOR,
            "u_opacity": _WIRE_OPACITY if is_wire else 1.0,
            "u_multiply": False,
        }
        switches = frozenset({"CONTRASTING"} if is_wire else ())
        self._lay(self._base_target, self._base_target.box, picture.texture, uniforms, switches)

    def _lay_cel(self, target: Target, cel: Cel, placement: Placement | None = None) -> None:
        seat = _seat_of(cel, placement, target.box)
        if seat is None or cel.matte.box is None:
            return
        texture = self._colors.texture(cel)
        self._lay(target, seat.box, texture, {**_AS_IT_IS, **seat.uniforms}, seat.switches)

    def _lay(
        self,
        target: Target,
        box: Box,
        source: Texture,
        uniforms: dict[str, Uniform],
        switches: frozenset[str] = frozenset(),
    ) -> None:
        self._copy_under(target, box)
        target.bind(box)
        self._under_target.texture.bind(0)
        source.bind(1)
        common: dict[str, Uniform] = {"u_target_size_px": self._target.size_px, "u_under": 0, "u_source": 1}
        self._lay_programs[switches].use(common | uniforms)
        self._boxes.draw_one(box)
        if target is self._target:
            self._drawn_over.append(box)

    def _copy_under(self, target: Target, box: Box) -> None:
        GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, target.id)
        self._under_target.texture.bind(0)
        GL.glCopyTexSubImage2D(GL.GL_TEXTURE_2D, 0, box.left, box.top, box.left, box.top, box.width, box.height)

    def _copy_base(self, box: Box) -> None:
        GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, self._base_target.id)
        self._target.texture.bind(0)
        GL.glCopyTexSubImage2D(GL.GL_TEXTURE_2D, 0, box.left, box.top, box.left, box.top, box.width, box.height)


@dataclass(frozen=True, slots=True)
class _Seat:
    """Where a drawing is seen on the canvas, and how its pixels find their texels."""

    box: Box
    uniforms: dict[str, Uniform]
    switches: frozenset[str]


def _seat_of(cel: Cel, placement: Placement | None, canvas: Box) -> _Seat | None:
    """Return how a drawing lies on the canvas, None where nothing of it is seen."""
    if cel.matte.box is None:
        return None
    height, width = cel.rgba.shape[:2]
    figure = cel.matte.box.moved(*centred_offset(canvas, width, height))
    corner = (float(figure.left), float(figure.top))
    if placement is None:
        box = figure.intersection(canvas)
        return None if box is None else _Seat(box, {"u_source_corner_px": corner}, frozenset())
    way = placement.canvas_from_centred()
    # What lies between the outermost texels and nothing reaches half a texel further.
    box = around_placed(figure.grown(1), way).intersection(canvas)
    return None if box is None else _Seat(box, moved_uniforms(way @ moved_by(*corner)), MOVED)
