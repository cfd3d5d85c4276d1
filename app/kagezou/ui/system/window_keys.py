"""Keys of the window's commands, as the parts of the window see them that use some keys for themselves."""

from PySide6.QtGui import QKeyEvent, QKeySequence
from PySide6.QtWidgets import QWidget


def lies_on_command(event: QKeyEvent, widget: QWidget) -> bool:
    """Whether a key lies on a command of a widget's window, which then goes before what arrows do in the widget.

    So the arrows step frames with the keys of a program in which they do, whatever the hand touched last.
    """
    key = QKeySequence(event.keyCombination())
    return any(key in action.shortcuts() for action in widget.window().actions() if action.isEnabled())
