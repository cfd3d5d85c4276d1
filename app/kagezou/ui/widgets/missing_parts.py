"""The small dialog that shows how to add parts that this installation does not have."""

import sys
from collections.abc import Sequence
from typing import Final

from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QDialog, QHBoxLayout, QLabel, QLineEdit, QPushButton, QVBoxLayout, QWidget

from kagezou.extras import IN_BUNDLE, Extra, install_words
from kagezou.own_process import is_bundle
from kagezou.ui.system.words import translated

MOST_WIDE_PX: Final = 900


class MissingParts(QDialog):
    """Says what is missing and what for, and gives the line that adds it; of nothing it says just that.

    Parameters
    ----------
    extras
        What is missing.
    """

    def __init__(self, extras: Sequence[Extra], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Missing Parts"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.command = QLineEdit(command_for(extras) if extras else "")
        self.command.setReadOnly(True)
        self.command.setAccessibleName(self.tr("Command"))
        self.command.setCursorPosition(0)
        self.copy = QPushButton(self.tr("Copy"))
        self.copy.clicked.connect(self._copy)
        self.words = [translated(each.purpose) for each in extras]
        self._lay_out()

    def _lay_out(self) -> None:
        column = QVBoxLayout(self)
        column.setContentsMargins(16, 16, 16, 14)
        column.setSpacing(12)
        if self.words:
            self._fill(column)
        else:
            column.addWidget(_label(self.tr("Nothing is missing: every part of the program is installed.")))
        close = QPushButton(self.tr("Close"))
        close.setAutoDefault(False)
        close.clicked.connect(self.accept)
        buttons = QHBoxLayout()
        buttons.addStretch(1)
        buttons.addWidget(close)
        column.addLayout(buttons)

    def _fill(self, column: QVBoxLayout) -> None:
        column.addWidget(_label(self.tr("This installation lacks parts for:")))
        column.addWidget(_label("\n".join(f"•  {each}" for each in self.words)))
        if is_bundle():
            column.addWidget(_label(translated(IN_BUNDLE)))
            return
        steps = (
            self.tr("They cost nothing and are added once:"),
            self.tr("1.  Copy this line."),
            self.tr("2.  Open a terminal (in Windows: PowerShell), paste it there and press Enter."),
            self.tr("3.  When it is done, close this window: the part is there at once."),
        )
        column.addWidget(_label("\n".join(steps)))
        row = QHBoxLayout()
        row.addWidget(self.command, 1)
        row.addWidget(self.copy)
        column.addLayout(row)
        line = self.fontMetrics().horizontalAdvance(self.command.text()) + 3 * self.fontMetrics().height()
        self.command.setMinimumWidth(min(line, MOST_WIDE_PX))

    def _copy(self) -> None:
        QGuiApplication.clipboard().setText(self.command.text())


def command_for(extras: Sequence[Extra]) -> str:
    """Return the line that adds extras to the Python that runs this; one that the usual shells understand."""
    python = f'& "{sys.executable}"' if sys.platform == "win32" else f"'{sys.executable}'"
    packages = tuple(dict.fromkeys(package for extra in extras for package in extra.packages))
    return f"{python} -m pip install {install_words(packages)}"


def _label(words: str) -> QLabel:
    label = QLabel(words)
    label.setWordWrap(True)
    label.setTextFormat(Qt.TextFormat.PlainText)
    return label
