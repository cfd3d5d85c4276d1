"""What is near a place of the graph, and the drags of keys, handles, speeds and the frame around keys."""

import pytest

from kagezou.animation.ease import EASY
from kagezou.animation.track import Interpolation
from kagezou.document.address import Address, track_of
from kagezou.document.ease_edits import set_ease
from kagezou.document.edits import set_canvas, set_key
from kagezou.document.key_edits import KeyRef, Refs
from kagezou.document.model import Canvas, Document
from kagezou.document.properties import GROUND_ROLL
from kagezou.tools.curves.box_drag import DraggedBox, MovedBy, ScaledBy, dragging_box
from kagezou.tools.curves.curve_drag import CurveGrip, DraggedCurves, dragging_curve
from kagezou.tools.curves.curve_list import curves_of
from kagezou.tools.curves.graph_model import GraphModel
from kagezou.tools.curves.graph_pointer import GraphPointer
from kagezou.tools.curves.key_box import BoxGrip
from kagezou.tools.curves.picture import CurvePicture, GraphKind, ShownCurves, pictures_of

ROLL = Address(GROUND_ROLL)
ALL: Refs = frozenset(KeyRef(ROLL, frame) for frame in (10, 20, 30))
PIXELS = (0.1, 0.2)
"""Frames and units a px."""


@pytest.fixture
def document() -> Document:
    """A cut of 48 frames: the roll on 10, 20 and 30, of which it is at 0, 20 and 10, eased."""
    made = set_canvas(Document(Canvas(100, 100)), Canvas(100, 100, length_frames=48))
    for frame, value in ((10, 0.0), (20, 20.0), (30, 10.0)):
        made = set_key(made, ROLL, frame, value)
    return set_ease(made, ALL, (EASY,), (EASY,))


def model(
    document: Document, chosen: Refs = ALL, kind: GraphKind = GraphKind.VALUE, *, is_locked: bool = False
) -> GraphModel:
    shown = ShownCurves(curves_of(document, None), kind)
    return GraphModel(pictures_of(document, shown, chosen), PIXELS, kind, is_locked)


def picture(document: Document, kind: GraphKind = GraphKind.VALUE) -> CurvePicture:
    return model(document, kind=kind).pictures[0]


def keys(document: Document) -> list[tuple[int, float]]:
    return [(key.frame, round(float(str(key.value)), 6)) for key in track_of(document, ROLL).keys]


def at(
    frame: float, ordinate: float, *, one_axis: bool = False, alone: bool = False, about_centre: bool = False
) -> GraphPointer:
    view_px = (frame / PIXELS[0], -ordinate / PIXELS[1])
    return GraphPointer((frame, ordinate), view_px, one_axis=one_axis, alone=alone, about_centre=about_centre)


def pulled(
    document: Document, grip: CurveGrip, start: GraphPointer, end: GraphPointer, kind: GraphKind = GraphKind.VALUE
) -> DraggedCurves:
    drag = dragging_curve(document, grip, kind)
    assert drag.send(start).document is document
    return drag.send(end)


def scaled(document: Document, part: BoxGrip, start: GraphPointer, end: GraphPointer) -> DraggedBox:
    box = model(document).key_box
    assert box is not None
    drag = dragging_box(document, box, part, model(document).pictures)
    assert drag.send(start).document is document
    return drag.send(end)


class TestModel:
    def test_the_nearest_key_within_ten_pixels_is_found(self, document: Document) -> None:
        found = model(document).key_at((20.7, 20.9))
        assert found is not None
        assert found[1].frame == 20
        assert model(document).key_at((21.1, 20.0)) is None

    def test_handles_only_where_something_can_be_changed(self, document: Document) -> None:
        handle = picture(document).handles[0]
        found = model(document).handle_at((handle.frame, handle.ordinate))
        assert found is not None
        assert found[1] == handle
        assert model(document, is_locked=True).handle_at((handle.frame, handle.ordinate)) is None

    def test_a_curve_is_found_along_its_line(self, document: Document) -> None:
        line = picture(document).line
        middle = len(line.frames) // 2
        place = float(line.frames[middle]), float(line.values[middle])
        assert model(document).curve_at((place[0], place[1] + 1.0)) is not None
        assert model(document).curve_at((place[0], place[1] + 9.0)) is None

    def test_a_box_holds_the_keys_on_its_edges_from_whatever_corner(self, document: Document) -> None:
        wanted = frozenset({KeyRef(ROLL, 20), KeyRef(ROLL, 30)})
        assert model(document).keys_between((15.0, 25.0), (30.0, 10.0)) == wanted
        assert model(document).keys_between((30.0, 10.0), (15.0, 25.0)) == wanted

    def test_the_frame_is_around_values_that_can_be_changed(self, document: Document) -> None:
        boxes = [
            model(document).key_box,
            model(document, frozenset({KeyRef(ROLL, 10)})).key_box,
            model(document, kind=GraphKind.SPEED).key_box,
            model(document, is_locked=True).key_box,
        ]
        assert [box is not None for box in boxes] == [True, False, False, False]


