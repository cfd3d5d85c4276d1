"""The names beside the lanes: folds, values, and the key navigator of each property."""

from enum import StrEnum

from PySide6.QtCore import QEvent, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QHelpEvent, QMouseEvent, QPainter, QPaintEvent, QPen, QPolygonF, QWheelEvent
from PySide6.QtWidgets import QToolTip, QWidget

from kagezou.animation.track import Value
from kagezou.document.address import path_of, track_of, value_of
from kagezou.document.edits import remove_key, set_key
from kagezou.document.key_edits import all_keys
from kagezou.document.linking import is_linked
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.missing import NOTHING_MISSING, Missing, missing_words
from kagezou.ui.system.shown_units import ShownUnit, shown_unit
from kagezou.ui.system.theme import BRIGHT, CHROME, DIM, LINE, SELECTED, TEXT
from kagezou.ui.system.words import choice_name, translated
from kagezou.ui.timeline.row_list import RowList
from kagezou.ui.timeline.row_signs import paint_label, paint_signs, row_name
from kagezou.ui.timeline.rows import RowKind, TimelineRow, frames_of
from kagezou.ui.widgets.link_sign import paint_link_sign

_BUTTON_PX = 16
_INDENT_PX = 14
_DIAMOND_PX = 4.6
_CHAIN_PX = 18
_GROUP = QColor("#333333")
_CHOSEN = QColor("#464646")


class Spot(StrEnum):
    """What can be clicked in a row."""

    FOLD = "fold"
    NAME = "name"
    PREVIOUS = "previous"
    KEY = "key"
    NEXT = "next"


