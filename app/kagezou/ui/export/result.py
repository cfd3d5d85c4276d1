"""What came of an export: where it is, what there is of each kind, and what to do with it next."""

from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QDialog,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from kagezou.export.exporters.exporter import ExportOutcome
from kagezou.ui.system.clipboard import SystemClipboard
from kagezou.ui.system.desktop import show_in_folder
from kagezou.ui.system.manual_page import PAGE
from kagezou.ui.system.words import translated


class ExportResult(QDialog):
    """The last page of an export; the window may be worked in while it stands.

    Parameters
    ----------
    outcome
        What came of it.
    """

    def __init__(self, outcome: ExportOutcome, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Export"))
        self.setProperty(PAGE, "export")
        self.setAttribute(Qt.WidgetAttribute.WA_ShowWithoutActivating)
        self._where = outcome.where
        self.title = _label(self._title(outcome), "set_name")
        self.path = QLineEdit(str(outcome.where))
        self.path.setReadOnly(True)
        self.path.setAccessibleName(self.tr("Folder"))
        self.path.setToolTip(str(outcome.where))
        self.counts = [(translated(each.kind), self._count(each.there, each.files)) for each in outcome.counts]
        self.notes = [translated(each) for each in outcome.notes]
        self.steps = [translated(each) for each in outcome.next_steps]
        self.says = _label("", "problem")
        if outcome.problem is not None:
            self.says.setText(translated(outcome.problem))
        self.show_button = QPushButton(self.tr("Show in Folder"))
        self.copy_button = QPushButton(self.tr("Copy Path"))
        self._lay_out(outcome)

    def _title(self, outcome: ExportOutcome) -> str:
        if not outcome.is_whole:
            words = self.tr("The export was stopped: %1 of %2 files are there, all whole.")
            if outcome.problem is not None:
                words = self.tr("The export is not complete: %1 of %2 files are there, all whole.")
            return words.replace("%1", str(outcome.there)).replace("%2", str(outcome.files))
        return self.tr("The export is complete.")

    def _count(self, there: int, files: int) -> str:
        if there == files:
            return str(files)
        return self.tr("%1 of %2").replace("%1", str(there)).replace("%2", str(files))

    def _lay_out(self, outcome: ExportOutcome) -> None:
        column = QVBoxLayout(self)
        column.setContentsMargins(16, 16, 16, 14)
        column.setSpacing(10)
        column.addWidget(self.title)
        column.addWidget(self.path)
        column.addLayout(self._count_rows(outcome))
        for note in self.notes:
            column.addWidget(_label(note, "problem"))
        if self.steps:
            heading = self.tr("What to do next") if outcome.is_whole else self.tr("How to go on")
            column.addWidget(_label(heading, "heading"))
            column.addLayout(_numbered(self.steps))
        column.addWidget(self.says)
        self.says.setVisible(bool(self.says.text()))
        column.addStretch(1)
        column.addLayout(self._buttons())
        self.setMinimumWidth(78 * self.fontMetrics().horizontalAdvance("0"))

    def _count_rows(self, outcome: ExportOutcome) -> QGridLayout:
        rows = QGridLayout()
        rows.setHorizontalSpacing(24)
        rows.setVerticalSpacing(3)
        for number, (kind, count) in enumerate(self.counts):
            rows.addWidget(QLabel(kind), number, 0)
            amount = QLabel(count)
            amount.setAlignment(Qt.AlignmentFlag.AlignRight)
            rows.addWidget(amount, number, 1)
        kept = outcome.there - outcome.written
        if kept:
            words = self.tr("Already there, and left as they were: %1").replace("%1", str(kept))
            rows.addWidget(_label(words, "welcome_hint"), len(self.counts), 0, 1, 3)
        rows.setColumnStretch(2, 1)
        return rows

    def _buttons(self) -> QHBoxLayout:
        close = QPushButton(self.tr("Close"))
        close.setDefault(True)
        close.clicked.connect(self.accept)
        self.show_button.clicked.connect(self._show)
        self.copy_button.clicked.connect(self._copy)
        row = QHBoxLayout()
        for button in (self.show_button, self.copy_button):
            button.setAutoDefault(False)
            row.addWidget(button)
        row.addStretch(1)
        row.addWidget(close)
        return row

    def _show(self) -> None:
        where = _nearest(self._where)
        if not show_in_folder(where):
            self.says.setText(self.tr("No program of this desktop opens folders; the path can be copied."))
            self.says.show()

    def _copy(self) -> None:
        SystemClipboard().put(str(self._where))


def _nearest(path: Path) -> Path:
    """Return a path, or the nearest folder above it that is there: a stopped export may have made none."""
    return next((each for each in (path, *path.parents) if each.exists()), path)


def _numbered(steps: list[str]) -> QGridLayout:
    rows = QGridLayout()
    rows.setHorizontalSpacing(8)
    rows.setVerticalSpacing(6)
    for number, step in enumerate(steps):
        sign = QLabel(f"{number + 1}.")
        sign.setAlignment(Qt.AlignmentFlag.AlignTop)
        rows.addWidget(sign, number, 0)
        rows.addWidget(_label(step), number, 1)
    rows.setColumnStretch(1, 1)
    return rows


def _label(words: str, name: str = "") -> QLabel:
    label = QLabel(words)
    label.setObjectName(name)
    label.setTextFormat(Qt.TextFormat.PlainText)
    label.setWordWrap(True)
    label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
    return label
