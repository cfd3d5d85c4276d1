"""Edits: what each one does, that nothing changes without need, and that documents stay sound."""

from pathlib import Path

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from kagezou.animation.ease import EASY
from kagezou.animation.track import Interpolation, Key, Track
from kagezou.document import edits, invariants
from kagezou.document.address import Address, addresses, path_of, resolve, track_of, value_of
from kagezou.document.linking import link
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure
from kagezou.document.properties import (
    FOV,
    GROUND_DECLINATION,
    GROUND_POSITION,
    GROUNDING,
    LIGHT_KIND,
    OPACITY,
    VISIBLE,
)
from kagezou.document.set_pieces import add_piece
from kagezou.document.set_properties import PIECE_LEAN
from kagezou.errors import UsageProblem
from kagezou.geometry.box import Box
from tests.documents import documents

CELS = Cels((Drawing("1", Path("/c/1.png")), Drawing("2", Path("/c/2.png"))), (Exposure(1, 0), Exposure(5, None)))
FIGURE = Box(10, 10, 50, 90)
HOLD, LINEAR, BEZIER = Interpolation.HOLD, Interpolation.LINEAR, Interpolation.BEZIER


@pytest.fixture
def document() -> Document:
    return edits.add_layer(Document(Canvas(100, 100, length_frames=3)), "A", CELS, FIGURE)


@pytest.fixture
def opacity(document: Document) -> Address:
    return Address(OPACITY, document.layers[0].id)


# ---- values


def test_a_constant_replaces_all_keys(document: Document, opacity: Address) -> None:
    keyed = edits.set_key(edits.set_key(document, opacity, 1, 0), opacity, 9, 1)
    assert track_of(edits.set_constant(keyed, opacity, 0.5), opacity) == Track(0.5)
    assert value_of(keyed, opacity, 5) == 0.5


def test_nothing_new_is_the_very_same_document(document: Document, opacity: Address) -> None:
    layer = document.layers[0]
    keyed = edits.set_key(document, opacity, 4, 0.5, BEZIER)
    assert edits.set_constant(document, opacity, OPACITY.default) is document
    assert edits.set_key(keyed, opacity, 4, 0.5) is keyed
    assert edits.set_key(keyed, opacity, 4, 0.5, BEZIER) is keyed
    assert edits.remove_key(document, opacity, 4) is document
    assert edits.rename_layer(document, layer.id, "A") is document
    assert edits.move_layer(document, layer.id, 0) is document
    assert edits.set_exposures(document, layer.id, layer.cels.exposures) is document
    assert edits.set_canvas(document, document.canvas) is document
    assert edits.set_background(document, None) is document


@given(documents(), st.data())
def test_setting_what_is_there_is_no_edit_on_any_document(document: Document, data: st.DataObject) -> None:
    address = data.draw(st.sampled_from(list(addresses(document))))
    track = track_of(document, address)
    assert edits.set_track(document, address, track) is document
    if not track.is_keyed:
        assert edits.set_constant(document, address, track.constant) is document


def test_an_edit_keeps_every_untouched_part(document: Document) -> None:
    two = edits.add_layer(document, "B", CELS, FIGURE)
    changed = edits.set_constant(two, Address(OPACITY, two.layers[1].id), 0.1)
    assert changed.layers[0] is two.layers[0]
    assert changed.tracks is two.tracks
    assert changed.canvas is two.canvas


def test_a_value_is_set_as_it_is_seen(document: Document, opacity: Address) -> None:
    assert track_of(edits.set_value(document, opacity, 0.25, frame=7), opacity) == Track(0.25)
    keyed = edits.set_key(document, opacity, 1, 0.5)
    assert [key.frame for key in track_of(edits.set_value(keyed, opacity, 0.25, frame=7), opacity).keys] == [1, 7]


def test_a_new_key_goes_on_as_the_one_before_it(document: Document, opacity: Address) -> None:
    first = edits.set_key(document, opacity, 5, 0.1)
    assert track_of(first, opacity).keys[0].interpolation is LINEAR
    held = edits.set_key(document, opacity, 5, 0.1, HOLD)
    for frame in (2, 9):
        key = track_of(edits.set_key(held, opacity, frame, 0.2), opacity).key_at(frame)
        assert key is not None
        assert key.interpolation is HOLD


