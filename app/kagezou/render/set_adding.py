"""Adding what is seen of one receiver's shadow to the picture of them all."""

from dataclasses import dataclass

from kagezou.geometry.box import Box
from kagezou.render.boxes import Boxes
from kagezou.render.gl import GL
from kagezou.render.program import Program, Uniform, Variants
from kagezou.render.set_tiles import Mask, MaskTiling, mask_tiles
from kagezou.render.set_uniforms import TABLE_SIZES, fits, mask_uniforms
from kagezou.render.targets import Target
from kagezou.render.tiles import TILE_PX


@dataclass(frozen=True, slots=True, eq=False)
class OwnShade:
    """How dark the set's own shadow is on a face: switches and uniforms of ``grazing.glsl``.

    ``is_even`` tells that the face is wholly dark where it is taken from the light, and not at all where it is lit.
    """

    switches: frozenset[str]
    uniforms: dict[str, Uniform]
    is_even: bool


class Adding:
    """Draws masks: whole tiles as they are, tiles with an edge pixel by pixel."""

    def __init__(self, boxes: Boxes) -> None:
        self._boxes = boxes
        self._masked = Variants("box.vert", "set_mask.frag")
        self._full = Variants("box.vert", "full.frag")
        self._copy = Program("box.vert", "shade.frag")

    def close(self) -> None:
        """Give the memory back."""
        self._masked.close()
        self._full.close()
        self._copy.close()

    def add(self, mask: Mask, alone: Target, box: Box, target: Target) -> Box | None:
        """Add the seen and lit part of a receiver's shadow; return the box it was added in, None for nowhere.

        Parameters
        ----------
        mask
            That of the receiver.
        alone
            The shadow as if nothing else were there.
        box
            Where that holds any.
        target
            What to add to.
        """
        drawn: Box | None = None
        for tiling in _parted(mask, box, target.box, own_shadow=False):
            around = tiling.box
            if around is None:
                continue
            _begin(target, around)
            alone.texture.bind(0)
            if len(tiling.whole):
                self._copy.use({"u_target_size_px": target.size_px, "u_coverage": 0, "u_opacity": 1.0})
                self._boxes.draw(tiling.whole)
            if len(tiling.edge):
                uniforms = mask_uniforms(tiling.mask, _origin(around))
                self._masked[TABLE_SIZES].use({"u_target_size_px": target.size_px, "u_coverage": 0, **uniforms})
                self._boxes.draw(tiling.edge)
            drawn = around if drawn is None else drawn.union(around)
        return drawn

    def add_own(self, mask: Mask, shade: OwnShade, box: Box, target: Target) -> Box | None:
        """Add the seen part of a receiver that bodies take from the light; return the box it was added in."""
        drawn: Box | None = None
        for tiling in _parted(mask, box, target.box, own_shadow=True):
            around = tiling.box
            if around is None:
                continue
            _begin(target, around)
            if len(tiling.whole):
                self._full[shade.switches].use({"u_target_size_px": target.size_px, **shade.uniforms})
                self._boxes.draw(tiling.whole)
            if len(tiling.edge):
                switches = TABLE_SIZES | shade.switches | {"OWN_SHADOW"}
                # The same origin for everything: grazing has its numbers around it.
                origin = shade.uniforms["u_origin_px"]
                assert isinstance(origin, tuple)
                uniforms = mask_uniforms(tiling.mask, (origin[0], origin[1]))
                self._masked[switches].use({"u_target_size_px": target.size_px, **shade.uniforms, **uniforms})
                self._boxes.draw(tiling.edge)
            drawn = around if drawn is None else drawn.union(around)
        return drawn

    def unite(self, source: Target, box: Box, target: Target) -> None:
        """Unite a box of a target with another one by maximum."""
        target.bind(box)
        GL.glEnable(GL.GL_BLEND)
        GL.glBlendEquation(GL.GL_MAX)
        source.texture.bind(0)
        self._copy.use({"u_target_size_px": target.size_px, "u_coverage": 0, "u_opacity": 1.0})
        self._boxes.draw_one(box)


def _begin(target: Target, box: Box) -> None:
    target.bind(box)
    GL.glEnable(GL.GL_BLEND)
    GL.glBlendFunc(GL.GL_ONE, GL.GL_ONE)


def _origin(box: Box) -> tuple[float, float]:
    """Return the pixel centre in the middle of a box."""
    return ((box.left + box.right) // 2 + 0.5, (box.top + box.bottom) // 2 + 0.5)


def _parted(mask: Mask, area: Box, canvas: Box, *, own_shadow: bool) -> list[MaskTiling]:
    """Return the tiles of an area, in several parts where one part's rims are more than the shader's tables hold."""
    tiling = mask_tiles(mask, area, canvas, own_shadow=own_shadow)
    if fits(tiling.mask) or max(area.width, area.height) <= TILE_PX:
        return [tiling]
    if area.width >= area.height:
        middle = -(-((area.left + area.right) // 2) // TILE_PX) * TILE_PX
        parts = (Box(area.left, area.top, middle, area.bottom), Box(middle, area.top, area.right, area.bottom))
    else:
        middle = -(-((area.top + area.bottom) // 2) // TILE_PX) * TILE_PX
        parts = (Box(area.left, area.top, area.right, middle), Box(area.left, middle, area.right, area.bottom))
    if any(part.is_empty for part in parts):
        return [tiling]
    return [each for part in parts for each in _parted(mask, part, canvas, own_shadow=own_shadow)]
