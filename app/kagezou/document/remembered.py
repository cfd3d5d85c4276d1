"""What was worked out of frozen values, kept as long as the very same values are asked about."""

import threading
from collections import OrderedDict
from collections.abc import Callable
from typing import Generic, TypeVar

T = TypeVar("T")


class Remembered(Generic[T]):
    """Results by the identity of what they were made of; the least lately used goes first. Any thread may ask.

    Comparing large frozen values would cost more than most of what is made of them; an edit keeps what it does not
    change, so that identity tells nearly always.

    Parameters
    ----------
    most
        How many results are kept.
    """

    def __init__(self, most: int) -> None:
        self._most = most
        self._kept: OrderedDict[tuple[int, ...], tuple[tuple[object, ...], T]] = OrderedDict()
        self._lock = threading.Lock()

    def forget(self) -> None:
        """Keep nothing of before, as when another document is worked on."""
        with self._lock:
            self._kept.clear()

    def of(self, parts: tuple[object, ...], make: Callable[[], T]) -> T:
        """Return what ``make`` made of these very ``parts``, or what it makes now."""
        key = tuple(map(id, parts))
        with self._lock:
            known = self._kept.get(key)
            if known is not None:
                self._kept.move_to_end(key)
                return known[1]
        made = make()
        with self._lock:
            # The parts are kept too: while they live nothing else can have their ids.
            self._kept[key] = (parts, made)
            while len(self._kept) > self._most:
                self._kept.popitem(last=False)
        return made
