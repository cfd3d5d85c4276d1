"""Free memory given back to the system now and then, beside the window."""

from typing import Final

from PySide6.QtCore import QObject, QThreadPool, QTimer

from kagezou.io.files.memory import give_back

EVERY_MS: Final = 15_000


class GivingBack(QObject):
    """Gives back what is free, as long as it lives."""

    def __init__(self) -> None:
        super().__init__()
        self._timer = QTimer(self)
        self._timer.setInterval(EVERY_MS)
        self._timer.timeout.connect(self.begin)
        self._timer.start()

    def begin(self) -> None:
        """Give back on another thread: to look through a gigabyte takes longer than a frame."""
        QThreadPool.globalInstance().start(give_back)
