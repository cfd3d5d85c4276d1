"""Frames a second of an export, beside the floor: the same files read and written by the same threads, not drawn."""

import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from typing import Final

from kagezou.document.model import Document
from kagezou.export.frames import export_frames
from kagezou.export.planning import planned
from kagezou.export.request import ExportRequest
from kagezou.geometry.box import Box
from kagezou.io.files.atomic import write_bytes
from kagezou.io.images.reading import read_cel, read_matte
from kagezou.io.images.writing import ShadowImage, encode_png
from kagezou.picture_source import PictureSource
from kagezou.render.gpu.context import OpenContext

REPETITIONS: Final = 7


@dataclass(frozen=True, slots=True)
class Throughput:
    """Frames a second."""

    fps: float
    floor_fps: float

    @property
    def of_floor(self) -> float:
        """The export's part of what reading and writing alone allow."""
        return self.fps / self.floor_fps


@dataclass(frozen=True, slots=True, eq=False)
class _Piece:
    """The drawings that one picture is the first to need, the picture, and into how many files it goes."""

    sources: tuple[PictureSource, ...]
    shadow: ShadowImage
    files: int


def measured(
    document: Document,
    layers: tuple[str, ...],
    folder: Path,
    workers: int,
    open_context: OpenContext,
    repetitions: int = REPETITIONS,
) -> Throughput:
    """Export layers of a document several times into a folder, in turn with the floor, and return the medians.

    The export is a whole one, from opening OpenGL to the last file in its place.
    """
    length = document.canvas.length_frames
    request = ExportRequest(folder / "frames", layers=layers, workers=workers)
    export_frames(document, request, open_context, _unwatched, _never)
    pieces = _pieces(document, request)
    (folder / "floor").mkdir(exist_ok=True)
    floors: list[float] = []
    exports: list[float] = []
    for _ in range(repetitions):
        floors.append(_floor_seconds(pieces, folder / "floor", workers))
        started = time.perf_counter()
        export_frames(document, request, open_context, _unwatched, _never)
        exports.append(time.perf_counter() - started)
    return Throughput(length / median(exports), length / median(floors))


def _pieces(document: Document, request: ExportRequest) -> list[_Piece]:
    """Return what an export reads and writes, in its order: each drawing is read once, when it is first needed."""
    jobs = planned(document, request).jobs
    seen: set[PictureSource] = set()
    pieces: list[_Piece] = []
    for job in jobs:
        sources = tuple(source for source in job.content.sources.mattes if source not in seen)
        seen.update(sources)
        pieces.append(_Piece(sources, _shadow_in(job.targets[0].path), len(job.targets)))
    return pieces


def _floor_seconds(pieces: list[_Piece], folder: Path, workers: int) -> float:
    """Return how long it takes to decode each drawing once and to encode each shadow and write its files."""

    def job(index: int) -> None:
        piece = pieces[index]
        for source in piece.sources:
            read_matte(source)
        data = encode_png(piece.shadow)
        for number in range(piece.files):
            write_bytes(folder / f"{index + 1:04d}_{number}.png", data)

    started = time.perf_counter()
    with ThreadPoolExecutor(workers) as pool:
        list(pool.map(job, range(len(pieces))))
    return time.perf_counter() - started


def _shadow_in(path: Path) -> ShadowImage:
    """Return a written shadow as what it was written from."""
    cel = read_cel(path)
    matte = cel.matte
    red, green, blue = (int(part) for part in cel.rgba[0, 0, :3])
    box = matte.box or Box(0, 0, 0, 0)
    return ShadowImage(matte.width_px, matte.height_px, (red, green, blue), matte.alpha, box)


def _unwatched(done: int, total: int) -> None:
    """Show no progress."""


def _never() -> bool:
    return False
