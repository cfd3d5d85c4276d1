"""The first light over the whole cut: where a figure travels its shadow keeps its direction."""

from math import atan2, degrees
from pathlib import Path

import pytest

from kagezou.document.address import resolve
from kagezou.document.edits import set_constant, set_key
from kagezou.document.model import Document
from kagezou.document.properties import LIGHT_KIND, LIGHT_POSITION
from kagezou.document.values import value_at
from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera
from kagezou.geometry.ground import ground_plane
from kagezou.geometry.light import lamp, sun
from kagezou.importing.lighting import relit, turning_note
from kagezou.importing.staging import CharacterSource, new_document
from kagezou.importing.travel import Station, stations, turn_of_shadows
from kagezou.scene.evaluate import camera_at, evaluate, ground_at, light_at
from tests.importing.cel_files import write_cel

SIZE = (900, 400)


def walk(folder: Path, lefts: list[int], rows: list[int] | None = None) -> Path:
    """Write drawings of a figure 40 px wide and 150 px high whose legs go, at some columns and ground rows."""
    for number, left in enumerate(lefts, 1):
        bottom = (rows or [350] * len(lefts))[number - 1]
        stride = 6 * (number % 2)
        parts = (
            (left, bottom - 150, left + 40, bottom - 50),
            (left - stride, bottom - 50, left + 10 - stride, bottom),
            (left + 30 + stride, bottom - 50, left + 40 + stride, bottom),
        )
        write_cel(folder / f"{folder.name}_{number:04}.png", SIZE, *parts)
    return folder


def new(source: Path) -> Document:
    return new_document([CharacterSource("A", source)]).document


def kind(document: Document) -> str:
    return value_at(document.tracks, LIGHT_KIND, 1)


def test_a_walk_across_the_canvas_is_lit_by_the_sun(tmp_path: Path) -> None:
    lefts = [40 + 35 * step for step in range(23)]
    document = new(walk(tmp_path / "walk", lefts))
    assert kind(document) == "sun"
    scene = evaluate(document, 1)
    assert scene.layers[0].cast is not None
    (light,) = scene.layers[0].cast.lights
    way = [Station(left + 20, 350, 200) for left in lefts]
    assert turn_of_shadows(scene.camera, scene.ground, light, [way]) < 1e-6
    beside = lamp(value_at(document.tracks, LIGHT_POSITION, 1))
    assert turn_of_shadows(scene.camera, scene.ground, beside, [way]) > 20


def test_the_sun_s_shadow_lies_on_the_canvas_behind_and_beside_the_figure_over_the_whole_cut(tmp_path: Path) -> None:
    lefts = [200 + 22 * step for step in range(23)]
    document = new(walk(tmp_path / "walk", lefts))
    assert kind(document) == "sun"
    ground = evaluate(document, 1).ground
    cast = evaluate(document, 1).layers[0].cast
    assert cast is not None
    way = [Station(left + 20, 350, 200) for left in lefts]
    for station in way:
        head = (station.x, 200.0, 0.0)
        x, y, z, _ = cast.lights[0]
        rise = sum(a * b for a, b in zip((x, y, z), ground.normal, strict=True))
        height = sum(a * b for a, b in zip(head, ground.normal, strict=True)) + ground.equation[3]
        tip = tuple(p - height / rise * q for p, q in zip(head, (x, y, z), strict=True))
        assert 0 < tip[0] < SIZE[0]
        assert 0 < tip[1] < 345
        assert abs(tip[0] - station.x) > 40


@pytest.mark.parametrize("lefts", [[400] * 12, [400 + step % 3 for step in range(12)]])
def test_a_figure_that_stays_has_a_lamp(lefts: list[int], tmp_path: Path) -> None:
    assert kind(new(walk(tmp_path / "walk", lefts))) == "point"


def test_layers_that_are_moved_across_the_canvas_get_the_sun_while_the_first_lamp_is_untouched(tmp_path: Path) -> None:
    document = new(walk(tmp_path / "walk", [430, 430, 430, 430]))
    assert kind(document) == "point"
    position = resolve(document, "layers.A.position")
    moved = set_key(set_key(document, position, 1, (100.0, 200.0)), position, 4, (800.0, 200.0))
    lit, said = relit(moved)
    assert kind(lit) == "sun"
    assert len(said) == 1
    way = [Station(100 + 700 / 3 * step, 350, 200) for step in range(4)]
    light = light_at(lit, 1, ground_at(lit, 1))
    assert turn_of_shadows(camera_at(lit, 1), ground_at(lit, 1), light, [way]) < 20
    first = light_at(moved, 1, ground_at(moved, 1))
    assert turn_of_shadows(camera_at(moved, 1), ground_at(moved, 1), first, [way]) > 20
    touched = set_constant(moved, resolve(document, "light.position"), (400.0, -100.0, 300.0))
    assert relit(document) == (document, ())
    assert relit(touched) == (touched, ())
    little = set_key(set_key(document, position, 1, (450.0, 200.0)), position, 4, (455.0, 200.0))
    assert relit(little) == (little, ())


def test_a_lamp_somebody_set_stays_and_what_it_does_to_a_travelling_figure_is_said_once(tmp_path: Path) -> None:
    document = new(walk(tmp_path / "walk", [430, 430, 430, 430]))
    position = resolve(document, "layers.A.position")
    touched = set_constant(document, resolve(document, "light.position"), (400.0, -100.0, 300.0))
    moved = set_key(set_key(touched, position, 1, (100.0, 200.0)), position, 4, (800.0, 200.0))
    assert "turns round" in str(turning_note(touched, moved))
    farther = set_key(moved, position, 4, (810.0, 200.0))
    assert turning_note(moved, farther) is None
    assert turning_note(moved, set_constant(moved, resolve(moved, "layers.A.shadow.opacity"), 0.5)) is None
    sunny = set_constant(touched, resolve(touched, "light.kind"), "sun")
    assert turning_note(sunny, set_key(sunny, position, 4, (810.0, 200.0))) is None
    on_its_way = set_key(moved, resolve(moved, "light.position"), 4, (900.0, -100.0, 300.0))
    assert turning_note(touched, on_its_way) is None


def test_a_jump_keeps_its_ground_and_a_way_into_the_depth_does_not() -> None:
    boxes = [Box(0, 0, 40, bottom) for bottom in (300, 220, 180, 250, 300)]
    assert [each.ground_row for each in stations(boxes)] == [300] * 5
    away = [Box(0, 0, 40, bottom) for bottom in (300, 280, 260, 240)]
    assert [each.ground_row for each in stations(away, below_px=5)] == [305, 285, 265, 245]
    assert stations([Box(10, 50, 20, 60)], above_px=20)[0] == Station(15, 60, 30)


def test_what_turns_is_measured() -> None:
    camera, ground = Camera(1000, 1000), ground_plane((0.0, 900.0), 0.0, 60.0)
    way = [Station(x, 900, 700) for x in (300.0, 500.0, 700.0)]
    near = lamp((500.0, 400.0, 600.0))
    assert turn_of_shadows(camera, ground, near, [way[:1]]) == 0
    # From (300, 900) to the head's shadow at (238.1, 792.8), and to the other side as far from (700, 900).
    assert turn_of_shadows(camera, ground, near, [way]) == pytest.approx(2 * degrees(atan2(61.9, 107.2)), abs=0.1)
    assert turn_of_shadows(camera, ground, near, []) == 0
    assert turn_of_shadows(camera, ground, sun(ground, 40.0, 50.0), [way]) < 1e-9
    assert turn_of_shadows(camera, ground, lamp((500.0, 750.0, 10.0)), [way]) == 360
