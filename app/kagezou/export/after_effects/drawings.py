"""The characters' drawings as footage: a gap-free copy of each layer, or the files where they lie."""

import re
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from itertools import repeat
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray

from kagezou.document.model import Canvas, Drawing, Layer
from kagezou.export.names import digits_for
from kagezou.io.files.atomic import write_bytes
from kagezou.io.files.faults import input_problem
from kagezou.io.images.reading import ImageInfo, probe, read_cel
from kagezou.io.images.writing import write_rgba

_NUMBERED: Final = re.compile(r"(.*?)([0-9]+)(\.[A-Za-z0-9]+)")
_READ_BY_AFTER_EFFECTS: Final = frozenset({".png", ".tga", ".tif", ".tiff", ".exr"})


@dataclass(frozen=True, slots=True)
class CelFootage:
    """A layer's drawings on disk.

    Parameters
    ----------
    first
        The first file of the gap-free sequence.
    count
        How many files there are.
    places
        Drawing's index in the layer → picture of the sequence, from 0.
    """

    first: Path
    count: int
    places: dict[int, int]


def exposed(layer: Layer, length: int) -> tuple[int, ...]:
    """Return the indices of the drawings that are seen within the cut, in the order of their first exposure."""
    seen = (each.drawing for each in layer.cels.exposures if each.frame <= length and each.drawing is not None)
    return tuple(dict.fromkeys(seen))


def referenced(layer: Layer, length: int) -> CelFootage | None:
    """Return the drawings where they lie, None where their files are no gap-free sequence that can be imported."""
    indices = exposed(layer, length)
    paths = [layer.cels.drawings[index].path for index in indices]
    found = [_NUMBERED.fullmatch(path.name) for path in paths]
    parts = {(path.parent, each[1], each[3], len(each[2])) for path, each in zip(paths, found, strict=True) if each}
    if not paths or None in found or len(parts) != 1 or paths[0].suffix.lower() not in _READ_BY_AFTER_EFFECTS:
        return None
    folder, prefix, suffix, digits = next(iter(parts))
    numbers = sorted(_numbers_in(folder, prefix, suffix, digits))
    if not numbers or numbers != list(range(numbers[0], numbers[0] + len(numbers))):
        return None
    places = {index: int(each[2]) - numbers[0] for index, each in zip(indices, found, strict=True) if each is not None}
    if len({(info.width_px, info.height_px) for info in map(probe, paths)}) != 1 or not have_alpha(layer, length):
        return None
    return CelFootage(folder / f"{prefix}{numbers[0]:0{digits}d}{suffix}", len(numbers), places)


def have_alpha(layer: Layer, length: int) -> bool:
    """Return whether all drawings that are seen have alpha; of others After Effects would show the white as well."""
    return all(probe(layer.cels.drawings[index].source).has_alpha for index in exposed(layer, length))


def are_within(layer: Layer, folder: Path) -> bool:
    """Return whether drawings of a layer lie in ``folder`` themselves, as those of an earlier hand-off do."""
    real = folder.resolve()
    return any(drawing.path.parent.resolve() == real for drawing in layer.cels.drawings)


def copied(layer: Layer, name: str, folder: Path, canvas: Canvas, workers: int) -> CelFootage | None:
    """Copy the drawings of a layer as ``NAME_0001.png`` and so on into ``folder``; None where none is ever seen.

    A PNG that can stay as it is is copied byte for byte. Others become PNG; where the sizes differ, which After
    Effects would stretch alike, all become as large as the canvas.

    Raises
    ------
    InputProblem
        A drawing cannot be read.
    DiskFullProblem, OutputProblem
        A copy cannot be written.
    """
    indices = exposed(layer, canvas.length_frames)
    if not indices:
        return None
    drawings = [layer.cels.drawings[index] for index in indices]
    infos = [probe(drawing.source) for drawing in drawings]
    alike = len({(info.width_px, info.height_px) for info in infos}) == 1
    size = None if alike else (canvas.width_px, canvas.height_px)
    digits = digits_for(len(indices))
    targets = [folder / f"{name}_{number:0{digits}d}.png" for number in range(1, len(indices) + 1)]
    with ThreadPoolExecutor(workers) as pool:
        list(pool.map(_copy, drawings, infos, targets, repeat(size)))
    remove_beyond(folder, name, digits, len(indices))
    return CelFootage(targets[0], len(indices), {index: place for place, index in enumerate(indices)})


def remove_beyond(folder: Path, name: str, digits: int, count: int) -> None:
    """Remove files of an earlier, longer hand-off: After Effects takes every number that follows on."""
    for path in folder.iterdir():
        found = re.fullmatch(re.escape(name) + r"_([0-9]+)\.[a-z]+", path.name)
        if found and len(found[1]) == digits and int(found[1]) > count:
            path.unlink()


def _numbers_in(folder: Path, prefix: str, suffix: str, digits: int) -> set[int]:
    found = (_NUMBERED.fullmatch(path.name) for path in folder.iterdir())
    return {int(each[2]) for each in found if each and (each[1], each[3], len(each[2])) == (prefix, suffix, digits)}


def _copy(drawing: Drawing, info: ImageInfo, target: Path, size: tuple[int, int] | None) -> None:
    if drawing.path.suffix.lower() == ".png" and info.has_alpha and size is None:
        try:
            write_bytes(target, drawing.path.read_bytes())
        except OSError as error:
            raise input_problem(drawing.path, error) from error
        return
    rgba = read_cel(drawing.source).rgba
    write_rgba(target, rgba if size is None else _centred(rgba, *size))


def _centred(rgba: NDArray[np.generic], width_px: int, height_px: int) -> NDArray[np.generic]:
    """Return a picture cut or padded to a size about its middle, as the canvas shows it."""
    made = np.zeros((height_px, width_px, 4), rgba.dtype)
    height, width = rgba.shape[:2]
    left, top = (width_px - width) // 2, (height_px - height) // 2
    x, y = max(left, 0), max(top, 0)
    part = rgba[y - top : height_px - top, x - left : width_px - left]
    made[y : y + part.shape[0], x : x + part.shape[1]] = part
    return made
