"""The contact sheet: a row a character, a column a step, each unlike the one before."""

from itertools import pairwise
from pathlib import Path

import numpy as np

from kagezou.cli.contact_sheet import CELL_PX, STEP_NAMES
from kagezou.io.images.reading import read_cel
from tests.cli.projects import Shell, make_drawings

PITCH = CELL_PX + 6


def test_each_step_changes_the_picture(shell: Shell, tmp_path: Path) -> None:
    cels = make_drawings(tmp_path / "hero", 1, (160, 240))
    output = tmp_path / "sheet.png"
    said = shell.ok("sheet", "-o", output, "--character", f"A={cels}", "--character", f"B={cels}")
    assert said.strip() == ", ".join(STEP_NAMES)
    sheet = read_cel(output, white_is_clear=False).rgba.astype(int)
    assert sheet.shape == (2 * PITCH - 6, len(STEP_NAMES) * PITCH - 6, 4)
    cells = [sheet[:CELL_PX, left : left + CELL_PX] for left in range(0, sheet.shape[1], PITCH)]
    assert all(np.abs(before - after).max() > 20 for before, after in pairwise(cells))
    assert np.array_equal(sheet[:CELL_PX], sheet[PITCH : PITCH + CELL_PX])


def test_samples_fill_a_sheet(shell: Shell, samples: Path, tmp_path: Path) -> None:
    kid = samples / "synfig_prologue_kid" / "A"
    shell.ok("sheet", "-o", tmp_path / "kid.png", "--character", f"Kid={kid}")
    sheet = read_cel(tmp_path / "kid.png", white_is_clear=False).rgba.astype(int)
    assert sheet.shape == (CELL_PX, len(STEP_NAMES) * PITCH - 6, 4)


def test_what_cannot_be_drawn_is_one_line(shell: Shell, tmp_path: Path) -> None:
    shell.fails(2, "sheet", "-o", tmp_path / "x.png")
    shell.fails(3, "sheet", "-o", tmp_path / "x.png", "--character", "A=/nowhere")
