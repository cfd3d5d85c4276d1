"""Tiles of a filtered shadow: none is called full or empty that is not, by the splines through what the strips hold."""

from collections.abc import Sequence
from itertools import product

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.geometry.bands import FINEST_SIGMA_PX, Blur, Extent, bands_of
from kagezou.geometry.box import Box
from kagezou.render.prepare.band_atlas import Strip, laid_out
from kagezou.render.prepare.outline_tiles import Reach, SeenChart, ShownTiles, outline_tiles

BOX = Box(3, 5, 92, 77)
SHADOW = Extent(10.0, -30.0, 80.0, 150.0)
EVEN, WIDENING = Blur(9.0, 0.0), Blur(14.0, 60.0)

Held = Sequence[tuple[Strip, np.ndarray]]


def found(tiles: ShownTiles) -> tuple[np.ndarray, np.ndarray]:
    """Return what is full, and what has to be looked at."""
    return tiles.full, np.concatenate([tiles.outline, tiles.joined])


def strips_of(blur: Blur, seed: int) -> Held:
    """The strips of a blur, holding a few steps of values; empty at the ends, as what is blurred is."""
    rng = np.random.default_rng(seed)
    held: list[tuple[Strip, np.ndarray]] = []
    for strip in laid_out(bands_of(blur, SHADOW)):
        height, width = strip.shown.height, strip.shown.width
        blocks = rng.choice([0.0, 0.3, 0.5, 0.5, 0.6, 1.0, 1.0, 1.0], (height // 8 + 1, width // 8 + 1))
        values = np.kron(blocks, np.ones((8, 8)))[:height, :width].astype(np.float32)
        values[:, :2] = values[:, -2:] = 0.0
        if blur.is_even:
            values[:2] = values[-2:] = 0.0
        held.append((strip, values))
    return held


def spline(f: np.ndarray) -> np.ndarray:
    """The four weights of a uniform cubic B-spline, (4, N)."""
    g = 1 - f
    return np.stack([g**3, 4 - 6 * f**2 + 3 * f**3, 4 - 6 * g**2 + 3 * g**3, f**3]) / 6


def value_at(held: Held, blur: Blur, u: np.ndarray, v: np.ndarray) -> np.ndarray:
    """What the shader reads at places (N,) of the blur: the spline through the band that a place is in; 0 in none."""
    found = np.zeros(len(u))
    for strip, values in held:
        core = strip.band.core
        at = np.flatnonzero((v >= core.low) & (v < core.high)) if not blur.is_even else np.arange(len(u))
        corner = strip.plane_from_atlas @ (strip.shown.left, strip.shown.top, 1.0)
        x, y = (u[at] - corner[0]) / strip.band.texel_px - 0.5, (v[at] - corner[1]) / strip.band.texel_px - 0.5
        column, row = np.floor(x).astype(int), np.floor(y).astype(int)
        found[at] = 0.0
        for j, down in enumerate(spline(y - row)):
            for i, across in enumerate(spline(x - column)):
                rows = np.clip(row + j - 1, 0, values.shape[0] - 1)
                columns = np.clip(column + i - 1, 0, values.shape[1] - 1)
                found[at] += down * across * values[rows, columns]
    return found


def pixels_of(box: np.ndarray) -> np.ndarray:
    """Places (3, N) in a box of tiles: every corner of its px."""
    left, top, right, bottom = box
    x, y = np.meshgrid(np.arange(left, right + 0.1), np.arange(top, bottom + 0.1))
    return np.stack([x.ravel(), y.ravel(), np.ones(x.size)])


def on_plane(look: SeenChart, places: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    u, v, w = look.plane_from_canvas @ places
    return u / w, v / w


def near_seam(look: SeenChart, u: np.ndarray, v: np.ndarray) -> np.ndarray:
    assert look.seam is not None
    (ax, ay), (bx, by) = look.seam
    t = np.clip(((u - ax) * (bx - ax) + (v - ay) * (by - ay)) / ((bx - ax) ** 2 + (by - ay) ** 2), 0, 1)
    return np.asarray(np.hypot(u - ax - t * (bx - ax), v - ay - t * (by - ay)) < look.reach_px)


def painted(boxes: np.ndarray) -> np.ndarray:
    count = np.zeros((BOX.bottom, BOX.right), int)
    for left, top, right, bottom in boxes.astype(int):
        count[top:bottom, left:right] += 1
    return count


def empty_boxes(full: np.ndarray, outline: np.ndarray) -> list[np.ndarray]:
    """The px of the box that no tile holds, as boxes of one px."""
    drawn = painted(full) + painted(outline)
    assert drawn.max() <= 1, "no px is drawn twice"
    assert not drawn[: BOX.top].any()
    assert not drawn[:, : BOX.left].any()
    rows, columns = np.nonzero(drawn[BOX.top :, BOX.left :] == 0)
    return [
        np.array([x, y, x + 1, y + 1]) + np.tile([BOX.left, BOX.top], 2) for x, y in zip(columns, rows, strict=True)
    ]


def homography(scale: float, turn_deg: float, shift: tuple[float, float], tilt: float) -> np.ndarray:
    cosine, sine = scale * np.cos(np.radians(turn_deg)), scale * np.sin(np.radians(turn_deg))
    return np.array([[cosine, -sine, shift[0]], [sine, cosine, shift[1]], [0.0, tilt, 1.0]])


VIEWS = st.builds(
    homography,
    st.floats(0.4, 1.8),
    st.floats(-180, 180),
    st.tuples(st.floats(-20, 90), st.floats(-40, 140)),
    st.floats(-0.003, 0.01),
)


@given(
    st.sampled_from([EVEN, WIDENING]),
    st.integers(0, 2**32),
    VIEWS,
    st.sampled_from([Reach(0.5, 0.5), Reach(0.1, 0.7), Reach(0.5, 0.5, (4.0, 2.5))]),
)
def test_no_tile_is_called_full_or_empty_that_is_not(
    blur: Blur, seed: int, plane_from_canvas: np.ndarray, reach: Reach
) -> None:
    held = strips_of(blur, seed)
    look = SeenChart(held, plane_from_canvas)
    full, outline = found(outline_tiles([look], reach, blur, BOX))
    empty = empty_boxes(full, outline)
    for boxes, is_full in ((full, True), (empty, False)):
        if not len(boxes):
            continue
        u, v = on_plane(look, np.concatenate([pixels_of(box) for box in boxes], axis=1))
        assert np.abs(v).min() >= blur.distance_of(FINEST_SIGMA_PX) - 1e-6, "there the sharp shadow is seen, too"
        for du, dv in product((-1, 1), repeat=2) if any(reach.moved_px) else [(0, 0)]:
            values = value_at(held, blur, u + du * reach.moved_px[0], v + dv * reach.moved_px[1])
            assert (values > reach.full - 1e-6).all() if is_full else (values <= reach.empty + 1e-6).all()


@given(st.integers(0, 2**32), VIEWS, VIEWS, st.floats(1, 40))
def test_near_a_seam_a_tile_is_full_or_empty_only_if_both_looks_agree(
    seed: int, own: np.ndarray, other: np.ndarray, reach_px: float
) -> None:
    mine, theirs = strips_of(EVEN, seed), strips_of(EVEN, seed + 1)
    seam = np.random.default_rng(seed).uniform((0, -40), (90, 140), (2, 2))
    looks = [SeenChart(mine, own), SeenChart(theirs, other, seam, reach_px)]
    full, outline = found(outline_tiles(looks, Reach(0.5, 0.5), EVEN, BOX))
    for boxes, is_full in ((full, True), (empty_boxes(full, outline), False)):
        if not len(boxes):
            continue
        places = np.concatenate([pixels_of(box) for box in boxes], axis=1)
        u, v = on_plane(looks[0], places)
        own_values = value_at(mine, EVEN, u, v)
        there = [each[near_seam(looks[1], u, v)] for each in on_plane(looks[1], places)]
        other_values = value_at(theirs, EVEN, *there)
        for values in (own_values, other_values):
            assert (values > 0.5 - 1e-6).all() if is_full else (values <= 0.5 + 1e-6).all()


def a_block(blur: Blur) -> Held:
    """Strips that are full but for their ends."""
    held = [(strip, np.ones((strip.shown.height, strip.shown.width), np.float32)) for strip, _ in strips_of(blur, 0)]
    for _, values in held:
        values[:, :4] = values[:, -4:] = 0.0
    return held


SEEN_AS_IT_IS = np.eye(3)


def test_what_is_wholly_in_shadow_and_far_from_the_contact_line_needs_no_look() -> None:
    full, outline = found(outline_tiles([SeenChart(a_block(WIDENING), SEEN_AS_IT_IS)], Reach(0.5, 0.5), WIDENING, BOX))
    near = WIDENING.distance_of(FINEST_SIGMA_PX)
    assert painted(full)[int(near) + 24 :, 40:60].all()
    assert painted(outline)[BOX.top : int(near), BOX.left :].all(), "along the contact line the sharp shadow is seen"


def test_what_no_strip_shows_is_empty() -> None:
    beyond = np.array([[1.0, 0, 0], [0, 1.0, 4000.0], [0, 0, 1.0]])
    full, outline = found(outline_tiles([SeenChart(a_block(EVEN), beyond)], Reach(0.5, 0.5), EVEN, BOX))
    assert len(full) == len(outline) == 0


def test_a_tile_across_the_horizon_may_be_anything() -> None:
    to_horizon = np.array([[1.0, 0, 0], [0, 1.0, 0], [0.0, 1.0, -40.0]])
    _, outline = found(outline_tiles([SeenChart(a_block(EVEN), to_horizon)], Reach(0.5, 0.5), EVEN, BOX))
    assert painted(outline)[BOX.top : 48, BOX.left :].all()


@pytest.mark.parametrize("reach_px", [1.0, 30.0])
def test_a_look_counts_near_its_seam_alone(reach_px: float) -> None:
    own, other = a_block(EVEN), [(strip, np.zeros_like(values)) for strip, values in a_block(EVEN)]
    seam = np.array([[40.0, 40.0], [60.0, 40.0]])
    looks = [SeenChart(own, SEEN_AS_IT_IS), SeenChart(other, SEEN_AS_IT_IS, seam, reach_px)]
    alone, _ = found(outline_tiles(looks[:1], Reach(0.5, 0.5), EVEN, BOX))
    both, _ = found(outline_tiles(looks, Reach(0.5, 0.5), EVEN, BOX))
    lost = (painted(alone) > 0) & (painted(both) == 0)
    rows, columns = np.nonzero(lost)
    assert lost[40, 40:60].all()
    assert 40 - rows.min() <= reach_px + 18
    assert rows.max() - 40 <= reach_px + 18
    assert columns.max() - 60 <= reach_px + 18


def test_only_near_a_seam_other_charts_are_asked() -> None:
    seam = np.array([[40.0, 40.0], [60.0, 40.0]])
    own, other = a_block(WIDENING), [(strip, np.zeros_like(values)) for strip, values in a_block(WIDENING)]
    looks = [SeenChart(own, SEEN_AS_IT_IS), SeenChart(other, SEEN_AS_IT_IS, seam, 4.0)]
    tiles = outline_tiles(looks, Reach(0.5, 0.5), WIDENING, BOX)
    joined = painted(tiles.joined)
    assert joined.any()
    assert (painted(tiles.outline) > 0).any()
    assert not joined[: 40 - 4 - 16].any()
    assert not joined[40 + 4 + 16 :].any()
