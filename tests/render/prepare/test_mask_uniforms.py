"""A mask as the shader reads it: its tables, read back as ``sets/mask.frag`` reads them, say what the mask says."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.geometry.sets.regions import Group, Region
from kagezou.render.prepare.mask_tiles import Mask
from kagezou.render.prepare.mask_uniforms import (
    LAST,
    LIGHT,
    MAX_CONICS,
    MAX_LINES,
    MAX_REGIONS,
    OVERLAPS,
    OWN,
    TABLE_SIZES,
    fits,
    mask_uniforms,
)
from kagezou.render.prepare.uniforms import Uniform

Table = dict[str, Uniform]

NO_LINES = np.zeros((0, 3))


def half_plane(x: float, degrees: float) -> np.ndarray:
    normal = np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees))])
    return np.append(normal, -normal @ (x, 50.0))


def ellipse(x: float, y: float, radius: float, slant: float) -> np.ndarray:
    """A disc, or for a slant of -1 to 1 an ellipse on its corner."""
    to_middle = np.array([[1.0, 0.0, -x], [0.0, 1.0, -y], [0.0, 0.0, 1.0]])
    conic = to_middle.T @ np.array([[-1.0, slant, 0.0], [slant, -1.0, 0.0], [0.0, 0.0, radius**2]]) @ to_middle
    return np.asarray(conic / np.abs(conic).max())


def table(uniforms: Table, name: str) -> np.ndarray:
    found = uniforms.get(name, np.zeros((0, 4)))
    assert isinstance(found, np.ndarray)
    return found


def depth_in(uniforms: Table, region: np.ndarray, x: float, y: float) -> float:
    """How deep within a region of the tables a canvas place lies; under 0 it lies outside."""
    origin = uniforms["u_origin_px"]
    assert isinstance(origin, tuple)
    here = np.array([x - origin[0], y - origin[1], 1.0])
    lines, conics = table(uniforms, "u_lines"), table(uniforms, "u_conics")
    depth = min((float(line[:3] @ here) for line in lines[int(region[0]) : int(region[1])]), default=np.inf)
    if region[2] < 0:
        return depth
    (xx, xy, yy, x2), (y2, one, *_) = conics[2 * int(region[2])], conics[2 * int(region[2]) + 1]
    value = xx * here[0] ** 2 + xy * here[0] * here[1] + yy * here[1] ** 2 + x2 * here[0] + y2 * here[1] + one
    return min(depth, float(value))


def seen_and_lit(uniforms: Table, x: float, y: float) -> tuple[bool, bool]:
    """What the shader makes of a place that is on no rim."""
    seen, lit, taken = True, True, False
    for region in table(uniforms, "u_regions"):
        flags = int(region[3])
        taken |= depth_in(uniforms, region, x, y) > 0
        if flags & LAST:
            kept = taken if flags & OWN else not taken
            seen, lit = (seen, lit and kept) if flags & LIGHT else (seen and kept, lit)
            taken = False
    return seen, lit


def holds(group: Group, x: float, y: float) -> bool:
    here = np.array([x, y, 1.0])
    return any(
        (region.lines @ here > 0).all() and (region.conic is None or here @ region.conic @ here > 0)
        for region in group.regions
    )


def is_on_a_rim(mask: Mask, x: float, y: float) -> bool:
    here = np.array([x, y, 1.0])
    return any(
        np.abs(region.lines @ here).min(initial=1.0) < 1e-6
        or (region.conic is not None and abs(here @ region.conic @ here) < 1e-9)
        for group in mask.groups
        for region in group.regions
    )


REGIONS = st.builds(
    lambda lines, conic: Region(np.reshape(lines, (-1, 3)), conic),
    st.lists(st.builds(half_plane, st.floats(0, 100), st.floats(0, 360)), max_size=3),
    st.none() | st.builds(ellipse, st.floats(0, 100), st.floats(0, 100), st.floats(5, 60), st.floats(-0.9, 0.9)),
)
GROUPS = st.builds(Group, st.lists(REGIONS, min_size=1, max_size=3).map(tuple), st.booleans())
MANY = st.lists(GROUPS, max_size=2).map(tuple)
PLACES = st.tuples(st.floats(0, 100), st.floats(0, 100))


@given(st.builds(Mask, st.none() | GROUPS, MANY, MANY), PLACES, st.lists(PLACES, min_size=1, max_size=8))
def test_the_tables_say_what_the_mask_says(
    mask: Mask, origin_px: tuple[float, float], places: list[tuple[float, float]]
) -> None:
    assert fits(mask)
    uniforms = mask_uniforms(mask, origin_px)
    for x, y in places:
        if is_on_a_rim(mask, x, y):
            continue
        outline = mask.outline is None or holds(mask.outline, x, y)
        wanted = (
            outline and not any(holds(group, x, y) for group in mask.hidden),
            not any(holds(group, x, y) for group in mask.unlit),
        )
        assert seen_and_lit(uniforms, x, y) == wanted


def test_a_group_says_of_each_region_whose_it_is() -> None:
    region = Region(half_plane(20, 0)[np.newaxis])
    mask = Mask(
        Group((region,), overlaps=False), (Group((region, region), overlaps=True),), (Group((region,), overlaps=False),)
    )
    flags = table(mask_uniforms(mask, (0.0, 0.0)), "u_regions")[:, 3].astype(int).tolist()
    assert flags == [OWN | LAST, OVERLAPS, OVERLAPS | LAST, LIGHT | LAST]


def test_a_conic_is_scaled_to_a_slope_of_about_one_at_its_rim() -> None:
    mask = Mask(Group((Region(NO_LINES, ellipse(500.0, 400.0, 30.0, 0.0)),), overlaps=False), (), ())
    uniforms = mask_uniforms(mask, (510.0, 390.0))
    (region,) = table(uniforms, "u_regions")
    inside, outside = (depth_in(uniforms, region, 500 + 30 + step, 400) for step in (-0.01, 0.01))
    assert inside > 0 > outside
    assert 0.1 < (inside - outside) / 0.02 < 10


def test_an_empty_mask_has_no_tables() -> None:
    assert mask_uniforms(Mask(None, (), ()), (3.0, 4.0)) == {"u_origin_px": (3.0, 4.0), "u_region_count": 0}
    uniforms = mask_uniforms(Mask(None, (Group((Region(NO_LINES),), overlaps=False),), ()), (0.0, 0.0))
    assert set(uniforms) == {"u_origin_px", "u_region_count", "u_regions"}


@pytest.mark.parametrize(
    ("region", "most"),
    [
        (Region(NO_LINES), MAX_REGIONS),
        (Region(np.tile(half_plane(10, 30), (MAX_LINES // 10, 1))), 10),
        (Region(NO_LINES, ellipse(10, 10, 5, 0)), MAX_CONICS),
    ],
    ids=["regions", "lines", "conics"],
)
def test_the_tables_have_room_for_so_much_and_no_more(region: Region, most: int) -> None:
    def mask_of(count: int) -> Mask:
        half = Group((region,) * (count // 2), overlaps=True)
        return Mask(None, (half,), (Group((region,) * (count - count // 2), overlaps=False),))

    assert fits(mask_of(most))
    assert not fits(mask_of(most + 1))
    sizes = {"u_regions": MAX_REGIONS, "u_lines": MAX_LINES, "u_conics": 2 * MAX_CONICS}
    for count in (most, most + 1):
        uniforms = mask_uniforms(mask_of(count), (0.0, 0.0))
        assert uniforms["u_region_count"] == min(count, MAX_REGIONS)
        assert all(len(table(uniforms, name)) <= size for name, size in sizes.items())


def test_the_shader_is_told_how_large_its_tables_are() -> None:
    assert {"MAX_REGIONS 40", "MAX_LINES 120", "MAX_CONICS 20"} == TABLE_SIZES
