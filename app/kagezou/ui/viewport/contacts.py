"""Contacts put and taken away by hand: feet where the figure stands on them, else grounding points."""

from PySide6.QtCore import QCoreApplication, QObject, Signal

from kagezou.document.model import Document
from kagezou.errors import Problem
from kagezou.geometry.vectors import Point2
from kagezou.io.images.cel_cache import CelSource
from kagezou.scene.figure_card import feet_at
from kagezou.standing.foot import Verdict
from kagezou.tools.feet import ShownFoot, carries, judged, kept_in_place, shown_foot, unpinned, with_foot_at
from kagezou.tools.grounding import GROUNDING, add_grounding, remove_grounding
from kagezou.tools.handle import Handle
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.words import translated
from kagezou.ui.viewport.figure_touch import is_on_figure


class Contacts(QObject):
    """Edits what the figure worked on touches the ground with, each edit as one step.

    Parameters
    ----------
    bridge
        The session worked in.
    cels
        Where the drawings come from: a contact is put on the figure, not beside it.
    """

    refused = Signal(str)

    def __init__(self, bridge: Bridge, cels: CelSource) -> None:
        super().__init__()
        self._bridge, self._cels = bridge, cels

    def add(self, canvas_px: Point2, reach_px: float) -> bool:
        """Put a contact on the figure within reach, canvas px; false without a layer, and where it is refused."""
        bridge, layer_id = self._bridge, self._bridge.layer_id
        if layer_id is None:
            return False
        document = bridge.document
        figure = document.layer(document.layer(layer_id).joins or layer_id)
        if not is_on_figure(document, figure.id, bridge.frame, canvas_px, reach_px, self._cels):
            self.refused.emit(
                QCoreApplication.translate(
                    "HandleController", "Double-click on the character itself to say where it touches the ground."
                )
            )
            return False
        if feet_at(document, figure, bridge.frame) is not None:
            added = with_foot_at(document, layer_id, bridge.frame, canvas_px)
            return added is not None and self._edit(QCoreApplication.translate("HandleController", "Add foot"), added)
        try:
            added = add_grounding(document, figure.id, bridge.frame, canvas_px)
        except Problem as problem:
            self.refused.emit(translated(problem))
            return False
        return self._edit(QCoreApplication.translate("HandleController", "Add grounding point"), added)

    def remove(self, handle: Handle) -> bool:
        """Take a contact away; false where the handle is none."""
        bridge = self._bridge
        foot = self.foot_of(handle)
        if foot is not None:
            self.judge(foot, Verdict.NONE)
            return True
        if handle.index is None or handle.layer_id is None or not handle.id.startswith(f"{GROUNDING}."):
            return False
        document = remove_grounding(bridge.document, handle.layer_id, bridge.frame, handle.index)
        return self._edit(QCoreApplication.translate("HandleController", "Remove grounding point"), document)

    def foot_of(self, handle: Handle) -> ShownFoot | None:
        """Return whose foot a handle is, None where it is none."""
        return shown_foot(self._bridge.document, handle, self._bridge.frame)

    def judge(self, foot: ShownFoot, verdict: Verdict) -> None:
        """Say what a foot does on the drawing that is shown."""
        words = {
            Verdict.PLANTED: QCoreApplication.translate("HandleController", "Plant foot"),
            Verdict.LIFTED: QCoreApplication.translate("HandleController", "Lift foot"),
            Verdict.NONE: QCoreApplication.translate("HandleController", "Remove foot"),
        }
        self._edit(words[verdict], judged(self._bridge.document, foot, verdict))

    def pin(self, foot: ShownFoot) -> None:
        """Keep a foot as it is now, whatever is found later: where it is, and whether it carries."""
        document, frame = self._bridge.document, self._bridge.frame
        judged_now = judged(document, foot, Verdict.PLANTED if carries(document, foot, frame) else Verdict.LIFTED)
        self._edit(QCoreApplication.translate("HandleController", "Pin foot"), kept_in_place(judged_now, foot))

    def unpin(self, foot: ShownFoot) -> None:
        """Leave a foot to what is found."""
        self._edit(QCoreApplication.translate("HandleController", "Unpin foot"), unpinned(self._bridge.document, foot))

    def _edit(self, name: str, document: Document) -> bool:
        self._bridge.session.edit(name, document)
        return True
