"""The menu of a handle: key, reset, type and copy what it edits, beside the handle."""

from collections.abc import Callable, Sequence
from functools import partial

from PySide6.QtCore import QCoreApplication, QPoint, Qt
from PySide6.QtWidgets import QMenu, QWidget

from kagezou.document.address import Address
from kagezou.ui.panels.edited_property import EditedProperty
from kagezou.ui.panels.row_menu import PropertyMenus
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.words import translated

translate = QCoreApplication.translate


class HandleMenu:
    """Opens the menus of handles, which are those of their properties' rows.

    Parameters
    ----------
    bridge
        The session.
    menus
        What fills the menu of a property.
    type_values
        Lets the values of a property be typed.
    """

    def __init__(self, bridge: Bridge, menus: PropertyMenus, type_values: Callable[[Address], None]) -> None:
        self._bridge, self._menus, self._type = bridge, menus, type_values

    def open(self, name: str, addresses: Sequence[Address], over: QWidget, at: QPoint) -> QMenu:
        """Open what can be done with the properties of a handle.

        Parameters
        ----------
        name
            What the handle is called.
        addresses
            What it edits.
        over
            The widget that was asked.
        at
            A place on the screen.
        """
        menu = QMenu(over)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        # Not a section: styles differ in whether they show its words.
        menu.addAction(name).setEnabled(False)
        menu.addSeparator()
        edited = [EditedProperty(self._bridge, address) for address in addresses]
        for each in edited:
            part = menu if len(edited) == 1 else menu.addMenu(translated(each.address.property.label))
            part.addAction(translate("HandleMenu", "Type Values…"), partial(self._type, each.address))
            self._menus.fill(each, edited, part)
        menu.popup(at)
        return menu
