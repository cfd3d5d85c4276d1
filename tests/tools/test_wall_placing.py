"""A new wall spans the canvas, and shadows bend up it well: a good part lies on the ground, a good part on the wall."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from kagezou.document import properties as p
from kagezou.document.address import Address
from kagezou.document.edits import add_layer, set_constant, set_key
from kagezou.document.figure_properties import POSITION
from kagezou.document.model import Cels, Document, Drawing, Exposure
from kagezou.document.property import AnyProperty
from kagezou.geometry.box import Box
from kagezou.geometry.sets.measures import PieceKind
from kagezou.geometry.sight import seen
from kagezou.geometry.vectors import dot
from kagezou.scene.piece_frames import PieceFrame, piece_frame
from kagezou.tools.frame_geometry import FrameGeometry
from kagezou.tools.placing import NewPiece, add_placed
from kagezou.tools.shadow import tip_of
from kagezou.tools.sight import between, moved
from kagezou.tools.view import CanvasView
from kagezou.tools.wall_fitting import reach_on, sides_of
from kagezou.tools.wall_placing import cut_notes
from tests.tools.tool_scenes import LAYER, document_with

WALL = NewPiece(PieceKind.WALL, "Back")
SUN = ((p.LIGHT_KIND, "sun"), (p.LIGHT_AZIMUTH, -30.0), (p.LIGHT_ELEVATION, 45.0))
LAMP = ((p.LIGHT_POSITION, (200.0, -900.0, 2600.0)),)


def travelling(*settings: tuple[AnyProperty, object]) -> Document:
    """Return a figure that goes from one side of the canvas to the other."""
    document = document_with(*settings)
    at = Address(POSITION, LAYER)
    return set_key(set_key(document, at, 1, (200.0, 500.0)), at, 24, (800.0, 500.0))


def wall_at(document: Document, frame: int) -> PieceFrame:
    geometry = FrameGeometry.of(document, frame, None, CanvasView())
    found = piece_frame(document.pieces[-1], frame, geometry.camera, geometry.ground)
    assert found is not None
    return found


def parts_on_ground(document: Document) -> Iterator[float]:
    """Yield which part of the way of each figure's shadow lies on the ground before the wall, frame by frame."""
    for layer in document.layers:
        for frame in range(1, 25, 4):
            geometry, stand = FrameGeometry.of(document, frame, layer.id, CanvasView()), wall_at(document, frame).stand
            tip = tip_of(geometry)
            assert tip is not None
            foot, end = (dot(between(stand.origin, at), stand.v) for at in (geometry.contact, tip))
            yield foot / (foot - end)


@pytest.mark.parametrize("light", [SUN, LAMP])
@pytest.mark.parametrize("fov", [0.0, 35.0])
def test_the_shadow_of_a_figure_that_travels_bends_well_over_the_whole_cut(
    light: tuple[tuple[AnyProperty, object], ...], fov: float
) -> None:
    document, _ = add_placed(travelling(*light, (p.FOV, fov)), 1, LAYER, WALL)
    parts = list(parts_on_ground(document))
    assert min(parts) >= 0.35
    assert max(parts) <= 0.7


def test_of_two_figures_behind_each_other_both_shadows_bend_on_it() -> None:
    cels = Cels((Drawing("1", Path("b.png")),), (Exposure(1, 0),))
    document = add_layer(document_with(*SUN), "B", cels, Box(100, 200, 300, 860))
    document = set_constant(document, Address(p.GROUNDING, document.layers[-1].id), ((200.0, 860.0),))
    document, _ = add_placed(document, 1, LAYER, WALL)
    assert all(0.2 < part < 0.8 for part in parts_on_ground(document))


@pytest.mark.parametrize("fov", [0.0, 50.0])
@pytest.mark.parametrize("roll", [0.0, -12.0])
def test_it_spans_the_canvas_and_no_shadow_is_cut(fov: float, roll: float) -> None:
    document, _ = add_placed(travelling(*LAMP, (p.FOV, fov), (p.GROUND_ROLL, roll)), 1, LAYER, WALL)
    wall = wall_at(document, 1)
    geometry = FrameGeometry.of(document, 1, None, CanvasView())
    half = wall.measures.width_px / 2
    left, right = (seen(geometry.camera, moved(wall.stand.origin, (side * half, wall.stand.u)))[0] for side in (-1, 1))
    assert left <= 0.5
    assert right >= 999.5
    reach = reach_on(sides_of(document, 1), wall.stand, 1e6)
    assert reach is not None
    assert reach.top < wall.measures.height_px
    assert max(reach.right, -reach.left) < half


def test_where_no_shadow_falls_on_it_a_wall_stands_behind_the_figure() -> None:
    toward = document_with((p.LIGHT_KIND, "sun"), (p.LIGHT_AZIMUTH, 180.0), (p.LIGHT_ELEVATION, 45.0))
    document, _ = add_placed(toward, 1, LAYER, WALL)
    x, y, _ = wall_at(document, 1).stand.origin
    assert x == 500
    assert 750 < y < 880


def test_only_a_new_wall_that_is_too_low_is_said() -> None:
    before = travelling(*LAMP)
    fitting, _ = add_placed(before, 1, LAYER, WALL)
    assert cut_notes(before, fitting) == ()
    low, _ = add_placed(before, 1, LAYER, replace(WALL, wanted={"height": 60.0}))
    assert [str(note) for note in cut_notes(before, low)] == [
        "Back: shadows reach over its upper edge at some time and are cut off"
    ]
    assert cut_notes(low, low) == ()
    away, _ = add_placed(before, 1, LAYER, replace(WALL, wanted={"present": False}))
    assert cut_notes(before, away) == ()


def test_a_second_wall_does_not_stand_in_the_first() -> None:
    document, _ = add_placed(document_with(*SUN), 1, LAYER, WALL)
    document, _ = add_placed(document, 1, LAYER, WALL)
    second = wall_at(document, 1)
    first = wall_at(replace(document, pieces=document.pieces[:1]), 1)
    assert abs(dot(between(first.stand.origin, second.stand.origin), first.stand.v)) > 50


def test_on_a_ground_line_that_is_nearly_upright_it_is_not_drawn_out_to_the_sides() -> None:
    document, _ = add_placed(document_with((p.GROUND_ROLL, 85.0)), 1, LAYER, WALL)
    assert wall_at(document, 1).measures.width_px < 20000