class RowNames(QWidget):
    """One line a row; the diamond tells none, elsewhere and here apart by its shape."""

    def __init__(self, bridge: Bridge, rows: RowList) -> None:
        super().__init__()
        self._bridge = bridge
        self._rows = rows
        self._missing = NOTHING_MISSING
        self.setAccessibleName(self.tr("Layers and properties"))
        for signal in (rows.changed, rows.values_changed, bridge.frame_settled, bridge.keys_changed):
            signal.connect(self.update)
        bridge.selection_changed.connect(self.update)

    def spot_at(self, place: QPointF) -> tuple[TimelineRow, Spot] | None:
        """Return the row and the part of it at a point."""
        index = self._rows.index_at(place.y())
        if index is None:
            return None
        row = self._rows.rows[index]
        if row.is_group and place.x() < _INDENT_PX + 8:
            return row, Spot.FOLD
        from_right = self.width() - place.x()
        for number, spot in enumerate((Spot.NEXT, Spot.KEY, Spot.PREVIOUS)):
            if number * _BUTTON_PX <= from_right - 4 < (number + 1) * _BUTTON_PX and (row.addresses or number != 1):
                return row, spot
        return row, Spot.NAME

    def mousePressEvent(self, event: QMouseEvent) -> None:
        found = self.spot_at(event.position())
        if found is None or event.button() is not Qt.MouseButton.LeftButton:
            return
        row, spot = found
        match spot:
            case Spot.FOLD if event.modifiers() & Qt.KeyboardModifier.AltModifier:
                self._rows.fold_all(row)
            case Spot.FOLD:
                self._rows.fold(row)
            case Spot.NAME:
                self._choose(row)
            case Spot.KEY:
                self._toggle_key(row)
            case Spot.PREVIOUS | Spot.NEXT:
                self._go_to_key(row, ahead=spot is Spot.NEXT)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        found = self.spot_at(event.position())
        if found is not None and found[1] is Spot.NAME and found[0].is_group:
            self._rows.fold(found[0])
        else:
            self.mousePressEvent(event)

    def wheelEvent(self, event: QWheelEvent) -> None:
        self._rows.scroll_to(round(self._rows.scroll_px - event.angleDelta().y() / 120 * 3 * self._rows.row_px))
        event.accept()

    def event(self, event: QEvent) -> bool:
        if event.type() is QEvent.Type.ToolTip and isinstance(event, QHelpEvent):
            found = self.spot_at(QPointF(event.pos()))
            QToolTip.showText(event.globalPos(), self._words(*found) if found else "", self)
            return True
        return super().event(event)

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), CHROME)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        for index in self._rows.seen():
            self._paint_row(painter, self._rows.rows[index], self._rows.top_of(index))
        painter.setPen(QPen(LINE, 1))
        painter.drawLine(self.width() - 1, 0, self.width() - 1, self.height())
        painter.end()

    def name_of(self, row: TimelineRow) -> str:
        """Return what a row is called."""
        return row_name(self._bridge.document, row)

    def show_missing(self, missing: Missing) -> None:
        """Mark the layers whose files are not all there."""
        self._missing = missing
        self.update()

    def _paint_row(self, painter: QPainter, row: TimelineRow, top: int) -> None:
        height = self._rows.row_px
        if row.is_group:
            is_chosen = row.is_about(self._bridge.layer_ids, self._bridge.piece_id)
            painter.fillRect(QRectF(0, top, self.width(), height), _CHOSEN if is_chosen else _GROUP)
        painter.setPen(QPen(LINE, 1))
        painter.drawLine(0, top + height - 1, self.width(), top + height - 1)
        left = _INDENT_PX + 8 if row.is_group else 2 * _INDENT_PX + 6
        room: float = self.width() - left - 3 * _BUTTON_PX - 8
        if row.is_group:
            self._paint_fold(painter, row, QPointF(_INDENT_PX, top + height / 2))
            room -= self._paint_marks(painter, row, QRectF(0, top, self.width(), height), left + room)
        elif row.addresses:
            if is_linked(self._bridge.document, row.addresses[0]):
                room -= _CHAIN_PX
                paint_link_sign(painter, QPointF(left + room + _CHAIN_PX / 2, top + (height - 1) / 2), linked=True)
            room -= self._paint_value(painter, row, top, left, room)
        painter.setPen(BRIGHT if row.is_group else TEXT)
        name = self.fontMetrics().elidedText(self.name_of(row), Qt.TextElideMode.ElideMiddle, int(room))
        painter.drawText(QRectF(left, top, room, height - 1), Qt.AlignmentFlag.AlignVCenter, name)
        if row.addresses:
            self._paint_navigator(painter, row, top + (height - 1) / 2)

    def _paint_marks(self, painter: QPainter, row: TimelineRow, area: QRectF, right: float) -> float:
        """Paint what is marked on a layer; return the room that it takes of its name."""
        if row.kind is not RowKind.LAYER or row.layer_id is None:
            return 0.0
        marks, is_missing = self._bridge.document.layer(row.layer_id).marks, row.layer_id in self._missing
        paint_label(painter, marks, area)
        return paint_signs(painter, marks, is_missing=is_missing, right=right, row=area)

    def _paint_fold(self, painter: QPainter, row: TimelineRow, middle: QPointF) -> None:
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(TEXT)
        down, right = [(-4, -2.5), (4, -2.5), (0, 3)], [(-2.5, -4), (-2.5, 4), (3, 0)]
        points = [middle + QPointF(x, y) for x, y in (down if row.is_open else right)]
        painter.drawPolygon(QPolygonF(points))

    def _paint_value(self, painter: QPainter, row: TimelineRow, top: int, left: float, room: float) -> float:
        address = row.addresses[0]
        words = _short(value_of(self._bridge.document, address, self._bridge.frame), shown_unit(address.property))
        metrics = self.fontMetrics()
        width = float(metrics.horizontalAdvance(words) + 8)
        if width + metrics.horizontalAdvance(self.name_of(row)) > room:
            # The name says which row it is; the value is in the inspector too.
            return 0.0
        painter.setPen(DIM)
        place = QRectF(left + room - width, top, width - 4, self._rows.row_px - 1)
        painter.drawText(place, Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignRight, words)
        return width

    def _paint_navigator(self, painter: QPainter, row: TimelineRow, y: float) -> None:
        frames = frames_of(self._bridge.document, row)
        here = self._bridge.frame
        x = self.width() - 4 - _BUTTON_PX / 2
        for middle, exists, way in (
            (x - 2 * _BUTTON_PX, any(frame < here for frame in frames), -1),
            (x, any(frame > here for frame in frames), 1),
        ):
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(TEXT if exists else DIM)
            tip = [
                QPointF(middle + way * 3.5, y),
                QPointF(middle - way * 2.5, y - 4),
                QPointF(middle - way * 2.5, y + 4),
            ]
            painter.drawPolygon(QPolygonF(tip))
        part = frames.get(here, 0) / len(row.addresses)
        _paint_diamond(painter, QPointF(x - _BUTTON_PX, y), part if frames else None)

    def _choose(self, row: TimelineRow) -> None:
        session = self._bridge.session
        if row.layer_id is not None:
            session.select(row.layer_id, () if row.is_group else row.addresses)
        elif row.piece_id is not None:
            session.select_piece(row.piece_id, () if row.is_group else row.addresses)
        document = self._bridge.document
        session.select_keys(frozenset().union(*(all_keys(document, address) for address in row.addresses)))

    def _toggle_key(self, row: TimelineRow) -> None:
        session, frame = self._bridge.session, self._bridge.frame
        document = session.document
        keyed = [address for address in row.addresses if track_of(document, address).key_at(frame)]
        for address in keyed if len(keyed) == len(row.addresses) else row.addresses:
            if len(keyed) == len(row.addresses):
                document = remove_key(document, address, frame)
            elif address not in keyed:
                document = set_key(document, address, frame, value_of(document, address, frame))
        session.edit(self.tr("Remove key") if len(keyed) == len(row.addresses) else self.tr("Set key"), document)

    def _go_to_key(self, row: TimelineRow, *, ahead: bool) -> None:
        here = self._bridge.frame
        frames = [frame for frame in frames_of(self._bridge.document, row) if (frame > here) == ahead and frame != here]
        if frames:
            self._bridge.session.go_to(min(frames) if ahead else max(frames))

    def _words(self, row: TimelineRow, spot: Spot) -> str:
        match spot:
            case Spot.FOLD:
                return self.tr("Show or hide the properties (Alt: of all)")
            case Spot.PREVIOUS:
                return self.tr("Previous key of this row")
            case Spot.NEXT:
                return self.tr("Next key of this row")
            case Spot.KEY:
                return self.tr("Set a key on this frame, or remove the one that is here")
            case Spot.NAME if row.kind is RowKind.PROPERTY:
                address = row.addresses[0]
                linked = is_linked(self._bridge.document, address)
                same = f"\n{self.tr('The same for all characters')}" if linked else ""
                return f"{translated(address.property.help)}\n{path_of(self._bridge.document, address)}{same}"
            case Spot.NAME:
                lost = self._missing.get(row.layer_id or "")
                words = self.tr("%1 missing files in", "then a folder")
                return self.name_of(row) if lost is None else missing_words(lost, words)