class TestKeys:
    def test_they_move_in_time_and_value(self, document: Document) -> None:
        grip = CurveGrip(picture(document), picture(document).keys[1], frozenset({KeyRef(ROLL, 20)}))
        shown = pulled(document, grip, at(20, 20), at(23.2, 25))
        assert keys(shown.document) == [(10, 0), (23, 25), (30, 10)]
        assert shown.refs == frozenset({KeyRef(ROLL, 23)})

    def test_on_one_axis_the_longer_way_in_pixels_counts(self, document: Document) -> None:
        grip = CurveGrip(picture(document), picture(document).keys[1], frozenset({KeyRef(ROLL, 20)}))
        # 30 px across and 25 px up, then 30 px across and 35 px up.
        assert keys(pulled(document, grip, at(20, 20), at(23, 25, one_axis=True)).document)[1] == (23, 20)
        assert keys(pulled(document, grip, at(20, 20), at(23, 27, one_axis=True)).document)[1] == (20, 27)

    def test_every_document_is_made_of_the_first(self, document: Document) -> None:
        grip = CurveGrip(picture(document), picture(document).keys[1], frozenset({KeyRef(ROLL, 20)}))
        drag = dragging_curve(document, grip, GraphKind.VALUE)
        drag.send(at(20, 20))
        drag.send(at(30, 40))
        assert keys(drag.send(at(20, 20)).document) == keys(document)


class TestHandlesAndSpeeds:
    def test_a_handle_is_pulled_joined_or_alone(self, document: Document) -> None:
        handle = next(each for each in picture(document).handles if each.key.frame == 20 and not each.is_before)
        grip = CurveGrip(picture(document), handle, ALL)
        start, end = at(handle.frame, handle.ordinate), (handle.frame, handle.ordinate + 4)
        joined = track_of(pulled(document, grip, start, at(*end)).document, ROLL).keys[1]
        alone = track_of(pulled(document, grip, start, at(*end, alone=True)).document, ROLL).keys[1]
        assert joined.ease_out[0].speed == pytest.approx(alone.ease_out[0].speed) != 0
        assert joined.ease_in[0].speed == pytest.approx(joined.ease_out[0].speed)
        assert alone.ease_in == track_of(document, ROLL).keys[1].ease_in

    def test_selected_keys_stay_as_they_are(self, document: Document) -> None:
        handle = picture(document).handles[0]
        shown = pulled(document, CurveGrip(picture(document), handle, ALL), at(handle.frame, 0), at(handle.frame, 5))
        assert shown.refs is None

    def test_a_key_of_speeds_is_gone_through_at_the_speed_it_is_pulled_to(self, document: Document) -> None:
        seen = picture(document, GraphKind.SPEED)
        shown = pulled(document, CurveGrip(seen, seen.keys[1], ALL), at(20, 0), at(25, 1.5), GraphKind.SPEED)
        key = track_of(shown.document, ROLL).keys[1]
        assert (key.frame, key.interpolation) == (20, Interpolation.BEZIER)
        assert key.ease_out[0].speed == pytest.approx(1.5)


class TestFrame:
    def test_inside_moves(self, document: Document) -> None:
        shown = scaled(document, BoxGrip(0, 0), at(15, 10), at(20, 4))
        assert keys(shown.document) == [(15, -6), (25, 14), (35, 4)]
        assert shown.change == MovedBy(5, -6.0)

    def test_an_edge_stretches_about_the_other_one_or_the_centre(self, document: Document) -> None:
        shown = scaled(document, BoxGrip(1, 0), at(30, 10), at(40, 13))
        assert keys(shown.document) == [(10, 0), (25, 20), (40, 10)]
        assert shown.change == ScaledBy(1.5, None)
        centred = scaled(document, BoxGrip(1, 0), at(30, 10), at(35, 10, about_centre=True))
        assert [frame for frame, _ in keys(centred.document)] == [5, 20, 35]

    def test_a_corner_scales_both_ways_and_alike_on_one_axis(self, document: Document) -> None:
        shown = scaled(document, BoxGrip(1, 1), at(30, 20), at(40, 10))
        assert keys(shown.document) == [(10, 0), (25, 10), (40, 5)]
        assert shown.change == ScaledBy(1.5, 0.5)
        alike = scaled(document, BoxGrip(1, 1), at(30, 20), at(40, 21, one_axis=True))
        assert alike.change == ScaledBy(1.5, 1.5)

    def test_time_is_never_turned_over_but_values_are(self, document: Document) -> None:
        assert scaled(document, BoxGrip(1, 0), at(30, 10), at(-10, 10)).change == ScaledBy(0.0, None)
        turned = scaled(document, BoxGrip(0, 1), at(20, 20), at(20, -20))
        assert turned.change == ScaledBy(None, -1.0)
        assert [value for _, value in keys(turned.document)] == [0, -20, -10]
