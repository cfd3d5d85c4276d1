"""The steps of a session: those made, to be taken back, and those taken back, to be brought again."""

from collections.abc import Callable
from dataclasses import dataclass, replace

from kagezou.session.state import State

MAX_STEPS = 500


@dataclass(frozen=True, slots=True)
class Step:
    """What was seen before and after something was done."""

    name: str
    before: State
    after: State


class History:
    """Steps in the order in which they were made; of very many the oldest are forgotten.

    Attributes
    ----------
    made
        How many steps were made, those taken back or forgotten included.
    """

    def __init__(self) -> None:
        self._done: list[Step] = []
        self._undone: list[Step] = []
        self.made = 0
        self._saved_at = 0

    @property
    def since_saved(self) -> int:
        """How many steps were made since the document was last saved."""
        return self.made - self._saved_at

    def mark_saved(self, made: int) -> None:
        """Say that what was seen after so many steps is on disk."""
        self._saved_at = made

    @property
    def undo_name(self) -> str | None:
        """The name of the step that would be taken back."""
        return self._done[-1].name if self._done else None

    @property
    def redo_name(self) -> str | None:
        """The name of the step that would be brought back."""
        return self._undone[-1].name if self._undone else None

    def add(self, step: Step) -> None:
        """Take note of a step; those that were taken back cannot be brought back any more."""
        self._done.append(step)
        del self._done[:-MAX_STEPS]
        self._undone.clear()
        self.made += 1

    def back(self) -> State:
        """Take the last step back and return what was seen before it; there must be one."""
        self._undone.append(self._done.pop())
        return self._undone[-1].before

    def forth(self) -> State:
        """Bring back the step that was taken back last and return what was seen after it; there must be one."""
        self._done.append(self._undone.pop())
        return self._done[-1].after

    def amend(self, change: Callable[[State], State]) -> None:
        """Change every state that there ever was."""
        for steps in (self._done, self._undone):
            steps[:] = [replace(each, before=change(each.before), after=change(each.after)) for each in steps]
