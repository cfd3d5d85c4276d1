"""Two characters whose feet stand on different rows each start on their own; who comes into a set stands as it does."""

from pathlib import Path

import numpy as np
import pytest

from kagezou.document.address import resolve, value_of
from kagezou.document.model import Document
from kagezou.document.properties import GROUND_POSITION
from kagezou.document.set_pieces import add_piece
from kagezou.document.values import value_at
from kagezou.geometry.camera import project
from kagezou.geometry.shadow import cast_card
from kagezou.importing.feet import document_with_feet
from kagezou.importing.staging import CharacterSource, new_document, with_characters
from kagezou.scene.evaluate import evaluate
from tests.importing.cel_files import write_cel

SIZE = (640, 480)


def figure(path: Path, left: int, bottom: int) -> Path:
    """Write a figure 60 px wide and 200 px high on two legs."""
    body = (left, bottom - 200, left + 60, bottom - 90)
    legs = [(x, bottom - 90, x + 14, bottom) for x in (left + 4, left + 42)]
    return write_cel(path, SIZE, body, *legs)


@pytest.fixture
def duo(tmp_path: Path) -> Document:
    sources = [
        CharacterSource("front", figure(tmp_path / "front.png", 120, 440)),
        CharacterSource("back", figure(tmp_path / "back.png", 420, 360)),
    ]
    document = new_document(sources).document
    return document_with_feet(document, [layer.id for layer in document.layers]).document


def test_each_of_two_figures_stands_on_its_own_feet_and_meets_its_shadow_there(duo: Document) -> None:
    assert value_at(duo.tracks, GROUND_POSITION, 1)[1] == 440
    scene = evaluate(duo, 1)
    for layer, row, columns in zip(scene.layers, (440, 360), ((131, 169), (431, 469)), strict=True):
        assert layer.cast is not None
        seen = [project(scene.camera.canvas_from_world(), (*place, 1.0)) for place in layer.card.contacts]
        assert [y for _, y in seen] == pytest.approx([row] * len(seen), abs=1)
        for x in columns:
            foot = (float(x), float(row))
            shadows = []
            for piece, cast in zip(
                layer.card.pieces,
                cast_card(scene.camera, scene.ground, layer.card, layer.cast.lights[0]),
                strict=True,
            ):
                if piece.room_at(foot) >= -1e-6:
                    shadows.append(project(np.asarray(np.linalg.inv(cast.art_from_canvas), np.float64), foot))
            assert shadows
            for shadow in shadows:
                assert shadow == pytest.approx(foot, abs=1)


def test_who_comes_into_a_set_stands_up_and_those_that_are_there_stay(duo: Document, tmp_path: Path) -> None:
    walled = add_piece(duo, "Back", "wall")
    more = with_characters(walled, [CharacterSource("late", figure(tmp_path / "late.png", 300, 400))])
    upright = [
        value_of(more.document, resolve(more.document, f"layers.{name}.upright"), 1) for name in ("front", "late")
    ]
    assert upright == [0, 1]
    assert "late: standing upright now, as the set does" in [str(note) for note in more.notes]
