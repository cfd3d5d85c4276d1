"""What came of a retake: which drawing became which, and where to look."""

from PySide6.QtCore import QCoreApplication, Qt, Signal
from PySide6.QtWidgets import (
    QDialog,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QPushButton,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)

from kagezou.importing.retakes.matching import How
from kagezou.importing.retakes.report import Report, Row
from kagezou.ui.system.theme import CHANGED, DIM, WARNING
from kagezou.ui.system.words import translated

_LETTERS = 72
_ROWS_SHOWN = 12


class RetakeResult(QDialog):
    """Stands beside the window, which may be worked in; drawings that are as before come last, as nobody looks at them.

    Parameters
    ----------
    report
        What came of it.

    Attributes
    ----------
    rows, look
        The drawings, and the button that leads to the first frame to look at.
    """

    frame_asked = Signal(int)

    def __init__(self, report: Report, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Replaced Drawings: %1").replace("%1", report.name))
        self.setAttribute(Qt.WidgetAttribute.WA_ShowWithoutActivating)
        self.words = QLabel("\n".join(translated(each) for each in report.messages))
        self.words.setWordWrap(True)
        self.words.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.rows = QTreeWidget()
        self.rows.setRootIsDecorated(False)
        self.rows.setHeaderLabels([self.tr("Before"), self.tr("Now"), self.tr("Known again by")])
        self.rows.header().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        self.rows.addTopLevelItems([_item(row) for row in sorted(report.rows, key=_weight)])
        self.look = QPushButton(self.tr("Go to the First Frame to Look At"))
        self.look.setEnabled(bool(report.frames))
        self.look.clicked.connect(lambda: self.frame_asked.emit(report.frames[0]))
        close = QPushButton(self.tr("Close"))
        close.setDefault(True)
        close.clicked.connect(self.accept)
        buttons = QHBoxLayout()
        buttons.addWidget(self.look)
        buttons.addStretch(1)
        buttons.addWidget(close)
        column = QVBoxLayout(self)
        column.setContentsMargins(16, 16, 16, 14)
        column.setSpacing(10)
        column.addWidget(self.words)
        column.addWidget(self.rows, 1)
        column.addLayout(buttons)
        metrics = self.fontMetrics()
        self.rows.setMinimumHeight(_ROWS_SHOWN * metrics.height())
        self.resize(_LETTERS * metrics.horizontalAdvance("0"), self.sizeHint().height())


def _item(row: Row) -> QTreeWidgetItem:
    item = QTreeWidgetItem([row.before or "–", row.after or "–", _how(row)])
    color = DIM if row.how in (How.SAME, How.PICTURE) else WARNING if row.after is None else CHANGED
    for column in range(3):
        item.setForeground(column, color)
    return item


def _weight(row: Row) -> int:
    """Return where a row stands: what is new or gone first, then other pictures, then what only moved."""
    return 0 if row.how is None else {How.PICTURE: 2, How.SAME: 3}.get(row.how, 1)


def _how(row: Row) -> str:
    translate = QCoreApplication.translate
    match row.how:
        case How.SAME:
            return translate("RetakeResult", "name and picture")
        case How.NAME:
            return translate("RetakeResult", "name; another picture")
        case How.PICTURE:
            return translate("RetakeResult", "picture")
        case How.LIKENESS:
            return translate("RetakeResult", "likeness")
        case How.ORDER:
            return translate("RetakeResult", "order")
        case None if row.before is None:
            return translate("RetakeResult", "new")
        case None:
            return translate("RetakeResult", "gone")
