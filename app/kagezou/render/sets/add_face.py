"""Adding what is seen of one receiver's shadow to the picture of them all."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace

import numpy as np

from kagezou.geometry.box import Box, around
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.gl import GL
from kagezou.render.gpu.program import Program, Variants
from kagezou.render.gpu.targets import Target
from kagezou.render.meshes.occlusion import Screen
from kagezou.render.passes.cast import CastPass, Laying, Stroke
from kagezou.render.prepare.mask_tiles import Flags, Mask, MaskStates, mask_states
from kagezou.render.prepare.mask_uniforms import TABLE_SIZES, fits, mask_uniforms
from kagezou.render.prepare.shadow_tiles import Boxes as TileBoxes
from kagezou.render.prepare.shadow_tiles import Tiling, around_boxes, whole_grid
from kagezou.render.prepare.uniforms import Uniform

_MOST_ASIDES = 6
"""Targets of the canvas' size for tiles with edges."""


@dataclass(frozen=True, slots=True, eq=False)
class OwnShade:
    """How dark the set's own shadow is on a face: switches and uniforms of ``common/grazing.glsl``.

    ``is_even`` tells that the face is wholly dark where it is taken from the light, and not at all where it is lit.
    """

    switches: frozenset[str]
    uniforms: dict[str, Uniform]
    is_even: bool


