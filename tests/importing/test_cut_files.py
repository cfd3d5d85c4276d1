"""Which files make a cut, by how studios lay them out."""

from collections.abc import Iterable
from pathlib import Path

import pytest

from kagezou.errors import InputProblem
from kagezou.importing.cut_files import cut_files, document_of_cut
from kagezou.importing.cut_listing import is_column_name
from kagezou.importing.new_cels import CharacterSource
from tests.batch.cut_folders import drawings, picture, timesheet


def names(sources: Iterable[CharacterSource]) -> list[str | None]:
    return [source.name for source in sources]


@pytest.mark.parametrize("name", ["A", "b2", "Ａ", "セルA", "cel_A", "c012_A", "A_R1", "C", "A_修正"])
def test_columns_by_name(name: str) -> None:
    assert is_column_name(name)


@pytest.mark.parametrize("name", ["c012", "c_012", "hero", "walk_01", "12", "cut1", "", "old drawings"])
def test_what_is_no_column(name: str) -> None:
    assert not is_column_name(name)


def test_columns_from_the_lowest_up_with_the_background(tmp_path: Path) -> None:
    for column in ("B", "A"):
        drawings(tmp_path / "c1" / column)
    picture(tmp_path / "c1" / "BG.png", fill=True)
    found = cut_files(tmp_path / "c1")
    assert names(found.sources) == ["A", "B"]
    assert found.background == tmp_path / "c1" / "BG.png"
    assert found.notes == ()


def test_what_is_no_column_beside_columns_is_left_out_and_said(tmp_path: Path) -> None:
    drawings(tmp_path / "A")
    drawings(tmp_path / "reference")
    picture(tmp_path / "memo.png")
    found = cut_files(tmp_path)
    assert names(found.sources) == ["A"]
    assert [str(note) for note in found.notes] == [f"{tmp_path}: not taken into the cut: memo.png, reference"]


@pytest.mark.parametrize("background", ["BG.png", "c7_BG.png", "背景.png", "LO1.png", "Background.PNG"])
def test_backgrounds_by_name(tmp_path: Path, background: str) -> None:
    drawings(tmp_path / "c7")
    picture(tmp_path / "c7" / background, fill=True)
    found = cut_files(tmp_path / "c7")
    assert names(found.sources) == ["c7"], "one run of drawings is called like the cut"
    assert found.background == tmp_path / "c7" / background


def test_of_several_backgrounds_one_counts_and_the_others_are_said(tmp_path: Path) -> None:
    drawings(tmp_path / "A")
    for name in ("BG.png", "LO.png"):
        picture(tmp_path / name, fill=True)
    found = cut_files(tmp_path)
    assert found.background == tmp_path / "BG.png"
    assert [note.values["names"] for note in found.notes] == ["LO.png"]


@pytest.mark.parametrize("holder", ["_Cell", "cel", "セル", "仕上", "Cells"])
def test_columns_may_lie_in_a_folder_of_their_own(tmp_path: Path, holder: str) -> None:
    for column in ("A", "B"):
        drawings(tmp_path / "c1" / holder / column)
    assert names(cut_files(tmp_path / "c1").sources) == ["A", "B"]
    sheet = timesheet(tmp_path / "c1" / "c1.xdts", {"B": [(1, 2)]})
    found = cut_files(tmp_path / "c1")
    assert (names(found.sources), found.sheet) == (["B"], sheet)


def test_of_several_stages_the_latest_counts_and_the_others_are_said(tmp_path: Path) -> None:
    for stage in ("原画", "仕上", "動画"):
        drawings(tmp_path / stage / "A")
    found = cut_files(tmp_path)
    assert [source.path for source in found.sources] == [tmp_path / "仕上" / "A"]
    assert [note.values["names"] for note in found.notes] == ["動画, 原画"]


def test_drawings_of_several_cuts_beside_their_sheets_are_told_apart_by_name(tmp_path: Path) -> None:
    for cut in ("c1", "c2"):
        for number in (1, 2):
            picture(tmp_path / f"{cut}_A_{number:04d}.png")
        timesheet(tmp_path / f"{cut}.xdts", {"A": [(1, 1)]})
    for cut in ("c1", "c2"):
        (source,) = cut_files(tmp_path / f"{cut}.xdts").sources
        assert source.drawings is not None
        assert {file.path.name for file in source.drawings.files} == {f"{cut}_A_0001.png", f"{cut}_A_0002.png"}


def test_named_folders_are_characters_where_nothing_is_a_column(tmp_path: Path) -> None:
    for name in ("hero", "dog"):
        drawings(tmp_path / name)
    assert names(cut_files(tmp_path).sources) == ["dog", "hero"]


def test_stills_are_characters_where_nothing_is_numbered(tmp_path: Path) -> None:
    picture(tmp_path / "hero.png")
    assert len(cut_files(tmp_path).sources) == 1


@pytest.mark.parametrize("place", ["c3/c3.xdts", "c3/sheet.xdts", "c3.xdts"])
def test_a_timesheet_in_the_folder_or_beside_it_times_the_columns(tmp_path: Path, place: str) -> None:
    drawings(tmp_path / "c3" / "A", count=2)
    sheet = timesheet(tmp_path / place, {"A": [(1, 2), (5, 1)]}, length=8)
    found = cut_files(tmp_path / "c3")
    assert found.sheet == sheet
    document = document_of_cut(found).document
    assert document.canvas.length_frames == 8
    assert [(each.frame, each.drawing) for each in document.layers[0].cels.exposures] == [(1, 1), (5, 0)]


def test_of_several_timesheets_the_one_called_like_the_cut_counts(tmp_path: Path) -> None:
    drawings(tmp_path / "c3" / "A")
    timesheet(tmp_path / "c3" / "a_first.xdts", {"A": [(1, 1)]})
    own = timesheet(tmp_path / "c3" / "C3.xdts", {"A": [(1, 2)]})
    found = cut_files(tmp_path / "c3")
    assert found.sheet == own
    assert [note.values["names"] for note in found.notes] == ["a_first.xdts"]


def test_a_plain_background_beside_several_timesheets_belongs_to_none(tmp_path: Path) -> None:
    drawings(tmp_path / "A")
    picture(tmp_path / "BG.png", fill=True)
    picture(tmp_path / "c2_BG.png", fill=True)
    for name in ("c1", "c2"):
        timesheet(tmp_path / f"{name}.xdts", {"A": [(1, 1)]})
    assert cut_files(tmp_path / "c1.xdts").background is None
    assert cut_files(tmp_path / "c2.xdts").background == tmp_path / "c2_BG.png"


@pytest.mark.parametrize(
    ("made", "said"),
    [
        ((), "the folder of this cut is empty"),
        (("BG.png",), "there is only a background in it"),
        (("notes/inner/x.png",), "there is no drawing"),
        (("memo.txt",), "there is no drawing"),
    ],
)
def test_a_cut_without_drawings_is_refused_in_one_sentence(tmp_path: Path, made: tuple[str, ...], said: str) -> None:
    for name in made:
        if name.endswith(".txt"):
            (tmp_path / name).write_text("none", encoding="utf-8")
        else:
            picture(tmp_path / name)
    with pytest.raises(InputProblem, match=said):
        cut_files(tmp_path)


def test_the_document_has_what_was_left_out_among_its_notes(tmp_path: Path) -> None:
    drawings(tmp_path / "A")
    picture(tmp_path / "memo.png")
    imported = document_of_cut(cut_files(tmp_path))
    assert "not taken into the cut" in str(imported.notes[0])
    assert imported.document.layers[0].name == "A"
