"""What each property takes, in which form it is kept, and how it refuses the rest."""

from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kagezou.animation.track import components_of
from kagezou.document.properties import (
    COLOR,
    GROUND_POSITION,
    GROUNDING,
    LIGHT_KIND,
    LIGHT_POSITION,
    OF_DOCUMENT,
    OF_LAYER,
    OF_PIECE,
    OPACITY,
    OVERHEAD_RADIUS,
    TABLE,
    TILT,
    VISIBLE,
)
from kagezou.document.property import AnyProperty, Kind
from kagezou.errors import UsageProblem
from tests.documents import values

props = pytest.mark.parametrize("prop", TABLE, ids=lambda prop: prop.name)


@pytest.mark.parametrize(
    ("prop", "raw", "kept"),
    [
        (OPACITY, 1, 1.0),
        (OPACITY, 0.25, 0.25),
        (TILT, -75, -75.0),
        (GROUND_POSITION, [1, 2.5], (1.0, 2.5)),
        (GROUND_POSITION, (1.0, 2.5), (1.0, 2.5)),
        (LIGHT_POSITION, [1, 2, 3], (1.0, 2.0, 3.0)),
        (GROUNDING, [], ()),
        (GROUNDING, [[1, 2], (3, 4.5)], ((1.0, 2.0), (3.0, 4.5))),
        (COLOR, "#aabbcc", "#AABBCC"),
        (LIGHT_KIND, "sun", "sun"),
        (VISIBLE, False, False),
    ],
)
def test_canonical_form(prop: AnyProperty, raw: object, kept: object) -> None:
    value = prop.canonical(raw)
    assert value == kept
    assert type(value) is type(kept)


@pytest.mark.parametrize(
    ("prop", "raw", "wanted"),
    [
        (OPACITY, 1.01, "a number from 0 to 1"),
        (OPACITY, True, "a number"),
        (OPACITY, "0.5", "a number"),
        (OPACITY, None, "a number"),
        (OPACITY, float("nan"), "a number"),
        (OPACITY, float("inf"), "a number"),
        (OVERHEAD_RADIUS, 10**400, "a number from 0 to 100000 px"),
        (TILT, 75.5, "a number from -75 to 75 °"),
        (GROUND_POSITION, [1], "a point [x, y] in px"),
        (GROUND_POSITION, [1, 2, 3], "a point [x, y] in px"),
        (GROUND_POSITION, [1, "2"], "a point [x, y] in px, each within ±1e+06"),
        (GROUND_POSITION, [1, 2e6], "a point [x, y] in px, each within ±1e+06"),
        (GROUND_POSITION, [1, float("nan")], "a point [x, y] in px"),
        (GROUND_POSITION, {"x": 1}, "a point [x, y] in px"),
        (LIGHT_POSITION, [1, 2], "a point [x, y, z] in px"),
        (GROUNDING, [1, 2], "a point [x, y] in px"),
        (GROUNDING, [[0, 0]] * 65, "a list of at most 64 points"),
        (GROUNDING, "ab", "a list of at most 64 points"),
        (COLOR, "red", "a colour such as"),
        (COLOR, "#12345", "a colour such as"),
        (COLOR, "#12345G", "a colour such as"),
        (COLOR, "#１２３４５６", "a colour such as"),
        (COLOR, 0x123456, "a colour such as"),
        (LIGHT_KIND, "moon", 'one of "point", "sun"'),
        (LIGHT_KIND, ["sun"], 'one of "point", "sun"'),
        (VISIBLE, 1, "true or false"),
        (VISIBLE, "true", "true or false"),
    ],
)
def test_refusals_say_what_is_wanted(prop: AnyProperty, raw: object, wanted: str) -> None:
    with pytest.raises(UsageProblem) as caught:
        prop.canonical(raw)
    said = str(caught.value)
    assert said.startswith(f"{prop.name}: ")
    assert wanted in said
    assert len(said) < 200


@props
def test_the_default_is_canonical(prop: AnyProperty) -> None:
    assert prop.canonical(prop.default) == prop.default


@props
def test_the_table_has_words(prop: AnyProperty) -> None:
    assert str(prop.label)
    assert str(prop.help).endswith(".")
    assert prop.unit in {"", "px", "px²", "°", "%"}


@props
def test_component_names_match_the_components_of_values(prop: AnyProperty) -> None:
    parts = components_of(prop.default)
    if prop.kind is not Kind.POINTS:
        assert len(prop.components) == len(parts or ())
    assert prop.holds_only == (prop.kind in (Kind.CHOICE, Kind.SWITCH))


def test_names_are_unique_and_sorted_into_three_tables() -> None:
    assert len({(prop.scope, prop.name) for prop in TABLE}) == len(TABLE)
    assert set(OF_DOCUMENT) | set(OF_LAYER) | set(OF_PIECE) == {prop.name for prop in TABLE}
    assert len(OF_DOCUMENT) + len(OF_LAYER) + len(OF_PIECE) == len(TABLE)


@props
@settings(max_examples=25)
@given(st.data())
def test_valid_values_stay_as_they_are(prop: AnyProperty, data: st.DataObject) -> None:
    value = data.draw(values(prop))
    assert prop.canonical(value) == value


json_values: st.SearchStrategy[Any] = st.recursive(
    st.one_of(st.none(), st.booleans(), st.integers(), st.floats(), st.text(max_size=8)),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=3), inner, max_size=2),
    max_leaves=8,
)


@props
@settings(max_examples=25)
@given(json_values)
def test_anything_is_taken_or_refused_and_what_is_taken_is_stable(prop: AnyProperty, raw: object) -> None:
    try:
        value = prop.canonical(raw)
    except UsageProblem:
        return
    assert prop.canonical(value) == value
