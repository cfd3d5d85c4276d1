"""The lanes: drawings as bars and keys as shapes, row by row over time."""

from functools import partial

from PySide6.QtCore import QEvent, QLineF, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPen, QResizeEvent, QWheelEvent
from PySide6.QtWidgets import QWidget

from kagezou.animation.timecode import frames_per_second
from kagezou.document.address import track_of
from kagezou.document.key_edits import KeyRef
from kagezou.scene.stances import stances_of
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.theme import BRIGHT, CHANGED, DIM, LINE, OFF, SELECTED, TEXT, WARNING, WELL
from kagezou.ui.system.window_keys import lies_on_command
from kagezou.ui.timeline.drawing_bars import SUM_LANE_PX, bars_of, paint_bars
from kagezou.ui.timeline.drawing_controller import DrawingController
from kagezou.ui.timeline.feet_lane import feet_over_time, paint_feet
from kagezou.ui.timeline.key_controller import KeyController
from kagezou.ui.timeline.key_shapes import half_path, halves_of
from kagezou.ui.timeline.row_list import RowList
from kagezou.ui.timeline.rows import RowKind, TimelineRow, frames_of, keys_on
from kagezou.ui.timeline.time_scale import TimeScale
from kagezou.ui.widgets.once_a_paint import OnceAPaint
from kagezou.ui.widgets.still_picture import StillPicture

KEY_RADIUS_PX = 6.5
_SUM_RADIUS_PX = 5.0
_PART_RADIUS_PX = 3.4
_BAND = QColor(255, 255, 255, 7)
_CHOSEN_BAND = QColor(255, 255, 255, 16)
_ABSENT = QColor("#5c5c5c")
_SPAN = QColor("#707070")
_OUTSIDE = QColor(0, 0, 0, 96)


