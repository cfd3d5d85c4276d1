"""What is marked on layers: locked ones are left alone, some are looked at alone, colours are known ones."""

from dataclasses import replace
from pathlib import Path

import pytest

from kagezou.document.address import Address
from kagezou.document.alike_names import folded, unlike
from kagezou.document.edits import (
    add_layer,
    duplicate_layers,
    free_name,
    join_layer,
    remove_layer,
    rename_layer,
    set_canvas,
    set_constant,
)
from kagezou.document.layer_marks import LABELS, NO_MARKS, LayerMarks
from kagezou.document.linking import link
from kagezou.document.marking import locked_and_changed, set_marks, soloed
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure
from kagezou.document.properties import OPACITY, VISIBLE
from kagezou.document.refitting import Refit, refitted
from kagezou.document.values import value_at
from kagezou.errors import UsageProblem
from kagezou.geometry.box import Box

CELS = Cels((Drawing("1", Path("/c/1.png")),), (Exposure(1, 0),))
OF_A = Address(OPACITY, "layer-1")


@pytest.fixture
def document() -> Document:
    document = Document(Canvas(40, 30))
    for name in ("A", "arm", "B"):
        document = add_layer(document, name, CELS, Box(1, 1, 20, 20))
    return join_layer(document, "layer-2", "layer-1")


def locked(document: Document, *ids: str) -> Document:
    return set_marks(document, ids, lambda marks: replace(marks, is_locked=True))


def test_marks_are_set_and_the_same_ones_change_nothing(document: Document) -> None:
    marked = set_marks(document, ("layer-1", "layer-3"), lambda _: LayerMarks(label="red"))
    assert [layer.marks.label for layer in marked.layers] == ["red", "", "red"]
    assert set_marks(marked, ("layer-1",), lambda _: LayerMarks(label="red")) is marked
    with pytest.raises(UsageProblem, match="no colour"):
        set_marks(document, ("layer-1",), lambda _: LayerMarks(label="mauve"))
    assert all(len(color) == 7 for color in LABELS.values())


def test_only_changes_of_locked_layers_are_noticed(document: Document) -> None:
    before = locked(document, "layer-1")
    assert locked_and_changed(before, set_constant(before, OF_A, 0.2)) == ("A",)
    assert locked_and_changed(before, set_constant(before, Address(OPACITY, "layer-3"), 0.2)) == ()
    assert locked_and_changed(before, remove_layer(before, "layer-1")) == ("A",)
    assert locked_and_changed(before, rename_layer(before, "layer-1", "C")) == ("A",)
    assert locked_and_changed(before, set_marks(before, ("layer-1",), lambda _: NO_MARKS)) == ()
    assert locked_and_changed(document, set_constant(document, OF_A, 0.2)) == ()
    assert locked_and_changed(before, before) == ()


def test_a_linked_property_would_change_a_locked_layer_too(document: Document) -> None:
    before = locked(link(document, OF_A), "layer-3")
    assert locked_and_changed(before, set_constant(before, OF_A, 0.2)) == ("B",)


def test_a_canvas_of_another_size_takes_locked_layers_along(document: Document) -> None:
    before = locked(document, "layer-1")
    assert locked_and_changed(before, refitted(before, 80, 60, Refit.SCALE).document) == ()
    longer = set_canvas(before, replace(before.canvas, length_frames=9))
    assert locked_and_changed(before, set_constant(longer, OF_A, 0.2)) == ("A",)


def shown(document: Document) -> list[bool]:
    return [value_at(layer.tracks, VISIBLE, 1) for layer in document.layers]


def test_a_figure_is_looked_at_alone_with_all_its_parts(document: Document) -> None:
    assert soloed(document) is document
    for layer_id, seen in (("layer-1", [True, True, False]), ("layer-2", [True, True, False]), ("layer-3", [0, 0, 1])):
        alone = set_marks(document, (layer_id,), lambda marks: replace(marks, is_solo=True))
        assert shown(soloed(alone)) == seen
        assert shown(alone) == [True, True, True], "the document itself shows all"


def test_a_copy_lies_above_its_original_and_a_figure_takes_its_parts_along(document: Document) -> None:
    marked = set_marks(document, ("layer-1",), lambda _: LayerMarks(is_locked=True))
    copied, ids = duplicate_layers(marked, ("layer-1",))
    assert [layer.name for layer in copied.layers] == ["A", "A 2", "arm", "arm 2", "B"]
    assert [copied.layer(each).name for each in ids] == ["A 2", "arm 2"]
    assert copied.layer(ids[1]).joins == ids[0]
    assert copied.layer(ids[0]).marks == NO_MARKS
    assert copied.layer("layer-2").joins == "layer-1"
    part, (only,) = duplicate_layers(document, ("layer-2",))
    assert part.layer(only).joins == "layer-1", "a copied part is one more of the same figure"
    assert len({layer.id for layer in copied.layers}) == 5


def test_no_two_layers_bear_names_that_look_alike(document: Document) -> None:
    assert free_name(document, "a") == "a 2"
    assert free_name(document, "ａ") == "ａ", "letters of another width are other letters"
    with pytest.raises(UsageProblem, match="already a layer"):
        rename_layer(document, "layer-3", "ARM")
    assert rename_layer(document, "layer-3", "b").layer("layer-3").name == "b", "its own name in other letters"
    decomposed = rename_layer(document, "layer-3", "が")
    assert free_name(decomposed, "か\u3099") == "か\u3099 2"


def test_names_are_alike_in_any_case_and_form() -> None:
    assert folded(" Straße ") == folded("STRASSE")
    assert unlike("scene", ["Scene", "SCENE 2"]) == "scene 3"
    assert unlike("scene", []) == "scene"
