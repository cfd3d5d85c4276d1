"""Feet taken hold of on the picture: what is said about the drawing that is shown."""

from dataclasses import replace

import pytest

from kagezou.document.address import resolve
from kagezou.document.edits import set_constant, set_drawings
from kagezou.document.feet_edits import pin_of
from kagezou.document.model import Document
from kagezou.geometry.vectors import Point2
from kagezou.scene.stances import stances_of
from kagezou.standing.foot import Foot, Verdict
from kagezou.tools.feet import carries, judged, kept_in_place, shown_foot, unpinned, with_foot_at
from kagezou.tools.handle import GuideKind, Handle, HandleShape
from kagezou.tools.handles import drag_of, handles_of
from kagezou.tools.pointer import Modifiers, Pointer
from kagezou.tools.view import CanvasView
from tests.tools.tool_scenes import LAYER, document_with

VIEW = CanvasView()


@pytest.fixture
def document() -> Document:
    """A figure on a planted foot, the other one 60 px higher."""
    return with_feet(document_with(), Foot(0, (450.0, 900.0)), Foot(1, (560.0, 840.0)))


def with_feet(document: Document, *feet: Foot) -> Document:
    (drawing,) = document.layer(LAYER).cels.drawings
    return set_drawings(document, LAYER, (replace(drawing, feet=feet),))


def found(document: Document, handle_id: str) -> Handle:
    handle = handles_of(document, 1, LAYER, VIEW).find(handle_id)
    assert handle is not None
    return handle


def dragged(document: Document, handle: Handle, to: Point2) -> Document:
    drag = drag_of(handle, document, 1, VIEW)
    for at in (handle.canvas_px, to):
        result = drag.send(Pointer(VIEW.view_from_canvas(at), at, Modifiers(snap=False)))
    drag.close()
    return result


def stance(document: Document) -> list[tuple[int, bool, float]]:
    known = stances_of(document, LAYER)
    assert known is not None
    return [(foot.track, foot.is_planted, foot.ground_row) for foot in known.at(1).feet]


def test_shape_tells_planted_from_lifted(document: Document) -> None:
    assert found(document, "foot.0").shape is HandleShape.SOLE
    assert found(document, "foot.1").shape is HandleShape.SOLE_LIFTED
    assert found(document, "foot_ground.1").canvas_px == (560.0, 900.0)
    assert handles_of(document, 1, LAYER, VIEW).find("foot_ground.0") is None
    kinds = [guide.kind for guide in handles_of(document, 1, LAYER, VIEW).guides]
    assert kinds.count(GuideKind.FOOT_HEIGHT) == 1


def test_a_foot_is_put_under_the_hand(document: Document) -> None:
    after = dragged(document, found(document, "foot.0"), (470.0, 893.0))
    assert found(after, "foot.0").canvas_px == (470.0, 893.0)
    assert pin_of(after.layer(LAYER).cels.drawings[0], 0) is not None


def test_a_foot_of_a_moved_cel_is_put_there_too(document: Document) -> None:
    for name, value in {"position": [300.0, 500.0], "scale": [-50.0, 50.0], "rotation": 30.0}.items():
        document = set_constant(document, resolve(document, f"layers.A.{name}"), value)
    handle = found(document, "foot.0")
    to = (handle.canvas_px[0] + 9.0, handle.canvas_px[1] - 5.0)
    assert found(dragged(document, handle, to), "foot.0").canvas_px == pytest.approx(to, abs=1e-6)


def test_the_ground_below_a_foot_is_put_at_a_row(document: Document) -> None:
    after = dragged(document, found(document, "foot_ground.1"), (700.0, 880.0))
    assert stance(after)[1] == (1, False, 880.0)


def test_a_person_has_the_last_word(document: Document) -> None:
    foot = shown_foot(document, found(document, "foot.1"), 1)
    assert foot is not None
    planted = judged(document, foot, Verdict.PLANTED)
    assert stance(planted)[1] == (1, True, 840.0)
    assert [track for track, _, _ in stance(judged(document, foot, Verdict.NONE))] == [0]
    assert unpinned(planted, foot) == document
    assert judged(planted, foot, None) == document


def test_a_foot_can_be_put_where_none_was_found(document: Document) -> None:
    after = with_foot_at(document, LAYER, 1, (520.0, 885.0))
    assert after is not None
    assert (2, True, 885.0) in stance(after)
    foot = shown_foot(after, found(after, "foot.2"), 1)
    assert foot is not None
    assert unpinned(after, foot) == document


def test_grounding_points_hide_feet(document: Document) -> None:
    pointed = set_constant(document, resolve(document, "layers.A.grounding"), [[450.0, 890.0]])
    assert handles_of(pointed, 1, LAYER, VIEW).find("foot.0") is None
    on_line = set_constant(document, resolve(document, "layers.A.stance"), "line")
    assert handles_of(on_line, 1, LAYER, VIEW).find("foot.0") is None


def test_a_foot_is_pinned_as_it_is(document: Document) -> None:
    for handle_id, expected in (("foot.0", True), ("foot.1", False)):
        foot = shown_foot(document, found(document, handle_id), 1)
        assert foot is not None
        assert carries(document, foot, 1) is expected
        kept = kept_in_place(document, foot)
        pin = pin_of(kept.layer(LAYER).cels.drawings[0], foot.track)
        assert pin is not None
        assert pin.place == found(document, handle_id).canvas_px
