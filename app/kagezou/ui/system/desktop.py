"""What the desktop does for the program: showing where a file lies."""

import sys
from pathlib import Path
from typing import Final

from PySide6.QtCore import QProcess, QUrl
from PySide6.QtGui import QDesktopServices

_SELECTING: Final = {"win32": ("explorer", "/select,"), "darwin": ("open", "-R")}
"""The programs that open a folder with one file selected."""


def show_in_folder(path: Path) -> bool:
    """Open the folder that a file lies in, or a folder itself; return whether the desktop did so.

    Where the system can, the file is selected there.
    """
    if path.is_file() and sys.platform in _SELECTING:
        program, option = _SELECTING[sys.platform]
        return QProcess.startDetached(program, [option, str(path)])[0]
    folder = path if path.is_dir() else path.parent
    return QDesktopServices.openUrl(QUrl.fromLocalFile(str(folder)))
