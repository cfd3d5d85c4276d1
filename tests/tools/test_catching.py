"""What a piece catches of a shadow, against shadows that can be worked out by hand."""

from math import pi

import numpy as np
import pytest

from kagezou.document import properties as p
from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera
from kagezou.geometry.card import Card, vertical_piece
from kagezou.geometry.sets.bodies import Ball, Body, Solid
from kagezou.geometry.sets.measures import PieceKind
from kagezou.geometry.sets.shapes import box
from kagezou.geometry.vectors import Vector4
from kagezou.scene.evaluate import evaluate, ground_at
from kagezou.scene.set_outlines import outlines_of
from kagezou.tools.catching import Caster, Catch, casters_of, catch_of
from kagezou.tools.placing import NewPiece, add_placed
from tests.tools.tool_scenes import LAYER, document_with

CAMERA = Camera(1000, 1000)
FRONT: Vector4 = (0.0, 0.0, 1.0, 0.0)
CARD = Card((vertical_piece((0.0, 0.0), 0.0),))
BALL = Ball((500.0, 500.0, -400.0), 100.0)
AROUND_BALL = Box(400, 400, 600, 600)


def figure(around: Box, shape: object = ((True,),)) -> Caster:
    return Caster("layer-1", CARD, around, np.array(shape, np.bool_))


def caught(caster: Caster, *others: Caster, light: Vector4, body: Body = BALL, camera: Camera = CAMERA) -> Catch:
    return catch_of((body,), AROUND_BALL, caster, others, camera, light)


def test_light_from_the_eye_casts_only_where_the_figure_hides_the_piece() -> None:
    found = caught(figure(Box(500, 0, 1000, 1000)), light=FRONT)
    assert found.shown == pytest.approx(0.5, abs=0.03)
    assert (found.part, found.area_px, found.parts) == (0.0, 0.0, 0)


@pytest.mark.parametrize("fov", [0.0, 40.0])
def test_a_shadow_covers_what_lies_behind_the_figure_toward_the_light(fov: float) -> None:
    # The sun stands at 45 degrees to the left: 400 px behind the card the shadow lies 400 px to the right.
    camera = Camera(1000, 1000, fov)
    found = caught(figure(Box(-1000, 500, 300, 1000)), light=(-1.0, 0.0, 1.0, 0.0), camera=camera)
    assert found.shown == pytest.approx(1.0)
    assert 0.4 < found.part < 0.6
    assert found.parts == 1
    assert found.area_px < pi * 100**2 / 2


def test_a_lamp_before_the_card_casts_and_one_behind_it_does_not() -> None:
    caster = figure(Box(-1000, -1000, 300, 2000))
    assert caught(caster, light=(-500.0, 500.0, 800.0, 1.0)).part > 0.5
    assert caught(caster, light=(-500.0, 500.0, -100.0, 1.0)).part == 0.0


def test_light_along_the_card_casts_nothing() -> None:
    assert caught(figure(Box(-1000, -1000, 300, 2000)), light=(-1.0, 0.0, 0.0, 0.0)).part == 0.0


def test_what_the_piece_turns_away_from_the_light_is_not_lit_and_does_not_count() -> None:
    dark = caught(figure(Box(-1000, -1000, 300, 2000)), light=(-1.0, 0.0, -1.0, 0.0))
    assert dark.part == 0.0
    assert dark.shown == 1.0


def test_a_shadow_in_stripes_falls_apart() -> None:
    stripes = figure(Box(-100, 400, 200, 600), [[True], [False], [True], [False], [True]])
    assert caught(stripes, light=(-1.0, 0.0, 1.0, 0.0)).parts == 3


def test_others_hide_but_do_not_cast() -> None:
    light: Vector4 = (-1.0, 0.0, 1.0, 0.0)
    own, other = figure(Box(-1000, 0, 200, 500)), figure(Box(-1000, 500, 200, 1000))
    assert caught(own, other, light=light) == caught(own, light=light)
    hiding = figure(Box(400, 400, 600, 500))
    assert caught(own, hiding, light=light).part == 0.0


def test_of_a_box_the_sides_toward_the_eye_are_met() -> None:
    ground = ground_at(document_with(), 1)
    (body,) = box(ground, 100.0, 100.0, 100.0)
    assert isinstance(body, Solid)
    frame = Box(450, 788, 550, 925)
    found = catch_of((body,), frame, figure(Box(0, 0, 10, 10)), (), CAMERA, FRONT)
    assert (found.shown, found.part) == (1.0, 0.0)


def test_figures_on_a_frame_have_the_shapes_that_are_known() -> None:
    document = document_with()
    (round_one,) = casters_of(document, 1, {})
    assert round_one.area_px == pytest.approx(pi / 4 * 200 * 700, rel=0.02)
    (full,) = casters_of(document, 1, {LAYER: np.ones((2, 2), np.bool_)})
    assert full.area_px == 200 * 700
    assert full.covers(np.array([399.0, 400.5, 599.0, 600.5]), np.array([300.0] * 4)).tolist() == [
        False,
        True,
        True,
        False,
    ]


@pytest.mark.parametrize("kind", [PieceKind.BOX, PieceKind.STEPS, PieceKind.RAMP, PieceKind.CYLINDER, PieceKind.SPHERE])
def test_a_new_piece_is_put_where_a_shadow_is_read(kind: PieceKind) -> None:
    lit = document_with((p.LIGHT_KIND, "sun"), (p.LIGHT_AZIMUTH, -40.0), (p.LIGHT_ELEVATION, 40.0))
    document, _ = add_placed(lit, 1, LAYER, NewPiece(kind, "Piece"))
    scene, (outline,) = evaluate(document, 1), outlines_of(document, 1)
    (left, top), (right, bottom) = (bound(outline.ends.reshape(-1, 2), axis=0) for bound in (np.min, np.max))
    (caster,) = casters_of(document, 1, {})
    cast = scene.layers[0].cast
    assert cast is not None
    frame = Box(int(left), int(top), int(right), int(bottom))
    found = catch_of(scene.pieces[0].bodies, frame, caster, (), scene.camera, cast.lights[0])
    assert 0.15 <= found.part <= 0.85
    assert found.area_px >= 0.03 * caster.area_px
    assert found.parts <= 3
