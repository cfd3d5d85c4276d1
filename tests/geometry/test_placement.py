"""How drawings are laid on the canvas: the affine maps and their boxes."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera
from kagezou.geometry.card import card_for
from kagezou.geometry.ground import ground_plane
from kagezou.geometry.light import lamp
from kagezou.geometry.placement import (
    Placement,
    around_placed,
    canvas_from_centred,
    centred_from_canvas,
    lie_alike,
    whole_shift,
)
from kagezou.geometry.shadow import cast_card, cast_in_space

px = st.floats(-2000, 2000)
factors = st.floats(-4, 4).filter(lambda each: abs(each) > 0.05)
placements = st.builds(
    Placement, st.tuples(px, px), st.tuples(px, px), st.tuples(factors, factors), st.floats(-720, 720)
)


@given(placements)
def test_the_anchor_lies_on_the_position(placement: Placement) -> None:
    assert placement.placed(placement.anchor) == pytest.approx(placement.position, abs=1e-6)
    assert placement.is_seen
    way = placement.canvas_from_centred() @ placement.centred_from_canvas()
    assert np.allclose(way, np.eye(3), atol=1e-6)


def test_turns_go_clockwise_as_seen() -> None:
    quarter = Placement((100.0, 100.0), (0.0, 0.0), rotation_deg=90.0)
    assert quarter.placed((10.0, 0.0)) == (100.0, 110.0)
    assert quarter.placed((0.0, 10.0)) == (90.0, 100.0)
    mirrored = Placement((100.0, 100.0), (0.0, 0.0), (-2.0, 1.0))
    assert mirrored.placed((10.0, 5.0)) == (80.0, 105.0)


def test_a_placement_that_changes_nothing_is_known() -> None:
    still = Placement((5.0, 6.0), (5.0, 6.0), rotation_deg=360.0)
    assert not still.moves
    assert (still.canvas_from_centred() == np.eye(3)).all()
    assert Placement((5.0, 6.0), (5.0, 7.0)).moves
    assert not Placement((0.0, 0.0), (0.0, 0.0), (1.0, 0.0)).is_seen


def test_none_moves_nothing() -> None:
    moved = Placement((3.0, 0.0), (0.0, 0.0))
    assert (canvas_from_centred(None) == np.eye(3)).all()
    assert (centred_from_canvas(None) == np.eye(3)).all()
    assert canvas_from_centred(moved)[0, 2] == 3.0
    assert centred_from_canvas(moved)[0, 2] == -3.0


def test_drawings_lie_alike_where_their_pixels_do() -> None:
    turned = Placement((10.0, 20.0), (0.0, 0.0), (2.0, 2.0), 30.0)
    assert lie_alike(None, None)
    assert lie_alike(None, Placement((7.0, -3.0), (0.0, 0.0)))
    assert not lie_alike(None, Placement((7.5, 0.0), (0.0, 0.0)))
    assert lie_alike(turned, Placement(turned.placed((4.0, 5.0)), (0.0, 0.0), (2.0, 2.0), 30.0))
    assert not lie_alike(turned, None)
    assert (whole_shift(np.array([[1.0, 0.0, 6.9999], [0.0, 1.0, -3.0001], [0.0, 0.0, 1.0]]))[:2, 2] == (7, -3)).all()


def test_boxes_around_what_is_moved_are_whole() -> None:
    box = Box(0, 0, 10, 4)
    assert around_placed(box, np.eye(3)) == box
    assert around_placed(box, Placement((0.0, 0.0), (0.0, 0.0), rotation_deg=90.0).canvas_from_centred()) == Box(
        -4, 0, 0, 10
    )
    assert around_placed(box, Placement((0.25, 0.0), (0.0, 0.0)).canvas_from_centred()) == Box(0, 0, 11, 4)


def test_a_shadow_of_a_moved_drawing_is_found_where_the_drawing_was() -> None:
    camera, ground, light = Camera(1000, 1000), ground_plane((500.0, 900.0), 0.0, 60.0), lamp((200.0, -300.0, 900.0))
    card = card_for(camera, ground, ((480.0, 890.0),), 0.0, 700.0)
    placement = Placement((300.0, 250.0), (500.0, 500.0), (-0.5, 0.7), 25.0)
    (cast,) = cast_card(camera, ground, card, light)
    space = cast_in_space(camera, card.pieces[0], light)
    assert space is not None
    back = placement.centred_from_canvas()
    for x, y in ((420.0, 700.0), (500.0, 620.0)):
        here = np.array([x, y, 1.0])
        seen, moved = cast.art_from_canvas @ here, cast.of_moved(placement).art_from_canvas @ here
        assert moved[:2] / moved[2] == pytest.approx((back @ (seen / seen[2]))[:2])
        world = np.array([x, 880.0, y, 1.0])
        seen, moved = space.art_from_world @ world, space.of_moved(placement).art_from_world @ world
        assert moved[:2] / moved[2] == pytest.approx((back @ (seen / seen[2]))[:2])


def test_the_middle_of_a_box() -> None:
    assert Box(0, 10, 5, 20).middle == (2.5, 15.0)
