"""One sentence for whatever the file system refuses: which file, and why."""

import errno
import os
import sys
from pathlib import Path
from typing import Final

from kagezou.errors import DiskFullProblem, InputProblem, OutputProblem
from kagezou.message import Message

_CAUSES: Final = {
    errno.ENOENT: Message("it does not exist"),
    errno.ENOTDIR: Message("a part of its path is not a folder"),
    errno.EISDIR: Message("it is a folder"),
    errno.EEXIST: Message("something of this name is in the way"),
    errno.EACCES: Message("permission denied"),
    errno.EPERM: Message("the operation is not permitted"),
    errno.EROFS: Message("the disk is read-only"),
    errno.EIO: Message("the disk reports an input/output error"),
    errno.ENOSPC: Message("no space left on the disk"),
    errno.EFBIG: Message("it would exceed the file size limit"),
    errno.ENAMETOOLONG: Message("its name is too long"),
    errno.ELOOP: Message("its links lead in a circle"),
}
LONGEST_ON_WINDOWS: Final = 259
_QUOTA: Final[int | None] = getattr(errno, "EDQUOT", None)
_FULL: Final = frozenset({errno.ENOSPC, errno.EFBIG, _QUOTA})
# ERROR_HANDLE_DISK_FULL and ERROR_DISK_FULL.
_FULL_ON_WINDOWS: Final = frozenset({39, 112})


def shown(path: Path) -> str:
    r"""Return ``path`` as printable text; bytes that are no UTF-8 appear as ``\xNN``."""
    return os.fsencode(path).decode("utf-8", "backslashreplace")


def cause_of(error: OSError) -> Message:
    """Return why the system refused, in a few words."""
    if error.errno == _QUOTA and _QUOTA is not None:
        return Message("the disk quota is used up")
    known = _CAUSES.get(error.errno or 0)
    return known or Message("{reason}", reason=error.strerror or type(error).__name__)


def too_long_for_windows(path: Path, system: str = sys.platform) -> Message | None:
    """Return what is said of a path that Windows calls missing because it is too long; None for any other.

    Parameters
    ----------
    path
        The path, as it was used.
    system
        The system, as in ``sys.platform``.
    """
    count = len(os.path.abspath(path))  # noqa: PTH100 - of a path that no system need know
    if system != "win32" or count <= LONGEST_ON_WINDOWS:
        return None
    return Message(
        "its path has {count} characters, and Windows takes {most} unless long paths are switched on",
        count=count,
        most=LONGEST_ON_WINDOWS,
    )


def _missing(path: Path, error: OSError, otherwise: Message) -> Message:
    is_missing = error.errno == errno.ENOENT
    return (too_long_for_windows(path) or otherwise) if is_missing else cause_of(error)


def input_problem(path: Path, cause: Message | OSError) -> InputProblem:
    """Return the problem of reading ``path``, as ``"{path}: {cause}"``."""
    why = _missing(path, cause, cause_of(cause)) if isinstance(cause, OSError) else cause
    return InputProblem(Message("{path}: {cause}", path=shown(path), cause=why))


def output_problem(path: Path, cause: Message | OSError) -> OutputProblem:
    """Return the problem of writing ``path``; a full disk, quota or size limit is a ``DiskFullProblem``."""
    if isinstance(cause, Message):
        return OutputProblem(Message("{path}: {cause}", path=shown(path), cause=cause))
    kind = DiskFullProblem if is_full(cause) else OutputProblem
    why = _missing(path, cause, Message("its folder does not exist"))
    return kind(Message("{path}: cannot be written: {cause}", path=shown(path), cause=why))


def is_full(error: OSError) -> bool:
    """Return whether the system ran out of room."""
    return error.errno in _FULL or getattr(error, "winerror", None) in _FULL_ON_WINDOWS
