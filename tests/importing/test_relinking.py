"""Drawings that are looked for again."""

from pathlib import Path

import pytest

from kagezou.document.edits import add_layer
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure
from kagezou.errors import InputProblem
from kagezou.geometry.box import Box
from kagezou.importing.relinking import found_again, missing_of, relinked
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
