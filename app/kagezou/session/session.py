"""The session: one document being worked on, with history and gestures."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from typing import Final

from kagezou.document.address import Address
from kagezou.document.key_edits import Refs
from kagezou.document.marking import locked_and_changed
from kagezou.document.model import Document
from kagezou.errors import Problem
from kagezou.session.history import History, Step
from kagezou.session.state import State, same, within

Ids = frozenset[str]
NOBODY: Final[Ids] = frozenset()

Listener = Callable[[State, State], None]
Refusal = Callable[[], None]
"""Told whenever an edit is refused because the session is locked."""
Admission = Callable[[Document, Document], None]
"""Raises a Problem if the second document may not follow the first as a step."""
LayerRefusal = Callable[[tuple[str, ...]], None]
"""Told the names of locked layers that an edit would have changed; it is not shown then."""


@dataclass(frozen=True, slots=True)
class SavePoint:
    """A document at the moment when it is to be written.

    Parameters
    ----------
    document
        The document.
    made
        How many steps had been made by then.
    """

    document: Document
    made: int


class Session:
    """One document being worked on. ``changed(before, after)`` is called after every change of state.

    While it is locked, nothing that a person does changes the document: whoever tries is refused, and it is told.

    Parameters
    ----------
    document
        The document, taken for saved.
    admit
        Asked before a step is taken for made; a Problem that it raises undoes the step and passes through.
    """

    def __init__(self, document: Document, admit: Admission = lambda _before, _after: None) -> None:
        self._state = State(document, layer_id=document.layers[-1].id if document.layers else None)
        self._saved = document
        self._history, self._is_locked = History(), False
        self._gesture: Gesture | None = None
        self._listeners: list[Listener] = []
        self.told_of_refusals: list[Refusal] = []
        self.told_of_locked: list[LayerRefusal] = []
        self._admit = admit

    @property
    def state(self) -> State:
        """What is seen now, an unfinished gesture included."""
        return self._state

    @property
    def document(self) -> Document:
        """The document now."""
        return self._state.document

    @property
    def is_saved(self) -> bool:
        """Whether the document now is the one last saved."""
        return self._state.document is self._saved

    @property
    def is_in_gesture(self) -> bool:
        """Whether something is under way that will be one step, such as a drag."""
        return self._gesture is not None

    @property
    def is_locked(self) -> bool:
        """Whether the document can only be looked at."""
        return self._is_locked

    @property
    def history(self) -> History:
        """The steps made so far."""
        return self._history

    @property
    def undo_name(self) -> str | None:
        """The name of the step that undo would take back."""
        return self._history.undo_name

    @property
    def redo_name(self) -> str | None:
        """The name of the step that redo would bring back."""
        return self._history.redo_name

    def listen(self, listener: Listener) -> None:
        """Call ``listener(before, after)`` after every change of state."""
        self._listeners.append(listener)

    def lock(self, *, locked: bool) -> None:
        """Let the document only be looked at, or be worked on again; what is under way ends as it is."""
        self._finish_gesture()
        self._is_locked = locked

    @property
    def save_point(self) -> SavePoint:
        """The document now, to be written; what is done meanwhile comes after it."""
        return SavePoint(self._state.document, self._history.made)

    def mark_saved(self, point: SavePoint | None = None) -> None:
        """Say that the document of a save point, or the one now, is on disk."""
        point = point or self.save_point
        self._saved = point.document
        self._history.mark_saved(point.made)
        self._tell(self._state)

    def edit(self, name: str, document: Document) -> None:
        """Make a new document the present one, as one step; the same document is no step."""
        with self.gesture(name) as gesture:
            gesture.show(document)

    @contextmanager
    def gesture(self, name: str) -> Iterator["Gesture"]:
        """Collect everything shown within the block into one step; an exception restores what was.

        Dropped if nothing changed. A gesture within a gesture joins it.
        """
        if self._gesture is not None:
            yield self._gesture
            return
        gesture = self.begin(name)
        try:
            yield gesture
        except BaseException:
            gesture.cancel()
            raise
        gesture.commit()

    def begin(self, name: str) -> "Gesture":
        """Begin a gesture that lives longer than a block, such as a drag; end it by commit or cancel.

        In a locked session it shows nothing and becomes no step.
        """
        if self._gesture is not None:
            self._gesture.commit()
        if self._refuses():
            return Gesture(self, name, self._state, is_open=False)
        self._gesture = Gesture(self, name, self._state)
        return self._gesture

    def amend(self, change: Callable[[Document], Document]) -> None:
        """Change the document now and all of history alike, as if it had always been so; this is no step.

        For what was found out about pictures, which is as true of every earlier state. What is on disk lacks it still.
        """
        self._finish_gesture()
        known: dict[int, Document] = {}

        def amended(state: State) -> State:
            key = id(state.document)
            if key not in known:
                known[key] = change(state.document)
            return replace(state, document=known[key])

        self._history.amend(amended)
        self._show(amended(self._state))

    def undo(self) -> None:
        """Take the last step back; shows the frame and selection it was made with."""
        self._finish_gesture()
        if self.undo_name is not None and not self._refuses():
            self._show(self._history.back())

    def redo(self) -> None:
        """Bring the last undone step back."""
        self._finish_gesture()
        if self.redo_name is not None and not self._refuses():
            self._show(self._history.forth())

    def go_to(self, frame: int) -> None:
        """Look at a frame, kept within the cut."""
        self._show(replace(self._state, frame=min(max(frame, 1), self.document.canvas.length_frames)))

    def select(self, layer_id: str | None, selection: tuple[Address, ...] = (), others: Ids = NOBODY) -> None:
        """Work on a layer, edit others with it, and select properties."""
        self._show(replace(self._state, layer_id=layer_id, selection=selection, piece_id=None, others=others))

    def select_piece(self, piece_id: str, selection: tuple[Address, ...] = ()) -> None:
        """Work on a set piece instead of a layer and select properties."""
        self._show(replace(self._state, layer_id=None, selection=selection, piece_id=piece_id, others=frozenset()))

    def select_properties(self, selection: tuple[Address, ...]) -> None:
        """Select properties of what is worked on."""
        self._show(replace(self._state, selection=selection))

    def select_keys(self, keys: Refs) -> None:
        """Select keys; those that are not there are left out."""
        self._show(replace(self._state, keys=keys))

    def _refuses(self) -> bool:
        for listener in self.told_of_refusals if self._is_locked else ():
            listener()
        return self._is_locked

    def _finish_gesture(self) -> None:
        if self._gesture is not None:
            self._gesture.commit()

    def _show(self, state: State) -> None:
        before, self._state = self._state, within(state, self._state)
        if not same(before, self._state):
            self._tell(before)

    def _tell(self, before: State) -> None:
        for listener in self._listeners:
            listener(before, self._state)

    def _ask(self, before: State) -> None:
        try:
            self._admit(before.document, self._state.document)
        except Problem:
            self._show(before)
            raise

    def _end(self, name: str, before: State, *, keep: bool) -> None:
        self._gesture = None
        if not keep:
            self._show(before)
        elif self._state.document is not before.document:
            self._ask(before)
            self._history.add(Step(name, before, self._state))
            self._tell(self._state)


class Gesture:
    """A run of documents shown one after the other that becomes one step of history."""

    def __init__(self, session: Session, name: str, before: State, *, is_open: bool = True) -> None:
        self._session = session
        self._name = name
        self._before = before
        self._open = is_open

    @property
    def start(self) -> Document:
        """The document before the gesture."""
        return self._before.document

    def show(self, document: Document, keys: Refs | None = None) -> None:
        """Make a document the present one, for now, and select keys in it where they are given."""
        if self._open and self._leaves_locked(document):
            state = self._session.state
            chosen = state.keys if keys is None else keys
            self._session._show(replace(state, document=document, keys=chosen))  # noqa: SLF001 - its own session

    def _leaves_locked(self, document: Document) -> bool:
        """Whether a document leaves locked layers as they are; whoever tries otherwise is told."""
        names = locked_and_changed(self._before.document, document)
        for tell in self._session.told_of_locked if names else ():
            tell(names)
        return not names

    def commit(self) -> None:
        """End the gesture as one step, or as none if nothing changed."""
        self._close(keep=True)

    def cancel(self) -> None:
        """End the gesture and restore what was."""
        self._close(keep=False)

    def _close(self, *, keep: bool) -> None:
        if self._open:
            self._open = False
            self._session._end(self._name, self._before, keep=keep)  # noqa: SLF001 - its own session
