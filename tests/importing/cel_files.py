"""Drawings as files: black figures of full alpha on a clear ground."""

from pathlib import Path

import numpy as np

from kagezou.io.images.writing import write_rgba

Part = tuple[int, int, int, int]
"""Left, top, right, bottom, px."""


def write_cel(path: Path, size: tuple[int, int], *parts: Part) -> Path:
    """Write a drawing that is solid in some boxes."""
    rgba = np.zeros((size[1], size[0], 4), np.uint8)
    for left, top, right, bottom in parts:
        rgba[top:bottom, left:right, 3] = 255
    path.parent.mkdir(parents=True, exist_ok=True)
    write_rgba(path, rgba)
    return path


def write_walk(folder: Path, numbers: list[int], size: tuple[int, int] = (400, 300)) -> Path:
    """Write a numbered sequence of a figure 40 px wide and 150 px high, with two legs, that moves right."""
    for number in numbers:
        x = 150 + number
        body, one_leg, other_leg = (x, 100, x + 40, 200), (x, 200, x + 10, 250), (x + 30, 200, x + 40, 248)
        write_cel(folder / f"{folder.name}_{number:04}.png", size, body, one_leg, other_leg)
    return folder
