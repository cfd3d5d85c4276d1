"""The first light: the shadow a new project shows lies wholly on the canvas, and real drawings stage without a word."""

from pathlib import Path

import numpy as np
import pytest

from kagezou.document import edits, invariants
from kagezou.document.address import Address
from kagezou.document.model import Canvas, Document
from kagezou.document.properties import FOV, GROUND_DECLINATION
from kagezou.geometry.box import Box
from kagezou.geometry.shadow import cast_on
from kagezou.importing.figures import figure_in
from kagezou.importing.staging import CharacterSource, new_document, with_characters
from kagezou.io.project.file import load, save
from kagezou.scene.evaluate import camera_at, ground_at, light_at
from kagezou.scene.figure_card import card_at
from tests.importing.cel_files import write_cel, write_walk

SAMPLE_SOURCES = (
    ("animdraw_duo_dance", 48),
    ("animdraw_duo_dance/A", 48),
    ("animdraw_duo_dance/B", 48),
    ("kenney_male_adventurer", 8),
    ("lottie_funky_chicken/A", 32),
    ("lottie_girl_jump", 34),
    ("lottie_girl_jump/A", 34),
    ("renpy_sylvie_blue", 4),
    ("synfig_prologue_kid/A", 60),
)


def shadow_box(document: Document) -> Box:
    """Return the box around the first drawings' shadows, every solid pixel followed to the ground."""
    camera, ground = camera_at(document, 1), ground_at(document, 1)
    fallen = []
    for layer in document.layers:
        (piece,) = card_at(document, layer, 1, camera, ground).pieces
        cast = cast_on(camera, ground, piece, light_at(document, 1, ground))
        figure = figure_in(layer.cels.drawings[0].path, document.canvas.box)
        assert cast is not None
        assert figure is not None
        rows, columns = np.nonzero(figure.solid)
        points = np.stack([columns + 0.5 + figure.offset[0], rows + 0.5 + figure.offset[1], np.ones(len(rows))])
        u, v, w = np.linalg.inv(cast.art_from_canvas) @ points
        assert (w > 0).all()
        fallen.append(np.stack([u / w, v / w]))
    points = np.concatenate(fallen, axis=1)
    low, high = np.floor(points.min(axis=1)).astype(int), np.ceil(points.max(axis=1)).astype(int)
    return Box(int(low[0]), int(low[1]), int(high[0]), int(high[1]))


@pytest.mark.parametrize("x", [40, 150, 240, 330])
def test_the_first_shadow_is_wholly_visible_beside_the_figure(x: int, tmp_path: Path) -> None:
    cel = write_cel(
        tmp_path / "hero.png", (400, 300), (x, 100, x + 40, 200), (x, 200, x + 8, 250), (x + 30, 200, x + 40, 250)
    )
    document = new_document([CharacterSource(None, cel)]).document
    fallen, figure = shadow_box(document), document.layers[0].figure
    assert fallen.left >= 0
    assert fallen.right <= 400
    assert fallen.top > figure.top
    assert fallen.bottom <= 251
    assert fallen.left < figure.left - 20 or fallen.right > figure.right + 20
    place = document.tracks["light.position"].constant
    assert isinstance(place, tuple)
    across, down, front = place
    assert isinstance(front, float)
    assert 0.5 * figure.height <= front <= 3 * figure.height
    assert isinstance(across, float)
    assert -20 <= across <= 420
    assert isinstance(down, float)
    assert -60 <= down <= 180


def test_the_lamp_is_placed_for_an_empty_project_as_it_is_seen(tmp_path: Path) -> None:
    walk = write_walk(tmp_path / "walk", [1, 2])
    empty = Document(Canvas(400, 300, length_frames=10))
    for line, value in ((FOV, 40.0), (GROUND_DECLINATION, 75.0)):
        empty = edits.set_constant(empty, Address(line), value)
    document = with_characters(empty, [CharacterSource("A", walk)]).document
    fallen = shadow_box(document)
    assert fallen.intersection(Box(0, 0, 400, 300)) == fallen
    assert document.canvas.length_frames == 10


def test_a_ground_seen_edge_on_still_has_a_lamp(tmp_path: Path) -> None:
    walk = write_walk(tmp_path / "walk", [1])
    empty = edits.set_constant(Document(Canvas(400, 300)), Address(GROUND_DECLINATION), 90.0)
    place = with_characters(empty, [CharacterSource("A", walk)]).document.tracks["light.position"].constant
    assert place == (171.0, -50.0, 150.0)


@pytest.mark.parametrize(("source", "length"), SAMPLE_SOURCES)
def test_every_sample_becomes_a_project(source: str, length: int, samples: Path, tmp_path: Path) -> None:
    result = new_document([CharacterSource("Hero", samples / source)])
    document = result.document
    invariants.check(document)
    assert document.canvas.length_frames == length
    assert all(layer.name.startswith("Hero") for layer in document.layers)
    for layer in document.layers:
        assert layer.figure.intersection(document.canvas.box) == layer.figure
    ground = document.tracks["ground.position"].constant
    assert isinstance(ground, tuple)
    assert ground[1] == max(layer.figure.bottom for layer in document.layers)
    fallen = shadow_box(document)
    if source != "renpy_sylvie_blue":  # cut off at the knees and as wide as its canvas: no shadow fits beside it
        assert fallen.intersection(document.canvas.box) == fallen
    save(document, tmp_path / "p.kage")
    assert load(tmp_path / "p.kage") == document
