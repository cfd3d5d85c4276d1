"""In any scene a dragged handle ends under the hand, unless it was stopped, and every document on the way is sound."""

from math import atan2, cos, degrees, hypot, radians, sin

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from hypothesis.strategies import DrawFn

from kagezou.document import properties as p
from kagezou.document.model import Document
from kagezou.document.property import AnyProperty
from kagezou.geometry.camera import project
from kagezou.geometry.ground import Plane, ground_plane
from kagezou.geometry.light import foot_of
from kagezou.geometry.shadow import cast_on
from kagezou.geometry.vectors import Point2, Vector3, height_over
from kagezou.scene.evaluate import camera_at, ground_at, light_at
from kagezou.scene.figure_card import card_at
from kagezou.tools.ground import LEVER_VIEW_PX
from kagezou.tools.handles import handles_of
from kagezou.tools.light import MIN_HEIGHT_PX
from kagezou.tools.pointer import Modifiers
from kagezou.tools.sight import REACH_PX, is_edge_on, moved
from kagezou.tools.sun import DIAL_RADIUS_VIEW_PX
from kagezou.tools.tilt import ARM_VIEW_PX
from kagezou.tools.view import CanvasView
from tests.tools.tool_scenes import FREE, LAYER, Hand, document_with, handle, number, place

# The press itself is left out: there a drag gives back the start, however often the sun went round on the way.
offsets = st.tuples(st.floats(-400, 400), st.floats(-400, 400)).filter(lambda way: hypot(*way) > 0.01)
parts = st.tuples(st.floats(-1, 1), st.floats(-1, 1)).filter(lambda way: hypot(*way) > 0.01)
views = st.builds(CanvasView, st.floats(0.2, 8.0), offsets)
grounding_points = st.tuples(st.floats(380, 620), st.floats(820, 960))


@st.composite
def scenes(draw: DrawFn, kind: str, *, high: bool = False, points: tuple[int, int] = (0, 3)) -> Document:
    """Return a lit scene; ``high`` puts the lamp well over the figure, ``points`` says how many it may stand on."""
    position = draw(st.tuples(st.floats(200, 800), st.floats(700, 1000)))
    roll, declination = draw(st.floats(-60, 60)), draw(st.floats(5, 87))
    ground = ground_plane(position, roll, declination)
    at = ground.point(draw(st.floats(-3000, 3000)), draw(st.floats(-3000, 3000)))
    lamp = moved(at, (draw(st.floats(900 if high else 5, 3000)), ground.normal))
    fov = draw(st.one_of(st.just(0.0), st.floats(5, 100)))
    grounding = draw(st.lists(grounding_points, min_size=points[0], max_size=points[1]))
    settings: list[tuple[AnyProperty, object]] = [
        (p.LIGHT_KIND, kind), (p.GROUND_POSITION, position), (p.GROUND_ROLL, roll), (p.GROUND_DECLINATION, declination),
        (p.LIGHT_POSITION, lamp), (p.FOV, fov), (p.GROUNDING, tuple(grounding)),
        (p.LIGHT_AZIMUTH, draw(st.floats(-720, 720))), (p.LIGHT_ELEVATION, draw(st.floats(3, 90))),
        (p.TILT, draw(st.floats(-75, 75))),
    ]  # fmt: skip
    return document_with(*settings)


def lamp_of(document: Document) -> Vector3:
    x, y, z = place(document)
    return (x, y, z)


def ground_of(document: Document) -> Plane:
    return ground_at(document, 1)


def wanted(hand: Hand, offset: Point2) -> Point2:
    return (hand.handle.canvas_px[0] + offset[0], hand.handle.canvas_px[1] + offset[1])


def is_stopped(document: Document) -> bool:
    """Whether a lamp lies at the ground or at the end of a drag's reach."""
    lamp = lamp_of(document)
    return height_over(ground_of(document).equation, (*lamp, 1.0)) < MIN_HEIGHT_PX + 1e-6 or (
        max(map(abs, lamp)) > REACH_PX - 1e-3
    )


