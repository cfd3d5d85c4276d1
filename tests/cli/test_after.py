"""What runs after an export of the command line."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

from kagezou.export.after.hooks import COMMAND_VARIABLE
from kagezou.io.images.video import is_there
from tests.cli.projects import Shell


@pytest.fixture
def keep(tmp_path: Path) -> Path:
    """A program that keeps the manifest beside itself and says how many files it has."""
    path = tmp_path / "keep.py"
    path.write_text(
        "import json, pathlib, sys\n"
        "found = json.loads(pathlib.Path(sys.argv[-1]).read_text('utf-8'))\n"
        "pathlib.Path(sys.argv[0]).with_suffix('.json').write_text(json.dumps(found))\n"
        "print(len(found['files']), 'files')\n"
    )
    return path


def kept(keep: Path) -> Any:
    return json.loads(keep.with_suffix(".json").read_text())


def test_frames_are_handed_on(shell: Shell, project: Path, keep: Path, tmp_path: Path) -> None:
    assert shell("render", project, "-o", tmp_path / "out", "--after", f"'{keep}'") == 0
    assert shell.said == "kagezou: note: handed on to keep.py: 3 files\n"
    assert shell.out == f"{tmp_path / 'out' / 'Hero_shadow'}\n"
    assert kept(keep)["project"]["file"] == str(project)
    assert [each["frame"] for each in kept(keep)["files"]] == [1, 2, 3]


@pytest.mark.parametrize(
    ("words", "kind"),
    [
        (["render", "--layered"], "layered"),
        (["export-ae"], "after effects"),
        (["export-scene", "--for", "nuke"], "nuke"),
        (["farm"], "farm"),
    ],
)
def test_every_kind_is_handed_on(
    shell: Shell, project: Path, keep: Path, tmp_path: Path, words: list[str], kind: str
) -> None:
    verb, *options = words
    assert shell(verb, project, *options, "-o", tmp_path / "out", "--after", f"'{keep}'") == 0
    assert "handed on to keep.py" in shell.said
    assert kept(keep)["export"]["kind"] == kind


@pytest.mark.skipif(not is_there(), reason="PyAV is not installed")
def test_a_video_is_handed_on(
    shell: Shell, project: Path, keep: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv(COMMAND_VARIABLE, f"'{keep}'")
    assert shell("video", project, "-o", tmp_path / "a.mp4") == 0
    assert [each["kind"] for each in kept(keep)["files"]] == ["video"]


def test_a_hook_that_fails_is_code_9_and_the_export_stays(shell: Shell, project: Path, tmp_path: Path) -> None:
    failing = tmp_path / "fail.py"
    failing.write_text("import sys; sys.exit('no task for this shot')")
    assert shell("render", project, "-o", tmp_path / "out", "--json", "--after", f"'{failing}'") == 9
    assert json.loads(shell.out)["written"] == 3
    assert shell.said == ("kagezou: the export is whole, but fail.py failed with code 1: no task for this shot\n")
    assert len(list((tmp_path / "out" / "Hero_shadow").glob("*.png"))) == 3


@pytest.mark.skipif(os.name == "nt", reason="Ctrl-C is sent as a signal")
def test_ctrl_c_ends_what_hangs_and_the_export_stays(project: Path, tmp_path: Path) -> None:
    hanging = tmp_path / "hang.py"
    hanging.write_text("import pathlib, sys, time\npathlib.Path(sys.argv[0] + '.begun').touch()\ntime.sleep(600)\n")
    words = ["render", str(project), "-o", str(tmp_path / "out"), "--after", f"'{hanging}'"]
    process = subprocess.Popen([sys.executable, "-m", "kagezou", *words], stderr=subprocess.PIPE, text=True)
    while not hanging.with_name("hang.py.begun").exists():
        assert process.poll() is None
        time.sleep(0.02)
    process.send_signal(signal.SIGINT)
    _, said = process.communicate()
    assert (process.returncode, said) == (130, "kagezou: hang.py was stopped; the export is whole\n")
    assert len(list((tmp_path / "out" / "Hero_shadow").glob("*.png"))) == 3


def test_a_command_that_cannot_be_is_told_before_anything_is_made(
    shell: Shell, project: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert "has no end" in shell.fails(2, "render", project, "-o", tmp_path / "out", "--after", "publish 'x")
    assert not (tmp_path / "out").exists()
    monkeypatch.setenv(COMMAND_VARIABLE, f"{sys.executable} -c 'raise SystemExit(1)'")
    shell.ok("render", project, "-o", tmp_path / "out", "--after", "")


def test_the_doctor_names_what_is_the_studios(shell: Shell, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(COMMAND_VARIABLE, "publish --now")
    monkeypatch.setenv("KAGEZOU_STYLES", f"{tmp_path}{os.pathsep}{tmp_path / 'nowhere'}")
    monkeypatch.delenv("KAGEZOU_PRESETS", raising=False)
    report = shell.json("doctor", "--json")
    assert report["studio"]["KAGEZOU_STYLES"] == f"{tmp_path}, {tmp_path / 'nowhere'}"
    assert report["studio"]["KAGEZOU_PRESETS"] is None
    assert report["studio"]["after export"] == "publish"
    assert f"KAGEZOU_STYLES: {tmp_path / 'nowhere'}: it does not exist" in report["missing"]
