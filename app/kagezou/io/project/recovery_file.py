"""Keepsakes: unsaved work put aside in a folder of the user's own, to be found again after a crash.

A keepsake is one JSON file: what the work is called, where its project lies, and the project itself as text. It is
never the project's own file.
"""

import contextlib
import json
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from kagezou.document.model import Document
from kagezou.errors import ProjectProblem
from kagezou.io.files.atomic import write_bytes
from kagezou.io.files.faults import cause_of, output_problem, shown
from kagezou.io.files.json_text import Reader, parse
from kagezou.io.files.small_files import remove_file
from kagezou.io.project.file import MAX_BYTES, dumps, loads
from kagezou.message import Message

SUFFIX: Final = ".keepsake"
_FORMAT: Final = "kagezou-keepsake"
_KEYS: Final = ("format", "name", "path", "kept_at", "edits", "project")
_MAX_TEXT: Final = 4096


@dataclass(frozen=True, slots=True)
class RecoveredWork:
    """Work that was put aside.

    Parameters
    ----------
    document
        The work.
    name
        What the window called it.
    path
        Where its project lies; None for work that was never saved.
    kept_at_s
        Seconds since 1970.
    edits
        How many steps lie between the saved project and this.
    """

    document: Document
    name: str
    path: Path | None
    kept_at_s: int
    edits: int


def keep(file: Path, keepsake: RecoveredWork) -> None:
    """Write a keepsake as a whole or not at all; its folder is made if need be.

    Raises
    ------
    ProjectProblem
        The document cannot be kept in a project that loads again.
    DiskFullProblem, OutputProblem
        The file cannot be written; an older keepsake is still there.
    """
    tree = {
        "format": _FORMAT,
        "name": keepsake.name,
        "path": None if keepsake.path is None else str(keepsake.path),
        "kept_at": keepsake.kept_at_s,
        "edits": keepsake.edits,
        "project": dumps(keepsake.document, file.parent),
    }
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise output_problem(file, error) from error
    # Lone surrogates, which names of files may hold, are escaped by JSON.
    write_bytes(file, json.dumps(tree).encode("ascii"))


def read_recovery_file(file: Path) -> RecoveredWork:
    """Return what was put aside in a file.

    Raises
    ------
    ProjectProblem
        It is gone, damaged or from a newer program: one sentence.
    """
    try:
        if file.stat().st_size > 2 * MAX_BYTES:
            raise ProjectProblem(
                Message("it is larger than {megabytes} MB, too large for kept work", megabytes=2 * MAX_BYTES >> 20)
            )
        return _keepsake(Reader(parse(file.read_bytes().decode("ascii"))), file.parent)
    except OSError as error:
        raise ProjectProblem(Message("{path}: {cause}", path=shown(file), cause=cause_of(error))) from error
    except (UnicodeDecodeError, ProjectProblem) as problem:
        raise ProjectProblem(
            Message("{path}: the kept work is damaged: {cause}", path=shown(file), cause=problem)
        ) from problem


def recovery_files_in(folder: Path) -> tuple[Path, ...]:
    """Return the files of keepsakes in a folder, the latest first; none where there is no such folder."""
    found = []
    with contextlib.suppress(OSError):
        for path in folder.glob(f"*{SUFFIX}"):
            with contextlib.suppress(OSError):
                found.append((path.stat().st_mtime, path))
    return tuple(path for _, path in sorted(found, reverse=True))


def forget(file: Path) -> None:
    """Remove a keepsake; one that is gone already is no problem.

    Raises
    ------
    OutputProblem
        The system refuses.
    """
    remove_file(file)


def now_s() -> int:
    """Return the time by the clock on the wall, which is what people compare with."""
    return int(time.time())


def _keepsake(reader: Reader, folder: Path) -> RecoveredWork:
    found = reader.record(_KEYS)
    found["format"].word([_FORMAT])
    path = found["path"]
    return RecoveredWork(
        document=loads(found["project"].text(2 * MAX_BYTES), folder),
        name=found["name"].text(_MAX_TEXT),
        path=None if path.value is None else Path(path.text(_MAX_TEXT)),
        kept_at_s=found["kept_at"].whole(0, 1 << 40),
        edits=found["edits"].whole(0, 1 << 30),
    )
