"""Tip and tilt of figures as a frame shows them: moved, mirrored, of several cels, on feet, and in the air."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from kagezou.document import figure_properties as f
from kagezou.document import properties as p
from kagezou.document.address import Address, resolve
from kagezou.document.edits import add_layer, join_layer, set_constant, set_drawings, set_key
from kagezou.document.invariants import check
from kagezou.document.model import Cels, Document, Drawing, Exposure
from kagezou.document.values import value_at
from kagezou.geometry.box import Box
from kagezou.geometry.camera import project
from kagezou.geometry.light import lamp
from kagezou.geometry.shadow import cast_on
from kagezou.geometry.vectors import Point2
from kagezou.scene.evaluate import camera_at, ground_at
from kagezou.scene.figure_card import card_at
from kagezou.standing.foot import Foot
from kagezou.tools.handle import GuideKind
from kagezou.tools.handles import drag_of, handles_of
from kagezou.tools.pointer import Modifiers, Pointer
from kagezou.tools.tilt import ABOVE_HEAD_VIEW_PX
from kagezou.tools.view import CanvasView
from tests.tools.tool_scenes import FIGURE, LAYER, document_with

VIEW = CanvasView()
LAMP = (p.LIGHT_POSITION, (200.0, -900.0, 1200.0))


def put(document: Document, path: str, raw: object, frame: int | None = None) -> Document:
    address = resolve(document, path)
    return set_constant(document, address, raw) if frame is None else set_key(document, address, frame, raw)


def with_feet(document: Document, *feet: Foot) -> Document:
    (drawing,) = document.layer(LAYER).cels.drawings
    return set_drawings(document, LAYER, (replace(drawing, size_px=(1000, 1000), figure=FIGURE, feet=feet),))


def moved() -> Document:
    document = put(document_with(LAMP), "layers.A.position", (500.0, 500.0), 1)
    return put(document, "layers.A.position", (700.0, 450.0), 11)


def mirrored() -> Document:
    document = put(document_with(LAMP), "layers.A.scale", (-100.0, 100.0))
    return put(document, "layers.A.position", (420.0, 500.0))


def of_two_cels() -> Document:
    cels = Cels(
        (Drawing("1", Path("hat.png"), size_px=(1000, 1000), figure=Box(450, 120, 700, 260)),), (Exposure(1, 0),)
    )
    document = add_layer(document_with(LAMP), "hat", cels, Box(450, 120, 700, 260))
    return join_layer(document, document.layers[-1].id, LAYER)


def on_feet() -> Document:
    return with_feet(document_with(LAMP), Foot(0, (430.0, 900.0)), Foot(1, (570.0, 850.0)))


def in_the_air() -> Document:
    """A figure that stands, is 200 px up, and stands again."""
    feet = (Foot(0, (450.0, 900.0)), Foot(1, (550.0, 900.0)))
    up = tuple(Foot(foot.track, (foot.place[0], 700.0)) for foot in feet)
    drawings = (
        Drawing("1", Path("1.png"), size_px=(1000, 1000), figure=FIGURE, feet=feet),
        Drawing("2", Path("2.png"), size_px=(1000, 1000), figure=FIGURE.moved(0, -200), feet=up),
    )
    document = document_with(LAMP)
    layer = replace(document.layer(LAYER), cels=Cels(drawings, (Exposure(1, 0), Exposure(9, 1), Exposure(13, 0))))
    return replace(document, layers=(layer,))


SCENES = {
    "moved": (moved(), 11, (700.0, 150.0)),
    "mirrored": (mirrored(), 1, (420.0, 200.0)),
    "of two cels": (of_two_cels(), 1, (550.0, 120.0)),
    "on feet": (on_feet(), 1, (500.0, 200.0)),
    "in the air": (in_the_air(), 11, (500.0, 0.0)),
}


def tip(document: Document, frame: int) -> Point2:
    found = handles_of(document, frame, LAYER, VIEW).find("shadow.tip")
    assert found is not None
    return found.canvas_px


def cast_head(document: Document, frame: int, head: Point2) -> Point2:
    """Return where the shadow of a canvas point of the figure is drawn."""
    camera, ground = camera_at(document, frame), ground_at(document, frame)
    card = card_at(document, document.layer(LAYER), frame, camera, ground)
    (piece,) = (piece for piece in card.pieces if piece.holds(head))
    cast = cast_on(camera, ground, piece, lamp(value_at(document.tracks, p.LIGHT_POSITION, frame)))
    assert cast is not None
    return project(np.asarray(np.linalg.inv(cast.art_from_canvas), np.float64), head)


@pytest.mark.parametrize("name", SCENES)
@pytest.mark.parametrize("upright", [0.0, 1.0])
def test_the_tip_lies_where_the_head_of_the_shown_frame_casts_it_and_does_not_jump(name: str, upright: float) -> None:
    document, frame, head = SCENES[name]
    document = put(document, "layers.A.upright", upright)
    assert tip(document, frame) == pytest.approx(cast_head(document, frame, head), abs=0.01)
    handle = handles_of(document, frame, LAYER, VIEW).find("shadow.tip")
    assert handle is not None
    drag = drag_of(handle, document, frame, VIEW)
    pressed = (handle.canvas_px[0] + 3, handle.canvas_px[1] - 2)
    assert drag.send(Pointer(pressed, pressed, Modifiers(snap=False))) is document
    for way in ((0.25, -0.25), (40.0, 12.0)):
        at = (pressed[0] + way[0], pressed[1] + way[1])
        shown = drag.send(Pointer(at, at, Modifiers(snap=False)))
        check(shown)
        assert tip(shown, frame) == pytest.approx(
            (handle.canvas_px[0] + way[0], handle.canvas_px[1] + way[1]), abs=0.01
        )
        assert cast_head(shown, frame, head) == pytest.approx(tip(shown, frame), abs=0.01)
    drag.close()


def test_the_tip_is_that_of_the_figure_also_while_a_part_is_worked_on() -> None:
    document = of_two_cels()
    part = handles_of(document, 1, document.layers[-1].id, VIEW).find("shadow.tip")
    assert part is not None
    assert part.canvas_px == tip(document, 1)


def test_a_cel_that_is_not_seen_has_no_tip() -> None:
    document = put(document_with(LAMP), "layers.A.scale", (0.0, 0.0))
    assert handles_of(document, 1, LAYER, VIEW).find("shadow.tip") is None


def lever(document: Document, frame: int = 1) -> tuple[Point2, Point2]:
    """Return both ends of the tilt's arm."""
    (arm,) = (each for each in handles_of(document, frame, LAYER, VIEW).guides if each.kind is GuideKind.TILT_ARM)
    start, end = arm.points
    return start, end


