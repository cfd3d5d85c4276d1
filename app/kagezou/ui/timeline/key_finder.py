"""Which keys of the timeline lie at a place, or within a box drawn around them."""

from PySide6.QtCore import QPointF, QRectF

from kagezou.animation.timecode import sheet_text
from kagezou.document.frame_numbers import number_of
from kagezou.document.key_edits import Refs
from kagezou.scene.stances import stances_of
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.timeline.drawing_bars import SUM_LANE_PX
from kagezou.ui.timeline.feet_lane import feet_over_time, words_at
from kagezou.ui.timeline.row_list import RowList
from kagezou.ui.timeline.rows import RowKind, TimelineRow, frames_of, keys_on
from kagezou.ui.timeline.time_scale import TimeScale

HIT_PX = 10.0
_OVER_BARS_PX = 2.0
"""How far the keys summed up under a layer's drawings reach up into them."""


class KeyFinder:
    """Looks for keys where they are seen.

    Parameters
    ----------
    bridge
        The session.
    scale, rows
        Where frames and rows lie.
    """

    def __init__(self, bridge: Bridge, scale: TimeScale, rows: RowList) -> None:
        self._bridge, self._scale, self._rows = bridge, scale, rows

    def row_at(self, place: QPointF) -> TimelineRow | None:
        """Return the row at a point."""
        index = self._rows.index_at(place.y())
        return None if index is None else self._rows.rows[index]

    def keys_on_frame(self, frame: int) -> Refs:
        """Return the keys of every row on a frame."""
        return frozenset().union(*(keys_on(self._bridge.document, row, frame) for row in self._rows.rows))

    def keys_at(self, place: QPointF, reach_px: float = HIT_PX) -> Refs:
        """Return the keys nearest to a point in its row, none beyond reach."""
        index = self._rows.index_at(place.y())
        if index is None:
            return frozenset()
        row = self._rows.rows[index]
        frames = frames_of(self._bridge.document, row)
        near = min(frames, key=lambda frame: abs(self._scale.middle_of(frame) - place.x()), default=None)
        if near is None or abs(self._scale.middle_of(near) - place.x()) > reach_px:
            return frozenset()
        top = self._rows.top_of(index)
        if row.kind is RowKind.LAYER and place.y() < top + self._rows.row_px - SUM_LANE_PX - _OVER_BARS_PX:
            # The upper part of a layer's row is its drawings'.
            return frozenset()
        return keys_on(self._bridge.document, row, near)

    def words_at(self, place: QPointF) -> str:
        """Return what a tool tip says about the key at a point, its frame, or about the feet on it."""
        row = self.row_at(place)
        if row is not None and row.kind is RowKind.FEET and row.layer_id is not None:
            return self._words_of_feet(row.layer_id, int(self._scale.position_at(place.x())))
        canvas = self._bridge.document.canvas
        if hit := self.keys_at(place):
            frame = min(ref.frame for ref in hit)
            return f"{number_of(canvas, frame)}  ({sheet_text(frame, canvas.frame_rate)})"
        return ""

    def _words_of_feet(self, figure_id: str, frame: int) -> str:
        document = self._bridge.document
        found = stances_of(document, figure_id)
        inside = 1 <= frame <= document.canvas.length_frames
        return words_at(feet_over_time(document, figure_id, found), found, frame) if found and inside else ""

    def keys_in(self, box: QRectF) -> Refs:
        """Return the keys in a box; those of an open group only where they lie themselves."""
        refs: Refs = frozenset()
        half = self._rows.row_px / 2
        for index, row in enumerate(self._rows.rows):
            middle = self._rows.top_of(index) + half
            # The keys of an open group lie below it, each in its own row.
            if not box.top() - half <= middle <= box.bottom() + half or row.is_open:
                continue
            for frame in frames_of(self._bridge.document, row):
                if box.left() <= self._scale.middle_of(frame) <= box.right():
                    refs |= keys_on(self._bridge.document, row, frame)
        return refs
