"""Cels taken hold of on the picture: corners, turns, the anchor and the whole."""

from math import cos, radians, sin

import pytest

from kagezou.document.address import resolve, value_of
from kagezou.document.edits import set_constant
from kagezou.document.model import Document
from kagezou.geometry.vectors import Point2
from kagezou.scene.placing import whole_placement
from kagezou.tools.cel_placing import ANCHOR_POINT, CORNER, TURN
from kagezou.tools.handle import Handle
from kagezou.tools.handles import cel_mover, drag_of, placing_handles_of
from kagezou.tools.pointer import Modifiers, Pointer
from kagezou.tools.view import CanvasView
from tests.tools.tool_scenes import LAYER, document_with

VIEW = CanvasView()


@pytest.fixture
def document() -> Document:
    return with_values(document_with(), {"scale": [80.0, 120.0], "rotation": 20.0, "position": [430.0, 310.0]})


def with_values(document: Document, values: dict[str, object]) -> Document:
    name = document.layer(LAYER).name
    for prop, value in values.items():
        document = set_constant(document, resolve(document, f"layers.{name}.{prop}"), value)
    return document


def value(document: Document, prop: str) -> object:
    return value_of(document, resolve(document, f"layers.{document.layer(LAYER).name}.{prop}"), 1)


def point(document: Document, prop: str) -> Point2:
    found = value(document, prop)
    assert isinstance(found, tuple)
    x, y = (float(part) for part in found if isinstance(part, float))
    return (x, y)


def dragged(document: Document, handle: Handle, to: Point2, **held: bool) -> Document:
    drag = drag_of(handle, document, 1, VIEW)
    modifiers = Modifiers(**{"snap": False, **held})
    drag.send(Pointer(VIEW.view_from_canvas(handle.canvas_px), handle.canvas_px, modifiers))
    result = drag.send(Pointer(VIEW.view_from_canvas(to), to, modifiers))
    drag.close()
    return result


def found(document: Document, handle_id: str) -> Handle:
    handle = placing_handles_of(document, 1, LAYER, VIEW).find(handle_id)
    assert handle is not None
    return handle


@pytest.mark.parametrize("corner", range(4))
def test_a_corner_lies_under_the_hand(document: Document, corner: int) -> None:
    handle = found(document, f"{CORNER}.{corner}")
    to = (handle.canvas_px[0] + 37.0, handle.canvas_px[1] - 22.0)
    after = dragged(document, handle, to)
    assert found(after, handle.id).canvas_px == pytest.approx(to, abs=1e-6)
    assert value(after, "position") == value(document, "position")


def test_constrained_a_corner_keeps_the_proportions(document: Document) -> None:
    handle = found(document, f"{CORNER}.2")
    after = dragged(document, handle, (handle.canvas_px[0] + 30.0, handle.canvas_px[1] + 50.0), constrain=True)
    sx, sy = point(after, "scale")
    assert sx / sy == pytest.approx(80 / 120)
    assert sx > 80


def test_over_the_anchor_a_cel_is_mirrored(document: Document) -> None:
    straight = with_values(document, {"rotation": 0.0})
    handle = found(straight, f"{CORNER}.2")
    x, _ = point(straight, "position")
    after = dragged(straight, handle, (2 * x - handle.canvas_px[0], handle.canvas_px[1]))
    assert value(after, "scale") == pytest.approx((-80.0, 120.0))


@pytest.mark.parametrize("turn", [35.0, -50.0, 170.0])
def test_outside_of_a_corner_a_cel_is_turned(document: Document, turn: float) -> None:
    handle = found(document, f"{TURN}.1")
    after = dragged(document, handle, around(document, handle.canvas_px, turn))
    assert value(after, "rotation") == pytest.approx(20.0 + turn)
    stepped = dragged(document, handle, around(document, handle.canvas_px, turn), constrain=True)
    assert value(stepped, "rotation") == pytest.approx(round((20.0 + turn) / 15) * 15)


def test_a_turn_goes_round_as_often_as_the_hand(document: Document) -> None:
    handle = found(document, f"{TURN}.0")
    drag = drag_of(handle, document, 1, VIEW)
    after = document
    for step in range(41):
        at = around(document, handle.canvas_px, 20.0 * step)
        after = drag.send(Pointer(VIEW.view_from_canvas(at), at, Modifiers(snap=False)))
    assert value(after, "rotation") == pytest.approx(820.0)


def around(document: Document, at: Point2, turn: float) -> Point2:
    x, y = point(document, "position")
    dx, dy, a = at[0] - x, at[1] - y, radians(turn)
    return (x + dx * cos(a) - dy * sin(a), y + dx * sin(a) + dy * cos(a))


def test_the_anchor_moves_and_the_drawing_stays(document: Document) -> None:
    handle = found(document, ANCHOR_POINT)
    after = dragged(document, handle, (handle.canvas_px[0] + 60.0, handle.canvas_px[1] + 45.0))
    assert found(after, ANCHOR_POINT).canvas_px == pytest.approx((490.0, 355.0))
    before, now = (whole_placement(each, each.layer(LAYER), 1) for each in (document, after))
    for point in ((0.0, 0.0), (250.0, 90.0)):
        assert now.placed(point) == pytest.approx(before.placed(point), abs=1e-6)


def test_within_its_frame_a_cel_is_moved(document: Document) -> None:
    (left, top), _, (right, bottom), _ = (found(document, f"{CORNER}.{index}").canvas_px for index in range(4))
    inside = ((left + right) / 2, (top + bottom) / 2)
    handle = cel_mover(document, 1, LAYER, VIEW, inside)
    assert handle is not None
    assert cel_mover(document, 1, LAYER, VIEW, (left - 500.0, top)) is None
    after = dragged(document, handle, (handle.canvas_px[0] + 12.0, handle.canvas_px[1] - 3.0))
    assert value(after, "position") == pytest.approx((442.0, 307.0))
    along = dragged(document, handle, (handle.canvas_px[0] + 12.0, handle.canvas_px[1] - 3.0), constrain=True)
    assert value(along, "position") == pytest.approx((442.0, 310.0))
