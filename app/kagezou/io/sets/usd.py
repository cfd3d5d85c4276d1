"""Sets from USD files, read in a process of their own: a broken file may take that along, never the program."""

import os
import subprocess
import sys
import tempfile
import threading
from collections import OrderedDict
from dataclasses import replace
from fractions import Fraction
from importlib.util import find_spec
from pathlib import Path
from typing import Final

import numpy as np

from kagezou.errors import InputProblem
from kagezou.extras import USD
from kagezou.geometry.set_camera import SetCamera
from kagezou.io.files.faults import input_problem
from kagezou.io.files.file_stamp import FileStamp
from kagezou.io.sets.bounded_bytes import state_of
from kagezou.io.sets.triangles import Triangles
from kagezou.io.sets.usd_contents import UsdContents, load_contents
from kagezou.message import Message
from kagezou.own_process import module_words

MISSING: Final = Message("USD files need the package usd-core: {how}", how=USD.how)

CHILD: Final = "kagezou.io.sets.usd_child"
MAX_SECONDS: Final = 120
_MOST_KEPT: Final = 8
_USUAL_RATE: Final = Fraction(24)
_TAKEN: Final = Triangles(np.zeros((0, 3)), np.zeros((0, 3), np.int32))
"""In place of triangles that were handed out: whoever got them keeps them."""

_State = tuple[Path, *FileStamp]


class _Readings:
    """What was read of the last files, so that triangles, cameras and the axis of one need one process."""

    def __init__(self) -> None:
        self._kept: OrderedDict[_State, UsdContents] = OrderedDict()
        self._lock = threading.Lock()

    def contents(self, path: Path, rate: Fraction | None, *, with_triangles: bool = False) -> UsdContents:
        """Return what a file holds, its cameras at a rate if one is given; its triangles are handed out once."""
        key = (path, *state_of(path))
        with self._lock:
            found = self._kept.get(key)
        # Outside of the lock: another file may be had meanwhile.
        if found is None or not _does(found, rate, with_triangles=with_triangles):
            found = _read(path, rate or (found and found.rate) or _USUAL_RATE)
        with self._lock:
            self._kept[key] = replace(found, triangles=_TAKEN) if with_triangles else found
            self._kept.move_to_end(key)
            while len(self._kept) > _MOST_KEPT:
                self._kept.popitem(last=False)
        return found


_READINGS: Final = _Readings()


def read_usd(path: Path) -> Triangles:
    """Return the triangles of a stage as it is on its first frame.

    Raises
    ------
    InputProblem
        The package is missing, the file is broken, or it has too many triangles.
    """
    found = _READINGS.contents(path, None, with_triangles=True).triangles
    if isinstance(found, Message):
        raise InputProblem(found)
    return found


def usd_cameras(path: Path, frame_rate: Fraction) -> tuple[SetCamera, ...]:
    """Return every camera of a stage, in the order of its tree.

    Raises
    ------
    InputProblem
        The package for USD is missing, or the file is broken.
    """
    found = _READINGS.contents(path, frame_rate).cameras
    if isinstance(found, Message):
        raise InputProblem(found)
    return found


def is_z_up(path: Path) -> bool:
    """Whether a stage says that its third axis points up; raises as `usd_cameras` does."""
    return _READINGS.contents(path, None).is_z_up


def _does(found: UsdContents, rate: Fraction | None, *, with_triangles: bool) -> bool:
    """Whether nothing has to be read again."""
    if with_triangles and found.triangles is _TAKEN:
        return False
    return rate is None or found.rate in (None, rate)


def _read(path: Path, rate: Fraction) -> UsdContents:
    if find_spec("pxr") is None:
        raise InputProblem(MISSING)
    with tempfile.TemporaryDirectory(prefix="kagezou-usd-") as folder:
        out = Path(folder, "contents.npz")
        _run(path, rate, out)
        try:
            return load_contents(out)
        # Half a file, or none: whatever went wrong was not said.
        except Exception as error:
            raise input_problem(
                path, Message("it cannot be read as USD: the file is damaged, or too large for the memory")
            ) from error


def _run(path: Path, rate: Fraction, out: Path) -> None:
    """Let a process read a file and write what it holds; what becomes of it shows in what it wrote."""
    # One thread is enough, and the room of many for numbers would count as memory.
    env = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path)), "PXR_WORK_THREAD_LIMIT": "1"}
    words = [*module_words(CHILD), str(path.absolute()), str(rate), str(out)]
    try:
        subprocess.run(
            words,
            env=env,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            timeout=MAX_SECONDS,
            check=False,
            creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
        )
    except subprocess.TimeoutExpired as error:
        raise input_problem(
            path, Message("reading it takes longer than {seconds} seconds: given up", seconds=MAX_SECONDS)
        ) from error
    except OSError as error:
        raise input_problem(path, Message("the process that reads USD cannot be started")) from error
