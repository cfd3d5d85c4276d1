"""What stands in for a missing drawing, by every command that writes frames."""

import json
from pathlib import Path
from typing import Any

import pytest

from kagezou.cli.arguments import Parser
from kagezou.cli.main import VERBS
from kagezou.cli.standing_in import WAYS, add_missing
from kagezou.export.exporters.table import EXPORTERS
from kagezou.export.request import Missing
from tests.cli.projects import Shell

COMMANDS = {
    "render": ("-o", "out"),
    "video": ("-o", "a.mp4"),
    "export-ae": ("-o", "out"),
    "export-scene": ("--for", "nuke", "-o", "out"),
}
HELD = "Hero: missing, so the nearest drawing is held on frames 2: walk_0002.png"


def test_the_words_are_those_of_the_exports() -> None:
    assert tuple(Missing) == WAYS
    parser = Parser("render", "", "")
    add_missing(parser)
    assert parser.parse_args([]).missing == Missing.FAIL


def test_every_command_that_an_export_is_made_by_is_tried_here() -> None:
    assert {each.verb for each in EXPORTERS} == {*COMMANDS, "farm"} <= set(VERBS)


@pytest.mark.parametrize("verb", COMMANDS)
def test_it_is_refused_or_held_and_said(
    shell: Shell, project: Path, verb: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    (project.parent / "hero" / "walk_0002.png").unlink()
    monkeypatch.chdir(project.parent)
    words = (verb, project, *COMMANDS[verb])
    assert "walk_0002.png: the drawing is missing" in shell.fails(3, *words)
    assert shell(*words, "--missing", "hold") == 0
    assert shell.said.count(HELD) == 1
    assert shell(*words, "--missing", "hold", "--json") == 0
    assert HELD in json.loads(shell.out)["notes"]


def test_a_job_of_a_farm_takes_it_along(shell: Shell, project: Path) -> None:
    assert shell("farm", project, "--missing", "empty") == 0
    assert '"default": "empty"' in (project.parent / "walk_job" / "template.json").read_text(encoding="utf-8")


def test_a_cut_of_a_batch_whose_project_was_changed_by_hand(shell: Shell, project: Path, tmp_path: Path) -> None:
    """A cut is brought in with the drawings that are there; a project that stays as it is may lack some."""
    out, cut = tmp_path / "many", project.parent / "hero"
    assert shell("auto", cut, "-o", out, "--as", "hero") == 0
    shell.ok("set", out / "hero" / "hero.kage", "light.azimuth=33")
    (cut / "walk_0002.png").unlink()
    assert shell("auto", cut, "-o", out, "--as", "hero") == 8
    assert "walk_0002.png: it does not exist (1 of 3 frames failed)" in shell.said

    def made(way: str) -> Any:
        assert shell("auto", cut, "-o", out, "--as", "hero", "--missing", way, "--skip-existing", "--json") == 0
        return json.loads(shell.out)

    told = made("hold")
    assert (told["state"], [note for note in told["notes"] if "held" in note]) == (
        "done",
        ["hero: missing, so the nearest drawing is held on frames 2: walk_0002.png"],
    )
    assert made("hold")["state"] == "kept"
    assert made("empty")["state"] == "done", "it comes out otherwise"


def test_cuts_of_a_batch_are_asked_for_alike_here_and_on_a_farm(shell: Shell, project: Path, tmp_path: Path) -> None:
    cuts = project.parent / "hero"
    assert shell("auto", cuts, "-o", tmp_path / "many", "--missing", "hold", "--farm", tmp_path / "job") == 0
    assert '"--missing=hold"' in (tmp_path / "job" / "template.json").read_text(encoding="utf-8")
    assert shell("auto", cuts, "-o", tmp_path / "many", "--farm", tmp_path / "job") == 0
    assert "--missing" not in (tmp_path / "job" / "template.json").read_text(encoding="utf-8")
