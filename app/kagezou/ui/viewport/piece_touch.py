"""The pieces of the set under the pointer: which outline it is on, and choosing that piece."""

from kagezou.scene.set_outlines import PieceOutline, outlines_of
from kagezou.tools.handle import Guide, GuideKind
from kagezou.tools.piece_hits import piece_at
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.viewport.pointer_report import PointerReport
from kagezou.ui.viewport.viewpoint import Viewpoint

_REACH_OF_HANDLES = 0.5
"""How near an outline must be, as a part of how near a handle must be: outlines are long, and lie under much."""


class PieceTouch:
    """Knows the outlines of the frame, worked out anew only where the document or the frame changed.

    Parameters
    ----------
    bridge
        The session worked in.
    viewpoint
        How the canvas is looked at.
    """

    def __init__(self, bridge: Bridge, viewpoint: Viewpoint) -> None:
        self._bridge = bridge
        self._viewpoint = viewpoint
        self._known: tuple[object, int, tuple[PieceOutline, ...]] | None = None
        self.hovered_id: str | None = None
        self._left: str | None = None

    @property
    def name(self) -> str:
        """What the piece under the pointer is called."""
        pieces = self._bridge.document.pieces
        return next((piece.name for piece in pieces if piece.id == self.hovered_id), "")

    @property
    def guides(self) -> tuple[Guide, ...]:
        """The outline under the pointer, where it is not drawn already."""
        touched = self.hovered_id if self.hovered_id != self._bridge.piece_id else None
        found = (each for each in self._outlines() if each.piece_id == touched)
        return tuple(Guide(GuideKind.PIECE_TOUCHED, line) for each in found for line in each.seen)

    def hover(self, report: PointerReport | None) -> None:
        """Look what is under the pointer; None where it has left, or is on something else."""
        self.hovered_id = None if report is None else self._at(report)

    def choose(self, report: PointerReport) -> bool:
        """Work on the piece under the pointer; false where there is none."""
        self._left = None
        piece_id = self._at(report)
        if piece_id is None:
            return False
        self._left = self._bridge.layer_id
        if piece_id != self._bridge.piece_id:
            self._bridge.session.select_piece(piece_id)
        return True

    def go_back(self) -> None:
        """Work on the layer again that the last press left for a piece: that press was the first of a double click."""
        if self._left is not None:
            self._bridge.session.select(self._left)
            self._left = None

    def _at(self, report: PointerReport) -> str | None:
        reach = report.reach_px * _REACH_OF_HANDLES
        return piece_at(self._outlines(), self._viewpoint.view, report.view_px, reach)

    def _outlines(self) -> tuple[PieceOutline, ...]:
        document, frame = self._bridge.document, self._bridge.frame
        if self._known is None or self._known[0] is not document or self._known[1] != frame:
            self._known = (document, frame, outlines_of(document, frame))
        return self._known[2]
