"""Simplified shadows held at the feet: against the exact shape slid as far, and that nothing jumps."""

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from kagezou.document.model import Document
from kagezou.document.set_pieces import add_piece
from kagezou.render.renderer import Renderer
from tests.effort import tries
from tests.render.passes.test_simplify import (
    MAX_AREA_ERROR,
    MAX_MEAN_SHIFT_PX,
    MAX_P99_SHIFT_PX,
    cast_of,
    coverage,
    on_ground,
    shadow_of,
    simplified,
)
from tests.render.reference import blurred
from tests.render.reference.figures import with_values
from tests.render.reference.outlines import Shift

HOLD = "layers.A.shadow.hold"

CASES = [
    ("plain", 40.0, 0.0, 1.0),
    ("plain", 90.0, 0.0, 0.5),
    ("plain", 200.0, 0.0, 1.0),
    ("plain", 90.0, 60.0, 1.0),
    ("two feet, roll, perspective", 200.0, 0.0, 1.0),
    ("sun on a folded card", 90.0, 0.0, 1.0),
    ("four lights, behind the feet too", 90.0, 0.0, 1.0),
    ("tilted, running out of the picture", 40.0, 0.0, 1.0),
]


def held(figure: Path, name: str, amount_px: float, distance_px: float, hold: float) -> Document:
    return with_values(simplified(figure, name, amount_px, distance_px), {HOLD: hold})


@pytest.mark.parametrize(("name", "amount", "distance", "hold"), CASES)
def test_it_is_the_exact_shape_slid_to_the_feet(
    renderer: Renderer, figure: Path, name: str, amount: float, distance: float, hold: float
) -> None:
    cast, shadow = cast_of(name), shadow_of(name)
    exact, slide = blurred.held(shadow, blurred.simplified(shadow, amount, distance), hold)
    wanted = exact.coverage(cast, 1000, 1000)
    got = coverage(renderer, held(figure, name, amount, distance, hold))
    shift = Shift.between(wanted, got)
    told = f"{shift}, slid by {slide}"
    assert shift.mean <= MAX_MEAN_SHIFT_PX, told
    assert shift.p99 <= MAX_P99_SHIFT_PX, told
    assert on_ground(cast, got) == pytest.approx(on_ground(cast, wanted), rel=MAX_AREA_ERROR), told


def test_it_goes_on_under_both_feet(renderer: Renderer, figure: Path) -> None:
    """The figure's feet are at row 900; what is simplified without hold has no shadow near them."""
    loose, kept = (coverage(renderer, held(figure, "plain", 200.0, 0.0, hold)) for hold in (0.0, 1.0))
    assert not loose[880:].any()
    assert kept[900, 460:540].min() == 1.0
    assert kept.sum() == pytest.approx(loose.sum(), rel=MAX_AREA_ERROR)


def test_none_at_all_is_the_shape_where_it_was(renderer: Renderer, figure: Path) -> None:
    for amount, distance in ((30.0, 60.0), (200.0, 0.0)):
        before = coverage(renderer, simplified(figure, "plain", amount, distance))
        assert np.array_equal(coverage(renderer, held(figure, "plain", amount, distance, 0.0)), before)


def test_a_shape_that_still_has_its_feet_stays(renderer: Renderer, figure: Path) -> None:
    before = coverage(renderer, simplified(figure, "plain", 30.0, 200.0))
    assert np.array_equal(coverage(renderer, held(figure, "plain", 30.0, 200.0, 1.0)), before)


def test_more_hold_or_a_wider_blur_moves_it_without_a_jump(renderer: Renderer, figure: Path) -> None:
    """Hold in steps of a hundredth, the blur in steps of 3 %: none changes much more than those beside it."""
    holds = [
        coverage(renderer, held(figure, "plain", 90.0, 0.0, each)) for each in np.linspace(0, 1, 21)[: tries(9, 21)]
    ]
    amounts = [
        coverage(renderer, held(figure, "plain", float(each), 0.0, 1.0))
        for each in 6.0 * 1.03 ** np.arange(tries(30, 90))
    ]
    for steps, most in ((holds, 0.12), (amounts, 0.06)):
        part = [float(np.abs(b - a).sum() / a.sum()) for a, b in pairwise(steps)]
        assert max(part) < most, part


def test_a_light_moved_by_one_px_moves_it_little(renderer: Renderer, figure: Path) -> None:
    base, place = held(figure, "plain", 90.0, 0.0, 1.0), [200.0, -200.0, 900.0]
    before = coverage(renderer, with_values(base, {"light.position": place}))
    for axis in range(3):
        moved = [each + (axis == index) for index, each in enumerate(place)]
        after = coverage(renderer, with_values(base, {"light.position": moved}))
        assert np.abs(after - before).sum() / before.sum() < 0.02


def test_on_a_wall_the_shape_is_slid_as_on_the_ground_and_meets_at_the_seam(renderer: Renderer, figure: Path) -> None:
    values = {"set.Back.position": [500.0, 800.0], "set.Back.width": 4000.0, "layers.A.upright": 1.0}
    loose, kept = (
        coverage(renderer, with_values(add_piece(held(figure, "plain", 60.0, 0.0, hold), "Back", "wall"), values))
        for hold in (0.0, 1.0)
    )
    assert not loose[895:].any()
    assert kept[897, 470:530].max() == 1.0
    assert kept[:800].sum() > 0.2 * kept.sum()
    # One row to the next, at the wall's foot as everywhere: the outline goes on.
    widths = (kept > 0.5).sum(axis=1)
    shown = np.flatnonzero(widths)
    assert np.abs(np.diff(kept[790:810] > 0.5, axis=0)).sum(axis=1).max() <= 14
    assert shown[-1] - shown[0] + 1 == len(shown)
