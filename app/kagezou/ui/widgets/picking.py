"""Picking places of the picture: while it is on, a click means a place and takes hold of nothing."""

from PySide6.QtCore import QObject, Signal

from kagezou.geometry.vectors import Point2


class Picking(QObject):
    """Whether places are picked now, and those that are marked over the picture."""

    picked = Signal(object)
    """A place, canvas px."""
    changed = Signal()
    stopped = Signal()
    """The hand gave it up, by Escape or the right button."""

    def __init__(self) -> None:
        super().__init__()
        self._is_on = False
        self._marks: tuple[Point2, ...] = ()

    @property
    def is_on(self) -> bool:
        """Whether a click means a place."""
        return self._is_on

    @property
    def marks(self) -> tuple[Point2, ...]:
        """What is marked, canvas px."""
        return self._marks

    def turn(self, *, on: bool) -> None:
        """Begin or end; nothing is marked then."""
        self._is_on = on
        self.mark(())

    def mark(self, places: tuple[Point2, ...]) -> None:
        """Mark places of the picture, joined by a line."""
        self._marks = places
        self.changed.emit()

    def give_up(self) -> bool:
        """End it for the hand; false where it is not on."""
        if not self._is_on:
            return False
        self.turn(on=False)
        self.stopped.emit()
        return True
