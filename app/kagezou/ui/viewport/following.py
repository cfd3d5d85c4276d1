"""When the picture follows the frame: at once, or while a hand scrubs through time, after the playhead."""

from collections.abc import Callable
from typing import Final

from PySide6.QtCore import QObject, QTimer, Signal

from kagezou.ui.system.bridge import Bridge

SCRUB_MS: Final = 30
"""While a hand scrubs through time, a picture follows it at least so much later: the playhead is painted in between."""


class Following(QObject):
    """Says when a picture of the session's frame is due.

    Parameters
    ----------
    bridge
        The session.
    took_s
        Tells how long the last picture took, seconds.
    """

    due = Signal()
    scrubbed = Signal()
    """A hand went to another frame, and may go on."""

    def __init__(self, bridge: Bridge, took_s: Callable[[], float]) -> None:
        super().__init__()
        self._bridge, self._took_s = bridge, took_s
        self._behind = QTimer(self)
        self._behind.setSingleShot(True)
        self._behind.timeout.connect(self.due)
        bridge.frame_changed.connect(self.follow)

    def follow(self) -> None:
        """Take note that the picture is another, by its frame or what is in it."""
        if not self._bridge.is_scrubbed:
            self.due.emit()
            return
        self.scrubbed.emit()
        if not self._behind.isActive():
            # Two thirds of the time belong to the playhead.
            self._behind.start(max(SCRUB_MS, round(2000 * self._took_s())))
