"""Styles on characters: a whole look, a light only where it is asked for, and what is said of both."""

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.animation.track import Value
from kagezou.document import invariants
from kagezou.document.address import Address, path_of, value_of
from kagezou.document.edits import add_layer, join_layer, set_constant, set_key
from kagezou.document.linking import link
from kagezou.document.local_name import LocalName
from kagezou.document.model import Canvas, Cels, Document
from kagezou.document.properties import LIGHT_AZIMUTH, LIGHT_ELEVATION, LIGHT_KIND, OF_DOCUMENT, OF_LAYER, SIMPLIFY
from kagezou.document.style import LINES, Style
from kagezou.document.styling import LeftOut, Styled, notes_on, put_style
from kagezou.geometry.box import Box
from kagezou.io.clips.style_files import bundled_styles
from tests.documents import documents

BUNDLED = tuple(each.style for each in bundled_styles())
EVENING = next(each for each in BUNDLED if each.scene)
SIMPLE = next(each for each in BUNDLED if each.name.en == "Simple")
AZIMUTH = Address(LIGHT_AZIMUTH)


def style(values: Mapping[str, Value], figure_px: float = 500.0, scene: Mapping[str, Value] | None = None) -> Style:
    return Style(LocalName("a"), figure_px, MappingProxyType(values), MappingProxyType(scene or {}))


def cut(*heights: int) -> Document:
    document = Document(Canvas(1000, 1000, length_frames=48))
    for number, height in enumerate(heights or (500,)):
        document = add_layer(document, "ABC"[number], Cels(), Box(0, 100, 200, 100 + height))
    return document


def put(document: Document, wanted: Style, *, frame: int = 1, with_light: bool = False) -> Styled:
    """Put a style on everybody."""
    return put_style(document, [layer.id for layer in document.layers], wanted, frame, with_light=with_light)


def value(document: Document, name: str, frame: int = 1, layer_id: str = "layer-1") -> Value:
    address = Address(OF_LAYER[name], layer_id) if name in OF_LAYER else Address(OF_DOCUMENT[name])
    return value_of(document, address, frame)


def said(styled: Styled) -> list[str]:
    return [str(note) for note in notes_on(styled, "NAME", "TICK", lambda each: path_of(styled.document, each))]


class TestLook:
    def test_lengths_grow_with_the_character_and_areas_twice(self) -> None:
        wanted = style({"shadow.simplify": 30.0, "shadow.opacity": 0.4, "shadow.least_part": 30.0})
        tall = put(cut(1000), wanted).document
        names = ("shadow.simplify", "shadow.opacity", "shadow.least_part")
        assert [value(tall, name) for name in names] == [60.0, 0.4, 120.0]

    def test_a_length_beyond_its_range_is_kept_to_it_and_said(self) -> None:
        styled = put(cut(100_000), style({"shadow.simplify": 30.0}))
        assert value(styled.document, "shadow.simplify") == 500.0
        assert said(styled) == [
            "layers.A.shadow.simplify went to the end of the range: the character is very small or very tall"
        ]

    def test_what_is_keyed_gets_a_key_and_that_is_said(self) -> None:
        keyed = set_key(cut(), Address(SIMPLIFY, "layer-1"), 1, 5.0)
        styled = put(keyed, style({"shadow.simplify": 30.0}), frame=9)
        assert [value(styled.document, "shadow.simplify", frame) for frame in (1, 5, 9)] == [5.0, 17.5, 30.0]
        assert said(styled) == ["1 keyed property got a key on frame 9: layers.A.shadow.simplify"]
        both = set_key(keyed, Address(OF_LAYER["shadow.fade"], "layer-1"), 1, 5.0)
        names = "layers.A.shadow.simplify, layers.A.shadow.fade"
        assert said(put(both, style({}), frame=9)) == [f"2 keyed properties got a key on frame 9: {names}"]

    def test_a_keyed_property_that_has_that_very_key_is_not_spoken_of(self) -> None:
        once = put(set_key(cut(), Address(SIMPLIFY, "layer-1"), 1, 5.0), SIMPLE, frame=9)
        again = put(once.document, SIMPLE, frame=9)
        assert again.document is once.document
        assert (again.changes, said(again)) == ((), [])

    def test_a_part_stands_for_its_figure(self) -> None:
        joined = join_layer(cut(500, 300), "layer-2", "layer-1")
        on_part = put_style(joined, ["layer-2"], SIMPLE, 1).document
        assert on_part == put_style(joined, ["layer-1"], SIMPLE, 1).document
        assert value(on_part, "shadow.simplify") == 18.0
        assert put_style(joined, ["layer-2"], EVENING, 1, with_light=True).left_out is LeftOut.NOTHING

    def test_what_changes_on_a_linked_layer_is_a_change_too(self) -> None:
        linked = link(cut(500, 500), Address(SIMPLIFY, "layer-1"))
        styled = put_style(linked, ["layer-1"], style({"shadow.simplify": 30.0}), 1)
        assert [(each.address.layer_id, each.before, each.after) for each in styled.changes] == [
            ("layer-1", 0.0, 30.0),
            ("layer-2", 0.0, 30.0),
        ]


