"""How a project names picture files: relative to its own folder, with forward slashes, and never across the network.

Only the text of a path is looked at. Nothing here asks a disk whether a file is there: that alone could already send
a user's credentials to a server that a stranger's project names.
"""

import os
import re
from pathlib import Path
from typing import Final

from kagezou.errors import ProjectProblem
from kagezou.io.files.faults import shown
from kagezou.message import Message

MAX_PATH_CHARACTERS: Final = 4096
_NETWORK: Final = re.compile(r"[/\\]{2}")
_DRIVE: Final = re.compile(r"[A-Za-z]:")
_DEVICE: Final = re.compile(
    r"(con|prn|aux|nul|conin\$|conout\$|(com|lpt)[0-9\u00b9\u00b2\u00b3]) *([.:].*)?", re.IGNORECASE
)
_ON_WINDOWS: Final = os.name == "nt"


def stored_path(path: Path, folder: Path) -> str:
    """Return the text that names ``path`` in a project that lies in ``folder``; both absolute.

    Relative wherever there is a way from one to the other, absolute on another drive; bytes on disk are kept.

    Raises
    ------
    ProjectProblem
        If the file lies on a network share that the project does not lie on.
    """
    try:
        text = Path(os.path.relpath(path, folder)).as_posix()
    except ValueError as error:  # another drive
        text = path.as_posix()
        if _NETWORK.match(text):
            raise ProjectProblem(
                Message(
                    "{path}: a project cannot name files of a network share it does not lie on; "
                    "give the share a drive letter or save the project there",
                    path=shown(path),
                )
            ) from error
        return text
    # A name that only looks like a drive or a share is told from one by where it starts.
    return f"./{text}" if _DRIVE.match(text) or _NETWORK.match(text) else text


def local_path(text: str, folder: Path) -> Path:
    """Return the absolute path that ``text`` names in a project that lies in ``folder``.

    Raises
    ------
    ProjectProblem
        If the text cannot be the name of a file of this computer.
    """
    cause = refusal_of(text, windows=_ON_WINDOWS)
    if cause:
        raise ProjectProblem(cause)
    return Path(os.path.normpath(folder / text))


def refusal_of(text: str, *, windows: bool) -> Message | None:
    """Return why a project may not name a file so, None if it may.

    Parameters
    ----------
    text
        What stands in the project.
    windows
        Whether it is read on Windows, where drives are local and some names are devices.
    """
    if not 1 <= len(text) <= MAX_PATH_CHARACTERS:
        return Message("a path has 1 to {most} characters", most=MAX_PATH_CHARACTERS)
    if "\0" in text or not _encodable(text):
        return Message("it cannot be the name of a file")
    if _NETWORK.match(text):
        return Message("a project may not name files on the network")
    if not windows:
        return Message("it names a drive of another computer") if _DRIVE.match(text) else None
    return _windows_refusal(text)


def _windows_refusal(text: str) -> Message | None:
    drive = _DRIVE.match(text)
    if drive and text[2:3] not in ("/", "\\"):
        return Message("a path on a drive starts at its root")
    parts = re.split(r"[/\\]", text[2:] if drive else text)
    if any(_DEVICE.fullmatch(part) for part in parts):
        return Message("it names a device")
    return Message("it cannot be the name of a file") if any(":" in part for part in parts) else None


def _encodable(text: str) -> bool:
    try:
        os.fsencode(text)
    except UnicodeEncodeError:
        return False
    return True


def absolute(path: Path) -> Path:
    """Return ``path`` from the root, by its text alone."""
    return Path(os.path.abspath(path))  # noqa: PTH100 - resolve() would follow links and so move relative names
