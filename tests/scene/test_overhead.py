"""Lamps overhead: what becomes of a simplification there, and what is said of them."""

from math import hypot

import pytest

from kagezou.document import properties as p
from kagezou.document.figure_properties import SHAPE
from kagezou.document.model import Document
from kagezou.document.property import AnyProperty
from kagezou.scene.evaluate import evaluate
from kagezou.scene.filters import Simplify
from kagezou.scene.misfits import MisfitKind, misfits_at, misfits_of, new_misfits
from kagezou.scene.scene import ShadowCast
from tests.tools.tool_scenes import document_with

ABOVE = (p.LIGHT_POSITION, (500.0, -400.0, 0.0))
RADIUS, JOINED = (p.OVERHEAD_RADIUS, 300.0), (p.OVERHEAD_SIMPLIFY, 160.0)
Settings = tuple[AnyProperty, object]


def cast_of(document: Document) -> ShadowCast:
    cast = evaluate(document, 1).layers[0].cast
    assert cast is not None
    return cast


def kinds(document: Document) -> list[MisfitKind]:
    return [misfit.kind for misfit in misfits_at(document, 1)]


def test_straight_above_the_four_shadows_are_simplified_to_one() -> None:
    assert cast_of(document_with(ABOVE, RADIUS)).simplify is None
    cast = cast_of(document_with(ABOVE, RADIUS, JOINED, (p.DISTANCE, 200.0)))
    assert len(cast.lights) == 4
    assert cast.simplify == Simplify(160.0, 0.0, 0.0)


def test_on_the_way_there_it_grows_and_beyond_it_is_as_set() -> None:
    amounts = []
    for x in (500.0, 600.0, 700.0, 800.0, 900.0):
        lamp = (p.LIGHT_POSITION, (x, -400.0, 30.0))
        simplify = cast_of(document_with(lamp, RADIUS, JOINED, (p.SIMPLIFY, 10.0), (p.DISTANCE, 200.0))).simplify
        assert simplify is not None
        share = max(1 - hypot(x - 500, 30.0) / 300, 0.0)
        assert (simplify.amount_px, simplify.distance_px) == pytest.approx((10 + 150 * share, 200 * (1 - share)))
        amounts.append(simplify.amount_px)
    assert amounts == sorted(amounts, reverse=True)
    assert amounts[-1] == 10.0


def test_switched_off_simplifying_stays_off() -> None:
    assert cast_of(document_with(ABOVE, RADIUS, JOINED, (p.SIMPLIFY_ON, False))).simplify is None


def test_a_lamp_in_the_plane_of_the_drawing_is_told() -> None:
    dark = document_with(ABOVE)
    assert kinds(dark) == [MisfitKind.DARK]
    words = str(misfits_at(dark, 1)[0].message)
    assert words.startswith("the lamp is in the plane of A's drawing on frame 1")
    assert "light.overhead_radius = 350" in words  # half of 700 px


@pytest.mark.parametrize(
    "settings",
    [
        [ABOVE, RADIUS],
        [(p.LIGHT_POSITION, (500.0, -400.0, 60.0))],
        [(p.LIGHT_POSITION, (500.0, 2400.0, 0.0))],
        [ABOVE, (p.LIGHT_KIND, "sun")],
        [ABOVE, (SHAPE, "disc")],
        [(p.LIGHT_POSITION, (1500.0, -400.0, 0.0))],
        [ABOVE, (p.GROUNDING, ((450.0, 900.0), (550.0, 890.0)))],
        [ABOVE, (p.TILT, 40.0), (p.LIGHT_POSITION, (700.0, -400.0, 0.0))],
    ],
    ids=[
        "within the radius",
        "before the plane",
        "under the ground",
        "the sun",
        "a disc",
        "aside",
        "points",
        "a turned card",
    ],
)
def test_others_are_not_dark(settings: list[Settings]) -> None:
    assert kinds(document_with(*settings)) == []


def test_that_shadows_are_joined_is_told_once() -> None:
    before, above = document_with(RADIUS, JOINED), document_with(RADIUS, JOINED, ABOVE)
    said = new_misfits(misfits_of(before), misfits_of(above))
    assert [misfit.kind for misfit in said] == [MisfitKind.JOINED]
    assert "light.overhead_simplify" in str(said[0].message)
    further = document_with(RADIUS, JOINED, (p.LIGHT_POSITION, (520.0, -500.0, 0.0)))
    assert new_misfits(misfits_of(above), misfits_of(further)) == ()


@pytest.mark.parametrize(
    "settings",
    [
        [(p.SIMPLIFY, 170.0)],
        [(p.SIMPLIFY_ON, False)],
        [(SHAPE, "disc")],
        [(p.LIGHT_POSITION, (750.0, -400.0, 0.0))],
        [(p.LIGHT_KIND, "sun")],
    ],
    ids=["it is simplified more", "switched off", "a disc", "at the rim", "the sun"],
)
def test_where_nothing_is_joined_nothing_is_told(settings: list[Settings]) -> None:
    assert kinds(document_with(ABOVE, RADIUS, JOINED, *settings)) == []
