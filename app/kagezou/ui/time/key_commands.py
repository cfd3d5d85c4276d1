"""What the commands on keys do: the keys are those selected in the session, whoever selected them."""

from PySide6.QtCore import QObject, Signal

from kagezou.animation.ease import EASY
from kagezou.animation.track import Interpolation
from kagezou.document.address import Address, track_of, value_of
from kagezou.document.ease_edits import set_ease, set_interpolation
from kagezou.document.edits import set_key
from kagezou.document.key_edits import (
    Refs,
    all_keys,
    copy_keys,
    move_keys,
    paste_keys,
    remove_keys,
)
from kagezou.document.model import Document
from kagezou.document.properties import OF_DOCUMENT, OF_LAYER, OF_PIECE
from kagezou.document.review import set_work_area
from kagezou.io.clips.timeline_clips import dumps_keys, holds_keys, loads_keys
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.clipboard import Clipboard


class KeyCommands(QObject):
    """Copying, pasting, moving, easing and setting keys, and the work area; each is one step with a name."""

    refused = Signal(str)
    """One sentence on why nothing happened."""

    def __init__(self, bridge: Bridge, clipboard: Clipboard) -> None:
        super().__init__()
        self._bridge, self._clipboard = bridge, clipboard

    @property
    def chosen(self) -> Refs:
        """The selected keys."""
        return self._bridge.session.state.keys

    def copy(self) -> None:
        """Put the selected keys on the clipboard, for any window of the program."""
        clip = copy_keys(self._bridge.document, self.chosen)
        if clip is None:
            self.refused.emit(self.tr("No keys are selected."))
        else:
            self._clipboard.put(dumps_keys(self._bridge.document, clip))

    def cut(self) -> None:
        """Put the selected keys on the clipboard and take them away."""
        if self.chosen:
            self.copy()
            self._edit(self.tr("Cut keys"), remove_keys(self._bridge.document, self.chosen), frozenset())

    def paste(self) -> None:
        """Put the copied keys down at the playhead, onto the layer worked on."""
        self._paste(self._bridge.frame)

    def paste_in_place(self) -> None:
        """Put the copied keys down where they were taken."""
        self._paste(None)

    def delete(self) -> bool:
        """Take the selected keys away; false if there are none."""
        if not self.chosen:
            return False
        self._edit(self.tr("Delete keys"), remove_keys(self._bridge.document, self.chosen), frozenset())
        return True

    def nudge(self, frames: int) -> None:
        """Move the selected keys in time."""
        if self.chosen:
            self._edit(self.tr("Move keys"), *move_keys(self._bridge.document, self.chosen, frames))

    def select_all(self) -> None:
        """Select every key of the scene and of the layers or the set piece worked on."""
        self._bridge.session.select_keys(
            frozenset().union(*(all_keys(self._bridge.document, each) for each in self._worked_on()))
        )

    def ease(self, *, into: bool, out: bool) -> None:
        """Let the values come to rest at the selected keys, on one side or both."""
        eased = set_ease(self._bridge.document, self.chosen, (EASY,) if into else None, (EASY,) if out else None)
        words = self.tr("Easy ease") if into and out else self.tr("Ease in") if into else self.tr("Ease out")
        self._edit(words, eased)

    def hold(self) -> None:
        """Hold the values from the selected keys on; where all are held already, let them move again."""
        keys = [track_of(self._bridge.document, ref.address).key_at(ref.frame) for ref in self.chosen]
        all_held = all(key is not None and key.interpolation is Interpolation.HOLD for key in keys)
        self.interpolate(Interpolation.LINEAR if all_held else Interpolation.HOLD)

    def interpolate(self, interpolation: Interpolation) -> None:
        """Let the values go on from the selected keys in one way."""
        words = {
            Interpolation.HOLD: self.tr("Hold keys"),
            Interpolation.LINEAR: self.tr("Make keys linear"),
            Interpolation.BEZIER: self.tr("Make keys bezier"),
        }
        self._edit(words[interpolation], set_interpolation(self._bridge.document, self.chosen, interpolation))

    def set_here(self) -> None:
        """Set keys at the playhead: of the selected properties, else of all that are keyed in the layer worked on."""
        document, frame = self._bridge.document, self._bridge.frame
        chosen = self._bridge.session.state.selection or tuple({ref.address for ref in self.chosen})
        addresses = chosen or tuple(each for each in self._worked_on() if track_of(document, each).is_keyed)
        if not addresses:
            self.refused.emit(self.tr("Nothing is keyed yet; click the diamond before a property in the inspector."))
            return
        for address in addresses:
            if track_of(document, address).key_at(frame) is None:
                document = set_key(document, address, frame, value_of(document, address, frame))
        self._edit(self.tr("Set keys"), document)

    def begin_work_area(self) -> None:
        """Let the work area begin at the playhead."""
        first, last = self._bridge.frame, self._bridge.document.played[1]
        self._set_area(first, last if last >= first else None)

    def end_work_area(self) -> None:
        """Let the work area end at the playhead."""
        first, last = self._bridge.document.played[0], self._bridge.frame
        self._set_area(first if first <= last else None, last)

    def clear_work_area(self) -> None:
        """Play the whole cut again."""
        self._edit(self.tr("Clear work area"), set_work_area(self._bridge.document, None, None))

    def _set_area(self, first: int | None, last: int | None) -> None:
        self._edit(self.tr("Set work area"), set_work_area(self._bridge.document, first, last))

    def _paste(self, frame: int | None) -> None:
        text = self._clipboard.text()
        clip = loads_keys(text, self._bridge.document)
        if clip is None:
            unfit = self.tr("Nothing in this project takes the copied keys, or they are more than a project holds.")
            self.refused.emit(unfit if holds_keys(text) else self.tr("No keys were copied yet."))
            return
        document, refs = paste_keys(self._bridge.document, clip, frame, self._bridge.layer_id)
        if refs:
            self._edit(self.tr("Paste keys"), document, refs)
        else:
            self.refused.emit(self.tr("The copied keys belong to layers that are not in this project."))

    def _edit(self, name: str, document: Document, keys: Refs | None = None) -> None:
        with self._bridge.session.gesture(name) as gesture:
            gesture.show(document, keys)

    def _worked_on(self) -> list[Address]:
        piece_id = self._bridge.piece_id
        found = [Address(prop) for prop in OF_DOCUMENT.values()]
        found += [Address(prop, each) for each in self._bridge.layer_ids for prop in OF_LAYER.values()]
        if piece_id is not None:
            found += [Address(prop, piece_id=piece_id) for prop in OF_PIECE.values()]
        return found