class Lanes(QWidget):
    """Keys and exposures over time; the hands on them are :class:`KeyController` and :class:`DrawingController`."""

    def __init__(self, bridge: Bridge, scale: TimeScale, rows: RowList) -> None:
        super().__init__()
        self._bridge = bridge
        self._scale = scale
        self._rows = rows
        self.controller = KeyController(bridge, scale, rows)
        self.drawings = DrawingController(bridge, scale, rows)
        for changed in (self.controller.changed, self.drawings.changed):
            changed.connect(self.update)
        self.still = StillPicture(self, self._paint_still)
        self._moves = OnceAPaint(self)
        self._frame_painted = bridge.frame
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        # Single letters are commands here, which an input method would swallow.
        self.setAttribute(Qt.WidgetAttribute.WA_InputMethodEnabled, on=False)
        self.setAccessibleName(self.tr("Keys and drawings over time"))
        for signal in (scale.changed, rows.changed, bridge.keys_changed, self.drawings.choice.changed):
            signal.connect(self.still.forget)
        bridge.selection_changed.connect(self.still.forget)
        bridge.frame_changed.connect(self._move_playhead)

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._scale.set_width(event.size().width())
        self._rows.set_room(event.size().height())

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self.setFocus(Qt.FocusReason.MouseFocusReason)
        if self.controller.finder.keys_at(event.position()) or not self.drawings.press(event):
            self.controller.press(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        self._moves.take(event, partial(self._move, event.clone()))

    def _move(self, event: QMouseEvent) -> None:
        if self.drawings.is_down:
            self.drawings.move(event)
            return
        self.controller.move(event)
        place = event.position()
        on_bar = (
            None if self.controller.is_busy or self.controller.finder.keys_at(place) else self.drawings.cursor_at(place)
        )
        self.setToolTip(self.controller.finder.words_at(place) if on_bar is None else self.drawings.words_at(place))
        self.setCursor(self.controller.cursor if on_bar is None else on_bar)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        self._moves.finish()
        if self.drawings.is_down:
            self.drawings.release(event)
        else:
            self.controller.release(event)

    def wheelEvent(self, event: QWheelEvent) -> None:
        self.controller.wheel(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if self._is_escape_of_drawings(event):
            self.drawings.cancel()
        elif not self.controller.key(event):
            super().keyPressEvent(event)

    def event(self, event: QEvent) -> bool:
        # The window's commands on these keys are for the viewport; here they belong to the hand.
        if isinstance(event, QKeyEvent) and event.type() is QEvent.Type.ShortcutOverride:
            own = self.controller.wants(event) and not lies_on_command(event, self)
            if own or self._is_escape_of_drawings(event):
                event.accept()
                return True
        return super().event(event)

    def _is_escape_of_drawings(self, event: QKeyEvent) -> bool:
        return event.key() == Qt.Key.Key_Escape and (self.drawings.is_down or self.drawings.choice.layer_id is not None)

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        self.still.paint(painter, event.rect())
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self._paint_playhead(painter)
        self._paint_hand(painter)
        painter.end()

    def _move_playhead(self, frame: int) -> None:
        """Paint anew where the playhead was and where it is."""
        for each in (self._frame_painted, frame):
            left, width = self._scale.x_of(each), max(self._scale.cell_px, 1.0)
            self.update(QRectF(left - 2, 0, width + 4, self.height()).toAlignedRect())
        self._frame_painted = frame

    def _paint_still(self, painter: QPainter) -> None:
        painter.fillRect(self.rect(), WELL)
        _paint_grid(painter, self._scale, frames_per_second(self._bridge.document.canvas.frame_rate), self.size())
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self._paint_outside(painter)
        for index in self._rows.seen():
            self._paint_row(painter, self._rows.rows[index], self._rows.top_of(index))

    def _paint_row(self, painter: QPainter, row: TimelineRow, top: int) -> None:
        height = self._rows.row_px
        if row.is_group:
            is_chosen = row.is_about(self._bridge.layer_ids, self._bridge.piece_id)
            painter.fillRect(0, top, self.width(), height, _CHOSEN_BAND if is_chosen else _BAND)
        painter.setPen(QPen(LINE, 1))
        painter.drawLine(QLineF(0, top + height - 0.5, self.width(), top + height - 0.5))
        if row.kind is RowKind.LAYER and row.layer_id is not None:
            layer = self._bridge.document.layer(row.layer_id)
            bars = bars_of(layer, self._scale, self.width())
            paint_bars(painter, layer, bars, QRectF(0, top, 0, height), self.drawings.choice)
        if row.kind is RowKind.FEET:
            self._paint_feet(painter, row, top)
        elif row.is_group:
            self._paint_summary(painter, row, top)
        else:
            self._paint_keys(painter, row, top + height / 2)

    def _paint_feet(self, painter: QPainter, row: TimelineRow, top: int) -> None:
        found = None if row.layer_id is None else stances_of(self._bridge.document, row.layer_id)
        if found is not None and row.layer_id is not None:
            shown = feet_over_time(self._bridge.document, row.layer_id, found)
            paint_feet(painter, shown, self._scale, QRectF(0, top, self.width(), self._rows.row_px))

    def _paint_summary(self, painter: QPainter, row: TimelineRow, top: int) -> None:
        # Under the bars, where both can be read.
        from_bottom = SUM_LANE_PX / 2 if row.kind is RowKind.LAYER else self._rows.row_px / 2
        y = top + self._rows.row_px - from_bottom - 0.5
        chosen = self._bridge.session.state.keys
        for frame, count in frames_of(self._bridge.document, row).items():
            x = self._scale.middle_of(frame)
            if not -KEY_RADIUS_PX <= x <= self.width() + KEY_RADIUS_PX:
                continue
            is_chosen = bool(chosen) and keys_on(self._bridge.document, row, frame) <= chosen
            radius = _SUM_RADIUS_PX if count == len(row.addresses) else _PART_RADIUS_PX
            painter.setPen(QPen(LINE, 1.2))
            painter.setBrush(SELECTED if is_chosen else TEXT)
            painter.translate(x, y)
            painter.drawPolygon([QPointF(0, -radius), QPointF(radius, 0), QPointF(0, radius), QPointF(-radius, 0)])
            painter.translate(-x, -y)

    def _paint_keys(self, painter: QPainter, row: TimelineRow, y: float) -> None:
        address = row.addresses[0]
        track, chosen = track_of(self._bridge.document, address), self._bridge.session.state.keys
        places = [self._scale.middle_of(key.frame) for key in track.keys]
        if len(places) > 1:
            painter.setPen(QPen(_SPAN, 2))
            painter.drawLine(QLineF(max(places[0], 0), y, min(places[-1], self.width()), y))
        for index, (key, x) in enumerate(zip(track.keys, places, strict=True)):
            if not -KEY_RADIUS_PX <= x <= self.width() + KEY_RADIUS_PX:
                continue
            is_chosen = KeyRef(address, key.frame) in chosen
            painter.translate(x, y)
            radius = KEY_RADIUS_PX + (0.8 if is_chosen else 0)
            painter.setPen(QPen(BRIGHT if is_chosen else LINE, 2.4))
            for half, is_left in zip(halves_of(track, index), (True, False), strict=True):
                painter.strokePath(half_path(half, is_left=is_left, radius=radius), painter.pen())
            painter.setPen(Qt.PenStyle.NoPen)
            for half, is_left in zip(halves_of(track, index), (True, False), strict=True):
                color = SELECTED if is_chosen else _ABSENT if half is None else TEXT
                painter.setBrush(color)
                painter.drawPath(half_path(half, is_left=is_left, radius=radius))
            painter.translate(-x, -y)

    def _paint_outside(self, painter: QPainter) -> None:
        first, last = self._bridge.document.played
        height = self.height()
        for left, right in ((0.0, self._scale.x_of(first)), (self._scale.x_of(last + 1), float(self.width()))):
            if right > left:
                painter.fillRect(QRectF(left, 0, right - left, height), _OUTSIDE)

    def _paint_playhead(self, painter: QPainter) -> None:
        frame = self._bridge.frame
        left, width = self._scale.x_of(frame), self._scale.cell_px
        painter.fillRect(QRectF(left, 0, max(width, 1.0), self.height()), QColor(255, 255, 255, 22))
        painter.setPen(QPen(BRIGHT if self.isEnabled() else OFF, 1))
        middle = round(left + width / 2) + 0.5
        painter.drawLine(QLineF(middle, 0, middle, self.height()))
        for marker in self._bridge.document.markers:
            x = round(self._scale.middle_of(marker.frame)) + 0.5
            painter.setPen(QPen(CHANGED, 1, Qt.PenStyle.DotLine))
            painter.drawLine(QLineF(x, 0, x, self.height()))

    def _paint_hand(self, painter: QPainter) -> None:
        if self.controller.box is not None:
            painter.setPen(QPen(BRIGHT, 1, Qt.PenStyle.DashLine))
            painter.setBrush(QColor(255, 255, 255, 24))
            painter.drawRect(self.controller.box)
        # A key lies in the middle of its frame, a drawing begins with it.
        lies = self._scale.x_of if self.drawings.is_busy else self._scale.middle_of
        for hand in (self.controller, self.drawings):
            if hand.caught_by is not None:
                x = lies(hand.caught_by)
                painter.setPen(QPen(WARNING, 1.5))
                painter.drawLine(QLineF(x, 0, x, self.height()))
            if hand.said:
                _paint_words(painter, hand.said, hand.place, self.width())


def _paint_words(painter: QPainter, words: str, beside: QPointF, width_px: int) -> None:
    """Paint words on a dark pill above a place, within the width there is."""
    metrics = painter.fontMetrics()
    width, height = metrics.horizontalAdvance(words) + 16, metrics.height() + 6
    place = beside + QPointF(14, -height - 8)
    pill = QRectF(min(max(place.x(), 2.0), width_px - width - 2.0), max(place.y(), 2.0), float(width), float(height))
    painter.setPen(QPen(DIM, 1))
    painter.setBrush(QColor("#101010"))
    painter.drawRoundedRect(pill, 4, 4)
    painter.setPen(BRIGHT)
    painter.drawText(pill, Qt.AlignmentFlag.AlignCenter, words)


def _paint_grid(painter: QPainter, scale: TimeScale, rate: int, size: QSize) -> None:
    """Paint a line each second, quarter of a second and frame, as far as they can be told apart."""
    cell = scale.cell_px
    # A heavier line each second, a fainter one each quarter of it, the faintest each frame.
    for step, color, least_px in (
        (1, "#262626", 7.0),
        (max(rate // 4, 1), "#2d2d2d", 14.0),
        (rate, "#3d3d3d", 5.0),
    ):
        if step * cell < least_px:
            continue
        painter.setPen(QPen(QColor(color), 1))
        first = max(int((scale.position_at(0) - 1) // step), 0) * step + 1
        last = min(scale.position_at(size.width()), scale.length + 1)
        for frame in range(first, int(last) + 1, step):
            x = round(scale.x_of(frame)) + 0.5
            painter.drawLine(QLineF(x, 0, x, size.height()))
