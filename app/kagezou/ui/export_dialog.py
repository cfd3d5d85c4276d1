"""The export dialog: whom it is for, how, where, and what will be written before anything is."""

from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import Signal
from PySide6.QtWidgets import (
    QButtonGroup,
    QCheckBox,
    QComboBox,
    QDialog,
    QFileDialog,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QListWidget,
    QPushButton,
    QRadioButton,
    QSpinBox,
    QVBoxLayout,
    QWidget,
)

from kagezou.document.model import Document
from kagezou.errors import UsageProblem
from kagezou.export.request import DEPTHS, SUFFIXES
from kagezou.ui.export_plan import ExportKind, ExportPlan, Place, preview, sound
from kagezou.ui.sentences import sentence_of


class ExportDialog(QDialog):
    """Asks for everything at once; the preview follows every choice.

    Parameters
    ----------
    document
        What is exported.
    plan
        What was chosen the last time.
    place
        Where it went the last time, and what the project is called.
    """

    chosen = Signal(object, object)
    """A plan, and the place it goes to."""

    def __init__(self, document: Document, plan: ExportPlan, place: Place, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Export"))
        self._document, self._place = document, place
        self.plan = sound(plan)
        self.kinds = QButtonGroup(self)
        self.folder = QLineEdit(str(place.folder))
        self.format_box, self.depth_box = QComboBox(), QComboBox()
        self.preview = QListWidget()
        self.preview.setSelectionMode(QListWidget.SelectionMode.NoSelection)
        self.preview.setAccessibleName(self.tr("What will be written"))
        self.says = QLabel()
        self.says.setWordWrap(True)
        self.says.setObjectName("problem")
        self.go = QPushButton(self.tr("Export"))
        self._rows: list[tuple[QWidget, tuple[ExportKind, ...]]] = []
        self._lay_out()
        self._show_formats()
        self.refresh()

    def refresh(self) -> None:
        """Show the options of the kind, and what would be written."""
        for widget, kinds in self._rows:
            widget.setVisible(self.plan.kind in kinds)
        self.preview.clear()
        problem = ""
        try:
            self.preview.addItems(list(preview(self._document, self.plan, self._place_now())))
        except UsageProblem as refused:
            problem = sentence_of(refused)
        if not problem and not self.folder.text().strip():
            problem = self.tr("Choose a folder.")
        self.says.setText(problem)
        self.says.setVisible(bool(problem))
        self.go.setEnabled(not problem)

    def change(self, **what: object) -> None:
        """Choose something else."""
        self.plan = sound(replace(self.plan, **what))  # type: ignore[arg-type]
        self._show_formats()
        self.refresh()

    def _place_now(self) -> Place:
        return replace(self._place, folder=Path(self.folder.text().strip()).expanduser())

    def _lay_out(self) -> None:
        column = QVBoxLayout(self)
        column.setContentsMargins(16, 16, 16, 14)
        column.setSpacing(10)
        column.addLayout(self._kind_row())
        column.addLayout(self._options())
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
        self.resize(76 * letter, 30 * self.fontMetrics().height())

    def _kind_row(self) -> QHBoxLayout:
        row = QHBoxLayout()
        words = {
            ExportKind.LAYERS: self.tr("Shadow layers"),
            ExportKind.AFTER_EFFECTS: self.tr("After Effects"),
            ExportKind.FARM: self.tr("Render farm job"),
        }
        for kind, text in words.items():
            button = QRadioButton(text)
            button.setChecked(kind is self.plan.kind)
            button.toggled.connect(lambda on, each=kind: self.change(kind=each) if on else None)
            self.kinds.addButton(button)
            row.addWidget(button)
        row.addStretch(1)
        return row

    def _options(self) -> QFormLayout:
        form = QFormLayout()
        every = tuple(ExportKind)
        layers, effects, farm = every
        browse = QPushButton(self.tr("Browse…"))
        browse.clicked.connect(self._browse)
        self.folder.textChanged.connect(self.refresh)
        form.addRow(self.tr("Folder"), _beside(self.folder, browse))
        self.format_box.activated.connect(lambda _index: self.change(format=self.format_box.currentData()))
        self.depth_box.activated.connect(lambda _index: self.change(depth=self.depth_box.currentData()))
        form.addRow(self.tr("Format"), _beside(self.format_box, self.depth_box))
        self._tick(form, self.tr("Composite with background and characters"), "composite", (layers, farm))
        self._tick(form, self.tr("Only the work area"), "only_work_area", (layers, farm))
        self._tick(form, self.tr("Each different shadow once, held by time remapping"), "per_drawing", (effects,))
        self._tick(form, self.tr("Copy characters and background into the folder"), "copies", (effects,))
        for matte, words in self._matte_words().items():
            box = QCheckBox(words)
            box.setChecked(matte in self.plan.mattes)
            box.toggled.connect(lambda on, each=matte: self._choose_matte(each, on=on))
            self._add(form, box, (effects,))
        chunk = QSpinBox()
        chunk.setRange(1, 1000)
        chunk.setValue(self.plan.chunk)
        chunk.setSuffix(self.tr(" frames a task"))
        chunk.valueChanged.connect(lambda value: self.change(chunk=value))
        self._add(form, chunk, (farm,))
        self._tick(form, self.tr("Leave frames alone that would come out the same"), "skip_existing", (layers, effects))
        return form

    def _matte_words(self) -> dict[str, str]:
        return {
            "shadow": self.tr("Matte: the shadow alone"),
            "core": self.tr("Matte: the part near the feet"),
            "distance": self.tr("Matte: distance from the feet"),
            "lit": self.tr("Matte: what no shadow lies on"),
        }

    def _tick(self, form: QFormLayout, words: str, name: str, kinds: tuple[ExportKind, ...]) -> None:
        box = QCheckBox(words)
        box.setChecked(bool(getattr(self.plan, name)))
        box.toggled.connect(lambda on: self.change(**{name: on}))
        self._add(form, box, kinds)

    def _add(self, form: QFormLayout, widget: QWidget, kinds: tuple[ExportKind, ...]) -> None:
        form.addRow("", widget)
        self._rows.append((widget, kinds))

    def _choose_matte(self, matte: str, *, on: bool) -> None:
        left = tuple(each for each in self.plan.mattes if each != matte)
        self.change(mattes=(*left, matte) if on else left)

    def _show_formats(self) -> None:
        formats = ("png", "exr") if self.plan.kind is ExportKind.AFTER_EFFECTS else tuple(SUFFIXES)
        _fill(self.format_box, {each.upper(): each for each in formats}, self.plan.format)
        depths = {self.tr("%1 bit").replace("%1", str(each)): each for each in DEPTHS[self.plan.format]}
        _fill(self.depth_box, depths, self.plan.depth)

    def _browse(self) -> None:
        chosen = QFileDialog.getExistingDirectory(self, self.tr("Export To"), self.folder.text())
        if chosen:
            self.folder.setText(chosen)

    def _accept(self) -> None:
        self.chosen.emit(self.plan, self._place_now())
        self.accept()


def _fill(box: QComboBox, choices: dict[str, str] | dict[str, int], chosen: object) -> None:
    box.clear()
    for words, value in choices.items():
        box.addItem(words, value)
    box.setCurrentIndex(box.findData(chosen))


def _beside(first: QWidget, second: QWidget) -> QHBoxLayout:
    row = QHBoxLayout()
    row.addWidget(first, 1)
    row.addWidget(second)
    return row
