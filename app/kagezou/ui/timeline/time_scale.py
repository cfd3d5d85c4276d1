"""Where frames lie across the timeline: every part of it that shows time shares one scale."""

from PySide6.QtCore import QObject, Signal

MARGIN_PX = 10
MIN_CELL_PX = 0.05
MAX_CELL_PX = 96.0
_ROOM_BEHIND = 1
"""Cells behind the last frame that can be scrolled to."""


class TimeScale(QObject):
    """Frames ↔ widget x. A frame is a cell, counted from 1; its key lies in the middle of it."""

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.length = 1
        self._width_px = 400
        self._cell_px = 0.0
        self._scroll_px = 0.0
        self._is_fitted = True

    @property
    def cell_px(self) -> float:
        """The width of a frame."""
        return self._fitting_px if self._is_fitted else self._cell_px

    @property
    def scroll_px(self) -> float:
        """How far the start of the cut lies left of the widget's edge."""
        return 0.0 if self._is_fitted else self._scroll_px

    @property
    def furthest_px(self) -> float:
        """The largest scroll."""
        if self._is_fitted:
            return 0.0
        return max((self.length + _ROOM_BEHIND) * self.cell_px + 2 * MARGIN_PX - self._width_px, 0.0)

    @property
    def width_px(self) -> int:
        """The width of what shows time."""
        return self._width_px

    def x_of(self, frame: float) -> float:
        """Return the x of the left edge of a frame's cell."""
        return MARGIN_PX + (frame - 1) * self.cell_px - self.scroll_px

    def middle_of(self, frame: float) -> float:
        """Return the x of the middle of a frame's cell, where its keys lie."""
        return self.x_of(frame + 0.5)

    def position_at(self, x: float) -> float:
        """Return the place in time of an x; the cell of frame n reaches from n to n + 1."""
        return (x - MARGIN_PX + self.scroll_px) / self.cell_px + 1

    def frame_at(self, x: float) -> int:
        """Return the frame whose cell lies at an x, kept within the cut."""
        return min(max(int(self.position_at(x) // 1), 1), self.length)

    def set_length(self, length: int) -> None:
        """Show a cut of so many frames."""
        if length != self.length:
            self.length = length
            self._scroll_px = min(self._scroll_px, self.furthest_px)
            self.changed.emit()

    def set_width(self, width_px: int) -> None:
        """Take note of the room there is."""
        if width_px != self._width_px:
            self._width_px = max(width_px, 1)
            self._scroll_px = min(self._scroll_px, self.furthest_px)
            self.changed.emit()

    def fit(self) -> None:
        """Show the whole cut, and go on showing it as the room changes."""
        self._is_fitted = True
        self.changed.emit()

    def zoom(self, factor: float, at_x: float) -> None:
        """Make frames wider or narrower; what lies at ``at_x`` stays there."""
        place = self.position_at(at_x)
        wanted = min(max(self.cell_px * factor, MIN_CELL_PX), MAX_CELL_PX)
        if wanted <= self._fitting_px:
            self.fit()
            return
        self._cell_px, self._is_fitted = wanted, False
        self.scroll_to(MARGIN_PX + (place - 1) * wanted - at_x)

    def scroll_to(self, scroll_px: float) -> None:
        """Lay the start of the cut so far left of the widget's edge."""
        if not self._is_fitted:
            self._scroll_px = min(max(scroll_px, 0.0), self.furthest_px)
            self.changed.emit()

    def reveal(self, frame: float) -> None:
        """Scroll no further than needed to see a frame."""
        left, right = self.x_of(frame) - MARGIN_PX, self.x_of(frame + 1) + MARGIN_PX
        if left < 0:
            self.scroll_to(self.scroll_px + left)
        elif right > self._width_px:
            self.scroll_to(self.scroll_px + right - self._width_px)

    @property
    def _fitting_px(self) -> float:
        return max((self._width_px - 2 * MARGIN_PX) / self.length, MIN_CELL_PX)
