"""One line of the inspector: key diamond, name, editor; it edits one address of the session at hand."""

from PySide6.QtCore import QObject, QPoint, Qt
from PySide6.QtGui import QGuiApplication, QPalette
from PySide6.QtWidgets import QMenu

from kagezou.animation.track import Value
from kagezou.document.address import Address, path_of, track_of
from kagezou.document.edits import remove_key, set_constant, set_key, set_value
from kagezou.errors import Problem
from kagezou.session.session import Gesture
from kagezou.ui.bridge import Bridge
from kagezou.ui.panels.editors import Editor, editor_for
from kagezou.ui.panels.key_button import KeyButton, KeyState
from kagezou.ui.panels.scrub_field import ScrubLabel
from kagezou.ui.sentences import sentence_of
from kagezou.ui.theme import CHANGED, TEXT
from kagezou.ui.words import said


class PropertyRow(QObject):
    """The widgets of one property and what they do; a drag is one step of history.

    Parameters
    ----------
    bridge
        The session to edit.
    address
        What is edited.
    """

    def __init__(self, bridge: Bridge, address: Address) -> None:
        super().__init__()
        self.address = address
        self._bridge = bridge
        self._gesture: Gesture | None = None
        self._shown: tuple[object, int] | None = None
        self.key = KeyButton()
        self.editor: Editor = editor_for(address.property)
        self.label = ScrubLabel(said(address.property.label), self.editor.scrubbed_by_label)
        self.label.setToolTip(f"{said(address.property.help)}\n{self.path}")
        self.label.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self.label.customContextMenuRequested.connect(self._open_menu)
        self.label.reset_asked.connect(self.reset)
        self.key.clicked.connect(self.toggle_key)
        self.editor.began.connect(self._begin)
        self.editor.tried.connect(self._try)
        self.editor.ended.connect(self._end)
        self.editor.entered.connect(self.enter)

    @property
    def widgets(self) -> tuple[KeyButton, ScrubLabel, Editor]:
        """The three columns."""
        return (self.key, self.label, self.editor)

    @property
    def path(self) -> str:
        """The property's path, as scripts and the command line write it."""
        return path_of(self._bridge.document, self.address)

    def refresh(self) -> None:
        """Show what the document has now; costs nothing where neither track nor frame changed."""
        track, frame = track_of(self._bridge.document, self.address), self._bridge.frame
        if self._shown == (track, frame):
            return
        self._shown = (track, frame)
        self.editor.show_value(track.value_at(frame))
        here = track.key_at(frame) is not None
        self.key.show_state(KeyState.HERE if here else KeyState.KEYED if track.is_keyed else KeyState.NONE)
        self._color_label(changed=track.is_keyed or track.constant != self.address.property.default)

    def set_visible(self, *, visible: bool) -> None:
        """Show or hide the whole line."""
        for widget in self.widgets:
            widget.setVisible(visible)

    def set_editable(self, *, editable: bool) -> None:
        """Allow editing, or only show."""
        for widget in self.widgets:
            widget.setEnabled(editable)

    def enter(self, raw: Value) -> None:
        """Set a value at the frame looked at, as one step."""
        session, document = self._bridge.session, self._bridge.document
        try:
            session.edit(self._step_name, set_value(document, self.address, raw, self._bridge.frame))
        except Problem as problem:
            self.label.setToolTip(sentence_of(problem))
        self._shown = None
        self.refresh()

    def reset(self) -> None:
        """Go back to the default, without keys."""
        document = set_constant(self._bridge.document, self.address, self.address.property.default)
        self._bridge.session.edit(self.tr("Reset %1").replace("%1", said(self.address.property.label)), document)

    def toggle_key(self) -> None:
        """Set a key at the frame looked at, or take it away."""
        document, frame = self._bridge.document, self._bridge.frame
        track = track_of(document, self.address)
        name = said(self.address.property.label)
        if track.key_at(frame) is None:
            keyed = set_key(document, self.address, frame, track.value_at(frame))
            self._bridge.session.edit(self.tr("Key %1").replace("%1", name), keyed)
        else:
            unkeyed = remove_key(document, self.address, frame)
            self._bridge.session.edit(self.tr("Remove key of %1").replace("%1", name), unkeyed)

    def remove_all_keys(self) -> None:
        """Keep the value seen now for the whole cut."""
        track = track_of(self._bridge.document, self.address)
        still = set_constant(self._bridge.document, self.address, track.value_at(self._bridge.frame))
        self._bridge.session.edit(
            self.tr("Remove all keys of %1").replace("%1", said(self.address.property.label)), still
        )

    @property
    def _step_name(self) -> str:
        return self.tr("Change %1").replace("%1", said(self.address.property.label))

    def _begin(self) -> None:
        self._gesture = self._bridge.session.begin(self._step_name)

    def _try(self, raw: Value) -> None:
        if self._gesture is not None:
            document = self._bridge.document
            self._gesture.show(set_value(document, self.address, raw, self._bridge.frame))

    def _end(self, keep: bool) -> None:
        gesture, self._gesture = self._gesture, None
        if gesture is not None:
            gesture.commit() if keep else gesture.cancel()
        self._shown = None
        self.refresh()

    def _color_label(self, *, changed: bool) -> None:
        palette = self.label.palette()
        for group in (QPalette.ColorGroup.Active, QPalette.ColorGroup.Inactive):
            palette.setColor(group, QPalette.ColorRole.WindowText, CHANGED if changed else TEXT)
        self.label.setPalette(palette)

    def _open_menu(self, at: QPoint) -> None:
        track = track_of(self._bridge.document, self.address)
        here = track.key_at(self._bridge.frame) is not None
        menu = QMenu(self.label)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        menu.addAction(self.tr("Reset to default"), self.reset)
        menu.addAction(self.tr("Remove key") if here else self.tr("Set key"), self.toggle_key)
        menu.addAction(self.tr("Remove all keys"), self.remove_all_keys).setEnabled(track.is_keyed)
        menu.addSeparator()
        clipboard = QGuiApplication.clipboard()
        menu.addAction(self.tr("Copy name for scripts"), lambda: clipboard.setText(self.path))
        menu.popup(self.label.mapToGlobal(at))
