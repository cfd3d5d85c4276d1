"""Backgrounds of one picture and of many: what is seen when, how large the canvas is and how long the cut."""

from fractions import Fraction
from pathlib import Path

import pytest

from kagezou.document.address import Address
from kagezou.document.edits import set_canvas
from kagezou.document.figure_properties import BACKGROUND_POSITION
from kagezou.document.model import Canvas, Document, Exposure
from kagezou.errors import InputProblem
from kagezou.importing.background_pictures import background_of, laid_behind, with_background
from kagezou.importing.staging import CharacterSource, new_document
from tests.importing.cel_files import write_cel, write_walk

ALL = (0, 0, 8, 8)


def street(folder: Path, sizes: dict[int, tuple[int, int]]) -> Path:
    for number, size in sizes.items():
        write_cel(folder / f"street_{number:03}.png", size, (0, 0, *size))
    return folder


def test_one_picture_is_seen_for_the_whole_cut(tmp_path: Path) -> None:
    picture = write_cel(tmp_path / "bg_12.png", (500, 320), ALL)
    found = background_of(picture)
    assert found.cels.exposures == (Exposure(1, 0),)
    assert found.cels.drawings[0].path == picture, "its number is no sequence"
    assert (found.size_px, found.length_frames, found.notes) == ((500, 320), 1, ())


@pytest.mark.parametrize("pattern", [None, "street_#.png"])
def test_a_folder_or_a_pattern_is_exposed_as_its_numbers_say(tmp_path: Path, pattern: str | None) -> None:
    folder = street(tmp_path / "bg", {4: (90, 60), 5: (90, 60), 8: (120, 50)})
    found = background_of(folder if pattern is None else folder / pattern)
    assert [(each.frame, each.drawing) for each in found.cels.exposures] == [(1, 0), (2, 1), (5, 2)]
    assert (found.size_px, found.length_frames) == ((120, 60), 5)
    said = list(map(str, found.notes))
    assert any("missing 6-7; the drawing before is held" in note for note in said)
    assert any("drawings differ in size" in note for note in said)


def test_what_else_lies_in_the_folder_is_said(tmp_path: Path) -> None:
    street(tmp_path / "bg", {1: (90, 60), 2: (90, 60)})
    write_walk(tmp_path / "bg", [1, 2])
    (note,) = background_of(tmp_path / "bg").notes
    assert str(note).endswith("bg: the background is bg; left out: street")


def test_what_is_not_there_is_refused(tmp_path: Path) -> None:
    for name, said in (("none.png", "it does not exist"), ("none_#.png", "no file has such a name")):
        with pytest.raises(InputProblem, match=said):
            background_of(tmp_path / name)


def test_a_project_takes_its_size_and_is_at_least_as_long(tmp_path: Path) -> None:
    folder = street(tmp_path / "bg", dict.fromkeys(range(1, 31), (500, 320)))
    document = new_document([CharacterSource(None, write_walk(tmp_path / "walk", [1, 2]))], background=folder).document
    assert document.canvas == Canvas(500, 320, Fraction(24), 30)
    assert len(document.behind.drawings) == 30
    assert Address(BACKGROUND_POSITION).property.name not in document.tracks
    small = new_document([], background=folder, size=(64, 48)).document
    assert (small.canvas.width_px, small.canvas.length_frames) == (64, 30)


def test_a_document_keeps_its_size_and_its_length_when_there_is_something_to_see(tmp_path: Path) -> None:
    found = background_of(street(tmp_path / "bg", {1: (500, 320), 2: (500, 320)}))
    blank = Document(Canvas(64, 48, Fraction(12), 40))
    assert laid_behind(blank, found).canvas == Canvas(500, 320, Fraction(12), 40)
    assert with_background(blank, found).canvas == Canvas(64, 48, Fraction(12), 40)
    there = set_canvas(laid_behind(blank, found), Canvas(64, 48))
    assert laid_behind(there, found).canvas == Canvas(64, 48, Fraction(24), 2)
