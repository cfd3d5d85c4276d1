"""The small dialog that shows how to add a part that this installation does not have."""

import sys
from typing import Final

from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QDialog, QHBoxLayout, QLabel, QLineEdit, QPushButton, QVBoxLayout, QWidget

from kagezou.export.exporters.exporter import Lack
from kagezou.ui.system.words import translated

MOST_WIDE_PX: Final = 900


class MissingPartDialog(QDialog):
    """Says what is missing, and gives the line that adds it.

    Parameters
    ----------
    lack
        What is missing.
    """

    def __init__(self, lack: Lack, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Add a Missing Part"))
        self.command = QLineEdit(command_for(lack.extra))
        self.command.setReadOnly(True)
        self.command.setAccessibleName(self.tr("Command"))
        self.command.setCursorPosition(0)
        self.copy = QPushButton(self.tr("Copy"))
        self.copy.clicked.connect(self._copy)
        self._lay_out(translated(lack.says))

    def _lay_out(self, what: str) -> None:
        steps = QLabel(
            "\n".join(
                (
                    self.tr("1.  Copy this line."),
                    self.tr("2.  Open a terminal (in Windows: PowerShell), paste it there and press Enter."),
                    self.tr("3.  When it is done, close this window: the part is there at once."),
                )
            )
        )
        title = QLabel(self.tr("%1. It costs nothing and is added once:").replace("%1", what))
        for label in (title, steps):
            label.setWordWrap(True)
            label.setTextFormat(Qt.TextFormat.PlainText)
        row = QHBoxLayout()
        row.addWidget(self.command, 1)
        row.addWidget(self.copy)
        close = QPushButton(self.tr("Close"))
        close.setAutoDefault(False)
        close.clicked.connect(self.accept)
        buttons = QHBoxLayout()
        buttons.addStretch(1)
        buttons.addWidget(close)
        column = QVBoxLayout(self)
        column.setContentsMargins(16, 16, 16, 14)
        column.setSpacing(12)
        for widget in (title, steps):
            column.addWidget(widget)
        column.addLayout(row)
        column.addLayout(buttons)
        line = self.fontMetrics().horizontalAdvance(self.command.text()) + 3 * self.fontMetrics().height()
        self.command.setMinimumWidth(min(line, MOST_WIDE_PX))

    def _copy(self) -> None:
        QGuiApplication.clipboard().setText(self.command.text())


def command_for(extra: str) -> str:
    """Return the line that adds an extra to the Python that runs this; one that every shell understands."""
    python = f'& "{sys.executable}"' if sys.platform == "win32" else f"'{sys.executable}'"
    return f"{python} -m pip install 'kagezou[{extra}]'"
