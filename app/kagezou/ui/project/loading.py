"""Loading beside the window: one load after the other on a thread of its own, and a bar that tells how far it is."""

import threading
from collections import deque
from collections.abc import Callable
from time import monotonic

from PySide6.QtCore import QCoreApplication, Qt, QTimer, Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QProgressBar, QPushButton, QWidget

from kagezou.errors import Problem
from kagezou.importing.progress import Cancelled, LoadPhase
from kagezou.ui.project.load import AnyLoad

PATIENCE_S = 0.05
"""So long a load is waited for before the bar comes: what is quick should not flicker."""

_LAST_WAIT_S = 1.0
_LOOK_EVERY_MS = 30
_TELL_AFTER_S = 1.0
"""The time left is shown only after a part has gone on for so long; before, it would be a guess."""


class _Job(threading.Thread):
    """Reads one load. A daemon: what hangs on a lost network disk must not keep the program from ending."""

    def __init__(self, load: AnyLoad) -> None:
        super().__init__(daemon=True, name="load")
        self.load = load
        self.progress = (LoadPhase.FINDING, 0, 0)
        self.result: object = None
        self.problem: BaseException | None = None
        self._unwanted = threading.Event()

    def cancel(self) -> None:
        """End soon; nobody looks at the result any more."""
        self._unwanted.set()

    def run(self) -> None:
        try:
            self.result = self.load.read(self._watch)
        except BaseException as problem:  # raised again on the window's thread
            self.problem = problem

    def _watch(self, part: LoadPhase, done: int, whole: int) -> None:
        if self._unwanted.is_set():
            raise Cancelled
        self.progress = (part, done, whole)


class Loading(QWidget):
    """Carries loads out in the order they came, and shows the one under way; hidden while there is none.

    A load that opens another project takes the place of all that are not done yet: what they would bring
    belongs to the project that goes.

    Parameters
    ----------
    failed
        Told what went wrong, while nothing was changed.
    may_put
        Whether the open project can take something now; it cannot in the middle of a drag.
    """

    progressed = Signal()
    """Sent now and then while something is loaded, and at its end."""

    def __init__(self, failed: Callable[[Problem], None], may_put: Callable[[], bool]) -> None:
        super().__init__()
        self.setObjectName("loading")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self._failed, self._may_put = failed, may_put
        self._job: _Job | None = None
        self._waiting: deque[AnyLoad] = deque()
        self._part, self._done, self._since_s = LoadPhase.FINDING, 0, 0.0
        self._words = QLabel()
        self._words.setTextFormat(Qt.TextFormat.PlainText)
        self._left = QLabel()
        self._progress = QProgressBar()
        self._progress.setTextVisible(False)
        self._progress.setFixedSize(220, 10)
        self.cancel_button = QPushButton(self.tr("Cancel"))
        self.cancel_button.clicked.connect(self.cancel)
        row = QHBoxLayout(self)
        row.setContentsMargins(12, 5, 8, 5)
        row.setSpacing(12)
        for widget, stretch in ((self._words, 0), (self._progress, 0), (self._left, 1), (self.cancel_button, 0)):
            row.addWidget(widget, stretch)
        self._timer = QTimer(self)
        self._timer.setInterval(_LOOK_EVERY_MS)
        self._timer.timeout.connect(self._look)
        self.hide()

    @property
    def is_running(self) -> bool:
        """Whether something is being loaded."""
        return self._job is not None

    @property
    def text(self) -> str:
        """What is shown now."""
        return self._words.text()

    @property
    def left_text(self) -> str:
        """What is shown of how far it is."""
        return self._left.text()

    def start(self, load: AnyLoad) -> bool:
        """Load something; false if it turned out at once that it cannot be."""
        if load.replaces or (self._job is not None and self._job.load.gives_way):
            self.cancel()
        if self._job is not None:
            self._waiting.append(load)
            return True
        return self._begin(load)

    def cancel(self) -> None:
        """Give up what is being loaded and what waits; everything is as it was."""
        self._waiting.clear()
        if self._job is not None:
            self._job.cancel()
            self._end()

    def finish(self) -> None:
        """Give everything up before the window goes; a file in hand is waited for, a disk that hangs is not."""
        job = self._job
        self.cancel()
        if job is not None:
            job.join(_LAST_WAIT_S)

    def _begin(self, load: AnyLoad) -> bool:
        self._since_s = monotonic()
        job = self._job = _Job(load)
        job.start()
        job.join(PATIENCE_S)
        if self._is_done(job):
            return self._finish(job)
        self._show_progress(*job.progress)
        self.show()
        self._timer.start()
        return True

    def _look(self) -> None:
        job = self._job
        if job is None:
            return
        self._show_progress(*job.progress)
        self.progressed.emit()
        if self._is_done(job):
            self._finish(job)

    def _is_done(self, job: _Job) -> bool:
        return not job.is_alive() and (job.problem is not None or self._may_put())

    def _finish(self, job: _Job) -> bool:
        """Put what was read, or say why it could not be, and go on with what waits."""
        self._end()
        try:
            if job.problem is not None:
                raise job.problem
            job.load.put(job.result)
            done = True
        except Problem as problem:
            self._failed(problem)
            done = False
        finally:
            if self._waiting and self._job is None:
                self._begin(self._waiting.popleft())
        return done

    def _end(self) -> None:
        self._job = None
        self._timer.stop()
        self.hide()
        self.progressed.emit()

    def _show_progress(self, part: LoadPhase, done: int, whole: int) -> None:
        if part is not self._part or done < self._done:
            self._part, self._since_s = part, monotonic()
        self._done = done
        name = self._job.load.what if self._job else ""
        self._words.setText(part_words(part).replace("%1", name))
        self._progress.setRange(0, whole)
        self._progress.setValue(done)
        passed_s = monotonic() - self._since_s
        told = done > 0 and passed_s > _TELL_AFTER_S
        count = self.tr("%1 of %2").replace("%1", str(done + 1)).replace("%2", str(whole)) if whole else ""
        left = self.tr("%1 s left").replace("%1", f"{passed_s * (whole - done) / max(done, 1):.0f}") if told else ""
        self._left.setText("   ·   ".join(filter(None, (count, left))))


def part_words(part: LoadPhase) -> str:
    """Return what is done in a part of a load, with %1 for what is loaded."""
    translate = QCoreApplication.translate
    match part:
        case LoadPhase.FINDING:
            return translate("Loading", "Opening %1")
        case LoadPhase.OPENING:
            return translate("Loading", "Looking through the drawings of %1")
        case LoadPhase.MEASURING:
            return translate("Loading", "Measuring the figure of %1")
        case LoadPhase.LIGHTING:
            return translate("Loading", "Finding a place for the lamp for %1")
        case LoadPhase.FEET:
            return translate("Loading", "Looking for the feet of %1")
        case LoadPhase.COMPARING:
            return translate("Loading", "Comparing the drawings of %1 with those of before")
        case LoadPhase.READING:
            return translate("Loading", "Reading drawings of %1")
