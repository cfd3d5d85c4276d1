"""A cut with margins around its canvas: every place goes along, and the eye stays where it is."""

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.document.address import Address, addresses, value_of
from kagezou.document.edits import add_layer, set_constant, set_key
from kagezou.document.figure_properties import ANCHOR, BACKGROUND_POSITION, POSITION
from kagezou.document.lengths import PLACES
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure
from kagezou.document.properties import FOV, GROUND_POSITION, GROUNDING, LIGHT_POSITION, TABLE
from kagezou.document.property import Kind
from kagezou.document.roomier import roomier
from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera
from kagezou.geometry.vectors import Vector4
from tests.documents import documents

GROUND, LIGHT, FEET, PLACE = (
    Address(GROUND_POSITION),
    Address(LIGHT_POSITION),
    Address(GROUNDING, "layer-1"),
    Address(POSITION, "layer-1"),
)


def cut() -> Document:
    cels = Cels((Drawing("1", Path("/a.png")), Drawing("2", Path("/b.png"), size_px=(10, 20))), (Exposure(1, 0),))
    return add_layer(Document(Canvas(200, 100)), "A", cels, Box(60, 20, 90, 80))


def eye(of: Document) -> Vector4:
    fov = value_of(of, Address(FOV), 1)
    assert isinstance(fov, float)
    return Camera(of.canvas.width_px, of.canvas.height_px, fov).eye


def test_places_move_whether_they_were_set_or_not() -> None:
    before = set_constant(cut(), FEET, [[70, 80], [85, 79]])
    before = set_key(set_key(before, LIGHT, 1, [10, -20, 300]), LIGHT, 9, [20, -20, 300])
    after = roomier(before, 40, 30)
    assert (after.canvas.width_px, after.canvas.height_px) == (280, 160)
    assert value_of(after, GROUND, 1) == (40.0, 30.0)
    assert value_of(after, FEET, 1) == ((110.0, 110.0), (125.0, 109.0))
    assert [value_of(after, LIGHT, frame) for frame in (1, 5, 9)] == [
        (50.0, 10.0, 300.0),
        (55.0, 10.0, 300.0),
        (60.0, 10.0, 300.0),
    ]
    assert after.layers[0].figure == Box(100, 50, 130, 110)


def test_what_is_usual_follows_its_canvas() -> None:
    for address in (PLACE, Address(BACKGROUND_POSITION)):
        assert value_of(roomier(cut(), 40, 30), address, 1) == (140.0, 80.0)
    assert value_of(roomier(set_constant(cut(), PLACE, [1, 2]), 40, 30), PLACE, 1) == (41.0, 32.0)


def test_drawings_stay_as_large_as_they_were() -> None:
    sizes = [each.size_px for each in roomier(cut(), 40, 30).layers[0].cels.drawings]
    assert sizes == [(200, 100), (10, 20)]


@pytest.mark.parametrize("fov", [0.0, 1.0, 35.0, 120.0])
def test_the_eye_stays_where_it_is(fov: float) -> None:
    before = set_constant(cut(), Address(FOV), fov)
    after = roomier(before, 40, 30)
    x, y, z, w = eye(before)
    assert eye(after) == pytest.approx((x + 40 * w, y + 30 * w, z, w))


@given(documents(), st.integers(0, 500), st.integers(0, 500))
def test_everything_that_is_no_place_is_as_it_was(document: Document, across: int, down: int) -> None:
    after = roomier(document, across, down)
    moved = {"ground.position", "light.position", "background.position", "position", "grounding", "camera.fov"}
    for address in addresses(document):
        if address.property.name not in moved | {"anchor"}:
            assert value_of(after, address, 7) == value_of(document, address, 7)


def test_every_place_in_the_table_is_known() -> None:
    """A new property whose values are places has to go along, too."""
    kinds = (Kind.POINT, Kind.PLACE, Kind.POINTS)
    assert {line for line in TABLE if line.kind in kinds and line.unit == "px"} == {*PLACES, ANCHOR}
