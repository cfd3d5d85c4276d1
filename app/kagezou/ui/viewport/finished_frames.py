"""Frames that were drawn and are kept as they are on screen, so that a cut plays again without drawing anything."""

from collections.abc import Callable, Set
from typing import Final

from PySide6.QtGui import QImage

LIMIT_MB: Final = 512
"""The memory that finished frames may take: 48 of 1920 × 1080 px, or 130 of 1280 × 800."""


class FinishedFrames:
    """Pictures of frames of one document in one view; another document or view forgets them all.

    Where no more fit, the frame goes that playing on needs last: the one just passed. So a cut that is longer than
    what fits keeps its beginning, and a part of every round is there.

    Parameters
    ----------
    limit_bytes
        The memory they may take together.
    """

    def __init__(self, limit_bytes: int = LIMIT_MB << 20) -> None:
        self._limit_bytes = limit_bytes
        self._look: tuple[object, ...] = ()
        self._kept: dict[int, QImage] = {}
        self._nbytes = 0

    @property
    def frames(self) -> Set[int]:
        """The frames that are kept."""
        return self._kept.keys()

    @property
    def nbytes(self) -> int:
        """The memory they take now."""
        return self._nbytes

    def picture(self, look: tuple[object, ...], frame: int) -> QImage | None:
        """Return a frame as it looks; None where it is not kept, or looked otherwise."""
        return self._kept.get(frame) if self._is_same(look) else None

    def keep(self, look: tuple[object, ...], frame: int, picture: QImage, length: int) -> None:
        """Keep a frame of a cut of some length.

        Parameters
        ----------
        look
            What it looks by: the document, which is compared by identity, then how it is viewed.
        """
        if not self._is_same(look):
            self.forget()
            self._look = look
        if frame in self._kept or picture.sizeInBytes() > self._limit_bytes:
            return
        while self._nbytes + picture.sizeInBytes() > self._limit_bytes:
            last: Callable[[int], int] = lambda each: (each - frame) % length  # noqa: E731 - a key, read where used
            self._nbytes -= self._kept.pop(max(self._kept, key=last)).sizeInBytes()
        self._kept[frame] = picture
        self._nbytes += picture.sizeInBytes()

    def forget(self) -> None:
        """Keep nothing any more."""
        self._look, self._nbytes = (), 0
        self._kept.clear()

    def _is_same(self, look: tuple[object, ...]) -> bool:
        return bool(self._look) and self._look[0] is look[0] and self._look[1:] == look[1:]
