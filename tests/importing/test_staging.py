"""Staging: from folders of drawings to a document with a good shadow."""

from fractions import Fraction
from pathlib import Path

import pytest

from kagezou.document import edits, invariants
from kagezou.document.address import Address
from kagezou.document.model import Canvas, Document, Exposure
from kagezou.document.properties import GROUND_POSITION, LIGHT_POSITION
from kagezou.errors import InputProblem, UsageProblem
from kagezou.geometry.box import Box
from kagezou.importing.staging import CharacterSource, Imported, new_document, with_characters
from tests.importing.cel_files import write_cel, write_walk


def imported(*paths: Path, name: str | None = None, size: tuple[int, int] | None = None) -> Imported:
    result = new_document([CharacterSource(name, path) for path in paths], size=size)
    invariants.check(result.document)
    return result


# ---- cels and time


def test_a_sequence_becomes_one_exposure_a_drawing_from_frame_one(tmp_path: Path) -> None:
    document = imported(write_walk(tmp_path / "walk", [5, 6, 7])).document
    (layer,) = document.layers
    assert layer.name == "walk"
    assert [drawing.name for drawing in layer.cels.drawings] == ["5", "6", "7"]
    assert layer.cels.exposures == (Exposure(1, 0), Exposure(2, 1), Exposure(3, 2))
    assert document.canvas == Canvas(400, 300, Fraction(24), 3)


def test_a_gap_holds_the_drawing_before_and_is_told(tmp_path: Path) -> None:
    result = imported(write_walk(tmp_path / "walk", [1, 2, 5, 8]))
    (layer,) = result.document.layers
    assert [exposure.frame for exposure in layer.cels.exposures] == [1, 2, 5, 8]
    assert layer.cels.drawing_at(4) == layer.cels.drawings[1]
    assert "walk: missing 3-4,6-7; the drawing before is held" in map(str, result.notes)


def test_an_inserted_drawing_takes_a_frame_of_its_own(tmp_path: Path) -> None:
    for name in ("A1", "A2", "A2a", "A3"):
        write_cel(tmp_path / f"{name}.png", (40, 40), (10, 10, 20, 30))
    (layer,) = imported(tmp_path, name="A").document.layers
    assert [drawing.name for drawing in layer.cels.drawings] == ["1", "2", "2a", "3"]
    assert [exposure.frame for exposure in layer.cels.exposures] == [1, 2, 3, 4]


def test_a_still_is_held_over_the_cut(tmp_path: Path) -> None:
    still = write_cel(tmp_path / "hero.png", (60, 80), (20, 10, 40, 70))
    document = imported(still).document
    (layer,) = document.layers
    assert (layer.name, layer.cels.drawings[0].name) == ("hero", "hero")
    assert layer.cels.exposures == (Exposure(1, 0),)
    assert document.canvas.length_frames == 24
    assert layer.cels.drawing_at(24) == layer.cels.drawings[0]


def test_the_cut_is_as_long_as_the_longest_sequence(tmp_path: Path) -> None:
    still = write_cel(tmp_path / "prop.png", (60, 80), (20, 10, 40, 70))
    walk, run = write_walk(tmp_path / "walk", [1, 2, 3]), write_walk(tmp_path / "run", [1, 2, 3, 4, 5])
    assert imported(walk, run, still).document.canvas.length_frames == 5


def test_several_sequences_become_layers_of_the_source(tmp_path: Path) -> None:
    write_walk(tmp_path / "hero/A", [1])
    write_walk(tmp_path / "hero/B", [1])
    assert [layer.name for layer in imported(tmp_path / "hero", name="Hero").document.layers] == ["Hero A", "Hero B"]
    assert [layer.name for layer in imported(tmp_path / "hero").document.layers] == ["A", "B"]
    assert [layer.name for layer in imported(tmp_path / "hero/A", name="Hero").document.layers] == ["Hero"]


