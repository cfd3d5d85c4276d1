"""The space bar: a tap plays or stops, held down it lets the hand pan; which of the two is decided on release."""

from collections.abc import Callable
from time import monotonic

from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtGui import QKeyEvent

TAP_S = 0.25


class SpaceBar(QObject):
    """Told of the keys that reach the window, which is those that no text field or button has taken for itself.

    Parameters
    ----------
    clock
        Seconds that only go forward.
    """

    tapped = Signal()
    changed = Signal()

    def __init__(self, clock: Callable[[], float] = monotonic) -> None:
        super().__init__()
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

    def press(self, event: QKeyEvent) -> bool:
        """Take a key that goes down; false if it is another one."""
        if event.key() != Qt.Key.Key_Space or event.modifiers():
            return False
        if not event.isAutoRepeat():
            self._since, self._was_used = self._clock(), False
            self.changed.emit()
        return True

    def release(self, event: QKeyEvent) -> bool:
        """Take a key that comes up; false if it is another one."""
        if event.key() != Qt.Key.Key_Space or self._since is None:
            return False
        if not event.isAutoRepeat():
            short = self._clock() - self._since <= TAP_S
            self.forget()
            if short and not self._was_used:
                self.tapped.emit()
        return True

    def forget(self) -> None:
        """Take the bar for released, because the window will not be told."""
        if self._since is not None:
            self._since = None
            self.changed.emit()
