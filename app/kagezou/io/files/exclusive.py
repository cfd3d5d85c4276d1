"""One writer at a time: a lock beside a file that the system takes back when whoever holds it dies.

The lock file is removed by its holder. Who waited for one that is gone by then locks the wrong file, so that is looked
for, and it begins anew.
"""

import os
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from errno import EACCES, EAGAIN, EDEADLK, ENOENT
from pathlib import Path
from typing import Final

from kagezou.errors import OutputProblem
from kagezou.io.files.faults import output_problem, shown
from kagezou.message import Message

WAIT_S: Final = 30.0
_POLL_S: Final = 0.02
_BUSY: Final = frozenset({EACCES, EAGAIN, EDEADLK})


@contextmanager
def exclusive(path: Path, wait_s: float = WAIT_S) -> Iterator[None]:
    """Hold a file against everyone else who asks so, in any process; wait a while if somebody holds it.

    Parameters
    ----------
    path
        What is held; it is neither opened nor need it be there.
    wait_s
        How long to wait, seconds.

    Raises
    ------
    OutputProblem
        It was held all the time, or its folder takes no lock file.
    """
    lock = path.with_name(f".{path.name}.edit")
    descriptor = _taken(path, lock, time.monotonic() + wait_s)
    try:
        yield
    finally:
        # While it is held, so that nobody removes the next one's. Windows removes none that is open.
        if sys.platform != "win32":
            lock.unlink(missing_ok=True)
        os.close(descriptor)


def _taken(path: Path, lock: Path, until_s: float) -> int:
    while True:
        try:
            descriptor = os.open(lock, os.O_RDWR | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0), 0o666)
        except PermissionError as error:
            if not lock.exists():
                raise output_problem(path, error) from error
            raise OutputProblem(
                Message(
                    "{path}: another user changes it, or left {lock} beside it, which only they can remove",
                    path=shown(path),
                    lock=lock.name,
                )
            ) from error
        except OSError as error:
            raise output_problem(path, error) from error
        if locks(descriptor) and _is_same(descriptor, lock):
            return descriptor
        os.close(descriptor)
        if time.monotonic() > until_s:
            raise OutputProblem(
                Message("{path}: somebody else has been changing it for a while; please try again", path=shown(path))
            )
        time.sleep(_POLL_S)


def locks(descriptor: int) -> bool:
    """Lock an open file as long as it is open here, and return whether it is nobody else's."""
    try:
        if sys.platform == "win32":
            import msvcrt

            msvcrt.locking(descriptor, msvcrt.LK_NBLCK, 1)
        else:
            import fcntl

            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as error:
        if error.errno in _BUSY:
            return False
        # A file system without locks: nobody can be kept out, and to refuse would keep its owner out as well.
    return True


def _is_same(descriptor: int, lock: Path) -> bool:
    """Return whether the lock file is still the one that was opened."""
    mine = os.fstat(descriptor)
    try:
        there = lock.lstat()
    except OSError as error:
        if error.errno == ENOENT:
            return False
        raise
    return (mine.st_dev, mine.st_ino) == (there.st_dev, there.st_ino)