class Adding:
    """Draws masks: whole tiles as they are, tiles with an edge pixel by pixel."""

    def __init__(self, boxes: Boxes, caster: CastPass) -> None:
        self._boxes = boxes
        self._caster = caster
        self._masked = Variants("common/box.vert", "sets/mask.frag")
        self._full = Variants("common/box.vert", "common/full.frag")
        self._copy = Program("common/box.vert", "common/shade.frag")

    def close(self) -> None:
        """Give the memory back."""
        self._masked.close()
        self._full.close()
        self._copy.close()

    def add_strokes(
        self, strokes: Iterable[tuple[Mask, Stroke]], aside: Callable[[int], Target], target: Target
    ) -> Box | None:
        """Add the seen and lit parts of strokes, each the only one on its receiver; return the box they are in.

        Most is drawn where it belongs at once; only tiles with an edge of a mask are drawn aside, where anything may
        lie before and after. They go there as soon as they are known, and are read as late as can be: what a driver
        draws meanwhile, nobody waits for.

        Parameters
        ----------
        strokes
            Every one touches one tile at least.
        aside
            Targets of the same size by their numbers.
        target
            What to add to.
        """
        drawn: Box | None = None
        wholes: list[tuple[Stroke, Tiling]] = []
        waiting: list[tuple[_FaceEdge, Target]] = []
        for mask, stroke in strokes:
            whole, found = _sorted(mask, stroke, target.box)
            wholes.append((stroke, whole))
            for edge in found:
                if len(waiting) == _MOST_ASIDES:
                    self._add_edges(waiting, target)
                    waiting.clear()
                waiting.append((edge, aside(len(waiting))))
                self._caster.paint(stroke, edge.tiling, waiting[-1][1], Laying.INSTEAD)
            drawn = around(drawn, whole.box, *(edge.tiling.box for edge in found))
        for stroke, whole in wholes:
            self._caster.paint(stroke, whole, target, Laying.ADDED)
        self._add_edges(waiting, target)
        return drawn

    def _add_edges(self, edges: Iterable[tuple["_FaceEdge", Target]], target: Target) -> None:
        for edge, aside in edges:
            self._add_edge(edge.needed, aside, edge.tiling.boxes, target)

    def add(self, mask: Mask, alone: Target, box: Box, target: Target, screen: Screen | None = None) -> Box | None:
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
        screen
            What meshes do to the receiver; None where there are none.
        """
        grid = whole_grid(box)
        states = mask_states(mask, grid.corners(), own_shadow=False)
        if screen is not None:
            states = screen.narrowed(states, box)
        whole = grid.tiling(target.box, states.whole)
        drawn = whole.box
        if drawn is not None:
            _begin(target, drawn)
            alone.texture.bind(0)
            self._copy.use({"u_target_size_px": target.size_px, "u_coverage": 0, "u_opacity": 1.0})
            self._boxes.draw(whole.boxes)
        for tiles, needed in _parted(states, None):
            edge = grid.tiling(target.box, tiles)
            if edge.box is not None:
                self._add_edge(needed, alone, edge.boxes, target, screen)
                drawn = around(drawn, edge.box)
        return drawn

    def add_own(
        self, mask: Mask, shade: OwnShade, box: Box, target: Target, screen: Screen | None = None
    ) -> Box | None:
        """Add the seen part of a receiver that bodies take from the light; return the box it was added in."""
        grid = whole_grid(box)
        states = mask_states(mask, grid.corners(), own_shadow="DARK_WHEN_TURNED" not in shade.switches)
        if "DARK_WHEN_TURNED" in shade.switches:
            # Every tile that is seen is a little dark.
            seen = mask_states(Mask(mask.outline, mask.hidden, ()), grid.corners(), own_shadow=False)
            all_mask = mask_states(mask, grid.corners(), own_shadow=True)
            states = MaskStates(all_mask.mask, np.zeros_like(seen.whole), seen.whole | seen.edge, all_mask.regions)
        if screen is not None:
            states = _taken(mask, states, screen, box)
        whole = grid.tiling(target.box, states.whole)
        drawn = whole.box
        if drawn is not None:
            _begin(target, drawn)
            self._full[shade.switches].use({"u_target_size_px": target.size_px, **shade.uniforms})
            self._boxes.draw(whole.boxes)
        for tiles, needed in _parted(states, None):
            edge = grid.tiling(target.box, tiles)
            if edge.box is not None:
                self._add_own_edge(needed, shade, edge.boxes, target, screen)
                drawn = around(drawn, edge.box)
        return drawn

    def unite(self, source: Target, box: Box, target: Target) -> None:
        """Unite a box of a target with another one by maximum."""
        target.bind(box)
        GL.glEnable(GL.GL_BLEND)
        GL.glBlendEquation(GL.GL_MAX)
        source.texture.bind(0)
        self._copy.use({"u_target_size_px": target.size_px, "u_coverage": 0, "u_opacity": 1.0})
        self._boxes.draw_one(box)

    def _add_edge(
        self, mask: Mask, alone: Target, boxes: TileBoxes, target: Target, screen: Screen | None = None
    ) -> None:
        around = around_boxes(boxes)
        assert around is not None
        _begin(target, around)
        alone.texture.bind(0)
        origin = ((around.left + around.right) // 2 + 0.5, (around.top + around.bottom) // 2 + 0.5)
        switches, uniforms = _screened(screen, origin)
        uniforms |= mask_uniforms(mask, origin)
        self._masked[TABLE_SIZES | switches].use({"u_target_size_px": target.size_px, "u_coverage": 0, **uniforms})
        self._boxes.draw(boxes)

    def _add_own_edge(
        self, mask: Mask, shade: OwnShade, boxes: TileBoxes, target: Target, screen: Screen | None
    ) -> None:
        _begin(target, around_boxes(boxes))
        # One origin for everything: grazing has its numbers around it.
        origin = shade.uniforms["u_origin_px"]
        assert isinstance(origin, tuple)
        switches, uniforms = _screened(screen, (origin[0], origin[1]))
        uniforms |= mask_uniforms(mask, (origin[0], origin[1]))
        switches |= TABLE_SIZES | shade.switches | {"OWN_SHADOW"}
        self._masked[switches].use({"u_target_size_px": target.size_px, **shade.uniforms, **uniforms})
        self._boxes.draw(boxes)


@dataclass(frozen=True, slots=True, eq=False)
class _FaceEdge:
    """Tiles of a stroke with an edge of its mask, and what of the mask they need."""

    tiling: Tiling
    needed: Mask


def _sorted(mask: Mask, stroke: Stroke, canvas: Box) -> tuple[Tiling, list[_FaceEdge]]:
    """Return the tiles of a stroke that count as they are, and those with an edge of its mask."""
    touched = stroke.grid.touched
    states = mask_states(mask, stroke.grid.corners()[:, :, touched], own_shadow=False)
    whole_tiles, edge_tiles = np.zeros(len(touched), bool), np.zeros(len(touched), bool)
    whole_tiles[touched] = states.whole
    parts = _parted(states, touched)
    if parts:
        edge_tiles = parts[0][0]
    whole, first = stroke.grid.tilings(canvas, whole_tiles, edge_tiles)
    tilings = [first, *(stroke.grid.tiling(canvas, tiles) for tiles, _ in parts[1:])]
    edges = [_FaceEdge(tiling, needed) for tiling, (_, needed) in zip(tilings, parts, strict=False)]
    return whole, [edge for edge in edges if edge.tiling.box is not None]


def _screened(screen: Screen | None, origin: tuple[float, float]) -> tuple[frozenset[str], dict[str, Uniform]]:
    return (frozenset(), {}) if screen is None else (screen.switches, screen.uniforms(origin))


def _taken(mask: Mask, states: MaskStates, screen: Screen, box: Box) -> MaskStates:
    """Return the states of tiles asked what is taken of the light, with what meshes take and hide."""
    taken = screen.may_be_taken(box)
    if taken.any():
        seen = mask_states(Mask(mask.outline, mask.hidden, ()), whole_grid(box).corners(), own_shadow=False)
        states = replace(states, edge=states.edge | (seen.whole | seen.edge) & taken & ~states.whole)
    return screen.narrowed(states, box)


def _begin(target: Target, box: Box | None) -> None:
    target.bind(box)
    GL.glEnable(GL.GL_BLEND)
    GL.glBlendFunc(GL.GL_ONE, GL.GL_ONE)


def _parted(states: MaskStates, touched: Flags | None) -> list[tuple[Flags, Mask]]:
    """Return the tiles of a grid that have an edge, in parts whose rims the shader's tables have room for.

    ``touched`` says which tiles of the grid the states are of, None for all.
    """
    tiles = states.edge
    if touched is not None:
        tiles = np.zeros(len(touched), bool)
        tiles[touched] = states.edge
    parts = [tiles] if tiles.any() else []
    done: list[tuple[Flags, Mask]] = []
    while parts:
        part = parts.pop()
        needed = states.needed(part if touched is None else part[touched])
        if fits(needed) or part.sum() <= 1:
            done.append((part, needed))
            continue
        numbers = np.nonzero(part)[0]
        for half in np.array_split(numbers, 2):
            flags = np.zeros(len(part), bool)
            flags[half] = True
            parts.append(flags)
    return done
