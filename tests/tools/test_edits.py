"""What each handle does to the document, in numbers that can be checked by hand."""

import pytest

from kagezou.document import properties as p
from kagezou.document.edits import remove_layer
from kagezou.document.invariants import check
from kagezou.document.model import Document
from kagezou.document.property import AnyProperty
from kagezou.errors import UsageProblem
from kagezou.tools.grounding import add_grounding, remove_grounding
from kagezou.tools.handle import GuideKind, hit
from kagezou.tools.handles import drag_of, handles_of, nudge
from kagezou.tools.pointer import Modifiers, Pointer
from kagezou.tools.view import CanvasView
from tests.tools.tool_scenes import FREE, LAYER, Hand, document_with, handle, number, place, value

CONSTRAINED = Modifiers(constrain=True)
HALF = 0.5  # cos 60°, the default declination
ROOT = 3**0.5 / 2  # sin 60°


def lamp_at(*position: float) -> tuple[AnyProperty, object]:
    return (p.LIGHT_POSITION, position)


def ids(document: Document) -> set[str]:
    return {each.id for each in handles_of(document, 1, LAYER, CanvasView()).handles}


def test_the_lamp_goes_sideways_with_its_foot_and_up_over_it() -> None:
    document = document_with(lamp_at(200.0, 100.0, 600.0))
    after = Hand(document, "light.lamp").to(30, -10 * ROOT)
    assert place(after) == pytest.approx((230, 100 - 10 * ROOT, 600 + 10 * HALF))
    foot, moved_foot = handle(document, "light.foot"), handle(after, "light.foot")
    assert moved_foot.canvas_px == pytest.approx((foot.canvas_px[0] + 30, foot.canvas_px[1]))


def test_the_foot_takes_the_lamp_along_at_its_height() -> None:
    document = document_with(lamp_at(200.0, 100.0, 600.0))
    after = Hand(document, "light.foot").to(30, 10 * HALF)
    assert place(after) == pytest.approx((230, 100 + 10 * HALF, 600 + 10 * ROOT))
    lamp, moved_lamp = handle(document, "light.lamp"), handle(after, "light.lamp")
    assert moved_lamp.canvas_px == pytest.approx((lamp.canvas_px[0] + 30, lamp.canvas_px[1] + 10 * HALF))


@pytest.mark.parametrize("handle_id", ["light.lamp", "light.foot"])
def test_constrained_a_light_keeps_to_the_ground_line_or_across_it(handle_id: str) -> None:
    document = document_with(lamp_at(200.0, 100.0, 600.0), (p.GROUND_ROLL, 30.0))
    start = place(document)
    along = place(Hand(document, handle_id).to(40, 20, CONSTRAINED))
    assert along[2] == pytest.approx(start[2])
    assert (along[1] - start[1]) / (along[0] - start[0]) == pytest.approx(3**-0.5)
    across = place(Hand(document, handle_id).to(-4, 30, CONSTRAINED))
    assert (across[0] - start[0]) / (across[1] - start[1]) == pytest.approx(-(3**-0.5))


def test_the_lamp_stops_over_the_ground() -> None:
    document = document_with(lamp_at(200.0, 100.0, 600.0))
    hand = Hand(document, "light.lamp")
    after = hand.to(0, 5000)
    assert handle(after, "light.lamp").canvas_px[1] == pytest.approx(handle(after, "light.foot").canvas_px[1] - ROOT)
    assert place(hand.to(0, 9000)) == pytest.approx(place(after))


@pytest.mark.parametrize("handle_id", ["light.lamp", "light.foot"])
def test_a_lamp_under_the_ground_is_brought_over_it_once_moved(handle_id: str) -> None:
    document = document_with(lamp_at(200.0, 2000.0, 0.0))
    after = Hand(document, handle_id).to(5, 0)
    x, y, z = place(after)
    assert ROOT * (900 - y) + HALF * z == pytest.approx(1.0)
    assert x == pytest.approx(205)


