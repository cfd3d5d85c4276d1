"""Light, looks, ground and set of one project for others, from the command line."""

import json
from pathlib import Path

import pytest

from tests.cli.projects import Shell, make_drawings


@pytest.fixture
def projects(shell: Shell, tmp_path: Path) -> list[Path]:
    paths = [tmp_path / f"c{number:03}.kage" for number in (1, 2, 3)]
    for path in paths:
        assert shell("new", path, "--character", f"Hero={make_drawings(tmp_path / path.stem)}", "--no-feet") == 0
    return paths


def test_light_and_look_are_taken_and_each_project_is_named(shell: Shell, projects: list[Path]) -> None:
    first, *others = projects
    shell.ok("set", first, "light.kind=sun", "light.azimuth=33", "layers.Hero.shadow.simplify=4")
    assert shell("apply", first, *others, "--light", "--look") == 0
    assert shell.out.splitlines() == [str(path) for path in others]
    for path in others:
        assert shell.json("get", path, "light.azimuth") == 33
        assert shell.json("get", path, "layers.Hero.shadow.simplify") == pytest.approx(4)
    assert shell("apply", first, *others, "--light") == 0
    assert shell.out == "", "nothing was left to take"


def test_it_goes_on_after_one_that_cannot_be_changed(shell: Shell, projects: list[Path], tmp_path: Path) -> None:
    first, second, third = projects
    shell.ok("set", first, "light.azimuth=33")
    second.write_text("no project", encoding="utf-8")
    assert shell("apply", first, second, tmp_path / "gone.kage", third, "--light", "--json") == 7
    told = json.loads(shell.out)
    assert [each["changed"] for each in told["projects"]] == [False, False, True]
    assert "gone.kage" in told["projects"][1]["problem"]
    assert shell.json("get", third, "light.azimuth") == 33
    assert not list(tmp_path.glob(".*.edit"))


def test_a_dry_run_writes_nothing_and_nothing_asked_for_is_refused(shell: Shell, projects: list[Path]) -> None:
    first, second, _ = projects
    shell.ok("set", first, "ground.declination=33")
    before = second.read_bytes()
    assert shell("apply", first, second, "--ground", "--set", "--dry-run") == 0
    assert shell.out.strip() == str(second)
    assert second.read_bytes() == before
    assert "what is taken?" in shell.fails(2, "apply", first, second)
