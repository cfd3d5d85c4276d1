"""One line of the inspector: key diamond, name, editor, link; it edits one property of all layers that are chosen."""

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QObject, QPoint, Qt
from PySide6.QtWidgets import QWidget

from kagezou.animation.track import Value
from kagezou.document.address import Address, path_of, track_of, value_of
from kagezou.document.common_edits import (
    change_all,
    is_keyed_here,
    is_mixed,
    reset_all,
    set_all,
    still_all,
    toggle_keys,
)
from kagezou.document.linking import LINKABLE, is_linked, link, unlink
from kagezou.document.model import Document
from kagezou.document.typed_number import evaluate
from kagezou.errors import Problem
from kagezou.io.clips.value_clips import dumps_value
from kagezou.session.session import Gesture
from kagezou.ui.panels.editors import Editor, editor_for
from kagezou.ui.panels.row_menu import open_row_menu
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.words import translated
from kagezou.ui.widgets.key_button import KeyButton, KeyState
from kagezou.ui.widgets.link_button import LinkButton
from kagezou.ui.widgets.scrub_field import ScrubLabel


class PropertyRow(QObject):
    """The widgets of one property and what they do; a drag is one step of history.

    Parameters
    ----------
    bridge
        The session to edit.
    address
        What is edited.
    others
        The same property of the other layers that are chosen.

    Attributes
    ----------
    mates
        The rows of its section.
    """

    def __init__(self, bridge: Bridge, address: Address, others: tuple[Address, ...] = ()) -> None:
        super().__init__()
        self.address = address
        self.addresses = (address, *others)
        self.bridge = bridge
        self._gesture: Gesture | None = None
        self._shown: tuple[object, ...] | None = None
        self._is_visible = True
        self.mates: list[PropertyRow] = [self]
        self.key = KeyButton()
        self.link = LinkButton()
        self.editor: Editor = editor_for(address.property)
        self.label = ScrubLabel(translated(address.property.label), self.editor.scrubbed_by_label)
        for widget in self.widgets:
            widget.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
            widget.customContextMenuRequested.connect(partial(self._open_menu, widget))
        self.label.reset_asked.connect(self.reset)
        self.key.clicked.connect(self.toggle_key)
        self.link.clicked.connect(self.toggle_link)
        self.editor.began.connect(self._begin)
        self.editor.tried.connect(self._try)
        self.editor.ended.connect(self._end)
        self.editor.entered.connect(self.enter)
        self.editor.calculated.connect(self.calculate)

    @property
    def widgets(self) -> tuple[KeyButton, ScrubLabel, Editor]:
        """The columns that are edited."""
        return (self.key, self.label, self.editor)

    @property
    def path(self) -> str:
        """The property's path, as scripts and the command line write it."""
        return path_of(self.bridge.document, self.address)

    @property
    def value(self) -> Value:
        """What is seen at the frame looked at, of the layer worked on."""
        return value_of(self.bridge.document, self.address, self.bridge.frame)

    @property
    def can_be_linked(self) -> bool:
        """Whether there are characters it could be the same for; a link that is there can always be taken away."""
        if self.address.layer_id is None or self.address.property.name not in LINKABLE:
            return False
        return len(self.bridge.document.layers) > 1 or is_linked(self.bridge.document, self.address)

    def refresh(self) -> None:
        """Show what the document has now; costs nothing where neither tracks nor frame changed."""
        document, frame = self.bridge.document, self.bridge.frame
        tracks = tuple(track_of(document, address) for address in self.addresses)
        linked = is_linked(document, self.address)
        shown = (tracks, frame, linked, self.can_be_linked, self.path)
        if self._shown == shown:
            return
        self._shown = shown
        value = tracks[0].value_at(frame)
        if is_mixed(document, self.addresses, frame):
            self.editor.show_mixed(value)
        else:
            self.editor.show_value(value)
        here, keyed = is_keyed_here(document, self.addresses, frame), any(track.is_keyed for track in tracks)
        self.key.show_state(KeyState.HERE if here else KeyState.KEYED if keyed else KeyState.NONE)
        self.link.show_linked(linked=linked)
        self.link.setVisible(self._is_visible and self.can_be_linked)
        default = self.address.property.default
        self._show_changed(changed=keyed or any(track.constant != default for track in tracks))

    def set_visible(self, *, visible: bool) -> None:
        """Show or hide the whole line."""
        self._is_visible = visible
        for widget in self.widgets:
            widget.setVisible(visible)
        self.link.setVisible(visible and self.can_be_linked)

    def set_editable(self, *, editable: bool) -> None:
        """Allow editing, or only show."""
        for widget in self.widgets:
            widget.setEnabled(editable)

    def enter(self, raw: Value) -> None:
        """Set a value at the frame looked at, everywhere, as one step."""
        self._attempt(lambda document: set_all(document, self.addresses, raw, self.bridge.frame))

    def calculate(self, text: str) -> None:
        """Change each layer's number by itself as a typed calculation says, as one step."""
        self._attempt(
            lambda document: change_all(
                document, self.addresses, lambda value: evaluate(text, value), self.bridge.frame
            )
        )

    def reset(self) -> None:
        """Go back to the default, without keys."""
        self._edit(self.tr("Reset %1"), reset_all(self.bridge.document, self.addresses))

    def toggle_key(self) -> None:
        """Set a key at the frame looked at, or take it away."""
        document, frame = self.bridge.document, self.bridge.frame
        removes = is_keyed_here(document, self.addresses, frame)
        words = self.tr("Remove key of %1") if removes else self.tr("Key %1")
        self._edit(words, toggle_keys(document, self.addresses, frame))

    def remove_all_keys(self) -> None:
        """Keep the value seen now for the whole cut."""
        still = still_all(self.bridge.document, self.addresses, self.bridge.frame)
        self._edit(self.tr("Remove all keys of %1"), still)

    def toggle_link(self) -> None:
        """Make the property the same for all characters as it is here, or each character's own again."""
        document = self.bridge.document
        if is_linked(document, self.address):
            self._edit(self.tr("Unlink %1"), unlink(document, self.address.property.name))
        else:
            self._edit(self.tr("Link %1"), link(document, self.address))

    @property
    def _step_name(self) -> str:
        return self._named(self.tr("Change %1"))

    def _named(self, words: str) -> str:
        return words.replace("%1", translated(self.address.property.label))

    def _edit(self, words: str, document: Document) -> None:
        self.bridge.session.edit(self._named(words), document)

    def _attempt(self, make: Callable[[Document], Document]) -> None:
        refused = ""
        try:
            self.bridge.session.edit(self._step_name, make(self.bridge.document))
        except Problem as problem:
            refused = translated(problem)
        self._shown = None
        self.refresh()
        if refused:
            self.label.setToolTip(refused)

    def _begin(self) -> None:
        self._gesture = self.bridge.session.begin(self._step_name)

    def _try(self, raw: Value) -> None:
        if self._gesture is None:
            return
        start, frame = self._gesture.start, self.bridge.frame
        before = value_of(start, self.address, frame)
        if len(self.addresses) > 1 and isinstance(raw, float) and isinstance(before, float):
            # Dragged together, each keeps its distance from the others.
            away = raw - before
            self._gesture.show(change_all(start, self.addresses, lambda value: value + away, frame))
        else:
            self._gesture.show(set_all(start, self.addresses, raw, frame))

    def _end(self, keep: bool) -> None:
        gesture, self._gesture = self._gesture, None
        if gesture is not None:
            gesture.commit() if keep else gesture.cancel()
        self._shown = None
        self.refresh()

    def _show_changed(self, *, changed: bool) -> None:
        line, words = self.address.property, ""
        if changed:
            # The words say it too: colour alone does not reach everyone.
            words = self.tr("Changed; double-click for the default, %1").replace("%1", dumps_value(line.default))
        self.label.setToolTip(f"{translated(line.help)}\n{self.path}\n{words}".strip())
        self.label.show_changed(changed=changed)

    def _open_menu(self, widget: QWidget, at: QPoint) -> None:
        open_row_menu(self, widget.mapToGlobal(at))