def test_a_pattern_names_the_layer_after_its_sequence(tmp_path: Path) -> None:
    write_walk(tmp_path / "walk", [1, 2])
    assert imported(tmp_path / "walk/walk_#.png").document.layers[0].name == "walk"


def test_names_of_files_become_names_of_layers(tmp_path: Path) -> None:
    folder = tmp_path / "odd\nname"
    write_walk(folder, [1])
    document = imported(folder, folder).document
    assert [layer.name for layer in document.layers] == ["odd_name", "odd_name 2"]


def test_left_out_pictures_are_told(tmp_path: Path) -> None:
    write_walk(tmp_path / "walk", [1, 2])
    for name in ("colors", "model", "notes", "zip"):
        write_cel(tmp_path / "walk" / f"{name}.png", (4, 4))
    (note,) = map(str, imported(tmp_path / "walk").notes)
    assert note.endswith("walk: left out, as they have no number: colors.png, model.png, notes.png, …")


def test_odd_sizes_are_told_and_the_canvas_holds_the_largest(tmp_path: Path) -> None:
    write_walk(tmp_path / "walk", [1, 2])
    write_cel(tmp_path / "walk/walk_0003.png", (420, 280), (200, 100, 240, 250))
    result = imported(tmp_path / "walk")
    assert (result.document.canvas.width_px, result.document.canvas.height_px) == (420, 300)
    assert any(
        "walk: drawings differ in size, first" in note and "420 × 280 px" in note for note in map(str, result.notes)
    )


