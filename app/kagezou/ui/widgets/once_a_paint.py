"""Work of a hand that is done at most once a painting: of moves that come faster, the last one counts."""

from collections.abc import Callable

from PySide6.QtCore import QCoreApplication, QEvent, QObject, QTimer
from PySide6.QtGui import QInputEvent
from PySide6.QtWidgets import QWidget

Work = Callable[[], object]


class OnceAPaint(QObject):
    """Does the last of the works it is given, and sees to it that what came of it is painted before the next.

    Without that a hand that is faster than the work would have the window work for ever and paint nothing.

    Parameters
    ----------
    widget
        Whose window is painted.
    """

    def __init__(self, widget: QWidget) -> None:
        super().__init__(widget)
        self._widget = widget
        self._work: Work | None = None
        self._turn = QTimer(self)
        self._turn.setSingleShot(True)
        self._turn.timeout.connect(self._do)

    def take(self, event: QInputEvent, work: Work) -> None:
        """Do the work that an event asks for, soon; at once where a program sent the event, for it looks at once."""
        if not event.spontaneous():
            self.finish()
            work()
            return
        self._work = work
        if not self._turn.isActive():
            self._turn.start(0)

    def finish(self) -> None:
        """Do now what waits."""
        self._turn.stop()
        work, self._work = self._work, None
        if work is not None:
            work()

    def _do(self) -> None:
        self.finish()
        QCoreApplication.sendPostedEvents(self._widget.window(), QEvent.Type.UpdateRequest.value)
