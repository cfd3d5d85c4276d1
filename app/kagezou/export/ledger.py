"""The ledger of an export folder: which frames were finished, from what, and how their bytes read.

It is what lets an interrupted export go on: a file is trusted only when its own bytes are the ones that were written
and what it would be made from now is what it was made from then. A line is added when a frame is in its place, so that
even a killed program leaves no more than a torn last line, which counts for nothing.
"""

import contextlib
import hashlib
import json
from functools import cache
from pathlib import Path
from typing import Final

from kagezou.export.planning import FrameJob
from kagezou.export.request import ExportRequest
from kagezou.io.files.atomic import write_bytes
from kagezou.io.files.faults import output_problem
from kagezou.io.files.file_stamp import FileStamp, stamp_of
from kagezou.locations import shader_folder
from kagezou.version import __version__

LEDGER_NAME: Final = ".kagezou-frames.jsonl"
_MAX_BYTES: Final = 256 << 20
_SPARE_LINES: Final = 1000


class Ledger:
    """What is known of the finished frames below one folder; used by one thread.

    Parameters
    ----------
    folder
        The folder of the export; it must exist.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._path = folder / LEDGER_NAME
        self._known = self._read()

    def holds(self, file: Path, fingerprint: str) -> bool:
        """Return whether a file is there, is the one that was written, and would come out the same."""
        known = self._known.get(self._name(file))
        if known is None or known[0] != fingerprint:
            return False
        try:
            return content_hash(file.read_bytes()) == known[1]
        except OSError:
            return False

    def hash_of(self, file: Path) -> str:
        """Return the hash of the bytes that were written; empty for a file that is not known."""
        return self._known.get(self._name(file), ("", ""))[1]

    def add(self, file: Path, fingerprint: str, content: str) -> None:
        """Note that a file is in its place; ``content`` is the `content_hash` of its bytes.

        Raises
        ------
        DiskFullProblem, OutputProblem
            The ledger cannot be written.
        """
        name = self._name(file)
        self._known[name] = (fingerprint, content)
        try:
            # One write of one short line at the end: several programs may share a folder.
            with self._path.open("ab", buffering=0) as stream:
                stream.write(_line(name, fingerprint, content))
        except OSError as error:
            raise output_problem(self._path, error) from error

    def _name(self, path: Path) -> str:
        return path.relative_to(self._folder).as_posix()

    def _read(self) -> dict[str, tuple[str, str]]:
        """Return what the file says; lines that are torn or none of ours count for nothing."""
        try:
            if self._path.stat().st_size > _MAX_BYTES:
                return {}
            lines = self._path.read_bytes().splitlines()
        except OSError:
            return {}
        known: dict[str, tuple[str, str]] = {}
        for line in lines:
            with contextlib.suppress(ValueError, RecursionError):
                match json.loads(line):
                    case [str(name), str(fingerprint), str(content)]:
                        known[name] = (fingerprint, content)
        if len(lines) > 2 * len(known) + _SPARE_LINES:
            tidy = b"".join(_line(name, *rest) for name, rest in known.items())
            write_bytes(self._path, tidy)
        return known


def _line(name: str, fingerprint: str, content: str) -> bytes:
    """Return one entry; it begins with a line end of its own, so that a torn entry before it spoils nothing."""
    return b"\n" + json.dumps([name, fingerprint, content]).encode("ascii")


def content_hash(data: bytes) -> str:
    """Return a text by which the bytes of a file are told from any others."""
    return hashlib.sha256(data).hexdigest()


def fingerprint(job: FrameJob, request: ExportRequest) -> str:
    """Return a text that changes with anything that decides the bytes of a picture.

    That is: its content down to the last digit, size, format and depth, the program's version and shaders, and the
    state of the drawings' files (size and times of change; a missing file has none).
    """
    states = [_state(path) for path in job.content.sources.files]
    canvas = job.content.scene.canvas
    parts = (engine(), request.format, request.depth, canvas.width, canvas.height, job.content, states)
    return hashlib.sha256(repr(parts).encode("utf-8", "backslashreplace")).hexdigest()


def _state(path: Path) -> FileStamp | None:
    try:
        found = path.stat()
    except (OSError, ValueError):
        return None
    return stamp_of(found)


@cache
def engine() -> str:
    """Return a text that changes with the program that draws: its version and its shaders."""
    shaders = sorted(path for path in shader_folder().rglob("*") if path.is_file())
    digest = hashlib.sha256(__version__.encode())
    for path in shaders:
        digest.update(path.name.encode() + b"\0" + path.read_bytes() + b"\0")
    return digest.hexdigest()
