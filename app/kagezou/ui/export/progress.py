"""Exporting beside the window: a thread that draws, and its progress in the status bar."""

import threading
from collections import deque
from time import monotonic

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QProgressBar, QToolButton, QWidget

from kagezou.errors import Problem
from kagezou.export.exporters.exporter import ExportOutcome, Work
from kagezou.ui.system.background import Queue
from kagezou.ui.system.icons import icon
from kagezou.ui.system.offscreen_context import OffscreenSurface
from kagezou.ui.system.words import translated
from kagezou.ui.widgets.message_bar import MessageBar, Severity

_KEY = "export"
_PACE_STEPS = 24
"""The time left follows from the pace of so many steps, as files that were there already cost almost none."""
_MINUTE_S = 60


class Exporting(QWidget):
    """Progress and a way to stop, for the status bar; hidden while nothing is exported.

    Parameters
    ----------
    bar
        Where is said what went wrong.
    """

    ended = Signal(object)
    """What came of an export that was not ended by a problem."""

    def __init__(self, bar: MessageBar) -> None:
        super().__init__()
        self._bar = bar
        self._surface: OffscreenSurface | None = None
        self._wants_stop = threading.Event()
        self._background = Queue[tuple[int, int] | ExportOutcome](
            self._take, failed=self._say_failed, ended=self._end, low_priority=True
        )
        self._pace: deque[tuple[float, int]] = deque(maxlen=_PACE_STEPS)
        self._stopping = False
        self._words = QLabel(self.tr("Exporting"))
        self._progress = QProgressBar()
        self._progress.setFixedWidth(180)
        self._progress.setFormat("%v / %m")
        self._stop = QToolButton()
        self._stop.setIcon(icon("close"))
        self._stop.setToolTip(self.tr("Cancel the export"))
        self._stop.setAccessibleName(self.tr("Cancel the export"))
        self._stop.clicked.connect(self.cancel)
        row = QHBoxLayout(self)
        row.setContentsMargins(4, 1, 4, 1)
        row.setSpacing(4)
        for widget in (self._words, self._progress, self._stop):
            row.addWidget(widget)
        self.hide()

    @property
    def is_running(self) -> bool:
        """Whether an export is under way."""
        return self._background.is_busy

    def start(self, work: Work) -> None:
        """Carry an export out beside the window."""
        if self.is_running:
            self.say_running()
            return
        surface = self._surface = OffscreenSurface()
        self._wants_stop.clear()
        self._progress.setRange(0, 0)
        self._progress.reset()
        self._pace.clear()
        self._pace.append((monotonic(), 0))
        self._words.setText(self.tr("Preparing the export"))
        self.show()
        self._background.ask(
            lambda turn: turn.tell(
                work(surface.open, lambda done, whole: turn.tell((done, whole)), self._wants_stop.is_set)
            )
        )

    def say_running(self) -> None:
        """Say that something has to wait for the export."""
        self._bar.say(_KEY, self.tr("An export is still running."), Severity.NOTE)

    def cancel(self) -> None:
        """Stop after the pictures in hand; what is written is whole."""
        if self.is_running:
            self._stopping = True
            self._words.setText(self.tr("Stopping"))
            self._wants_stop.set()

    def finish(self) -> None:
        """Stop and wait, before the window goes."""
        self._wants_stop.set()
        self._background.finish()

    def _take(self, told: tuple[int, int] | ExportOutcome) -> None:
        if isinstance(told, ExportOutcome):
            self._bar.withdraw(_KEY)
            self.ended.emit(told)
        else:
            self._show_progress(*told)

    def _say_failed(self, problem: Problem) -> None:
        words = translated(problem)
        if self._progress.value() > 0:
            words += "\n" + self.tr("Every file that was written before is whole and stays.")
        self._bar.say(_KEY, words)

    def _show_progress(self, finished: int, whole: int) -> None:
        self._progress.setRange(0, whole)
        self._progress.setValue(finished)
        began_s, before = self._pace[0]
        now_s = monotonic()
        self._pace.append((now_s, finished))
        if not self._stopping and finished >= whole:
            # Files are read back, and what comes after an export runs.
            self._words.setText(self.tr("Finishing the export"))
        elif not self._stopping:
            left_s = (now_s - began_s) * (whole - finished) / max(finished - before, 1)
            self._words.setText(self._time_words(left_s))

    def _time_words(self, left_s: float) -> str:
        if left_s < _MINUTE_S:
            return self.tr("Exporting, %1 s left").replace("%1", f"{left_s:.0f}")
        return self.tr("Exporting, %1 min left").replace("%1", f"{left_s / _MINUTE_S:.0f}")

    def _end(self) -> None:
        self._surface = None
        self._stopping = False
        self.hide()
