"""The questions the window asks: which file, which folder, and whether unsaved work may go."""

from enum import Enum, auto
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QSysInfo
from PySide6.QtWidgets import QAbstractItemView, QFileDialog, QInputDialog, QMessageBox, QWidget

from kagezou.importing.found_characters import FoundCharacters
from kagezou.importing.new_cels import CharacterSource
from kagezou.importing.sheet_project import TIMESHEET_SUFFIXES
from kagezou.io.oca.reading import SUFFIX as OCA_SUFFIX
from kagezou.io.pixels.signatures import FORMATS, PSD_SUFFIXES
from kagezou.io.sets.mesh_cache import MESH_SUFFIXES
from kagezou.ui.project.dropped_files import PROJECT_SUFFIX
from kagezou.ui.project.found_dialog import FoundDialog
from kagezou.ui.system.settings import Settings


class Answer(Enum):
    """What to do with unsaved work."""

    SAVE = auto()
    DISCARD = auto()
    CANCEL = auto()


class Changed(Enum):
    """What to do about a file that others wrote since it was read."""

    SAVE_AS = auto()
    REPLACE = auto()
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
        """Ask for a project file, or for what a project begins with: a timesheet or a file of layers."""
        title = QCoreApplication.translate("Dialogs", "Open Project")
        suffixes = (PROJECT_SUFFIX, *TIMESHEET_SUFFIXES, *PSD_SUFFIXES, OCA_SUFFIX)
        words = QCoreApplication.translate("Dialogs", "Projects, timesheets, PSD and OCA files")
        every = f"{words} ({' '.join(f'*{each}' for each in suffixes)})"
        filters = ";;".join([every, self._project_filter()])
        chosen, _ = QFileDialog.getOpenFileName(self._parent, title, self._folder("project"), filters)
        return self._remembered("project", chosen)

    def project_to_take_from(self) -> Path | None:
        """Ask for the project file that something is taken from."""
        title = QCoreApplication.translate("Dialogs", "Take From Project")
        chosen, _ = QFileDialog.getOpenFileName(self._parent, title, self._folder("project"), self._project_filter())
        return self._remembered("project", chosen)

    def project_to_save(self, suggested: str) -> Path | None:
        """Ask where to save."""
        title = QCoreApplication.translate("Dialogs", "Save Project As")
        start = str(Path(self._folder("project")) / suggested)
        chosen, _ = QFileDialog.getSaveFileName(self._parent, title, start, self._project_filter())
        return self._remembered("project", self._whole(chosen, PROJECT_SUFFIX))

    def folder_of_cels(self) -> Path | None:
        """Ask for a folder of drawings."""
        title = QCoreApplication.translate("Dialogs", "Choose a Folder of Cels")
        chosen = QFileDialog.getExistingDirectory(self._parent, title, self._folder("cels"))
        return self._remembered("cels", chosen)

    def folders_of_cels(self) -> list[Path]:
        """Ask for folders of drawings, several at once; the systems' own dialogs let one choose a single one."""
        dialog = QFileDialog(self._parent, QCoreApplication.translate("Dialogs", "Choose Folders of Cels"))
        dialog.setFileMode(QFileDialog.FileMode.Directory)
        dialog.setOption(QFileDialog.Option.DontUseNativeDialog)
        dialog.setDirectory(self._folder("cels"))
        for view in dialog.findChildren(QAbstractItemView):
            if view.objectName() in ("listView", "treeView"):
                view.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        if dialog.exec() != QFileDialog.DialogCode.Accepted:
            return []
        return [path for line in dialog.selectedFiles() if (path := self._remembered("cels", line))]

    def pictures(self) -> list[Path]:
        """Ask for pictures of a character."""
        title = QCoreApplication.translate("Dialogs", "Choose Cels")
        chosen, _ = QFileDialog.getOpenFileNames(self._parent, title, self._folder("cels"), _picture_filter())
        return [path for line in chosen if (path := self._remembered("cels", line))]

    def characters(self, found: FoundCharacters) -> tuple[CharacterSource, ...]:
        """Show what was understood of folders and files, and return what of it is to be taken."""
        dialog = FoundDialog(found, self._parent)
        return dialog.sources() if dialog.exec() == FoundDialog.DialogCode.Accepted else ()

    def sheet(self, names: list[str]) -> str | None:
        """Ask which of several sheets of a file is meant."""
        title = QCoreApplication.translate("Dialogs", "Choose a Sheet")
        words = QCoreApplication.translate("Dialogs", "The file holds several timesheets:")
        lines = [f"{number}   {name}" for number, name in enumerate(names, start=1)]
        chosen, is_agreed = QInputDialog.getItem(self._parent, title, words, lines, 0, False)
        return f"#{lines.index(chosen) + 1}" if is_agreed else None

    def background(self) -> Path | None:
        """Ask for a background picture."""
        title = QCoreApplication.translate("Dialogs", "Choose a Background")
        chosen, _ = QFileDialog.getOpenFileName(self._parent, title, self._folder("background"), _picture_filter())
        return self._remembered("background", chosen)

    def folder_of_background(self) -> Path | None:
        """Ask for a folder of background pictures."""
        title = QCoreApplication.translate("Dialogs", "Choose a Folder of Background Pictures")
        chosen = QFileDialog.getExistingDirectory(self._parent, title, self._folder("background"))
        return self._remembered("background", chosen)

    def set_file(self) -> Path | None:
        """Ask for a set from a 3-D program."""
        title = QCoreApplication.translate("Dialogs", "Import Set")
        words = QCoreApplication.translate("Dialogs", "Sets") + f" ({' '.join(f'*{each}' for each in MESH_SUFFIXES)})"
        chosen, _ = QFileDialog.getOpenFileName(self._parent, title, self._folder("set"), words)
        return self._remembered("set", chosen)

    def timesheet(self) -> Path | None:
        """Ask for a timesheet."""
        title = QCoreApplication.translate("Dialogs", "Open Timesheet")
        words = QCoreApplication.translate("Dialogs", "Timesheets") + " (*.xdts *.tdts *.sts)"
        chosen, _ = QFileDialog.getOpenFileName(self._parent, title, self._folder("timesheet"), words)
        return self._remembered("timesheet", chosen)

    def timesheet_to_save(self, suggested: str) -> Path | None:
        """Ask where to write a timesheet."""
        title = QCoreApplication.translate("Dialogs", "Save Timesheet As")
        start = str(Path(self._folder("timesheet")) / suggested)
        words = QCoreApplication.translate("Dialogs", "Timesheets") + " (*.xdts)"
        chosen, _ = QFileDialog.getSaveFileName(self._parent, title, start, words)
        return self._remembered("timesheet", self._whole(chosen, ".xdts"))

    def unsaved(self, name: str) -> Answer:
        """Ask what to do with unsaved work."""
        question = QCoreApplication.translate("Dialogs", "Save the changes to “%1”?").replace("%1", name)
        note = QCoreApplication.translate("Dialogs", "They are lost if you do not save them.")
        box, buttons = self._box(question, note), QMessageBox.StandardButton
        box.setStandardButtons(buttons.Save | buttons.Discard | buttons.Cancel)
        box.setDefaultButton(buttons.Save)
        # Said here, so that they do not depend on Qt's own translations being installed.
        box.button(buttons.Save).setText(QCoreApplication.translate("Dialogs", "Save"))
        box.button(buttons.Discard).setText(QCoreApplication.translate("Dialogs", "Don't Save"))
        box.button(buttons.Cancel).setText(QCoreApplication.translate("Dialogs", "Cancel"))
        answers = {buttons.Save.value: Answer.SAVE, buttons.Discard.value: Answer.DISCARD}
        return answers.get(box.exec(), Answer.CANCEL)

    def open_twice(self, name: str, holder: str) -> bool:
        """Ask whether to open a project that another window has open; ``holder`` is its computer."""
        question = QCoreApplication.translate("Dialogs", "“%1” is open in another window. Open it here too?")
        here = QCoreApplication.translate("Dialogs", "Whoever saves last wins. The other window is on this computer.")
        there = QCoreApplication.translate("Dialogs", "Whoever saves last wins. The other window is on %1.")
        note = here if holder == QSysInfo.machineHostName() else there
        return self._agrees(
            question.replace("%1", name),
            note.replace("%1", holder),
            QCoreApplication.translate("Dialogs", "Open Anyway"),
        )

    def overwrite_changed(self, name: str) -> Changed:
        """Ask where to save what would go over a project that others changed since it was opened."""
        question = QCoreApplication.translate("Dialogs", "“%1” was changed outside this window. Replace it?")
        note = QCoreApplication.translate("Dialogs", "What was changed there would be kept only as its backup (%1~).")
        box, buttons = self._box(question.replace("%1", name), note.replace("%1", name)), QMessageBox.StandardButton
        box.setStandardButtons(buttons.Save | buttons.Yes | buttons.Cancel)
        box.setDefaultButton(buttons.Save)
        box.button(buttons.Save).setText(QCoreApplication.translate("Dialogs", "Save As…"))
        box.button(buttons.Yes).setText(QCoreApplication.translate("Dialogs", "Replace"))
        box.button(buttons.Cancel).setText(QCoreApplication.translate("Dialogs", "Cancel"))
        answers = {buttons.Save.value: Changed.SAVE_AS, buttons.Yes.value: Changed.REPLACE}
        return answers.get(box.exec(), Changed.CANCEL)

    def _whole(self, chosen: str, suffix: str) -> str:
        """Return a chosen name with its suffix, or nothing; the system asked only about the name as typed."""
        if not chosen or chosen.lower().endswith(suffix):
            return chosen
        whole = chosen + suffix
        if not Path(whole).exists():
            return whole
        question = QCoreApplication.translate("Dialogs", "“%1” is there already. Replace it?")
        agrees = self._agrees(
            question.replace("%1", Path(whole).name), "", QCoreApplication.translate("Dialogs", "Replace")
        )
        return whole if agrees else ""

    def _agrees(self, question: str, note: str, yes: str) -> bool:
        box, buttons = self._box(question, note), QMessageBox.StandardButton
        box.setStandardButtons(buttons.Yes | buttons.Cancel)
        box.setDefaultButton(buttons.Cancel)
        box.button(buttons.Yes).setText(yes)
        box.button(buttons.Cancel).setText(QCoreApplication.translate("Dialogs", "Cancel"))
        return box.exec() == buttons.Yes.value

    def _box(self, question: str, note: str) -> QMessageBox:
        box = QMessageBox(self._parent)
        box.setIcon(QMessageBox.Icon.Warning)
        box.setWindowTitle("Kagezou")
        box.setText(question)
        box.setInformativeText(note)
        return box

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
