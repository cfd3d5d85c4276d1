"""Who tells whom about the manual: which page explains what, and when it opens."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

from PySide6.QtCore import QObject
from PySide6.QtGui import QCursor, QGuiApplication, QShortcut
from PySide6.QtWidgets import QApplication, QDialog, QMainWindow, QWidget

from kagezou.document.properties import TABLE
from kagezou.document.property import AnyProperty
from kagezou.ui.commands.shortcut_editor import ShortcutEditor
from kagezou.ui.commands.shortcut_sheet import ShortcutSheet
from kagezou.ui.curves.panel import CurvesPanel
from kagezou.ui.curves.review_bar import ReviewBar
from kagezou.ui.help.first_cut_bar import FirstCutBar
from kagezou.ui.help.manual import Manual
from kagezou.ui.help.pages import FIRST
from kagezou.ui.panels.groups import Group, group_of
from kagezou.ui.panels.inspector import Inspector
from kagezou.ui.panels.layer_list import LayerList
from kagezou.ui.panels.section import Section
from kagezou.ui.panels.style_list import StyleList
from kagezou.ui.project.cut_settings_dialog import CutSettingsDialog
from kagezou.ui.project.found_dialog import FoundDialog
from kagezou.ui.project.retake_result import RetakeResult
from kagezou.ui.project.welcome import Welcome
from kagezou.ui.sets.import_bar import SetBar
from kagezou.ui.sets.list import SetList
from kagezou.ui.system.manual_page import PAGE
from kagezou.ui.system.words import translated
from kagezou.ui.time.transport import Transport
from kagezou.ui.timeline.timeline import Timeline
from kagezou.ui.viewport.viewport import Viewport
from kagezou.ui.widgets.missing_parts import MissingParts
from kagezou.ui.window.parts import Parts
from kagezou.ui.window.preferences_dialog import PreferencesDialog

Place = tuple[str, str]
"""A page of the manual, and the term on it; "" for its beginning."""

_WIDGETS: Final[Mapping[type[QWidget], str]] = MappingProxyType(
    {
        Welcome: "first-cut",
        FirstCutBar: "first-cut",
        FoundDialog: "drawings",
        RetakeResult: "drawings",
        LayerList: "layers",
        SetList: "sets",
        SetBar: "sets",
        StyleList: "styles",
        Inspector: "light",
        Viewport: "words",
        Transport: "timeline",
        Timeline: "timeline",
        CurvesPanel: "curves",
        ReviewBar: "curves",
        CutSettingsDialog: "saving",
        PreferencesDialog: "saving",
        MissingParts: "trouble",
        ShortcutSheet: "keyboard",
        ShortcutEditor: "keyboard",
    }
)

_GROUPS: Final[Mapping[Group, str]] = MappingProxyType(
    {
        Group.LIGHT: "light",
        Group.GROUND: "ground",
        Group.CAMERA: "ground",
        Group.PIECE_PLACE: "sets",
        Group.PIECE_DOES: "sets",
        Group.SET_SHADOW: "sets",
        Group.CHARACTER: "standing",
        Group.JUMP: "standing",
        Group.SHADOW: "shadow",
        Group.CONTACT: "shadow",
        Group.SHAPE: "shape",
        Group.FADING: "shape",
        Group.WAVES: "water",
        Group.REFLECTION: "water",
        Group.PLACEMENT: "layers",
        Group.BACKGROUND: "layers",
    }
)


def sections() -> Mapping[str, tuple[AnyProperty, ...]]:
    """Return the properties of each section of the inspector, by the section's name in the manual."""
    names = {group: group.name.lower().replace("_", "-") for group in Group}
    found: dict[str, list[AnyProperty]] = {name: [] for name in names.values()}
    for prop in TABLE:
        found[names[group_of(prop)]].append(prop)
    return {name: tuple(props) for name, props in found.items()}


def place_of_property(prop: AnyProperty) -> Place:
    """Return where a property is explained."""
    return _GROUPS[group_of(prop)], translated(prop.label)


class Help(QObject):
    """Opens the manual where it explains what the pointer is over.

    Parameters
    ----------
    window
        The main window.
    parts
        What it is made of.
    """

    def __init__(self, window: QWidget, parts: Parts) -> None:
        super().__init__(window)
        self._window = window
        self._parts = parts
        self.manual: Manual | None = None

    def open(self) -> None:
        """Open the manual at what is under the pointer."""
        self.open_at(self.place_of(QApplication.widgetAt(QCursor.pos())))

    def open_at(self, place: Place) -> None:
        """Open the manual at a place; over a dialog that holds the keyboard it belongs to that dialog."""
        owner = QApplication.activeModalWidget() or self._window
        if self.manual is None or self.manual.parentWidget() is not owner:
            if self.manual is not None:
                self.manual.deleteLater()
            made = self.manual = Manual(sections(), owner)
            made.destroyed.connect(lambda: self._forget(made))
        self.manual.open(*place)

    def place_of(self, widget: QWidget | None) -> Place:
        """Return where the manual explains a widget; its contents where it does not."""
        if isinstance(widget, QWidget) and self._parts.viewport.isAncestorOf(widget):
            hand = self._parts.viewport.controller
            handle = hand.handles.find(hand.hovered_id)
            if handle is not None and handle.addresses:
                return place_of_property(handle.addresses[0].property)
        while widget is not None:
            prop = self._property_of(widget)
            if prop is not None:
                return place_of_property(prop)
            if isinstance(widget, Section):
                return _GROUPS[widget.group], ""
            page = widget.property(PAGE) or next((p for kind, p in _WIDGETS.items() if isinstance(widget, kind)), None)
            if page is not None:
                return page, ""
            widget = widget.parentWidget()
        return FIRST, ""

    def follow_window(self) -> None:
        """Let the dialog that came up open the manual by the same key: the window's own commands are out of reach."""
        dialog = QApplication.activeWindow()
        if not isinstance(dialog, QDialog) or dialog.property("explained") or not self._owns(dialog):
            return
        dialog.setProperty("explained", True)
        for keys in self._parts.actions["manual"].shortcuts():
            QShortcut(keys, dialog).activated.connect(self.open)

    def _owns(self, dialog: QWidget) -> bool:
        """Return whether a dialog belongs to the window; another window may be about to go, or to come."""
        owner = dialog.parentWidget()
        while owner is not None and owner is not self._window:
            owner = owner.parentWidget()
        return owner is not None

    def _property_of(self, widget: QWidget) -> AnyProperty | None:
        rows = self._parts.panels.inspector.rows
        return next((row.address.property for row in rows if widget in row.widgets), None)

    def _forget(self, gone: Manual) -> None:
        if self.manual is gone:
            self.manual = None


def connect_help(window: QMainWindow, parts: Parts) -> Help:
    """Connect the manual with its key, and with the dialogs that come up."""
    manual = Help(window, parts)
    parts.actions.on("manual", manual.open)
    application = QGuiApplication.instance()
    if isinstance(application, QGuiApplication):
        # A receiver that is an object of ours: the connection goes with the window.
        application.focusWindowChanged.connect(manual.follow_window)
    return manual
