"""The ruler over the lanes: frames, work area, markers, what is ready to be seen, and the playhead to drag."""

from collections.abc import Callable, Set
from functools import partial
from typing import Final

from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QMouseEvent, QPainter, QPaintEvent, QPen, QResizeEvent, QWheelEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from kagezou.animation.timecode import Count, sheet_text
from kagezou.document.frame_numbers import number_of
from kagezou.document.model import Document, Marker
from kagezou.document.note import Note
from kagezou.document.review import move_marker, set_work_area
from kagezou.picture_source import PictureSource
from kagezou.session.session import Gesture
from kagezou.tools.timeline.snapping import snap_frames, snapped
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.note_words import note_heading, note_words
from kagezou.ui.system.theme import BRIGHT, LINE, OFF, WELL
from kagezou.ui.timeline.row_list import is_same
from kagezou.ui.timeline.ruler_painting import (
    STRIP_PX,
    Ready,
    flag_of,
    note_mark,
    paint_area,
    paint_marker,
    paint_note,
    paint_playhead,
    paint_ready,
    paint_ticks,
)
from kagezou.ui.timeline.time_scale import TimeScale
from kagezou.ui.widgets.once_a_paint import OnceAPaint
from kagezou.ui.widgets.still_picture import StillPicture

_END_REACH_PX: Final = 7.0

Kept = Callable[[], Set[PictureSource]]
"""The pictures that are decoded."""

Finished = Callable[[], Set[int]]
"""The frames that are kept as they are seen."""


