"""Writing a file so that, whatever happens, either the old content or the new one is there."""

import contextlib
import errno
import os
import re
import secrets
import shutil
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Final

from kagezou.io.files.faults import output_problem

_CREATE: Final = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_CLOEXEC", 0) | getattr(os, "O_BINARY", 0)
_UPDATE: Final = os.O_RDWR | getattr(os, "O_CLOEXEC", 0) | getattr(os, "O_BINARY", 0)
_PART: Final = re.compile(r"\..+\.\d+-[0-9a-f]{8}\.part(\.[A-Za-z0-9]+)?")
_NAME_BYTES: Final = 180
_STALE_S: Final = 3600.0
# A scanner or an indexer holds a Windows file for a moment: access denied, sharing and lock violation.
_BUSY_ON_WINDOWS: Final = frozenset({5, 32, 33})
_RETRIES_S: Final = (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0)
# Folders of some network file systems cannot be opened or synchronised; the rename itself is done by then.
_NO_FOLDER_SYNC: Final = frozenset({errno.EACCES, errno.EPERM, errno.EINVAL, errno.ENOTSUP, errno.EBADF, errno.EISDIR})


def write_bytes(path: Path, data: bytes | memoryview, *, keep_previous: bool = False) -> None:
    """Put ``data`` at ``path`` as a whole, or leave what was there.

    Parameters
    ----------
    path
        The file; its folder must exist. A link is followed.
    data
        The whole content.
    keep_previous
        Keep the file that was there as ``NAME~``.

    Raises
    ------
    DiskFullProblem
        No room, quota or size left.
    OutputProblem
        Anything else the system refuses. The old content is still there and no temporary file is left.
    """
    target = _target(path)
    temp = _part_path(target, "")
    with _reporting(path), _discarding(temp):
        descriptor = _create(temp, target)
        try:
            _write_all(descriptor, memoryview(data))
            os.fsync(descriptor)
        finally:
            os.close(descriptor)
        if keep_previous:
            _keep_previous(target)
        _replace(temp, target)
        _sync_folder(target.parent)


def check_writable(folder: Path) -> None:
    """Make a file in a folder and take it away again.

    Raises
    ------
    DiskFullProblem, OutputProblem
        The folder refuses.
    """
    temp = _part_path(folder / "write-test", "")
    with _reporting(folder), _discarding(temp):
        descriptor = os.open(temp, _CREATE, 0o666)
        try:
            _write_all(descriptor, memoryview(b"can be written to"))
        finally:
            os.close(descriptor)
        temp.unlink()


def replace_by(path: Path, write: Callable[[Path], None]) -> None:
    """Let ``write`` fill a temporary file beside ``path`` and put it in place when it returns.

    The temporary file exists, is empty and has the suffix of ``path``.

    Raises
    ------
    DiskFullProblem, OutputProblem
        As for `write_bytes`; whatever ``write`` raises passes through. The old content is still there.
    """
    target = _target(path)
    temp = _part_path(target, target.suffix)
    with _reporting(path), _discarding(temp):
        os.close(_create(temp, target))
        write(temp)
        descriptor = os.open(temp, _UPDATE)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)
        _replace(temp, target)
        _sync_folder(target.parent)


def let_go_of_link(path: Path) -> None:
    """Take away a link where a file of the program's own is to lie, so that what it leads to stays as it is.

    Raises
    ------
    OutputProblem
        The system refuses.
    """
    with _reporting(path):
        if path.is_symlink():
            path.unlink()


def sweep_stale(folder: Path) -> int:
    """Remove temporary files in ``folder`` that a killed program left over an hour ago; return how many.

    What cannot be looked at or removed stays, silently.
    """
    removed = 0
    latest_s = time.time() - _STALE_S
    with contextlib.suppress(OSError), os.scandir(folder) as entries:
        for entry in entries:
            if not _PART.fullmatch(entry.name):
                continue
            with contextlib.suppress(OSError):
                if entry.is_file(follow_symlinks=False) and entry.stat().st_mtime < latest_s:
                    Path(entry.path).unlink()
                    removed += 1
    return removed


def _target(path: Path) -> Path:
    """Return where ``path`` really lies, so that replacing it does not replace a link."""
    return Path(os.path.realpath(path))


def _part_path(target: Path, suffix: str) -> Path:
    """Return a new temporary path beside ``target``; very long names are cut so that ours still fits."""
    name = os.fsencode(target.name)[:_NAME_BYTES].decode("utf-8", "ignore")
    return target.with_name(f".{name}.{os.getpid()}-{secrets.token_hex(4)}.part{suffix}")


@contextlib.contextmanager
def _reporting(path: Path) -> Iterator[None]:
    try:
        yield
    except OSError as error:
        raise output_problem(path, error) from error


@contextlib.contextmanager
def _discarding(temp: Path) -> Iterator[None]:
    try:
        yield
    except BaseException:
        with contextlib.suppress(OSError):
            temp.unlink()
        raise


def _create(temp: Path, target: Path) -> int:
    """Create ``temp`` with the mode of ``target`` and return its descriptor; a locked target refuses."""
    try:
        mode = target.stat().st_mode & 0o7777
    except OSError:
        return os.open(temp, _CREATE, 0o666)
    if not os.access(target, os.W_OK):
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
    descriptor = os.open(temp, _CREATE, 0o666)
    if hasattr(os, "fchmod"):
        with contextlib.suppress(OSError):
            os.fchmod(descriptor, mode)
    return descriptor


def _write_all(descriptor: int, data: memoryview) -> None:
    """Write every byte; a short count is not an error of the system, only of who ignores it."""
    rest = data.cast("B")
    while len(rest):
        count = os.write(descriptor, rest)
        if count <= 0:
            raise OSError(errno.EIO, os.strerror(errno.EIO))
        rest = rest[count:]


def _keep_previous(target: Path) -> None:
    """Keep the file at ``target`` as ``NAME~``, by a second name where the file system allows it."""
    if not target.exists():
        return
    backup = target.with_name(target.name + "~")
    if backup.exists() and backup.samefile(target):
        return  # a save that failed after this step; renaming a file onto itself would leave the part
    temp = _part_path(backup, "")
    with _discarding(temp):
        try:
            temp.hardlink_to(target)
        except OSError:
            shutil.copy2(target, temp)
        _replace(temp, backup)


def _replace(temp: Path, target: Path) -> None:
    for pause_s in (*_RETRIES_S, None):
        try:
            temp.replace(target)
        except OSError as error:
            if pause_s is None or getattr(error, "winerror", None) not in _BUSY_ON_WINDOWS:
                raise
            time.sleep(pause_s)
        else:
            return


def _sync_folder(folder: Path) -> None:
    """Make the new name itself durable; Windows has no such call."""
    if os.name == "nt":
        return
    try:
        descriptor = os.open(folder, os.O_RDONLY | getattr(os, "O_DIRECTORY", 0))
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)
    except OSError as error:
        if error.errno not in _NO_FOLDER_SYNC:
            raise
