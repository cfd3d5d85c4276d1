"""The session: one document being worked on, with history and gestures."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace

from kagezou.document.address import Address
from kagezou.document.key_edits import Refs
from kagezou.document.marking import locked_and_changed
from kagezou.document.model import Document
from kagezou.session.state import State, are_alike, within_document

MAX_STEPS = 500


@dataclass(frozen=True, slots=True)
class _Step:
    name: str
    before: State
    after: State


Listener = Callable[[State, State], None]
Refusal = Callable[[], None]
LayerRefusal = Callable[[tuple[str, ...]], None]
"""Told the names of locked layers that an edit would have changed; it is not shown then."""


class Session:
    """One document being worked on. ``changed(before, after)`` is called after every change of state.

    While it is locked, nothing that a person does changes the document: whoever tries is refused, and it is told.
    """

    def __init__(self, document: Document) -> None:
        layers = document.layers
        self._state = State(document, layer_id=layers[-1].id if layers else None)
        self._saved = document
        self._done: list[_Step] = []
        self._undone: list[_Step] = []
        self._gesture: Gesture | None = None
        self._listeners: list[Listener] = []
        self._refusals: list[Refusal] = []
        self.told_of_locked: list[LayerRefusal] = []
        self._is_locked = False
        self._steps_made = 0
        self._saved_at = 0

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
    def steps_made(self) -> int:
        """How many steps were made since the session began, those taken back included."""
        return self._steps_made

    @property
    def steps_since_saved(self) -> int:
        """How many steps were made since the document was last saved."""
        return self._steps_made - self._saved_at

    @property
    def undo_name(self) -> str | None:
        """The name of the step that undo would take back."""
        return self._done[-1].name if self._done else None

    @property
    def redo_name(self) -> str | None:
        """The name of the step that redo would bring back."""
        return self._undone[-1].name if self._undone else None

    def listen(self, listener: Listener) -> None:
        """Call ``listener(before, after)`` after every change of state."""
        self._listeners.append(listener)

    def listen_to_refusals(self, listener: Refusal) -> None:
        """Call ``listener()`` whenever an edit is refused because the session is locked."""
        self._refusals.append(listener)

    def lock(self, *, locked: bool) -> None:
        """Let the document only be looked at, or be worked on again; what is under way ends as it is."""
        self._finish_gesture()
        self._is_locked = locked

    def mark_saved(self) -> None:
        """Say that the document now is on disk."""
        self._saved, self._saved_at = self._state.document, self._steps_made
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

        for steps in (self._done, self._undone):
            steps[:] = [replace(each, before=amended(each.before), after=amended(each.after)) for each in steps]
        self._show(amended(self._state))

    def undo(self) -> None:
        """Take the last step back; shows the frame and selection it was made with."""
        self._finish_gesture()
        if self._done and not self._refuses():
            self._undone.append(self._done.pop())
            self._show(self._undone[-1].before)

    def redo(self) -> None:
        """Bring the last undone step back."""
        self._finish_gesture()
        if self._undone and not self._refuses():
            self._done.append(self._undone.pop())
            self._show(self._done[-1].after)

    def go_to(self, frame: int) -> None:
        """Look at a frame, kept within the cut."""
        length = self.document.canvas.length_frames
        self._show(replace(self._state, frame=min(max(frame, 1), length)))

    def select(self, layer_id: str | None, selection: tuple[Address, ...] = ()) -> None:
        """Work on a layer and select properties."""
        self._show(replace(self._state, layer_id=layer_id, selection=selection, piece_id=None, others=frozenset()))

    def select_layers(self, layer_id: str, others: frozenset[str]) -> None:
        """Work on a layer, and edit others with it."""
        self._show(replace(self._state, layer_id=layer_id, selection=(), piece_id=None, others=others))

    def select_piece(self, piece_id: str, selection: tuple[Address, ...] = ()) -> None:
        """Work on a set piece instead of a layer and select properties."""
        self._show(replace(self._state, layer_id=None, selection=selection, piece_id=piece_id, others=frozenset()))

    def select_keys(self, keys: Refs) -> None:
        """Select keys; those that are not there are left out."""
        self._show(replace(self._state, keys=keys))

    def _refuses(self) -> bool:
        if self._is_locked:
            for listener in self._refusals:
                listener()
        return self._is_locked

    def _finish_gesture(self) -> None:
        if self._gesture is not None:
            self._gesture.commit()

    def _show(self, state: State) -> None:
        before, self._state = self._state, within_document(state)
        if not are_alike(before, self._state):
            self._tell(before)

    def _tell(self, before: State) -> None:
        for listener in self._listeners:
            listener(before, self._state)

    def _end(self, name: str, before: State, *, keep: bool) -> None:
        self._gesture = None
        if not keep:
            self._show(before)
        elif self._state.document is not before.document:
            self._done.append(_Step(name, before, self._state))
            del self._done[:-MAX_STEPS]
            self._steps_made += 1
            self._undone.clear()
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
