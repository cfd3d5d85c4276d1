"""The dock's content: the curve editor is made when it is first shown, for its graph library takes a while to load."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QMenu, QVBoxLayout, QWidget

from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.clipboard import Clipboard

if TYPE_CHECKING:
    from kagezou.ui.curves.curve_editor import CurveEditor


class CurvesPanel(QWidget):
    """Holds the editor once there is one.

    Parameters
    ----------
    bridge
        The session.
    clipboard
        Where copies go.
    fill_menu
        Fills the menu of what can be done to selected keys.
    """

    refused = Signal(str)

    def __init__(self, bridge: Bridge, clipboard: Clipboard, fill_menu: Callable[[QMenu], None]) -> None:
        super().__init__()
        self._bridge, self._clipboard, self._fill_menu = bridge, clipboard, fill_menu
        self.editor: CurveEditor | None = None
        self._author = ""
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)

    def come(self, seen: bool) -> None:
        """Take note whether the dock is at the front; docks behind others count as shown with Qt, but not as seen."""
        if seen:
            self.made()

    def sign(self, author: str) -> None:
        """Take the name that stands under notes from now on."""
        self._author = author
        if self.editor is not None:
            self.editor.notes.author = author

    def made(self) -> "CurveEditor":
        """Return the editor, made now if need be."""
        if self.editor is None:
            from kagezou.ui.curves.curve_editor import CurveEditor

            self.editor = CurveEditor(self._bridge, self._clipboard)
            self.editor.notes.author = self._author
            self._fill_menu(self.editor.key_menu)
            self.editor.refused.connect(self.refused)
            layout = self.layout()
            assert layout is not None
            layout.addWidget(self.editor)
        return self.editor

    def fit_chosen(self) -> None:
        """Show the selected keys, else everything."""
        self.made().graph.fit_chosen()

    def fit_all(self) -> None:
        """Show the whole cut and every curve."""
        self.made().graph.fit_all()

    def ask_velocity(self) -> None:
        """Ask for the exact speed and influence of the selected keys."""
        self.made().ask_velocity()