def miss(document: Document, hand: Hand, offset: Point2) -> float:
    found = handle(document, hand.handle_id, hand.view).canvas_px
    x, y = wanted(hand, offset)
    return hypot(found[0] - x, found[1] - y)


@given(scenes("point"), st.lists(offsets, min_size=1, max_size=3))
def test_the_lamp_ends_under_the_hand(document: Document, way: list[Point2]) -> None:
    assume(not is_edge_on(camera_at(document, 1), lamp_of(document), ground_of(document).v))
    hand = Hand(document, "light.lamp")
    after = hand.through(way)
    assume(not is_stopped(after))
    assert miss(after, hand, way[-1]) < 0.01


@given(scenes("point"), st.lists(offsets, min_size=1, max_size=3))
def test_the_foot_ends_under_the_hand_and_the_lamp_keeps_its_height(document: Document, way: list[Point2]) -> None:
    ground = ground_of(document)
    foot = foot_of(ground, lamp_of(document))
    assume(not is_edge_on(camera_at(document, 1), foot, ground.normal))
    hand = Hand(document, "light.foot")
    after = hand.through(way)
    heights = [height_over(ground.equation, (*lamp_of(each), 1.0)) for each in (document, after)]
    assert heights[1] == pytest.approx(heights[0], abs=1e-4)
    assume(not is_stopped(after))
    assert miss(after, hand, way[-1]) < 0.01


@given(scenes("point"), st.sampled_from(["light.lamp", "light.foot"]), st.floats(-1e7, 1e7), st.floats(-1e7, 1e7))
def test_no_drag_explodes_or_buries_the_lamp(document: Document, handle_id: str, dx: float, dy: float) -> None:
    for modifiers in (FREE, Modifiers(constrain=True), Modifiers(fine=True)):
        after = Hand(document, handle_id).to(dx, dy, modifiers)
        lamp = lamp_of(after)
        assert max(map(abs, lamp)) <= REACH_PX + 1e-3
        assert height_over(ground_of(after).equation, (*lamp, 1.0)) > 0
        handles_of(after, 1, LAYER, CanvasView())


def on_arm(view: CanvasView, part: Point2, length_view_px: float) -> Point2:
    return (part[0] * length_view_px / view.zoom, part[1] * length_view_px / view.zoom)


@given(scenes("sun"), views, parts)
def test_the_sun_ends_under_the_hand(document: Document, view: CanvasView, part: Point2) -> None:
    hand = Hand(document, "light.sun", view)
    way = on_arm(view, part, DIAL_RADIUS_VIEW_PX / 2)
    after = hand.to(*way)
    assume(number(after, p.LIGHT_ELEVATION) > 0)
    assert miss(after, hand, way) < 0.01


@given(scenes("sun"), views, st.lists(offsets, min_size=1, max_size=5))
def test_the_sun_never_turns_by_more_than_half_a_turn_at_once(
    document: Document, view: CanvasView, way: list[Point2]
) -> None:
    hand = Hand(document, "light.sun", view)
    before = number(document, p.LIGHT_AZIMUTH)
    for offset in way:
        after = number(hand.to(*offset), p.LIGHT_AZIMUTH)
        assert abs(after - before) <= 180 + 1e-9
        before = after


@given(scenes("point"), offsets)
def test_the_ground_s_position_ends_under_the_hand(document: Document, way: Point2) -> None:
    hand = Hand(document, "ground.position")
    assert miss(hand.to(*way), hand, way) < 1e-9


@given(scenes("point"), views, offsets)
def test_the_ground_line_ends_under_the_hand(document: Document, view: CanvasView, way: Point2) -> None:
    hand = Hand(document, "ground.end", view)
    after = hand.to(*way)
    assume(abs(number(after, p.GROUND_ROLL)) < 90)
    gx, gy = place(document, p.GROUND_POSITION)
    (x, y), (ex, ey) = wanted(hand, way), handle(after, "ground.end", view).canvas_px
    assume(hypot(x - gx, y - gy) > 1)
    turned = degrees(atan2(y - gy, x - gx) - atan2(ey - gy, ex - gx))
    assert abs((turned + 180) % 360 - 180) < 1e-6


