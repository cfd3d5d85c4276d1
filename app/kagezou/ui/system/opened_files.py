"""Files that the desktop hands to the running program: a double click or a drop on the icon, as macOS sends them."""

from pathlib import Path

from PySide6.QtCore import QCoreApplication, QEvent, QObject, Signal
from PySide6.QtGui import QFileOpenEvent


class OpenedFiles(QObject):
    """Tells which file is to be opened.

    Parameters
    ----------
    application
        Which gets the events.
    """

    came = Signal(Path)

    def __init__(self, application: QCoreApplication) -> None:
        super().__init__()
        application.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if isinstance(event, QFileOpenEvent) and event.file():
            self.came.emit(Path(event.file()))
            return True
        return False
