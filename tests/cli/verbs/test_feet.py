"""Feet from the command line: found, kept, listed."""

from pathlib import Path

import numpy as np
import pytest

from kagezou.io.images.writing import write_rgba
from tests.cli.projects import Shell


@pytest.fixture
def jumper(tmp_path: Path) -> Path:
    """A figure on two legs that jumps, ten drawings."""
    folder = tmp_path / "jumper"
    folder.mkdir()
    for number, up in enumerate((0, 0, 0, 30, 55, 55, 30, 0, 0, 0), start=1):
        rgba = np.zeros((400, 300, 4), np.uint8)
        rgba[100 - up : 280 - up, 100:200] = (60, 110, 190, 255)
        for left in (108, 170):
            rgba[280 - up : 360 - up, left : left + 24] = (70, 60, 50, 255)
        write_rgba(folder / f"jump_{number:04d}.png", rgba)
    return folder


def test_new_finds_feet_and_feet_lists_them(shell: Shell, jumper: Path, tmp_path: Path) -> None:
    path = tmp_path / "p.kage"
    assert shell("new", path, "--character", f"Hero={jumper}") == 0
    stances = shell.json("feet", path, "--list", "--json")["Hero"]
    assert [stance["frame"] for stance in stances if stance["lift_px"] > 0] == [4, 5, 6, 7]
    assert max(stance["lift_px"] for stance in stances) == pytest.approx(55, abs=1)
    assert all(len(stance["feet"]) == 2 for stance in stances)
    lines = shell.ok("feet", path, "--list").splitlines()
    assert "in the air, 55 px high" in lines[4]
    assert lines[0].startswith("Hero 1: (")


def test_without_feet_the_ground_line_is_kept_until_they_are_looked_for(
    shell: Shell, jumper: Path, tmp_path: Path
) -> None:
    path = tmp_path / "p.kage"
    shell.ok("new", path, "--character", f"Hero={jumper}", "--no-feet")
    assert shell.ok("feet", path, "--list").strip() == "Hero: no feet"
    before = path.read_bytes()
    assert shell("feet", path, "--layer", "Hero") == 0
    assert path.read_bytes() != before
    assert shell("feet", path) == 0
    assert "Nobody" in shell.fails(2, "feet", path, "--layer", "Nobody")


def test_a_figure_without_feet_is_told_once(shell: Shell, tmp_path: Path) -> None:
    folder = tmp_path / "hem"
    folder.mkdir()
    for number in (1, 2):
        rgba = np.zeros((200, 200, 4), np.uint8)
        rgba[60:180, 30:170] = 255
        write_rgba(folder / f"hem_{number}.png", rgba)
    assert shell("new", tmp_path / "p.kage", "--character", f"Hero={folder}") == 0
    assert shell.said.count("no feet were found") == 1


def test_in_a_jump_the_shadow_keeps_to_the_ground(shell: Shell, jumper: Path, tmp_path: Path) -> None:
    path = tmp_path / "p.kage"
    shell("new", path, "--character", f"Hero={jumper}", "--size", "600x500")
    shell.ok("render", path, "-o", tmp_path / "out")
    from kagezou.io.images.reading import read_cel

    alphas = [
        read_cel(each).rgba[..., 3].astype(float) for each in sorted((tmp_path / "out" / "Hero_shadow").iterdir())
    ]
    sums = [float(alpha.sum()) for alpha in alphas]
    assert sums[3] < sums[2]
    assert sums[4] < sums[3]
    assert sums[6] > sums[5]
    assert sums[9] == pytest.approx(sums[0], rel=1e-3)