@given(scenes("point"), views, parts)
def test_the_declination_lever_ends_as_far_down_as_the_hand(document: Document, view: CanvasView, part: Point2) -> None:
    hand = Hand(document, "ground.declination", view)
    way = on_arm(view, part, LEVER_VIEW_PX)
    after = hand.to(*way)
    assume(1 < number(after, p.GROUND_DECLINATION) < 90)
    roll = radians(number(document, p.GROUND_ROLL))
    (x, y), (hx, hy) = wanted(hand, way), handle(after, "ground.declination", view).canvas_px
    assert abs(-sin(roll) * (x - hx) + cos(roll) * (y - hy)) < 0.01


@given(scenes("point", points=(3, 3)), offsets, st.integers(0, 2))
def test_a_grounding_point_ends_under_the_hand(document: Document, way: Point2, index: int) -> None:
    hand = Hand(document, f"grounding.{index}")
    assert miss(hand.to(*way), hand, way) < 1e-9


@given(scenes("point", points=(0, 1)), views, parts)
def test_the_tilt_lever_ends_over_the_hand(document: Document, view: CanvasView, part: Point2) -> None:
    hand = Hand(document, "tilt.lever", view)
    way = on_arm(view, part, ARM_VIEW_PX)
    after = hand.to(*way)
    assume(abs(number(after, p.TILT)) < 75)
    assert abs(handle(after, "tilt.lever", view).canvas_px[0] - wanted(hand, way)[0]) < 0.01


@given(st.sampled_from(["point", "sun"]).flatmap(lambda kind: scenes(kind, high=True)), offsets)
def test_the_tip_of_the_shadow_ends_under_the_hand(document: Document, way: Point2) -> None:
    assume(handles_of(document, 1, LAYER, CanvasView()).find("shadow.tip"))
    hand = Hand(document, "shadow.tip")
    after = hand.to(*way)
    assume(not is_stopped(after))
    assume(handles_of(after, 1, LAYER, CanvasView()).find("shadow.tip"))
    assert miss(after, hand, way) < 0.05


@given(st.sampled_from(["point", "sun"]).flatmap(lambda kind: scenes(kind, high=True)))
def test_the_tip_lies_where_the_head_s_shadow_is_drawn(document: Document) -> None:
    tip = handles_of(document, 1, LAYER, CanvasView()).find("shadow.tip")
    assume(tip)
    assert tip is not None
    camera, ground = camera_at(document, 1), ground_of(document)
    card = card_at(document, document.layer(LAYER), 1, camera, ground)
    piece = next(piece for piece in card.pieces if piece.holds((500.0, 500.0)))
    cast = cast_on(camera, ground, piece, light_at(document, 1, ground))
    assume(cast)  # a light within the card's own plane casts a line
    assert cast is not None
    canvas_from_art = np.asarray(np.linalg.inv(cast.art_from_canvas), dtype=np.float64)
    assert project(canvas_from_art, (500.0, 200.0)) == pytest.approx(tip.canvas_px, abs=0.05)


@given(st.floats(100, 900), st.floats(100, 900), st.floats(50, 100), st.floats(-2000, 4000), st.floats(-2000, 2000))
def test_beside_and_behind_the_eye_lamp_and_foot_still_follow(
    x: float, y: float, fov: float, z: float, dy: float
) -> None:
    document = document_with((p.FOV, fov), (p.LIGHT_POSITION, (x, y - 2000, z)))
    for handle_id in ("light.lamp", "light.foot"):
        hand = Hand(document, handle_id)
        after = hand.to(40, dy)
        if not is_stopped(after):
            assert miss(after, hand, (40, dy)) < 0.01
