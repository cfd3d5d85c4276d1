"""Tiles of a mask: none is called whole, or left out, that is not; held against the regions themselves, at places."""

from dataclasses import dataclass

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.geometry.sets.regions import Group, Region
from kagezou.render.prepare.mask_tiles import Mask, MaskStates, mask_states, region_states
from kagezou.render.prepare.shadow_tiles import TILE_PX, tile_corners

COLUMNS, ROWS = np.arange(1, 6), np.arange(2, 6)
CORNERS = tile_corners(COLUMNS, ROWS)
COUNT = len(COLUMNS) * len(ROWS)
MIDDLES = CORNERS.mean(axis=0)

STEPS = np.linspace(-1.0, TILE_PX + 1.0, 7)
PLACES = np.stack(
    [
        np.add.outer(CORNERS[0, 0] + 1, np.tile(STEPS, 7)),
        np.add.outer(CORNERS[0, 1] + 1, np.repeat(STEPS, 7)),
        np.ones((COUNT, 49)),
    ]
)
"""(3, N, 49): places all over each tile, as far out as its corners."""

UNSURE = 1e-7
"""A place this near to a rim, px, is on neither side of it."""


@dataclass(frozen=True)
class Held:
    """For each tile's places (N, 49) whether something holds them surely, and whether it may."""

    surely: np.ndarray
    maybe: np.ndarray

    def without(self, other: "Held") -> "Held":
        return Held(self.surely & ~other.maybe, self.maybe & ~other.surely)

    def within(self, other: "Held") -> "Held":
        return Held(self.surely & other.surely, self.maybe & other.maybe)


EVERYWHERE, NOWHERE = (Held(np.full((COUNT, 49), each), np.full((COUNT, 49), each)) for each in (True, False))


def held_by(region: Region) -> Held:
    depth = np.full((COUNT, 49), np.inf)
    for line in region.lines:
        depth = np.minimum(depth, np.tensordot(line, PLACES, axes=1))
    if region.conic is not None:
        depth = np.minimum(depth, np.einsum("int,ij,jnt->nt", PLACES, region.conic, PLACES))
    return Held(depth > UNSURE, depth >= -UNSURE)


def held_by_any(groups: tuple[Group, ...]) -> Held:
    held = [held_by(region) for group in groups for region in group.regions]
    return Held(
        np.logical_or.reduce([NOWHERE.surely, *(each.surely for each in held)]),
        np.logical_or.reduce([NOWHERE.maybe, *(each.maybe for each in held)]),
    )


def seen_and_lit(mask: Mask) -> tuple[Held, Held]:
    outline = EVERYWHERE if mask.outline is None else held_by_any((mask.outline,))
    return outline.without(held_by_any(mask.hidden)), EVERYWHERE.without(held_by_any(mask.unlit))


def line_through(x: float, y: float, degrees: float) -> np.ndarray:
    normal = np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees))])
    return np.append(normal, -normal @ (x, y))


def ellipse(x: float, y: float, axes: tuple[float, float], degrees: float) -> np.ndarray:
    cosine, sine = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    away = np.array([[cosine, sine, 0.0], [-sine, cosine, 0.0], [0.0, 0.0, 1.0]])
    away = np.diag([1 / axes[0], 1 / axes[1], 1.0]) @ away @ np.array([[1.0, 0.0, -x], [0.0, 1.0, -y], [0.0, 0.0, 1.0]])
    conic = away.T @ np.diag([-1.0, -1.0, 1.0]) @ away
    return np.asarray(conic / np.abs(conic).max())


PLACE_X, PLACE_Y = st.floats(-40, 90), st.floats(-30, 90)
LINES = st.lists(st.builds(line_through, PLACE_X, PLACE_Y, st.floats(0, 360)), max_size=4)
AXES = st.tuples(st.floats(2, 80), st.floats(2, 80))
CONICS = st.one_of(st.none(), st.builds(ellipse, PLACE_X, PLACE_Y, AXES, st.floats(0, 180)))
REGIONS = st.builds(lambda lines, conic: Region(np.reshape(lines, (-1, 3)), conic), LINES, CONICS)
GROUPS = st.builds(Group, st.lists(REGIONS, min_size=1, max_size=3).map(tuple), st.booleans())
MANY = st.lists(GROUPS, max_size=2).map(tuple)
MASKS = st.builds(Mask, st.none() | GROUPS, MANY, MANY)


def box_region(left: float, top: float, right: float, bottom: float) -> Region:
    return Region(np.array([[1.0, 0, -left], [-1.0, 0, right], [0, 1.0, -top], [0, -1.0, bottom]]))


def alone(*regions: Region) -> Group:
    return Group(regions, overlaps=False)


@given(st.lists(REGIONS, max_size=4))
def test_a_region_holds_all_or_nothing_of_a_tile_only_if_it_does(regions: list[Region]) -> None:
    states = region_states(regions, CORNERS)
    assert states.full.shape == states.some.shape == (len(regions), COUNT)
    for region, full, some in zip(regions, states.full, states.some, strict=True):
        held = held_by(region)
        assert held.maybe[full].all()
        assert not held.surely[~some].any()
        assert some[full].all()


