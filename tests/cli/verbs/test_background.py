"""Backgrounds of several pictures on the command line: made, described, and missed when they are gone."""

import json
from pathlib import Path

from tests.cli.projects import Shell, make_drawings


def test_a_project_with_a_background_of_several_pictures(shell: Shell, tmp_path: Path) -> None:
    hero, street = make_drawings(tmp_path / "hero"), make_drawings(tmp_path / "street", 5, (80, 48))
    project = tmp_path / "walk.kage"
    words = ("new", project, "--character", f"Hero={hero}", "--no-feet", "--background")
    assert shell(*words, street) == 0, shell.said
    about = shell.json("info", project, "--json")
    assert (about["width_px"], about["last_frame"], about["background_pictures"]) == (80, 5, 5)
    assert about["missing"] == []
    (street / "walk_0003.png").unlink()
    about = json.loads(shell.missing("info", project, "--json"))
    assert [Path(each).name for each in about["missing"]] == ["walk_0003.png"]
    lines = shell.missing("info", project).splitlines()
    (line,) = (each for each in lines if each.startswith("background"))
    assert line.endswith("walk_0001.png and 4 more pictures")
    assert shell(*words, street / "walk_0001.png", "--force") == 0
    assert shell.json("info", project, "--json")["background_pictures"] == 1
    assert shell(*words, street / "walk_#.png", "--force") == 0
    assert shell.json("info", project, "--json")["background_pictures"] == 4
