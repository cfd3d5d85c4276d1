"""Drawings that are not in memory yet are decoded beside the window; until they are there the last picture stays."""

import threading
from collections.abc import Callable, Iterable

from PySide6.QtCore import QObject, QRunnable, QThreadPool, Signal

from kagezou.document.model import Document
from kagezou.errors import Problem
from kagezou.io.images.cel_cache import CelCache
from kagezou.picture_source import PictureSource

PATIENCE_S = 0.04
"""So long a picture waits for its drawings: small ones are there by then, and nothing flickers."""

Read = Callable[[PictureSource], object]


class Reading(QObject):
    """Brings the drawings of a frame into memory.

    Parameters
    ----------
    cels
        Where decoded drawings are kept.
    """

    arrived = Signal()
    """What was missing is there, or cannot be read; sent from the thread that read it."""

    def __init__(self, cels: CelCache) -> None:
        super().__init__()
        self._cels = cels
        self._came: set[PictureSource] = set()
        self._pool = QThreadPool(self)
        self._pool.setMaxThreadCount(1)

    def has_drawings_of(self, document: Document, frame: int) -> bool:
        """Whether a frame can be drawn without reading files; if not, they are read and ``arrived`` is sent."""
        missing = [(each, read) for each, read in self._needed(document, frame) if not self._cels.is_kept(each)]
        # What came and is not kept cannot be read, or is larger than all that may be kept: drawing it will tell.
        if all(source in self._came for source, _ in missing):
            return True
        self._came.clear()
        self._pool.clear()
        job = _Job(self, missing)
        self._pool.start(job)
        return job.done.wait(PATIENCE_S)

    def came(self, source: PictureSource) -> None:
        """Take note of a picture that was read, or could not be."""
        self._came.add(source)

    def finish(self) -> None:
        """Read nothing any more, before the window goes."""
        self._pool.clear()
        self._pool.waitForDone()

    def _needed(self, document: Document, frame: int) -> Iterable[tuple[PictureSource, Read]]:
        if document.background is not None:
            yield document.background, self._cels.background
        for layer in document.layers:
            if (drawing := layer.cels.drawing_at(frame)) is not None:
                yield drawing.source, self._cels.cel


class _Job(QRunnable):
    def __init__(self, owner: Reading, wanted: Iterable[tuple[PictureSource, Read]]) -> None:
        super().__init__()
        self._owner, self._wanted = owner, wanted
        self.done = threading.Event()

    def run(self) -> None:
        for source, read in self._wanted:
            try:
                read(source)
            except Problem:
                # Whoever draws meets the same file, and says what is wrong with it.
                continue
            finally:
                self._owner.came(source)
        self.done.set()
        self._owner.arrived.emit()