@given(st.builds(line_through, PLACE_X, PLACE_Y, st.floats(0, 360)))
def test_a_single_line_is_told_exactly(line: np.ndarray) -> None:
    at_corners = np.tensordot(line, CORNERS, axes=(0, 1))
    states = region_states([Region(line[np.newaxis])], CORNERS)
    sure = np.flatnonzero(np.abs(at_corners).min(axis=0) > UNSURE)
    assert np.array_equal(states.full[0, sure], at_corners[:, sure].min(axis=0) > 0)
    assert np.array_equal(states.some[0, sure], at_corners[:, sure].max(axis=0) > 0)


def test_a_disc_is_told_to_a_tile() -> None:
    disc = Region(np.zeros((0, 3)), ellipse(28.0, 32.0, (14.0, 14.0), 0.0))
    states = region_states([disc], CORNERS)
    away = np.hypot(MIDDLES[0] - 28, MIDDLES[1] - 32)
    assert states.full[0, away < 14 - 2 * TILE_PX + 5].all()
    assert not states.some[0, away > 14 + 2 * TILE_PX].any()
    assert states.full.any()


@given(mask=MASKS, own_shadow=st.booleans())
def test_no_tile_is_called_whole_or_left_out_that_is_not(mask: Mask, *, own_shadow: bool) -> None:
    states = mask_states(mask, CORNERS, own_shadow=own_shadow)
    seen, lit = seen_and_lit(mask)
    asked = seen.within(EVERYWHERE.without(lit) if own_shadow else lit)
    assert not (states.whole & states.edge).any()
    assert asked.maybe[states.whole].all()
    assert not asked.surely[~(states.whole | states.edge)].any()


@given(mask=MASKS, own_shadow=st.booleans(), chosen=st.lists(st.booleans(), min_size=COUNT, max_size=COUNT))
def test_what_some_tiles_need_of_a_mask_is_the_same_to_them(
    mask: Mask, chosen: list[bool], *, own_shadow: bool
) -> None:
    tiles = np.array(chosen)
    states = mask_states(mask, CORNERS, own_shadow=own_shadow)
    needed = states.needed(tiles)
    for part, whole in zip(seen_and_lit(needed), seen_and_lit(mask), strict=True):
        assert not (part.surely & ~whole.maybe)[tiles].any()
        assert not (whole.surely & ~part.maybe)[tiles].any()
    assert states.regions.some.shape == (sum(len(group.regions) for group in states.mask.groups), COUNT)


def states_of(mask: Mask, *, own_shadow: bool = False) -> MaskStates:
    return mask_states(mask, CORNERS, own_shadow=own_shadow)


def test_a_mask_of_nothing_takes_nothing() -> None:
    assert states_of(Mask(None, (), ())).whole.all()
    dark = states_of(Mask(None, (), ()), own_shadow=True)
    assert not dark.whole.any()
    assert not dark.edge.any()


def test_own_shadow_asks_for_what_is_seen_and_taken_from_the_light() -> None:
    left, upper = box_region(-100, -100, 24, 200), box_region(-100, -100, 200, 32)
    states = states_of(Mask(None, (alone(left),), (alone(upper),)), own_shadow=True)
    x, y = MIDDLES[:2]
    assert np.array_equal(states.whole, (x > 24 + TILE_PX) & (y < 32 - TILE_PX))
    lit = states_of(Mask(None, (alone(left),), (alone(upper),)))
    assert np.array_equal(lit.whole, (x > 24 + TILE_PX) & (y > 32 + TILE_PX))


def test_regions_far_from_all_tiles_are_not_looked_at() -> None:
    near, far = box_region(10, 20, 30, 40), box_region(300, 20, 330, 40)
    states = states_of(Mask(alone(near), (alone(far), alone(near, far)), (alone(far, near),)))
    assert [len(group.regions) for group in states.mask.hidden] == [1]
    assert [len(group.regions) for group in states.mask.unlit] == [1]
    assert states.mask.hidden[0].regions[0] is near


@pytest.mark.parametrize("overlaps", [True, False])
def test_a_group_keeps_what_it_says_of_its_regions(*, overlaps: bool) -> None:
    near, far = box_region(10, 20, 30, 40), box_region(300, 20, 330, 40)
    states = states_of(Mask(None, (Group((far, near), overlaps),), ()))
    (group,) = states.needed(np.ones(COUNT, bool)).hidden
    assert (group.regions, group.overlaps) == ((near,), overlaps)


def test_an_outline_around_all_tiles_asked_about_is_not_needed() -> None:
    states = states_of(Mask(alone(box_region(0, 0, 28, 100)), (), ()))
    x = MIDDLES[0]
    assert states.needed(x < 20).outline is None
    assert states.needed(x < 30).outline is not None
    assert states.needed(np.zeros(COUNT, bool)).hidden == ()
