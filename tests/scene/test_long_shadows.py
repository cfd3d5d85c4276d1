"""Long shadows: those of the style for the evening stay on the picture, and what leaves it is told."""

from itertools import product
from pathlib import Path

import pytest

from kagezou.document.edits import set_background
from kagezou.document.model import Document
from kagezou.io.clips.style_files import bundled_styles
from kagezou.scene.misfits import Misfit, MisfitKind, misfits_at
from tests.scene.jumps import jumping, with_values

SUN = {"light.kind": "sun"}


def leaving(document: Document, frame: int = 1) -> list[Misfit]:
    return [each for each in misfits_at(document, frame) if each.kind is MisfitKind.LEAVES]


def lit(azimuth: float, elevation: float, **values: object) -> Document:
    return with_values(jumping(), SUN | {"light.azimuth": azimuth, "light.elevation": elevation} | values)


def test_the_evening_keeps_the_head_of_a_usual_figure_on_the_picture_through_a_jump() -> None:
    evening = next(each.style for each in bundled_styles() if each.style.name.en == "Long evening")
    document = with_values(jumping(), dict(evening.scene))
    assert evening.scene.keys() == {"light.kind", "light.azimuth", "light.elevation"}
    assert [frame for frame in range(1, document.canvas.length_frames + 1) if leaving(document, frame)] == []


def test_a_head_beside_the_picture_is_told_with_the_nearest_sun_that_keeps_it() -> None:
    (told,) = leaving(lit(-62.0, 20.0))
    words = str(told.message)
    assert words.startswith("the head of A's long shadow falls beside the picture on frame 1: light.azimuth = ")
    azimuth, elevation = (float(words.split(name)[1].split()[0]) for name in ("azimuth = ", "elevation = "))
    assert leaving(lit(azimuth, elevation)) == []
    nearer = [
        (a, e)
        for a, e in product(range(-75, 76, 5), range(15, 35, 5))
        if abs(a + 62) + 2 * abs(e - 20) < abs(azimuth + 62) + 2 * abs(elevation - 20)
    ]
    assert all(leaving(lit(float(a), float(e))) for a, e in nearer)


def test_where_no_sun_keeps_it_that_is_told() -> None:
    (told,) = leaving(lit(-62.0, 20.0, position=[5000.0, 500.0]))
    assert str(told.message).endswith("as it does under any sun")


@pytest.mark.parametrize(
    "values",
    [
        {"light.elevation": 40.0},
        {"light.elevation": -5.0},
        {"shadow.shape": "disc"},
        {"light.kind": "point", "light.position": [-20000.0, 300.0, 4000.0]},
    ],
    ids=["a high sun", "after sunset", "a disc", "a lamp"],
)
def test_others_are_not_asked(values: dict[str, object]) -> None:
    assert leaving(with_values(lit(-62.0, 20.0), values)) == []


def climbing(document: Document) -> list[Misfit]:
    return [each for each in misfits_at(document, 1) if each.kind is MisfitKind.CLIMBS]


def on_a_painting(azimuth: float, elevation: float, **values: object) -> Document:
    return set_background(lit(azimuth, elevation, **values), Path("/nowhere/park.png"))


def test_a_shadow_that_runs_up_a_painting_is_told_and_perspective_lays_it_down() -> None:
    (told,) = climbing(on_a_painting(0.0, 18.0))
    assert str(told.message).startswith("A's long shadow runs up the background on frame 1, for without perspective")
    assert climbing(on_a_painting(0.0, 18.0, **{"camera.fov": 40.0})) == []


@pytest.mark.parametrize(
    "document",
    [
        lit(0.0, 18.0),
        on_a_painting(0.0, 60.0),
        on_a_painting(180.0, 18.0),
        on_a_painting(0.0, 18.0, **{"shadow.shape": "disc"}),
    ],
    ids=["no background", "a high sun", "toward the viewer", "a disc"],
)
def test_other_shadows_do_not_climb(document: Document) -> None:
    assert climbing(document) == []
