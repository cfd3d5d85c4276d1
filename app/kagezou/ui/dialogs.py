"""The questions the window asks: which file, which folder, and whether unsaved work may go."""

from enum import Enum, auto
from pathlib import Path

from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QFileDialog, QMessageBox, QWidget

from kagezou.io.signatures import FORMATS
from kagezou.ui.arrivals import PROJECT_SUFFIX
from kagezou.ui.settings import Settings


class Answer(Enum):
    """What to do with unsaved work."""

    SAVE = auto()
    DISCARD = auto()
    CANCEL = auto()


class Dialogs:
    """Asks with the system's own dialogs and remembers the folders used.

    Parameters
    ----------
    parent
        The window they belong to.
    settings
        Where folders are remembered.
    """

    def __init__(self, parent: QWidget, settings: Settings) -> None:
        self._parent = parent
        self._settings = settings

    def project_to_open(self) -> Path | None:
        """Ask for a project file."""
        title = QCoreApplication.translate("Dialogs", "Open Project")
        chosen, _ = QFileDialog.getOpenFileName(self._parent, title, self._folder("project"), self._project_filter())
        return self._remembered("project", chosen)

    def project_to_save(self, suggested: str) -> Path | None:
        """Ask where to save."""
        title = QCoreApplication.translate("Dialogs", "Save Project As")
        start = str(Path(self._folder("project")) / suggested)
        chosen, _ = QFileDialog.getSaveFileName(self._parent, title, start, self._project_filter())
        return self._remembered("project", chosen)

    def folder_of_cels(self) -> Path | None:
        """Ask for a folder of drawings."""
        title = QCoreApplication.translate("Dialogs", "Choose a Folder of Cels")
        chosen = QFileDialog.getExistingDirectory(self._parent, title, self._folder("cels"))
        return self._remembered("cels", chosen)

    def pictures(self) -> list[Path]:
        """Ask for pictures of a character."""
        title = QCoreApplication.translate("Dialogs", "Choose Cels")
        chosen, _ = QFileDialog.getOpenFileNames(self._parent, title, self._folder("cels"), _picture_filter())
        return [path for line in chosen if (path := self._remembered("cels", line))]

    def background(self) -> Path | None:
        """Ask for a background picture."""
        title = QCoreApplication.translate("Dialogs", "Choose a Background")
        chosen, _ = QFileDialog.getOpenFileName(self._parent, title, self._folder("background"), _picture_filter())
        return self._remembered("background", chosen)

    def folder_for_export(self) -> Path | None:
        """Ask where shadow layers go."""
        title = QCoreApplication.translate("Dialogs", "Export Shadow Layers To")
        chosen = QFileDialog.getExistingDirectory(self._parent, title, self._folder("export"))
        return self._remembered("export", chosen)

    def unsaved(self, name: str) -> Answer:
        """Ask what to do with unsaved work."""
        box = QMessageBox(self._parent)
        box.setIcon(QMessageBox.Icon.Warning)
        box.setWindowTitle("Kagezou")
        question = QCoreApplication.translate("Dialogs", "Save the changes to “%1”?")
        box.setText(question.replace("%1", name))
        box.setInformativeText(QCoreApplication.translate("Dialogs", "They are lost if you do not save them."))
        buttons = QMessageBox.StandardButton
        box.setStandardButtons(buttons.Save | buttons.Discard | buttons.Cancel)
        box.setDefaultButton(buttons.Save)
        # Said here, so that they do not depend on Qt's own translations being installed.
        box.button(buttons.Save).setText(QCoreApplication.translate("Dialogs", "Save"))
        box.button(buttons.Discard).setText(QCoreApplication.translate("Dialogs", "Don't Save"))
        box.button(buttons.Cancel).setText(QCoreApplication.translate("Dialogs", "Cancel"))
        answers = {buttons.Save.value: Answer.SAVE, buttons.Discard.value: Answer.DISCARD}
        return answers.get(box.exec(), Answer.CANCEL)

    def _folder(self, purpose: str) -> str:
        return self._settings.folder(purpose) or str(Path.home())

    def _remembered(self, purpose: str, chosen: str) -> Path | None:
        if not chosen:
            return None
        path = Path(chosen)
        self._settings.remember_folder(purpose, path.parent)
        return path

    @staticmethod
    def _project_filter() -> str:
        return QCoreApplication.translate("Dialogs", "Kagezou projects") + f" (*{PROJECT_SUFFIX})"


def _picture_filter() -> str:
    patterns = " ".join(f"*{suffix}" for suffix in sorted(FORMATS))
    return QCoreApplication.translate("Dialogs", "Pictures") + f" ({patterns})"
