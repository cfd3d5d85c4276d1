"""What the window brought to the screen and when, beside which move of the pointer it had seen by then."""

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from statistics import median, quantiles

from PySide6.QtCore import QCoreApplication, QEvent, QObject
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication, QWidget

from kagezou.ui.measuring.pointer import Place, Sent


@dataclass(frozen=True, slots=True)
class Paint:
    """A painting of the window: when it was done, what the pointer's last move was, and what was seen."""

    at_s: float
    place: Place | None
    seen: object


@dataclass(frozen=True, slots=True)
class Response:
    """How a window answered.

    Parameters
    ----------
    name
        What was done.
    paints_a_second
        How often something new was seen.
    latency_ms, late_ms
        From input to paint: median, and what one in twenty exceeds; None where nothing is put in.
    """

    name: str
    paints_a_second: float
    latency_ms: float | None = None
    late_ms: float | None = None


class Watch(QObject):
    """Watches a window paint.

    Parameters
    ----------
    window
        The window.
    seen
        Tells what is seen now; another object is something new.
    """

    def __init__(self, window: QWidget, seen: Callable[[], object]) -> None:
        super().__init__()
        self._window, self._seen = window, seen
        self._place: Place | None = None
        self._is_within = False
        self.paints: list[Paint] = []
        self._application = _application()
        self._application.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if isinstance(event, QMouseEvent) and event.type() is QEvent.Type.MouseMove:
            place = event.globalPosition()
            self._place = (round(place.x()), round(place.y()))
        if watched is self._window and event.type() is QEvent.Type.UpdateRequest and not self._is_within:
            # Delivered from here, so that painting is over, and sent to the screen, when the clock is read.
            self._is_within = True
            QApplication.sendEvent(watched, event)
            self._is_within = False
            self.paints.append(Paint(time.monotonic(), self._place, self._seen()))
            return True
        return False

    def finish(self) -> tuple[Paint, ...]:
        """Watch no more, and return the paintings that showed something new."""
        self._application.removeEventFilter(self)
        return tuple(
            paint
            for before, paint in zip(self.paints, self.paints[1:], strict=False)
            if paint.seen is not before.seen and paint.seen != before.seen
        )


def response(name: str, paints: Sequence[Paint], took_s: float, sent: Sequence[Sent] = ()) -> Response:
    """Return figures of the paintings in a time; a painting answers the last move that the window had seen."""
    rate = len(paints) / took_s
    late = []
    for paint in paints:
        # The pointer may have been at one place twice.
        causes = [each.at_s for each in sent if each.place == paint.place and each.at_s <= paint.at_s]
        if causes:
            late.append((paint.at_s - causes[-1]) * 1000)
    if len(late) < 2:
        return Response(name, rate)
    return Response(name, rate, median(late), quantiles(late, n=20)[-1])


def _application() -> QCoreApplication:
    application = QCoreApplication.instance()
    assert application is not None
    return application
