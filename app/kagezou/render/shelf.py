"""Things on the graphics card kept within a budget of memory."""

from collections import OrderedDict
from collections.abc import Callable
from typing import Generic, Protocol, TypeVar


class Kept(Protocol):
    """What lies on a shelf."""

    @property
    def nbytes(self) -> int:
        """The memory it takes."""
        ...

    def close(self) -> None:
        """Give the memory back."""
        ...


T = TypeVar("T", bound=Kept)


class Shelf(Generic[T]):
    """The things last used, each made of one object in memory; the least recently used go first."""

    def __init__(self, budget_bytes: int) -> None:
        self._budget = budget_bytes
        self._kept: OrderedDict[int, tuple[object, T]] = OrderedDict()

    def made_of(self, source: object, make: Callable[[], T]) -> T:
        """Return what was made of ``source``, which is told by identity; made now if it is not there."""
        key = id(source)
        if key in self._kept:
            self._kept.move_to_end(key)
            return self._kept[key][1]
        made = make()
        # The source is kept beside what was made of it, so that its id cannot pass to another object.
        self._kept[key] = (source, made)
        self._forget_over_budget()
        return made

    def close(self) -> None:
        """Give the memory back."""
        for _, made in self._kept.values():
            made.close()
        self._kept.clear()

    def _forget_over_budget(self) -> None:
        total = sum(made.nbytes for _, made in self._kept.values())
        while total > self._budget and len(self._kept) > 1:
            _, (_, oldest) = self._kept.popitem(last=False)
            total -= oldest.nbytes
            oldest.close()