def test_ground_seen_edge_on_moves_the_lamp_by_the_hand_s_px() -> None:
    document = document_with(lamp_at(200.0, 100.0, 600.0), (p.GROUND_DECLINATION, 90.0))
    assert place(Hand(document, "light.foot").to(30, 20)) == pytest.approx((230, 100, 620))
    assert place(Hand(document, "light.lamp").to(30, 20)) == pytest.approx((230, 120, 600))
    assert "shadow.tip" not in ids(document)


def test_ground_seen_from_straight_above_raises_the_lamp_by_the_hand_s_px() -> None:
    document = document_with(lamp_at(200.0, 100.0, 600.0), (p.GROUND_DECLINATION, 1.0))
    after = place(Hand(document, "light.lamp").to(30, -20))
    assert after == pytest.approx((230, 100, 620), abs=0.5)


def test_beyond_the_horizon_the_foot_ends_within_reach() -> None:
    document = document_with(lamp_at(200.0, 100.0, 600.0), (p.FOV, 50.0))
    hand = Hand(document, "light.foot")
    for dy in (-400.0, -700.0, -900.0, -5000.0, -1e6):
        assert max(map(abs, place(hand.to(3, dy)))) <= 1e5 + 1e-6
    assert max(map(abs, place(hand.to(3, -5000)))) == pytest.approx(1e5)


def test_a_handle_taken_at_the_view_s_edge_moves_by_the_hand_s_way_only() -> None:
    document = document_with(lamp_at(500.0, -2000.0, 600.0))
    view, size = CanvasView(0.5, (50.0, 20.0)), (600, 500)
    found = hit(handles_of(document, 1, LAYER, view).handles, view, (300, 18), view_size=size)
    assert found is not None
    assert found.id == "light.lamp"
    drag = drag_of(found, document, 1, view)
    assert drag.send(Pointer.seen_at(view, (300, 18), FREE)) is document
    after = drag.send(Pointer.seen_at(view, (310, 18), FREE))
    assert place(after) == pytest.approx((520, -2000, 600))


def test_the_sun_s_dial_reads_azimuth_round_and_elevation_inward() -> None:
    document = document_with((p.LIGHT_KIND, "sun"), (p.LIGHT_AZIMUTH, 90.0), (p.LIGHT_ELEVATION, 0.0))
    assert handle(document, "light.sun").canvas_px == pytest.approx((590, 900))
    after = Hand(document, "light.sun").to(-45, 0)
    assert number(after, p.LIGHT_ELEVATION) == pytest.approx(45)
    assert number(after, p.LIGHT_AZIMUTH) == pytest.approx(90)
    nearer = Hand(document, "light.sun").to(-90, 90 * HALF * 2 / 3)
    assert number(nearer, p.LIGHT_AZIMUTH) == pytest.approx(0, abs=1e-9)
    assert number(nearer, p.LIGHT_ELEVATION) == pytest.approx(30)
    outside = Hand(document, "light.sun").to(500, 0)
    assert number(outside, p.LIGHT_ELEVATION) == 0
    overhead = Hand(document, "light.sun").to(-90, 0)
    assert (number(overhead, p.LIGHT_ELEVATION), number(overhead, p.LIGHT_AZIMUTH)) == pytest.approx((90, 90))


def test_the_dial_has_one_size_on_screen() -> None:
    document = document_with((p.LIGHT_KIND, "sun"), (p.LIGHT_AZIMUTH, 90.0), (p.LIGHT_ELEVATION, 0.0))
    assert handle(document, "light.sun", CanvasView(4.0)).canvas_px == pytest.approx((500 + 90 / 4, 900))


def test_the_sun_counts_whole_turns() -> None:
    document = document_with((p.LIGHT_KIND, "sun"), (p.LIGHT_AZIMUTH, 90.0), (p.LIGHT_ELEVATION, 45.0))
    right = handle(document, "light.sun").canvas_px[0] - 500
    deep = right * HALF
    once_round = [(-right, -deep), (-2 * right, 0), (-right, deep), (0.001, 0)]
    hand = Hand(document, "light.sun")
    angles = [number(hand.to(dx, dy), p.LIGHT_AZIMUTH) for dx, dy in once_round]
    assert angles == pytest.approx([180, 270, 360, 450])
    back = [number(hand.to(dx, dy), p.LIGHT_AZIMUTH) for dx, dy in reversed(once_round[:-1])]
    assert back == pytest.approx([360, 270, 180])


