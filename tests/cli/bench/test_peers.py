"""What other programs take for the same is found, timed as whole processes, and told."""

import shutil
import sys
from pathlib import Path

import numpy as np
import pytest

from kagezou.cli.bench import peers
from kagezou.cli.bench.peers import Peer, compared
from kagezou.errors import OutputProblem, UsageProblem
from kagezou.io.images.reading import read_cel
from tests.io.images import picture_files as files


@pytest.fixture
def drawings(tmp_path: Path) -> Path:
    folder = tmp_path / "drawings"
    folder.mkdir()
    for number in range(1, 3):
        pixels = np.zeros((120, 160, 4), np.uint8)
        pixels[20:110, 60 + number : 100] = (200, 30, 30, 255)
        files.save(folder / f"a_{number:04d}.png", pixels)
    return folder


@pytest.mark.skipif(shutil.which("ffmpeg") is None, reason="ffmpeg is not installed")
def test_ffmpeg_makes_the_same_shadow_and_is_timed(drawings: Path, tmp_path: Path) -> None:
    work = tmp_path / "work"
    work.mkdir()
    found, missing = compared(drawings, work, pairs=1)
    assert "ffmpeg" not in missing
    ratio = next(each for each in found if each.name == "ffmpeg")
    assert ratio.wall > 0
    assert ratio.cpu is None or ratio.cpu > 0
    ours = read_cel(next((work / "ours").glob("*/*_0001.png"))).rgba[..., 3] > 76
    theirs = read_cel(work / "ffmpeg/0001.png").rgba[..., 3] > 76
    assert ours.any()
    assert (ours & theirs).sum() / (ours | theirs).sum() > 0.7


def test_what_is_not_installed_is_named(drawings: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("shutil.which", lambda _: None)
    monkeypatch.setattr("importlib.util.find_spec", lambda _: None)
    assert compared(drawings, tmp_path) == ((), ("ffmpeg", "OpenCV"))


def test_other_drawings_are_refused(tmp_path: Path) -> None:
    folder = tmp_path / "other"
    folder.mkdir()
    with pytest.raises(UsageProblem):
        compared(folder, tmp_path)
    files.save(folder / "a.tif", np.zeros((4, 4, 4), np.uint8))
    with pytest.raises(UsageProblem):
        compared(folder, tmp_path)


def test_ratios_are_ours_over_theirs() -> None:
    slow = Peer("slow", (sys.executable, "-c", "sum(range(3_000_000))"))
    quick = Peer("quick", (sys.executable, "-S", "-c", "pass"))
    ratio = peers._against(slow, quick, 1)
    assert ratio.name == "quick"
    assert ratio.wall > 1


def test_a_program_that_fails_is_told() -> None:
    with pytest.raises(OutputProblem, match="it broke"):
        peers._taken(Peer("x", (sys.executable, "-c", "import sys; sys.exit('it broke')")))
    with pytest.raises(OutputProblem):
        peers._taken(Peer("x", ("/nowhere/at/all",)))
