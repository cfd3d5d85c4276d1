"""What a project's file was like at a moment, to find out later whether others wrote it since."""

import hashlib
import os
from dataclasses import dataclass, field
from pathlib import Path


@dataclass(frozen=True, slots=True)
class FileState:
    """The content of a file, told by its size and hash; equal ones hold the same bytes.

    Parameters
    ----------
    size
        Bytes.
    sha256
        Hexadecimal.
    modified_s
        Seconds since 1970; not compared, as copies and backups change it.
    """

    size: int
    sha256: str
    modified_s: int = field(default=0, compare=False)


NEVER_SEEN = FileState(0, "")
"""Equal to no file: whatever lies there was not seen."""


def state_of(path: Path) -> FileState | None:
    """Return the state of a file; None if there is none, or none that can be read."""
    try:
        with path.open("rb") as stream:
            found = os.fstat(stream.fileno())
            return FileState(found.st_size, hashlib.file_digest(stream, "sha256").hexdigest(), int(found.st_mtime))
    except (OSError, ValueError):  # a NUL in the name
        return None
