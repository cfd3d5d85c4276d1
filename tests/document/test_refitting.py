"""A cut on a canvas of another size: every pixel lies where it lay, or all of it becomes larger alike."""

from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kagezou.animation.track import components_of
from kagezou.document.address import Address, value_of
from kagezou.document.edits import add_layer, set_background, set_constant, set_key
from kagezou.document.figure_properties import ANCHOR, BACKGROUND_POSITION, POSITION, ROTATION, SCALE
from kagezou.document.invariants import check
from kagezou.document.model import BroughtLight, Canvas, Cels, Document, Drawing, Exposure, Piece, drawing_offset
from kagezou.document.properties import FOV, GROUND_POSITION, GROUNDING, LIGHT_POSITION, SIMPLIFY
from kagezou.document.refitting import Refit, refitted
from kagezou.document.set_properties import PIECE_WIDTH
from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera
from kagezou.geometry.placement import canvas_from_centred
from kagezou.geometry.vanishing import VanishingLines
from kagezou.geometry.vectors import Point2
from kagezou.scene.placing import background_at, whole_placement
from tests.documents import documents

A = "layer-1"
sizes = st.tuples(st.integers(1, 3000), st.integers(1, 3000))


def cut(size: tuple[int, int] = (200, 100), drawn: tuple[int, int] | None = (51, 40)) -> Document:
    cels = Cels((Drawing("1", Path("/a.png"), size_px=drawn),), (Exposure(1, 0),))
    return add_layer(Document(Canvas(*size)), "A", cels, Box(60, 20, 90, 80))


def seen(document: Document, pixel: Point2, frame: int = 1) -> Point2:
    """Return where a point of the first drawing is seen."""
    layer = document.layers[0]
    left, top = drawing_offset(document.canvas, layer)
    x, y, _ = canvas_from_centred(whole_placement(document, layer, frame)) @ (pixel[0] + left, pixel[1] + top, 1)
    return (float(x), float(y))


