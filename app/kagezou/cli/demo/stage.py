"""The demo's files: the numbered drawings, the background, and the project that lets a light go over them."""

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import numpy as np

from kagezou.animation.track import Interpolation, Value
from kagezou.cli.demo.figure import drawn
from kagezou.cli.demo.pose import FRAMES, GROUND_Y, pose_at
from kagezou.cli.demo.scenery import painted
from kagezou.document.address import resolve
from kagezou.document.edits import set_constant, set_key
from kagezou.document.model import Document
from kagezou.importing.feet import document_with_feet
from kagezou.importing.staging import CharacterSource, new_document
from kagezou.io.files.faults import output_problem
from kagezou.io.images.writing import write_rgba
from kagezou.io.project.file import save

SIZE_PX: Final = 1000
PAIR_SIZE_PX: Final = (1920, 1080)
_APART_PX: Final = 800
CHARACTER: Final = "Child"
_CONSTANTS: Final[dict[str, Value]] = {
    "ground.position": (500.0, GROUND_Y + 3),
    "ground.declination": 58.0,
    "light.kind": "sun",
    "light.elevation": 48.0,
    f"layers.{CHARACTER}.shadow.color": "#2C3E63",
    f"layers.{CHARACTER}.shadow.opacity": 0.55,
}
_LIGHT: Final[dict[int, Value]] = {1: -50.0, FRAMES: 50.0}
"""The sun's azimuth by frame: it wanders from the left to the right of the child."""


@dataclass(frozen=True, slots=True)
class Demo:
    """The files of a demo."""

    project: Path
    document: Document


def make_drawings(folder: Path, workers: int, progress: Callable[[int, int], None], count: int = FRAMES) -> None:
    """Draw the first ``count`` drawings into a folder as ``child_0001.png`` and so on.

    Raises
    ------
    DiskFullProblem, OutputProblem
        The folder refuses.
    """
    _make_folder(folder)

    def draw(frame: int) -> None:
        write_rgba(folder / f"child_{frame:04d}.png", drawn(pose_at(frame), SIZE_PX, SIZE_PX))

    _draw_all(draw, count, workers, progress)


def make_pair(folder: Path, workers: int, progress: Callable[[int, int], None]) -> tuple[Path, Path]:
    """Draw the child into two folders, on sheets of `PAIR_SIZE_PX`, in the second one further to the right.

    Raises
    ------
    DiskFullProblem, OutputProblem
        The folder refuses.
    """
    left, right = folder / "left", folder / "right"
    for each in (left, right):
        _make_folder(each)

    def draw(frame: int) -> None:
        drawing = drawn(pose_at(frame), *PAIR_SIZE_PX)
        write_rgba(left / f"left_{frame:04d}.png", drawing)
        write_rgba(right / f"right_{frame:04d}.png", np.roll(drawing, _APART_PX, axis=1))

    _draw_all(draw, FRAMES, workers, progress)
    return left, right


def make_demo(folder: Path, workers: int, progress: Callable[[int, int], None]) -> Demo:
    """Draw everything into a folder and write the project beside it; what was there of a former demo is replaced.

    Raises
    ------
    DiskFullProblem, OutputProblem
        The folder refuses.
    """
    make_drawings(folder / "drawings", workers, progress)
    background = folder / "meadow.png"
    write_rgba(background, painted(SIZE_PX, SIZE_PX))
    document = imported(folder / "drawings", background)
    project = folder / "demo.kage"
    save(document, project)
    return Demo(project, document)


def imported(drawings: Path, background: Path | None) -> Document:
    """Return the document of the demo's drawings, with its light on the move."""
    document = new_document([CharacterSource(CHARACTER, drawings)], background=background).document
    document = document_with_feet(document, [layer.id for layer in document.layers]).document
    for path, value in _CONSTANTS.items():
        document = set_constant(document, resolve(document, path), value)
    for frame, degrees in _LIGHT.items():
        document = set_key(document, resolve(document, "light.azimuth"), frame, degrees, Interpolation.BEZIER)
    return document


def _draw_all(draw: Callable[[int], None], count: int, workers: int, progress: Callable[[int, int], None]) -> None:
    """Draw the frames 1 to ``count`` on several threads."""
    with ThreadPoolExecutor(workers) as pool:
        try:
            for done, _ in enumerate(pool.map(draw, range(1, count + 1)), start=1):
                progress(done, count)
        except BaseException:
            pool.shutdown(wait=True, cancel_futures=True)
            raise


def _make_folder(folder: Path) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise output_problem(folder, error) from error
