"""The question by which name a look is kept, and whether with its light and ground."""

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QDialog, QDialogButtonBox, QFormLayout, QLineEdit, QWidget

MOST_LETTERS = 80


class StyleName(QDialog):
    """Asks for the name of a style; there is no style without one."""

    given = Signal(str, bool)
    """The name, and whether light, ground and set-up are kept too."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Keep as a style"))
        self.name = QLineEdit()
        self.name.setMaxLength(MOST_LETTERS)
        self.with_scene = QCheckBox(self.tr("Keep the light and the ground, too"))
        self.with_scene.setToolTip(
            self.tr("Light, ground, field of view and the look of the set's shadow, as they are on this canvas.")
        )
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel)
        buttons.button(QDialogButtonBox.StandardButton.Cancel).setText(self.tr("Cancel"))
        self.ok = buttons.button(QDialogButtonBox.StandardButton.Ok)
        self.ok.setEnabled(False)
        self.name.textChanged.connect(lambda name: self.ok.setEnabled(bool(name.strip())))
        buttons.accepted.connect(self._give)
        buttons.rejected.connect(self.reject)
        rows = QFormLayout(self)
        rows.addRow(self.tr("Name"), self.name)
        rows.addRow(self.with_scene)
        rows.addRow(buttons)

    def _give(self) -> None:
        self.accept()
        self.given.emit(self.name.text(), self.with_scene.isChecked())
