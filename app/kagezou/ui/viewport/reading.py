"""Drawings that are not in memory yet are decoded beside the window; until they are there the last picture stays."""

import threading
from collections.abc import Callable, Iterable
from functools import partial

from PySide6.QtCore import QObject, Signal

from kagezou.document.model import Document
from kagezou.errors import Problem
from kagezou.io.images.cel_cache import CelCache
from kagezou.picture_source import PictureSource
from kagezou.ui.system.background import Latest, Turn

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
    """What was missing is there, or cannot be read."""

    def __init__(self, cels: CelCache) -> None:
        super().__init__()
        self._cels = cels
        self._came: set[PictureSource] = set()
        self._background = Latest[None](lambda _: self.arrived.emit())

    def has_drawings_of(self, document: Document, frame: int) -> bool:
        """Whether a frame can be drawn without reading files; if not, they are read and ``arrived`` is sent."""
        missing = [(each, read) for each, read in self._needed(document, frame) if not self._cels.is_kept(each)]
        # What came and is not kept cannot be read, or is larger than all that may be kept: drawing it will tell.
        if all(source in self._came for source, _ in missing):
            return True
        self._came.clear()
        done = threading.Event()
        return self._background.ask(partial(self._read, missing, done)) and done.wait(PATIENCE_S)

    def finish(self) -> None:
        """Read nothing any more, before the window goes."""
        self._background.finish()

    def _read(self, wanted: Iterable[tuple[PictureSource, Read]], done: threading.Event, turn: Turn[None]) -> None:
        """Read pictures; on the worker's thread."""
        for source, read in wanted:
            if turn.is_unwanted:
                return
            try:
                read(source)
            except Problem:
                # Whoever draws meets the same file, and says what is wrong with it.
                continue
            finally:
                self._came.add(source)
        done.set()
        turn.tell(None)

    def _needed(self, document: Document, frame: int) -> Iterable[tuple[PictureSource, Read]]:
        behind = document.behind.drawing_at(frame)
        if behind is not None:
            yield behind.source, self._cels.background
        for layer in document.layers:
            if (drawing := layer.cels.drawing_at(frame)) is not None:
                yield drawing.source, self._cels.cel