def test_a_bezier_key_is_easy_in_every_component(document: Document) -> None:
    keyed = edits.set_key(document, Address(GROUND_POSITION), 3, [1, 2], BEZIER)
    assert track_of(keyed, Address(GROUND_POSITION)).keys == (Key(3, (1.0, 2.0), BEZIER, (EASY,) * 2, (EASY,) * 2),)


def test_a_key_keeps_its_eases_when_only_its_value_changes(document: Document, opacity: Address) -> None:
    keyed = edits.set_key(document, opacity, 3, 0.1, BEZIER)
    again = track_of(edits.set_key(keyed, opacity, 3, 0.9), opacity).keys[0]
    assert (again.value, again.interpolation, again.ease_out) == (0.9, BEZIER, (EASY,))
    assert track_of(edits.set_key(keyed, opacity, 3, 0.9, LINEAR), opacity).keys[0].ease_out == ()


def test_switches_and_choices_are_only_held(document: Document) -> None:
    visible = Address(VISIBLE, document.layers[0].id)
    keyed = edits.set_key(document, visible, 3, raw=False)
    assert track_of(keyed, visible).keys[0].interpolation is HOLD
    with pytest.raises(UsageProblem, match=r"light\.kind: a switch or choice can only be held, not keyed linear"):
        edits.set_key(document, Address(LIGHT_KIND), 3, "sun", LINEAR)


def test_keys_count_from_frame_one(document: Document, opacity: Address) -> None:
    with pytest.raises(UsageProblem, match="a key cannot lie on frame 0, frames count from 1"):
        edits.set_key(document, opacity, 0, 0.5)
    with pytest.raises(UsageProblem, match="2 is not a number from 0 to 1"):
        edits.set_key(document, opacity, 1, 2)


def test_the_last_key_taken_leaves_its_value(document: Document, opacity: Address) -> None:
    keyed = edits.set_key(document, opacity, 3, 0.1)
    assert track_of(edits.remove_key(keyed, opacity, 3), opacity) == Track(0.1)


# ---- layers and canvas


def test_a_layer_makes_the_cut_long_enough(document: Document) -> None:
    assert document.canvas.length_frames == 5
    assert edits.add_layer(document, "B", Cels(), FIGURE).canvas.length_frames == 5


def test_layers_get_free_ids_and_names(document: Document) -> None:
    three = edits.add_layer(edits.add_layer(document, "A", CELS, FIGURE), "A", CELS, FIGURE)
    assert [layer.name for layer in three.layers] == ["A", "A 2", "A 3"]
    assert [layer.id for layer in three.layers] == ["layer-1", "layer-2", "layer-3"]
    refilled = edits.add_layer(edits.remove_layer(three, "layer-2"), "C", CELS, FIGURE)
    assert [layer.id for layer in refilled.layers] == ["layer-1", "layer-3", "layer-2"]


def test_tracks_may_come_with_a_layer() -> None:
    document = edits.add_layer(Document(Canvas(9, 9)), "A", CELS, FIGURE, {"shadow.opacity": Track(0.1)})
    assert value_of(document, Address(OPACITY, "layer-1"), 1) == 0.1


def test_renaming(document: Document) -> None:
    two = edits.add_layer(document, "B", CELS, FIGURE)
    assert edits.rename_layer(two, "layer-1", "影.1").layers[0].name == "影.1"
    with pytest.raises(UsageProblem, match="there is already a layer named 'B'"):
        edits.rename_layer(two, "layer-1", "B")
    for name in ("", "  ", "a\nb", "a" * 201):
        with pytest.raises(UsageProblem, match="a layer cannot be named"):
            edits.rename_layer(two, "layer-1", name)


def test_moving(document: Document) -> None:
    three = edits.add_layer(edits.add_layer(document, "B", CELS, FIGURE), "C", CELS, FIGURE)
    assert [layer.name for layer in edits.move_layer(three, "layer-1", 2).layers] == ["B", "C", "A"]
    assert [layer.name for layer in edits.move_layer(three, "layer-3", 0).layers] == ["C", "A", "B"]


