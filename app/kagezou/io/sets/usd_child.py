"""The process in which a USD file is read: ``python -m kagezou.io.sets.usd_child FILE RATE OUT``.

It knows neither window nor graphics, and what it allocates is bounded where the system can do so.
"""

import sys
from fractions import Fraction
from pathlib import Path
from typing import Final

import numpy as np

from kagezou.errors import InputProblem
from kagezou.geometry.set_camera import SetCamera
from kagezou.io.files.faults import input_problem
from kagezou.io.sets.triangle_count import MAX_TRIANGLES
from kagezou.io.sets.triangles import Triangles
from kagezou.io.sets.usd_cameras import cameras_in, moves
from kagezou.io.sets.usd_contents import UsdContents, save_contents
from kagezou.io.sets.usd_scene import triangles_in
from kagezou.io.sets.usd_stage import OpenStage, open_stage, pxr
from kagezou.message import Message

MAX_BYTES: Final = 6 << 30
"""Of addresses, which are more than memory."""


def main(words: list[str]) -> None:
    """Read a file and write what it holds, or what is wrong with it."""
    _bound_memory()
    path, rate, out = Path(words[0]), Fraction(words[1]), Path(words[2])
    try:
        with np.errstate(all="ignore"):
            contents = contents_of(path, rate)
    except InputProblem as problem:
        contents = UsdContents(problem.message, problem.message, None, is_z_up=False)
    except MemoryError:
        told = input_problem(path, Message("there is not enough memory for this set")).message
        contents = UsdContents(told, told, None, is_z_up=False)
    save_contents(contents, out)


def _bound_memory() -> None:
    # Windows has no such bound; macOS takes it and does not keep it.
    if sys.platform != "win32":
        import resource

        _, hard = resource.getrlimit(resource.RLIMIT_AS)
        most = MAX_BYTES if hard == resource.RLIM_INFINITY else min(MAX_BYTES, hard)
        resource.setrlimit(resource.RLIMIT_AS, (most, hard))


def contents_of(path: Path, rate: Fraction) -> UsdContents:
    """Return what a file holds; InputProblem where it cannot be opened at all."""
    try:
        opened = open_stage(path)
        is_z_up = str(pxr("UsdGeom").GetStageUpAxis(opened.stage)) == "Z"
        return UsdContents(_triangles(opened), _cameras(opened, rate), rate if moves(opened.stage) else None, is_z_up)
    # In a damaged file names need not be text, and OpenUSD itself may refuse a length (std::length_error).
    except (UnicodeDecodeError, RuntimeError) as error:
        raise InputProblem(_damaged(path)) from error


def _triangles(opened: OpenStage) -> Triangles | Message:
    try:
        return triangles_in(opened, MAX_TRIANGLES)
    except InputProblem as problem:
        return problem.message
    except pxr("Tf").ErrorException:
        return _damaged(opened.path)


def _cameras(opened: OpenStage, rate: Fraction) -> tuple[SetCamera, ...] | Message:
    """Return the cameras; one that makes no sense leaves the shapes as they are."""
    try:
        return cameras_in(opened.path, opened.stage, rate)
    except InputProblem as problem:
        return problem.message
    except pxr("Tf").ErrorException:
        return _damaged(opened.path)


def _damaged(path: Path) -> Message:
    return input_problem(path, Message("it cannot be read as USD: the file is damaged")).message


if __name__ == "__main__":
    main(sys.argv[1:])