@pytest.mark.parametrize("tilt", [-60.0, 30.0])
@pytest.mark.parametrize("upright", [0.0, 1.0])
def test_a_body_turns_about_its_own_feet(tilt: float, upright: float) -> None:
    document = put(on_feet(), "layers.A.upright", upright)
    apart = put(document, "ground.position", (5000.0, 900.0))
    for each in (document, apart):
        camera, ground = camera_at(each, 1), ground_at(each, 1)
        before = card_at(each, each.layer(LAYER), 1, camera, ground)
        after_document = put(each, "layers.A.tilt", tilt)
        after = card_at(after_document, after_document.layer(LAYER), 1, camera, ground)
        assert after.tilt_deg == tilt
        assert after.contacts == before.contacts
        assert after.axis == before.axis
        assert before.axis is not None
        x = before.axis[0]
        depths = [depth_at(card.piece_at((x, 300.0)).plane, x, 300.0) for card in (before, after)]
        assert depths[1] == pytest.approx(depths[0], abs=1e-6)
        assert lever(after_document)[0] == pytest.approx((500.0, 200.0 - ABOVE_HEAD_VIEW_PX))
        assert handles_of(after_document, 1, LAYER, VIEW).find("tilt.lever") is not None


def depth_at(plane: tuple[float, float, float, float], x: float, y: float) -> float:
    a, b, c, d = plane
    return -(a * x + b * y + d) / c


def test_the_tilt_s_lever_stands_at_its_own_figure_on_the_frame_that_is_shown() -> None:
    document = moved()
    assert lever(document, 1)[0] == (500.0, 200.0 - ABOVE_HEAD_VIEW_PX)
    # The ground line's position is at 500; the figure is at 600 to 800.
    assert lever(document, 11)[0] == (600.0, 150.0 - ABOVE_HEAD_VIEW_PX)
    one_point = put(document, "layers.A.grounding", [[650, 850]])
    assert lever(one_point, 11)[0] == (650.0, 150.0 - ABOVE_HEAD_VIEW_PX)
    air = in_the_air()
    assert lever(air, 11)[0] == (500.0, ABOVE_HEAD_VIEW_PX / 2)
    out = put(document_with(LAMP), "layers.A.position", (-600.0, 1800.0))
    (x, y), _ = lever(out)
    assert 0 <= x <= 1000
    assert 0 <= y <= 1000


def test_two_points_measure_the_tilt_and_feet_do_not() -> None:
    def has_lever(document: Document) -> bool:
        return handles_of(document, 1, LAYER, VIEW).find("tilt.lever") is not None

    assert has_lever(on_feet())
    points = put(on_feet(), "layers.A.grounding", [[430, 900], [570, 850]])
    assert not has_lever(points)
    assert Address(f.STANCE, LAYER).property.default == "feet"
    assert not has_lever(put(points, "layers.A.stance", "points"))
