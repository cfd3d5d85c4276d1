"""Small pictures of the present drawing in every style, drawn beside the window's own thread."""

from dataclasses import dataclass
from functools import partial

import numpy as np
from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtGui import QImage

from kagezou.document.model import Document
from kagezou.document.style import Style
from kagezou.document.styling import put_style
from kagezou.geometry.box import Box
from kagezou.io.images.cel_cache import CelCache
from kagezou.io.images.reading import Steps
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from kagezou.ui.system.background import Latest, Turn
from kagezou.ui.system.offscreen_context import OffscreenSurface

SIDE_PX = 144
_AROUND = 0.15
"""How much of the figure's height is shown around it."""


@dataclass(frozen=True, slots=True)
class Wanted:
    """What the pictures show: layers of a document at a frame in these styles, perhaps with the styles' own light.

    The first layer is the one whose figure is seen.
    """

    document: Document
    layer_ids: tuple[str, ...]
    frame: int
    styles: tuple[Style, ...]
    with_light: bool


class StylePictures(QObject):
    """Draws one set of pictures after the other; only the newest wish counts."""

    made = Signal(int, QImage)
    """The style's index among those wanted last, and its picture."""

    def __init__(self) -> None:
        super().__init__()
        self._surface = OffscreenSurface()
        # The viewport says what is wrong with a drawing or the driver; the list keeps its names.
        self._background = Latest[tuple[int, QImage]](self._deliver, low_priority=True)

    @property
    def is_busy(self) -> bool:
        """Whether pictures are being drawn."""
        return self._background.is_busy

    def ask(self, wanted: Wanted) -> None:
        """Draw these pictures and forget what was asked for before."""
        self._background.ask(partial(_draw, self._surface, wanted))

    def pause(self) -> None:
        """Stop soon: the machine is needed elsewhere; what is still wanted is asked for again later."""
        self._background.drop()

    def finish(self) -> None:
        """Stop and wait, before the window goes."""
        self._background.finish()

    def _deliver(self, made: tuple[int, QImage]) -> None:
        self.made.emit(*made)


def _draw(surface: OffscreenSurface, wanted: Wanted, turn: Turn[tuple[int, QImage]]) -> None:
    """Draw the pictures of one wish; on the worker's thread."""
    figure = wanted.document.layer(wanted.layer_ids[0]).figure
    with surface.open():
        renderer = Renderer(CelCache())
        try:
            for index, style in enumerate(wanted.styles):
                if turn.is_unwanted:
                    return
                styled = put_style(wanted.document, wanted.layer_ids, style, wanted.frame, with_light=wanted.with_light)
                renderer.draw_picture(evaluate(styled.document, wanted.frame), Backdrop.WHITE)
                turn.tell((index, _small(renderer.read_picture(), figure)))
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
