"""The dialog for the exact speed and influence of the selected keys, as compositors type them."""

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QDoubleSpinBox, QFormLayout, QLabel, QVBoxLayout, QWidget

from kagezou.animation.ease import Ease
from kagezou.ui.system.shown_units import ShownUnit
from kagezou.ui.widgets.number_boxes import NumberBox


class VelocityDialog(QDialog):
    """Speeds in units a frame, influences in per cent of the way to the neighbouring key.

    Parameters
    ----------
    before, after
        What is there now on both sides.
    shown
        In which unit the property's numbers are shown.
    """

    entered = Signal(object, object)

    def __init__(self, before: Ease, after: Ease, shown: ShownUnit, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Key Velocity"))
        self._factor = shown.factor
        suffix = self.tr("%1 / frame").replace("%1", shown.unit).strip()
        self.fields = [_field(before.speed * shown.factor, suffix), _field(before.influence * 100, "%")]
        self.fields += [_field(after.speed * shown.factor, suffix), _field(after.influence * 100, "%")]
        for field in (self.fields[1], self.fields[3]):
            field.setRange(0.1, 100)
        form = QFormLayout()
        for words, pair in ((self.tr("Incoming"), self.fields[:2]), (self.tr("Outgoing"), self.fields[2:])):
            heading = QLabel(words)
            heading.setObjectName("heading")
            form.addRow(heading)
            form.addRow(self.tr("Speed"), pair[0])
            form.addRow(self.tr("Influence"), pair[1])
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel)
        buttons.button(QDialogButtonBox.StandardButton.Cancel).setText(self.tr("Cancel"))
        buttons.accepted.connect(self._enter)
        buttons.rejected.connect(self.reject)
        column = QVBoxLayout(self)
        column.setContentsMargins(16, 16, 16, 14)
        column.addLayout(form)
        column.addWidget(buttons)

    def _enter(self) -> None:
        into, reach_in, out, reach_out = (field.value() for field in self.fields)
        self.entered.emit(Ease(into / self._factor, reach_in / 100), Ease(out / self._factor, reach_out / 100))
        self.accept()


def _field(value: float, suffix: str) -> QDoubleSpinBox:
    field = NumberBox()
    field.setDecimals(3)
    field.setRange(-1e9, 1e9)
    field.setSuffix(f" {suffix}" if suffix else "")
    field.setValue(value)
    field.setMinimumWidth(field.fontMetrics().horizontalAdvance("-000000.000 px / frame "))
    return field
