"""The keys of one property as a table to read, to type into, and to copy to spreadsheets and back."""

from collections.abc import Callable

from PySide6.QtCore import QEvent, QSignalBlocker, Qt, Signal
from PySide6.QtGui import QKeyEvent, QKeySequence
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableWidget, QTableWidgetItem

from kagezou.animation.track import Interpolation
from kagezou.document.address import Address
from kagezou.document.frame_numbers import number_of
from kagezou.document.model import Document
from kagezou.errors import UsageProblem
from kagezou.ui.curves.choice import Choice
from kagezou.ui.curves.key_rows import KeyRow, in_frames, pasted, rows_of, text_of, with_cell
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.clipboard import Clipboard
from kagezou.ui.system.shown_units import shown_unit
from kagezou.ui.system.words import translated

_FRAME_COLUMN = 0
_FIXED_COLUMNS = (1,)
_INTERPOLATION_COLUMN = 3


class KeyTable(QTableWidget):
    """Shows the keys of the property of the first selected key, else of the first curve."""

    refused = Signal(str)

    def __init__(self, bridge: Bridge, choice: Choice, clipboard: Clipboard) -> None:
        super().__init__(0, 8)
        self._bridge, self._choice, self._clipboard = bridge, choice, clipboard
        self._rows: tuple[KeyRow, ...] = ()
        self.setHorizontalHeaderLabels([
            self.tr("Frame"), self.tr("Part"), self.tr("Value"), self.tr("Goes on"),
            self.tr("Speed in /frame"), self.tr("Infl. in %"), self.tr("Speed out /frame"), self.tr("Infl. out %"),
        ])  # fmt: skip
        self.verticalHeader().hide()
        self.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + 6)
        self.horizontalHeader().setResizeContentsPrecision(0)
        self.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        self.setAlternatingRowColors(True)
        self.setAccessibleName(self.tr("Keys"))
        self.itemChanged.connect(self._enter)
        self.itemSelectionChanged.connect(self._go_there)
        self.refresh()

    @property
    def address(self) -> Address | None:
        """Whose keys are shown."""
        refs = sorted(self._bridge.session.state.keys, key=lambda ref: (ref.address.property.name, ref.frame))
        shown = self._choice.shown
        return refs[0].address if refs else shown[0].address if shown else None

    def refresh(self) -> None:
        """Show the keys as they are."""
        address = self.address
        rows = () if address is None else rows_of(self._bridge.document, address)
        triggers = QAbstractItemView.EditTrigger
        locked = self._choice.is_locked
        self.setEditTriggers(triggers.NoEditTriggers if locked else triggers.DoubleClicked | triggers.AnyKeyPressed)
        if rows == self._rows:
            return
        self._rows = rows
        header, modes = self.horizontalHeader(), QHeaderView.ResizeMode
        with QSignalBlocker(self):
            # Columns would be measured anew with every cell.
            header.setSectionResizeMode(modes.Fixed)
            self.setRowCount(len(rows))
            for number, row in enumerate(rows):
                for column, text in enumerate(self._shown(row, address)):
                    self.setItem(number, column, _cell(text, fixed=column in _FIXED_COLUMNS))
            header.setSectionResizeMode(modes.ResizeToContents)

    def event(self, event: QEvent) -> bool:
        # The window has commands on these keys too; here they are about the table's rows.
        if event.type() is QEvent.Type.ShortcutOverride and isinstance(event, QKeyEvent) and _is_own(event):
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.matches(QKeySequence.StandardKey.Copy):
            self.copy()
        elif event.matches(QKeySequence.StandardKey.SelectAll):
            self.selectAll()
        elif event.matches(QKeySequence.StandardKey.Paste):
            self.paste()
        else:
            super().keyPressEvent(event)

    def copy(self) -> None:
        """Put the selected rows, or all, on the clipboard as lines with tabs."""
        chosen = sorted({index.row() for index in self.selectedIndexes()}) or list(range(len(self._rows)))
        self._clipboard.put(text_of(tuple(self._rows[row] for row in chosen), self._bridge.document.canvas))

    def paste(self) -> None:
        """Set keys from lines with tabs on the clipboard."""
        address = self.address
        if address is not None:
            text = self._clipboard.text()
            self._edit(self.tr("Paste keys"), lambda: pasted(self._bridge.document, address, text))

    def _enter(self, item: QTableWidgetItem) -> None:
        address = self.address
        if address is None:
            return
        row, column = self._rows[item.row()], item.column()
        spoken = {self._word(each): each.value for each in Interpolation}
        text = spoken.get(item.text().strip(), item.text()) if column == _INTERPOLATION_COLUMN else item.text()
        if column == _FRAME_COLUMN:
            text = in_frames(self._bridge.document.canvas, text)
        factor = shown_unit(address.property).factor
        self._edit(self.tr("Type key"), lambda: with_cell(self._bridge.document, address, row, column, text, factor))

    def _shown(self, row: KeyRow, address: Address | None) -> tuple[str, ...]:
        """Return a row's cells as they are read: its axis by name, how it goes on in the window's language."""
        shown = None if address is None else shown_unit(address.property)
        _, part, value, _, *eases = row.cells if shown is None else row.cells_in(shown.factor)
        if shown is not None and shown.unit == "%":
            value += " %"
        axes = address.property.components if address is not None else ()
        axis = axes[row.component] if row.component < len(axes) and len(axes[row.component]) == 1 else part
        frame = str(number_of(self._bridge.document.canvas, row.frame))
        return (frame, axis, value, self._word(row.interpolation), *eases)

    def _word(self, interpolation: Interpolation) -> str:
        match interpolation:
            case Interpolation.HOLD:
                return self.tr("hold")
            case Interpolation.LINEAR:
                return self.tr("linear")
            case Interpolation.BEZIER:
                return self.tr("bezier")

    def _edit(self, name: str, make: Callable[[], Document]) -> None:
        try:
            document = make()
        except UsageProblem as problem:
            self.refused.emit(translated(problem))
        else:
            self._bridge.session.edit(name, document)
        self._rows = ()
        self.refresh()

    def _go_there(self) -> None:
        rows = {index.row() for index in self.selectedIndexes()}
        if len(rows) == 1 and self.hasFocus():
            self._bridge.session.go_to(self._rows[rows.pop()].frame)


def _is_own(event: QKeyEvent) -> bool:
    keys = QKeySequence.StandardKey
    return any(event.matches(key) for key in (keys.Copy, keys.Paste, keys.SelectAll))


def _cell(text: str, *, fixed: bool) -> QTableWidgetItem:
    item = QTableWidgetItem(text)
    item.setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
    if fixed:
        item.setFlags(item.flags() & ~Qt.ItemFlag.ItemIsEditable)
    return item
