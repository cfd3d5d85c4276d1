"""The small buttons at the edges of panels."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QToolButton

from kagezou.ui.system.icons import icon, icon_size


def tool_button(name: str, words: str, do: object, *, small: bool = False) -> QToolButton:
    """Return a button of one icon for the edge of a panel; ``do`` is what a click does, ``words`` its tool tip."""
    button = QToolButton()
    button.setIcon(icon(name))
    button.setIconSize(icon_size(button.fontMetrics(), small=small))
    button.setToolTip(words)
    button.setAccessibleName(words)
    button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
    button.clicked.connect(do)
    return button
