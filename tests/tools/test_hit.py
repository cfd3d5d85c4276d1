import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.message import Message
from kagezou.tools.handle import (
    EDGE_MARGIN_PX,
    HIT_RADIUS_PX,
    PEN_HIT_RADIUS_PX,
    Handle,
    HandleSet,
    HandleShape,
    clamped,
    hit,
    place_in_view,
)
from kagezou.tools.view import CanvasView


def ring(name: str, x: float, y: float, *, stays_in_view: bool = False) -> Handle:
    return Handle(name, HandleShape.RING, (x, y), None, Message("{name}", name=name), stays_in_view=stays_in_view)


def test_the_nearest_handle_is_hit() -> None:
    handles = (ring("a", 100, 100), ring("b", 106, 100))
    assert hit(handles, CanvasView(), (104, 100)) is handles[1]
    assert hit(handles, CanvasView(), (102, 100)) is handles[0]


def test_the_topmost_of_equally_near_handles_is_hit() -> None:
    handles = (ring("a", 100, 100), ring("b", 100, 100))
    assert hit(handles, CanvasView(), (101, 100)) is handles[1]


def test_the_radius_is_in_view_px_whatever_the_zoom() -> None:
    handles = (ring("a", 100, 100),)
    view = CanvasView(8.0)
    assert hit(handles, view, (800 + HIT_RADIUS_PX, 800)) is handles[0]
    assert hit(handles, view, (800 + HIT_RADIUS_PX + 0.1, 800)) is None
    assert hit(handles, view, (800 + PEN_HIT_RADIUS_PX, 800), PEN_HIT_RADIUS_PX) is handles[0]


def test_a_handle_outside_the_view_is_hit_at_its_edge_if_it_stays_in_view() -> None:
    far, lost = ring("lamp", 300, -700, stays_in_view=True), ring("lost", 200, -700)
    edge = (300, EDGE_MARGIN_PX)
    assert hit((lost, far), CanvasView(), edge, view_size=(800, 600)) is far
    assert hit((lost, far), CanvasView(), edge) is None
    assert hit((lost,), CanvasView(), (200, EDGE_MARGIN_PX), view_size=(800, 600)) is None


def test_what_is_seen_is_not_moved_to_the_edge() -> None:
    assert clamped((3, 597), (800, 600)) is None
    inside = ring("lamp", 3, 597, stays_in_view=True)
    assert place_in_view(inside, CanvasView(), (800, 600)) == ((3, 597), None)


def test_the_arrow_points_from_the_edge_to_the_true_place() -> None:
    off = clamped((400, -300), (800, 600), 20)
    assert off is not None
    assert off.view_px == pytest.approx((400, 20))
    assert off.direction == pytest.approx((0, -1))
    assert off.distance_px == pytest.approx(320)


@given(st.tuples(st.floats(-1e6, 1e6), st.floats(-1e6, 1e6)), st.tuples(st.floats(1, 3000), st.floats(1, 3000)))
def test_a_clamped_place_lies_in_the_view_on_the_way_to_the_true_one(
    at: tuple[float, float], size: tuple[float, float]
) -> None:
    off = clamped(at, size)
    if off is None:
        assert all(0 <= part <= whole for part, whole in zip(at, size, strict=True))
        return
    assert all(0 <= part <= whole for part, whole in zip(off.view_px, size, strict=True))
    reached = tuple(a + off.distance_px * d for a, d in zip(off.view_px, off.direction, strict=True))
    assert reached == pytest.approx(at, abs=1e-3)


def test_handles_are_found_by_their_id() -> None:
    handles = HandleSet((ring("a", 0, 0), ring("b", 1, 1)))
    assert handles.find("b") is handles.handles[1]
    assert handles.find("c") is None
    assert handles.find(None) is None
