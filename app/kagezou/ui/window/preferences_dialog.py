"""The preferences of the program: every choice takes effect at once, the language when the dialog is closed."""

import os
from dataclasses import replace
from pathlib import Path
from typing import Final

from PySide6.QtCore import QCoreApplication, QLocale, Qt, QUrl, Signal
from PySide6.QtGui import QColor, QDesktopServices
from PySide6.QtWidgets import (
    QColorDialog,
    QComboBox,
    QDialog,
    QFileDialog,
    QFormLayout,
    QLabel,
    QLineEdit,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from kagezou.export.after.hooks import COMMAND_VARIABLE
from kagezou.ui.system.language import languages
from kagezou.ui.system.preferences import (
    LEAST_MEMORY_MB,
    MOST_LETTERS,
    Preferences,
    most_memory_mb,
    preferences_in,
    remember_preferences,
)
from kagezou.ui.system.settings import Settings
from kagezou.ui.viewport.resolution import Resolution
from kagezou.ui.widgets.color_button import Swatch
from kagezou.ui.widgets.in_row import GAP_PX, in_row
from kagezou.ui.widgets.number_boxes import WholeNumberBox

_FOLDERS: Final = ("project", "cels", "background", "export")
_STEP_MB: Final = 128


class PreferencesDialog(QDialog):
    """Shows what is remembered and tells what is chosen.

    Parameters
    ----------
    settings
        Where everything is remembered.
    parent
        The window.
    """

    changed = Signal(object)
    """Other Preferences, which are remembered already."""
    resolution_chosen = Signal(str)
    language_chosen = Signal(str)
    """Sent when the dialog is closed, and only if it is another."""

    def __init__(self, settings: Settings, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Preferences"))
        self._settings = settings
        self._preferences: Preferences = preferences_in(settings)
        self.language, self.resolution, self.surround = QComboBox(), QComboBox(), QComboBox()
        self.swatch = Swatch()
        self.memory = WholeNumberBox()
        self.author = QLineEdit(self._preferences.author)
        self.after_export = QLineEdit(self._preferences.after_export)
        self.folders = {purpose: QLineEdit(settings.settled_folder(purpose)) for purpose in _FOLDERS}
        self._fill()
        self._lay_out()
        self._connect()
        self._show_surround()

    def _fill(self) -> None:
        for code, words in {"": self.tr("As the system"), **languages()}.items():
            self.language.addItem(words, code)
        self.language.setCurrentIndex(max(self.language.findData(self._settings.language), 0))
        for resolution in Resolution:
            self.resolution.addItem(_resolution_words(resolution), resolution.value)
        kept = self._settings.word("resolution", Resolution.AUTO.value)
        self.resolution.setCurrentIndex(max(self.resolution.findData(kept), 0))
        for words, color in surrounds().items():
            self.surround.addItem(words, color)
        self.surround.addItem(self.tr("Own colour…"), None)
        self.memory.setRange(LEAST_MEMORY_MB, max(most_memory_mb(), self._preferences.memory_mb))
        self.memory.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.memory.setSingleStep(_STEP_MB)
        self.memory.setSuffix(" MB")
        self.memory.setValue(self._preferences.memory_mb)
        self.author.setMaxLength(MOST_LETTERS)
        self.after_export.setPlaceholderText(os.environ.get(COMMAND_VARIABLE) or self.tr("a command, if any"))
        self.after_export.setToolTip(
            self.tr("It runs when everything of an export is there, with a JSON file that says what was made.")
        )
        self.author.setPlaceholderText(replace(self._preferences, author="").signature)

    def _connect(self) -> None:
        self.resolution.activated.connect(lambda _index: self.resolution_chosen.emit(self.resolution.currentData()))
        self.surround.activated.connect(lambda _index: self._choose_surround())
        self.swatch.clicked.connect(self._pick)
        self.memory.valueChanged.connect(lambda value: self._prefer(replace(self._preferences, memory_mb=value)))
        self.author.editingFinished.connect(
            lambda: self._prefer(replace(self._preferences, author=self.author.text().strip()))
        )
        self.after_export.editingFinished.connect(
            lambda: self._prefer(replace(self._preferences, after_export=self.after_export.text().strip()))
        )
        for purpose, field in self.folders.items():
            field.editingFinished.connect(lambda purpose=purpose: self._settle(purpose))
        self.finished.connect(lambda _result: self._tell_language())

    def _prefer(self, preferences: Preferences) -> None:
        if preferences != self._preferences:
            self._preferences = preferences
            remember_preferences(self._settings, preferences)
            self.changed.emit(preferences)
        self._show_surround()

    def _choose_surround(self) -> None:
        color = self.surround.currentData()
        if color is None:
            self._pick()
        else:
            self._prefer(replace(self._preferences, surround=color))

    def _pick(self) -> None:
        """Let a colour be picked; the picture's surroundings show each one that is tried."""
        before = self._preferences
        dialog = QColorDialog(QColor(before.surround), self)
        dialog.setWindowTitle(self.tr("Colour around the picture"))
        dialog.setOption(QColorDialog.ColorDialogOption.DontUseNativeDialog)
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.currentColorChanged.connect(
            lambda color: self._prefer(replace(self._preferences, surround=color.name()))
        )
        dialog.rejected.connect(lambda: self._prefer(replace(self._preferences, surround=before.surround)))
        dialog.open()

    def _show_surround(self) -> None:
        color = self._preferences.surround
        self.swatch.color = QColor(color)
        self.swatch.update()
        known = self.surround.findData(color)
        self.surround.setCurrentIndex(known if known >= 0 else self.surround.count() - 1)

    def _settle(self, purpose: str) -> None:
        """Begin always in the folder that was typed; one that is not there is not taken, and shown so."""
        field = self.folders[purpose]
        typed = field.text().strip()
        path = Path(typed).expanduser() if typed else None
        if path is not None and not path.is_dir():
            field.setText(self._settings.settled_folder(purpose))
            self.says.setText(self.tr("%1: there is no such folder").replace("%1", typed))
            return
        self.says.setText("")
        self._settings.settle_folder(purpose, "" if path is None else str(path))
        field.setText("" if path is None else str(path))

    def _browse(self, purpose: str) -> None:
        start = self.folders[purpose].text() or self._settings.folder(purpose) or str(Path.home())
        chosen = QFileDialog.getExistingDirectory(self, self.tr("Choose a Folder"), start)
        if chosen:
            self.folders[purpose].setText(chosen)
            self._settle(purpose)

    def _tell_language(self) -> None:
        code = self.language.currentData()
        if code != self._settings.language:
            self.language_chosen.emit(code)

    def _lay_out(self) -> None:
        form = QFormLayout()
        form.setHorizontalSpacing(2 * GAP_PX)
        form.setVerticalSpacing(GAP_PX + 2)
        note = _hint(self.tr("The window speaks it when this dialog is closed."))
        form.addRow(self.tr("Language"), in_row(self.language, note, None))
        form.addRow(self.tr("Preview resolution"), in_row(self.resolution, None))
        form.addRow(self.tr("Around the picture"), in_row(self.surround, self.swatch, None))
        size = QLocale().toString(most_memory_mb())
        most = _hint(self.tr("of at most %1 MB on this machine").replace("%1", size))
        form.addRow(self.tr("Memory for drawings"), in_row(self.memory, most, None))
        form.addRow(self.tr("Name under notes"), in_row(self.author, None))
        form.addRow(self.tr("Unsaved work"), self._kept_row())
        form.addRow(self.tr("After an export"), in_row(self.after_export))
        for purpose, words in _folder_words().items():
            form.addRow(words, self._folder_row(purpose, words))
        for box, words in (
            (self.language, self.tr("Language")),
            (self.resolution, self.tr("Preview resolution")),
            (self.surround, self.tr("Around the picture")),
            (self.memory, self.tr("Memory for drawings")),
            (self.author, self.tr("Name under notes")),
            (self.after_export, self.tr("After an export")),
        ):
            box.setAccessibleName(words)
        self.says = QLabel()
        self.says.setObjectName("problem")
        self.says.setWordWrap(True)
        close = QPushButton(self.tr("Close"))
        close.setDefault(True)
        close.clicked.connect(self.accept)
        column = QVBoxLayout(self)
        column.setContentsMargins(16, 16, 16, 14)
        column.setSpacing(10)
        column.addLayout(form)
        column.addWidget(self.says)
        column.addStretch(1)
        column.addWidget(in_row(None, close))
        self.resize(76 * self.fontMetrics().horizontalAdvance("0"), self.sizeHint().height())

    def _folder_row(self, purpose: str, words: str) -> QWidget:
        field = self.folders[purpose]
        field.setPlaceholderText(self.tr("the folder last used"))
        field.setAccessibleName(words)
        browse = QPushButton(self.tr("Browse…"))
        browse.setObjectName("small_button")
        browse.setAutoDefault(False)
        browse.clicked.connect(lambda: self._browse(purpose))
        return in_row(field, browse)

    def _kept_row(self) -> QWidget:
        """Say when and where unsaved work is put aside."""
        folder = self._settings.recovery_folder
        field = QLineEdit(str(folder))
        field.setReadOnly(True)
        field.setAccessibleName(self.tr("Where unsaved work is put aside"))
        field.setToolTip(self.tr("Unsaved work is put aside by itself while you work, and offered after a crash"))
        show = QPushButton(self.tr("Show Folder"))
        show.setObjectName("small_button")
        show.setAutoDefault(False)
        show.setEnabled(folder.is_dir())
        show.clicked.connect(lambda: QDesktopServices.openUrl(QUrl.fromLocalFile(str(folder))))
        return in_row(field, show)


def surrounds() -> dict[str, str]:
    """Return the greys to choose from by their names; neutral, so that no colour is judged beside another."""
    translate = QCoreApplication.translate
    return {
        translate("PreferencesDialog", "Dark grey"): "#1e1e1e",
        translate("PreferencesDialog", "Middle grey"): "#484848",
        translate("PreferencesDialog", "Light grey"): "#9a9a9a",
        translate("PreferencesDialog", "White"): "#f0f0f0",
    }


def _folder_words() -> dict[str, str]:
    translate = QCoreApplication.translate
    return {
        "project": translate("PreferencesDialog", "Projects begin in"),
        "cels": translate("PreferencesDialog", "Cels begin in"),
        "background": translate("PreferencesDialog", "Backgrounds begin in"),
        "export": translate("PreferencesDialog", "Exports begin in"),
    }


def _resolution_words(resolution: Resolution) -> str:
    translate = QCoreApplication.translate
    match resolution:
        case Resolution.AUTO:
            return translate("PreferencesDialog", "Automatic: lower while dragging")
        case Resolution.FULL:
            return translate("PreferencesDialog", "Full")
        case Resolution.HALF:
            return translate("PreferencesDialog", "Half")
        case Resolution.QUARTER:
            return translate("PreferencesDialog", "Quarter")


def _hint(words: str) -> QLabel:
    label = QLabel(words)
    label.setObjectName("welcome_hint")
    return label
