"""A wall that is put or drawn stands behind all figures, holds their shadows, and no head lies behind it."""

from dataclasses import replace
from math import hypot
from pathlib import Path

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from kagezou.document import properties as p
from kagezou.document.edits import add_layer, set_drawings
from kagezou.document.invariants import check
from kagezou.document.model import Cels, Document, Drawing, Exposure
from kagezou.geometry.box import Box
from kagezou.geometry.sets.measures import PieceKind
from kagezou.geometry.sight import seen
from kagezou.geometry.vectors import dot
from kagezou.scene.evaluate import camera_at, ground_at
from kagezou.scene.misfits import MisfitKind, misfits_of
from kagezou.scene.piece_frames import piece_frame
from kagezou.standing.foot import Foot
from kagezou.tools.corner import drawing, wall_line
from kagezou.tools.placing import NewPiece, add_placed
from kagezou.tools.pointer import Modifiers, Pointer
from kagezou.tools.sight import between, moved
from kagezou.tools.wall_fitting import FigureSide, reach_on, sides_of
from tests.tools.tool_scenes import FIGURE, LAYER, document_with

lamps = st.tuples(st.floats(-300, 1300), st.floats(-1500, -400), st.floats(600, 2500))


def two(lamp: tuple[float, float, float], fov: float = 0.0) -> Document:
    """Return a figure on feet at row 900, and one farther back on feet at row 750."""
    document = document_with((p.LIGHT_POSITION, lamp), (p.FOV, fov))
    box = Box(150, 250, 300, 750)
    cels = Cels((Drawing("1", Path("b.png")),), (Exposure(1, 0),))
    document = add_layer(document, "B", cels, box)
    for layer, figure, feet in (
        (document.layer(LAYER), FIGURE, ((450.0, 900.0), (550.0, 900.0))),
        (document.layers[-1], box, ((180.0, 750.0), (270.0, 740.0))),
    ):
        found = tuple(Foot(track, place) for track, place in enumerate(feet))
        drawn = replace(layer.cels.drawings[0], size_px=(1000, 1000), figure=figure, feet=found)
        document = set_drawings(document, layer.id, (drawn,))
    return document


@settings(max_examples=20)
@given(lamps, st.sampled_from([0.0, 30.0, 60.0]), st.sampled_from([LAYER, None]))
def test_a_wall_that_is_put_beheads_nobody_and_holds_the_shadows(
    lamp: tuple[float, float, float], fov: float, layer_id: str | None
) -> None:
    document, piece_id = add_placed(two(lamp, fov), 1, layer_id, NewPiece(PieceKind.WALL, "Back"))
    check(document)
    assert all(each.kind is not MisfitKind.POKES for each in misfits_of(document))
    camera, ground = camera_at(document, 1), ground_at(document, 1)
    found = piece_frame(document.piece(piece_id), 1, camera, ground)
    assert found is not None
    sides = sides_of(document, 1)
    # Behind all figures …
    ways = [between(found.stand.origin, end) for side in sides for end in (side.foot, side.top)]
    assert min(dot(way, ground.v) for way in ways) > 0
    # … and at least as large as what falls on it.
    reach = reach_on(sides, found.stand, 3 * 1000)
    if reach is not None:
        slack = 2 * found.scale
        assert -found.measures.width_px / 2 <= reach.left + slack
        assert reach.right - slack <= found.measures.width_px / 2
        assert reach.top - slack <= found.measures.height_px


@pytest.mark.parametrize("x", [-300.0, 300.0, 900.0])
def test_the_head_of_the_figure_falls_onto_the_wall(x: float) -> None:
    document, piece_id = add_placed(
        document_with((p.LIGHT_POSITION, (x, -200.0, 2200.0))), 1, LAYER, NewPiece(PieceKind.WALL, "Back")
    )
    found = piece_frame(document.piece(piece_id), 1, camera_at(document, 1), ground_at(document, 1))
    assert found is not None
    reach = reach_on(sides_of(document, 1), found.stand, 3000)
    assert reach is not None
    assert reach.top > 0.15 * 700


