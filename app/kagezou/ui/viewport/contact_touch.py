"""Contacts under the pointer: put on the figure by a double click, looked at by a right click, taken away by Delete."""

from PySide6.QtCore import QObject

from kagezou.io.images.cel_cache import CelSource
from kagezou.tools.feet import ShownFoot
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.viewport.contacts import Contacts
from kagezou.ui.viewport.handle_controller import HandleController
from kagezou.ui.viewport.handle_source import Task
from kagezou.ui.viewport.pointer_report import PointerReport
from kagezou.ui.viewport.viewpoint import Viewpoint


class ContactTouch(QObject):
    """What the hand does with contacts.

    Parameters
    ----------
    bridge
        The session worked in.
    viewpoint
        How the canvas is looked at.
    hand
        Which handle is selected.
    cels
        Where the drawings come from.

    Attributes
    ----------
    contacts
        The edits.
    """

    def __init__(self, bridge: Bridge, viewpoint: Viewpoint, hand: HandleController, cels: CelSource) -> None:
        super().__init__()
        self._viewpoint, self._hand = viewpoint, hand
        self.contacts = Contacts(bridge, cels)
        self.contacts.refused.connect(hand.refused)

    def add(self, report: PointerReport) -> bool:
        """Add a contact under the pointer and select it; false without a layer, on a handle, or beside the figure."""
        hand, view = self._hand, self._viewpoint.view
        hand.pieces.go_back()
        if hand.task is not Task.SCENE or hand.under(report) is not None:
            return False
        hand.end_nudge()
        before = {handle.id for handle in hand.handles.handles}
        if not self.contacts.add(view.canvas_from_view(report.view_px), view.canvas_length(report.reach_px)):
            return False
        added = [each.id for each in hand.handles.handles if each.index is not None and each.id not in before]
        hand.select(added[-1] if added else None)
        return True

    def foot_under(self, report: PointerReport) -> ShownFoot | None:
        """Return the foot under the pointer, None where there is none or something is held."""
        handle = None if self._hand.is_busy else self._hand.under(report)
        return None if handle is None else self.contacts.foot_of(handle)

    def remove_selected(self) -> bool:
        """Remove the selected contact; false where none is selected."""
        hand = self._hand
        handle = hand.handles.find(hand.selected_id)
        if handle is None or hand.is_busy:
            return False
        hand.end_nudge()
        if not self.contacts.remove(handle):
            return False
        hand.hovered_id = None
        hand.select(None)
        return True
