"""Something to be loaded: what is read beside the window, and what is done in it with what was read."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Generic, TypeVar

from kagezou.importing.progress import Progress, no_progress

T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class Load(Generic[T]):
    """A load in its two halves.

    Parameters
    ----------
    what
        What is loaded, as the window calls it.
    read
        Everything slow, on another thread when its turn comes: it may look at the document there is then, which is
        frozen, and must not touch anything else.
    put
        What makes of it what is seen, on the window's own thread; quick, and either all or nothing.
    replaces
        Whether it puts another project in the place of the one there is.
    gives_way
        Whether it is given up as soon as something else is to be loaded.
    """

    what: str
    read: Callable[[Progress], T]
    put: Callable[[T], None]
    replaces: bool = False
    gives_way: bool = False

    def at_once(self) -> None:
        """Do both now, on the thread that asks."""
        self.put(self.read(no_progress))


AnyLoad = Load[Any]
