"""Files by names that Unicode can write in two ways: a Mac may keep ``ガ`` as a letter and a mark behind it."""

import os
import unicodedata
from pathlib import Path


def on_disk(path: Path) -> Path:
    """Return ``path`` as it is spelled on the disk; as it is where there is nothing of that name in any spelling.

    A disk is asked only where the name can be spelled in more than one way; folders are read only where it is not there
    as it is written.
    """
    if not _has_spellings(str(path)) or os.path.lexists(path):
        return path
    found = Path(path.anchor)
    try:
        for part in path.parts[1 if path.anchor else 0 :]:
            found = found / _spelled(found, part)
    except OSError:
        return path
    return found if os.path.lexists(found) else path


def _has_spellings(text: str) -> bool:
    return not text.isascii() and unicodedata.normalize("NFC", text) != unicodedata.normalize("NFD", text)


def _spelled(folder: Path, name: str) -> str:
    """Return how a name is spelled in its folder; of several spellings the first in order."""
    if not _has_spellings(name) or os.path.lexists(folder / name):
        return name
    wanted = unicodedata.normalize("NFC", name)
    names = (entry.name for entry in folder.iterdir())
    return min((each for each in names if unicodedata.normalize("NFC", each) == wanted), default=name)
