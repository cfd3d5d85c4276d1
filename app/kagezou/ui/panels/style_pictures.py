"""Small pictures of the present drawing in every style, drawn beside the window's own thread."""

from dataclasses import dataclass
from functools import partial

import numpy as np
from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtGui import QImage

from kagezou.document.local_name import LocalName
from kagezou.document.model import Document
from kagezou.document.style import NO_VALUES, Style
from kagezou.document.styling import put_style
from kagezou.export.portraits import Portraits
from kagezou.io.images.reading import Steps
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.ui.system.background import Latest, Turn
from kagezou.ui.system.offscreen_context import OffscreenSurface

SIDE_PX = 144
_PLAIN = Style(LocalName(""), 1.0, NO_VALUES)


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

    def in_style(self, style: Style) -> Document:
        """Return the document in a style."""
        return put_style(self.document, self.layer_ids, style, self.frame, with_light=self.with_light).document


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
    first = wanted.document.layer(wanted.layer_ids[0])
    with surface.open():
        portraits = Portraits(wanted.document, first.joins or first.id, wanted.frame, SIDE_PX)
        try:
            # What every picture shows at least, so that the figure is as large in most of them.
            usual = portraits.box(wanted.in_style(_PLAIN))
            for index, style in enumerate(wanted.styles):
                if turn.is_unwanted:
                    return
                document = wanted.in_style(style)
                around = usual.union(portraits.box(document))
                turn.tell((index, _small(portraits.draw(document, around, Backdrop.WHITE))))
        finally:
            portraits.close()


def _small(picture: Steps) -> QImage:
    """Return a square picture, small."""
    side = picture.shape[0]
    whole = QImage(np.ascontiguousarray(picture).data, side, side, side * 4, QImage.Format.Format_RGBA8888)
    small = whole.scaled(
        SIDE_PX, SIDE_PX, Qt.AspectRatioMode.KeepAspectRatio, Qt.TransformationMode.SmoothTransformation
    )
    # The copy outlives the array the picture was made of.
    return small.convertToFormat(QImage.Format.Format_RGB32).copy()