class TestOneAfterTheOther:
    """Two styles in turn give the same as the second alone."""

    @pytest.mark.parametrize("first", BUNDLED, ids=lambda each: each.name.en)
    @pytest.mark.parametrize("second", BUNDLED, ids=lambda each: each.name.en)
    @pytest.mark.parametrize("lights", [(False, False), (True, False), (True, True), (False, True)])
    def test_of_the_bundled_ones(self, first: Style, second: Style, lights: tuple[bool, bool]) -> None:
        both = put(put(cut(480, 700), first, with_light=lights[0]).document, second, with_light=lights[1]).document
        assert both == put(cut(480, 700), second, with_light=lights[1]).document

    @given(documents(), st.sampled_from(BUNDLED), st.sampled_from((*BUNDLED, style({}))), st.data())
    def test_on_any_cut(self, document: Document, first: Style, second: Style, data: st.DataObject) -> None:
        """At one frame keys are no exception: the second sets those that the first did."""
        first_lit, second_lit, frame = data.draw(st.booleans()), data.draw(st.booleans()), data.draw(st.integers(1, 99))
        once = put(document, first, frame=frame, with_light=first_lit).document
        invariants.check(once)
        both = put(once, second, frame=frame, with_light=second_lit).document
        if document.layers:
            assert both == put(document, second, frame=frame, with_light=second_lit).document

    def test_what_a_style_does_not_name_goes_to_its_default(self) -> None:
        changed = cut()
        for line in LINES:
            raw: Value | None = line.choices[-1] if line.choices else "#FFFFFF" if line.default == "#20203A" else None
            if isinstance(line.default, float):
                raw = line.high
            if raw is not None:
                changed = set_constant(changed, Address(line, "layer-1"), raw)
        assert changed != cut()
        assert (
            put(changed, style({"shadow.simplify": 30.0})).document
            == put(cut(), style({"shadow.simplify": 30.0})).document
        )


class TestLight:
    def test_it_is_left_out_unless_it_is_asked_for_and_that_is_said(self) -> None:
        styled = put(cut(), EVENING)
        assert styled.document.tracks == cut().tracks
        assert said(styled) == ["NAME came without its own light: TICK brings that too"]
        assert value(styled.document, "shadow.color") == "#3A1F4A"

    def test_asked_for_it_comes(self) -> None:
        styled = put(cut(), EVENING, with_light=True)
        assert {name: value(styled.document, name) for name in EVENING.scene} == dict(EVENING.scene)
        assert said(styled) == []
        assert LIGHT_KIND.name in {each.address.property.name for each in styled.changes}

    def test_it_never_comes_for_some(self) -> None:
        styled = put_style(cut(500, 500), ["layer-1"], EVENING, 1, with_light=True)
        assert styled.document.tracks == cut().tracks
        assert styled.left_out is LeftOut.NOT_EVERYBODY
        assert said(styled) == ["NAME came without its own light: light is for all characters, and only some are meant"]

    def test_nothing_is_said_where_the_light_is_so_already(self) -> None:
        lit = replace(put(cut(), EVENING, with_light=True).document, brought_light=None)
        assert said(put(lit, EVENING)) == []

    def test_ground_that_comes_along_is_spoken_of(self) -> None:
        grounded = style({}, scene={"ground.roll": 5.0})
        assert said(put(cut(), grounded)) == ["NAME came without its own light and ground: TICK brings that too"]

    def test_keys_of_the_light_get_a_key(self) -> None:
        keyed = set_key(cut(), AZIMUTH, 1, 0.0)
        styled = put(keyed, EVENING, frame=9, with_light=True)
        assert said(styled) == ["1 keyed property got a key on frame 9: light.azimuth"]
        assert value(styled.document, "light.azimuth", 1) == 0.0
        back = put(styled.document, SIMPLE, frame=9)
        assert back.document.tracks == keyed.tracks
        assert said(back) == ["the light that another style had brought was taken back"]

    def test_it_goes_with_its_style_while_nobody_has_touched_it(self) -> None:
        own = set_constant(cut(), Address(LIGHT_ELEVATION), 70.0)
        lit = put(own, EVENING, with_light=True).document
        back = put(lit, SIMPLE)
        assert back.document.tracks == own.tracks
        assert said(back) == ["the light that another style had brought was taken back"]
        assert put(lit, EVENING, with_light=True).document == lit

    def test_a_light_that_was_changed_since_is_the_cuts_own(self) -> None:
        lit = put(cut(), EVENING, with_light=True).document
        moved = set_constant(lit, AZIMUTH, -50.0)
        after = put(moved, SIMPLE)
        assert after.document.tracks == moved.tracks
        assert said(after) == []
        assert after.document.brought_light is None

    def test_a_style_for_some_leaves_the_light_of_all(self) -> None:
        lit = put(cut(500, 500), EVENING, with_light=True).document
        after = put_style(lit, ["layer-1"], SIMPLE, 1)
        assert after.document.tracks == lit.tracks
        assert after.document.brought_light == lit.brought_light
