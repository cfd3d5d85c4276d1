"""The pictures of the work area, decoded before they are seen, as many as memory is meant to hold."""

from collections.abc import Callable, Sequence

from kagezou.document.model import Document
from kagezou.errors import Problem
from kagezou.importing.progress import LoadPhase, Progress
from kagezou.io.images.cel_cache import CelCache
from kagezou.io.images.reading import Cel
from kagezou.picture_source import PictureSource


def read_ahead(reads: Sequence[Callable[[], Cel]], cels: CelCache, progress: Progress) -> None:
    """Decode pictures until memory holds as many as it is meant to."""
    for index, read in enumerate(reads):
        progress(LoadPhase.READING, index, len(reads))
        try:
            size = read().nbytes
        except Problem:
            continue
        if cels.nbytes + size > cels.limit_bytes:
            break


def played_drawings(document: Document) -> tuple[PictureSource, ...]:
    """Return the drawings of the work area, each once, in the order in which they are seen."""
    first, last = document.played
    seen = (layer.cels.drawing_at(frame) for frame in range(first, last + 1) for layer in document.layers)
    return tuple(dict.fromkeys(drawing.source for drawing in seen if drawing is not None))


def played_backgrounds(document: Document) -> tuple[PictureSource, ...]:
    """Return the pictures of the background in the work area, each once, in the order in which they are seen."""
    first, last = document.played
    seen = (document.behind.drawing_at(frame) for frame in range(first, last + 1))
    return tuple(dict.fromkeys(drawing.source for drawing in seen if drawing is not None))
