"""One line of the inspector: key diamond, name, editor, link; it edits one property of all layers that are chosen."""

from collections.abc import Callable, Sequence
from functools import partial

from PySide6.QtCore import QObject, QPoint, Qt
from PySide6.QtWidgets import QWidget

from kagezou.animation.track import Value
from kagezou.errors import Problem
from kagezou.io.clips.value_clips import dumps_value
from kagezou.ui.panels.edited_property import EditedProperty
from kagezou.ui.panels.editors import Editor, editor_for
from kagezou.ui.panels.filter_pictures import tip_of
from kagezou.ui.panels.row_menu import PropertyMenus
from kagezou.ui.system.words import translated
from kagezou.ui.widgets.key_button import KeyButton, KeyState
from kagezou.ui.widgets.link_button import LinkButton
from kagezou.ui.widgets.scrub_field import ScrubLabel


class PropertyRow(QObject):
    """The widgets of one property; a drag is one step of history.

    Parameters
    ----------
    edited
        What the widgets show and change.
    mates
        The properties of its section.
    menus
        What opens its menu.
    """

    def __init__(self, edited: EditedProperty, mates: Sequence[EditedProperty], menus: PropertyMenus) -> None:
        super().__init__()
        self.address = address = edited.address
        self._menus = menus
        self.edited = edited
        self._shown: tuple[object, ...] | None = None
        self._is_visible = True
        self.is_changed = False
        """Whether it was shown as set by someone or keyed."""
        self.mates = mates
        self.key = KeyButton()
        self.link = LinkButton()
        self.editor: Editor = editor_for(address.property)
        self.label = ScrubLabel(translated(address.property.label), self.editor.scrubbed_by_label)
        for widget in self.widgets:
            widget.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
            widget.customContextMenuRequested.connect(partial(self._open_menu, widget))
        self.label.reset_asked.connect(self.edited.reset)
        self.key.clicked.connect(self.edited.toggle_key)
        self.link.clicked.connect(self.edited.toggle_link)
        self.editor.began.connect(self.edited.begin)
        self.editor.tried.connect(self.edited.show)
        self.editor.ended.connect(self._end)
        self.editor.entered.connect(self.enter)
        self.editor.calculated.connect(self.calculate)

    @property
    def widgets(self) -> tuple[KeyButton, ScrubLabel, Editor]:
        """The columns that are edited."""
        return (self.key, self.label, self.editor)

    def refresh(self) -> None:
        """Show what the document has now; costs nothing where neither tracks nor frame changed."""
        edited = self.edited
        tracks, linked, frame = edited.tracks, edited.is_linked, edited.bridge.frame
        shown = (tracks, frame, linked, edited.can_be_linked, edited.path)
        if self._shown == shown:
            return
        self._shown = shown
        value = tracks[0].value_at(frame)
        if edited.is_mixed:
            self.editor.show_mixed(value)
        else:
            self.editor.show_value(value)
        keyed = any(track.is_keyed for track in tracks)
        self.key.show_state(KeyState.HERE if edited.is_keyed_here else KeyState.KEYED if keyed else KeyState.NONE)
        self.link.show_linked(linked=linked)
        self.link.setVisible(self._is_visible and edited.can_be_linked)
        self.is_changed = edited.is_changed
        self._show_changed(changed=self.is_changed)

    def set_visible(self, *, visible: bool) -> None:
        """Show or hide the whole line."""
        self._is_visible = visible
        for widget in self.widgets:
            widget.setVisible(visible)
        self.link.setVisible(visible and self.edited.can_be_linked)

    def show_chosen(self, *, chosen: bool) -> None:
        """Show whether the handle that the hand chose in the picture is about it."""
        if chosen != bool(self.label.property("chosen")):
            self.label.setProperty("chosen", chosen)
            self.label.style().unpolish(self.label)
            self.label.style().polish(self.label)
            # Which gave the label the palette of all labels.
            self.label.show_changed(changed=self.is_changed)

    def set_editable(self, *, editable: bool) -> None:
        """Allow editing, or only show."""
        for widget in self.widgets:
            widget.setEnabled(editable)

    def enter(self, raw: Value) -> None:
        """Set a value at the frame looked at, everywhere, as one step."""
        self._attempt(partial(self.edited.enter, raw))

    def calculate(self, text: str, factor: float = 1.0) -> None:
        """Change each layer's number by itself as a typed calculation says of it times a factor, as one step."""
        self._attempt(partial(self.edited.calculate, text, factor))

    def _attempt(self, do: Callable[[], None]) -> None:
        refused = ""
        try:
            do()
        except Problem as problem:
            refused = translated(problem)
        self._show_anew()
        if refused:
            self.label.setToolTip(refused)

    def _end(self, keep: bool) -> None:
        self.edited.end(keep=keep)
        self._show_anew()

    def _show_anew(self) -> None:
        self._shown = None
        self.refresh()

    def _show_changed(self, *, changed: bool) -> None:
        line, words = self.address.property, ""
        if changed:
            # The words say it too: colour alone does not reach everyone.
            words = self.tr("Changed; double-click for the default, %1").replace("%1", dumps_value(self.edited.usual))
        self.label.setToolTip(tip_of(line, self.edited.path, words))
        self.label.show_changed(changed=changed)

    def _open_menu(self, widget: QWidget, at: QPoint) -> None:
        self._menus.open(self.edited, self.mates, widget, widget.mapToGlobal(at))
