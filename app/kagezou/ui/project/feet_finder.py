"""Feet are looked for beside the window; what is found is put in when nothing is in the hand."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from PySide6.QtCore import QObject, QTimer, Signal

from kagezou.document.model import Document, Layer
from kagezou.importing.feet import FeetOfLayer, feet_in, feet_notes, with_feet
from kagezou.importing.progress import LoadPhase
from kagezou.session.session import Session
from kagezou.ui.system.background import Queue, Turn
from kagezou.ui.system.bridge import Bridge

_WAITS_MS = 100
"""While something is in the hand what was found waits; so often it looks whether the hand is free."""


@dataclass(frozen=True, slots=True)
class _Told:
    """What comes back from the search in one layer: how far it is, or what was found."""

    session: Session
    layer_id: str
    done: int = 0
    whole: int = 0
    found: FeetOfLayer | None = None


class FeetFinder(QObject):
    """Looks for feet and puts them into the document and its history; they belong to the drawings.

    Parameters
    ----------
    bridge
        The session worked in.
    """

    progressed = Signal(int, int)
    """So many drawings of so many have been looked at; 0 of 0 when all is done."""
    noted = Signal(object)
    """A Message that the user should know."""
    found = Signal(str)
    """The feet of a layer, by its id, are in the document."""

    def __init__(self, bridge: Bridge) -> None:
        super().__init__()
        self._bridge = bridge
        self._queue: Queue[_Told] = Queue(self._take, ended=self._end, low_priority=True)
        self._ready: list[_Told] = []
        self._timer = QTimer(self)
        self._timer.setInterval(_WAITS_MS)
        self._timer.timeout.connect(self._put)

    @property
    def is_busy(self) -> bool:
        """Whether something is looked for, or waits to be put in."""
        return self._queue.is_busy or bool(self._ready)

    def search(self, layer_ids: Any) -> None:
        """Look for the feet of layers; those that were there before are found anew, what a person said stays."""
        session = self._bridge.session
        for layer_id in layer_ids:
            self._queue.ask(_work(session, session.document.layer(layer_id)))

    def forget(self) -> None:
        """Drop what belongs to another session."""
        self._queue.drop()
        self._ready = []
        self._timer.stop()
        self.progressed.emit(0, 0)

    def finish(self) -> None:
        """End with the window."""
        self._queue.drop()
        self._queue.finish()

    def _take(self, told: _Told) -> None:
        if told.session is not self._bridge.session:
            return
        if told.found is None:
            self.progressed.emit(told.done, told.whole)
            return
        self._ready.append(told)
        self._put()

    def _put(self) -> None:
        """Put in what was found, unless something is in the hand now."""
        session = self._bridge.session
        if session.is_in_gesture:
            self._timer.start()
            return
        self._timer.stop()
        ready, self._ready = self._ready, []
        for told in ready:
            self._put_one(session, told)

    def _put_one(self, session: Session, told: _Told) -> None:
        if told.found is None or told.layer_id not in {layer.id for layer in session.document.layers}:
            return
        layer_id, found = told.layer_id, told.found

        def stands(document: Document) -> Document:
            has_it = any(layer.id == layer_id for layer in document.layers)
            return with_feet(document, layer_id, found) if has_it else document

        session.amend(stands)
        for note in feet_notes(session.document, layer_id, found):
            self.noted.emit(note)
        self.found.emit(layer_id)

    def _end(self) -> None:
        if not self._queue.is_busy:
            self.progressed.emit(0, 0)


def _work(session: Session, layer: Layer) -> Callable[[Turn[_Told]], None]:
    def work(turn: Turn[_Told]) -> None:
        def progress(_part: LoadPhase, done: int, whole: int) -> None:
            turn.tell(_Told(session, layer.id, done, whole))

        found = feet_in(layer, progress, lambda: turn.is_unwanted)
        if not turn.is_unwanted:
            turn.tell(_Told(session, layer.id, found=found))

    return work
