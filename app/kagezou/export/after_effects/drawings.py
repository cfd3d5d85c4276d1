"""Drawings of a layer or the background as footage: a gap-free copy, or the files where they lie."""

import re
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from itertools import repeat
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray

from kagezou.document.model import Canvas, Cels, Drawing
from kagezou.errors import Stopped
from kagezou.export.file_names import NumberedName
from kagezou.export.names import digits_for
from kagezou.geometry.box import centred_offset
from kagezou.io.files.atomic import write_bytes
from kagezou.io.files.faults import input_problem
from kagezou.io.files.folders import entries_to_read, entries_to_write
from kagezou.io.files.small_files import remove_file
from kagezou.io.images.reading import ImageInfo, probe, read_cel
from kagezou.io.images.writing import write_rgba
from kagezou.io.pixels.signatures import is_psd

_NUMBERED: Final = re.compile(r"(.*?)([0-9]+)(\.[A-Za-z0-9]+)")
_READ_BY_AFTER_EFFECTS: Final = frozenset({".png", ".tga", ".tif", ".tiff", ".exr"})


Step = Callable[[], bool]
"""Called on the asking thread when a file is copied; returns whether to go on."""


@dataclass(frozen=True, slots=True)
class CelFootage:
    """The drawings of a layer or the background on disk.

    Parameters
    ----------
    first
        The first file of the gap-free sequence.
    count
        How many files there are.
    places
        Drawing's index among the cels → picture of the sequence, from 0.
    size_px
        Width and height of each file.
    """

    first: Path
    count: int
    places: dict[int, int]
    size_px: tuple[int, int]


@dataclass(frozen=True, slots=True)
class Copying:
    """How drawings are copied.

    Parameters
    ----------
    canvas
        On which they lie.
    is_moved
        Whether something moves them, so that what reaches beyond the canvas may come to be seen.
    white_is_clear
        Whether white is clear in a drawing without alpha; in a background it is white.
    workers
        How many are copied at a time.
    """

    canvas: Canvas
    is_moved: bool = False
    white_is_clear: bool = True
    workers: int = 2


def exposed(cels: Cels, length: int) -> tuple[int, ...]:
    """Return the indices of the drawings that are seen within the cut, in the order of their first exposure."""
    seen = (each.drawing for each in cels.exposures if each.frame <= length and each.drawing is not None)
    return tuple(dict.fromkeys(seen))


def referenced(cels: Cels, length: int, *, white_is_clear: bool = True) -> CelFootage | None:
    """Return the drawings where they lie, None where their files are no gap-free sequence that can be imported."""
    indices = exposed(cels, length)
    paths = [cels.drawings[index].path for index in indices]
    found = [_NUMBERED.fullmatch(path.name) for path in paths]
    parts = {(path.parent, each[1], each[3], len(each[2])) for path, each in zip(paths, found, strict=True) if each}
    if any(cels.drawings[index].part is not None for index in indices):
        return None
    if not paths or None in found or len(parts) != 1 or paths[0].suffix.lower() not in _READ_BY_AFTER_EFFECTS:
        return None
    folder, prefix, suffix, digits = next(iter(parts))
    numbers = sorted(_numbers_in(folder, prefix, suffix, digits))
    if not numbers or numbers != list(range(numbers[0], numbers[0] + len(numbers))):
        return None
    places = {index: int(each[2]) - numbers[0] for index, each in zip(indices, found, strict=True) if each is not None}
    sizes = {(info.width_px, info.height_px) for info in map(probe, paths)}
    if len(sizes) != 1 or (white_is_clear and not have_alpha(cels, length)):
        return None
    return CelFootage(folder / f"{prefix}{numbers[0]:0{digits}d}{suffix}", len(numbers), places, next(iter(sizes)))


def have_alpha(cels: Cels, length: int) -> bool:
    """Return whether all drawings that are seen have alpha; of others After Effects would show the white as well."""
    return all(probe(cels.drawings[index].source).has_alpha for index in exposed(cels, length))


def are_within(cels: Cels, folder: Path) -> bool:
    """Return whether drawings lie in ``folder`` themselves, as those of an earlier hand-off do."""
    real = folder.resolve()
    return any(drawing.path.parent.resolve() == real for drawing in cels.drawings)


