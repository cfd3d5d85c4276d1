"""A slider over the part of a number's range that a hand wants."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QSlider

_STEPS = 1000
_KEY_STEPS = 10


class RangeSlider(QSlider):
    """Shows a number; ``began``, ``tried`` and ``ended`` bracket a drag, ``entered`` is a step by key or click.

    Parameters
    ----------
    low, high
        The ends; a number beyond them shows at the end and stays as it is.
    """

    began = Signal()
    tried = Signal(object)
    ended = Signal(bool)
    entered = Signal(object)

    def __init__(self, low: float, high: float) -> None:
        super().__init__(Qt.Orientation.Horizontal)
        self._low, self._high = low, high
        self.setRange(0, _STEPS)
        self.setSingleStep(_KEY_STEPS)
        self.setPageStep(_STEPS // 10)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setMinimumWidth(self.fontMetrics().horizontalAdvance("-00000"))
        self.sliderPressed.connect(self.began)
        self.sliderMoved.connect(lambda step: self.tried.emit(self._number(step)))
        self.sliderReleased.connect(lambda: self.ended.emit(True))
        self.actionTriggered.connect(self._step)

    def show_value(self, number: float) -> None:
        """Show a number, without telling anyone."""
        if not self.isSliderDown():
            self.blockSignals(True)
            self.setValue(round((number - self._low) / (self._high - self._low) * _STEPS))
            self.blockSignals(False)

    def wheelEvent(self, event: QWheelEvent) -> None:
        # The panel scrolls under the pointer; a value must not change on the way.
        event.ignore()

    def _number(self, step: int) -> float:
        return self._low + (self._high - self._low) * step / _STEPS

    def _step(self, action: int) -> None:
        if action != QSlider.SliderAction.SliderMove.value:
            self.entered.emit(self._number(self.sliderPosition()))
