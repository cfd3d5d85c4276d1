"""What is kept on the graphics card by name, within a budget of memory: the least lately used goes first."""

from collections import OrderedDict
from collections.abc import Callable, Iterable
from typing import Generic, Protocol, TypeVar


class Budgeted(Protocol):
    """What is kept under a name."""

    @property
    def nbytes(self) -> int:
        """The memory it takes now."""
        ...

    def close(self) -> None:
        """Give the memory back."""
        ...


K = TypeVar("K")
T = TypeVar("T", bound=Budgeted)


class Budget(Generic[K, T]):
    """Things by name.

    What was used lately may be in use still: the last ``spared`` are never let go to make room.

    Parameters
    ----------
    budget_bytes
        What all may take together.
    spared
        How many stay whatever they take.
    """

    def __init__(self, budget_bytes: int, spared: int = 2) -> None:
        self._budget_bytes, self._spared = budget_bytes, spared
        self._kept: OrderedDict[K, T] = OrderedDict()

    @property
    def nbytes(self) -> int:
        """The memory that all take together."""
        return sum(each.nbytes for each in self._kept.values())

    @property
    def names(self) -> tuple[K, ...]:
        """Under which names something is kept, the latest last."""
        return tuple(self._kept)

    def latest(self, name: K, fitting: Callable[[T | None], T]) -> T:
        """Return what is kept under a name, as the latest.

        ``fitting`` is given what is there, if anything, and returns it or what takes its place, having closed it.
        """
        self._make_room()
        kept = self._kept[name] = fitting(self._kept.pop(name, None))
        return kept

    def forget(self, names: Iterable[K]) -> None:
        """Give back the memory of some."""
        for name in names:
            self._kept.pop(name).close()

    def close(self) -> None:
        """Give back the memory of all."""
        self.forget(self.names)

    def _make_room(self) -> None:
        over = self.nbytes - self._budget_bytes
        for name in self.names[: -self._spared]:
            if over <= 0:
                return
            over -= self._kept[name].nbytes
            self.forget([name])
