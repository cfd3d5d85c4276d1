"""Who tells whom about the handle that the hand chose: its rows are shown, and commands and a menu are about it."""

from PySide6.QtCore import QPoint

from kagezou.document.address import Address
from kagezou.tools.handle import Handle
from kagezou.ui.panels.handle_menu import HandleMenu
from kagezou.ui.system.words import translated
from kagezou.ui.widgets.scrub_field import ScrubField
from kagezou.ui.window.panel_layout import PanelLayout
from kagezou.ui.window.parts import Parts


def connect_handles(parts: Parts, layout: PanelLayout) -> None:
    """Connect the chosen handle with the inspector, with the commands on keys, and with its menu."""
    hand, bridge, inspector = parts.viewport.controller, parts.bridge, parts.panels.inspector

    def follow() -> None:
        handle = hand.handles.find(hand.selected_id)
        addresses = () if handle is None else handle.addresses
        bridge.session.select_properties(addresses)
        inspector.reveal(addresses)

    def type_values(address: Address) -> None:
        layout.show("inspector")
        inspector.reveal((address,))
        field = inspector.row(address.property.name).editor.findChild(ScrubField)
        if isinstance(field, ScrubField):
            field.setFocus()
            field.begin_typing()

    menu = HandleMenu(bridge, inspector.menus, type_values)

    def ask(handle: Handle, at: QPoint) -> None:
        menu.open(translated(handle.label), handle.addresses, parts.viewport, at)

    hand.chosen.connect(follow)
    parts.viewport.handle_menu_asked.connect(ask)
