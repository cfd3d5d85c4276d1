"""How an export grows: with the frames, the layers and the pixels of a cut, with cuts, and with workers on one folder.

Each is measured at three sizes as whole processes, so that start and end are counted as whoever waits counts them.
"""

from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path
from time import perf_counter
from typing import Final

from kagezou.cli.bench.whole_processes import Spent, taken
from kagezou.document.address import Address, resolve
from kagezou.document.edits import set_canvas, set_constant, set_key
from kagezou.document.model import Document
from kagezou.document.properties import OF_LAYER
from kagezou.importing.staging import CharacterSource, new_document
from kagezou.io.project.file import save
from kagezou.own_process import program_words

Told = Callable[[int, int], None]
"""Takes how many of how many measurements are done."""

_SIZE_PX: Final = (960, 540)
_NAME: Final = "kagezou"


@dataclass(frozen=True, slots=True)
class Sizes:
    """What is measured at growing sizes.

    Parameters
    ----------
    frames, layers
        So many frames of one layer, and so many layers of a few frames.
    widths_px
        Canvases of these widths, 16:9.
    cuts
        So many cuts in one batch.
    workers
        So many processes on one folder, each with its part of the frames.
    """

    frames: tuple[int, ...] = (500, 1000, 2000)
    layers: tuple[int, ...] = (15, 30, 60)
    widths_px: tuple[int, ...] = (960, 1920, 3840)
    cuts: tuple[int, ...] = (2, 4, 8)
    workers: tuple[int, ...] = (1, 2)
    few: int = 12
    shared: int = 240


@dataclass(frozen=True, slots=True)
class Grown:
    """What some sizes of one thing took, upward."""

    name: str
    sizes: tuple[int, ...]
    took: tuple[Spent, ...]

    @property
    def times(self) -> float:
        """How many times as long the largest took as the smallest."""
        return self.took[-1].wall_s / self.took[0].wall_s

    @property
    def memory(self) -> float:
        """How many times as much memory; 1 where the system does not tell."""
        return self.took[-1].peak_bytes / self.took[0].peak_bytes if self.took[0].peak_bytes else 1.0


def grown(drawings: Path, folder: Path, told: Told, sizes: Sizes | None = None) -> Iterator[Grown]:
    """Yield how an export of some drawings grows.

    Parameters
    ----------
    drawings
        A folder of numbered drawings of one figure.
    folder
        Where projects and frames may be written.
    told
        Told how far it is.
    sizes
        What is measured; None for the usual.

    Raises
    ------
    OutputProblem
        The program failed.
    """
    asked = Sizes() if sizes is None else sizes
    counts = [asked.frames, asked.layers, asked.widths_px, asked.cuts, asked.workers]
    steps, done = sum(map(len, counts)), 0

    def each(name: str, of: tuple[int, ...], measure: Callable[[Path, int], Spent]) -> Grown:
        nonlocal done
        took: list[Spent] = []
        for size in of:
            told(done, steps)
            place = folder / f"{name}-{size}".replace(" ", "-")
            place.mkdir()
            took.append(measure(place, size))
            done += 1
        told(done, steps)
        return Grown(name, of, tuple(took))

    def frames(place: Path, count: int) -> Spent:
        return _rendered(place, _cut(drawings, count))

    def layers(place: Path, count: int) -> Spent:
        return _rendered(place, _cut(drawings, asked.few, count))

    def widths(place: Path, width: int) -> Spent:
        return _rendered(place, _cut(drawings, asked.few, size_px=(width, width * 9 // 16)))

    def cuts(place: Path, count: int) -> Spent:
        return _batch(place, drawings, count)

    def workers(place: Path, count: int) -> Spent:
        return _on_one_folder(place, _cut(drawings, asked.shared), count)

    yield each("frames", asked.frames, frames)
    yield each("layers", asked.layers, layers)
    yield each("px wide", asked.widths_px, widths)
    yield each("cuts", asked.cuts, cuts)
    yield each("workers", asked.workers, workers)


def _cut(drawings: Path, frames: int, layers: int = 1, size_px: tuple[int, int] = _SIZE_PX) -> Document:
    """Return a cut of which no two pictures are equal: its sun goes around figures that stand apart."""
    sources = [CharacterSource(f"Figure {number}", drawings) for number in range(1, layers + 1)]
    document = new_document(sources, size=size_px).document
    document = set_canvas(document, replace(document.canvas, length_frames=frames))
    document = set_constant(document, resolve(document, "light.kind"), "sun")
    for number, layer in enumerate(document.layers):
        document = set_constant(document, Address(OF_LAYER["position"], layer.id), [4.0 * number, 0.0])
    for frame, degrees in ((1, -40.0), (frames, 40.0)):
        document = set_key(document, resolve(document, "light.azimuth"), frame, degrees)
    return document


def _rendered(place: Path, document: Document) -> Spent:
    save(document, place / "cut.kage")
    return taken(_NAME, (*program_words(), "render", str(place / "cut.kage"), "-o", str(place / "out")))


def _batch(place: Path, drawings: Path, count: int) -> Spent:
    """Make so many cuts of the same drawings, each a folder of links."""
    for number in range(1, count + 1):
        column = place / "episode" / f"c{number:03d}" / "A"
        column.mkdir(parents=True)
        for drawing in sorted(drawings.iterdir()):
            (column / drawing.name).hardlink_to(drawing)
    return taken(_NAME, (*program_words(), "auto", str(place / "episode"), "-o", str(place / "out")))


def _on_one_folder(place: Path, document: Document, count: int) -> Spent:
    """Have so many programs of one worker each make their part of the frames, all at a time, as a farm has."""
    save(document, place / "cut.kage")
    length = document.canvas.length_frames
    words = (*program_words(), "render", str(place / "cut.kage"), "-o", str(place / "out"), "--workers", "1")
    bounds = [length * number // count for number in range(count + 1)]
    parts = [f"{first + 1}-{end}" for first, end in pairwise(bounds)]
    started = perf_counter()
    with ThreadPoolExecutor(count) as pool:
        every = list(pool.map(lambda frames: taken(_NAME, (*words, "--frames", frames)), parts))
    wall_s = perf_counter() - started
    return Spent(wall_s, sum(each.cpu_s for each in every), sum(each.peak_bytes for each in every))