@pytest.mark.parametrize("turn_deg", [0.0, 30.0])
@pytest.mark.parametrize("refit", Refit)
@given(old=sizes, new=sizes, drawn=st.sampled_from([(51, 40), (50, 41), None]))
def test_every_pixel_of_a_drawing_goes_where_places_go(
    old: tuple[int, int], new: tuple[int, int], drawn: tuple[int, int] | None, refit: Refit, turn_deg: float
) -> None:
    (width, height), (wide, high) = old, new
    before = cut(old, drawn)
    if turn_deg:
        before = set_constant(set_constant(before, Address(ROTATION, A), turn_deg), Address(SCALE, A), [-80, 120])
        before = set_key(set_key(before, Address(POSITION, A), 1, [10, 20]), Address(POSITION, A), 9, [90, 40])
        before = set_constant(before, Address(ANCHOR, A), [7, 3])
    before = set_constant(before, Address(GROUNDING, A), [seen(before, (12.0, 30.0), 5)])
    after = refitted(before, wide, high, refit).document
    assert (after.canvas.width_px, after.canvas.height_px) == (wide, high)
    for corner in ((0.0, 0.0), (12.0, 30.0), (51.0, 7.0)):
        factor = min(wide / width, high / height) if refit is Refit.SCALE else 1.0
        x, y = seen(before, corner, 5)
        left, top = {
            Refit.STAY: (0.0, 0.0),
            Refit.CENTRE: ((wide - width) // 2, (high - height) // 2),
            Refit.SCALE: ((wide - factor * width) / 2, (high - factor * height) / 2),
        }[refit]
        assert seen(after, corner, 5) == pytest.approx((x * factor + left, y * factor + top), abs=1e-6)
    grounding = components_of(value_of(after, Address(GROUNDING, A), 5))
    assert grounding == pytest.approx(seen(after, (12.0, 30.0), 5), abs=1e-6)


def test_what_lies_in_the_middle_needs_no_place_of_its_own() -> None:
    for refit, size in ((Refit.CENTRE, (300, 160)), (Refit.SCALE, (600, 300)), (Refit.SCALE, (666, 333))):
        after = refitted(set_background(cut(drawn=(50, 40)), Path("/bg.png")), *size, refit).document
        assert POSITION.name not in after.layers[0].tracks
        assert BACKGROUND_POSITION.name not in after.tracks


def test_places_and_lengths_follow_and_angles_stay() -> None:
    before = set_constant(set_constant(cut(), Address(LIGHT_POSITION), [10, -20, 300]), Address(SIMPLIFY, A), 20)
    before = replace(before, pieces=(Piece("piece-1", "wall"),))
    stay, centre, scale = (refitted(before, 400, 200, refit).document for refit in Refit)
    assert [value_of(each, Address(LIGHT_POSITION), 1) for each in (stay, centre, scale)] == [
        (10.0, -20.0, 300.0),
        (110.0, 30.0, 300.0),
        (20.0, -40.0, 600.0),
    ]
    assert [value_of(each, Address(GROUND_POSITION), 1) for each in (stay, centre)] == [(0.0, 0.0), (100.0, 50.0)]
    assert [value_of(each, Address(SIMPLIFY, A), 1) for each in (stay, centre, scale)] == [20.0, 20.0, 40.0]
    assert value_of(scale, Address(PIECE_WIDTH, piece_id="piece-1"), 1) == 2 * PIECE_WIDTH.default
    assert value_of(scale, Address(SCALE, A), 1) == (200.0, 200.0)
    assert value_of(scale, Address(FOV), 1) == 0.0


def test_a_canvas_of_another_proportion_scales_by_the_side_that_has_less_room() -> None:
    after = refitted(cut(), 400, 400, Refit.SCALE).document
    assert value_of(after, Address(SCALE, A), 1) == (200.0, 200.0)
    assert value_of(after, Address(GROUND_POSITION), 1) == (0.0, 100.0)


@pytest.mark.parametrize("refit", [Refit.CENTRE, Refit.SCALE])
@pytest.mark.parametrize("fov", [0.0, 35.0, 90.0])
def test_the_eye_goes_along(fov: float, refit: Refit) -> None:
    def eye(of: Document) -> tuple[float, ...]:
        angle = value_of(of, Address(FOV), 1)
        assert isinstance(angle, float)
        return Camera(of.canvas.width_px, of.canvas.height_px, angle).eye

    before = set_constant(cut(), Address(FOV), fov)
    after = refitted(before, 500, 140, refit).document
    x, y, z, w = eye(before)
    factor, left, top = (1.0, 150, 20) if refit is Refit.CENTRE else (1.4, 110, 0)
    assert eye(after) == pytest.approx((x * factor + left * w, y * factor + top * w, z * (factor if w else 1), w))


def test_what_is_kept_aside_follows_too() -> None:
    lines = VanishingLines((((0, 0), (1, 1)), ((2, 2), (3, 3))), (((4, 4), (5, 5)), ((6, 6), (7, 7))))
    lit = set_constant(cut(), Address(LIGHT_POSITION), [1, 2, 3]).tracks
    before = replace(cut(), vanishing=lines, brought_light=BroughtLight(lit, lit))
    after = refitted(before, 400, 200, Refit.SCALE).document
    assert after.vanishing is not None
    assert after.vanishing.all[3] == ((12.0, 12.0), (14.0, 14.0))
    assert after.brought_light is not None
    assert after.brought_light.tracks[LIGHT_POSITION.name].constant == (2.0, 4.0, 6.0)
    assert after.brought_light.before.keys() == lit.keys()


def test_what_would_leave_its_range_is_kept_at_its_end_and_counted() -> None:
    before = set_key(set_key(cut(), Address(SIMPLIFY, A), 1, 300), Address(SIMPLIFY, A), 9, 20)
    after = refitted(before, 400, 200, Refit.SCALE)
    assert after.limited == 1
    assert [key.value for key in after.document.layers[0].tracks[SIMPLIFY.name].keys] == [500.0, 40.0]
    assert refitted(before, 400, 200, Refit.CENTRE).limited == 0


def test_the_picture_behind_stays_on_its_pixels() -> None:
    before = set_background(cut((201, 101)), Path("/bg.png"))
    for size in ((300, 160), (202, 102), (77, 33)):
        after = refitted(before, *size, Refit.STAY).document
        placed = background_at(after, 1)
        assert placed is not None
        left, top = ((size[0] - 201) // 2, (size[1] - 101) // 2)
        x, y, _ = canvas_from_centred(placed.placement) @ (left, top, 1)
        assert (x, y) == (0.0, 0.0)


def test_the_same_size_is_the_same_document() -> None:
    document = cut()
    for refit in Refit:
        assert refitted(document, 200, 100, refit).document is document


@settings(max_examples=40)
@given(documents(), st.integers(1, 16384), st.integers(1, 16384), st.sampled_from(Refit))
def test_any_document_stays_sound(document: Document, width: int, height: int, refit: Refit) -> None:
    check(refitted(document, width, height, refit).document)
