"""A project of a timesheet alone, and the timesheet of a project."""

from pathlib import Path

import numpy as np
import pytest

from kagezou.document.edits import set_exposures
from kagezou.document.model import Exposure
from kagezou.errors import InputProblem
from kagezou.io.encode import write_rgba
from kagezou.io.timesheet import SheetTrack, Timesheet
from kagezou.io.xdts import write_xdts
from kagezou.session.sheet_project import document_of_sheet
from kagezou.session.timing import sheet_of, timed

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
    staged = document_of_sheet(sheet)
    document = staged.document
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
    assert any("column 'C'" in note for note in staged.notes)


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
