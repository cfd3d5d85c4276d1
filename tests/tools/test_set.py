"""In any scene a set piece's handles end under the hand, and lie where the properties put them."""

from math import atan2, degrees, hypot, radians, sin

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from hypothesis.strategies import DrawFn

from kagezou.document import properties as p
from kagezou.document import set_properties as s
from kagezou.document.edits import set_constant
from kagezou.document.model import Document
from kagezou.document.piece_kinds import BUILT_KINDS
from kagezou.document.set_pieces import rename_piece
from kagezou.geometry.ground import place_on
from kagezou.geometry.vectors import Point2, dot
from kagezou.scene.evaluate import camera_at, ground_at
from kagezou.scene.piece_frames import PieceFrame, piece_frame
from kagezou.scene.set_outlines import outlines_of
from kagezou.tools.handle import GuideKind
from kagezou.tools.handles import handles_of, nudge
from kagezou.tools.piece_hits import piece_at
from kagezou.tools.pointer import Modifiers
from kagezou.tools.readout import readout
from kagezou.tools.sight import between
from kagezou.tools.view import CanvasView
from tests.effort import tries
from tests.tools.tool_scenes import FREE, PIECE, Hand, document_with, handle, handles, number, place, with_piece

SIZES = {"piece.width": s.PIECE_WIDTH, "piece.depth": s.PIECE_DEPTH, "piece.height": s.PIECE_HEIGHT}
offsets = st.tuples(st.floats(-300, 300), st.floats(-300, 300)).filter(lambda way: hypot(*way) > 0.01)
views = st.builds(CanvasView, st.floats(0.2, 8.0), offsets)


@st.composite
def sets(draw: DrawFn, *kinds: str, lowest: float = 20.0) -> Document:
    """Return a scene with a piece that is seen before the horizon."""
    document = document_with(
        (p.GROUND_POSITION, draw(st.tuples(st.floats(300, 700), st.floats(700, 950)))),
        (p.GROUND_ROLL, draw(st.floats(-40, 40))),
        (p.GROUND_DECLINATION, draw(st.floats(lowest, 82))),
        (p.FOV, draw(st.one_of(st.just(0.0), st.floats(10, 80)))),
    )
    position = draw(st.tuples(st.floats(200, 800), st.floats(750, 950)))
    assume(place_on(camera_at(document, 1), ground_at(document, 1), position) is not None)
    return with_piece(
        document, draw(st.sampled_from(kinds or BUILT_KINDS)), position=list(position),
        angle=draw(st.floats(-400, 400)), lean=draw(st.floats(-60, 60)), width=draw(st.floats(20, 700)),
        height=draw(st.floats(20, 700)), depth=draw(st.floats(20, 500)),
    )  # fmt: skip


def frame_of(document: Document) -> PieceFrame:
    found = piece_frame(document.piece(PIECE), 1, camera_at(document, 1), ground_at(document, 1))
    assert found is not None
    return found


@given(sets(), offsets)
def test_a_piece_ends_under_the_hand_or_before_the_horizon(document: Document, way: Point2) -> None:
    hand = Hand(document, "piece.position")
    assert hand.handle.canvas_px == pytest.approx(place(document, s.PIECE_POSITION), abs=1e-6)
    wanted = (hand.handle.canvas_px[0] + way[0], hand.handle.canvas_px[1] + way[1])
    after = hand.to(*way)
    frame_of(after)
    if place_on(camera_at(document, 1), ground_at(document, 1), wanted) is None:
        assert place(after, s.PIECE_POSITION) != pytest.approx(wanted, abs=1e-6)
    assume(place(after, s.PIECE_POSITION) == pytest.approx(wanted, abs=1e-9))
    assert handle(after, "piece.position").canvas_px == pytest.approx(wanted, abs=1e-6)


@given(sets(), st.sampled_from(sorted(SIZES)), st.floats(-60, 60).filter(lambda grown: abs(grown) > 0.1))
def test_a_side_ends_under_a_hand_that_goes_along_its_line(document: Document, handle_id: str, grown: float) -> None:
    assume(handles(document, of_piece=True).find(handle_id) is not None)
    hand, line = Hand(document, handle_id), SIZES[handle_id]
    size = number(document, line)
    assume(size + grown > 5)
    aim = handle(set_constant(document, hand.handle.addresses[0], size + grown), handle_id).canvas_px
    way = (aim[0] - hand.handle.canvas_px[0], aim[1] - hand.handle.canvas_px[1])
    assume(hypot(*way) > 0.05 * abs(grown))
    after = hand.to(*way)
    assert number(after, line) == pytest.approx(size + grown, abs=1e-3)
    assert handle(after, handle_id).canvas_px == pytest.approx(aim, abs=1e-3)


