"""The space bar: a tap plays or stops, held down it lets the hand pan; which of the two is decided on release."""

from collections.abc import Callable
from time import monotonic

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QLineEdit,
    QPlainTextEdit,
    QTextEdit,
    QWidget,
)

TAP_S = 0.25
_OWN_USE_OF_SPACE = (QLineEdit, QAbstractSpinBox, QPlainTextEdit, QTextEdit, QAbstractButton, QComboBox)


class SpaceBar(QObject):
    """Watches the keys of one window; whatever types or clicks with the space bar keeps it.

    Parameters
    ----------
    window
        The window; keys of others are left alone.
    clock
        Seconds that only go forward.
    """

    tapped = Signal()
    changed = Signal()

    def __init__(self, window: QWidget, clock: Callable[[], float] = monotonic) -> None:
        super().__init__(window)
        self._window = window
        self._clock = clock
        self._since: float | None = None
        self._was_used = False

    @property
    def is_held(self) -> bool:
        """Whether the bar is down."""
        return self._since is not None

    def use(self) -> None:
        """Take note that the bar serves for panning this time, and does not play."""
        self._was_used = True

    def watch(self, application: QApplication) -> None:
        """Begin to watch the keys."""
        application.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() is QEvent.Type.WindowDeactivate and watched is self._window:
            self._since = None
        if not isinstance(event, QKeyEvent) or event.key() != Qt.Key.Key_Space:
            return False
        if event.type() not in (QEvent.Type.KeyPress, QEvent.Type.KeyRelease) or not isinstance(watched, QWidget):
            return False
        if watched.window() is not self._window or (self._since is None and not self._is_free(watched, event)):
            return False
        if not event.isAutoRepeat():
            self._press() if event.type() is QEvent.Type.KeyPress else self._release()
        return True

    def _is_free(self, watched: QWidget, event: QKeyEvent) -> bool:
        return not event.modifiers() and not isinstance(watched, _OWN_USE_OF_SPACE)

    def _press(self) -> None:
        self._since, self._was_used = self._clock(), False
        self.changed.emit()

    def _release(self) -> None:
        if self._since is None:
            return
        short = self._clock() - self._since <= TAP_S
        self._since = None
        self.changed.emit()
        if short and not self._was_used:
            self.tapped.emit()
