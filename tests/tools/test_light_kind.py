"""Lamp or sun: the shadow's tip stays where it is when the kind of light changes."""

from itertools import pairwise

import pytest

from kagezou.animation.track import Interpolation
from kagezou.document import properties as p
from kagezou.document.address import Address, track_of
from kagezou.document.edits import set_constant, set_key
from kagezou.document.invariants import check
from kagezou.document.model import Document
from kagezou.geometry.ground import ground_plane
from kagezou.geometry.light import sun, sun_angles
from kagezou.tools.frame_geometry import FrameGeometry
from kagezou.tools.light_kind import with_light_kind
from kagezou.tools.shadow import tip_of
from kagezou.tools.view import CanvasView
from tests.tools.tool_scenes import document_with

KIND, POSITION = Address(p.LIGHT_KIND), Address(p.LIGHT_POSITION)
AZIMUTH, ELEVATION = Address(p.LIGHT_AZIMUTH), Address(p.LIGHT_ELEVATION)
LAMP = (p.LIGHT_POSITION, (100.0, -300.0, 700.0))


def tip(document: Document, frame: int = 1) -> tuple[float, ...]:
    found = tip_of(FrameGeometry.of(document, frame, "layer-1", CanvasView()))
    assert found is not None
    return found


def switched(document: Document, kind: str, frame: int = 1) -> Document:
    changed = with_light_kind(document, "layer-1", frame, kind)
    check(changed)
    return changed


@pytest.mark.parametrize("fov", [0.0, 40.0])
def test_the_tip_stays_and_the_lamp_comes_back_as_it_was(fov: float) -> None:
    lamp = document_with(LAMP, (p.FOV, fov), (p.GROUND_ROLL, 10.0))
    sunny = switched(lamp, "sun")
    assert FrameGeometry.of(sunny, 1, "layer-1", CanvasView()).is_sun
    assert tip(sunny) == pytest.approx(tip(lamp), abs=0.01)
    again = switched(sunny, "point")
    assert track_of(again, POSITION) == track_of(lamp, POSITION)
    assert tip(again) == tip(lamp)


def test_a_sun_that_was_turned_becomes_a_far_lamp_with_the_same_tip() -> None:
    sunny = document_with(LAMP, (p.LIGHT_KIND, "sun"), (p.LIGHT_AZIMUTH, -50.0), (p.LIGHT_ELEVATION, 30.0))
    lamp = switched(sunny, "point")
    assert tip(lamp) == pytest.approx(tip(sunny), abs=0.01)
    assert track_of(lamp, POSITION) != track_of(sunny, POSITION)
    assert switched(lamp, "point") is lamp


def test_a_lamp_that_moves_becomes_a_sun_that_moves_the_short_way() -> None:
    document = document_with()
    # Behind the figure, where the azimuth goes through half a turn.
    for frame, x in ((1, -300.0), (12, 450.0), (24, 1200.0)):
        document = set_key(document, POSITION, frame, (x, -2000.0, -2000.0), Interpolation.BEZIER)
    sunny = switched(document, "sun", 12)
    keys = track_of(sunny, AZIMUTH).keys
    assert [key.frame for key in keys] == [1, 12, 24]
    assert {key.interpolation for key in keys} == {Interpolation.BEZIER}
    for frame in (1, 12, 24):
        assert tip(sunny, frame) == pytest.approx(tip(document, frame), abs=0.01)
    turns = [key.value for key in keys if isinstance(key.value, float)]
    assert len(turns) == 3
    assert all(abs(after - before) < 180 for before, after in pairwise(turns))


def test_where_the_kind_is_keyed_only_that_frame_is_taken_over() -> None:
    document = set_key(document_with(LAMP), KIND, 1, "point")
    document = set_key(set_constant(document, AZIMUTH, 80.0), ELEVATION, 1, 20.0)
    sunny = switched(document, "sun", 12)
    assert [key.frame for key in track_of(sunny, KIND).keys] == [1, 12]
    assert [key.frame for key in track_of(sunny, ELEVATION).keys] == [1, 12]
    assert not track_of(sunny, AZIMUTH).is_keyed
    assert tip(sunny, 12) == pytest.approx(tip(document, 12), abs=0.01)


def test_angles_are_the_way_back_of_the_sun() -> None:
    ground = ground_plane((500.0, 900.0), 12.0, 70.0)
    x, y, z, _ = sun(ground, -133.0, 21.0)
    assert sun_angles(ground, (3 * x, 3 * y, 3 * z)) == pytest.approx((-133.0, 21.0))
    nx, ny, nz = ground.normal
    assert sun_angles(ground, (nx, ny, nz))[1] == pytest.approx(90.0)


def test_without_a_figure_the_light_falls_on_where_it_would_stand() -> None:
    document = document_with(LAMP)
    sunny = with_light_kind(document, None, 1, "sun")
    assert FrameGeometry.of(sunny, 1, None, CanvasView()).is_sun
    elevation = track_of(sunny, ELEVATION).constant
    assert isinstance(elevation, float)
    assert 0 < elevation < 90
