"""A project of a timesheet alone, and the timesheet of a project."""

import unicodedata
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from kagezou.document.edits import set_canvas, set_exposures
from kagezou.document.model import Document, Exposure
from kagezou.errors import InputProblem
from kagezou.importing.sheet_project import document_of_sheet
from kagezou.importing.staging import Imported
from kagezou.importing.timesheet_on_document import sheet_of, timed
from kagezou.io.images.writing import write_rgba
from kagezou.io.project.file import load, save
from kagezou.io.sheets.timesheet import SheetTrack, Timesheet
from kagezou.io.sheets.xdts_writing import write_xdts, xdts_text

SHEET = Timesheet(
    "c012",
    36,
    (
        SheetTrack("A", ((0, "1"), (6, "3"), (12, None), (20, "2"))),
        SheetTrack("B", ((0, None), (4, "1"))),
        SheetTrack("C", ((0, "1"),)),
    ),
)


def drawing(path: Path) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    rgba = np.zeros((48, 64, 4), np.uint8)
    rgba[10:40, 20:40] = 255
    write_rgba(path, rgba)


@pytest.fixture
def sheet(tmp_path: Path) -> Path:
    for number in (1, 2, 3):
        drawing(tmp_path / "a" / f"{number:04d}.png")
        drawing(tmp_path / f"B_{number}.png")
    write_xdts(tmp_path / "c012.xdts", SHEET)
    return tmp_path / "c012.xdts"


def test_columns_find_folders_in_any_case_and_files_of_their_name(sheet: Path) -> None:
    imported = document_of_sheet(sheet)
    document = imported.document
    assert [layer.name for layer in document.layers] == ["A", "B"]
    assert document.canvas.length_frames == 36
    assert document.layers[0].cels.exposures == (
        Exposure(1, 0),
        Exposure(7, 2),
        Exposure(13, None),
        Exposure(21, 1),
    )
    assert document.layers[1].cels.drawing_at(5) is not None
    assert document.layers[1].cels.drawing_at(4) is None
    assert any("column 'C'" in note for note in map(str, imported.notes))


def test_without_any_drawings_it_says_what_was_looked_for(tmp_path: Path) -> None:
    write_xdts(tmp_path / "c012.xdts", SHEET)
    with pytest.raises(InputProblem, match=r"c012\.xdts: beside it there are no drawings .*A, B, C") as caught:
        document_of_sheet(tmp_path / "c012.xdts")
    assert "\n" not in str(caught.value)


def test_the_timesheet_of_a_project_times_it_the_same(sheet: Path) -> None:
    document = document_of_sheet(sheet).document
    written = sheet_of(document, "c012")
    assert written.tracks == SHEET.tracks[:2]
    again, notes = timed(document, written)
    assert notes == []
    assert again == document


def test_what_was_exposed_before_the_cut_is_what_it_begins_with(sheet: Path) -> None:
    document = document_of_sheet(sheet).document
    early = set_exposures(document, "layer-1", (Exposure(-5, 0), Exposure(-1, 2), Exposure(9, 1)))
    assert sheet_of(early, "").tracks[0].entries == ((0, "3"), (8, "2"))


def test_what_lies_behind_the_end_of_the_cut_is_not_in_its_sheet(sheet: Path) -> None:
    document = document_of_sheet(sheet).document
    short = set_canvas(document, replace(document.canvas, length_frames=12))
    assert sheet_of(short, "").tracks[0].entries == ((0, "1"), (6, "3"))


def test_numbers_that_a_sheet_does_not_ask_for_are_nothing_to_speak_of(tmp_path: Path) -> None:
    for number in (1, 7):
        drawing(tmp_path / "A" / f"{number}.png")
    write_xdts(tmp_path / "c.xdts", Timesheet("c", 24, (SheetTrack("A", ((0, "7"), (4, "1"))),)))
    assert tuple(map(str, document_of_sheet(tmp_path / "c.xdts").notes)) == ()
    write_xdts(tmp_path / "c.xdts", Timesheet("c", 24, (SheetTrack("A", ((0, "7"), (4, "2"))),)))
    (note,) = map(str, document_of_sheet(tmp_path / "c.xdts").notes)
    assert note.endswith("stay empty: 2")