@settings(max_examples=15)
@given(lamps, st.tuples(st.floats(0, 300), st.floats(500, 690)), st.tuples(st.floats(700, 1000), st.floats(500, 690)))
def test_a_wall_that_is_drawn_behind_the_figures_is_high_enough(
    lamp: tuple[float, float, float], start: tuple[float, float], end: tuple[float, float]
) -> None:
    document = two(lamp)
    assume(hypot(end[0] - start[0], end[1] - start[1]) > 100)
    drag = drawing(document, wall_line(document, 1, LAYER, "Back"))
    for at in (start, start, end):
        after = drag.send(Pointer(at, at, Modifiers(snap=False)))
    check(after)
    assert [after.layers[n].tracks["upright"].constant for n in (0, 1)] == [1, 1]
    assert all(each.kind is not MisfitKind.POKES for each in misfits_of(after))
    found = piece_frame(after.pieces[-1], 1, camera_at(after, 1), ground_at(after, 1))
    assert found is not None
    reach = reach_on(sides_of(after, 1), found.stand, 3 * 1000)
    if reach is not None:
        assert reach.top <= found.measures.height_px


def test_where_a_shadow_falls_on_a_wall_is_seen_there() -> None:
    document, piece_id = add_placed(
        document_with((p.LIGHT_POSITION, (300.0, -200.0, 2200.0))), 1, LAYER, NewPiece(PieceKind.WALL, "B")
    )
    camera, ground = camera_at(document, 1), ground_at(document, 1)
    found = piece_frame(document.piece(piece_id), 1, camera, ground)
    assert found is not None
    stand = found.stand
    light = (300.0, -200.0, 2200.0, 1.0)
    head = (500.0, 200.0, 404.145)
    reach = reach_on((FigureSide((500.0, 900.0, 0.0), head, light),), stand, 1e6)
    assert reach is not None
    # The point of the wall on the line from the lamp through the head.
    way = between(light[:3], head)
    part = dot(between(light[:3], stand.origin), stand.v) / dot(way, stand.v)
    at = tuple(a + part * b for a, b in zip(light[:3], way, strict=True))
    offset = between(stand.origin, (at[0], at[1], at[2]))
    assert reach.top == pytest.approx(dot(offset, stand.normal))
    assert max(reach.right, -reach.left) >= abs(dot(offset, stand.u)) - 1e-6
    assert seen(camera, stand.origin)[1] < 900


def test_what_does_not_fall_on_a_wall_has_no_reach() -> None:
    ground = ground_at(document_with(), 1)
    stand = replace(ground, origin=moved(ground.origin, (-300.0, ground.v)))
    side = FigureSide(ground.origin, moved(ground.origin, (800.0, ground.normal)), (0.0, 0.0, 1.0, 0.0))

    def toward(u: float, v: float, up: float) -> FigureSide:
        light = moved((0.0, 0.0, 0.0), (u, ground.u), (v, ground.v), (up, ground.normal))
        return replace(side, light=(*light, 0.0))

    assert reach_on((), stand, 1e3) is None
    assert reach_on((toward(0.0, -1.0, 1.0),), stand, 1e3) is None  # the light stands behind the wall
    assert reach_on((toward(0.0, 0.1, 1.0),), stand, 1e3) is None  # the shadow ends on the ground before it
    reach = reach_on((toward(0.0, 1.0, 1.0),), stand, 1e3)
    assert reach is not None
    assert (reach.left, reach.right, reach.top) == pytest.approx((0.0, 0.0, 500.0))
    # It comes to the wall 300 px aside of the feet, and ends 800 px up it.
    aside = reach_on((toward(-1.0, 1.0, 0.0),), stand, 1e3)
    assert aside is not None
    assert (aside.left, aside.right, aside.top) == pytest.approx((300.0, 300.0, 800.0))
    far = reach_on((toward(-10.0, 1.0, 0.1),), stand, 100.0)
    assert far is not None
    assert (far.right, far.top) == (100.0, 100.0)