def test_at_the_end_of_its_range_the_azimuth_unwinds() -> None:
    document = document_with((p.LIGHT_KIND, "sun"), (p.LIGHT_AZIMUTH, 36000.0), (p.LIGHT_ELEVATION, 45.0))
    assert 0 < number(Hand(document, "light.sun").to(5, 0), p.LIGHT_AZIMUTH) < 20


def test_constrained_the_sun_goes_by_fifteen_degrees() -> None:
    document = document_with((p.LIGHT_KIND, "sun"), (p.LIGHT_AZIMUTH, 90.0), (p.LIGHT_ELEVATION, 0.0))
    after = Hand(document, "light.sun").to(-40, 12, CONSTRAINED)
    assert (number(after, p.LIGHT_AZIMUTH), number(after, p.LIGHT_ELEVATION)) == (60, 30)


def test_the_ground_s_position_is_moved() -> None:
    after = Hand(document_with(), "ground.position").to(-20, 33)
    assert place(after, p.GROUND_POSITION) == (480, 933)


@pytest.mark.parametrize(("offset", "expected"), [((50, 9), (550, 900)), ((-3, 40), (500, 940))])
def test_constrained_the_ground_moves_level_or_upright(
    offset: tuple[float, float], expected: tuple[float, float]
) -> None:
    assert place(Hand(document_with(), "ground.position").to(*offset, CONSTRAINED), p.GROUND_POSITION) == expected


def test_the_ground_is_drawn_to_the_figure_s_lowest_pixel() -> None:
    document = document_with((p.GROUND_POSITION, (500.0, 880.0)))
    assert place(Hand(document, "ground.position").to(7, 16, Modifiers()), p.GROUND_POSITION) == (507, 900)
    assert place(Hand(document, "ground.position").to(7, 16), p.GROUND_POSITION) == (507, 896)
    assert place(Hand(document, "ground.position").to(7, 14, Modifiers()), p.GROUND_POSITION) == (507, 894)
    near = Hand(document, "ground.position", CanvasView(4.0)).to(7, 18, Modifiers())
    assert place(near, p.GROUND_POSITION) == (507, 898)


@pytest.mark.parametrize(("x", "side"), [(300.0, 1), (700.0, -1)])
def test_the_end_of_the_line_rolls_the_ground(x: float, side: int) -> None:
    document = document_with((p.GROUND_POSITION, (x, 600.0)))
    end = handle(document, "ground.end")
    assert end.canvas_px == pytest.approx((1000 - 28 if side > 0 else 28, 600))
    arm = abs(end.canvas_px[0] - x)
    after = Hand(document, "ground.end").to(0, -side * arm)
    assert number(after, p.GROUND_ROLL) == pytest.approx(-45)
    assert number(Hand(document, "ground.end").to(0, side * arm * 0.3, CONSTRAINED), p.GROUND_ROLL) == 15


def test_the_roll_stops_at_upright_and_is_drawn_to_level() -> None:
    document = document_with((p.GROUND_POSITION, (300.0, 600.0)), (p.GROUND_ROLL, 3.0))
    x, y = (300 - handle(document, "ground.end").canvas_px[0], 600 - handle(document, "ground.end").canvas_px[1])
    hand = Hand(document, "ground.end")
    assert number(hand.to(x - 50, y + 40), p.GROUND_ROLL) == 90
    assert number(hand.to(x - 50, y - 40), p.GROUND_ROLL) == -90
    assert number(hand.to(0, y - 4, Modifiers()), p.GROUND_ROLL) == 0
    assert number(hand.to(0, y - 4), p.GROUND_ROLL) < 0
    assert hand.to(x, y) is document


