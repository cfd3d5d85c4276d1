"""How the canvas is looked at: zoom and place, fitting, and sizes on screens with small pixels."""

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QColor

from kagezou.geometry.vectors import Point2
from kagezou.tools.view import CanvasView
from kagezou.ui.system.theme import SURROUND

ZOOM_STEP = 2.0**0.25
"""One notch of the wheel: four double the size."""

FIT_MARGIN_PX = 64.0
"""Room around the canvas for the handles that stand at its edge."""

FIT_MARGIN_PART = 0.1
"""The most of the viewport's shorter side that may be left as such room: on a small screen the picture goes first."""


class Viewpoint(QObject):
    """The view of one viewport, in logical px; it stays fitted until someone zooms or pans.

    ``percent`` counts device pixels, as artists do: at 100 each pixel of the canvas is one of the screen. ``surround``
    is the colour around the canvas.
    """

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.view = CanvasView()
        self.surround = SURROUND
        self._size: Point2 = (1.0, 1.0)
        self._canvas: Point2 = (1.0, 1.0)
        self._ratio = 1.0
        self._is_fitted = True

    @property
    def size(self) -> Point2:
        """The viewport's width and height, logical px."""
        return self._size

    @property
    def canvas_size(self) -> Point2:
        """The canvas' width and height, canvas px."""
        return self._canvas

    @property
    def device_ratio(self) -> float:
        """Device pixels a logical px."""
        return self._ratio

    @property
    def is_fitted(self) -> bool:
        """Whether the whole canvas is shown and kept shown."""
        return self._is_fitted

    @property
    def percent(self) -> float:
        """Device pixels for 100 canvas px."""
        return self.view.zoom * self._ratio * 100

    def resize(self, size: Point2, device_ratio: float) -> None:
        """Take note of the viewport's size; the middle stays in the middle."""
        old, self._size, self._ratio = self._size, size, device_ratio
        if self._is_fitted:
            self.fit()
        else:
            self._show(self.view.panned((size[0] - old[0]) / 2, (size[1] - old[1]) / 2))

    def set_canvas(self, size_px: Point2) -> None:
        """Take note of the canvas' size; another size is fitted anew."""
        if size_px != self._canvas:
            self._canvas = size_px
            self.fit()

    def show_surround(self, color: QColor) -> None:
        """Have another colour around the canvas."""
        if color != self.surround:
            self.surround = color
            self.changed.emit()

    def fit(self) -> None:
        """Show the whole canvas."""
        self._is_fitted = True
        margin = min(FIT_MARGIN_PX, FIT_MARGIN_PART * min(self._size))
        self._show(CanvasView.fitted(self._canvas, self._size, margin))

    def show_actual_pixels(self) -> None:
        """Show one pixel of the canvas as one of the screen, around what is in the middle now."""
        self._freely(self.view.zoomed_at(self._middle, 1 / (self._ratio * self.view.zoom)))

    def zoom_at(self, place_px: Point2, steps: float) -> None:
        """Magnify by notches of the wheel, the canvas point at a place of the viewport staying there."""
        self._freely(self.view.zoomed_at(place_px, ZOOM_STEP**steps))

    def magnify_at(self, place_px: Point2, factor: float) -> None:
        """Magnify by a factor, as two fingers do."""
        self._freely(self.view.zoomed_at(place_px, factor))

    def zoom_middle(self, steps: float) -> None:
        """Magnify around the middle of the viewport."""
        self.zoom_at(self._middle, steps)

    def pan(self, dx: float, dy: float) -> None:
        """Move the picture by logical px."""
        self._freely(self.view.panned(dx, dy))

    @property
    def _middle(self) -> Point2:
        return (self._size[0] / 2, self._size[1] / 2)

    def _freely(self, view: CanvasView) -> None:
        self._is_fitted = False
        self._show(view)

    def _show(self, view: CanvasView) -> None:
        if view != self.view:
            self.view = view
            self.changed.emit()
