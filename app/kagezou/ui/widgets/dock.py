"""A dock whose title bar is drawn by Qt, so that a pen can drag it back where the system's own bars ignore pens."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDockWidget, QHBoxLayout, QLabel, QWidget

from kagezou.ui.widgets.tool_button import tool_button


class Dock(QDockWidget):
    """A panel at the window's side.

    Parameters
    ----------
    name
        Its name for the saved layout.
    title
        What people read.
    content
        The panel.
    """

    def __init__(self, name: str, title: str, content: QWidget) -> None:
        super().__init__(title)
        self.setObjectName(name)
        self.setWidget(content)
        self.setTitleBarWidget(self._title_bar(title))

    def _title_bar(self, title: str) -> QWidget:
        bar = QWidget()
        bar.setObjectName("dock_title")
        bar.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        row = QHBoxLayout(bar)
        row.setContentsMargins(0, 0, 3, 0)
        row.setSpacing(0)
        row.addWidget(QLabel(title), 1)
        row.addWidget(tool_button("float", self.tr("Float or dock"), self._float_or_dock, small=True))
        row.addWidget(tool_button("close", self.tr("Close"), self.close, small=True))
        return bar

    def _float_or_dock(self) -> None:
        self.setFloating(not self.isFloating())
