"""Small pictures of the present drawing in every style, drawn beside the window's own thread."""

import threading
from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QObject, Qt, QThread, Signal
from PySide6.QtGui import QImage

from kagezou.document.model import Document
from kagezou.document.style import Style, apply_style
from kagezou.errors import Problem
from kagezou.geometry.box import Box
from kagezou.io.images.cel_cache import CelCache
from kagezou.io.images.reading import Steps
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from kagezou.ui.system.offscreen_context import OffscreenSurface

SIDE_PX = 144
_AROUND = 0.15
"""How much of the figure's height is shown around it."""


@dataclass(frozen=True, slots=True)
class Wanted:
    """What the pictures show: a layer of a document at a frame, in these styles."""

    document: Document
    layer_id: str
    frame: int
    styles: tuple[Style, ...]


class StylePictures(QObject):
    """Draws one set of pictures after the other; only the newest wish counts."""

    made = Signal(int, QImage)
    """The style's index among those wanted last, and its picture."""

    _drawn = Signal(object, int, QImage)

    def __init__(self) -> None:
        super().__init__()
        self._surface = OffscreenSurface()
        self._job: _Job | None = None
        self._next: Wanted | None = None
        self._wanted: Wanted | None = None
        self._drawn.connect(self._deliver)

    @property
    def is_busy(self) -> bool:
        """Whether pictures are being drawn."""
        return self._job is not None

    def ask(self, wanted: Wanted) -> None:
        """Draw these pictures and forget what was asked for before."""
        self._wanted = self._next = wanted
        if self._job is None:
            self._begin()
        else:
            self._job.stop.set()

    def pause(self) -> None:
        """Stop soon: the machine is needed elsewhere; what is still wanted is asked for again later."""
        self._next = None
        if self._job is not None:
            self._job.stop.set()

    def finish(self) -> None:
        """Stop and wait, before the window goes."""
        self._next = None
        if self._job is not None:
            self._job.stop.set()
            self._job.wait()

    def _begin(self) -> None:
        if self._next is None:
            return
        self._job = _Job(self, self._surface, self._next)
        self._next = None
        self._job.finished.connect(self._end)
        self._job.start(QThread.Priority.LowPriority)

    def _end(self) -> None:
        self._job = None
        self._begin()

    def hand_over(self, wanted: Wanted, index: int, image: QImage) -> None:
        """Take a finished picture; called on the worker's thread."""
        self._drawn.emit(wanted, index, image)

    def _deliver(self, wanted: Wanted, index: int, image: QImage) -> None:
        if wanted is self._wanted:
            self.made.emit(index, image)


class _Job(QThread):
    def __init__(self, owner: StylePictures, surface: OffscreenSurface, wanted: Wanted) -> None:
        super().__init__()
        self._owner, self._surface, self._wanted = owner, surface, wanted
        self.stop = threading.Event()

    def run(self) -> None:
        try:
            self._draw()
        except Problem:
            # The viewport says what is wrong with a drawing or the driver; the list keeps its names.
            return

    def _draw(self) -> None:
        wanted = self._wanted
        figure = wanted.document.layer(wanted.layer_id).figure
        with self._surface.open():
            renderer = Renderer(CelCache())
            try:
                for index, style in enumerate(wanted.styles):
                    if self.stop.is_set():
                        return
                    document = apply_style(wanted.document, wanted.layer_id, style, wanted.frame)
                    renderer.draw_picture(evaluate(document, wanted.frame), Backdrop.WHITE)
                    self._owner.hand_over(wanted, index, _small(renderer.read_picture(), figure))
            finally:
                renderer.close()


def _small(picture: Steps, figure: Box) -> QImage:
    """Return the square around a figure, small."""
    height, width = picture.shape[:2]
    side = min(round(figure.height * (1 + 2 * _AROUND)), height, width)
    left = min(max((figure.left + figure.right - side) // 2, 0), width - side)
    top = min(max((figure.top + figure.bottom - side) // 2, 0), height - side)
    part = np.ascontiguousarray(picture[top : top + side, left : left + side])
    whole = QImage(part.data, side, side, side * 4, QImage.Format.Format_RGBA8888)
    small = whole.scaled(
        SIDE_PX, SIDE_PX, Qt.AspectRatioMode.KeepAspectRatio, Qt.TransformationMode.SmoothTransformation
    )
    # The copy outlives the array the picture was made of.
    return small.convertToFormat(QImage.Format.Format_RGB32).copy()