def cels_of(document: Document) -> list[tuple[str, list[tuple[int, str | None]]]]:
    """Return the layers' names, and which file is exposed from which frame on."""
    made = []
    for layer in document.layers:
        drawings = layer.cels.drawings
        shown = [
            (each.frame, None if each.drawing is None else drawings[each.drawing].path.name)
            for each in layer.cels.exposures
        ]
        made.append((layer.name, shown))
    return made


def opened(folder: Path, *tracks: SheetTrack) -> Imported:
    write_xdts(folder / "c012.xdts", Timesheet("c012", 24, tracks))
    return document_of_sheet(folder / "c012.xdts")


def test_inserted_drawings_and_retakes_beside_the_sheet_are_found(tmp_path: Path) -> None:
    for name in ("A_0001", "A_0001a", "A_0002R", "AB_0001"):
        drawing(tmp_path / f"{name}.png")
    imported = opened(tmp_path, SheetTrack("A", ((0, "1"), (4, "1a"), (8, "2r"))))
    assert tuple(map(str, imported.notes)) == ()
    assert cels_of(imported.document) == [("A", [(1, "A_0001.png"), (5, "A_0001a.png"), (9, "A_0002R.png")])]


def test_a_folder_whose_files_are_called_in_two_ways_is_one_column(tmp_path: Path) -> None:
    for name in ("A_0001", "a0002", "A-0003", "A_line_0001"):
        drawing(tmp_path / "A" / f"{name}.png")
    imported = opened(tmp_path, SheetTrack("A", ((0, "1"), (4, "2"), (8, "3"))))
    assert cels_of(imported.document)[0][1] == [(1, "A_0001.png"), (5, "a0002.png"), (9, "A-0003.png")]
    drawing(tmp_path / "A" / "A0001.png")
    names = [name for name, _ in cels_of(opened(tmp_path, SheetTrack("A", ((0, "1"),))).document)]
    assert names == ["A A", "A A_line"], "of two files of one number one counts"


def test_columns_of_one_name_share_their_drawings(tmp_path: Path) -> None:
    for number in (1, 2):
        drawing(tmp_path / "A" / f"{number}.png")
    imported = opened(
        tmp_path, SheetTrack("A", ((0, "1"),)), SheetTrack("A", ((0, None), (6, "2"))), SheetTrack("A", ())
    )
    assert tuple(map(str, imported.notes)) == ()
    assert cels_of(imported.document) == [("A", [(1, "1.png")]), ("A 2", [(1, None), (7, "2.png")])]
    again, notes = timed(imported.document, sheet_of(imported.document, ""))
    assert (again, notes) == (imported.document, [])


def test_odd_names_and_full_width_figures_are_understood(tmp_path: Path) -> None:
    name = "A\"'\u2028🎈"
    drawing(tmp_path / name / "1.png")
    drawing(tmp_path / name / "2.png")
    drawing(tmp_path / "_Cell" / "B" / "b001.png")
    odd = SheetTrack(name, ((0, "１"), (3, "Ａ２")))
    imported = opened(tmp_path, odd, SheetTrack("../../B", ((0, "1"),)), SheetTrack("B", ((0, "1"),)))
    assert cels_of(imported.document) == [("A\"'_🎈", [(1, "1.png"), (4, "2.png")]), ("B", [(1, "b001.png")])]
    assert any("'../../B'" in note for note in map(str, imported.notes))


@pytest.mark.parametrize(
    "names",
    [
        ("A (1)", "A (2)"),
        ("1", "2"),
        ("Ａ０００１", "Ａ０００２"),
        ("A_0001_col", "A_0002_col"),
        ("a-01_v2", "a-02_v2"),
        ("A1A", "A2A"),
        ("c012_A_0001", "c012_A_0002"),
    ],
)
def test_cels_are_found_by_whatever_names_their_drawings_have(tmp_path: Path, names: tuple[str, str]) -> None:
    for name in names:
        drawing(tmp_path / "A" / f"{name}.png")
    imported = opened(tmp_path, SheetTrack("A", ((0, "1"), (4, "A_0002"), (6, "０１"))))
    first, second = (f"{name}.png" for name in names)
    assert cels_of(imported.document) == [("A", [(1, first), (5, second), (7, first)])]


