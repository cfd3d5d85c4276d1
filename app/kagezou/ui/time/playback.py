"""Playing the cut: which frame is due, by a clock, and how many frames a second are really seen."""

from collections import deque
from collections.abc import Callable
from time import monotonic

from PySide6.QtCore import QObject, Qt, QTimer, Signal

from kagezou.ui.system.bridge import Bridge

_WINDOW_S = 1.0


class Player(QObject):
    """Moves the session's frame along in time.

    With ``every_frame`` each frame is shown, later than due where drawing is slow; without it frames are dropped so
    that the timing is true. Either way nobody is told a rate that was not seen.

    Parameters
    ----------
    bridge
        The session to play.
    clock
        Seconds that only go forward.
    """

    playing_changed = Signal(bool)
    rate_measured = Signal(float)
    """Frames a second that were shown over the last second."""

    def __init__(self, bridge: Bridge, clock: Callable[[], float] = monotonic) -> None:
        super().__init__()
        self.loop = True
        self.ping_pong = False
        self.every_frame = True
        self._way = 1
        self._bridge = bridge
        self._clock = clock
        self._timer = QTimer(self)
        self._timer.setTimerType(Qt.TimerType.PreciseTimer)
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._tick)
        self._is_playing = False
        self._due_s = 0.0
        self._waiting_for_picture = False
        self._shown_at: deque[float] = deque()
        bridge.session_replaced.connect(self.stop)

    @property
    def is_playing(self) -> bool:
        """Whether the cut runs."""
        return self._is_playing

    def toggle(self) -> None:
        """Play, or stop where it is."""
        if self._is_playing:
            self.stop()
        else:
            self.start()

    def start(self) -> None:
        """Play the work area from here; from its start where this is its end or not within it."""
        first, last = self._bridge.document.played
        if self._is_playing or first == last:
            return
        self._way = 1
        if not first <= self._bridge.frame < last:
            self._bridge.session.go_to(first)
        self._is_playing = True
        self._bridge.let_pass(on=True)
        self._waiting_for_picture = False
        self._shown_at.clear()
        self._due_s = self._clock() + self._frame_s
        self._wait()
        self.playing_changed.emit(True)

    def stop(self) -> None:
        """Stop on the frame that is seen."""
        if self._is_playing:
            self._is_playing = False
            self._timer.stop()
            self._bridge.let_pass(on=False)
            self.playing_changed.emit(False)

    def picture_shown(self) -> None:
        """Take note that the viewport has brought a frame to the screen."""
        # Other widgets are brought to the screen too; only the first time after a step it is that step's frame.
        is_new, self._waiting_for_picture = self._waiting_for_picture, False
        if not self._is_playing or not is_new:
            return
        now = self._clock()
        self._shown_at.append(now)
        while now - self._shown_at[0] > _WINDOW_S:
            self._shown_at.popleft()
        span = now - self._shown_at[0]
        if span > _WINDOW_S / 4:
            self.rate_measured.emit((len(self._shown_at) - 1) / span)

    @property
    def _frame_s(self) -> float:
        return float(1 / self._bridge.document.canvas.frame_rate)

    def _tick(self) -> None:
        now = self._clock()
        if not self._is_playing:
            return
        if self.every_frame and self._waiting_for_picture and now - self._due_s < 1.0:
            self._timer.start(1)
            return
        late_frames = max(int((now - self._due_s) / self._frame_s), 0)
        steps = 1 if self.every_frame else 1 + late_frames
        self._due_s += steps * self._frame_s
        if self.every_frame and late_frames:
            self._due_s = now + self._frame_s
        self._advance(steps)
        if self._is_playing:
            self._wait()

    def _advance(self, steps: int) -> None:
        first, last = self._bridge.document.played
        if not self.loop and self._bridge.frame + steps > last:
            self._bridge.session.go_to(last)
            self.stop()
            return
        self._waiting_for_picture = True
        if self.loop and self.ping_pong:
            frame, self._way = bounced(self._bridge.frame, self._way, steps, (first, last))
        else:
            frame = (self._bridge.frame + steps - first) % (last - first + 1) + first
        self._bridge.session.go_to(frame)

    def _wait(self) -> None:
        self._timer.start(max(round((self._due_s - self._clock()) * 1000), 0))


def bounced(frame: int, way: int, steps: int, ends: tuple[int, int]) -> tuple[int, int]:
    """Return the frame ``steps`` on when playing turns around at both ends, and which way it then goes.

    Parameters
    ----------
    frame
        Within the ends, or it counts as the nearest of them.
    way
        1 forward, -1 backward.
    ends
        First and last frame, not the same.
    """
    first, last = ends
    there = last - first
    place = min(max(frame, first), last) - first
    # Forward and back is one round of twice the way; the ends are seen once each.
    around = ((place if way > 0 else 2 * there - place) + steps) % (2 * there)
    return (first + around, 1) if around <= there else (first + 2 * there - around, -1)
