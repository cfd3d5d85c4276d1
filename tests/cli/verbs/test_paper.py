"""The paper of drawings without alpha, from the command line: chosen, shown and changed."""

import json
from pathlib import Path

import numpy as np
from PIL import Image

from kagezou.io.images.reading import read_cel
from tests.cli.projects import Shell


def drawn(folder: Path, *, shirt: int) -> Path:
    pixels = np.full((48, 64, 3), 255, np.uint8)
    pixels[8:40, 26:38] = (190, 120, 60)
    pixels[14 : 14 + shirt, 28:36] = 255
    folder.mkdir()
    Image.fromarray(pixels).save(folder / "a_0001.png")
    return folder


def alphas(shell: Shell, project: Path, folder: Path) -> int:
    """Return how much the shadow covers."""
    shell.ok("render", project, "-o", folder)
    return int(read_cel(folder / "A_shadow" / "A_shadow_0001.png").rgba[..., 3].astype(int).sum())


def test_the_paper_is_chosen_and_can_be_changed(shell: Shell, tmp_path: Path) -> None:
    project = tmp_path / "a.kage"
    assert shell("new", project, "--character", f"A={drawn(tmp_path / 'A', shirt=14)}") == 0
    assert "A: its drawings have no alpha; white inside their outlines stays" in shell.said
    assert shell.json("get", project, "layers.A.paper") == "border"
    whole = alphas(shell, project, tmp_path / "1")
    shell.ok("set", project, "layers.A.paper=white")
    assert "paper" not in json.loads(project.read_text())["layers"][0]
    assert shell.json("get", project, "layers.A.paper", "--json")["value"] == "white"
    assert alphas(shell, project, tmp_path / "2") < 0.9 * whole
    shell.ok("set", project, 'layers.A.paper="border"')
    assert alphas(shell, project, tmp_path / "3") == whole


def test_it_has_no_keys_and_two_words(shell: Shell, tmp_path: Path) -> None:
    project = tmp_path / "a.kage"
    assert shell("new", project, "--character", f"A={drawn(tmp_path / 'A', shirt=0)}") == 0
    assert "A: its drawings have no alpha; pure white is taken as clear" in shell.said
    before = project.read_bytes()
    assert "has no keys" in shell.fails(2, "set", project, "layers.A.paper=border", "--frame", 1)
    assert "one of white, border" in shell.fails(2, "set", project, "layers.A.paper=blue")
    assert project.read_bytes() == before
