"""Small pictures of drawings, decoded beside the window's own thread and kept."""

from pathlib import Path

import numpy as np
from PySide6.QtCore import QObject, QRunnable, Qt, QThreadPool, Signal
from PySide6.QtGui import QImage

from kagezou.errors import Problem
from kagezou.io.images import read_cel

SIDE_PX = 96
"""Twice what is shown, for screens with small pixels."""


class Thumbnails(QObject):
    """Pictures by file; asking for one that is not there begins to make it, ``ready`` says when it is."""

    ready = Signal()
    _made = Signal(object, QImage)

    def __init__(self) -> None:
        super().__init__()
        self._kept: dict[Path, QImage | None] = {}
        self._pool = QThreadPool(self)
        self._pool.setMaxThreadCount(1)
        self._made.connect(self._keep)

    def image(self, path: Path) -> QImage | None:
        """Return the opaque part of a drawing; None while it is made and where the file cannot be read."""
        if path not in self._kept:
            self._kept[path] = None
            self._pool.start(_Job(self, path))
        return self._kept[path]

    def wait(self) -> None:
        """Wait until nothing is being made."""
        self._pool.waitForDone()

    def deliver(self, path: Path, image: QImage) -> None:
        """Hand over a finished picture; called on the worker's thread."""
        self._made.emit(path, image)

    def _keep(self, path: Path, image: QImage) -> None:
        self._kept[path] = image
        self.ready.emit()


class _Job(QRunnable):
    def __init__(self, owner: Thumbnails, path: Path) -> None:
        super().__init__()
        self._owner, self._path = owner, path

    def run(self) -> None:
        try:
            image = _thumbnail(self._path)
        except Problem:
            # The viewport says what is wrong with the file; the list shows its empty frame.
            return
        self._owner.deliver(self._path, image)


def _thumbnail(path: Path) -> QImage:
    cel = read_cel(path)
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
