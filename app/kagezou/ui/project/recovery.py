"""After a crash: what was put aside, and whether it shall come back."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QDateTime, QLocale, Qt, QUrl, Signal
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import (
    QDialog,
    QHBoxLayout,
    QLabel,
    QListWidget,
    QListWidgetItem,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from kagezou.errors import Problem
from kagezou.io.project.recovery_file import RecoveredWork, forget, read_recovery_file
from kagezou.ui.project.keepsakes import is_abandoned
from kagezou.ui.system.words import translated

_FILE = Qt.ItemDataRole.UserRole


class RecoveryDialog(QDialog):
    """Lists what was put aside and not saved; closing it keeps everything for the next start.

    Parameters
    ----------
    files
        Keepsakes of programs that are gone.
    parent
        The window.
    """

    recovered = Signal(object, object)
    """A keepsake shall come back, and the file it lies in."""
    failed = Signal(str)

    def __init__(self, files: tuple[Path, ...], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Recover Unsaved Work"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self._work: dict[Path, RecoveredWork] = {}
        self.list = QListWidget()
        self.list.setAlternatingRowColors(True)
        self.list.setSpacing(3)
        # A line never grows wider than the list; a long path loses its middle.
        self.list.setWordWrap(True)
        self.list.setTextElideMode(Qt.TextElideMode.ElideMiddle)
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.recover_button = self._button(self.tr("Recover"), self._recover)
        self.recover_button.setDefault(True)
        self.discard_button = self._button(self.tr("Discard"), self._discard)
        self._lay_out()
        for file in files:
            self._add(file)
        self.list.itemSelectionChanged.connect(self._show_choice)
        self.list.itemActivated.connect(lambda _item: self._recover())
        self.list.setCurrentRow(0)
        self._show_choice()

    def _lay_out(self) -> None:
        words = QLabel(self.tr("Kagezou ended before this work was saved. It was put aside:"))
        words.setWordWrap(True)
        buttons = QHBoxLayout()
        buttons.addWidget(self._button(self.tr("Show Folder"), self._show_folder))
        buttons.addStretch(1)
        buttons.addWidget(self.discard_button)
        buttons.addWidget(self._button(self.tr("Later"), self.reject))
        buttons.addWidget(self.recover_button)
        column = QVBoxLayout(self)
        column.setContentsMargins(16, 16, 16, 14)
        column.setSpacing(12)
        column.addWidget(words)
        column.addWidget(self.list, 1)
        column.addLayout(buttons)
        letter = self.fontMetrics().horizontalAdvance("0")
        self.resize(78 * letter, 18 * self.fontMetrics().height())

    def _button(self, words: str, do: Callable[[], object]) -> QPushButton:
        button = QPushButton(words)
        button.setAutoDefault(False)
        button.clicked.connect(do)
        return button

    def _add(self, file: Path) -> None:
        item = QListWidgetItem()
        item.setData(_FILE, file)
        try:
            work = read_recovery_file(file)
        except Problem as problem:
            item.setText(translated(problem))
        else:
            self._work[file] = work
            when = QLocale().toString(QDateTime.fromSecsSinceEpoch(work.kept_at_s), QLocale.FormatType.ShortFormat)
            where = str(work.path) if work.path else self.tr("never saved")
            steps = self.tr("%n step(s)", "", work.edits)
            lines = [work.name, f"{when}   ·   {steps}", where]
            if work.is_behind:
                lines.append(
                    self.tr("The project was saved after this work began from it; nothing replaces it unasked.")
                )
            item.setText("\n".join(lines))
            item.setToolTip(where)
        self.list.addItem(item)

    def _chosen(self) -> Path | None:
        item = self.list.currentItem()
        return None if item is None else Path(item.data(_FILE))

    def _show_choice(self) -> None:
        self.discard_button.setEnabled(self._chosen() is not None)
        self.recover_button.setEnabled(self._chosen() in self._work)

    def _recover(self) -> None:
        file = self._chosen()
        if file in self._work and file is not None and self._is_free(file):
            self.recovered.emit(self._work[file], file)
            self.accept()

    def _discard(self) -> None:
        file = self._chosen()
        if file is None or not self._is_free(file):
            return
        try:
            forget(file)
        except Problem as problem:
            self.failed.emit(translated(problem))
            return
        self._take_away()

    def _is_free(self, file: Path) -> bool:
        """Whether no other window took this work since it was listed; one that did is said and no longer listed."""
        if is_abandoned(file):
            return True
        self.failed.emit(self.tr("Another window has recovered this work already."))
        self._take_away()
        return False

    def _take_away(self) -> None:
        self.list.takeItem(self.list.currentRow())
        if not self.list.count():
            self.accept()

    def _show_folder(self) -> None:
        file = self._chosen()
        if file is not None:
            QDesktopServices.openUrl(QUrl.fromLocalFile(str(file.parent)))
