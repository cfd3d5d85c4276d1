"""Small pictures of drawings, decoded beside the window's own thread and kept."""

from collections import OrderedDict

import numpy as np
from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtGui import QImage

from kagezou.io.images.reading import read_cel
from kagezou.picture_source import PictureSource
from kagezou.ui.system.background import Queue

SIDE_PX = 96
"""Twice what is shown, for screens with small pixels."""
BUDGET_BYTES = 32 << 20
"""What all pictures may take together: some thousand times what a list shows at once."""


class Thumbnails(QObject):
    """Pictures by source; asking for one that is not there begins to make it, ``ready`` says when it is."""

    ready = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._kept: OrderedDict[PictureSource, QImage] = OrderedDict()
        self._coming: set[PictureSource] = set()
        # The viewport says what is wrong with a file; the list shows its empty frame.
        self._background = Queue[tuple[PictureSource, QImage]](self._keep)

    @property
    def kept(self) -> set[PictureSource]:
        """What is there."""
        return set(self._kept)

    @property
    def nbytes(self) -> int:
        """The memory it takes."""
        return sum(image.sizeInBytes() for image in self._kept.values())

    def image(self, source: PictureSource) -> QImage | None:
        """Return the opaque part of a drawing; None while it is made and where the file cannot be read."""
        image = self._kept.get(source)
        if image is not None:
            self._kept.move_to_end(source)
        elif source not in self._coming:
            # One that cannot be read stays among those that come: it is not tried again each time it is looked for.
            self._coming.add(source)
            self._background.ask(lambda turn: turn.tell((source, _thumbnail(source))))
        return image

    def finish(self) -> None:
        """Make no more, before the window goes."""
        self._background.drop()
        self._background.finish()

    def _keep(self, made: tuple[PictureSource, QImage]) -> None:
        source, image = made
        self._kept[source] = image
        self._coming.discard(source)
        while self.nbytes > BUDGET_BYTES and len(self._kept) > 1:
            self._kept.popitem(last=False)
        self.ready.emit()


def _thumbnail(source: PictureSource) -> QImage:
    cel = read_cel(source)
    box = cel.matte.box
    part = cel.rgba if box is None else cel.rgba[box.top : box.bottom, box.left : box.right]
    eight_bit = part if part.dtype == np.uint8 else part >> 8
    pixels = np.ascontiguousarray(eight_bit, dtype=np.uint8)
    height, width = pixels.shape[:2]
    whole = QImage(pixels.data, width, height, width * 4, QImage.Format.Format_RGBA8888)
    small = whole.scaled(
        SIDE_PX, SIDE_PX, Qt.AspectRatioMode.KeepAspectRatio, Qt.TransformationMode.SmoothTransformation
    )
    # The copy outlives the array the picture was made of.
    return small.convertToFormat(QImage.Format.Format_ARGB32_Premultiplied).copy()