def test_the_end_of_the_line_is_in_reach_wherever_the_ground_is() -> None:
    for position in ((500.0, -4000.0), (990.0, 900.0), (-3000.0, 500.0)):
        document = document_with((p.GROUND_POSITION, position), (p.GROUND_ROLL, 90.0))
        x, y = handle(document, "ground.end").canvas_px
        assert abs(x - position[0]) + abs(y - position[1]) >= 80


def test_the_lever_sets_the_declination() -> None:
    document = document_with()
    assert handle(document, "ground.declination").canvas_px == pytest.approx((500, 970))
    hand = Hand(document, "ground.declination")
    assert number(hand.to(99, 140 * (ROOT - HALF)), p.GROUND_DECLINATION) == pytest.approx(30)
    assert number(hand.to(0, -70), p.GROUND_DECLINATION) == pytest.approx(90)
    assert number(hand.to(0, -400), p.GROUND_DECLINATION) == pytest.approx(90)
    assert number(hand.to(0, 400), p.GROUND_DECLINATION) == 1
    assert number(hand.to(0, 25, CONSTRAINED), p.GROUND_DECLINATION) == 45


TWO_POINTS = document_with((p.GROUNDING, ((450.0, 900.0), (550.0, 880.0))))


def test_a_grounding_point_is_moved() -> None:
    assert value(Hand(TWO_POINTS, "grounding.1").to(5, 7), p.GROUNDING) == ((450, 900), (555, 887))


def test_a_grounding_point_keeps_its_place_in_the_list_when_it_passes_another() -> None:
    after = Hand(TWO_POINTS, "grounding.0").to(200, 0)
    assert value(after, p.GROUNDING) == ((650, 900), (550, 880))
    assert handle(after, "grounding.0").canvas_px == (650, 900)


def test_constrained_a_grounding_point_keeps_its_row() -> None:
    assert value(Hand(TWO_POINTS, "grounding.1").to(5, 70, CONSTRAINED), p.GROUNDING) == ((450, 900), (555, 880))


def test_symmetric_the_other_of_two_points_goes_against() -> None:
    symmetric = Modifiers(symmetric=True, snap=False)
    assert value(Hand(TWO_POINTS, "grounding.1").to(5, 7, symmetric), p.GROUNDING) == ((445, 893), (555, 887))


def test_a_grounding_point_is_drawn_to_the_others_rows_and_the_ground_line() -> None:
    document = document_with((p.GROUNDING, ((450.0, 860.0), (550.0, 880.0))))
    hand = Hand(document, "grounding.1")
    assert value(hand.to(5, -17, Modifiers()), p.GROUNDING) == ((450, 860), (555, 860))
    assert value(hand.to(5, 17, Modifiers()), p.GROUNDING) == ((450, 860), (555, 900))
    assert value(hand.to(5, 8, Modifiers()), p.GROUNDING) == ((450, 860), (555, 888))


def test_grounding_points_are_added_and_removed() -> None:
    document = add_grounding(document_with(), LAYER, 1, (470, 899))
    document = add_grounding(document, LAYER, 1, (530, 890))
    check(document)
    assert value(document, p.GROUNDING) == ((470, 899), (530, 890))
    assert value(remove_grounding(document, LAYER, 1, 0), p.GROUNDING) == ((530, 890),)
    assert remove_grounding(document, LAYER, 1, 2) is document
    assert remove_grounding(document, LAYER, 1, -1) is document


def test_there_is_an_end_to_grounding_points() -> None:
    document = document_with((p.GROUNDING, tuple((float(x), 900.0) for x in range(64))))
    with pytest.raises(UsageProblem, match="at most 64 points"):
        add_grounding(document, LAYER, 1, (470, 899))


def test_a_drag_of_a_point_that_is_not_there_changes_nothing() -> None:
    gone = handle(TWO_POINTS, "grounding.1")
    assert nudge(gone, document_with(), 1, 5, 5, CanvasView()) == document_with()