@given(sets("wall", "box", "steps", "ramp"), views, offsets)
def test_the_front_looks_at_the_hand(document: Document, view: CanvasView, way: Point2) -> None:
    hand = Hand(document, "piece.turn", view)
    wanted = (hand.handle.canvas_px[0] + way[0], hand.handle.canvas_px[1] + way[1])
    camera, ground = camera_at(document, 1), ground_at(document, 1)
    there = place_on(camera, ground, wanted)
    assume(there is not None)
    assert there is not None
    assume(place_on(camera, ground, hand.handle.canvas_px) is not None)
    assume(max(map(abs, there)) < 1e5)
    after = frame_of(hand.to(*way))
    toward = between(after.stand.origin, there)
    assume(hypot(*toward) > 1)
    turned = degrees(atan2(dot(toward, after.stand.u), dot(toward, after.stand.v)))
    assert abs(turned) < 0.01
    assert abs(after.angle_deg - frame_of(document).angle_deg) <= 180 + 1e-6


@given(sets("wall"), views, st.floats(-75, 75))
def test_a_wall_leans_as_its_side_view_does(document: Document, view: CanvasView, lean: float) -> None:
    leant = set_constant(document, handle(document, "piece.lean").addresses[0], lean)
    hand = Hand(document, "piece.lean", view)
    aim = handle(leant, "piece.lean", view).canvas_px
    way = (aim[0] - hand.handle.canvas_px[0], aim[1] - hand.handle.canvas_px[1])
    assume(hypot(*way) > 0.01)
    after = hand.to(*way)
    assert number(after, s.PIECE_LEAN) == pytest.approx(lean, abs=1e-6)
    assert handle(after, "piece.lean", view).canvas_px == pytest.approx(aim, abs=1e-6)


@settings(max_examples=tries(20, 60))
@given(sets(lowest=1.0), st.floats(-1e7, 1e7), st.floats(-1e7, 1e7))
def test_no_drag_leads_out_of_the_set(document: Document, dx: float, dy: float) -> None:
    for each in handles(document, of_piece=True).handles:
        if each.piece_id is not None:
            for modifiers in (FREE, Modifiers(constrain=True), Modifiers()):
                after = Hand(document, each.id).to(dx, dy, modifiers)
                frame_of(after)
                handles(after, of_piece=True)


def test_which_handles_a_kind_has() -> None:
    flat = {"piece.position", "piece.turn", "piece.width", "piece.height"}
    expected = {
        "wall": flat | {"piece.lean"},
        "box": flat | {"piece.depth"},
        "steps": flat | {"piece.depth"},
        "ramp": flat | {"piece.depth"},
        "cylinder": {"piece.position", "piece.width", "piece.height"},
        "sphere": {"piece.position", "piece.width"},
    }
    for kind, ids in expected.items():
        found = handles(with_piece(document_with(), kind), of_piece=True).handles
        assert {each.id for each in found if each.piece_id == PIECE} == ids, kind
        assert {each.id for each in found} >= {"ground.position", "light.lamp"}


def test_steps_of_turns_and_leans_and_places_that_draw() -> None:
    document = with_piece(document_with(), "wall", position=[500, 860], width=300)
    constrained = Modifiers(constrain=True, snap=False)
    assert number(Hand(document, "piece.turn").to(40, 0, constrained), s.PIECE_ANGLE) % 15 == 0
    assert number(Hand(document, "piece.lean").to(20, 3, constrained), s.PIECE_LEAN) % 15 == 0
    snapping = Modifiers()
    assert number(Hand(document, "piece.lean").to(3, -4, snapping), s.PIECE_LEAN) == 0
    assert number(Hand(document, "piece.turn").to(3, 4, snapping), s.PIECE_ANGLE) == 0
    assert place(Hand(document, "piece.position").to(10, 38, snapping), s.PIECE_POSITION) == (510, 900)
    assert place(Hand(document, "piece.position").to(10, 38), s.PIECE_POSITION) == (510, 898)
    assert place(Hand(document, "piece.position").to(10, 38, constrained), s.PIECE_POSITION) == (500, 898)


