"""The keyboard on the picture: arrows nudge the selected handle or step frames, and values are typed into a drag."""

from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QWidget

from kagezou.ui.system.window_keys import lies_on_command
from kagezou.ui.viewport.handle_controller import HandleController
from kagezou.ui.viewport.typed_value import LETTERS

NUDGE_PX, LONG_NUDGE_PX = 1.0, 10.0

_ARROWS = {
    Qt.Key.Key_Left: (-1.0, 0.0),
    Qt.Key.Key_Right: (1.0, 0.0),
    Qt.Key.Key_Up: (0.0, -1.0),
    Qt.Key.Key_Down: (0.0, 1.0),
}
_ENTER = (Qt.Key.Key_Return, Qt.Key.Key_Enter)
_TYPING = (*_ENTER, Qt.Key.Key_Backspace)


class HandKeys(QObject):
    """Passes keys of the picture on to the hand.

    Parameters
    ----------
    picture
        Whose keys they are.
    hand
        Takes them.
    """

    step_asked = Signal(int)
    """Left or right arrow without a selected handle: so many frames on."""

    def __init__(self, picture: QWidget, hand: HandleController) -> None:
        super().__init__(picture)
        self._picture, self._hand = picture, hand

    def wants(self, event: QKeyEvent) -> bool:
        """Whether a key types into a drag, though it may lie on a command, or is an arrow that lies on none."""
        return _is_typing(event) if self._hand.is_busy else self._is_arrow(event)

    def press(self, event: QKeyEvent) -> bool:
        """Take a key going down; false if it is another one."""
        if self._hand.is_busy and _is_typing(event):
            self._type(event)
        elif self._is_arrow(event):
            self._arrow(event)
        else:
            return False
        return True

    def release(self, event: QKeyEvent) -> bool:
        """Take a key coming up; false if it is another one."""
        if event.key() not in _ARROWS or event.isAutoRepeat():
            return False
        self._hand.end_nudge()
        return True

    def _is_arrow(self, event: QKeyEvent) -> bool:
        others = event.modifiers() & ~(Qt.KeyboardModifier.ShiftModifier | Qt.KeyboardModifier.KeypadModifier)
        return event.key() in _ARROWS and not others and not lies_on_command(event, self._picture)

    def _arrow(self, event: QKeyEvent) -> None:
        length = LONG_NUDGE_PX if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else NUDGE_PX
        dx, dy = _ARROWS[Qt.Key(event.key())]
        if not self._hand.nudge(dx * length, dy * length) and dx:
            self.step_asked.emit(round(dx * length))

    def _type(self, event: QKeyEvent) -> None:
        if event.key() in _ENTER:
            self._hand.release()
        elif event.key() == Qt.Key.Key_Backspace:
            self._hand.type(self._hand.typed[:-1])
        else:
            self._hand.type(self._hand.typed + event.text())


def _is_typing(event: QKeyEvent) -> bool:
    return event.key() in _TYPING or (len(event.text()) == 1 and event.text() in LETTERS)
