"""Drawing a corner of a room on the picture: the ground line first, then the line on which a wall stands.

While it is on, the hand is at rest: this sheet takes the pointer, says what to do now, and paints the line.
"""

from dataclasses import dataclass
from enum import StrEnum

from PySide6.QtCore import QEvent, QObject, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QColor, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPen, QTabletEvent

from kagezou.document.model import Document
from kagezou.errors import Problem
from kagezou.geometry.sets.measures import PieceKind
from kagezou.geometry.vectors import Point2
from kagezou.session.session import Gesture
from kagezou.tools.corner import drawing, ground_line, is_on_ground, wall_line
from kagezou.tools.drag import Drag
from kagezou.tools.handle import GuideKind
from kagezou.tools.handles import handles_of
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.theme import SELECTED
from kagezou.ui.system.words import choice_name, translated
from kagezou.ui.viewport.handle_paths import paint_guide
from kagezou.ui.viewport.picture_widget import PictureWidget
from kagezou.ui.viewport.pointer_report import Device, PointerReport, report_of
from kagezou.ui.viewport.sheets import OverlaySheet
from kagezou.ui.widgets.space_bar import SpaceBar

_PILL, _PILL_EDGE, _PILL_TEXT = QColor(16, 16, 16, 235), QColor(255, 255, 255, 46), QColor("#f4f4f4")
_SHADE = QColor(0, 0, 0, 150)
_SHOWN = (
    GuideKind.GROUND_LINE,
    GuideKind.GROUND_OUTLINE,
    GuideKind.PIECE_EDGE,
    GuideKind.PIECE_OTHER,
    GuideKind.PIECE_FLOOR,
)
_PRESSES = (QEvent.Type.MouseButtonPress, QEvent.Type.MouseButtonDblClick, QEvent.Type.TabletPress)
_MOVES = (QEvent.Type.MouseMove, QEvent.Type.TabletMove)
_RELEASES = (QEvent.Type.MouseButtonRelease, QEvent.Type.TabletRelease)


class CornerStroke(StrEnum):
    """What is drawn next."""

    GROUND = "ground"
    WALL = "wall"


@dataclass(slots=True)
class _Line:
    """A line in the hand, from ``start`` to ``end`` in canvas px, and the document that is shown for it."""

    drag: Drag
    gesture: Gesture
    start: Point2
    end: Point2
    shown: Document


