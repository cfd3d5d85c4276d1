"""Decoding the next drawings while the cut plays, so that the first time through is as smooth as the second."""

from functools import partial

from PySide6.QtCore import QObject

from kagezou.document.model import Document
from kagezou.io.images.cel_cache import CelCache
from kagezou.picture_source import PictureSource
from kagezou.ui.system.background import Queue, Turn
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.time.playback import Player

AHEAD_FRAMES = 12


class Prefetch(QObject):
    """Keeps the drawings of the next frames coming.

    Parameters
    ----------
    bridge, player
        What plays.
    cels
        Where decoded drawings are kept; drawings that are there already cost nothing.
    """

    def __init__(self, bridge: Bridge, player: Player, cels: CelCache) -> None:
        super().__init__()
        self._bridge = bridge
        self._player = player
        self._cels = cels
        self._asked: set[PictureSource] = set()
        self._asked_behind: set[PictureSource] = set()
        # The viewport meets a broken file when its frame comes, and says what is wrong.
        self._background = Queue[None](lambda _: None)
        player.playing_changed.connect(self._begin)
        bridge.frame_changed.connect(self._go_on)

    def finish(self) -> None:
        """Drop what has not begun and wait for the rest."""
        self._background.drop()
        self._background.finish()

    def _begin(self, playing: bool) -> None:
        self._asked.clear()
        self._asked_behind.clear()
        if playing:
            self._go_on()
        else:
            self._background.drop()

    def _go_on(self) -> None:
        if not self._player.is_playing:
            return
        for source in upcoming(self._bridge.document, self._bridge.frame):
            if source not in self._asked:
                self._asked.add(source)
                self._background.ask(partial(self._decode, source))
        for source in upcoming_backgrounds(self._bridge.document, self._bridge.frame):
            if source not in self._asked_behind:
                self._asked_behind.add(source)
                self._background.ask(partial(self._decode_behind, source))

    def _decode(self, source: PictureSource, _turn: Turn[None]) -> None:
        self._cels.cel(source)

    def _decode_behind(self, source: PictureSource, _turn: Turn[None]) -> None:
        self._cels.background(source)


def upcoming(document: Document, frame: int) -> list[PictureSource]:
    """Return the drawings of the frames after ``frame``, around the end, in the order they are needed."""
    found = (layer.cels.drawing_at(each) for each in _frames_after(document, frame) for layer in document.layers)
    return list(dict.fromkeys(drawing.source for drawing in found if drawing is not None))


def upcoming_backgrounds(document: Document, frame: int) -> list[PictureSource]:
    """Return the pictures of the background on the same frames."""
    found = (document.behind.drawing_at(each) for each in _frames_after(document, frame))
    return list(dict.fromkeys(drawing.source for drawing in found if drawing is not None))


def _frames_after(document: Document, frame: int) -> list[int]:
    length = document.canvas.length_frames
    return [(frame + ahead - 1) % length + 1 for ahead in range(1, min(AHEAD_FRAMES, length) + 1)]
