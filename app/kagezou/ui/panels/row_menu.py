"""The menu of a property in the inspector: its value, its section's values, its keys, its link and its name."""

from collections.abc import Iterable
from dataclasses import replace
from types import MappingProxyType
from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication, QPoint, Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QMenu

from kagezou.document.address import track_of
from kagezou.document.common_edits import is_keyed_here, set_all
from kagezou.document.properties import OF_DOCUMENT, OF_LAYER, OF_PIECE
from kagezou.document.property import Scope
from kagezou.io.clips.value_clips import dumps_value, dumps_values, loads_value, loads_values

if TYPE_CHECKING:
    from kagezou.ui.panels.property_row import PropertyRow

translate = QCoreApplication.translate
_TABLES = MappingProxyType({Scope.DOCUMENT: OF_DOCUMENT, Scope.LAYER: OF_LAYER, Scope.PIECE: OF_PIECE})


def open_row_menu(row: "PropertyRow", at: QPoint) -> None:
    """Open what can be done with a property, at a place on the screen."""
    menu = QMenu(row.label)
    menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    fill_row_menu(row, menu)
    menu.popup(at)


def fill_row_menu(row: "PropertyRow", menu: QMenu) -> None:
    """Fill a menu with what can be done with a property."""
    tracks = [track_of(row.bridge.document, address) for address in row.addresses]
    here = is_keyed_here(row.bridge.document, row.addresses, row.bridge.frame)
    menu.addAction(translate("RowMenu", "Copy Value"), lambda: _put(dumps_value(row.value)))
    add_paste(menu, row)
    menu.addAction(translate("RowMenu", "Copy All of This Section"), lambda: copy_section(row.mates))
    menu.addSeparator()
    menu.addAction(translate("RowMenu", "Reset to Default"), row.reset)
    menu.addAction(translate("RowMenu", "Remove Key") if here else translate("RowMenu", "Set Key"), row.toggle_key)
    menu.addAction(translate("RowMenu", "Remove All Keys"), row.remove_all_keys).setEnabled(
        any(track.is_keyed for track in tracks)
    )
    if row.can_be_linked:
        words = (
            translate("RowMenu", "Give Each Character Its Own")
            if row.link.is_linked
            else translate("RowMenu", "Make the Same for All Characters")
        )
        menu.addAction(words, row.toggle_link)
    menu.addSeparator()
    menu.addAction(translate("RowMenu", "Copy Name for Scripts"), lambda: _put(row.path))


def fill_section_menu(rows: "list[PropertyRow]", menu: QMenu) -> None:
    """Fill the menu of a section's heading."""
    menu.addAction(translate("RowMenu", "Copy All of This Section"), lambda: copy_section(rows))
    add_paste(menu, rows[0], alone=False)
    menu.addSeparator()
    menu.addAction(translate("RowMenu", "Reset All of This Section"), lambda: reset_section(rows))


def copy_section(rows: "Iterable[PropertyRow]") -> None:
    """Put the values of rows, as they are at the frame looked at, on the clipboard as text."""
    _put(dumps_values({row.address.property.name: row.value for row in rows}))


def reset_section(rows: "list[PropertyRow]") -> None:
    """Bring every property of rows back to its default, as one step."""
    with rows[0].bridge.session.gesture(translate("RowMenu", "Reset section")):
        for row in rows:
            row.reset()


def add_paste(menu: QMenu, row: "PropertyRow", *, alone: bool = True) -> None:
    """Add what pastes the clipboard's values: those it has by name, or with ``alone`` the one it has for this row."""
    text = QGuiApplication.clipboard().text()
    line, session = row.address.property, row.bridge.session
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
        document = row.bridge.document
        for name, value in values.items():
            addresses = [replace(each, property=_TABLES[line.scope][name]) for each in row.addresses]
            document = set_all(document, addresses, value, row.bridge.frame)
        session.edit(translate("RowMenu", "Paste values"), document)

    action.triggered.connect(paste)


def _put(text: str) -> None:
    QGuiApplication.clipboard().setText(text)
