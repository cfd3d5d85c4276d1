"""The row of presets in the export dialog: choose, save, rename, remove."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QInputDialog, QLabel, QPushButton, QWidget

from kagezou.errors import Problem
from kagezou.export.choices import ExportChoices
from kagezou.export.presets import Preset, presets_there, remove_preset, rename_preset, save_preset
from kagezou.ui.export.options import GAP_PX
from kagezou.ui.system.words import translated


class PresetRow(QWidget):
    """A box of presets, of which the one is chosen that is as the dialog stands.

    Parameters
    ----------
    folder
        Where the presets lie.
    """

    picked = Signal(object)
    """The choices of the preset that was picked."""
    failed = Signal(str)

    def __init__(self, folder: Path) -> None:
        super().__init__()
        self._folder = folder
        self._choices = ExportChoices()
        self._presets: tuple[Preset, ...] = ()
        self.box = QComboBox()
        self.box.setAccessibleName(self.tr("Preset"))
        self.box.activated.connect(self._pick)
        self.label = QLabel(self.tr("Preset"))
        self.label.setBuddy(self.box)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(GAP_PX)
        row.addWidget(self.label)
        row.addWidget(self.box, 1)
        self.save_button = self._button(row, self.tr("Save…"), self._ask_to_save)
        self.rename_button = self._button(row, self.tr("Rename…"), self._ask_to_rename)
        self.remove_button = self._button(row, self.tr("Remove"), self.remove)

    def reload(self) -> None:
        """Read the presets again."""
        self._presets, problems = presets_there(self._folder)
        for problem in problems:
            self.failed.emit(translated(problem))
        self._show()

    def show_choices(self, choices: ExportChoices) -> None:
        """Take note of how the dialog stands."""
        self._choices = choices
        self._show()

    def save(self, name: str) -> None:
        """Keep how the dialog stands under a name."""
        self._try(lambda: save_preset(self._folder, name, self._choices))

    def rename(self, name: str) -> None:
        """Give the chosen preset another name."""
        chosen = self._chosen
        if chosen is not None and not chosen.is_studio:
            self._try(lambda: rename_preset(self._folder, chosen, name))

    def remove(self) -> None:
        """Take the chosen preset away; the dialog stays as it is."""
        chosen = self._chosen
        if chosen is not None and not chosen.is_studio:
            self._try(lambda: remove_preset(chosen))

    @property
    def _chosen(self) -> Preset | None:
        found: Preset | None = self.box.currentData()
        return found

    def _button(self, row: QHBoxLayout, words: str, act: Callable[[], None]) -> QPushButton:
        button = QPushButton(words)
        button.setAutoDefault(False)
        button.clicked.connect(act)
        row.addWidget(button)
        return button

    def _show(self) -> None:
        self.box.clear()
        if not self._presets:
            self.box.addItem(self.tr("None saved yet"), None)
        elif all(each.choices != self._choices for each in self._presets):
            self.box.addItem(self.tr("Choices of your own"), None)
        for each in self._presets:
            words = self.tr("%1 (studio)").replace("%1", each.name) if each.is_studio else each.name
            self.box.addItem(words, each)
        kept = next((row for row, each in enumerate(self._presets) if each.choices == self._choices), None)
        self.box.setCurrentIndex(0 if kept is None else kept)
        self.box.setEnabled(bool(self._presets))
        is_own = self._chosen is not None and not self._chosen.is_studio
        reason = "" if is_own else self.tr("Choose one of your presets first.")
        for button in (self.rename_button, self.remove_button):
            button.setEnabled(not reason)
            button.setToolTip(reason)

    def _pick(self) -> None:
        chosen = self._chosen
        if chosen is not None:
            self.picked.emit(chosen.choices)

    def _ask_to_save(self) -> None:
        before = self._chosen
        name, given = QInputDialog.getText(
            self, self.tr("Save as a Preset"), self.tr("Name"), text="" if before is None else before.name
        )
        if given:
            self.save(name)

    def _ask_to_rename(self) -> None:
        chosen = self._chosen
        if chosen is None:
            return
        name, given = QInputDialog.getText(self, self.tr("Rename the Preset"), self.tr("Name"), text=chosen.name)
        if given:
            self.rename(name)

    def _try(self, act: Callable[[], object]) -> None:
        try:
            act()
        except Problem as problem:
            self.failed.emit(translated(problem))
        self.reload()
