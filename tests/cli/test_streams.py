"""Streams that whoever started the program has closed."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

posix = pytest.mark.skipif(os.name != "posix", reason="a shell closes streams so")


def shell(words: str, *, cwd: Path) -> subprocess.CompletedProcess[str]:
    program = f"'{sys.executable}' -m kagezou"
    return subprocess.run(
        ["sh", "-c", words.replace("kagezou", program, 1)], cwd=cwd, capture_output=True, text=True, check=False
    )


@posix
@pytest.mark.parametrize("closed", ["2>&-", ">&-", "<&-", ">&- 2>&-", "<&- >&- 2>&-"])
def test_frames_are_made_whatever_is_closed(project: Path, closed: str) -> None:
    done = shell(f"kagezou render '{project}' -o out --frames 1-2 {closed}", cwd=project.parent)
    assert (done.returncode, done.stderr) == (0, "")
    frames = sorted((project.parent / "out" / "Hero_shadow").glob("*.png"))
    assert len(frames) == 2
    assert all(path.read_bytes()[:4] == b"\x89PNG" for path in frames)


@posix
def test_a_problem_ends_with_its_code_whatever_is_closed(tmp_path: Path) -> None:
    assert shell("kagezou info nothing.kage 2>&-", cwd=tmp_path).returncode == 7
    said = shell("kagezou info nothing.kage >&-", cwd=tmp_path)
    assert said.returncode == 7
    assert said.stderr.startswith("kagezou: ")
    assert shell("kagezou --version >&- 2>&-", cwd=tmp_path).returncode == 0
