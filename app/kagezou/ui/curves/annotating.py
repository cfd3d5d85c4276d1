"""Who may say something about the cut, and how it is done while everything else can only be looked at."""

from PySide6.QtCore import QObject, Signal

from kagezou.document.model import Document
from kagezou.ui.system.bridge import Bridge


class Annotating(QObject):
    """The right to write notes: always, but for a session that is locked and is not reviewed.

    Parameters
    ----------
    bridge
        The session.
    """

    changed = Signal()

    def __init__(self, bridge: Bridge) -> None:
        super().__init__()
        self._bridge = bridge
        self._is_reviewing = False
        bridge.lock_changed.connect(self.changed)

    @property
    def may(self) -> bool:
        """Whether notes may be written, answered and ticked off."""
        return self._is_reviewing or not self._bridge.is_locked

    def review(self, *, on: bool) -> None:
        """Let notes be written although nothing else can be changed."""
        self._is_reviewing = on
        self.changed.emit()

    def edit(self, name: str, document: Document) -> None:
        """Make a document with other notes the present one."""
        session = self._bridge.session
        if not (session.is_locked and self._is_reviewing):
            session.edit(name, document)
            return
        session.lock(locked=False)
        try:
            session.edit(name, document)
        finally:
            session.lock(locked=True)
