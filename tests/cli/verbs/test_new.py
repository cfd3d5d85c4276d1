"""What ``kagezou new`` understood, and what it does not make a project of."""

import json
from pathlib import Path

import pytest

from kagezou.io.sheets.timesheet import SheetTrack, Timesheet
from kagezou.io.sheets.xdts_writing import write_xdts
from tests.cli.projects import Shell, make_drawings


def lines_of(shell: Shell) -> list[str]:
    return [line.removeprefix("kagezou: note: ") for line in shell.said.splitlines()]


def test_what_was_understood_is_printed_before_the_doubts(shell: Shell, tmp_path: Path) -> None:
    drawings = make_drawings(tmp_path / "walk", 3)
    (drawings / "walk_0002.png").replace(drawings / "walk_0002_R1.png")
    make_drawings(drawings, 3)
    assert shell("new", "--no-feet", tmp_path / "p.kage", "--character", f"A={drawings}") == 0
    assert lines_of(shell) == [
        "A: 3 drawings, 1-3, walk_0001.png … walk_0003.png",
        f"{drawings}: the newest retake counts: walk_0002.png → walk_0002_R1.png",
    ]


@pytest.mark.parametrize(
    ("column", "cel", "sentence"),
    [("Z", "1", "beside it there are no drawings of its columns (Z)"), ("walk", "9", "none of its cels has a drawing")],
)
def test_a_sheet_that_finds_no_drawing_makes_no_project(
    shell: Shell, tmp_path: Path, column: str, cel: str, sentence: str
) -> None:
    make_drawings(tmp_path / "walk", 3)
    write_xdts(tmp_path / "cut.xdts", Timesheet("cut", 12, (SheetTrack(column, ((0, cel),)),)))
    assert sentence in shell.fails(3, "new", tmp_path / "p.kage", "--timesheet", tmp_path / "cut.xdts")
    assert not (tmp_path / "p.kage").exists()


def test_nothing_to_be_seen_is_no_project(shell: Shell, tmp_path: Path) -> None:
    for words in ((), ("--size", "64x48")):
        assert "no character and no background" in shell.fails(2, "new", tmp_path / "p.kage", *words)
    assert not (tmp_path / "p.kage").exists()


def test_one_of_several_sheets_is_chosen(shell: Shell, tmp_path: Path) -> None:
    make_drawings(tmp_path / "walk", 3)
    path = tmp_path / "cut.xdts"
    write_xdts(path, Timesheet("one", 12, (SheetTrack("walk", ((0, "1"),)),)))
    first, _, rest = path.read_text(encoding="utf-8").partition("\n")
    tree = json.loads(rest)
    tree["timeTables"].append({**tree["timeTables"][0], "name": "two", "duration": 30})
    path.write_text(first + json.dumps(tree), encoding="utf-8")
    words = ("new", "--no-feet", "--force", tmp_path / "p.kage", "--timesheet", path)
    for more, length, used in (((), 12, "one"), (("--sheet", "two"), 30, "two"), (("--sheet", "1"), 12, "one")):
        assert shell(*words, *more) == 0
        assert any(f"of its 2 sheets {used} is used" in line for line in lines_of(shell))
        assert shell.json("info", tmp_path / "p.kage", "--json")["last_frame"] == length
    assert "no sheet 'three' in it" in shell.fails(3, *words, "--sheet", "three")
