"""What tells that a file is the one that was read before, without reading it again."""

import os

FileStamp = tuple[int, int, int]
"""Size in bytes, time of change, and time of the last change to file or entry, both in nanoseconds since 1970."""


def stamp_of(status: os.stat_result) -> FileStamp:
    """Return the stamp of a file from its status.

    The first time can be set by anyone, and copies that keep times set it; the second one is the system's own, so that
    other content of the same size and time is noticed. On Windows it is when the file was made, which tells a file that
    was replaced, but not one that was written over with its old time set again.
    """
    return status.st_size, status.st_mtime_ns, status.st_ctime_ns
