"""What every drag does, whatever it drags."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.animation.track import Interpolation
from kagezou.document import properties
from kagezou.document.address import track_of
from kagezou.document.edits import set_key
from kagezou.document.model import Document
from kagezou.tools.pointer import Modifiers
from kagezou.tools.view import CanvasView
from tests.tools.tool_scenes import FREE, Hand, address, document_with, handles, place, value, with_piece

LAMP = document_with((properties.GROUNDING, ((450.0, 900.0), (550.0, 890.0))), (properties.LIGHT_POSITION, (0, 0, 500)))
TILTABLE = document_with((properties.LIGHT_KIND, "sun"), (properties.LIGHT_AZIMUTH, 170.0))
FILTERED = document_with(
    (properties.LIGHT_POSITION, (0, 0, 500)), (properties.SIMPLIFY, 40.0), (properties.DISTANCE, 150.0),
    (properties.WAVE1.amplitude, 5.0), (properties.WAVE2.amplitude, 5.0),
)  # fmt: skip
WALL = with_piece(document_with(), "wall", position=[500, 860], width=500, angle=10)
STEPS = with_piece(document_with((properties.FOV, 40.0)), "steps", position=[600, 850], angle=-30)
EVERY_HANDLE = [
    (document, handle.id)
    for document, of_piece in ((LAMP, False), (TILTABLE, False), (FILTERED, False), (WALL, True), (STEPS, True))
    for handle in handles(document, of_piece=of_piece).handles
    if handle.id.startswith("piece.") == of_piece
]


def test_every_handle_there_is_takes_part() -> None:
    assert {handle_id for _, handle_id in EVERY_HANDLE} == {
        "ground.position", "ground.end", "ground.declination", "grounding.0", "grounding.1", "tilt.lever",
        "light.lamp", "light.foot", "light.sun", "shadow.tip", "filter.distance", "filter.wave1", "filter.wave2",
        "piece.position", "piece.turn", "piece.width", "piece.depth", "piece.height", "piece.lean",
    }  # fmt: skip


@pytest.mark.parametrize(("document", "handle_id"), EVERY_HANDLE)
def test_a_drag_there_and_back_gives_the_very_document_it_began_with(document: Document, handle_id: str) -> None:
    hand = Hand(document, handle_id)
    changed = hand.to(13, -9)
    assert changed is not document
    assert changed != document
    assert hand.to(0, 0) is document
    assert hand.to(13, -9) == changed


@pytest.mark.parametrize(("document", "handle_id"), EVERY_HANDLE)
def test_a_drag_depends_only_on_where_the_hand_is(document: Document, handle_id: str) -> None:
    straight = Hand(document, handle_id).to(13, -9)
    assert Hand(document, handle_id).through([(5, 5), (-20, 8), (40, -3), (13, -9)]) == straight


@pytest.mark.parametrize(("document", "handle_id"), EVERY_HANDLE)
def test_a_handle_keeps_the_offset_it_was_taken_hold_of_with(document: Document, handle_id: str) -> None:
    middle = Hand(document, handle_id).to(13, -9)
    rim = Hand(document, handle_id, grab_offset=(6.0, -4.0)).to(13, -9)
    far = Hand(document, handle_id, grab_offset=(512.0, 2048.0)).to(13, -9)
    assert place(rim) == pytest.approx(place(middle), abs=1e-9)
    assert place(far) == pytest.approx(place(middle), abs=1e-9)


@pytest.mark.parametrize(("document", "handle_id"), EVERY_HANDLE)
def test_escape_closes_the_drag_and_leaves_the_start_document_alone(document: Document, handle_id: str) -> None:
    before = repr(document)
    hand = Hand(document, handle_id)
    hand.to(30, 30)
    hand.drag.close()
    assert repr(document) == before
    with pytest.raises(StopIteration):
        hand.to(1, 1)


@pytest.mark.parametrize(("document", "handle_id"), EVERY_HANDLE)
def test_a_keyed_property_gets_a_key_at_the_frame(document: Document, handle_id: str) -> None:
    lines = [each.property for each in Hand(document, handle_id).handle.addresses]
    for line in lines:
        document = set_key(document, address(line), 1, value(document, line), Interpolation.LINEAR)
    changed = Hand(document, handle_id, frame=7).to(13, -9)
    for line in lines:
        track = track_of(changed, address(line))
        assert [key.frame for key in track.keys] == [1, 7]
        assert value(changed, line, 1) == value(document, line, 1)
        assert value(changed, line, 7) != value(document, line, 7)


@given(st.floats(-300, 300), st.floats(-300, 300))
def test_the_fine_gear_goes_a_tenth_of_the_way(dx: float, dy: float) -> None:
    fine = Hand(LAMP, "ground.position").to(dx, dy, Modifiers(fine=True, snap=False))
    assert place(fine, properties.GROUND_POSITION) == pytest.approx((500 + dx / 10, 900 + dy / 10))


def test_changing_the_gear_never_jumps() -> None:
    fine = Modifiers(fine=True, snap=False)
    hand = Hand(LAMP, "ground.position")
    where = [
        place(document, properties.GROUND_POSITION)[0]
        for document in (
            hand.to(100, 0), hand.to(100, 0, fine), hand.to(200, 0, fine), hand.to(200, 0), hand.to(150, 0),
        )
    ]  # fmt: skip
    assert where == pytest.approx([600, 600, 610, 610, 560])


def test_the_zoom_changes_nothing_for_what_lies_on_the_canvas() -> None:
    near = Hand(LAMP, "light.lamp", CanvasView(4.0, (-300.0, 20.0))).to(10, 20)
    assert near == Hand(LAMP, "light.lamp").to(10, 20, FREE)
