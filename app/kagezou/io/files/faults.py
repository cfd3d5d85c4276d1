"""One sentence for whatever the file system refuses: which file, and why."""

import errno
import os
from pathlib import Path
from typing import Final

from kagezou.errors import DiskFullProblem, InputProblem, OutputProblem

_CAUSES: Final = {
    errno.ENOENT: "it does not exist",
    errno.ENOTDIR: "a part of its path is not a folder",
    errno.EISDIR: "it is a folder",
    errno.EACCES: "permission denied",
    errno.EPERM: "the operation is not permitted",
    errno.EROFS: "the disk is read-only",
    errno.EIO: "the disk reports an input/output error",
    errno.ENOSPC: "no space left on the disk",
    errno.EFBIG: "it would exceed the file size limit",
    errno.ENAMETOOLONG: "its name is too long",
    errno.ELOOP: "its links lead in a circle",
}
_QUOTA: Final[int | None] = getattr(errno, "EDQUOT", None)
_FULL: Final = frozenset({errno.ENOSPC, errno.EFBIG, _QUOTA})
# ERROR_HANDLE_DISK_FULL and ERROR_DISK_FULL.
_FULL_ON_WINDOWS: Final = frozenset({39, 112})


def shown(path: Path) -> str:
    r"""Return ``path`` as printable text; bytes that are no UTF-8 appear as ``\xNN``."""
    return os.fsencode(path).decode("utf-8", "backslashreplace")


def cause_of(error: OSError) -> str:
    """Return why the system refused, in a few words."""
    if error.errno == _QUOTA and _QUOTA is not None:
        return "the disk quota is used up"
    known = _CAUSES.get(error.errno or 0)
    return known or error.strerror or type(error).__name__


def input_problem(path: Path, cause: str | OSError) -> InputProblem:
    """Return the problem of reading ``path``, as ``"{path}: {cause}"``."""
    text = cause_of(cause) if isinstance(cause, OSError) else cause
    return InputProblem(f"{shown(path)}: {text}")


def output_problem(path: Path, cause: str | OSError) -> OutputProblem:
    """Return the problem of writing ``path``; a full disk, quota or size limit is a ``DiskFullProblem``."""
    if isinstance(cause, str):
        return OutputProblem(f"{shown(path)}: {cause}")
    kind = DiskFullProblem if is_full(cause) else OutputProblem
    why = "its folder does not exist" if cause.errno == errno.ENOENT else cause_of(cause)
    return kind(f"{shown(path)}: cannot be written: {why}")


def is_full(error: OSError) -> bool:
    """Return whether the system ran out of room."""
    return error.errno in _FULL or getattr(error, "winerror", None) in _FULL_ON_WINDOWS
