"""The dialog that shows what was understood of folders and files before any of it is taken."""

from collections.abc import Sequence
from dataclasses import replace

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QIcon, QImage, QPainter, QPixmap
from PySide6.QtWidgets import (
    QAbstractItemView,
    QComboBox,
    QDialog,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QPushButton,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from kagezou.importing.found_characters import FoundCharacter, FoundCharacters
from kagezou.importing.new_cels import CharacterSource, printable
from kagezou.ui.system.thumbnails import Thumbnails
from kagezou.ui.system.words import translated

PICTURE_PX = 48
_NAME, _COUNT, _FILES, _FIGURE, _REMARKS = range(5)
_FRAME_PX = 12
_MOST_LINES = 4


class FoundDialog(QDialog):
    """Lists the characters; each may be left out, called otherwise, or joined to the figure of one above it.

    Parameters
    ----------
    found
        What was understood.
    """

    def __init__(self, found: FoundCharacters, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Characters Found"))
        self._found = found
        self._thumbnails = Thumbnails()
        self.table = QTableWidget(len(found.characters), 5)
        self.names: list[QTableWidgetItem] = []
        self.figures: list[QComboBox] = []
        self.layers: dict[int, QComboBox] = {}
        self.remarks = QLabel("\n".join(translated(note) for note in found.notes))
        self.take = QPushButton(self.tr("Take"))
        for row, character in enumerate(found.characters):
            self._fill(row, character)
        self._lay_out()
        self._thumbnails.ready.connect(self._show_pictures)
        self.table.itemChanged.connect(self._show_choice)
        self.finished.connect(lambda _result: self._thumbnails.finish())
        self._show_pictures()
        self._show_choice()
        self.take.setFocus()

    def sources(self) -> tuple[CharacterSource, ...]:
        """Return what brings the characters that are ticked, by their names as they stand."""
        taken = [row for row in range(self.table.rowCount()) if self._is_taken(row)]
        made = []
        for row in taken:
            figure = self.figures[row].currentData()
            joins = self._name(figure) if figure in taken else None
            character = self._found.characters[row]
            # A PSD file that nobody called otherwise names its characters itself.
            name = character.source.name if self._name(row) == character.name else self._name(row)
            drawings = character.source.drawings
            # What is doubtful about them has been read here.
            told = None if drawings is None else replace(drawings, notes=())
            layer = self.layers[row].currentData() if row in self.layers else character.source.layer
            made.append(replace(character.source, name=name, joins=joins, drawings=told, layer=layer))
        return tuple(made)

    def _fill(self, row: int, character: FoundCharacter) -> None:
        name = QTableWidgetItem(character.name)
        name.setFlags(name.flags() | Qt.ItemFlag.ItemIsUserCheckable | Qt.ItemFlag.ItemIsEditable)
        name.setCheckState(Qt.CheckState.Checked)
        files = character.first_name
        if character.count > 1:
            files = f"{character.first_name}\n… {character.last_name}"
        count = f"{character.count}" if character.count else "PSD"
        texts = {
            _COUNT: "\n".join(filter(None, (count, character.numbers))),
            _FILES: files,
            _REMARKS: "\n".join(translated(note) for note in character.notes),
        }
        self.names.append(name)
        self.table.setItem(row, _NAME, name)
        for column, text in texts.items():
            item = QTableWidgetItem(text)
            item.setFlags(Qt.ItemFlag.ItemIsEnabled)
            item.setToolTip(text)
            self.table.setItem(row, column, item)
        figure = QComboBox()
        figure.addItem(self.tr("of its own"), None)
        figure.setEnabled(row > 0)
        figure.setAccessibleName(self.tr("Figure"))
        figure.currentIndexChanged.connect(self._show_choice)
        self.figures.append(figure)
        self.table.setCellWidget(row, _FIGURE, _framed(figure))
        if character.layers:
            self.layers[row] = self._layer_list(character.layers)
            self.table.setItem(row, _COUNT, QTableWidgetItem())
            self.table.setCellWidget(
                row, _COUNT, _framed(QLabel(" · ".join(filter(None, (count, character.numbers)))), self.layers[row])
            )

    def _layer_list(self, names: Sequence[str]) -> QComboBox:
        """Return a list of the layers of OpenEXR files, the one that is used by itself chosen."""
        layers = QComboBox()
        layers.setAccessibleName(self.tr("Layer"))
        layers.setToolTip(self.tr("Which layer of the OpenEXR files is the drawing"))
        for number, name in enumerate(names):
            layers.addItem(name or self.tr("without a name"), None if number == 0 else name)
        return layers

    def _lay_out(self) -> None:
        words = QLabel(self.tr("This is what was found. Lower rows lie over upper ones."))
        words.setWordWrap(True)
        self.remarks.setWordWrap(True)
        self.remarks.setVisible(bool(self._found.notes))
        self._lay_out_table()
        cancel = QPushButton(self.tr("Cancel"))
        cancel.setAutoDefault(False)
        cancel.clicked.connect(self.reject)
        self.take.setDefault(True)
        self.take.clicked.connect(self.accept)
        buttons = QHBoxLayout()
        buttons.addStretch(1)
        buttons.addWidget(cancel)
        buttons.addWidget(self.take)
        column = QVBoxLayout(self)
        column.setContentsMargins(16, 16, 16, 14)
        column.setSpacing(12)
        column.addWidget(words)
        column.addWidget(self.table, 1)
        column.addWidget(self.remarks)
        column.addLayout(buttons)
        letter, line = self.fontMetrics().horizontalAdvance("0"), self.fontMetrics().height()
        rows = min(max(len(self._found.characters), 2), 7)
        self.resize(min(136 * letter, 1180), min(14 * line + rows * (PICTURE_PX + _FRAME_PX), 640))

    def _lay_out_table(self) -> None:
        table = self.table
        table.setHorizontalHeaderLabels([
            self.tr("Name"),
            self.tr("Drawings"),
            self.tr("First and last file"),
            self.tr("Figure"),
            self.tr("Remarks"),
        ])  # fmt: skip
        table.setIconSize(QSize(PICTURE_PX, PICTURE_PX))
        table.setWordWrap(True)
        table.setShowGrid(False)
        table.setTabKeyNavigation(False)
        table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        table.verticalHeader().hide()
        table.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        header = table.horizontalHeader()
        header.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        header.setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
        header.setSectionResizeMode(_REMARKS, QHeaderView.ResizeMode.Stretch)
        letter = self.fontMetrics().horizontalAdvance("0")
        for column, width in ((_NAME, 30), (_COUNT, 14), (_FILES, 26), (_FIGURE, 18)):
            table.setColumnWidth(column, width * letter)
        line = self.fontMetrics().height()
        for row, character in enumerate(self._found.characters):
            lines = min(2 * len(character.notes), _MOST_LINES)
            table.setRowHeight(row, max(PICTURE_PX, lines * line) + _FRAME_PX)

    def _show_pictures(self) -> None:
        """Show the pictures that are there by now; the others have an empty place of that size."""
        self.table.blockSignals(True)
        for row, character in enumerate(self._found.characters):
            image = self._thumbnails.image(character.picture)
            self.names[row].setIcon(QIcon(_square(image)))
        self.table.blockSignals(False)

    def _show_choice(self) -> None:
        """Offer in each row the figures above it that are taken and are no parts themselves."""
        own: list[int] = []
        for row, box in enumerate(self.figures):
            chosen = box.currentData()
            box.blockSignals(True)
            while box.count() > 1:
                box.removeItem(1)
            for figure in own:
                box.addItem(self.tr("part of %1").replace("%1", self._name(figure)), figure)
            box.setCurrentIndex(max(box.findData(chosen), 0) if chosen is not None else 0)
            box.blockSignals(False)
            box.setEnabled(bool(own) and self._is_taken(row))
            is_known = self._found.characters[row].source.drawings is not None
            if is_known and self._is_taken(row) and box.currentData() is None:
                own.append(row)
        self.take.setEnabled(any(map(self._is_taken, range(self.table.rowCount()))))

    def _item(self, row: int) -> QTableWidgetItem:
        item = self.table.item(row, _NAME)
        assert item is not None
        return item

    def _is_taken(self, row: int) -> bool:
        return self.names[row].checkState() is Qt.CheckState.Checked

    def _name(self, row: int) -> str:
        typed = self.names[row].text().strip()
        return printable(typed) if typed else self._found.characters[row].name


def _framed(*widgets: QWidget) -> QWidget:
    """Return widgets one under the other, with room to the next column."""
    cell = QWidget()
    column = QVBoxLayout(cell)
    column.setContentsMargins(4, 0, _FRAME_PX, 0)
    column.setSpacing(2)
    for widget in widgets:
        column.addWidget(widget)
    return cell


def _square(image: QImage | None) -> QPixmap:
    """Return a picture in the middle of a square, so that the names beside them stand in one line."""
    side = max(image.width(), image.height(), PICTURE_PX) if image is not None else PICTURE_PX
    square = QPixmap(side, side)
    square.fill(Qt.GlobalColor.transparent)
    if image is not None:
        painter = QPainter(square)
        painter.drawImage((side - image.width()) // 2, (side - image.height()) // 2, image)
        painter.end()
    return square
