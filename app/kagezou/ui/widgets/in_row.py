"""Widgets side by side, for a field of a form that has several."""

from typing import Final

from PySide6.QtWidgets import QHBoxLayout, QWidget

GAP_PX: Final = 8


def in_row(*parts: QWidget | None) -> QWidget:
    """Return widgets in a row without margins; None is room."""
    holder = QWidget()
    row = QHBoxLayout(holder)
    row.setContentsMargins(0, 0, 0, 0)
    row.setSpacing(GAP_PX)
    for part in parts:
        if part is None:
            row.addStretch(1)
        else:
            row.addWidget(part)
    return holder
