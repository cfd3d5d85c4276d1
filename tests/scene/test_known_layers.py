"""What of a scene is evaluated anew after an edit: counted, and compared with a scene that knows nothing of before."""

from pathlib import Path

import pytest
from hypothesis import given

from kagezou.document import edits
from kagezou.document.address import Address
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure
from kagezou.document.properties import GROUND_ROLL, OF_LAYER, VISIBLE
from kagezou.geometry.box import Box
from kagezou.scene.evaluate import evaluate
from kagezou.scene.known_layers import KnownLayers
from tests.documents import documents

CELS = Cels((Drawing("1", Path("/c/1.png")),), (Exposure(1, 0),))
OPACITY = OF_LAYER["shadow.opacity"]


@pytest.fixture
def crowd() -> Document:
    """Five layers; the last of them joins the one below it."""
    document = Document(Canvas(400, 300, length_frames=24))
    for name in "ABCDE":
        document = edits.add_layer(document, name, CELS, Box(100, 50, 200, 250))
    return edits.join_layer(document, "layer-5", "layer-4")


def keyed(document: Document, layer_id: str, value: float) -> Document:
    return edits.set_key(document, Address(OPACITY, layer_id), 3, value)


def test_a_key_that_moves_has_one_layer_evaluated(crowd: Document) -> None:
    known, document = KnownLayers(), crowd
    evaluate(document, 3, known)
    assert known.times_made == 5
    for times, value in enumerate((0.1, 0.2, 0.3), start=1):
        document = keyed(document, "layer-2", value)
        scene = evaluate(document, 3, known)
        assert known.times_made == 5 + times
        assert scene == evaluate(document, 3)


def test_nothing_is_evaluated_again_where_no_layer_changed(crowd: Document) -> None:
    known = KnownLayers()
    first = evaluate(crowd, 3, known)
    again = evaluate(crowd, 3, known)
    assert known.times_made == 5
    assert all(now is before for now, before in zip(again.layers, first.layers, strict=True))


def test_a_figure_changes_with_each_of_its_layers(crowd: Document) -> None:
    known = KnownLayers()
    evaluate(crowd, 3, known)
    for times, layer_id in enumerate(("layer-4", "layer-5"), start=1):
        changed = keyed(crowd, layer_id, 0.2)
        assert evaluate(changed, 3, known) == evaluate(changed, 3)
        evaluate(crowd, 3, known)
        assert known.times_made == 5 + 4 * times


def test_another_frame_ground_or_canvas_changes_every_layer(crowd: Document) -> None:
    known = KnownLayers()
    evaluate(crowd, 3, known)
    evaluate(crowd, 4, known)
    assert known.times_made == 10
    tilted = edits.set_constant(crowd, Address(GROUND_ROLL), 5.0)
    assert evaluate(tilted, 4, known) == evaluate(tilted, 4)
    assert known.times_made == 15
    larger = edits.set_canvas(tilted, Canvas(800, 600, length_frames=24))
    assert evaluate(larger, 4, known) == evaluate(larger, 4)
    assert known.times_made == 20


def test_layers_that_are_hidden_or_gone_are_forgotten(crowd: Document) -> None:
    known = KnownLayers()
    evaluate(crowd, 3, known)
    hidden = edits.set_constant(crowd, Address(VISIBLE, "layer-1"), raw=False)
    assert [layer.id for layer in evaluate(hidden, 3, known).layers] == ["layer-2", "layer-3", "layer-4", "layer-5"]
    assert known.times_made == 5
    evaluate(crowd, 3, known)
    assert known.times_made == 6


@given(documents(), documents())
def test_whatever_was_known_the_scene_is_the_same(before: Document, after: Document) -> None:
    known = KnownLayers()
    evaluate(before, 1, known)
    assert evaluate(after, 1, known) == evaluate(after, 1)
    for layer in after.layers:
        changed = keyed(after, layer.id, 0.25)
        assert evaluate(changed, 1, known) == evaluate(changed, 1)
