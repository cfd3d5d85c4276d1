"""Small folders of cuts."""

from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from kagezou.io.images.writing import write_rgba
from kagezou.io.sheets.timesheet import SheetTrack, Timesheet
from kagezou.io.sheets.xdts_writing import write_xdts

SIZE = (64, 48)


def picture(path: Path, left: int = 20, *, fill: bool = False) -> Path:
    """Draw a block that stands on the lower third; or one that fills the picture."""
    path.parent.mkdir(parents=True, exist_ok=True)
    width, height = SIZE
    pixels = np.zeros((height, width, 4), np.uint8)
    if fill:
        pixels[:] = (90, 120, 90, 255)
    else:
        pixels[height // 3 : height * 5 // 6, left : left + width // 6] = (200, 120, 40, 255)
    write_rgba(path, pixels)
    return path


def drawings(folder: Path, count: int = 3) -> Path:
    """Draw a block that walks to the right, in numbered files."""
    for number in range(1, count + 1):
        picture(folder / f"walk_{number:04d}.png", 18 + 2 * number)
    return folder


def timesheet(path: Path, columns: Mapping[str, Sequence[tuple[int, int]]], length: int = 6) -> Path:
    """Write a timesheet: for each column frames, from 1, and the drawings from there on."""
    tracks = tuple(
        SheetTrack(name, tuple((frame - 1, str(drawing)) for frame, drawing in entries))
        for name, entries in columns.items()
    )
    path.parent.mkdir(parents=True, exist_ok=True)
    write_xdts(path, Timesheet(path.stem, length, tracks))
    return path
