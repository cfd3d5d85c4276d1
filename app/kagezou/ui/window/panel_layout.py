"""The arrangement of the panels: put back as it was at first, and hidden for a moment to see only the picture."""

from collections.abc import Callable

from PySide6.QtCore import QByteArray, QObject, Qt
from PySide6.QtGui import QAction, QKeySequence, QShortcut
from PySide6.QtWidgets import QApplication, QDockWidget, QMainWindow, QWidget


class PanelLayout(QObject):
    """Made when the panels lie as they do at first, before a remembered arrangement is restored.

    Parameters
    ----------
    window
        The window of the panels.
    version
        As for the window's own ``saveState``.
    share_room
        Gives every panel its size; Qt does not remember the sizes of a window that was never shown.
    """

    def __init__(self, window: QMainWindow, version: int, share_room: Callable[[], None]) -> None:
        super().__init__(window)
        self._window = window
        self._version = version
        self._share_room = share_room
        self._first = window.saveState(version)
        self._before = self._first
        self._reasons: set[str] = set()
        self._before_filled: QByteArray | None = None

    def reset(self) -> None:
        """Put every panel back to where it was at first."""
        self._go_back()
        self._before = self._first
        if not self._reasons:
            self._window.restoreState(self._first, self._version)
            self._share_room()

    def show(self, name: str) -> None:
        """Bring a panel to the front and give it the keyboard."""
        dock = self._window.findChild(QDockWidget, name)
        if isinstance(dock, QDockWidget):
            dock.show()
            dock.raise_()
            dock.widget().setFocus(Qt.FocusReason.ShortcutFocusReason)

    def fill(self, widget: QWidget | None) -> None:
        """Let the panel with a widget, or the picture where it is in none, fill the window; what fills it goes back."""
        if self._before_filled is not None:
            self._go_back()
            return
        if self._reasons:
            return
        docks = self._window.findChildren(QDockWidget)
        chosen = next((dock for dock in docks if widget is not None and dock.isAncestorOf(widget)), None)
        self._before_filled = self._window.saveState(self._version)
        for dock in docks:
            dock.setVisible(dock is chosen)
        self._show_picture(shown=chosen is None)

    def _go_back(self) -> None:
        before, self._before_filled = self._before_filled, None
        self._show_picture(shown=True)
        if before is not None:
            self._window.restoreState(before, self._version)

    def _show_picture(self, *, shown: bool) -> None:
        middle = self._window.centralWidget()
        if middle is not None:
            middle.setVisible(shown)

    def hide(self, on: bool, reason: str = "asked") -> None:
        """Hide all panels for a reason, or let it go; without any reason those that were there come back."""
        self._go_back()
        hidden = bool(self._reasons)
        if on:
            self._reasons.add(reason)
        else:
            self._reasons.discard(reason)
        if self._reasons and not hidden:
            self._before = self._window.saveState(self._version)
            for dock in self._window.findChildren(QDockWidget):
                dock.hide()
        elif hidden and not self._reasons:
            self._bring_back()

    def bring_back(self) -> None:
        """Show the panels again whatever hid them."""
        self._go_back()
        if self._reasons:
            self._reasons.clear()
            self._bring_back()

    def _bring_back(self) -> None:
        self._window.restoreState(self._before, self._version)
        if self._before == self._first:
            self._share_room()


class TabKey(QObject):
    """The Tab key as a switch, as far as nothing else needs it.

    Handles and fields are reached by Tab too, so it switches only while none of them has the keyboard, and for as long
    as the switch is on: then the key that turned it on turns it off again.

    Parameters
    ----------
    window
        Where the key is pressed.
    switch
        What it turns on and off.
    is_free
        Whether the page shown has no use for the key itself.
    """

    def __init__(self, window: QWidget, switch: QAction, is_free: Callable[[], bool]) -> None:
        super().__init__(window)
        self._window = window
        self._switch = switch
        self._is_free = is_free
        self.key = QShortcut(QKeySequence(Qt.Key.Key_Tab), window, switch.toggle)
        application = QApplication.instance()
        if isinstance(application, QApplication):
            application.focusChanged.connect(self._follow)
        switch.toggled.connect(lambda _: self._follow(None, QApplication.focusWidget()))
        self._follow(None, QApplication.focusWidget())

    def _follow(self, _before: QWidget | None, focused: QWidget | None) -> None:
        types = focused is not None and focused.testAttribute(Qt.WidgetAttribute.WA_InputMethodEnabled)
        nobody = focused in (None, self._window)
        self.key.setEnabled(self._is_free() and not types and (nobody or self._switch.isChecked()))
