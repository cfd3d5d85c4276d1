"""The export dialog: whom it is for, how, where, and what will be written before anything is."""

from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import Signal
from PySide6.QtWidgets import (
    QButtonGroup,
    QDialog,
    QFileDialog,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QListWidget,
    QPushButton,
    QRadioButton,
    QVBoxLayout,
    QWidget,
)

from kagezou.document.model import Document
from kagezou.errors import UsageProblem
from kagezou.export.choices import ExportChoices, Place
from kagezou.export.exporters.table import EXPORTERS, depths_of, exporter_of, sound
from kagezou.ui.export.options import GAP_PX, ExportOptions
from kagezou.ui.export.preset_row import PresetRow
from kagezou.ui.system.words import translated


class ExportDialog(QDialog):
    """Asks for everything at once; the preview follows every choice.

    Parameters
    ----------
    document
        What is exported.
    choices
        What was chosen the last time.
    place
        Where it went the last time, and what the project is called.
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
        self.setWindowTitle(self.tr("Export"))
        self._document, self._place = document, place
        self.kinds = QButtonGroup(self)
        self._buttons: dict[str, QRadioButton] = {}
        self.presets = PresetRow(preset_folder)
        self.folder_label, self.folder = QLabel(self.tr("Folder")), QLineEdit(str(place.folder))
        self.options = ExportOptions(document)
        self.preview = QListWidget()
        self.preview.setSelectionMode(QListWidget.SelectionMode.NoSelection)
        self.preview.setAccessibleName(self.tr("What will be written"))
        self.says = QLabel()
        self.says.setWordWrap(True)
        self.says.setObjectName("problem")
        self.go = QPushButton(self.tr("Export"))
        self._formats: dict[str, str] = {}
        self._lay_out()
        self.choices = self._possible(choices)
        self.presets.picked.connect(self.show_choices)
        self.presets.failed.connect(self._say)
        self.options.changed.connect(lambda what: self.change(**what))
        self.show_choices(self.choices)
        self.presets.reload()
        self.go.setFocus()

    def show_choices(self, choices: ExportChoices) -> None:
        """Stand as it was chosen, as far as this document and this machine allow."""
        self.choices = self._possible(choices)
        self._formats[self.choices.kind] = self.choices.format
        self._buttons[self.choices.kind].setChecked(True)
        self.options.show_choices(self.choices)
        self.presets.show_choices(self.choices)
        self.refresh()

    def change(self, **what: object) -> None:
        """Choose something else; each kind keeps the format that was chosen for it.

        A depth that was the only one there was has not been chosen and is not kept.
        """
        changed = replace(self.choices, **what)  # type: ignore[arg-type]
        if changed.kind != self.choices.kind:
            changed = replace(changed, format=self._formats.get(changed.kind, changed.format))
        if "depth" not in what and changed.format != self.choices.format and len(depths_of(self.choices.format)) == 1:
            changed = replace(changed, depth=depths_of(changed.format)[0])
        self.show_choices(changed)

    def refresh(self) -> None:
        """Show what would be written, or why nothing can be."""
        self.preview.clear()
        problem = ""
        try:
            exporter = exporter_of(self.choices)
            self.preview.addItems(list(exporter.preview(self._document, self.choices, self._place_now())))
        except UsageProblem as refused:
            problem = translated(refused)
        if not problem and not self.folder.text().strip():
            problem = self.tr("Choose a folder.")
        self._say(problem)
        self.go.setEnabled(not problem)

    def _say(self, problem: str) -> None:
        self.says.setText(problem[:1].upper() + problem[1:])
        self.says.setVisible(bool(problem))

    def _possible(self, choices: ExportChoices) -> ExportChoices:
        """Return the choices without what this document or this machine does not have."""
        if choices.video_layer not in [layer.name for layer in self._document.layers]:
            choices = replace(choices, video_layer="")
        if not self._buttons[choices.kind].isEnabled():
            choices = replace(choices, kind=EXPORTERS[0].key)
        return sound(choices)

    def _place_now(self) -> Place:
        return replace(self._place, folder=Path(self.folder.text().strip()).expanduser())

    def _lay_out(self) -> None:
        column = QVBoxLayout(self)
        column.setContentsMargins(16, 16, 16, 14)
        column.setSpacing(10)
        column.addWidget(self.presets)
        column.addLayout(self._kind_row())
        for button in self._buttons.values():
            if not button.isEnabled():
                why = QLabel(button.toolTip())
                why.setObjectName("welcome_hint")
                column.addWidget(why)
        column.addLayout(self._folder_row())
        column.addWidget(self.options)
        labels = (self.presets.label, self.folder_label, *self.options.labels)
        for label in labels:
            label.setMinimumWidth(max(each.sizeHint().width() for each in labels))
        heading = QLabel(self.tr("What will be written"))
        heading.setObjectName("heading")
        column.addWidget(heading)
        column.addWidget(self.preview, 1)
        column.addWidget(self.says)
        buttons = QHBoxLayout()
        buttons.addStretch(1)
        cancel = QPushButton(self.tr("Cancel"))
        cancel.clicked.connect(self.reject)
        self.go.setDefault(True)
        self.go.clicked.connect(self._accept)
        buttons.addWidget(cancel)
        buttons.addWidget(self.go)
        column.addLayout(buttons)
        letter = self.fontMetrics().horizontalAdvance("0")
        self.resize(84 * letter, 34 * self.fontMetrics().height())

    def _kind_row(self) -> QHBoxLayout:
        row = QHBoxLayout()
        for exporter in EXPORTERS:
            button = self._buttons[exporter.key] = QRadioButton(translated(exporter.label))
            button.clicked.connect(lambda _on, each=exporter.key: self.change(kind=each))
            if lacking := exporter.lacks():
                button.setEnabled(False)
                button.setToolTip(translated(lacking))
            self.kinds.addButton(button)
            row.addWidget(button)
        row.addStretch(1)
        return row

    def _folder_row(self) -> QHBoxLayout:
        row = QHBoxLayout()
        row.setSpacing(GAP_PX)
        self.folder_label.setBuddy(self.folder)
        browse = QPushButton(self.tr("Browse…"))
        browse.setAutoDefault(False)
        browse.clicked.connect(self._browse)
        self.folder.textChanged.connect(self.refresh)
        for widget in (self.folder_label, self.folder, browse):
            row.addWidget(widget)
        return row

    def _browse(self) -> None:
        chosen = QFileDialog.getExistingDirectory(self, self.tr("Export To"), self.folder.text())
        if chosen:
            self.folder.setText(chosen)

    def _accept(self) -> None:
        self.chosen.emit(self.choices, self._place_now())
        self.accept()