def test_on_a_ground_seen_edge_on_a_piece_is_not_there_and_nothing_breaks() -> None:
    document = with_piece(document_with((p.GROUND_DECLINATION, 90.0)), "box")
    found = handles(document, of_piece=True)
    assert not [each for each in found.handles if each.piece_id]
    assert outlines_of(document, 1) == ()


def test_a_side_that_is_seen_end_on_is_drawn_out_by_the_way_down() -> None:
    above = with_piece(document_with((p.GROUND_DECLINATION, 1.0)), "box", height=100)
    assert number(Hand(above, "piece.height").to(0, 30), s.PIECE_HEIGHT) == pytest.approx(130)


def test_a_constrained_side_keeps_the_proportions() -> None:
    document = with_piece(document_with(), "box", position=[300, 860], width=100, height=50, depth=80)
    after = Hand(document, "piece.width").to(25, 0, Modifiers(constrain=True))
    assert [number(after, line) for line in (s.PIECE_WIDTH, s.PIECE_HEIGHT, s.PIECE_DEPTH)] == [150, 75, 120]
    flat = with_piece(document_with(), "wall", position=[300, 860], width=100, height=50, depth=80)
    after = Hand(flat, "piece.width").to(25, 0, Modifiers(constrain=True))
    assert [number(after, line) for line in (s.PIECE_WIDTH, s.PIECE_HEIGHT, s.PIECE_DEPTH)] == [150, 75, 80]


def test_arrows_move_a_piece_and_a_drag_says_its_values() -> None:
    document = with_piece(document_with(), "box", position=[300, 860], width=100)
    moved = nudge(handle(document, "piece.position"), document, 1, 10, 0, CanvasView())
    assert place(moved, s.PIECE_POSITION) == (310, 860)
    wider = Hand(document, "piece.width").to(20, 0)
    assert list(map(str, readout(handle(document, "piece.width"), document, wider, 1))) == ["Width 140 (+40)"]


def test_a_height_is_what_it_looks_like() -> None:
    document = with_piece(document_with(), "cylinder", position=[300, 860], height=200)
    (_, top), (_, foot) = (handle(document, name).canvas_px for name in ("piece.height", "piece.position"))
    assert foot - top == pytest.approx(200 * sin(radians(60)))


class TestOutlines:
    def two(self) -> Document:
        document = with_piece(document_with(), "box", position=[300, 860], width=100, height=100, depth=60, angle=20)
        document = rename_piece(document, PIECE, "Near")
        return with_piece(document, "wall", position=[700, 800], width=300, height=400)

    def test_a_piece_is_found_at_its_edges_and_nowhere_else(self) -> None:
        outlines, view = outlines_of(self.two(), 1), CanvasView(2.0, (10.0, 20.0))
        corner = view.view_from_canvas((550.0, 800.0))
        assert piece_at(outlines, view, (corner[0] - 4, corner[1]), 5.0) == "piece-2"
        assert piece_at(outlines, view, (corner[0] - 6, corner[1]), 5.0) is None
        assert piece_at(outlines, view, view.view_from_canvas((700.0, 700.0)), 5.0) is None
        assert piece_at(outlines, view, view.view_from_canvas((244.0, 820.0)), 5.0) == "piece-1"
        assert piece_at((), view, corner, 5.0) is None

    def test_the_set_is_drawn_always_and_with_what_is_hidden_apart_while_it_is_worked_on(self) -> None:
        document = self.two()
        kinds = [guide.kind for guide in handles_of(document, 1, None, CanvasView(), PIECE).guides]
        assert (kinds.count(GuideKind.PIECE_EDGE), kinds.count(GuideKind.PIECE_HIDDEN)) == (9, 3)
        assert kinds.count(GuideKind.PIECE_OTHER) == 1
        kinds = [guide.kind for guide in handles_of(document, 1, "layer-1", CanvasView()).guides]
        assert GuideKind.PIECE_EDGE not in kinds
        assert (kinds.count(GuideKind.PIECE_OTHER), kinds.count(GuideKind.PIECE_FLOOR)) == (10, 3)

    def test_what_is_switched_off_has_none(self) -> None:
        assert outlines_of(with_piece(document_with(), "box", present=False), 1) == ()
