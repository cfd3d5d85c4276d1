"""The settings of a cut on the command line: set, get, info, and the sheet that bears scene and cut."""

import json
from pathlib import Path

import pytest

from tests.cli.projects import Shell, make_drawings


@pytest.fixture
def project(shell: Shell, tmp_path: Path) -> Path:
    project = tmp_path / "p.kage"
    drawings = make_drawings(tmp_path / "walk", 4, (64, 36))
    assert shell("new", project, "--no-feet", "--character", f"A={drawings}") == 0
    return project


def test_a_cut_gets_other_settings_and_info_shows_them(shell: Shell, project: Path) -> None:
    words = ("canvas.fps=23.976", "canvas.length=48", "canvas.first_frame=101", "canvas.scene=3", "canvas.cut=012")
    assert shell("set", project, *words, "canvas.name=Episode 3") == 0
    assert "lasts 2.00 instead of 0.17 s" in shell.said
    assert "shown as 101" in shell.said
    about = shell.json("info", project, "--json")
    assert about["frame_rate"] == "24000/1001"
    assert (about["first_frame"], about["last_frame"], about["shown_first_frame"]) == (1, 48, 101)
    assert about["slate"] == {"name": "Episode 3", "scene": "3", "cut": "012"}
    assert shell.json("get", project, "canvas.fps") == "24000/1001"
    assert shell.json("get", project, "canvas.length") == 48
    listed = {row["path"]: row["value"] for row in shell.json("info", project, "--json", "--properties")["properties"]}
    assert listed["canvas.cut"] == "012"


@pytest.mark.parametrize(
    ("drawings", "ground_shift", "scale"),
    [((), 32, 100), (("--drawings", "stay"), 0, 100), (("--drawings", "scale"), None, 200)],
)
def test_another_size_takes_what_is_drawn_along(
    shell: Shell, project: Path, drawings: tuple[str, ...], ground_shift: int | None, scale: int
) -> None:
    before = shell.json("get", project, "ground.position")
    light = shell.json("get", project, "light.kind")
    assert shell("set", project, "canvas.size=128x72", *drawings) == 0
    assert ("become 200 %" in shell.said) == (scale == 200)
    after = shell.json("get", project, "ground.position")
    assert after[0] == (2 * before[0] if ground_shift is None else before[0] + ground_shift)
    assert shell.json("get", project, "layers.A.scale") == [scale, scale]
    assert shell.json("get", project, "light.kind") == light, "a larger canvas sends nobody on a way"


def test_properties_are_meant_on_the_new_canvas(shell: Shell, project: Path) -> None:
    shell.ok("set", project, "ground.position=[5,6]", "canvas.size=128x72")
    assert shell.json("get", project, "ground.position") == [5, 6]


@pytest.mark.parametrize(
    "words",
    [
        ("canvas.size=big",),
        ("canvas.size=0x0",),
        ("canvas.fps=0",),
        ("canvas.length=0",),
        ("canvas.length=9", "--frame", "2"),
        ("canvas.length=9", "--drawings", "scale"),
        ("light.kind=sun", "--drawings", "stay"),
        ("canvas.size=64x36", "canvas.colour=3"),
    ],
)
def test_what_cannot_be_meant_is_refused_and_nothing_is_written(
    shell: Shell, project: Path, words: tuple[str, ...]
) -> None:
    before = project.read_bytes()
    assert shell("set", project, *words) == 2
    assert project.read_bytes() == before


def test_the_sheet_that_is_written_bears_scene_and_cut(shell: Shell, project: Path, tmp_path: Path) -> None:
    sheet = tmp_path / "p.xdts"
    shell.ok("timesheet", project, "-o", sheet)
    assert json.loads(sheet.read_text(encoding="utf-8").split("\n", 1)[1])["header"] == {"cut": "1", "scene": "1"}
    shell.ok("set", project, "canvas.cut=12A")
    assert shell("timesheet", project, "-o", sheet, "--force") == 0
    assert "'12A' is written as 'cut' of the timesheet" in shell.said
    assert json.loads(sheet.read_text(encoding="utf-8").split("\n", 1)[1])["header"] == {"cut": "12A", "scene": "1"}
    shell.ok("set", project, "canvas.cut=0012")
    shell.ok("timesheet", project, "-o", sheet, "--force")
