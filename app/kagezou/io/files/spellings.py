"""Files by names that Unicode can write in two ways: a Mac may keep ``ガ`` as a letter and a mark behind it."""

import os
import unicodedata
from pathlib import Path

Listings = dict[Path, dict[str, str]]
"""Of folders that were read: their names in their composed form, and as they are spelled."""


def on_disk(path: Path, listings: Listings | None = None) -> Path:
    """Return ``path`` as it is spelled on the disk; as it is where there is nothing of that name in any spelling.

    A disk is asked only where the name can be spelled in more than one way; folders are read only where it is not there
    as it is written.

    Parameters
    ----------
    path
        A file or folder.
    listings
        Folders that were read before, and this one's; so that many files of one folder read it once.
    """
    if not has_spellings(str(path)) or os.path.lexists(path):
        return path
    known: Listings = {} if listings is None else listings
    found = Path(path.anchor)
    try:
        for part in path.parts[1 if path.anchor else 0 :]:
            found = found / _spelled(found, part, known)
    except OSError:
        return path
    return found if os.path.lexists(found) else path


def has_spellings(text: str) -> bool:
    """Whether Unicode can write a text in more than one way."""
    return not text.isascii() and unicodedata.normalize("NFC", text) != unicodedata.normalize("NFD", text)


def _spelled(folder: Path, name: str, listings: Listings) -> str:
    """Return how a name is spelled in its folder; of several spellings the first in order."""
    if not has_spellings(name) or (folder not in listings and os.path.lexists(folder / name)):
        return name
    if folder not in listings:
        names = sorted((entry.name for entry in folder.iterdir()), reverse=True)
        listings[folder] = {unicodedata.normalize("NFC", each): each for each in names}
    return listings[folder].get(unicodedata.normalize("NFC", name), name)
