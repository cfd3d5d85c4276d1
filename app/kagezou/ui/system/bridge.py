"""The one place where the session's callback becomes Qt signals."""

from PySide6.QtCore import QObject, Signal

from kagezou.document.marking import soloed
from kagezou.document.model import Document
from kagezou.session.session import Session
from kagezou.session.state import State


class Bridge(QObject):
    """The session at hand, and signals for what changed in it.

    Opening another project puts another session behind the same bridge, so that panels connect once. Every signal is
    sent after the whole change is made; receivers compare with ``is`` and repaint only their part.
    """

    document_changed = Signal()
    frame_changed = Signal(int)
    frame_settled = Signal()
    """The frame is another one than when this was sent last, and frames do not pass: what takes time may follow."""
    selection_changed = Signal()
    keys_changed = Signal()
    saved_changed = Signal(bool)
    history_changed = Signal()
    session_replaced = Signal()
    shown_changed = Signal()
    """Another document is looked at for the moment, or none any more."""
    settled = Signal()
    """The document is another one than when this was sent last, and no gesture is under way."""
    lock_changed = Signal(bool)
    edit_refused = Signal()
    """Someone tried to change what can only be looked at."""
    layer_refused = Signal(tuple)
    """Someone tried to change layers that are locked; their names."""

    def __init__(self, session: Session) -> None:
        super().__init__()
        self._session = session
        self._history: tuple[str | None, str | None] = (None, None)
        self._was_saved = True
        self._looked_at: Document | None = None
        self._soloed = (session.document, soloed(session.document))
        self._settled = session.document
        self._is_passing = self._is_scrubbed = self._has_passed = False
        self._listen(session)

    @property
    def session(self) -> Session:
        """The session at hand."""
        return self._session

    @property
    def document(self) -> Document:
        """The document now."""
        return self._session.document

    @property
    def shown(self) -> Document:
        """The document that the picture shows: the session's own, or one that is looked at for the moment.

        Where layers are looked at alone, the others are hidden in it.
        """
        document = self._looked_at or self._session.document
        if document is not self._soloed[0]:
            self._soloed = (document, soloed(document))
        return self._soloed[1]

    def look_at(self, document: Document | None) -> None:
        """Show another document in the picture, until something is done or None is looked at.

        It is nowhere else: no step of history, never saved, and every panel keeps to the session's own.
        """
        if document is self._session.document:
            document = None
        if document is not self._looked_at:
            self._looked_at = document
            self.shown_changed.emit()

    @property
    def frame(self) -> int:
        """The frame looked at, from 1."""
        return self._session.state.frame

    @property
    def is_passing(self) -> bool:
        """Whether frames pass: the cut plays, or time is scrubbed."""
        return self._is_passing

    @property
    def is_scrubbed(self) -> bool:
        """Whether a hand lets frames pass."""
        return self._is_scrubbed

    def let_pass(self, *, on: bool, by_hand: bool = False) -> None:
        """Let frames pass, so that only what shows the frame itself follows; or let all else follow now."""
        self._is_passing, self._is_scrubbed = on, on and by_hand
        if not on and self._has_passed:
            self._has_passed = False
            self.frame_settled.emit()

    @property
    def is_locked(self) -> bool:
        """Whether nothing can be changed in this session, nor in those opened after it."""
        return self._session.is_locked

    def lock(self, on: bool) -> None:
        """Let everything only be looked at, or be worked on again."""
        if on != self.is_locked:
            self._session.lock(locked=on)
            self.lock_changed.emit(on)

    @property
    def layer_id(self) -> str | None:
        """The layer worked on; None while a set piece is."""
        return self._session.state.layer_id

    @property
    def piece_id(self) -> str | None:
        """The set piece worked on."""
        return self._session.state.piece_id

    @property
    def layer_ids(self) -> tuple[str, ...]:
        """Every layer that is chosen: the one worked on, then those edited with it as they lie; none with a piece."""
        state = self._session.state
        others = tuple(layer.id for layer in state.document.layers if layer.id in state.others)
        return () if state.layer_id is None else (state.layer_id, *others)

    def open(self, session: Session) -> None:
        """Put another session in the place of this one and say that everything changed."""
        session.lock(locked=self.is_locked)
        self._session = session
        self._settled = session.document
        self._looked_at = None
        self._listen(session)
        self.session_replaced.emit()
        self.document_changed.emit()
        self.selection_changed.emit()
        self.keys_changed.emit()
        self._tell_frame()
        self._tell_saved()

    def _tell_frame(self) -> None:
        self.frame_changed.emit(self.frame)
        if self._is_passing:
            self._has_passed = True
        else:
            self.frame_settled.emit()

    def _listen(self, session: Session) -> None:
        def changed(before: State, after: State) -> None:
            # A session that was put away may still hold an open gesture; nobody looks at it any more.
            if session is self._session:
                self._changed(before, after)

        def refused() -> None:
            if session is self._session:
                # Fields that were typed into show again what is.
                self.document_changed.emit()
                self.edit_refused.emit()

        session.listen(changed)

        def layers_refused(names: tuple[str, ...]) -> None:
            if session is self._session:
                self.document_changed.emit()
                self.layer_refused.emit(names)

        session.told_of_refusals.append(refused)
        session.told_of_locked.append(layers_refused)

    def _changed(self, before: State, after: State) -> None:
        if after is not before:
            self.look_at(None)
        if after.document is not before.document:
            self.document_changed.emit()
        if _chosen(after) != _chosen(before):
            self.selection_changed.emit()
        if after.keys != before.keys:
            self.keys_changed.emit()
        if after.frame != before.frame:
            self._tell_frame()
        self._tell_saved()
        if after.document is not self._settled and not self._session.is_in_gesture:
            self._settled = after.document
            self.settled.emit()

    def _tell_saved(self) -> None:
        saved = self._session.is_saved
        if saved != self._was_saved:
            self._was_saved = saved
            self.saved_changed.emit(saved)
        history = (self._session.undo_name, self._session.redo_name)
        if history != self._history:
            self._history = history
            self.history_changed.emit()


def _chosen(state: State) -> tuple[object, ...]:
    return state.layer_id, state.piece_id, state.selection, state.others
