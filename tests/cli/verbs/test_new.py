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


def test_a_template_gives_canvas_light_look_ground_set_and_first_number(shell: Shell, tmp_path: Path) -> None:
    like = tmp_path / "show.kage"
    shell.ok("new", "--no-feet", like, "--character", f"B={make_drawings(tmp_path / 'b', 2)}", "--size", "200x100")
    assert shell("set", like, "canvas.fps=25", "canvas.first_frame=1001", "canvas.name=Show", "canvas.cut=12") == 0
    assert shell("set", like, "light.kind=sun", "layers.B.shadow.opacity=0.25", "ground.roll=3") == 0
    assert shell("piece", like, "add", "Wall", "wall") == 0
    made = tmp_path / "new.kage"
    shell("new", made, "--character", f"A={make_drawings(tmp_path / 'a', 3)}", "--template", like)
    values = {
        path: shell.json("get", made, path)
        for path in ("canvas.size", "canvas.fps", "canvas.first_frame", "canvas.name", "canvas.cut", "light.kind")
    }
    assert list(values.values()) == ["200x100", "25", 1001, "Show", "", "sun"]
    assert shell.json("get", made, "layers.A.shadow.opacity") == 0.25
    assert shell.json("get", made, "ground.roll") == 3
    assert "Wall" in shell.ok("piece", made, "list")
    sized = tmp_path / "sized.kage"
    shell("new", sized, "--character", f"A={tmp_path / 'a'}", "--template", like, "--size", "64x48", "--fps", "24")
    assert (shell.json("get", sized, "canvas.size"), shell.json("get", sized, "canvas.fps")) == ("64x48", "24")


def test_a_template_that_is_not_there(shell: Shell, tmp_path: Path) -> None:
    words = ["--character", f"A={make_drawings(tmp_path / 'a', 1)}", "--template", tmp_path / "no.kage"]
    assert "no.kage" in shell.fails(7, "new", tmp_path / "p.kage", *words)


def test_a_project_has_the_ending_by_which_it_is_known(shell: Shell, tmp_path: Path) -> None:
    make_drawings(tmp_path / "hero", 2)
    said = shell.fails(2, "new", tmp_path / "walk", "--character", f"Hero={tmp_path / 'hero'}")
    assert said.endswith("walk: the name of a project ends in .kage, such as " + str(tmp_path / "walk.kage"))
    assert not (tmp_path / "walk").exists()
