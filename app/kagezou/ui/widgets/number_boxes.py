"""Boxes for numbers that begin as far from their edge as other fields do."""

from typing import Final

from PySide6.QtWidgets import QAbstractSpinBox, QDoubleSpinBox, QSpinBox

_INSET_PX: Final = 5


class WholeNumberBox(QSpinBox):
    """A spin box of whole numbers."""

    def __init__(self) -> None:
        super().__init__()
        _inset(self)


class NumberBox(QDoubleSpinBox):
    """A spin box of numbers with decimals."""

    def __init__(self) -> None:
        super().__init__()
        _inset(self)


def _inset(box: QAbstractSpinBox) -> None:
    """Give the words the room that the theme reserves: a style sheet's padding makes a box wider, and its text not."""
    box.lineEdit().setTextMargins(_INSET_PX, 0, 0, 0)