class Ruler(QWidget):
    """Shows and sets the frame; drags markers and the ends of the work area.

    Parameters
    ----------
    bridge
        The session.
    scale
        Where frames lie.
    kept
        The pictures that are decoded: frames that need no others can be seen at once.
    finished
        The frames that are kept as they are seen: they play at the cut's own rate.
    """

    marker_asked = Signal(int)
    """The marker on this frame shall be renamed."""

    def __init__(
        self, bridge: Bridge, scale: TimeScale, kept: Kept = frozenset, finished: Finished = frozenset
    ) -> None:
        super().__init__()
        self._bridge, self._scale, self._kept, self._finished = bridge, scale, kept, finished
        self.count = Count.FRAMES
        self._gesture: Gesture | None = None
        self._held: int | str | None = None
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setMouseTracking(True)
        self.setAccessibleName(self.tr("Frame ruler"))
        self._seen = _seen_of(bridge.document)
        self.still = StillPicture(self, self._paint_still)
        self._moves = OnceAPaint(self)
        self._frame_painted = bridge.frame
        scale.changed.connect(self.still.forget)
        bridge.frame_changed.connect(self._move_playhead)
        bridge.document_changed.connect(self._show_document)

    def sizeHint(self) -> QSize:
        return QSize(400, self.fontMetrics().height() + 20)

    def show_count(self, count: Count) -> None:
        """Count frames in another way."""
        self.count = count
        self.still.forget()

    def refresh(self) -> None:
        """Show which pictures are decoded and which frames are kept now."""
        self.still.forget()

    def marker_at(self, place: QPointF) -> Marker | None:
        """Return the marker whose flag lies at a point."""
        if place.y() > self.height() - STRIP_PX:
            return None
        return next(
            (
                marker
                for marker in reversed(self._bridge.document.markers)
                if flag_of(marker, self._scale, self.fontMetrics()).adjusted(-4, 0, 2, 0).contains(place)
            ),
            None,
        )

    def notes_at(self, place: QPointF) -> tuple[Note, ...]:
        """Return the notes whose mark lies at a point."""
        frame = self._scale.frame_at(place.x())
        near = (frame - 1, frame, frame + 1)
        return tuple(
            note
            for note in self._bridge.document.notes
            if note.frame in near
            and note_mark(note.frame, self._scale, self.height()).adjusted(-3, -3, 3, 1).contains(place)
        )

    def end_at(self, place: QPointF) -> str | None:
        """Return which end of the work area lies at a point: "first", "last" or none."""
        if place.y() < self.height() - STRIP_PX - 3:
            return None
        first, last = self._bridge.document.played
        gaps = {
            "first": abs(place.x() - self._scale.x_of(first)),
            "last": abs(place.x() - self._scale.x_of(last + 1)),
        }
        name = min(gaps, key=lambda each: gaps[each])
        return name if gaps[name] <= _END_REACH_PX else None

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._scale.set_width(event.size().width())

    def wheelEvent(self, event: QWheelEvent) -> None:
        turn = event.angleDelta()
        if event.modifiers() & Qt.KeyboardModifier.ShiftModifier or abs(turn.x()) > abs(turn.y()):
            self._scale.scroll_to(self._scale.scroll_px - (turn.x() or turn.y()))
        else:
            self._scale.zoom(1.25 ** (turn.y() / 120), event.position().x())
        event.accept()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() is not Qt.MouseButton.LeftButton:
            return
        place = event.position()
        marker = self.marker_at(place)
        self._held = marker.frame if marker is not None else self.end_at(place)
        if isinstance(self._held, int):
            self._bridge.session.go_to(self._held)
        elif self._held is None:
            self._bridge.let_pass(on=True, by_hand=True)
            self._scrub(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        self._moves.take(event, partial(self._move, event.clone()))

    def _move(self, event: QMouseEvent) -> None:
        place = event.position()
        frame = self._scale.frame_at(place.x())
        marker = self.marker_at(place)
        document = self._bridge.document
        canvas = document.canvas
        said = [marker.comment] if marker is not None and marker.comment else []
        said += [f"{note_heading(each, document)}\n{note_words(each)}" for each in self.notes_at(place)]
        self.setToolTip("\n".join([f"{number_of(canvas, frame)}  ({sheet_text(frame, canvas.frame_rate)})", *said]))
        if not event.buttons() & Qt.MouseButton.LeftButton:
            ends = self.end_at(place) is not None and marker is None
            self.setCursor(Qt.CursorShape.SizeHorCursor if ends else Qt.CursorShape.PointingHandCursor)
        elif self._held is None:
            self._scrub(event)
        elif self._gesture is not None or frame != self._held:
            self._drag(self._held, frame)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        self._moves.finish()
        if self._bridge.is_scrubbed:
            self._bridge.let_pass(on=False)
        if self._gesture is not None and event.button() is Qt.MouseButton.LeftButton:
            self._gesture.commit()
        self._gesture = self._held = None

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        marker = self.marker_at(event.position())
        if marker is not None:
            self.marker_asked.emit(marker.frame)
        elif self.end_at(event.position()) or event.position().y() > self.height() - STRIP_PX:
            self._bridge.session.edit(self.tr("Clear work area"), set_work_area(self._bridge.document, None, None))

    def _show_document(self) -> None:
        """Paint anew if what is seen here changed: a drag on the picture tells many times a second."""
        seen = _seen_of(self._bridge.document)
        if not is_same(seen, self._seen):
            self._seen = seen
            self.still.forget()

    def _scrub(self, event: QMouseEvent) -> None:
        frame = self._scale.frame_at(event.position().x())
        if event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
            place = self._scale.position_at(event.position().x()) - 0.5
            frame, _ = snapped(place, snap_frames(self._bridge.document, 1), self._scale.cell_px)
        self._bridge.session.go_to(frame)

    def _drag(self, held: int | str, frame: int) -> None:
        if self._gesture is None:
            words = self.tr("Move marker") if isinstance(held, int) else self.tr("Set work area")
            self._gesture = self._bridge.session.begin(words)
        start = self._gesture.start
        if isinstance(held, int):
            self._gesture.show(move_marker(start, held, frame))
            return
        first, last = start.played
        ends = (min(frame, last), last) if held == "first" else (first, max(frame, first))
        self._gesture.show(set_work_area(start, *ends))

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        self.still.paint(painter, event.rect())
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        left, width = self._scale.x_of(self._bridge.frame), max(self._scale.cell_px, 2.0)
        paint_playhead(painter, left, width, self.height(), BRIGHT if self.isEnabled() else OFF)
        painter.end()

    def _move_playhead(self, frame: int) -> None:
        """Paint anew where the playhead was and where it is."""
        for each in (self._frame_painted, frame):
            left, width = self._scale.x_of(each), max(self._scale.cell_px, 2.0)
            self.update(QRectF(left - 12, 0, width + 24, self.height()).toAlignedRect())
        self._frame_painted = frame

    def _paint_still(self, painter: QPainter) -> None:
        painter.fillRect(self.rect(), WELL)
        document, scale = self._bridge.document, self._scale
        paint_area(painter, scale, document, self.height())
        paint_ticks(painter, scale, self.size(), document.canvas, self.count)
        if document.layers:
            ready = Ready(self._kept(), self._finished())
            paint_ready(painter, scale, document.layers, ready, self.size())
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        for marker in document.markers:
            paint_marker(painter, scale, marker, self.height())
        for frame, is_done in _marked(document).items():
            paint_note(painter, note_mark(frame, scale, self.height()), is_done=is_done)
        painter.setPen(QPen(LINE, 1))
        painter.drawLine(0, self.height() - 1, self.width(), self.height() - 1)


def _seen_of(document: Document) -> tuple[object, ...]:
    """Return what of a document is seen on the ruler; drawings, for it shows which are decoded."""
    return (
        document.canvas,
        document.work_area,
        document.markers,
        document.notes,
        *(layer.cels for layer in document.layers),
    )


def _marked(document: Document) -> dict[int, bool]:
    """Return the frames with notes, and whether all of them are ticked off."""
    are_done: dict[int, bool] = {}
    for note in document.notes:
        are_done[note.frame] = note.is_done and are_done.get(note.frame, True)
    return are_done