def test_exposures_canvas_and_background(document: Document) -> None:
    on_twos = (Exposure(1, 0), Exposure(3, 1))
    changed = edits.set_exposures(document, "layer-1", on_twos)
    assert changed.layers[0].cels.exposures == on_twos
    assert edits.set_canvas(document, Canvas(7, 8)).canvas == Canvas(7, 8)
    assert edits.set_background(document, Path("/bg.png")).background == Path("/bg.png")


def test_an_unknown_layer_is_a_key_error(document: Document) -> None:
    with pytest.raises(KeyError):
        document.layer("layer-9")
    with pytest.raises(KeyError):
        edits.set_constant(document, Address(OPACITY, "layer-9"), 0.5)


# ---- cels


def test_what_is_exposed() -> None:
    shown = {frame: CELS.drawing_at(frame) for frame in (0, 1, 4, 5, 99)}
    assert shown == {0: None, 1: CELS.drawings[0], 4: CELS.drawings[0], 5: None, 99: None}


# ---- addresses


def test_paths_and_addresses(document: Document) -> None:
    dotted = edits.rename_layer(document, "layer-1", "A.shadow")
    assert resolve(dotted, "layers.A.shadow.shadow.opacity") == Address(OPACITY, "layer-1")
    assert resolve(dotted, "camera.fov") == Address(FOV)
    for address in addresses(dotted):
        assert resolve(dotted, path_of(dotted, address)) == address


def test_an_unknown_path_names_the_nearest(document: Document) -> None:
    with pytest.raises(UsageProblem, match=r"did you mean layers\.A\.shadow\.opacity\?"):
        resolve(document, "layers.A.shadow.opcity")
    with pytest.raises(UsageProblem, match=r"there is no property '12345' in this project$"):
        resolve(document, "12345")
    with pytest.raises(UsageProblem):
        resolve(document, "layers.A.camera.fov")


# ---- soundness


@given(documents(), st.data())
def test_a_document_is_sound_after_every_edit(document: Document, data: st.DataObject) -> None:
    assume(document.layers)
    invariants.check(document)
    layer_id = data.draw(st.sampled_from([layer.id for layer in document.layers]))
    frame = data.draw(st.integers(1, 200))
    opacity, points = Address(OPACITY, layer_id), Address(GROUNDING, layer_id)
    for changed in (
        edits.set_constant(document, opacity, 0.5),
        edits.set_key(document, opacity, frame, 0.5),
        edits.set_key(document, points, frame, [[1, 2]], BEZIER),
        edits.set_key(document, Address(VISIBLE, layer_id), frame, raw=False),
        edits.set_key(document, Address(GROUND_DECLINATION), frame, 45, HOLD),
        edits.remove_key(document, opacity, frame),
        edits.add_layer(document, document.layers[0].name, CELS, FIGURE),
        edits.remove_layer(document, layer_id),
        edits.rename_layer(document, layer_id, edits.free_name(document, "New")),
        edits.move_layer(document, layer_id, data.draw(st.integers(0, 5))),
        edits.set_exposures(document, layer_id, (Exposure(frame, None),)),
    ):
        invariants.check(changed)


class TestUnset:
    """What is taken away is as if nobody had ever set it."""

    def test_of_scene_layer_and_piece(self) -> None:
        plain = edits.add_layer(Document(Canvas(100, 100)), "A", Cels(), Box(0, 0, 9, 9))
        plain = add_piece(plain, "Wall", "wall")
        for address, value in (
            (Address(FOV), 30.0),
            (Address(OPACITY, "layer-1"), 0.2),
            (Address(PIECE_LEAN, piece_id=plain.pieces[0].id), 5.0),
        ):
            changed = edits.set_key(plain, address, 3, value)
            assert changed != plain
            assert edits.unset(changed, address) == plain
            assert edits.unset(plain, address) is plain

    def test_of_a_linked_property_it_goes_from_all(self) -> None:
        plain = Document(Canvas(100, 100))
        for name in "AB":
            plain = edits.add_layer(plain, name, Cels(), Box(0, 0, 9, 9))
        address = Address(OPACITY, "layer-1")
        linked = link(edits.set_constant(plain, address, 0.2), address)
        assert edits.unset(linked, address).layers == plain.layers
