"""Small pictures of drawings, decoded beside the window's own thread and kept."""

import numpy as np
from PySide6.QtCore import QObject, QRunnable, Qt, QThreadPool, Signal
from PySide6.QtGui import QImage

from kagezou.errors import Problem
from kagezou.io.images.reading import read_cel
from kagezou.picture_source import PictureSource

SIDE_PX = 96
"""Twice what is shown, for screens with small pixels."""


class Thumbnails(QObject):
    """Pictures by source; asking for one that is not there begins to make it, ``ready`` says when it is."""

    ready = Signal()
    _made = Signal(object, QImage)

    def __init__(self) -> None:
        super().__init__()
        self._kept: dict[PictureSource, QImage | None] = {}
        self._pool = QThreadPool(self)
        self._pool.setMaxThreadCount(1)
        self._made.connect(self._keep)

    def image(self, source: PictureSource) -> QImage | None:
        """Return the opaque part of a drawing; None while it is made and where the file cannot be read."""
        if source not in self._kept:
            self._kept[source] = None
            self._pool.start(_Job(self, source))
        return self._kept[source]

    def wait(self) -> None:
        """Wait until nothing is being made."""
        self._pool.waitForDone()

    def deliver(self, source: PictureSource, image: QImage) -> None:
        """Hand over a finished picture; called on the worker's thread."""
        self._made.emit(source, image)

    def _keep(self, source: PictureSource, image: QImage) -> None:
        self._kept[source] = image
        self.ready.emit()


class _Job(QRunnable):
    def __init__(self, owner: Thumbnails, source: PictureSource) -> None:
        super().__init__()
        self._owner, self._source = owner, source

    def run(self) -> None:
        try:
            image = _thumbnail(self._source)
        except Problem:
            # The viewport says what is wrong with the file; the list shows its empty frame.
            return
        self._owner.deliver(self._source, image)


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
