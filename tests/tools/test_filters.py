"""The handles of the filters: a line across the shadow, and an arrow for each wave."""

import pytest

from kagezou.document import properties
from kagezou.document.model import Document
from kagezou.document.property import AnyProperty
from kagezou.document.wave_properties import SLITS
from kagezou.tools.handles import handles_of
from kagezou.tools.pointer import Modifiers
from kagezou.tools.view import CanvasView
from tests.tools.tool_scenes import LAYER, Hand, document_with, handle, number

Settings = tuple[tuple[AnyProperty, object], ...]
SUN: Settings = (
    (properties.LIGHT_KIND, "sun"), (properties.LIGHT_AZIMUTH, 0.0), (properties.LIGHT_ELEVATION, 45.0),
)  # fmt: skip
SIMPLE: Settings = (*SUN, (properties.SIMPLIFY, 40.0), (properties.DISTANCE, 200.0))
WAVY: Settings = (
    *SUN, (properties.WAVE1.amplitude, 5.0), (properties.WAVE1.wavelength, 100.0), (properties.WAVE1.direction, 0.0),
)  # fmt: skip


def ids(document: Document) -> set[str]:
    found = {each.id for each in handles_of(document, 1, LAYER, CanvasView()).handles}
    return {each for each in found if each.startswith("filter.")}


@pytest.mark.parametrize(
    ("settings", "wanted"),
    [
        (SUN, set()),
        (SIMPLE, {"filter.distance"}),
        ((*SIMPLE, (properties.SIMPLIFY_ON, False)), set()),
        (WAVY, {"filter.wave1"}),
        ((*WAVY, (properties.WAVE2.amplitude, 1.0)), {"filter.wave1", "filter.wave2"}),
        ((*WAVY, (properties.WAVES_ON, False)), set()),
        ((*SUN, (SLITS, 0.5)), {"filter.wave1"}),
        ((*SUN, (SLITS, 0.5), (properties.WAVE2.amplitude, 1.0)), {"filter.wave1", "filter.wave2"}),
    ],
)
def test_only_filters_in_use_have_handles(settings: Settings, wanted: set[str]) -> None:
    assert ids(document_with(*settings)) == wanted


class TestDistance:
    def test_the_line_lies_on_the_ground_where_the_shadow_falls(self) -> None:
        """At a declination of 60° a px of the ground is half a px high; the shadow falls away from the viewer."""
        assert handle(document_with(*SIMPLE), "filter.distance").canvas_px == pytest.approx((745.0, 800.0))
        toward = document_with(*SIMPLE, (properties.LIGHT_AZIMUTH, 180.0))
        assert handle(toward, "filter.distance").canvas_px == pytest.approx((745.0, 1000.0))

    def test_dragging_it_sets_the_distance(self) -> None:
        hand = Hand(document_with(*SIMPLE), "filter.distance")
        assert number(hand.to(0, -50), properties.DISTANCE) == pytest.approx(300.0)
        assert number(hand.to(80, 50), properties.DISTANCE) == pytest.approx(100.0)

    def test_it_stops_at_the_feet(self) -> None:
        assert number(Hand(document_with(*SIMPLE), "filter.distance").to(0, 400), properties.DISTANCE) == 0.0

    def test_it_can_be_pulled_out_of_the_feet_again(self) -> None:
        near = document_with(*SIMPLE, (properties.DISTANCE, 0.0))
        assert number(Hand(near, "filter.distance").to(0, -30), properties.DISTANCE) == pytest.approx(60.0)


class TestWave:
    def test_the_arrow_is_one_wavelength_where_the_crests_go(self) -> None:
        document = document_with(*WAVY)
        start, end = next(
            each for each in handles_of(document, 1, LAYER, CanvasView()).guides if each.kind == "wave"
        ).points
        assert (end[0] - start[0], end[1] - start[1]) == pytest.approx((100.0, 0.0))
        assert handle(document, "filter.wave1").canvas_px == pytest.approx(end)

    def test_dragging_its_end_turns_and_stretches(self) -> None:
        hand = Hand(document_with(*WAVY), "filter.wave1")
        longer = hand.to(60, 0)
        assert number(longer, properties.WAVE1.wavelength) == pytest.approx(160.0)
        assert number(longer, properties.WAVE1.direction) == pytest.approx(0.0)
        turned = hand.to(-100, 40)
        assert number(turned, properties.WAVE1.direction) == pytest.approx(90.0)
        assert number(turned, properties.WAVE1.wavelength) == pytest.approx(80.0)

    def test_it_keeps_to_steps_and_to_its_range(self) -> None:
        hand = Hand(document_with(*WAVY), "filter.wave1")
        steps = Modifiers(constrain=True)
        assert number(hand.to(0, 24, steps), properties.WAVE1.direction) == pytest.approx(30.0)
        assert number(hand.to(-99.9, 0), properties.WAVE1.wavelength) == properties.WAVE1.wavelength.low
