"""Drawings that are looked for again, and other drawings for a layer."""

from pathlib import Path

import numpy as np
import pytest

from kagezou.document.edits import add_layer, set_exposures
from kagezou.document.layer_marks import LayerMarks
from kagezou.document.marking import set_marks
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure
from kagezou.document.paper import paper_of, set_paper
from kagezou.errors import InputProblem, UsageProblem
from kagezou.geometry.box import Box
from kagezou.importing.new_cels import CharacterSource
from kagezou.importing.relinking import found_again, missing_of, relinked
from kagezou.importing.replacing import replaced
from kagezou.importing.staging import Brought, brought
from kagezou.picture_source import Paper
from tests.importing.cel_files import write_cel

A = "layer-1"


def cut(folder: Path, names: tuple[str, ...]) -> Document:
    drawings = tuple(Drawing(Path(name).stem, folder / name, size_px=(40, 30)) for name in names)
    exposures = tuple(Exposure(1 + 2 * index, index) for index in range(len(names)))
    return add_layer(Document(Canvas(40, 30)), "A", Cels(drawings, exposures), Box(1, 1, 20, 20))


def test_files_are_found_by_name_in_any_case_and_form_below_a_folder(tmp_path: Path) -> None:
    document = cut(tmp_path / "old" / "A", ("A_01.png", "が.png", "A_03.png"))
    for name in ("A/a_01.PNG", "B/A_01.png", "deep/er/か\u3099.png"):
        write_cel(tmp_path / "new" / name, (40, 30), (5, 5, 20, 25))
    missing = missing_of(document, (A,))
    assert len(missing) == 3
    again = found_again(missing, tmp_path / "new")
    after, notes = relinked(document, (A,), again)
    paths = [drawing.path.relative_to(tmp_path).as_posix() for drawing in after.layers[0].cels.drawings]
    assert paths == ["new/A/a_01.PNG", "new/deep/er/か\u3099.png", "old/A/A_03.png"]
    assert [str(note) for note in notes] == [
        "2 of 3 missing files were found",
        f"{tmp_path / 'new'}: not there: A_03.png",
    ]
    assert missing_of(after, (A,)) == (tmp_path / "old" / "A" / "A_03.png",)


def test_where_none_is_found_nothing_is_changed_and_the_names_are_said(tmp_path: Path) -> None:
    missing = missing_of(cut(tmp_path / "old", ("1.png", "2.png")), (A,))
    (tmp_path / "new").mkdir()
    with pytest.raises(InputProblem, match=r"none of the missing drawings is there: 1\.png, 2\.png"):
        found_again(missing, tmp_path / "new")


def test_drawings_of_another_size_are_taken_and_said(tmp_path: Path) -> None:
    document = cut(tmp_path / "old", ("1.png", "2.png"))
    write_cel(tmp_path / "new" / "1.png", (80, 60), (5, 5, 20, 25))
    (tmp_path / "new" / "2.png").write_bytes(b"broken")
    after, notes = relinked(document, (A,), found_again(missing_of(document, (A,)), tmp_path / "new"))
    assert after.layers[0].cels.drawings[0].size_px == (80, 60)
    assert "another size than before: 1.png" in str(notes[-1])
    assert after.layers[0].cels.drawings[1].path == tmp_path / "new" / "2.png"


def test_layers_that_are_not_meant_stay(tmp_path: Path) -> None:
    document = cut(tmp_path / "old", ("1.png",))
    write_cel(tmp_path / "new" / "1.png", (40, 30), (5, 5, 20, 25))
    again = found_again(missing_of(document, (A,)), tmp_path / "new")
    assert relinked(document, (), again)[0] is document


def read(folder: Path, numbers: tuple[int, ...], size: tuple[int, int] = (40, 30)) -> Brought:
    for number in numbers:
        write_cel(folder / f"clean_{number:03}.png", size, (5, 5, 20, 25))
    return brought((CharacterSource(None, folder),), Canvas(40, 30))


def test_the_same_numbers_keep_their_exposures_in_any_order(tmp_path: Path) -> None:
    document = cut(tmp_path / "old", ("a3.png", "a1.png", "a2.png"))
    document = set_marks(set_paper(document, A, Paper.BORDER), (A,), lambda _: LayerMarks(label="red"))
    document = set_exposures(document, A, (Exposure(1, 0), Exposure(4, None), Exposure(5, 2)))
    after = replaced(document, A, read(tmp_path / "new", (1, 2, 3)))
    layer = after.document.layers[0]
    shown = [
        None if each.drawing is None else layer.cels.drawings[each.drawing].path.stem for each in layer.cels.exposures
    ]
    assert shown == ["clean_003", None, "clean_002"]
    assert layer.figure == Box(5, 5, 20, 25)
    assert paper_of(layer) is Paper.BORDER
    assert layer.marks.label == "red"
    assert after.layer_ids == (A,)


def test_as_many_drawings_of_other_numbers_take_each_others_places(tmp_path: Path) -> None:
    document = cut(tmp_path / "old", ("a1.png", "a2.png"))
    after = replaced(document, A, read(tmp_path / "new", (11, 12)))
    assert after.document.layers[0].cels.exposures == document.layers[0].cels.exposures


def test_other_drawings_are_exposed_by_their_numbers_and_that_is_said(tmp_path: Path) -> None:
    document = cut(tmp_path / "old", ("a1.png", "a2.png"))
    after = replaced(document, A, read(tmp_path / "new", (4, 5, 6)))
    assert [exposure.drawing for exposure in after.document.layers[0].cels.exposures] == [0, 1, 2]
    assert "these are other drawings" in " ".join(str(note) for note in after.notes)
    assert after.document.canvas.length_frames >= after.document.layers[0].cels.exposures[-1].frame


def test_of_several_characters_the_first_counts_and_without_one_nothing_happens(tmp_path: Path) -> None:
    document = cut(tmp_path / "old", ("a1.png",))
    two = read(tmp_path / "new", (1,)), read(tmp_path / "other", (1,))
    both = Brought((*two[0].characters, *two[1].characters), (*two[0].figures_seen, *two[1].figures_seen), ())
    after = replaced(document, A, both)
    assert "a layer holds one character" in " ".join(str(note) for note in after.notes)
    with pytest.raises(UsageProblem, match="no drawings"):
        replaced(document, A, Brought((), (), ()))
    assert isinstance(both.figures_seen[0].later, np.ndarray)
