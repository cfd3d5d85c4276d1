"""The menu of a property in the inspector: its value, its section's values, its keys, its link and its name."""

from collections.abc import Sequence
from dataclasses import replace
from types import MappingProxyType

from PySide6.QtCore import QCoreApplication, QPoint, Qt
from PySide6.QtWidgets import QMenu, QWidget

from kagezou.document.common_edits import set_all
from kagezou.document.properties import OF_DOCUMENT, OF_LAYER, OF_PIECE
from kagezou.document.property import Scope
from kagezou.io.clips.value_clips import dumps_value, dumps_values, loads_value, loads_values
from kagezou.ui.panels.edited_property import EditedProperty
from kagezou.ui.system.clipboard import Clipboard

translate = QCoreApplication.translate
_TABLES = MappingProxyType({Scope.DOCUMENT: OF_DOCUMENT, Scope.LAYER: OF_LAYER, Scope.PIECE: OF_PIECE})


class PropertyMenus:
    """Opens the menus of properties and of their sections.

    Parameters
    ----------
    clipboard
        Where values and names are copied to and pasted from.
    """

    def __init__(self, clipboard: Clipboard) -> None:
        self._clipboard = clipboard

    def open(self, edited: EditedProperty, mates: Sequence[EditedProperty], over: QWidget, at: QPoint) -> None:
        """Open what can be done with a property.

        Parameters
        ----------
        edited, mates
            The property, and all of its section.
        over
            The widget that was asked.
        at
            A place on the screen.
        """
        menu = QMenu(over)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.fill(edited, mates, menu)
        menu.popup(at)

    def fill(self, edited: EditedProperty, mates: Sequence[EditedProperty], menu: QMenu) -> None:
        """Fill a menu with what can be done with a property, and with all of its section."""
        menu.addAction(translate("RowMenu", "Copy Value"), lambda: self._clipboard.put(dumps_value(edited.value)))
        self._add_paste(menu, edited)
        menu.addAction(translate("RowMenu", "Copy All of This Section"), lambda: self._copy(mates))
        menu.addSeparator()
        menu.addAction(translate("RowMenu", "Reset to Default"), edited.reset)
        menu.addAction(
            translate("RowMenu", "Remove Key") if edited.is_keyed_here else translate("RowMenu", "Set Key"),
            edited.toggle_key,
        )
        menu.addAction(translate("RowMenu", "Remove All Keys"), edited.remove_all_keys).setEnabled(
            any(track.is_keyed for track in edited.tracks)
        )
        if edited.can_be_linked:
            words = (
                translate("RowMenu", "Give Each Character Its Own")
                if edited.is_linked
                else translate("RowMenu", "Make the Same for All Characters")
            )
            menu.addAction(words, edited.toggle_link)
        menu.addSeparator()
        menu.addAction(translate("RowMenu", "Copy Name for Scripts"), lambda: self._clipboard.put(edited.path))

    def fill_section(self, section: Sequence[EditedProperty], menu: QMenu) -> None:
        """Fill the menu of a section's heading."""
        menu.addAction(translate("RowMenu", "Copy All of This Section"), lambda: self._copy(section))
        self._add_paste(menu, section[0], alone=False)
        menu.addSeparator()
        menu.addAction(translate("RowMenu", "Reset All of This Section"), lambda: _reset(section))

    def _copy(self, section: Sequence[EditedProperty]) -> None:
        """Put the values of properties, as they are at the frame looked at, on the clipboard as text."""
        self._clipboard.put(dumps_values({each.address.property.name: each.value for each in section}))

    def _add_paste(self, menu: QMenu, edited: EditedProperty, *, alone: bool = True) -> None:
        """Add what pastes the clipboard's values: those it has by name, or with ``alone`` the one it has for it."""
        text = self._clipboard.text()
        line, session = edited.address.property, edited.bridge.session
        values = dict(loads_values(text, _TABLES[line.scope]))
        single = loads_value(text, line) if alone and not values else None
        if single is not None:
            values = {line.name: single}
        words = (
            translate("RowMenu", "Paste Value")
            if single is not None or len(values) < 2
            else translate("RowMenu", "Paste %1 Values")
        )
        action = menu.addAction(words.replace("%1", str(len(values))))
        action.setEnabled(bool(values))

        def paste() -> None:
            document = edited.bridge.document
            for name, value in values.items():
                addresses = [replace(each, property=_TABLES[line.scope][name]) for each in edited.addresses]
                document = set_all(document, addresses, value, edited.bridge.frame)
            session.edit(translate("RowMenu", "Paste values"), document)

        action.triggered.connect(paste)


def _reset(section: Sequence[EditedProperty]) -> None:
    """Bring every property of a section back to its default, as one step."""
    with section[0].bridge.session.gesture(translate("RowMenu", "Reset section")):
        for each in section:
            each.reset()