@pytest.mark.parametrize(("kept", "asked"), [("NFD", "NFC"), ("NFC", "NFD")])
def test_columns_are_found_in_either_spelling(tmp_path: Path, kept: str, asked: str) -> None:
    def spelled(text: str, form: str) -> str:
        return unicodedata.normalize("NFD" if form == "NFD" else "NFC", text)

    drawing(tmp_path / spelled("ガール", kept) / "0001.png")
    drawing(tmp_path / f"{spelled('パンダ', kept)}_0001.png")
    path = tmp_path / f"{spelled('カット_ガ', kept)}.xdts"
    write_xdts(
        path, Timesheet("c", 9, tuple(SheetTrack(spelled(name, asked), ((0, "1"),)) for name in ("ガール", "パンダ")))
    )
    document = document_of_sheet(path.with_name(spelled(path.name, asked))).document
    assert [layer.name for layer in document.layers] == ["ガール", "パンダ"]
    assert all(layer.cels.drawing_at(1) is not None for layer in document.layers)


def test_a_folder_or_a_run_whose_last_word_is_the_column_is_its(tmp_path: Path) -> None:
    drawing(tmp_path / "c012_A" / "0001.png")
    drawing(tmp_path / "c012_B_0001.png")
    imported = opened(tmp_path, SheetTrack("A", ((0, "1"),)), SheetTrack("b", ((0, "1"),)))
    assert cels_of(imported.document) == [("A", [(1, "0001.png")]), ("b", [(1, "c012_B_0001.png")])]


def test_retakes_of_a_column_count_and_are_said(tmp_path: Path) -> None:
    for name in ("A/1", "A/2", "A_R1/2", "B_1", "B_1_R1"):
        drawing(tmp_path / f"{name}.png")
    imported = opened(tmp_path, SheetTrack("A", ((0, "1"), (4, "2"))), SheetTrack("B", ((0, "1"),)))
    paths = [
        each.path.relative_to(tmp_path).as_posix() for layer in imported.document.layers for each in layer.cels.drawings
    ]
    assert paths == ["A/1.png", "A_R1/2.png", "B_1_R1.png"]
    said = list(map(str, imported.notes))
    assert any("taken as one, of which the newest counts: A, A_R1" in note for note in said)
    assert any("the newest retake counts: B_1.png → B_1_R1.png" in note for note in said)


def test_a_column_that_ends_with_a_figure_is_no_part_of_a_cel(tmp_path: Path) -> None:
    for number in (1, 2):
        drawing(tmp_path / "1" / f"{number}.png")
    imported = opened(tmp_path, SheetTrack("1", ((0, "12"), (3, "2"))))
    assert cels_of(imported.document)[0][1] == [(1, None), (4, "2.png")]


def test_a_sheet_none_of_whose_cels_is_there_makes_nothing(tmp_path: Path) -> None:
    drawing(tmp_path / "A" / "7.png")
    with pytest.raises(InputProblem, match=r"c012\.xdts: none of its cels has a drawing among those of A"):
        opened(tmp_path, SheetTrack("A", ((0, "1"), (4, "2"))))


def test_what_a_sheet_holds_besides_comes_back_with_the_project(sheet: Path, tmp_path: Path) -> None:
    text = sheet.read_text(encoding="utf-8").replace('"cut": "1"', '"cut": "77"')
    sheet.write_text(text, encoding="utf-8")
    save(document_of_sheet(sheet).document, tmp_path / "p.kage")
    document = load(tmp_path / "p.kage")
    assert '"cut": "77"' in xdts_text(sheet_of(document, "p"))
    assert '"C"' in xdts_text(sheet_of(document, "p")), "a column without a layer stays in the sheet"
