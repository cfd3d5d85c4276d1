"""What a program that waits reads of a command's way: how far, how it ended, and that it stops when asked."""

import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import pytest

from kagezou.cli.progress_file import ProgressFile, taken_out
from kagezou.document.edits import set_canvas
from kagezou.errors import UsageProblem
from kagezou.io.project.file import load, save
from tests.cli.projects import Shell, make_drawings
from tests.export.small_cuts import with_key


def said(path: Path) -> dict[str, list[str]]:
    found: dict[str, list[str]] = {}
    for line in path.read_text(encoding="utf-8").splitlines():
        name, _, value = line.partition(": ")
        found.setdefault(name, []).append(value)
    return found


def test_a_command_that_is_done(shell: Shell, project: Path, tmp_path: Path) -> None:
    told = tmp_path / "進捗 🦊.txt"
    shell.ok("export-ae", project, "-o", tmp_path / "ae", "--progress-file", told)
    found = said(told)
    assert (found["state"], found["exit"]) == (["done"], ["0"])
    assert found["done"] == found["total"]
    assert int(found["done"][0]) > 3
    assert sorted(each.name for each in tmp_path.iterdir() if each.name.startswith("進捗")) == [told.name]


def test_a_command_that_fails_says_why(shell: Shell, tmp_path: Path) -> None:
    told = tmp_path / "told"
    missing = tmp_path / "影.kage"
    assert shell("--progress-file", told, "render", missing, "-o", tmp_path / "out") == 7
    found = said(told)
    assert (found["state"], found["exit"]) == (["failed"], ["7"])
    assert found["said"] == [shell.said.rstrip("\n")]
    assert "影.kage" in found["said"][0]


def test_notes_come_with_it(shell: Shell, tmp_path: Path) -> None:
    drawings = make_drawings(tmp_path / "hero")
    told = tmp_path / "told"
    shell("new", tmp_path / "a.kage", "--character", f"Hero={drawings}", "--progress-file", told)
    assert said(told)["said"] == shell.said.splitlines()
    assert said(told)["state"] == ["done"]


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["render", "--progress-file"], "--progress-file needs a file"),
        (["render", "--progress-file", "nowhere/at all/a"], "its folder is not there"),
    ],
)
def test_an_option_without_a_file_is_one_sentence(shell: Shell, words: list[str], sentence: str) -> None:
    assert sentence in shell.fails(2, *words)


def test_the_option_is_taken_out_wherever_it_stands(tmp_path: Path) -> None:
    file = tmp_path / "a"
    for words in (["--progress-file", str(file), "info", "p"], ["info", "p", "--progress-file", str(file)]):
        assert taken_out(words) == (["info", "p"], file)
    assert taken_out(["info"]) == (["info"], None)
    with pytest.raises(UsageProblem):
        taken_out(["info", "--progress-file", ""])


def test_what_is_asked_to_stop_stops_with_whole_files_and_goes_on_later(tmp_path: Path, project: Path) -> None:
    told = tmp_path / "told"
    document = load(project)
    document = set_canvas(document, replace(document.canvas, length_frames=400, width_px=1200, height_px=900))
    document = with_key(with_key(document, "light.position", 1, [5, -20, 40]), "light.position", 400, [60, -25, 45])
    save(document, project)
    words = ["render", str(project), "-o", str(tmp_path / "out"), "--skip-existing", "--progress-file", str(told)]
    with subprocess.Popen([sys.executable, "-m", "kagezou", *words], stderr=subprocess.DEVNULL) as working:
        while not told.exists() or said(told)["done"] == ["0"]:
            assert working.poll() is None
            time.sleep(0.01)
        (tmp_path / "told.stop").touch()
        assert working.wait(60) == 130
    found = said(told)
    assert found["state"] == ["stopped"]
    assert 0 < int(found["done"][0]) < int(found["total"][0])
    assert not (tmp_path / "told.stop").exists()
    frames = list((tmp_path / "out/Hero_shadow").glob("*.png"))
    assert 0 < len(frames) < 400
    assert not list((tmp_path / "out/Hero_shadow").glob(".*"))


def test_the_beat_goes_on_while_nothing_is_finished(tmp_path: Path) -> None:
    path = tmp_path / "told"
    with ProgressFile(path) as told:
        while said(path)["beat"] == ["0"]:
            time.sleep(0.05)
        assert said(path)["state"] == ["running"]
    told.end(0)
    assert said(path)["state"] == ["done"]
    assert [each.name for each in tmp_path.iterdir()] == ["told"]


def test_a_file_that_cannot_be_replaced_for_a_while_has_the_last_state_all_the_same(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "told"
    real = Path.replace
    refused: list[int] = []

    def busy(self: Path, target: Path) -> Path:
        if len(refused) < 3:
            refused.append(1)
            raise PermissionError
        return real(self, target)

    with ProgressFile(path) as told:
        monkeypatch.setattr(Path, "replace", busy)
    told.end(4)
    assert said(path)["exit"] == ["4"]
    assert len(refused) == 3