def test_paths_are_absolute(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write_walk(tmp_path / "walk", [1])
    write_cel(tmp_path / "bg.png", (500, 320))
    monkeypatch.chdir(tmp_path)
    document = new_document([CharacterSource(None, Path("walk"))], background=Path("bg.png")).document
    assert document.layers[0].cels.drawings[0].path == tmp_path / "walk/walk_0001.png"
    assert document.background == tmp_path / "bg.png"
    assert (document.canvas.width_px, document.canvas.height_px) == (500, 320)


# ---- figure and ground


def test_figure_and_ground_come_from_the_first_drawing_centred_on_the_canvas(tmp_path: Path) -> None:
    write_cel(tmp_path / "A/1.png", (40, 60), (10, 5, 30, 40), (12, 40, 16, 51))
    write_cel(tmp_path / "A/2.png", (40, 60), (0, 0, 40, 60))
    document = imported(tmp_path / "A", size=(101, 99)).document
    assert document.layers[0].figure == Box(30 + 10, 19 + 5, 30 + 30, 19 + 51)
    assert document.tracks["ground.position"].constant == (30 + 14.0, 19 + 51.0)


def test_the_ground_lies_under_the_lowest_of_all_characters(tmp_path: Path) -> None:
    high = write_cel(tmp_path / "high.png", (200, 200), (20, 20, 40, 100))
    low = write_cel(tmp_path / "low.png", (200, 200), (120, 20, 140, 150))
    for order in ((high, low), (low, high)):
        assert imported(*order).document.tracks["ground.position"].constant == (130.0, 150.0)


def test_an_empty_first_drawing_lets_the_next_one_speak(tmp_path: Path) -> None:
    write_cel(tmp_path / "A/1.png", (40, 60))
    write_cel(tmp_path / "A/2.png", (40, 60), (10, 5, 30, 40))
    assert imported(tmp_path / "A").document.layers[0].figure == Box(10, 5, 30, 40)


def test_a_character_of_empty_drawings_takes_the_whole_canvas_and_says_so(tmp_path: Path) -> None:
    write_cel(tmp_path / "A/1.png", (40, 60))
    result = imported(tmp_path / "A")
    assert result.document.layers[0].figure == Box(0, 0, 40, 60)
    assert result.document.tracks["ground.position"].constant == (20.0, 60.0)
    assert tuple(map(str, result.notes)) == (
        "A: there is nothing solid in its drawings; the whole canvas was taken as the figure",
    )


def test_a_figure_that_reaches_the_lower_edge_is_told(tmp_path: Path) -> None:
    cut = write_cel(tmp_path / "bust.png", (100, 100), (20, 10, 80, 100))
    result = imported(cut)
    assert result.document.tracks["ground.position"].constant == (50.0, 100.0)
    assert any(
        note.startswith("bust: the figure reaches the lower edge of its drawing") for note in map(str, result.notes)
    )


def test_a_drawing_over_the_canvas_is_told(tmp_path: Path) -> None:
    big = write_cel(tmp_path / "big.png", (100, 100), (20, 10, 80, 90))
    assert "big: its drawings of 100 × 100 px reach over the canvas of 80 × 60 px" in map(
        str, imported(big, size=(80, 60)).notes
    )


# ---- more characters


def test_later_characters_leave_ground_lamp_and_length_alone(tmp_path: Path) -> None:
    first = imported(write_walk(tmp_path / "walk", [1, 2])).document
    moved = edits.set_constant(first, Address(LIGHT_POSITION), (1.0, 2.0, 3.0))
    moved = edits.set_constant(moved, Address(GROUND_POSITION), (4.0, 5.0))
    result = with_characters(moved, [CharacterSource("B", write_walk(tmp_path / "run", [1, 2, 3]))])
    invariants.check(result.document)
    assert result.document.tracks == moved.tracks
    assert result.layer_ids == ("layer-2",)
    assert result.document.canvas.length_frames == 3
    assert result.document.layers[0] is moved.layers[0]


# ---- faults


def test_what_cannot_be_found_is_one_sentence(tmp_path: Path) -> None:
    with pytest.raises(InputProblem, match=r"nobody: it does not exist"):
        imported(tmp_path / "nobody")
    with pytest.raises(InputProblem, match=r"bg\.png: it does not exist"):
        new_document([], background=tmp_path / "bg.png")
    with pytest.raises(UsageProblem, match="a layer cannot be named"):
        imported(write_walk(tmp_path / "walk", [1]), name="a\nb")


def test_a_broken_drawing_is_told_and_the_others_are_used(tmp_path: Path) -> None:
    write_walk(tmp_path / "walk", [1, 2, 3, 4, 5, 6, 7])
    (tmp_path / "walk/walk_0001.png").write_bytes(b"")
    for number in (3, 4, 5):
        (tmp_path / f"walk/walk_{number:04}.png").write_bytes(b"<html>")
    result = imported(tmp_path / "walk")
    assert len(result.document.layers[0].cels.drawings) == 7
    assert result.document.layers[0].figure.left == 152
    assert sum("walk_0001.png: the file is empty" in note for note in map(str, result.notes)) == 1
    assert "walk: 4 drawings cannot be opened" in map(str, result.notes)


def test_a_drawing_cut_short_is_told_once(tmp_path: Path) -> None:
    write_walk(tmp_path / "walk", [1, 2])
    path = tmp_path / "walk/walk_0001.png"
    path.write_bytes(path.read_bytes()[:-20])
    result = imported(tmp_path / "walk")
    assert [note for note in map(str, result.notes) if "walk_0001.png" in note] == [f"{path}: the file is cut short"]


def test_a_character_of_broken_drawings_is_refused(tmp_path: Path) -> None:
    (tmp_path / "A_1.png").write_bytes(b"")
    with pytest.raises(InputProblem, match=r"A_1\.png: the file is empty"):
        imported(tmp_path)


def test_pictures_larger_than_a_canvas_ask_for_a_size(tmp_path: Path) -> None:
    wide = write_cel(tmp_path / "wide.png", (16385, 2), (0, 0, 4, 1))
    with pytest.raises(InputProblem, match="16385 × 2 px, as the pictures have it, is larger than 16384 px"):
        imported(wide)
    assert imported(wide, size=(100, 50)).document.canvas.width_px == 100


def test_no_characters_make_an_empty_canvas() -> None:
    result = new_document([], frame_rate=Fraction(25))
    assert result == Imported(Document(Canvas(1920, 1080, Fraction(25))), (), ())
