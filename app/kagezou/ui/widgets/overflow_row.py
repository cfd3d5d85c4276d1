"""A row of tools that never asks for more room than there is: those that find none go into a menu at its end."""

from collections.abc import Callable

from PySide6.QtCore import QEvent, QSize, Qt
from PySide6.QtGui import QAction, QResizeEvent, QShowEvent
from PySide6.QtWidgets import QHBoxLayout, QMenu, QSizePolicy, QToolButton, QWidget

_GAP_PX = 4


class OverflowRow(QWidget):
    """Tools side by side; the menu button at the end shows only while some find no room.

    A tool is an action, so that its button and its line in the menu are one thing.

    Attributes
    ----------
    more
        The button of the menu.
    """

    def __init__(self) -> None:
        super().__init__()
        self._fixed: list[QWidget] = []
        self._tools: list[tuple[QAction, QToolButton]] = []
        self.more = QToolButton()
        self.more.setText("»")
        self.more.setToolTip(self.tr("More tools"))
        self.more.setAccessibleName(self.tr("More tools"))
        self.more.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.more.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.more.setMenu(QMenu(self.more))
        self._row = QHBoxLayout(self)
        self._row.setContentsMargins(_GAP_PX, 2, _GAP_PX, 2)
        self._row.setSpacing(_GAP_PX)
        self._row.addStretch(1)
        self._row.addWidget(self.more)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)

    @property
    def left_over(self) -> tuple[QAction, ...]:
        """The tools that are in the menu now."""
        return tuple(action for action, button in self._tools if button.isHidden())

    def add_fixed(self, widget: QWidget) -> None:
        """Put a widget before the tools; it is always seen."""
        self._row.insertWidget(len(self._fixed), widget)
        self._fixed.append(widget)

    def add_tool(self, words: str, tip: str, do: Callable[[], object]) -> QAction:
        """Add a tool that does something when it is clicked."""
        action = self._add(words, tip)
        action.triggered.connect(lambda _checked: do())
        return action

    def add_switch(self, words: str, tip: str, turn: Callable[[bool], object]) -> QAction:
        """Add a tool that is on or off."""
        action = self._add(words, tip)
        action.setCheckable(True)
        action.toggled.connect(turn)
        return action

    def minimumSizeHint(self) -> QSize:
        return QSize(self._width_of([*self._fixed, self.more]), self.sizeHint().height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._share_room()

    def event(self, event: QEvent) -> bool:
        # What a button needs may be known only once it has its style.
        if event.type() is QEvent.Type.LayoutRequest:
            self._share_room()
        return super().event(event)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        for widget in (*self._fixed, *(button for _, button in self._tools), self.more):
            # What the layout keeps of it is from before it had its style.
            widget.ensurePolished()
            widget.updateGeometry()
        self._share_room()

    def _add(self, words: str, tip: str) -> QAction:
        action = QAction(words, self)
        action.setToolTip(tip)
        button = QToolButton()
        button.setDefaultAction(action)
        button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self._row.insertWidget(len(self._fixed) + len(self._tools), button)
        self._tools.append((action, button))
        return action

    def _share_room(self) -> None:
        buttons = [button for _, button in self._tools]
        shown = len(buttons)
        if self._width_of([*self._fixed, *buttons]) > self.width():
            while shown and self._width_of([*self._fixed, *buttons[:shown], self.more]) > self.width():
                shown -= 1
        for number, button in enumerate(buttons):
            button.setHidden(number >= shown)
        self.more.setHidden(shown == len(buttons))
        menu = self.more.menu()
        menu.clear()
        menu.addActions(self.left_over)

    def _width_of(self, widgets: list[QWidget]) -> int:
        # Two edges, and the gap before the room that is left over.
        return 3 * _GAP_PX + sum(widget.sizeHint().width() + _GAP_PX for widget in widgets)
