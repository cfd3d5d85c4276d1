"""The value of a property at a frame is its track's, of the property's own type."""

from types import MappingProxyType

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kagezou.animation.track import Track
from kagezou.document.model import NO_TRACKS
from kagezou.document.properties import COLOR, GROUND_POSITION, GROUNDING, OPACITY, TABLE, VISIBLE
from kagezou.document.property import AnyProperty
from kagezou.document.values import rgb_at, value_at
from tests.documents import tracks

props = pytest.mark.parametrize("prop", TABLE, ids=lambda prop: f"{prop.scope}-{prop.name}")


@props
@settings(max_examples=25)
@given(st.data(), st.floats(1, 1001))
def test_the_value_is_that_of_the_track(prop: AnyProperty, data: st.DataObject, frame: float) -> None:
    track = data.draw(tracks(prop))
    value = value_at(MappingProxyType({prop.name: track, "another": Track(0.5)}), prop, frame)
    assert value == track.value_at(frame)
    assert type(value) is type(prop.default)


@props
def test_what_was_never_set_has_its_default(prop: AnyProperty) -> None:
    assert value_at(NO_TRACKS, prop, 1) == prop.default
    assert value_at(MappingProxyType({"another": Track(0.5)}), prop, 1) == prop.default


@pytest.mark.parametrize(
    ("prop", "value"),
    [(OPACITY, True), (OPACITY, "0.5"), (VISIBLE, 1.0), (COLOR, 0.0), (GROUND_POSITION, 2.0), (GROUNDING, "point")],
)
def test_a_track_of_another_property_is_no_value(prop: AnyProperty, value: float | str) -> None:
    with pytest.raises(TypeError, match=f"^{prop.name} cannot be "):
        value_at(MappingProxyType({prop.name: Track(value)}), prop, 1)


def test_a_colour_is_three_numbers() -> None:
    assert rgb_at(NO_TRACKS, COLOR, 1) == (0x20, 0x20, 0x3A)
    assert rgb_at(MappingProxyType({COLOR.name: Track("#00FF7F")}), COLOR, 1) == (0, 255, 127)
