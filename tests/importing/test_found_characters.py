"""What folders and files hold, told before any of it is taken."""

from pathlib import Path

import numpy as np
import pytest

from kagezou.errors import InputProblem
from kagezou.importing.found_characters import FoundCharacters, found_characters, whole_of
from kagezou.importing.new_cels import CharacterSource
from kagezou.importing.staging import new_document
from kagezou.importing.understood import numbers_text, understood
from kagezou.io.images.writing import write_rgba


def draw(folder: Path, *names: str) -> list[Path]:
    folder.mkdir(parents=True, exist_ok=True)
    for name in names:
        rgba = np.zeros((48, 64, 4), np.uint8)
        rgba[10:40, 20:40] = 255
        write_rgba(folder / f"{name}.png", rgba)
    return [folder / f"{name}.png" for name in names]


def rows(found: FoundCharacters) -> list[tuple[str, int, str, str, str]]:
    return [(each.name, each.count, each.numbers, each.first_name, each.last_name) for each in found.characters]


def test_one_character_of_a_folder_is_clear_and_called_like_it(tmp_path: Path) -> None:
    draw(tmp_path / "Hero", "walk_0001", "walk_0002", "walk_0004")
    found = found_characters([CharacterSource(None, tmp_path / "Hero")])
    assert found.is_clear
    assert rows(found) == [("Hero", 3, "1-2,4", "walk_0001.png", "walk_0004.png")]
    document = new_document(found.sources)
    assert [layer.name for layer in document.document.layers] == ["Hero"]
    assert [exposure.frame for exposure in document.document.layers[0].cels.exposures] == [1, 2, 4]
    assert list(map(str, understood(document.document))) == ["Hero: 3 drawings, 1-2,4, walk_0001.png … walk_0004.png"]


def test_several_characters_and_doubts_are_not_clear(tmp_path: Path) -> None:
    draw(tmp_path, "A0001", "A0002", "A0002_R1", "B0001", "layout")
    found = found_characters([CharacterSource(None, tmp_path)])
    assert not found.is_clear
    assert rows(found) == [("A", 2, "1-2", "A0001.png", "A0002_R1.png"), ("B", 1, "1", "B0001.png", "B0001.png")]
    assert list(map(str, found.characters[0].notes)) == ["the newest retake counts: A0002.png → A0002_R1.png"]
    assert [str(note) for note in found.notes] == [f"{tmp_path}: left out, as they have no number: layout.png"]
    brought = new_document(found.sources[:1]).document
    assert [drawing.path.name for drawing in brought.layers[0].cels.drawings] == ["A0001.png", "A0002_R1.png"]


def test_chosen_pictures_are_understood_together(tmp_path: Path) -> None:
    chosen = draw(tmp_path, "A_0001_col", "A_0002_col", "hero smile", "tree")
    draw(tmp_path, "A_0003_col")
    assert rows(found_characters([], chosen)) == [
        ("A", 2, "1-2", "A_0001_col.png", "A_0002_col.png"),
        ("hero smile", 1, "", "hero smile.png", "hero smile.png"),
        ("tree", 1, "", "tree.png", "tree.png"),
    ]


def test_of_one_numbered_picture_the_whole_sequence_comes(tmp_path: Path) -> None:
    first, *_others, still = draw(tmp_path, "A0001_v2", "A0002_v2", "A0003_v2", "tree")
    assert rows(whole_of(first)) == [("A", 3, "1-3", "A0001_v2.png", "A0003_v2.png")]
    assert rows(whole_of(still)) == [("tree", 1, "", "tree.png", "tree.png")]
    with pytest.raises(InputProblem, match="it does not exist"):
        whole_of(tmp_path / "none" / "A1.png")


@pytest.mark.parametrize(
    ("names", "text"),
    [
        (["1", "2", "3a"], "1-3"),
        (["-2", "-1"], "-2 … -1"),
        (["smile", "cry"], ""),
        ([], ""),
        ([str(2 * number) for number in range(90)], "0 … 178"),
    ],
)
def test_numbers_are_told_shortly(names: list[str], text: str) -> None:
    assert numbers_text(names) == text


def test_numbers_that_are_no_frames_are_exposed_one_after_the_other(tmp_path: Path) -> None:
    draw(tmp_path, "shot 1700000000123", "shot 1700000001456", "shot 1700009999999")
    made = new_document([CharacterSource("A", tmp_path)])
    assert [exposure.frame for exposure in made.document.layers[0].cels.exposures] == [1, 2, 3]
    assert any("too far apart to be frames" in str(note) for note in made.notes)
