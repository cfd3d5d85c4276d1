"""What one should know of how figures stand after a step: upright with the set, through it, as a sliver, turning."""

from PySide6.QtCore import QObject, Signal

from kagezou.document.frame_numbers import at_shown_number
from kagezou.document.model import Document
from kagezou.document.set_pieces import stood_up_notes
from kagezou.importing.lighting import turning_note
from kagezou.scene.heavy_sets import heavy_notes
from kagezou.scene.misfits import Misfit, misfits_at, new_misfits
from kagezou.tools.wall_placing import cut_notes
from kagezou.ui.system.bridge import Bridge


class StandingNotes(QObject):
    """Looks at the frame that is shown after every step.

    Parameters
    ----------
    bridge
        The session.
    """

    noted = Signal(object)
    """A message, said once while what it is about stays."""

    def __init__(self, bridge: Bridge) -> None:
        super().__init__()
        self._bridge = bridge
        self._forget()
        bridge.settled.connect(self._look)
        bridge.session_replaced.connect(self._forget)

    def _forget(self) -> None:
        """Take what is there as known: an older project stands as it was left."""
        self._document: Document = self._bridge.document
        self._known: tuple[Misfit, ...] = misfits_at(self._document, self._bridge.frame)

    def _look(self) -> None:
        before, document = self._document, self._bridge.document
        found = misfits_at(document, self._bridge.frame)
        if len(document.pieces) > len(before.pieces):
            for note in (*stood_up_notes(before, document), *cut_notes(before, document)):
                self.noted.emit(note)
        for note in heavy_notes(before, document):
            self.noted.emit(note)
        for misfit in new_misfits(self._known, found):
            self.noted.emit(at_shown_number(misfit.message, document.canvas))
        if (turning := turning_note(before, document)) is not None:
            self.noted.emit(turning)
        self._document, self._known = document, found
