"""The neighbouring drawings and their shadows, tinted, under the drawing of the layer worked on.

Drawn only while the hand rests, one neighbour at a time, so that the window goes on answering between them.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QTimer
from PySide6.QtGui import QImage, QPainter, QPaintEvent

from kagezou.document.model import Document, Layer
from kagezou.io.images.reading import Steps
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.viewport.picture_widget import PictureWidget
from kagezou.ui.viewport.sheets import OverlaySheet

BEFORE, AFTER = (213, 94, 0), (0, 114, 178)
"""Warm is what was, cool is what comes: told apart by everyone, and by which way the figure moves."""

REST_MS = 200
NEAREST_OPACITY = 0.5
MOST = 3


@dataclass(frozen=True, slots=True)
class Neighbour:
    """A frame to show.

    Parameters
    ----------
    frame
        Where its drawing begins.
    steps
        How many drawings away; below 0 before.
    """

    frame: int
    steps: int


def neighbours(layer: Layer, frame: int, count: int) -> tuple[Neighbour, ...]:
    """Return the drawings before and after the one that is seen at a frame, the farthest first."""
    present = layer.cels.exposed_since(frame)
    starts = [max(each.frame, 1) for each in layer.cels.exposures if each.drawing is not None]
    before = [start for start in starts if start < present][-count:]
    after = [start for start in starts if start > frame][:count]
    found = [Neighbour(start, index - len(before)) for index, start in enumerate(before)]
    found += [Neighbour(start, index + 1) for index, start in enumerate(after)]
    return tuple(sorted(found, key=lambda each: -abs(each.steps)))


def tinted(picture: Steps, steps: int, present: NDArray[np.float64]) -> NDArray[np.uint8]:
    """Return a neighbour in its colour, (H, W, 4) straight; ``present`` is the alpha that covers it, 0 to 1."""
    values = np.asarray(picture, np.float64) / np.iinfo(picture.dtype).max
    light = values[..., :3] @ np.array([0.2126, 0.7152, 0.0722])
    color = np.array(BEFORE if steps < 0 else AFTER) / 255
    made = np.empty(values.shape)
    # The drawing's own lines stay to be seen within the tint.
    made[..., :3] = color + (1 - color) * 0.7 * light[..., np.newaxis]
    made[..., 3] = values[..., 3] * (1 - present) * NEAREST_OPACITY / abs(steps)
    return np.asarray(made * 255 + 0.5, np.uint8)


class OnionSkin(OverlaySheet):
    """Shows the neighbours of the drawing of the layer worked on.

    Parameters
    ----------
    viewport
        What it covers, and who draws.
    bridge
        The session shown.
    is_free
        Whether nothing moves now, so that there is time to draw.
    """

    def __init__(self, viewport: PictureWidget, bridge: Bridge, is_free: Callable[[], bool]) -> None:
        super().__init__(viewport, viewport.viewpoint)
        self._viewport = viewport
        self._bridge = bridge
        self._is_free = is_free
        self._count = 1
        self._on = False
        self._waiting: list[Neighbour] = []
        self._present: NDArray[np.float64] = np.zeros((0, 0))
        self.images: list[QImage] = []
        self._rest = QTimer(self)
        self._rest.setSingleShot(True)
        self._rest.timeout.connect(self._go_on)
        for signal in (bridge.document_changed, bridge.frame_changed, bridge.selection_changed):
            signal.connect(self._begin)

    def turn(self, on: bool) -> None:
        """Show or hide the neighbours."""
        self._on = on
        self._begin()

    def show_count(self, count: int) -> None:
        """Show so many drawings on each side."""
        self._count = count
        self._begin()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        for image in self.images:
            painter.drawImage(self.canvas, image)
        painter.end()

    def _begin(self) -> None:
        """Take away what belongs to another moment, and draw anew when the hand has rested."""
        self.images = []
        self.hide()
        document, layer_id = self._bridge.document, self._bridge.layer_id
        layers = [layer for layer in document.layers if layer.id == layer_id]
        self._waiting = list(neighbours(layers[0], self._bridge.frame, self._count)) if self._on and layers else []
        self._present = np.zeros((0, 0))
        if self._waiting:
            self._rest.start(REST_MS)
        else:
            self._rest.stop()

    def _go_on(self) -> None:
        layer_id = self._bridge.layer_id
        if not self._waiting or layer_id is None:
            return
        if not self._is_free():
            self._rest.start(REST_MS)
            return
        document = self._bridge.document
        if not self._present.size:
            drawn = self._drawn(document, self._bridge.frame, layer_id, with_shadow=False)
            if drawn is not None:
                self._present = np.asarray(drawn[..., 3], np.float64) / np.iinfo(drawn.dtype).max
        else:
            neighbour = self._waiting.pop(0)
            drawn = self._drawn(document, neighbour.frame, layer_id, with_shadow=True)
            if drawn is not None:
                self.images.append(_image(tinted(drawn, neighbour.steps, self._present)))
            self.setVisible(bool(self.images))
            self.update()
        if drawn is not None:
            self._rest.start(0)

    def _drawn(self, document: Document, frame: int, layer_id: str, *, with_shadow: bool) -> Steps | None:
        return self._viewport.layer_picture(document, frame, layer_id, with_shadow=with_shadow)


def _image(pixels: NDArray[np.uint8]) -> QImage:
    height, width = pixels.shape[:2]
    # The copy outlives the array.
    return QImage(pixels.tobytes(), width, height, width * 4, QImage.Format.Format_RGBA8888).copy()