def copied(cels: Cels, name: str, folder: Path, copying: Copying, step: Step) -> CelFootage | None:
    """Copy drawings as ``NAME_0001.png`` and so on into ``folder``; None where none is ever seen.

    A PNG that can stay as it is is copied byte for byte. Others become PNG; where the sizes differ, which After
    Effects would stretch alike, all become as large as the canvas, or where they are moved as the largest if need be.

    Raises
    ------
    Stopped
        ``step`` said so; the copies that were in hand are finished and told to it too.
    InputProblem
        A drawing cannot be read.
    DiskFullProblem, OutputProblem
        A copy cannot be written.
    """
    indices = exposed(cels, copying.canvas.length_frames)
    if not indices:
        return None
    drawings = [cels.drawings[index] for index in indices]
    infos = [probe(drawing.source) for drawing in drawings]
    size = _size_of(infos, copying)
    names = NumberedName(folder, f"{name}_", ".png", digits_for(len(indices)))
    targets = [names.file(number) for number in range(1, len(indices) + 1)]
    pool = ThreadPoolExecutor(copying.workers)
    try:
        work = zip(drawings, infos, targets, repeat(size), repeat(copying), strict=False)
        _counted([pool.submit(_copy, *each) for each in work], step)
    finally:
        pool.shutdown(wait=True, cancel_futures=True)
    remove_beyond(names, len(indices))
    return CelFootage(targets[0], len(indices), {index: place for place, index in enumerate(indices)}, size)


def still_where_it_lies(cels: Cels, length: int) -> CelFootage | None:
    """Return the one picture that is seen of all where it lies, None where it is in a file of several."""
    (index,) = exposed(cels, length)
    path = cels.drawings[index].path
    if is_psd(path) or cels.drawings[index].part is not None:
        return None
    info = probe(path)
    return CelFootage(path, 1, {index: 0}, (info.width_px, info.height_px))


def copied_still(cels: Cels, target: Path, copying: Copying, step: Step) -> CelFootage:
    """Copy the one picture that is seen of all to ``target``; raises as `copied`."""
    (index,) = exposed(cels, copying.canvas.length_frames)
    info = probe(cels.drawings[index].source)
    size = (info.width_px, info.height_px)
    _copy(cels.drawings[index], info, target, size, copying)
    if not step():
        raise Stopped
    return CelFootage(target, 1, {index: 0}, size)


def remove_beyond(name: NumberedName, count: int) -> None:
    """Remove files of an earlier, longer hand-off: After Effects takes every number that follows on."""
    for path in entries_to_write(name.folder):
        found = re.fullmatch(re.escape(name.before) + r"([0-9]+)\.[a-z]+", path.name)
        if found and len(found[1]) == name.digits and int(found[1]) > count:
            remove_file(path)


def _numbers_in(folder: Path, prefix: str, suffix: str, digits: int) -> set[int]:
    found = (_NUMBERED.fullmatch(path.name) for path in entries_to_read(folder))
    return {int(each[2]) for each in found if each and (each[1], each[3], len(each[2])) == (prefix, suffix, digits)}


def _size_of(infos: list[ImageInfo], copying: Copying) -> tuple[int, int]:
    """Return how large all copies become: as they are, or where their sizes differ as the canvas, or larger."""
    sizes = {(info.width_px, info.height_px) for info in infos}
    if len(sizes) == 1:
        return next(iter(sizes))
    canvas = (copying.canvas.width_px, copying.canvas.height_px)
    if not copying.is_moved:
        return canvas
    widths, heights = zip(canvas, *sizes, strict=True)
    return (max(widths), max(heights))


def _counted(copies: list[Future[None]], step: Step) -> None:
    """Wait for copies and tell each; Stopped where a step said so."""
    is_stopped = False
    for each in copies:
        if each.cancelled():
            continue
        each.result()
        if not step():
            is_stopped = True
            # Those under way cannot be cancelled any more, and are counted when they are done.
            for rest in copies:
                rest.cancel()
    if is_stopped:
        raise Stopped


def _copy(drawing: Drawing, info: ImageInfo, target: Path, size: tuple[int, int], copying: Copying) -> None:
    is_alike = (info.width_px, info.height_px) == size
    is_png = drawing.part is None and drawing.path.suffix.lower() == ".png"
    if is_png and is_alike and (info.has_alpha or not copying.white_is_clear):
        try:
            write_bytes(target, drawing.path.read_bytes())
        except OSError as error:
            raise input_problem(drawing.path, error) from error
        return
    rgba = read_cel(drawing.source, white_is_clear=copying.white_is_clear).rgba
    write_rgba(target, rgba if is_alike else _centred(rgba, size, copying.canvas))


def _centred(rgba: NDArray[np.generic], size: tuple[int, int], canvas: Canvas) -> NDArray[np.generic]:
    """Return a picture cut or padded to a size, so that it lies on the canvas as it does alone, to the pixel."""
    made = np.zeros((size[1], size[0], 4), rgba.dtype)
    height, width = rgba.shape[:2]
    own, whole = centred_offset(canvas.box, width, height), centred_offset(canvas.box, *size)
    left, top = own[0] - whole[0], own[1] - whole[1]
    x, y = max(left, 0), max(top, 0)
    part = rgba[y - top : size[1] - top, x - left : size[0] - left]
    made[y : y + part.shape[0], x : x + part.shape[1]] = part
    return made
