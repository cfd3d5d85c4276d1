"""Light, looks, ground and set of another project, in one dialog that says what comes of them before it changes."""

from collections.abc import Sequence
from typing import Final

from PySide6.QtCore import QCoreApplication, Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QDialog,
    QHeaderView,
    QLabel,
    QPushButton,
    QScrollArea,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)

from kagezou.document.model import Document
from kagezou.document.taking import Part, figures_of, model_of, taken
from kagezou.message import Message
from kagezou.ui.system.words import translated
from kagezou.ui.widgets.in_row import in_row

_SAID_LINES: Final = 6
_ROWS: Final = 4


class TakingDialog(QDialog):
    """Asks what is taken of a project, and whose looks.

    Parameters
    ----------
    document
        The document that it is taken into; it is not changed.
    source
        The other project.
    name
        What that is called.

    Attributes
    ----------
    parts, figures, says, take
        A box for each part, the characters, what comes of the choice, and the button that agrees.
    """

    chosen = Signal(object, object)
    """The Document with what was taken, and the messages that are said of it."""

    def __init__(self, document: Document, source: Document, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Take from %1").replace("%1", name))
        self._document, self._source, self._name = document, source, name
        self._taken = document
        self._notes: tuple[Message, ...] = ()
        self.parts = {part: QCheckBox(_words(part)[0]) for part in Part}
        self.figures = QTreeWidget()
        self.says = QLabel()
        self.take = QPushButton(self.tr("Take"))
        self._fill()
        self._lay_out()
        for box in self.parts.values():
            box.toggled.connect(self.refresh)
        self.figures.itemChanged.connect(self.refresh)
        self.take.clicked.connect(self._accept)
        self.refresh()

    def refresh(self) -> None:
        """Show what would come of the choice."""
        parts = [part for part, box in self.parts.items() if box.isChecked()]
        self.figures.setEnabled(Part.LOOK in parts)
        ids = self._ids()
        done = taken(self._document, self._source, parts, figure_ids=ids)
        alone = {part: taken(self._document, self._source, [part], figure_ids=ids).document for part in parts}
        same = [part for part, document in alone.items() if document == self._document]
        self._taken = done.document
        self._notes = (*self._summary(parts, same), *done.notes)
        self.says.setText("\n".join(f"•  {translated(each)}" for each in self._notes))
        self.take.setEnabled(done.document != self._document)

    def _summary(self, parts: list[Part], same: list[Part]) -> list[Message]:
        """Return what is taken, what is the same in both already, and what stays as it is."""
        left = [part for part in Part if part not in parts]
        news = [part for part in parts if part not in same]
        said = [Message("taken from {name}: {parts}", name=self._name, parts=_listed(news))] if news else []
        said += [Message("the same already: {parts}", parts=_listed(same))] if same else []
        return [*said, *([Message("not taken: {parts}", parts=_listed(left))] if left else [])]

    def _ids(self) -> tuple[str, ...]:
        """Return the layers that are ticked."""
        rows = [self.figures.topLevelItem(index) for index in range(self.figures.topLevelItemCount())]
        layers = figures_of(self._document)
        return tuple(
            layer.id
            for layer, row in zip(layers, rows, strict=True)
            if row is not None and row.checkState(0) == Qt.CheckState.Checked
        )

    def _accept(self) -> None:
        self.refresh()
        if self.take.isEnabled():
            self.chosen.emit(self._taken, self._notes)
            self.accept()

    def _fill(self) -> None:
        has = {
            Part.LOOK: bool(figures_of(self._source) and figures_of(self._document)),
            Part.SET: bool(self._source.pieces),
        }
        for part, box in self.parts.items():
            box.setToolTip(_words(part)[1])
            box.setChecked(has.get(part, True))
        self.parts[Part.LOOK].setEnabled(has[Part.LOOK])
        self.figures.setRootIsDecorated(False)
        self.figures.setAccessibleName(self.tr("Characters that get a look"))
        self.figures.setHeaderLabels([self.tr("Character"), self.tr("Looks like")])
        self.figures.header().setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        for layer in figures_of(self._document):
            model = model_of(layer, self._source)
            row = QTreeWidgetItem([layer.name, "–" if model is None else model.name])
            is_locked = layer.marks.is_locked
            row.setFlags(Qt.ItemFlag.ItemIsUserCheckable | (Qt.ItemFlag(0) if is_locked else Qt.ItemFlag.ItemIsEnabled))
            row.setCheckState(0, Qt.CheckState.Unchecked if is_locked else Qt.CheckState.Checked)
            row.setToolTip(0, self.tr("It is locked") if is_locked else "")
            self.figures.addTopLevelItem(row)
        self.says.setObjectName("welcome_hint")
        self.says.setWordWrap(True)
        self.says.setTextFormat(Qt.TextFormat.PlainText)
        self.says.setAlignment(Qt.AlignmentFlag.AlignTop)

    def _lay_out(self) -> None:
        line = self.fontMetrics().lineSpacing()
        heading = QLabel(self.tr("What will change"))
        heading.setObjectName("heading")
        area = QScrollArea()
        area.setWidget(self.says)
        area.setWidgetResizable(True)
        area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        area.setMinimumHeight(_SAID_LINES * line)
        cancel = QPushButton(self.tr("Cancel"))
        cancel.setAutoDefault(False)
        cancel.clicked.connect(self.reject)
        self.take.setDefault(True)
        self.figures.setMinimumHeight((_ROWS + 1) * 2 * line)
        column = QVBoxLayout(self)
        column.setContentsMargins(16, 16, 16, 14)
        column.setSpacing(10)
        column.addWidget(in_row(*self.parts.values(), None))
        column.addWidget(self.figures, 1)
        column.addWidget(heading)
        column.addWidget(area, 1)
        column.addWidget(in_row(None, cancel, self.take))
        self.resize(64 * self.fontMetrics().horizontalAdvance("0"), self.sizeHint().height())


def _listed(parts: Sequence[Part]) -> str:
    """Return what parts are called, one after the other."""
    return ", ".join(_words(part)[0].replace("&", "").partition("(")[0] for part in parts)


def _words(part: Part) -> tuple[str, str]:
    """Return what a part is called, and what belongs to it."""
    translate = QCoreApplication.translate
    match part:
        case Part.LIGHT:
            return (
                translate("TakingDialog", "&Light"),
                translate("TakingDialog", "The light with its keys, and whether shadows unite"),
            )
        case Part.LOOK:
            return translate("TakingDialog", "L&ooks"), translate(
                "TakingDialog", "The looks of the characters' shadows"
            )
        case Part.GROUND:
            return (
                translate("TakingDialog", "&Ground"),
                translate("TakingDialog", "The ground with its keys, and the camera's field of view"),
            )
        case Part.SET:
            return (
                translate("TakingDialog", "&Set"),
                translate("TakingDialog", "The set pieces, in the place of those there are"),
            )