class CornerSheet(OverlaySheet):
    """Takes strokes while it is on; each is one step of history.

    Parameters
    ----------
    viewport
        What it covers.
    bridge
        The session worked in.
    space
        The space bar: held, a drag pans as ever.
    """

    turned = Signal()
    """It went on, or off."""
    refused = Signal(str)
    """One sentence on why nothing was drawn."""

    def __init__(self, viewport: PictureWidget, bridge: Bridge, space: SpaceBar) -> None:
        super().__init__(viewport, viewport.viewpoint)
        self._viewport = viewport
        self._bridge = bridge
        self._space = space
        self._line: _Line | None = None
        self.stroke: CornerStroke | None = None
        bridge.session_replaced.connect(self._drop)
        bridge.document_changed.connect(self.update)

    @property
    def is_on(self) -> bool:
        """Whether something is to be drawn."""
        return self.stroke is not None

    @property
    def hint(self) -> str:
        """What to do now."""
        if self.stroke is CornerStroke.GROUND:
            return self.tr("Drag along the line the figure stands on  ·  Enter: the ground is right  ·  Esc: leave")
        return self.tr("Drag along the foot of the wall  ·  Esc: leave")

    def begin(self, stroke: CornerStroke) -> None:
        """Ask for a stroke; the ground line is followed by the wall's."""
        self._turn(stroke)
        self._viewport.setFocus(Qt.FocusReason.OtherFocusReason)

    def leave(self) -> None:
        """Give the pointer back to the hand; what is half drawn is not kept."""
        self._end(keep=False)
        self._turn(None)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if self.is_on and watched is self._viewport and self._takes(event):
            return True
        return super().eventFilter(watched, event)

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        bridge, view = self._bridge, self._viewpoint.view
        newest = bridge.document.pieces[-1].id if bridge.document.pieces else None
        for guide in handles_of(bridge.document, bridge.frame, None, view, newest).guides:
            if guide.kind in _SHOWN:
                paint_guide(painter, guide, view, QRectF(self.rect()))
        if self._line is not None:
            self._paint_line(painter, self._line)
        self._paint_hint(painter)
        painter.end()

    def _takes(self, event: QEvent) -> bool:
        """Answer an event, and return whether nobody else should."""
        kind = event.type()
        if isinstance(event, QKeyEvent):
            return kind is QEvent.Type.KeyPress and self._press_key(event.key())
        if not isinstance(event, QMouseEvent | QTabletEvent):
            return False
        report = report_of(event, Device.PEN if isinstance(event, QTabletEvent) else Device.MOUSE)
        if kind in _PRESSES and event.button() is Qt.MouseButton.RightButton:
            self._step_back()
            return True
        if self._line is None and (self._space.is_held or event.buttons() & Qt.MouseButton.MiddleButton):
            return False
        if kind in _PRESSES and event.button() is Qt.MouseButton.LeftButton:
            self._press(report)
        elif kind in _MOVES and self._line is not None:
            self._move(self._line, report)
        elif kind in _RELEASES and event.button() is Qt.MouseButton.LeftButton:
            self._end(keep=True)
        event.accept()
        return kind in _PRESSES or kind in _RELEASES or kind in _MOVES

    def _press_key(self, key: int) -> bool:
        if key == Qt.Key.Key_Escape:
            self._step_back()
            return True
        if key in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and self._line is None and self.stroke is CornerStroke.GROUND:
            self._turn(CornerStroke.WALL)
            return True
        return False

    def _step_back(self) -> None:
        """Drop the line in the hand; without one leave."""
        if self._line is not None:
            self._end(keep=False)
        else:
            self.leave()

    def _press(self, report: PointerReport) -> None:
        bridge, pointer = self._bridge, report.pointer(self._viewpoint.view)
        document, frame = bridge.document, bridge.frame
        if self.stroke is CornerStroke.GROUND:
            name, lay = self.tr("Draw ground line"), ground_line(document, frame)
        elif is_on_ground(document, frame, pointer.canvas_px):
            name, lay = self.tr("Draw wall"), wall_line(document, frame, bridge.layer_id, choice_name(PieceKind.WALL))
        else:
            self.refused.emit(self.tr("There is no ground here for a wall to stand on: begin below the horizon."))
            return
        drag = drawing(document, lay)
        drag.send(pointer)
        self._line = _Line(drag, bridge.session.begin(name), pointer.canvas_px, pointer.canvas_px, document)

    def _move(self, line: _Line, report: PointerReport) -> None:
        pointer = report.pointer(self._viewpoint.view)
        try:
            line.shown = line.drag.send(pointer)
        except Problem as problem:
            self._end(keep=False)
            self.refused.emit(translated(problem))
            return
        line.gesture.show(line.shown)
        line.end = pointer.canvas_px
        self.update()

    def _end(self, *, keep: bool) -> None:
        line, self._line = self._line, None
        if line is None:
            return
        session = self._bridge.session
        line.drag.close()
        # History may have been gone through with the line still in the hand.
        is_drawn = keep and line.shown is not line.gesture.start and session.document is line.shown
        if is_drawn and self.stroke is CornerStroke.WALL:
            session.select_piece(session.document.pieces[-1].id)
        line.gesture.commit() if is_drawn else line.gesture.cancel()
        if is_drawn:
            self._turn(CornerStroke.WALL if self.stroke is CornerStroke.GROUND else None)
        self.update()

    def _turn(self, stroke: CornerStroke | None) -> None:
        before, self.stroke = self.is_on, stroke
        self.setVisible(self.is_on)
        self._viewport.setCursor(Qt.CursorShape.CrossCursor if self.is_on else Qt.CursorShape.ArrowCursor)
        self.raise_()
        self.update()
        if self.is_on != before:
            self.turned.emit()

    def _drop(self) -> None:
        """Forget a session that was put away."""
        self._line = None
        self._turn(None)

    def _paint_line(self, painter: QPainter, line: _Line) -> None:
        start, end = (QPointF(*self._viewpoint.view.view_from_canvas(point)) for point in (line.start, line.end))
        for pen in (QPen(_SHADE, 4.0), QPen(SELECTED, 2.0)):
            painter.setPen(pen)
            painter.drawLine(start, end)
        painter.setPen(QPen(_SHADE, 1.0))
        painter.setBrush(SELECTED)
        for point in (start, end):
            painter.drawEllipse(point, 4.0, 4.0)

    def _paint_hint(self, painter: QPainter) -> None:
        metrics, words = self.fontMetrics(), self.hint
        wide = min(metrics.horizontalAdvance(words) + 32.0, self.width() - 16.0)
        room = QRectF(0, 0, wide - 24, self.height())
        flags = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
        text = painter.boundingRect(room, flags, words)
        pill = QRectF((self.width() - wide) / 2, 14, wide, text.height() + 14)
        painter.setPen(QPen(_PILL_EDGE, 1))
        painter.setBrush(_PILL)
        painter.drawRoundedRect(pill, min(pill.height() / 2, 16.0), min(pill.height() / 2, 16.0))
        painter.setPen(_PILL_TEXT)
        painter.drawText(pill, flags, words)
