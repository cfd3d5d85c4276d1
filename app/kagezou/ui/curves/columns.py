"""The list of curves, the graph, and what is listed of it, side by side: the graph gets all the room it can."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QSplitter, QWidget

_TREE_LETTERS, _LISTS_LETTERS = (17, 40), (24, 48)
_TREE_SHARE, _LISTS_SHARE = 0.14, 0.19
"""The list at the left and those at the right have these parts of the width, as far as they are between those numbers
of letters."""


class Columns(QSplitter):
    """Shares out its width itself until somebody has drawn a border of it.

    Parameters
    ----------
    tree, graph, lists
        From left to right.
    """

    def __init__(self, tree: QWidget, graph: QWidget, lists: QWidget) -> None:
        super().__init__(Qt.Orientation.Horizontal)
        for widget in (tree, graph, lists):
            self.addWidget(widget)
        self.setStretchFactor(1, 1)
        letter = self.fontMetrics().horizontalAdvance("0")
        tree.setMinimumWidth(_TREE_LETTERS[0] * letter)
        lists.setMinimumWidth(_LISTS_LETTERS[0] * letter)
        self._letter = letter
        self._is_drawn = False
        self.splitterMoved.connect(self._leave_alone)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if not self._is_drawn:
            self._share_out(event.size().width())

    def _share_out(self, width: int) -> None:
        tree = self._part_of(width, _TREE_SHARE, _TREE_LETTERS)
        lists = self._part_of(width, _LISTS_SHARE, _LISTS_LETTERS)
        self.setSizes([tree, max(width - tree - lists, 1), lists])

    def _part_of(self, width: int, share: float, letters: tuple[int, int]) -> int:
        least, most = (each * self._letter for each in letters)
        return min(max(round(width * share), least), most)

    def _leave_alone(self) -> None:
        self._is_drawn = True
