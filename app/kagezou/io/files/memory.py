"""How much memory there is, for what would be too large to be begun, and what is given back of it."""

import os
import sys
from contextlib import suppress
from pathlib import Path
from typing import Final

_AVAILABLE: Final = b"MemAvailable:"


def free_memory() -> int | None:
    """Return how many bytes of memory can be had now, None where the system does not tell."""
    if sys.platform == "win32":
        return _free_on_windows()
    try:
        with Path("/proc/meminfo").open("rb") as table:
            for line in table:
                if line.startswith(_AVAILABLE):
                    return int(line[len(_AVAILABLE) :].split()[0]) << 10
    except (OSError, ValueError, IndexError):
        pass
    return whole_memory()


def whole_memory() -> int | None:
    """Return how many bytes of memory the machine has, None where the system does not tell."""
    try:
        return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    except (AttributeError, OSError, ValueError):
        return None


def give_back() -> None:
    """Give the system what is free between the blocks that are in use, where its C library keeps that (glibc).

    Pictures of all sizes come and go on many threads, and what lies between those that stay grows without bound.
    """
    if sys.platform != "linux":
        return
    import ctypes

    with suppress(OSError, AttributeError):  # another C library than glibc
        ctypes.CDLL(None).malloc_trim(0)


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
    asked: object = getattr(ctypes, "windll").kernel32.GlobalMemoryStatusEx(ctypes.byref(status))  # noqa: B009 - known on Windows alone
    return int(status.bytes_1) if asked else None
