import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.tools.pointer import Modifiers, Pointer
from kagezou.tools.view import MAX_ZOOM, MIN_ZOOM, CanvasView

places = st.tuples(st.floats(-3000, 3000), st.floats(-3000, 3000))
views = st.builds(CanvasView, st.floats(MIN_ZOOM, MAX_ZOOM), places)


@given(views, places)
def test_canvas_and_view_px_are_each_other_s_inverse(view: CanvasView, place: tuple[float, float]) -> None:
    assert view.view_from_canvas(view.canvas_from_view(place)) == pytest.approx(place, abs=1e-6)


@given(views, places, st.floats(0.01, 100))
def test_zooming_keeps_what_lies_under_the_pointer(view: CanvasView, place: tuple[float, float], factor: float) -> None:
    zoomed = view.zoomed_at(place, factor)
    assert MIN_ZOOM <= zoomed.zoom <= MAX_ZOOM
    assert zoomed.view_from_canvas(view.canvas_from_view(place)) == pytest.approx(place, abs=1e-5)


def test_panning_moves_the_picture_by_view_px() -> None:
    assert CanvasView(4.0, (10.0, 20.0)).panned(3, -5) == CanvasView(4.0, (13.0, 15.0))


def test_fitting_shows_the_whole_canvas_centred() -> None:
    view = CanvasView.fitted((1920, 1080), (1000, 800), 20)
    assert view.zoom == pytest.approx(0.5)
    assert view.view_from_canvas((960, 540)) == pytest.approx((500, 400))
    assert view.view_from_canvas((0, 0))[0] == pytest.approx(20)


def test_fitting_into_a_window_without_room_still_gives_a_view() -> None:
    assert CanvasView.fitted((1920, 1080), (10, 0)).zoom == MIN_ZOOM


def test_keys_mean_what_the_program_s_convention_says() -> None:
    assert Modifiers.of_keys() == Modifiers()
    assert Modifiers.of_keys(shift=True) == Modifiers(constrain=True)
    assert Modifiers.of_keys(alt=True) == Modifiers(symmetric=True)
    assert Modifiers.of_keys(shift=True, alt=True) == Modifiers(fine=True)
    assert Modifiers.of_keys(ctrl=True) == Modifiers(snap=False)


def test_a_pointer_knows_its_place_on_the_canvas() -> None:
    pointer = Pointer.seen_at(CanvasView(2.0, (100.0, 50.0)), (120.0, 60.0), Modifiers(fine=True))
    assert pointer == Pointer((120.0, 60.0), (10.0, 5.0), Modifiers(fine=True))