def test_the_tilt_lever_points_where_the_figure_faces() -> None:
    document = document_with((p.GROUNDING, ((450.0, 900.0),)))
    assert handle(document, "tilt.lever").canvas_px == pytest.approx((450, 200 - 44 + 0.35 * 70))
    hand = Hand(document, "tilt.lever")
    assert number(hand.to(35, 99), p.TILT) == pytest.approx(-30)
    assert number(hand.to(-35, 0), p.TILT) == pytest.approx(30)
    assert number(hand.to(500, 0), p.TILT) == -75
    assert number(hand.to(33, 0, CONSTRAINED), p.TILT) == -30
    assert number(hand.to(3, 0, Modifiers()), p.TILT) == 0


def test_a_measured_tilt_is_shown_and_not_set() -> None:
    assert "tilt.lever" not in ids(TWO_POINTS)
    kinds = {guide.kind for guide in handles_of(TWO_POINTS, 1, LAYER, CanvasView()).guides}
    assert {GuideKind.TILT_ARC, GuideKind.TILT_ARM, GuideKind.CARD_FOOT} <= kinds
    folded = document_with((p.GROUNDING, ((420.0, 900.0), (500.0, 880.0), (590.0, 890.0))))
    assert GuideKind.TILT_ARM not in {guide.kind for guide in handles_of(folded, 1, LAYER, CanvasView()).guides}


def test_dragging_the_shadow_keeps_the_lamp_s_height() -> None:
    document = document_with(lamp_at(300.0, -600.0, 700.0))
    after = Hand(document, "shadow.tip").to(-60, 25)
    heights = [ROOT * (900 - y) + HALF * z for _, y, z in (place(document), place(after))]
    assert heights[1] == pytest.approx(heights[0])


def test_the_tip_right_under_the_head_puts_the_sun_straight_above() -> None:
    document = document_with((p.LIGHT_KIND, "sun"))
    x, y = handle(document, "shadow.tip").canvas_px
    after = Hand(document, "shadow.tip").to(500 - x, 900 - 700 * HALF * HALF - y)
    assert number(after, p.LIGHT_ELEVATION) == pytest.approx(90)


def test_a_drag_of_a_tip_that_is_gone_changes_nothing() -> None:
    tip = handle(document_with(), "shadow.tip")
    hidden = document_with((p.VISIBLE, False))
    assert nudge(tip, hidden, 1, 5, 5, CanvasView()) is hidden


@pytest.mark.parametrize(
    "settings",
    [
        (lamp_at(300.0, 500.0, 0.0),),  # lower than the head: the shadow has no tip
        (lamp_at(300.0, 2000.0, 0.0),),  # under the ground
        ((p.LIGHT_KIND, "sun"), (p.LIGHT_ELEVATION, -20.0)),
        ((p.LIGHT_KIND, "sun"), (p.LIGHT_ELEVATION, 0.4)),
        ((p.GROUND_POSITION, (500.0, 250.0)),),  # the head hardly over the ground
        ((p.VISIBLE, False),),
    ],
)
def test_there_is_no_handle_where_there_is_no_tip(settings: tuple[tuple[AnyProperty, object], ...]) -> None:
    document = document_with(*settings)
    assert "shadow.tip" not in ids(document)
    assert GuideKind.SHADOW_RAY not in {guide.kind for guide in handles_of(document, 1, LAYER, CanvasView()).guides}


def test_without_a_layer_there_are_light_and_ground() -> None:
    document = remove_layer(document_with(), LAYER)
    for kind, lights in (("point", {"light.foot", "light.lamp"}), ("sun", {"light.sun"})):
        lit = document_with((p.LIGHT_KIND, kind))
        found = handles_of(lit, 1, None, CanvasView())
        ground = {"ground.position", "ground.end", "ground.declination"}
        assert {each.id for each in found.handles} == ground | lights
        for each in found.handles:
            check(nudge(each, lit, 1, 3, 2, CanvasView()))
    assert handles_of(document, 1, None, CanvasView()).find("grounding.0") is None


def test_an_arrow_key_moves_by_px_and_is_not_held_by_a_snap() -> None:
    document = document_with()
    after = nudge(handle(document, "ground.position"), document, 1, 0, 1, CanvasView())
    assert place(after, p.GROUND_POSITION) == (500, 901)
