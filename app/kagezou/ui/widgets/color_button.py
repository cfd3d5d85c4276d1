"""A colour to see, to type and to pick."""

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QAbstractButton, QColorDialog, QHBoxLayout, QLineEdit, QWidget

from kagezou.ui.system.theme import BRIGHT, CHROME, DIM
from kagezou.ui.widgets.scrub_field import MIXED


class Swatch(QAbstractButton):
    """A patch of the colour itself, drawn flat so that nothing tints it."""

    def __init__(self) -> None:
        super().__init__()
        self.color = QColor("#000000")
        self.is_mixed = False
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setCursor(Qt.CursorShape.PointingHandCursor)
        self.setAccessibleName(self.tr("Pick a colour"))
        self.setToolTip(self.tr("Pick a colour"))

    def sizeHint(self) -> QSize:
        height = self.fontMetrics().height() + 6
        return QSize(height * 2, height)

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setPen(QPen(BRIGHT if self.hasFocus() or self.underMouse() else DIM, 1))
        painter.setBrush(self.color)
        area = self.rect().adjusted(0, 0, -1, -1)
        painter.drawRect(area)
        if self.is_mixed:
            # Half of it is anything else.
            painter.setBrush(CHROME)
            painter.drawPolygon([area.topRight(), area.bottomRight(), area.bottomLeft()])
        painter.end()


class ColorField(QWidget):
    """A swatch and its ``#RRGGBB``; picking in the dialog shows each colour tried, and Cancel takes them back."""

    picking_began = Signal()
    tried = Signal(str)
    picking_ended = Signal(bool)
    entered = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self.swatch = Swatch()
        self.code = QLineEdit()
        self.code.setMaxLength(7)
        self.code.setAccessibleName(self.tr("Colour code"))
        self.swatch.clicked.connect(self._pick)
        self.code.editingFinished.connect(self._accept)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(5)
        row.addWidget(self.swatch)
        row.addWidget(self.code, 1)

    def show_mixed(self, code: str) -> None:
        """Show that there are several colours, one of which is this."""
        self.set_color(code, mixed=True)

    def set_color(self, code: str, *, mixed: bool = False) -> None:
        """Show a colour."""
        self.swatch.color, self.swatch.is_mixed = QColor(code), mixed
        self.swatch.update()
        if not self.code.hasFocus():
            self.code.setText(self._written())

    def _accept(self) -> None:
        typed = QColor.fromString(self.code.text() if self.code.text().startswith("#") else "#" + self.code.text())
        shown = self.swatch.color.name().upper()
        if typed.isValid() and (self.swatch.is_mixed or typed.name().upper() != shown):
            self.entered.emit(typed.name().upper())
        else:
            self.code.setText(self._written())

    def _written(self) -> str:
        return MIXED if self.swatch.is_mixed else self.swatch.color.name().upper()

    def _pick(self) -> None:
        dialog = QColorDialog(self.swatch.color, self.window())
        dialog.setWindowTitle(self.tr("Shadow colour"))
        dialog.setOption(QColorDialog.ColorDialogOption.DontUseNativeDialog)
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.setModal(True)
        dialog.currentColorChanged.connect(lambda color: self.tried.emit(color.name().upper()))
        dialog.finished.connect(lambda result: self.picking_ended.emit(bool(result)))
        self.picking_began.emit()
        dialog.open()
