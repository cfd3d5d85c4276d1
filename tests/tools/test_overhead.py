"""The rim within which a lamp is overhead: where it is seen, and what dragging it does."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.document import properties as p
from kagezou.document.model import Document
from kagezou.document.property import AnyProperty
from kagezou.geometry.camera import project
from kagezou.geometry.light import foot_of
from kagezou.scene.evaluate import camera_at, ground_at
from kagezou.tools.handle import GuideKind
from kagezou.tools.overhead import LEAST_VIEW_PX, OVERHEAD
from kagezou.tools.view import CanvasView
from tests.tools.tool_scenes import Hand, document_with, handle, handles, number

ABOVE = (p.LIGHT_POSITION, (500.0, -100.0, 0.0))
SLOPE = 3**-0.5  # cot 60°, the default declination: the ground rises so far for each px away from the viewer


def rim_of(document: Document) -> list[tuple[float, float]]:
    return [
        point for guide in handles(document).guides if guide.kind is GuideKind.OVERHEAD_AREA for point in guide.points
    ]


def test_the_rim_lies_on_the_ground_around_the_feet() -> None:
    document = document_with(ABOVE, (p.OVERHEAD_RADIUS, 200.0))
    rim = rim_of(document)
    assert len(rim) == 64
    for x, y in rim:
        assert ((x - 500) / 200) ** 2 + ((y - 900) / (200 * SLOPE)) ** 2 == pytest.approx(1.0)
    assert handle(document, OVERHEAD).canvas_px == pytest.approx((700.0, 900.0))
    assert handle(document, OVERHEAD).address is not None


def test_a_lamp_on_the_rim_stands_where_it_ceases_to_be_overhead() -> None:
    """The rim is what lies straight under such lamps, in a rolled ground and in perspective, too."""
    values = [(p.GROUND_ROLL, 20.0), (p.FOV, 40.0), (p.OVERHEAD_RADIUS, 150.0)]
    document = document_with(ABOVE, *values)
    camera, ground = camera_at(document, 1), ground_at(document, 1)
    nx, ny, _ = ground.normal
    below = (650.0, 900.0 - nx * 150.0 / ny, 0.0)
    assert foot_of(ground, below) == pytest.approx(below)
    assert handle(document, OVERHEAD).canvas_px == pytest.approx(project(camera.canvas_from_world(), (*below, 1.0)))


def test_dragged_it_is_wider_or_narrower_and_never_below_nothing() -> None:
    document = document_with(ABOVE, (p.OVERHEAD_RADIUS, 200.0))
    assert number(Hand(document, OVERHEAD).to(50, 0), p.OVERHEAD_RADIUS) == pytest.approx(250.0)
    assert number(Hand(document, OVERHEAD).to(-120, 0), p.OVERHEAD_RADIUS) == pytest.approx(80.0)
    assert number(Hand(document_with(ABOVE), OVERHEAD).to(-10, 0), p.OVERHEAD_RADIUS) == 0.0


def test_with_no_radius_the_grip_lies_beside_the_feet_and_gives_one() -> None:
    document = document_with(ABOVE)
    assert rim_of(document) == []
    view = CanvasView(2.0)
    grip = next(each for each in handles(document, view).handles if each.id == OVERHEAD)
    assert grip.canvas_px == pytest.approx((500.0 + LEAST_VIEW_PX / 2, 900.0))
    assert number(Hand(document, OVERHEAD).to(40, 0), p.OVERHEAD_RADIUS) == pytest.approx(40.0)


@given(st.floats(60, 400), st.floats(-60, 60), st.floats(10, 85), st.floats(0, 60), st.floats(-25, 200))
def test_it_ends_under_the_hand(radius: float, roll: float, declination: float, fov: float, way: float) -> None:
    settings = [(p.OVERHEAD_RADIUS, radius), (p.GROUND_ROLL, roll), (p.GROUND_DECLINATION, declination), (p.FOV, fov)]
    hand = Hand(document_with(ABOVE, *settings), OVERHEAD)
    x, y = hand.handle.canvas_px
    # Toward where the rim goes when it grows, which is a straight line on the canvas.
    along = ((x - 500) / (x - 500), (y - 900) / (x - 500))
    after = handle(hand.to(way * along[0], way * along[1]), OVERHEAD).canvas_px
    assert after == pytest.approx((x + way * along[0], y + way * along[1]), abs=0.01)


def test_seen_edge_on_the_way_along_the_ground_line_counts() -> None:
    document = document_with(ABOVE, (p.OVERHEAD_RADIUS, 200.0), (p.GROUND_DECLINATION, 90.0))
    assert number(Hand(document, OVERHEAD).to(30, 12), p.OVERHEAD_RADIUS) == pytest.approx(230.0)


@pytest.mark.parametrize(
    "settings",
    [
        [(p.LIGHT_POSITION, (1200.0, -100.0, 0.0))],
        [(p.LIGHT_POSITION, (500.0, -100.0, 900.0))],
        [ABOVE, (p.LIGHT_KIND, "sun"), (p.OVERHEAD_RADIUS, 100.0)],
        [ABOVE, (p.GROUND_ROLL, 90.0), (p.OVERHEAD_RADIUS, 100.0)],
    ],
    ids=["a lamp aside", "a lamp before the figure", "the sun", "a ground on its side"],
)
def test_it_is_hidden_where_it_means_nothing(settings: list[tuple[AnyProperty, object]]) -> None:
    document = document_with(*settings)
    assert rim_of(document) == []
    assert handles(document).find(OVERHEAD) is None


def test_the_grip_says_when_the_lamp_is_outside() -> None:
    inside = document_with(ABOVE, (p.OVERHEAD_RADIUS, 200.0))
    assert str(handle(inside, OVERHEAD).label) == "Overhead radius"
    aside = document_with((p.LIGHT_POSITION, (900.0, -100.0, 0.0)), (p.OVERHEAD_RADIUS, 150.0))
    assert str(handle(aside, OVERHEAD).label) == "Overhead radius; the lamp is 250 px outside it"
    assert len(rim_of(aside)) == 64
