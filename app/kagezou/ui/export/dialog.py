"""The export dialog: whom it is for, how, where, and what will be written before anything is."""

import importlib
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QDialog,
    QFileDialog,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from kagezou.document.model import Document
from kagezou.errors import UsageProblem
from kagezou.export.choices import ExportChoices, Place
from kagezou.export.exporters.table import depths_of, exporter_of, sound
from kagezou.ui.export.options import GAP_PX, ExportOptions
from kagezou.ui.export.preset_row import PresetRow
from kagezou.ui.export.targets import TargetList
from kagezou.ui.system.manual_page import PAGE
from kagezou.ui.system.words import translated
from kagezou.ui.widgets.missing_parts import MissingParts

_SAYS_LINES = 2
"""So many lines are kept free for what stands in the way."""


class ExportDialog(QDialog):
    """Asks for everything at once; the preview follows every choice, and nothing else moves.

    Parameters
    ----------
    document
        What is exported.
    choices
        What was chosen the last time.
    place
        Where it is proposed to go, and what the project is called.
    preset_folder
        Where the presets lie.
    """

    chosen = Signal(object, object)
    """Choices, and the place the export goes to."""

    def __init__(
        self,
        document: Document,
        choices: ExportChoices,
        place: Place,
        preset_folder: Path,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.setProperty(PAGE, "export")
        self.setWindowTitle(self.tr("Export"))
        self._document, self._place = document, place
        self.targets = TargetList()
        self.presets = PresetRow(preset_folder)
        self.folder = QLineEdit(str(place.folder))
        self.options = ExportOptions(document)
        self.preview = QListWidget()
        self.preview.setSelectionMode(QListWidget.SelectionMode.NoSelection)
        self.preview.setAccessibleName(self.tr("What will be written"))
        # A scroll bar that comes and goes would move what stands above it.
        self.preview.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.preview.setTextElideMode(Qt.TextElideMode.ElideMiddle)
        self.says = QLabel()
        self.says.setWordWrap(True)
        self.says.setObjectName("problem")
        self.how = QPushButton(self.tr("How to Add It…"))
        self.go = QPushButton(self.tr("Export"))
        self._formats: dict[str, str] = {}
        self._lay_out()
        self.choices = self._possible(choices)
        self.targets.picked.connect(lambda kind: self.change(kind=kind))
        self.presets.picked.connect(self.show_choices)
        self.presets.failed.connect(self._say)
        self.options.changed.connect(lambda what: self.change(**what))
        self.show_choices(self.choices)
        self.presets.reload()
        self.go.setFocus()

    def show_choices(self, choices: ExportChoices) -> None:
        """Stand as it was chosen, as far as this document allows."""
        self.choices = self._possible(choices)
        self._formats[self.choices.kind] = self.choices.format
        self.targets.show_kind(self.choices.kind)
        self.options.show_choices(self.choices)
        self.presets.show_choices(self.choices)
        self.refresh()

    def change(self, **what: object) -> None:
        """Choose something else; each kind keeps the format that was chosen for it.

        A depth that was the only one there was has not been chosen and is not kept.
        """
        changed = replace(self.choices, **what)  # type: ignore[arg-type] # by name
        if changed.kind != self.choices.kind:
            changed = replace(changed, format=self._formats.get(changed.kind, changed.format))
        if "depth" not in what and changed.format != self.choices.format and len(depths_of(self.choices.format)) == 1:
            changed = replace(changed, depth=depths_of(changed.format)[0])
        self.show_choices(changed)

    def refresh(self) -> None:
        """Show what would be written, or why nothing can be."""
        self.preview.clear()
        exporter = exporter_of(self.choices)
        problem = ""
        try:
            for line in exporter.preview(self._document, self.choices, self._place_now()):
                item = QListWidgetItem(line, self.preview)
                item.setToolTip(line)
        except UsageProblem as refused:
            problem = translated(refused)
        if not problem and not self.folder.text().strip():
            problem = self.tr("Choose a folder.")
        lack = exporter.lacks()
        self.how.setVisible(lack is not None)
        self._say(problem if lack is None else translated(lack.says))
        self.go.setEnabled(not problem and lack is None)

    def _say(self, problem: str) -> None:
        self.says.setText(problem[:1].upper() + problem[1:])
        self.says.setToolTip(problem)

    def _possible(self, choices: ExportChoices) -> ExportChoices:
        """Return the choices without what this document does not have."""
        if choices.video_layer not in [layer.name for layer in self._document.layers]:
            choices = replace(choices, video_layer="")
        return sound(choices)

    def _place_now(self) -> Place:
        return replace(self._place, folder=Path(self.folder.text().strip()).expanduser())

    def _lay_out(self) -> None:
        column = QVBoxLayout(self)
        column.setContentsMargins(16, 16, 16, 14)
        column.setSpacing(10)
        column.addWidget(self.presets)
        heading = QLabel(self.tr("What will be written"))
        heading.setObjectName("heading")
        middle = QGridLayout()
        middle.setHorizontalSpacing(18)
        middle.setVerticalSpacing(4)
        middle.addWidget(self.targets, 0, 0, 2, 1)
        middle.addWidget(self.options, 0, 1, 2, 1)
        middle.addWidget(heading, 0, 2)
        middle.addWidget(self.preview, 1, 2)
        middle.setColumnStretch(2, 1)
        middle.setRowStretch(1, 1)
        column.addLayout(middle, 1)
        column.addLayout(self._folder_row())
        column.addLayout(self._last_row())
        letter = self.fontMetrics().horizontalAdvance("0")
        self.preview.setMinimumWidth(34 * letter)

    def _folder_row(self) -> QGridLayout:
        rows = QGridLayout()
        rows.setHorizontalSpacing(GAP_PX)
        rows.setVerticalSpacing(3)
        label = QLabel(self.tr("Folder"))
        label.setBuddy(self.folder)
        browse = QPushButton(self.tr("Browse…"))
        browse.setAutoDefault(False)
        browse.clicked.connect(self._browse)
        self.folder.textChanged.connect(self.refresh)
        for number, widget in enumerate((label, self.folder, browse)):
            rows.addWidget(widget, 0, number)
        self.place_note = QLabel(
            self.tr("The project is not saved yet, so a folder in your documents is proposed.")
            if self._place.project is None
            else self.tr("Another folder than the one beside the project is remembered for this project.")
        )
        self.place_note.setObjectName("welcome_hint")
        rows.addWidget(self.place_note, 1, 1)
        return rows

    def _last_row(self) -> QHBoxLayout:
        """Return what stands in the way, and the buttons; the room for words is kept while there are none."""
        self.says.setMinimumHeight(_SAYS_LINES * self.fontMetrics().lineSpacing())
        self.says.setAlignment(Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft)
        self.how.setAutoDefault(False)
        self.how.clicked.connect(self._show_how)
        policy = self.how.sizePolicy()
        policy.setRetainSizeWhenHidden(True)
        self.how.setSizePolicy(policy)
        cancel = QPushButton(self.tr("Cancel"))
        cancel.clicked.connect(self.reject)
        self.go.setDefault(True)
        self.go.clicked.connect(self._accept)
        row = QHBoxLayout()
        row.setSpacing(GAP_PX)
        row.addWidget(self.says, 1)
        for button in (self.how, cancel, self.go):
            row.addWidget(button)
        return row

    def _browse(self) -> None:
        chosen = QFileDialog.getExistingDirectory(self, self.tr("Export To"), self.folder.text())
        if chosen:
            self.folder.setText(chosen)

    def _show_how(self) -> None:
        lack = exporter_of(self.choices).lacks()
        if lack is None:
            return
        dialog = MissingParts((lack.extra,), self)
        dialog.finished.connect(self._look_again)
        dialog.open()

    def _look_again(self) -> None:
        """Take what was installed meanwhile."""
        importlib.invalidate_caches()
        self.refresh()

    def _accept(self) -> None:
        self.chosen.emit(self.choices, self._place_now())
        self.accept()
