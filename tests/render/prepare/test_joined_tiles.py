"""The tiles of several pieces at once: the same as those of each piece by itself."""

from collections.abc import Sequence

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera
from kagezou.geometry.ground import ground_plane
from kagezou.geometry.light import lamp
from kagezou.geometry.polygon import bounding_box
from kagezou.geometry.relief import Foothold, relief_card
from kagezou.geometry.shadow import Cast, cast_card
from kagezou.render.prepare.joined_tiles import JoinedTiling, joined_tiling
from kagezou.render.prepare.occupancy import Occupancy
from kagezou.render.prepare.piece_tiles import ENDS, limits_of, regions_of
from kagezou.render.prepare.shadow_tiles import Fineness, Tiling, tile_grid
from tests.render.prepare.test_shadow_tiles import DrawnMatte, painted
from tests.render.reference.figures import figure_alpha

CANVAS = Box(0, 0, 500, 500)
FINE = Fineness(1.25)
ALPHA = figure_alpha(500)[95:452, 170:340]
MATTE = DrawnMatte(Box(170, 95, 340, 452), Occupancy(ALPHA, 0))
FEET = (Foothold((220.0, 449.0), 449.0, is_planted=True), Foothold((282.0, 436.0), 436.0, is_planted=True))


def casts_of(light: tuple[float, float, float], fov: float = 0.0) -> tuple[tuple[Cast, ...], list[np.ndarray]]:
    camera, ground = Camera(500, 500, fov), ground_plane((250.0, 450.0), 3.0, 60.0)
    card = relief_card(camera, ground, FEET, 350.0)
    casts = cast_card(camera, ground, card, lamp(light))
    return casts, [card.pieces[cast.number].part_of(MATTE.box) for cast in casts]


def each_alone(casts: Sequence[Cast]) -> list[Tiling]:
    found = []
    for cast in casts:
        region = bounding_box(cast.region(CANVAS, MATTE.box))
        if region is not None:
            found.append(tile_grid(cast, region, MATTE, FINE).tiling(CANVAS))
    return found


def all_boxes(tiling: JoinedTiling) -> np.ndarray:
    return np.concatenate([tiling.full, *(boxes for boxes, _ in tiling.edges.values())])


def joined(casts: Sequence[Cast], parts: Sequence[np.ndarray]) -> JoinedTiling:
    regions = regions_of(casts, parts, MATTE.box, CANVAS)
    kept = [(cast, region) for cast, region in zip(casts, regions, strict=True) if region is not None]
    return joined_tiling([cast for cast, _ in kept], [region for _, region in kept], MATTE, FINE, CANVAS)


@given(st.floats(-100, 600), st.floats(-500, 0), st.floats(150, 700), st.sampled_from([0.0, 40.0]))
def test_tiles_are_those_of_each_piece_alone(x: float, y: float, z: float, fov: float) -> None:
    casts, parts = casts_of((x, y, z), fov)
    tiling, alone = joined(casts, parts), each_alone(casts)
    full = sum((painted(each.full, CANVAS) for each in alone), np.zeros((500, 500), int))
    drawn = sum((painted(each.boxes, CANVAS) for each in alone), np.zeros((500, 500), int))
    assert (painted(tiling.full, CANVAS) <= full).all()
    # The box of a region may be a tile larger than the other way finds it.
    both = painted(all_boxes(tiling), CANVAS)
    assert np.maximum(both - drawn, 0).sum() <= 0.02 * drawn.sum()


@pytest.mark.parametrize("fov", [0.0, 40.0])
@pytest.mark.parametrize(
    "light", [(100.0, -120.0, 480.0), (0.0, 0.0, 150.0), (500.0, 40.0, 300.0), (250.0, 200.0, 60.0)]
)
def test_every_shaded_pixel_is_drawn_once_a_piece_with_its_own_number(
    light: tuple[float, float, float], fov: float
) -> None:
    casts, parts = casts_of(light, fov)
    tiling = joined(casts, parts)
    y, x = np.mgrid[0:500, 0:500] + 0.5
    places = np.stack([x, y, np.ones_like(x)])
    covered = painted(tiling.full, CANVAS)
    by_piece = np.zeros((len(casts), 500, 500), int)
    for kind, (boxes, numbers) in tiling.edges.items():
        assert ((numbers % ENDS == 0) | kind.is_at_one).all()
        for number in range(len(casts)):
            by_piece[number] += painted(boxes[numbers // ENDS == number], CANVAS)
    assert by_piece.max() == 1
    for number, cast in enumerate(casts):
        u, v, w = np.tensordot(cast.art_from_canvas, places, axes=1)
        inside = (np.tensordot(limits_of([cast])[0], places, axes=1) > 0).all(axis=0) & (w > 1e-9)
        w = np.where(inside, w, 1.0)
        column, row = np.floor(u / w).astype(int) - 170, np.floor(v / w).astype(int) - 95
        on_art = inside & (column >= 0) & (column < 170) & (row >= 0) & (row < 357)
        shaded = np.zeros((500, 500), bool)
        shaded[on_art] = ALPHA[row[on_art], column[on_art]] > 0
        assert ((by_piece[number] + covered)[shaded] > 0).all()


def test_kinds_of_few_pixels_are_drawn_as_others_that_do_no_less() -> None:
    casts, parts = casts_of((100.0, -120.0, 480.0))
    tiling = joined(casts, parts)
    kinds = {kind for each in each_alone(casts) for kind in each.edges}
    assert len(tiling.edges) < len(kinds)
    assert len({kind.switches for kind in tiling.edges}) == len(tiling.edges)


def test_a_part_as_high_as_the_lamp_is_cut_instead_of_projected() -> None:
    casts, parts = casts_of((250.0, 200.0, 60.0))
    regions = regions_of(casts, parts, MATTE.box, CANVAS)
    for cast, region in zip(casts, regions, strict=True):
        wanted = bounding_box(cast.region(CANVAS, MATTE.box))
        if region is not None and wanted is not None:
            both = region.intersection(wanted)
            assert both is not None
            assert both.width * both.height >= 0.9 * min(region.width * region.height, wanted.width * wanted.height)
    assert len(regions) == len(casts)


def test_sides_and_limits_are_filled_up() -> None:
    casts, _ = casts_of((100.0, -120.0, 480.0))
    for cast in casts:
        forms = limits_of([cast])[0]
        assert forms.shape == (ENDS, 3)
        assert forms[0] == pytest.approx(cast.side)
        assert (forms[1 + len(cast.limits) :] == (0.0, 0.0, 1e6)).all()
