"""One property of one or several layers as something to edit: its value, its keys, its link; no widget."""

from collections.abc import Callable

from PySide6.QtCore import QCoreApplication

from kagezou.animation.track import Track, Value
from kagezou.document.address import Address, path_of, track_of, usual_value, value_of
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
from kagezou.document.properties import LIGHT_KIND
from kagezou.document.typed_number import evaluate
from kagezou.session.session import Gesture
from kagezou.tools.light_kind import with_light_kind
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.words import translated

translate = QCoreApplication.translate


class EditedProperty:
    """What can be done with a property at the frame looked at; every change is one step of history.

    Parameters
    ----------
    bridge
        The session to edit.
    address
        What is edited.
    others
        The same property of the other layers that are chosen.
    """

    def __init__(self, bridge: Bridge, address: Address, others: tuple[Address, ...] = ()) -> None:
        self.bridge = bridge
        self.address = address
        self.addresses = (address, *others)
        self._about = frozenset(self.addresses)
        self._gesture: Gesture | None = None

    def is_about(self, addresses: frozenset[Address]) -> bool:
        """Return whether any of some properties is edited here."""
        return not self._about.isdisjoint(addresses)

    @property
    def tracks(self) -> tuple[Track, ...]:
        """The tracks of all layers, that of the one worked on first."""
        return tuple(track_of(self.bridge.document, address) for address in self.addresses)

    @property
    def usual(self) -> Value:
        """What the property is while nobody has set it."""
        return usual_value(self.bridge.document, self.address)

    @property
    def is_changed(self) -> bool:
        """Whether it was set by someone, or is keyed."""
        usual = self.usual
        return any(track.is_keyed or track.constant != usual for track in self.tracks)

    @property
    def path(self) -> str:
        """The property's path, as scripts and the command line write it."""
        return path_of(self.bridge.document, self.address)

    @property
    def value(self) -> Value:
        """What is seen at the frame looked at, of the layer worked on."""
        return value_of(self.bridge.document, self.address, self.bridge.frame)

    @property
    def is_mixed(self) -> bool:
        """Whether the layers have different values."""
        return is_mixed(self.bridge.document, self.addresses, self.bridge.frame)

    @property
    def is_keyed_here(self) -> bool:
        """Whether every layer has a key at the frame looked at."""
        return is_keyed_here(self.bridge.document, self.addresses, self.bridge.frame)

    @property
    def is_linked(self) -> bool:
        """Whether it is the same for all characters."""
        return is_linked(self.bridge.document, self.address)

    @property
    def can_be_linked(self) -> bool:
        """Whether there are characters it could be the same for; a link that is there can always be taken away."""
        if self.address.layer_id is None or self.address.property.name not in LINKABLE:
            return False
        return len(self.bridge.document.layers) > 1 or self.is_linked

    def enter(self, raw: Value) -> None:
        """Set a value at the frame looked at, everywhere, as one step; a Problem if it cannot be.

        Another kind of light takes over the shadow where it is.
        """
        if self.address.property is LIGHT_KIND:
            layer_id, frame = self.bridge.layer_id, self.bridge.frame
            self._change(lambda document: with_light_kind(document, layer_id, frame, str(raw)))
            return
        self._change(lambda document: set_all(document, self.addresses, raw, self.bridge.frame))

    def calculate(self, text: str, factor: float = 1.0) -> None:
        """Change each layer's number by itself as a typed calculation says, as one step; a Problem if it cannot be.

        Parameters
        ----------
        factor
            The numbers are meant times this, as they are shown.
        """

        def change(value: float) -> float:
            return evaluate(text, value * factor) / factor

        self._change(lambda document: change_all(document, self.addresses, change, self.bridge.frame))

    def reset(self) -> None:
        """Go back to the default, without keys."""
        self._edit(translate("EditedProperty", "Reset %1"), reset_all(self.bridge.document, self.addresses))

    def toggle_key(self) -> None:
        """Set a key at the frame looked at, or take it away."""
        document, frame = self.bridge.document, self.bridge.frame
        removes = self.is_keyed_here
        words = translate("EditedProperty", "Remove key of %1") if removes else translate("EditedProperty", "Key %1")
        self._edit(words, toggle_keys(document, self.addresses, frame))

    def remove_all_keys(self) -> None:
        """Keep the value seen now for the whole cut."""
        still = still_all(self.bridge.document, self.addresses, self.bridge.frame)
        self._edit(translate("EditedProperty", "Remove all keys of %1"), still)

    def toggle_link(self) -> None:
        """Make the property the same for all characters as it is here, or each character's own again."""
        document = self.bridge.document
        if self.is_linked:
            self._edit(translate("EditedProperty", "Unlink %1"), unlink(document, self.address.property.name))
        else:
            self._edit(translate("EditedProperty", "Link %1"), link(document, self.address))

    def begin(self) -> None:
        """Begin a drag, which will be one step."""
        self._gesture = self.bridge.session.begin(self._step_name)

    def show(self, raw: Value) -> None:
        """Show the value that a drag is at; several layers dragged together keep their distance from each other."""
        if self._gesture is None:
            return
        start, frame = self._gesture.start, self.bridge.frame
        before = value_of(start, self.address, frame)
        if len(self.addresses) > 1 and isinstance(raw, float) and isinstance(before, float):
            away = raw - before
            self._gesture.show(change_all(start, self.addresses, lambda value: value + away, frame))
        else:
            self._gesture.show(set_all(start, self.addresses, raw, frame))

    def end(self, *, keep: bool) -> None:
        """End the drag, and keep or take back what it did."""
        gesture, self._gesture = self._gesture, None
        if gesture is not None:
            gesture.commit() if keep else gesture.cancel()

    @property
    def _step_name(self) -> str:
        return self._named(translate("EditedProperty", "Change %1"))

    def _named(self, words: str) -> str:
        return words.replace("%1", translated(self.address.property.label))

    def _edit(self, words: str, document: Document) -> None:
        self.bridge.session.edit(self._named(words), document)

    def _change(self, make: Callable[[Document], Document]) -> None:
        self.bridge.session.edit(self._step_name, make(self.bridge.document))
