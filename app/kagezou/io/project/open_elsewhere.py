"""Whether a window has a project open: it says so by a lock file beside it."""

import os
import socket
import sys
from pathlib import Path

from kagezou.message import Message


def lock_of_window(path: Path) -> Path:
    """Return the lock file of the window that has a project open."""
    return path.with_name(f".{path.name}.lock")


def open_elsewhere(path: Path) -> Message | None:
    """Return what is said before a project is changed that a window has open; None where none has.

    A window that died leaves its lock file behind; on this computer that is seen, on another it is not.
    """
    try:
        lines = lock_of_window(path).read_text("utf-8", errors="replace").splitlines()
    except OSError:
        return None
    pid, _program, host, *_ = (*lines, "", "", "")
    if host == socket.gethostname() and not _is_alive(pid):
        return None
    return Message(
        "{path}: it is open in a window on {host}, which will ask before it saves over this", path=path.name, host=host
    )


def _is_alive(pid: str) -> bool:
    if sys.platform == "win32" or not pid.strip().isdecimal():
        # There a process cannot be asked without being ended.
        return True
    try:
        os.kill(int(pid), 0)
    except ProcessLookupError:
        return False
    except (PermissionError, OverflowError):
        return True
    return True
