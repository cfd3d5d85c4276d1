"""Frames a second of an export, beside the floor: the same files read and written by the same threads, not drawn."""

import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from typing import Final

from kagezou.document.model import Document, PictureSource
from kagezou.export.frames import export_frames
from kagezou.export.request import ExportRequest
from kagezou.geometry.box import Box
from kagezou.io.atomic import write_bytes
from kagezou.io.encode import ShadowImage, encode_png
from kagezou.io.images import read_cel, read_matte
from kagezou.render.context import OpenContext

REPETITIONS: Final = 3


@dataclass(frozen=True, slots=True)
class Throughput:
    """Frames a second."""

    fps: float
    floor_fps: float

    @property
    def of_floor(self) -> float:
        """The export's part of what reading and writing alone allow."""
        return self.fps / self.floor_fps


def measured(
    document: Document, folder: Path, workers: int, open_context: OpenContext, repetitions: int = REPETITIONS
) -> Throughput:
    """Export a document's first layer several times into a folder, in turn with the floor, and return the medians.

    The export is a whole one, from opening OpenGL to the last file in its place.
    """
    layer = document.layers[0]
    request = ExportRequest(folder / "frames", layers=(layer.name,), workers=workers)
    sources = [layer.cels.drawing_at(frame) for frame in range(1, document.canvas.length_frames + 1)]
    export_frames(document, request, open_context, _unwatched, _never)
    outputs = sorted(next((folder / "frames").glob("*_shadow")).glob("*.png"))
    pairs = [
        (drawing.source, _shadow_in(output))
        for drawing, output in zip(sources, outputs, strict=True)
        if drawing is not None
    ]
    (folder / "floor").mkdir(exist_ok=True)
    floors: list[float] = []
    exports: list[float] = []
    for _ in range(repetitions):
        floors.append(_floor_seconds(pairs, folder / "floor", workers))
        started = time.perf_counter()
        export_frames(document, request, open_context, _unwatched, _never)
        exports.append(time.perf_counter() - started)
    return Throughput(len(outputs) / median(exports), len(pairs) / median(floors))


def _floor_seconds(pairs: list[tuple[PictureSource, ShadowImage]], folder: Path, workers: int) -> float:
    """Return how long it takes to decode each drawing and to encode and write each shadow."""

    def job(index: int) -> None:
        source, shadow = pairs[index]
        read_matte(source)
        write_bytes(folder / f"{index + 1:04d}.png", encode_png(shadow))

    started = time.perf_counter()
    with ThreadPoolExecutor(workers) as pool:
        list(pool.map(job, range(len(pairs))))
    return time.perf_counter() - started


def _shadow_in(path: Path) -> ShadowImage:
    """Return a written shadow as what it was written from."""
    cel = read_cel(path)
    height, width = cel.matte.alpha.shape
    box = cel.matte.box or Box(0, 0, 0, 0)
    red, green, blue = (int(part) for part in cel.rgba[0, 0, :3])
    return ShadowImage(
        width, height, (red, green, blue), cel.matte.alpha[box.top : box.bottom, box.left : box.right], box
    )


def _unwatched(done: int, total: int) -> None:
    """Show no progress."""


def _never() -> bool:
    return False