def _paint_diamond(painter: QPainter, middle: QPointF, part: float | None) -> None:
    """Paint the diamond: full with ``part`` of the properties keyed here, dotted with some, hollow without keys."""
    painter.setPen(QPen(SELECTED if part else DIM if part is None else TEXT, 1.3))
    painter.setBrush(SELECTED if part == 1 else Qt.BrushStyle.NoBrush)
    painter.drawPolygon(_diamond(middle, _DIAMOND_PX))
    if part is not None and part < 1:
        painter.setBrush(SELECTED if part else DIM)
        painter.drawPolygon(_diamond(middle, _DIAMOND_PX / 3))


def _diamond(middle: QPointF, radius: float) -> QPolygonF:
    across, up = QPointF(radius, 0), QPointF(0, radius)
    return QPolygonF([middle - up, middle + across, middle + up, middle - across])


def _short(value: Value, shown: ShownUnit) -> str:
    match value:
        case bool():
            return "✓" if value else "–"
        case str():
            return value if value.startswith("#") else choice_name(value)
        case float():
            return f"{value * shown.factor:.4g}{shown.behind() if shown.unit in ('°', '%') else ''}"
        case tuple() if value and isinstance(value[0], tuple):
            return f"{len(value)} pt"
        case _:
            return ", ".join(f"{part:.0f}" for part in value if isinstance(part, float)) or "–"
