"""Two taps of a pen, which Qt does not tell as a double click."""

from math import hypot

from PySide6.QtGui import QGuiApplication

from kagezou.geometry.vectors import Point2
from kagezou.ui.viewport.pointer_report import PointerReport

TAP_RADIUS_PX = 12.0


class PenTaps:
    """Remembers the last tap."""

    def __init__(self) -> None:
        self._last: tuple[Point2, int] | None = None

    def is_second_tap(self, report: PointerReport, timestamp_ms: int) -> bool:
        """Take note of a tap; true where it follows another one closely in place and time."""
        last, self._last = self._last, (report.view_px, timestamp_ms)
        if last is None:
            return False
        (x, y), before_ms = last
        near = hypot(report.view_px[0] - x, report.view_px[1] - y) <= TAP_RADIUS_PX
        soon = timestamp_ms - before_ms <= QGuiApplication.styleHints().mouseDoubleClickInterval()
        if near and soon:
            self._last = None
        return near and soon
