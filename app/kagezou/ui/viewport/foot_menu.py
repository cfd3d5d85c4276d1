"""What can be said about a foot, beside the foot."""

from functools import partial

from PySide6.QtCore import QCoreApplication, QPoint, Qt
from PySide6.QtWidgets import QMenu, QWidget

from kagezou.standing.foot import Verdict
from kagezou.tools.feet import ShownFoot
from kagezou.ui.viewport.contacts import Contacts

translate = QCoreApplication.translate


def foot_menu(contacts: Contacts, foot: ShownFoot, parent: QWidget) -> QMenu:
    """Return the menu of a foot on the drawing that is shown."""
    menu = QMenu(parent)
    menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    said = None if foot.pin is None else foot.pin.verdict
    for verdict, words in (
        (Verdict.PLANTED, translate("FootMenu", "Planted")),
        (Verdict.LIFTED, translate("FootMenu", "Lifted")),
        (Verdict.NONE, translate("FootMenu", "No Foot")),
    ):
        action = menu.addAction(words, partial(contacts.judge, foot, verdict))
        action.setCheckable(True)
        action.setChecked(said is verdict)
    menu.addSeparator()
    menu.addAction(translate("FootMenu", "Pin as It Is"), partial(contacts.pin, foot))
    unpin = menu.addAction(translate("FootMenu", "As Found (Unpin)"), lambda: contacts.unpin(foot))
    unpin.setEnabled(foot.pin is not None)
    return menu


def open_foot_menu(contacts: Contacts, foot: ShownFoot, at: QPoint, parent: QWidget) -> QMenu:
    """Show the menu of a foot at a place of the screen."""
    menu = foot_menu(contacts, foot, parent)
    menu.popup(at)
    return menu
