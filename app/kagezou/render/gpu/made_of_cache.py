"""Things on the graphics card kept within a budget of memory."""

from collections import OrderedDict, deque
from collections.abc import Callable
from typing import Generic, Protocol, TypeVar
from weakref import ref


class Kept(Protocol):
    """What is kept of one source."""

    @property
    def nbytes(self) -> int:
        """The memory it takes."""
        ...

    def close(self) -> None:
        """Give the memory back."""
        ...


T = TypeVar("T", bound=Kept)


class MadeOfCache(Generic[T]):
    """The things last used, each made of one object in memory; the least recently used go first.

    The object itself is not kept alive: it belongs to whoever decoded it and may take many times the memory of what
    was made of it. What was made of an object that is gone cannot be asked for again and goes at the next making.
    """

    def __init__(self, budget_bytes: int) -> None:
        self._budget = budget_bytes
        self._kept: OrderedDict[int, tuple[ref[object], T, int]] = OrderedDict()
        self._nbytes = 0
        # Filled from whatever thread lets go of an object last; things are closed only where they are made.
        self._gone: deque[tuple[int, ref[object]]] = deque()

    def made_of(self, source: object, make: Callable[[], T]) -> T:
        """Return what was made of ``source``, which is compared by identity; made now if it is not there."""
        key = id(source)
        known = self._kept.get(key)
        # The id of an object that is gone may have passed to another.
        if known is not None and known[0]() is source:
            self._kept.move_to_end(key)
            return known[1]
        self._forget_gone()
        made = make()
        gone = self._gone
        self._kept[key] = (ref(source, lambda mark: gone.append((key, mark))), made, made.nbytes)
        self._nbytes += made.nbytes
        self._forget_over_budget()
        return made

    def close(self) -> None:
        """Give the memory back."""
        while self._kept:
            self._forget(next(iter(self._kept)))
        self._gone.clear()

    def _forget_gone(self) -> None:
        while self._gone:
            key, mark = self._gone.popleft()
            kept = self._kept.get(key)
            if kept is not None and kept[0] is mark:
                self._forget(key)

    def _forget_over_budget(self) -> None:
        while self._nbytes > self._budget and len(self._kept) > 1:
            self._forget(next(iter(self._kept)))

    def _forget(self, key: int) -> None:
        _, made, nbytes = self._kept.pop(key)
        self._nbytes -= nbytes
        made.close()
