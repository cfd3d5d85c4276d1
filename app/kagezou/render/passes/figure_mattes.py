"""The silhouettes of figures: the matte of one cel as it is, or the mattes of several laid over one another."""

from collections import OrderedDict
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from kagezou.geometry.box import Box, around
from kagezou.geometry.placement import around_placed, canvas_from_centred, centred_from_canvas, lie_alike, whole_shift
from kagezou.geometry.vectors import Matrix
from kagezou.io.images.casting_mattes import CastingMattes
from kagezou.io.images.cel_cache import CelSource
from kagezou.io.images.reading import Matte
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.gl import GL
from kagezou.render.gpu.mattes import Mattes, MatteTexture, PlacedMatte, drawn_from
from kagezou.render.gpu.program import Program, Variants
from kagezou.render.gpu.targets import Format, Target
from kagezou.render.prepare.disc_matte import disc_matte
from kagezou.render.prepare.moved import MOVED_ALPHA, moved_by, moved_uniforms
from kagezou.render.prepare.occupancy import Occupancy
from kagezou.render.prepare.uniforms import LAST_LEVEL, Uniform
from kagezou.scene.disc import Disc
from kagezou.scene.scene import ShadowCast

_KEPT: Final = 4
"""So many joined silhouettes are kept; each has its texture."""

_RIM_PX: Final = 2


@dataclass(frozen=True, slots=True)
class _Part:
    """One matte of a figure: its texture, and the map (3, 3) from px of where it lies centred to the silhouette's."""

    placed: PlacedMatte
    silhouette_from_centred: Matrix


class FigureMattes:
    """Finds the silhouette of what casts a shadow, in px of the figure before its placement moves it.

    Parameters
    ----------
    boxes
        What draws.
    cels, mattes
        Where drawings come from, in memory and on the graphics card.
    """

    def __init__(self, boxes: Boxes, cels: CelSource, mattes: Mattes) -> None:
        self._boxes, self._mattes = boxes, mattes
        self._casting = CastingMattes(cels)
        self._placed = Variants("common/box.vert", "passes/placed.frag")
        self._neighbours = Program("common/box.vert", "common/neighbours.frag")
        self._joined: OrderedDict[tuple[object, ...], PlacedMatte] = OrderedDict()

    def mattes_of(self, cast: ShadowCast) -> tuple[Matte, ...]:
        """Return the mattes of what casts; they are equal only to themselves, so a changed file shows.

        Raises
        ------
        InputProblem
            One cannot be read.
        """
        return tuple(
            disc_matte()
            if isinstance(part, Disc)
            else self._casting.matte(part.source, translucent=cast.translucent, without_painted=cast.without_painted)
            for part in cast.figure
        )

    def placed(self, cast: ShadowCast, canvas: Box) -> PlacedMatte | None:
        """Return the silhouette, None where all cels are empty.

        Raises
        ------
        InputProblem
            A cel cannot be read.
        """
        mattes = self.mattes_of(cast)
        if len(mattes) == 1:
            return self._mattes.placed(mattes[0], canvas)
        key = (mattes, tuple(part.placement for part in cast.figure), canvas)
        known = self._joined.get(key)
        if known is None:
            known = self._join(cast, mattes, canvas)
            if known is None:
                return None
            self._joined[key] = known
            while len(self._joined) > _KEPT:
                self._joined.popitem(last=False)[1].on_gpu.close()
        self._joined.move_to_end(key)
        return known

    def close(self) -> None:
        """Give the memory back."""
        for each in self._joined.values():
            each.on_gpu.close()
        self._joined.clear()
        self._placed.close()
        self._neighbours.close()

    def _join(self, cast: ShadowCast, mattes: Sequence[Matte], canvas: Box) -> PlacedMatte | None:
        base = centred_from_canvas(cast.placement)
        parts = []
        for part, matte in zip(cast.figure, mattes, strict=True):
            placed = self._mattes.placed(matte, canvas)
            if placed is not None:
                way = base @ canvas_from_centred(part.placement)
                parts.append(_Part(placed, whole_shift(way) if lie_alike(cast.placement, part.placement) else way))
        box = around(*[around_placed(part.placed.box, part.silhouette_from_centred) for part in parts])
        if box is not None and not all(lie_alike(cast.placement, part.placement) for part in cast.figure):
            # Scaled up, a cel may be of any size; what lies farther off the canvas than it is large casts nothing.
            box = box.intersection(canvas.grown(max(canvas.width, canvas.height)))
        return None if box is None else self._laid(parts, _whole_squares(box.grown(_RIM_PX)))

    def _laid(self, parts: Sequence[_Part], box: Box) -> PlacedMatte:
        """Lay mattes over one another as the picture lays the cels: a + b - ab."""
        target = Target(box.width, box.height, Format.ALPHA16)
        target.clear()
        for part in parts:
            self._lay(part, box, target)
        # The outermost texels are what is found beyond; a part that is cut off there ends there.
        size = target.box
        for rim in (
            Box(0, 0, size.right, _RIM_PX),
            Box(0, size.bottom - _RIM_PX, size.right, size.bottom),
            Box(0, 0, _RIM_PX, size.bottom),
            Box(size.right - _RIM_PX, 0, size.right, size.bottom),
        ):
            target.clear(rim)
        occupancy = Occupancy(target.read(size), 0)
        texture = drawn_from(target.texture, Format.RGBA16, self._boxes, self._neighbours, {})
        target.close()
        return PlacedMatte(MatteTexture(texture, occupancy), box)

    def _lay(self, part: _Part, box: Box, target: Target) -> None:
        way, placed = part.silhouette_from_centred, part.placed
        target.bind()
        GL.glEnable(GL.GL_BLEND)
        GL.glBlendFunc(GL.GL_ONE, GL.GL_ONE_MINUS_SRC_COLOR)
        GL.glBlendEquation(GL.GL_FUNC_ADD)
        placed.texture.bind(0)
        uniforms: dict[str, Uniform] = {"u_target_size_px": target.size_px, "u_matte": 0}
        target_from_texel = moved_by(-box.left, -box.top) @ way @ moved_by(placed.box.left, placed.box.top)
        if (way == whole_shift(way)).all():
            corner = (float(target_from_texel[0, 2]), float(target_from_texel[1, 2]))
            self._placed[frozenset()].use(uniforms | {"u_corner_px": corner})
        else:
            self._placed[MOVED_ALPHA].use(uniforms | moved_uniforms(target_from_texel))
        where = around_placed(placed.box, way).moved(-box.left, -box.top).intersection(target.box)
        if where is not None:
            self._boxes.draw_one(where)


def _whole_squares(box: Box) -> Box:
    """Return a box grown to the right and down until its sides are whole squares of the coarsest mipmap."""
    square = 1 << LAST_LEVEL
    width, height = (-(-side // square) * square for side in (box.width, box.height))
    return Box(box.left, box.top, box.left + width, box.top + height)
