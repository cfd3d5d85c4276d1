"""The size of the picture: usual ones to choose from, and two numbers to type."""

from typing import Final

from PySide6.QtCore import QCoreApplication, Qt, Signal
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QLabel, QWidget

from kagezou.document.model import Document
from kagezou.ui.widgets.number_boxes import WholeNumberBox

MOST_PX: Final = 16384


class SizeRow(QWidget):
    """Width and height, and a choice of usual ones and of those of the pictures at hand.

    Parameters
    ----------
    document
        Whose canvas it shows first, and whose drawings and background offer their sizes.
    """

    changed = Signal()

    def __init__(self, document: Document) -> None:
        super().__init__()
        self.usual, self.width_box, self.height_box = QComboBox(), WholeNumberBox(), WholeNumberBox()
        self.usual.setAccessibleName(self.tr("Usual size"))
        self.width_box.setAccessibleName(self.tr("Width"))
        self.height_box.setAccessibleName(self.tr("Height"))
        self.usual.addItem(self.tr("Own size"), None)
        for words, size_px in (sizes_at_hand(document) | usual_sizes()).items():
            self.usual.addItem(f"{words}   {size_px[0]} × {size_px[1]}", size_px)
        letter = self.fontMetrics().horizontalAdvance("0")
        for box, value in ((self.width_box, document.canvas.width_px), (self.height_box, document.canvas.height_px)):
            box.setAlignment(Qt.AlignmentFlag.AlignRight)
            box.setRange(1, MOST_PX)
            box.setValue(value)
            box.setFixedWidth(12 * letter)
            box.valueChanged.connect(lambda _value: self._typed())
        self.usual.activated.connect(lambda _index: self._picked())
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(8)
        for part in (self.width_box, QLabel("×"), self.height_box, QLabel("px")):
            row.addWidget(part)
        row.addWidget(self.usual, 1)
        self._show_usual()

    @property
    def size_px(self) -> tuple[int, int]:
        """Width and height that are chosen."""
        return (self.width_box.value(), self.height_box.value())

    def show_size(self, width_px: int, height_px: int) -> None:
        """Choose a size."""
        for box, value in ((self.width_box, width_px), (self.height_box, height_px)):
            box.blockSignals(True)
            box.setValue(value)
            box.blockSignals(False)
        self._typed()

    def _picked(self) -> None:
        size_px = self.usual.currentData()
        if size_px is not None:
            self.show_size(*size_px)

    def _typed(self) -> None:
        self._show_usual()
        self.changed.emit()

    def _show_usual(self) -> None:
        """Name the size if it is a usual one."""
        sizes = [self.usual.itemData(index) for index in range(self.usual.count())]
        known = [index for index, size in enumerate(sizes) if size is not None and tuple(size) == self.size_px]
        self.usual.setCurrentIndex(known[0] if known else 0)


def usual_sizes() -> dict[str, tuple[int, int]]:
    """Return the sizes that productions use by what they are called."""
    translate = QCoreApplication.translate
    return {
        translate("CanvasSizes", "HD"): (1280, 720),
        translate("CanvasSizes", "Full HD"): (1920, 1080),
        translate("CanvasSizes", "2K cinema"): (2048, 1080),
        translate("CanvasSizes", "WQHD"): (2560, 1440),
        translate("CanvasSizes", "4K UHD"): (3840, 2160),
        translate("CanvasSizes", "4K cinema"): (4096, 2160),
        translate("CanvasSizes", "B5 scan, 150 dpi"): (1518, 1075),
        translate("CanvasSizes", "B5 scan, 200 dpi"): (2024, 1433),
        translate("CanvasSizes", "A4 scan, 150 dpi"): (1754, 1240),
        translate("CanvasSizes", "Upright HD"): (1080, 1920),
        translate("CanvasSizes", "Square"): (1080, 1080),
    }


def sizes_at_hand(document: Document) -> dict[str, tuple[int, int]]:
    """Return the sizes of the largest drawings and of the background, where they are known."""
    drawn = [each.size_px for layer in document.layers for each in layer.cels.drawings if each.size_px]
    behind = [each.size_px for each in document.behind.drawings if each.size_px]
    translate = QCoreApplication.translate
    named = ((translate("CanvasSizes", "The drawings"), drawn), (translate("CanvasSizes", "The background"), behind))
    return {
        words: (max(width for width, _ in sizes), max(height for _, height in sizes)) for words, sizes in named if sizes
    }
