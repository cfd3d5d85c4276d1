"""What every command can be asked for: quiet, verbose, a log, JSON for programs, help by name."""

import json
from io import StringIO
from pathlib import Path

import pytest

from kagezou.cli.manner import manner_of
from kagezou.cli.terminal import ProgressLine, Voice, speaking
from kagezou.errors import UsageProblem
from tests.cli.projects import Shell


def test_a_problem_is_one_object_too(shell: Shell, project: Path, tmp_path: Path) -> None:
    assert shell("info", tmp_path / "no.kage", "--json") == 7
    told = json.loads(shell.out)
    assert told["code"] == 7
    assert "no.kage" in told["message"]
    assert told["file"] == str(tmp_path / "no.kage")
    assert shell.said.count("\n") == 1, "people get the sentence as before"
    assert shell("set", project, "light.positoin=1", "--json") == 2
    assert json.loads(shell.out)["values"]["near"] == "light.position"
    assert shell("render", project, "--json") == 2
    assert json.loads(shell.out)["code"] == 2


def test_commands_without_json_of_their_own_give_their_lines(shell: Shell, project: Path, tmp_path: Path) -> None:
    sheet = tmp_path / "sheet.xdts"
    told = shell.json("timesheet", project, "-o", sheet, "--json")
    assert told == {"code": 0, "lines": [str(sheet)], "notes": []}
    assert shell("set", project, "light.position=10,-20,30", "--json", "--quiet") == 0
    assert json.loads(shell.out)["lines"] == []


def test_quiet_leaves_notes_out_and_a_log_keeps_them(shell: Shell, project: Path, tmp_path: Path) -> None:
    log = tmp_path / "said.log"
    assert shell("relink", project) == 0
    assert "no drawing is missing" in shell.said
    assert shell("relink", project, "--quiet", "--log", log) == 0
    assert shell.said == ""
    assert "no drawing is missing" in log.read_text(encoding="utf-8")
    assert shell("get", project, "nothing", "--quiet", "--log", log) == 2
    assert "there is no property" in shell.said, "problems are always said"
    assert len(log.read_text(encoding="utf-8").splitlines()) == 2


def test_what_cannot_be_meant_is_refused(shell: Shell, tmp_path: Path) -> None:
    assert "needs a file" in shell.fails(2, "doctor", "--log")
    assert "one too many" in shell.fails(2, "doctor", "--quiet", "--verbose")
    assert "log cannot be written" in shell.fails(4, "doctor", "--log", tmp_path / "nowhere" / "x.log")
    with pytest.raises(UsageProblem):
        manner_of(["--log"])


def test_help_of_a_command(shell: Shell) -> None:
    assert shell.ok("help", "set") == shell.ok("set", "--help")
    assert "neither a command nor a project" in shell.fails(2, "help", "sett")


@pytest.mark.parametrize(("voice", "lines"), [(Voice(), 0), (Voice(is_verbose=True), 1), (Voice(is_quiet=True), 0)])
def test_progress_is_said_in_lines_where_no_one_watches(voice: Voice, lines: int) -> None:
    stream = StringIO()
    with speaking(voice), ProgressLine("rendering", stream) as line:
        line.update(2, 2)
    assert stream.getvalue().count("\n") == lines
    assert "\r" not in stream.getvalue()
