"""How much memory there is, for what would be too large to be begun."""

import os
import sys
from pathlib import Path


def free_memory() -> int | None:
    """Return how many bytes of memory can be had now, None where the system does not tell."""
    if sys.platform == "win32":
        return _free_on_windows()
    try:
        with Path("/proc/meminfo").open(encoding="ascii") as table:
            rows = dict(line.split(":", 1) for line in table)
        return int(rows["MemAvailable"].split()[0]) << 10
    except (OSError, ValueError, KeyError, IndexError):
        pass
    return whole_memory()


def whole_memory() -> int | None:
    """Return how many bytes of memory the machine has, None where the system does not tell."""
    try:
        return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    except (AttributeError, OSError, ValueError):
        return None


def _free_on_windows() -> int | None:
    import ctypes

    class Status(ctypes.Structure):
        _fields_ = (
            ("length", ctypes.c_ulong),
            ("load", ctypes.c_ulong),
            *((f"bytes_{index}", ctypes.c_ulonglong) for index in range(7)),
        )

    status = Status()
    status.length = ctypes.sizeof(Status)
    asked: object = getattr(ctypes, "windll").kernel32.GlobalMemoryStatusEx(ctypes.byref(status))  # noqa: B009
    return int(status.bytes_1) if asked else None
