"""A new wall spans the canvas, and shadows bend up it well: a good part lies on the ground, a good part on the wall."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from kagezou.document import properties as p
from kagezou.document import set_properties as s
from kagezou.document.address import Address, value_of
from kagezou.document.edits import add_layer, set_constant, set_key
from kagezou.document.figure_properties import POSITION
from kagezou.document.model import Cels, Document, Drawing, Exposure
from kagezou.geometry.box import Box
from kagezou.geometry.sets.measures import PieceKind
from kagezou.geometry.vectors import dot
from kagezou.scene.piece_frames import PieceFrame, piece_frame
from kagezou.tools.frame_geometry import FrameGeometry
from kagezou.tools.placing import NewPiece, add_placed
from kagezou.tools.shadow import tip_of
from kagezou.tools.sight import between
from kagezou.tools.view import CanvasView
from kagezou.tools.wall_fitting import reach_on, sides_of
from tests.tools.tool_scenes import LAYER, document_with

WALL = NewPiece(PieceKind.WALL, "Back")
SUN = ((p.LIGHT_KIND, "sun"), (p.LIGHT_AZIMUTH, -30.0), (p.LIGHT_ELEVATION, 45.0))
LAMP = ((p.LIGHT_POSITION, (200.0, -900.0, 2600.0)),)


def travelling(*settings: tuple[p.AnyProperty, object]) -> Document:
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
    light: tuple[tuple[p.AnyProperty, object], ...], fov: float
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
    from_world = geometry.camera.canvas_from_world()
    ends = []
    for side in (-0.5, 0.5):
        x, _, w = from_world @ (
            *(a + side * wall.measures.width_px * b for a, b in zip(wall.stand.origin, wall.stand.u, strict=True)),
            1.0,
        )
        ends.append(x / w)
    assert ends[0] <= 0.5
    assert ends[1] >= 999.5
    reach = reach_on(sides_of(document, 1), wall.stand, 1e6)
    assert reach is not None
    assert reach.top < wall.measures.height_px
    assert max(reach.right, -reach.left) < wall.measures.width_px / 2


def test_where_no_shadow_falls_on_it_a_wall_stands_behind_the_figure() -> None:
    toward = document_with((p.LIGHT_KIND, "sun"), (p.LIGHT_AZIMUTH, 180.0), (p.LIGHT_ELEVATION, 45.0))
    document, piece_id = add_placed(toward, 1, LAYER, WALL)
    x, y = value_of(document, Address(s.PIECE_POSITION, piece_id=piece_id), 1)
    assert x == 500
    assert 750 < y < 880


def test_a_second_wall_does_not_stand_in_the_first() -> None:
    document, _ = add_placed(document_with(*SUN), 1, LAYER, WALL)
    document, _ = add_placed(document, 1, LAYER, WALL)
    first, second = (
        value_of(document, Address(s.PIECE_POSITION, piece_id=piece.id), 1)[1] for piece in document.pieces
    )
    assert abs(first - second) > 20


def test_on_a_ground_that_is_nearly_upright_and_rolled_it_is_not_drawn_out() -> None:
    document, piece_id = add_placed(document_with((p.GROUND_ROLL, 85.0)), 1, LAYER, WALL)
    assert len(document.pieces) == 1
    assert value_of(document, Address(s.PIECE_WIDTH, piece_id=piece_id), 1) < 20000
