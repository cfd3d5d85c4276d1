"""Keepsakes: unsaved work put aside in a folder of the user's own, to be found again after a crash.

A keepsake is one JSON file: what the work is called, where its project lies and what that file was like, and the
project itself as text. It is never the project's own file. It counts once it was read back and says the same.
"""

import contextlib
import json
import os
import stat
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from kagezou.document.model import Document
from kagezou.errors import ProjectProblem
from kagezou.io.files.atomic import replace_by, sweep_stale
from kagezou.io.files.faults import cause_of, output_problem, shown
from kagezou.io.files.json_text import MOST_VALUES, Reader, parse
from kagezou.io.files.small_files import remove_file
from kagezou.io.project.file import MAX_BYTES, dumps, loads
from kagezou.io.project.file_state import NEVER_SEEN, FileState, state_of
from kagezou.io.project.paths import absolute
from kagezou.message import Message

SUFFIX: Final = ".keepsake"
_FORMAT: Final = "kagezou-keepsake"
_KEYS: Final = ("format", "name", "path", "kept_at", "edits", "project")
_LATER_KEYS: Final = ("file", "folder")
"""Keepsakes of earlier programs lack them."""
_MAX_TEXT: Final = 4096
# What a project writes as two bytes can take six here, and its name and path may hold commas.
_MAX_KEEPSAKE_BYTES: Final = 3 * MAX_BYTES + (1 << 20)
_MOST_VALUES: Final = MOST_VALUES + 5 * _MAX_TEXT


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
    file
        What the project's file was like when it was opened or last saved; None where that is not known.
    """

    document: Document
    name: str
    path: Path | None
    kept_at_s: int
    edits: int
    file: FileState | None = None

    @property
    def seen(self) -> FileState | None:
        """What of the project's file this work knows: as it lies there, unless others wrote it since."""
        now = None if self.path is None else state_of(self.path)
        if now is None:
            return None
        if self.file is None:
            return NEVER_SEEN if now.modified_s > self.kept_at_s else now
        return now if now == self.file else NEVER_SEEN

    @property
    def is_behind(self) -> bool:
        """Whether others wrote the project's file since this work began from it."""
        return self.seen == NEVER_SEEN


def keep(file: Path, keepsake: RecoveredWork) -> None:
    """Write a keepsake as a whole or not at all, and read it back before it takes the place of an older one.

    Its folder is made if need be.

    Raises
    ------
    ProjectProblem
        The document cannot be kept in a project that loads again.
    DiskFullProblem, OutputProblem
        The file cannot be written, or does not say what was written; an older keepsake is still there.
    """
    base = absolute(file if keepsake.path is None else keepsake.path).parent
    tree = {
        "format": _FORMAT,
        "name": keepsake.name,
        "path": None if keepsake.path is None else str(keepsake.path),
        "kept_at": keepsake.kept_at_s,
        "edits": keepsake.edits,
        "file": _file_tree(keepsake.file),
        "folder": str(base),
        "project": dumps(keepsake.document, base),
    }
    # Lone surrogates, which names of files may hold, are escaped by JSON.
    data = json.dumps(tree).encode("ascii")
    make_folder(file.parent)

    def write(temp: Path) -> None:
        temp.write_bytes(data)
        if temp.read_bytes() != data:
            # A disk that keeps other bytes than it was given says nothing itself.
            raise output_problem(file, Message("what was written reads otherwise"))
        _check(data, keepsake, base)

    replace_by(file, write)


def make_folder(folder: Path) -> None:
    """Make a folder for keepsakes, closed to others, unless it is there.

    Raises
    ------
    OutputProblem
        It cannot be made, or somebody else made it where everybody may, such as for temporary files.
    """
    try:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    except OSError as error:
        raise output_problem(folder, error) from error
    if _is_strange(folder):
        raise output_problem(folder, Message("it belongs to somebody else"))


def read_recovery_file(file: Path) -> RecoveredWork:
    """Return what was put aside in a file.

    Raises
    ------
    ProjectProblem
        It is gone, damaged or from a newer program: one sentence.
    """
    try:
        if file.stat().st_size > _MAX_KEEPSAKE_BYTES:
            raise ProjectProblem(
                Message(
                    "it is larger than {megabytes} MB, too large for kept work", megabytes=_MAX_KEEPSAKE_BYTES >> 20
                )
            )
        return _keepsake_of(file.read_bytes(), file.parent)
    except OSError as error:
        raise ProjectProblem(Message("{path}: {cause}", path=shown(file), cause=cause_of(error))) from error
    except (UnicodeDecodeError, ProjectProblem) as problem:
        raise ProjectProblem(
            Message("{path}: the kept work is damaged: {cause}", path=shown(file), cause=problem)
        ) from problem


def recovery_files_in(folder: Path) -> tuple[Path, ...]:
    """Return the files of keepsakes in a folder, the latest first; none where there is no such folder.

    What was half written when a program ended is none.
    """
    found = []
    if _is_strange(folder):
        return ()
    sweep_stale(folder)
    with contextlib.suppress(OSError):
        for path in folder.glob(f"[!.]*{SUFFIX}"):
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


def _check(data: bytes, keepsake: RecoveredWork, base: Path) -> None:
    """Read kept work as it will be read after a crash, and compare."""
    document = _keepsake_of(data, base).document
    # Equal text is enough: paths may be written in several ways that mean one file.
    if document != keepsake.document and dumps(document, base) != dumps(keepsake.document, base):
        raise ProjectProblem(Message("it would come back as something else"))


def _is_strange(folder: Path) -> bool:
    """Whether somebody else owns a folder that lies where everybody may make one."""
    if not hasattr(os, "getuid"):
        return False
    try:
        is_open_to_all = folder.parent.stat().st_mode & stat.S_IWOTH
        return bool(is_open_to_all) and folder.lstat().st_uid != os.getuid()
    except OSError:
        return False


def _file_tree(file: FileState | None) -> dict[str, object] | None:
    if file is None:
        return None
    return {"size": file.size, "sha256": file.sha256, "modified_s": file.modified_s}


def _keepsake_of(data: bytes, folder: Path) -> RecoveredWork:
    reader = Reader(parse(data.decode("ascii"), _MOST_VALUES))
    found = reader.record(_KEYS, _LATER_KEYS)
    found["format"].word([_FORMAT])
    path = found["path"]
    base = Path(found["folder"].text(_MAX_TEXT)) if "folder" in found else folder
    return RecoveredWork(
        document=loads(found["project"].text(2 * MAX_BYTES), base),
        name=found["name"].text(_MAX_TEXT),
        path=None if path.value is None else Path(path.text(_MAX_TEXT)),
        kept_at_s=found["kept_at"].whole(0, 1 << 40),
        edits=found["edits"].whole(0, 1 << 30),
        file=_file(found["file"]) if "file" in found else None,
    )


def _file(reader: Reader) -> FileState | None:
    if reader.value is None:
        return None
    found = reader.record(("size", "sha256", "modified_s"))
    return FileState(
        size=found["size"].whole(0, 1 << 60),
        sha256=found["sha256"].text(64, 0),
        modified_s=found["modified_s"].whole(-(1 << 40), 1 << 40),
    )
