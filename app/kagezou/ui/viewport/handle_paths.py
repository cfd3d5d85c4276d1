"""The outlines of handles and guides on screen: constant in size, told apart by shape, readable on any picture."""

from collections.abc import Callable, Iterable, Mapping
from math import cos, pi, sin
from types import MappingProxyType
from typing import Final

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen, QPolygonF

from kagezou.geometry.vectors import Point2
from kagezou.tools.handle import Cursor, Guide, GuideKind, Handle, HandleShape, OffView
from kagezou.tools.view import CanvasView
from kagezou.ui.system.theme import SELECTED

_Outline = Callable[[float, Cursor], QPainterPath]
"""From a radius in logical px and the cursor over the handle to its outline."""

RADIUS_PX = 5.0
HOVER_GROWS_PX = 2.0

_FILL = QColor("#ffffff")
_DARK = QColor(20, 20, 20, 235)
_OUTER = QColor(255, 255, 255, 150)
_SHADE = QColor(0, 0, 0, 100)
_FAINT, _CLEAR, _STRONG, _OPAQUE = 90, 165, 220, 255

_GUIDES: dict[GuideKind, tuple[int, Qt.PenStyle]] = {
    GuideKind.GROUND_LINE: (_CLEAR, Qt.PenStyle.SolidLine),
    GuideKind.GROUND_OUTLINE: (_FAINT, Qt.PenStyle.SolidLine),
    GuideKind.DECLINATION: (_CLEAR, Qt.PenStyle.SolidLine),
    GuideKind.LAMP_TO_FOOT: (_CLEAR, Qt.PenStyle.DashLine),
    GuideKind.FOOT_TO_CONTACT: (_FAINT, Qt.PenStyle.DashLine),
    GuideKind.OVERHEAD_AREA: (_CLEAR, Qt.PenStyle.DashLine),
    GuideKind.SUN_DIAL: (_FAINT, Qt.PenStyle.SolidLine),
    GuideKind.SUN_RAY: (_CLEAR, Qt.PenStyle.DashLine),
    GuideKind.TILT_ARC: (_FAINT, Qt.PenStyle.SolidLine),
    GuideKind.TILT_ARM: (_CLEAR, Qt.PenStyle.SolidLine),
    GuideKind.CARD_FOOT: (_STRONG, Qt.PenStyle.SolidLine),
    GuideKind.SHADOW_RAY: (_FAINT, Qt.PenStyle.DotLine),
    GuideKind.FILTER_DISTANCE: (_CLEAR, Qt.PenStyle.DashLine),
    GuideKind.WAVE: (_STRONG, Qt.PenStyle.SolidLine),
    GuideKind.PIECE_EDGE: (_STRONG, Qt.PenStyle.SolidLine),
    GuideKind.PIECE_HIDDEN: (_CLEAR, Qt.PenStyle.DashLine),
    GuideKind.PIECE_TOUCHED: (_STRONG, Qt.PenStyle.SolidLine),
    GuideKind.PIECE_OTHER: (_FAINT, Qt.PenStyle.SolidLine),
    GuideKind.PIECE_FLOOR: (_CLEAR, Qt.PenStyle.SolidLine),
    GuideKind.PIECE_ARM: (_CLEAR, Qt.PenStyle.SolidLine),
    GuideKind.LEAN_ARM: (_STRONG, Qt.PenStyle.SolidLine),
    GuideKind.LEAN_ARC: (_FAINT, Qt.PenStyle.SolidLine),
    GuideKind.FLOOR_FIRST: (_OPAQUE, Qt.PenStyle.SolidLine),
    GuideKind.FLOOR_SECOND: (_OPAQUE, Qt.PenStyle.DashLine),
    GuideKind.FLOOR_RAY: (_FAINT, Qt.PenStyle.DotLine),
    GuideKind.HORIZON: (_STRONG, Qt.PenStyle.DashDotLine),
    GuideKind.FOOT_HEIGHT: (_STRONG, Qt.PenStyle.DotLine),
    GuideKind.CEL_FRAME: (_STRONG, Qt.PenStyle.DashLine),
}

_TONES = {
    GuideKind.FLOOR_FIRST: (QColor("#E69F00"), 2.0),
    GuideKind.FLOOR_SECOND: (QColor("#56B4E9"), 2.0),
    GuideKind.PIECE_EDGE: (SELECTED, 1.2),
    GuideKind.PIECE_HIDDEN: (SELECTED, 1.2),
}
"""Colour and width of guides that come in kinds, which their dashes tell apart too; all others are white and thin."""

_SHADES = {GuideKind.PIECE_OTHER: 50}
"""How dark the line under a guide is, of those that are always there: many of them lie on each other."""

_EXPLAINING: dict[GuideKind, tuple[str, ...]] = {
    GuideKind.GROUND_OUTLINE: ("ground.", "light."),
    GuideKind.SHADOW_RAY: ("shadow.",),
    GuideKind.TILT_ARC: ("tilt.",),
    GuideKind.LEAN_ARC: ("piece.lean",),
}
"""Guides that only stand in the way until one of their handles is touched, by the beginnings of those handles' ids."""


def is_wanted(kind: GuideKind, active_ids: Iterable[str | None]) -> bool:
    """Whether a guide is worth showing while these handles are hovered, held or selected."""
    handles = _EXPLAINING.get(kind)
    return handles is None or any(each is not None and each.startswith(handles) for each in active_ids)


def handle_path(shape: HandleShape, radius: float, cursor: Cursor) -> QPainterPath:
    """Return the outline of a handle around the origin; logical px."""
    return _OUTLINES[shape](radius, cursor)


def _round(wide: float, high: float, *, inner: float = 0.0) -> _Outline:
    """Return what draws an ellipse, perhaps with another one in it, all as parts of the radius."""

    def outline(radius: float, _cursor: Cursor) -> QPainterPath:
        path = QPainterPath()
        path.addEllipse(QPointF(0, 0), radius * wide, radius * high)
        if inner:
            path.addEllipse(QPointF(0, 0), radius * inner, radius * inner)
        return path

    return outline


def _pointed(points: int, outer: float, inner: float) -> _Outline:
    return lambda radius, _cursor: _closed(_star(points, radius * outer, radius * inner))


def _square(radius: float, _cursor: Cursor) -> QPainterPath:
    side = radius * 0.95
    path = QPainterPath()
    path.addRect(QRectF(-side, -side, 2 * side, 2 * side))
    return path


def _lever(radius: float, cursor: Cursor) -> QPainterPath:
    wide, high = (radius * 1.5, radius * 0.85) if cursor is Cursor.HORIZONTAL else (radius * 0.85, radius * 1.5)
    path = QPainterPath()
    path.addRoundedRect(QRectF(-wide, -high, 2 * wide, 2 * high), radius * 0.8, radius * 0.8)
    return path


def _diamond(radius: float, _cursor: Cursor) -> QPainterPath:
    return _closed(QPolygonF([QPointF(x * radius * 1.3, y * radius * 1.3) for x, y in _COMPASS]))


def _sole(*, planted: bool) -> _Outline:
    """Return what draws a wedge that stands on the place: filled over a line where it carries, else hollow."""

    def outline(radius: float, _cursor: Cursor) -> QPainterPath:
        path = _wedge(radius, 0.0)
        if not planted:
            return path.subtracted(_wedge(radius, 0.45))
        line = QPainterPath()
        line.addRect(QRectF(-radius * 1.5, radius * 0.1, radius * 3.0, radius * 0.5))
        return path.united(line)

    return outline


def _wedge(radius: float, inset: float) -> QPainterPath:
    corners = ((-1.1 + inset, -1.9 + inset * 0.5), (1.1 - inset, -1.9 + inset * 0.5), (0.0, -inset * 1.4))
    return _closed(QPolygonF([QPointF(x * radius, y * radius) for x, y in corners]))


def _level_bar(radius: float, _cursor: Cursor) -> QPainterPath:
    path = QPainterPath()
    path.addRect(QRectF(-radius * 1.6, -radius * 0.3, radius * 3.2, radius * 0.6))
    return path


def _closed(polygon: QPolygonF) -> QPainterPath:
    path = QPainterPath()
    path.addPolygon(polygon)
    path.closeSubpath()
    return path


def paint_handle(painter: QPainter, handle: Handle, at: Point2, *, hovered: bool, selected: bool) -> None:
    """Paint a handle at a place of the view."""
    path = handle_path(handle.shape, RADIUS_PX + (HOVER_GROWS_PX if hovered else 0), handle.cursor)
    painter.save()
    painter.translate(*at)
    if handle.shape is HandleShape.SUN_DISC:
        _paint_rays(painter, RADIUS_PX + (HOVER_GROWS_PX if hovered else 0), SELECTED if selected else _FILL)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.strokePath(path, QPen(_OUTER, 4.0))
    painter.strokePath(path, QPen(_DARK, 2.2))
    painter.fillPath(path, SELECTED if selected else _FILL)
    painter.restore()


def paint_off_view_arrow(painter: QPainter, off: OffView, *, selected: bool) -> None:
    """Paint the arrow toward a handle that lies outside the view."""
    (x, y), (dx, dy) = off.view_px, off.direction
    tip = QPointF(x + dx * 17, y + dy * 17)
    base = QPointF(x + dx * 10, y + dy * 10)
    side = QPointF(-dy * 5, dx * 5)
    path = QPainterPath()
    path.addPolygon(QPolygonF([tip, base + side, base - side]))
    path.closeSubpath()
    painter.strokePath(path, QPen(_DARK, 2.2))
    painter.fillPath(path, SELECTED if selected else _FILL)


def paint_guide(painter: QPainter, guide: Guide, view: CanvasView, area: QRectF) -> None:
    """Paint a guide where it is seen; ``area`` is the viewport, logical px."""
    alpha, style = _GUIDES[guide.kind]
    known, width = _TONES.get(guide.kind, (_FILL, 1.0))
    tone = QColor(known)
    tone.setAlpha(alpha)
    points = [view.view_from_canvas(point) for point in guide.points]
    ends = [*points[1:], points[0]] if guide.closed else points[1:]
    room = area.adjusted(-8, -8, 8, 8)
    # Guides may run far beyond the screen, where dashing them would take for ever.
    lines = [line for a, b in zip(points, ends, strict=False) if (line := clipped(a, b, room))]
    shade = QColor(_SHADE)
    shade.setAlpha(_SHADES.get(guide.kind, _SHADE.alpha()))
    for pen in (QPen(shade, width + 1.6), QPen(tone, width, style)):
        pen.setCapStyle(Qt.PenCapStyle.FlatCap)
        painter.setPen(pen)
        for a, b in lines:
            painter.drawLine(QPointF(*a), QPointF(*b))


def clipped(start: Point2, end: Point2, room: QRectF) -> tuple[Point2, Point2] | None:
    """Return the part of a segment within a rectangle, None where there is none (Liang and Barsky)."""
    enter, leave = 0.0, 1.0
    way = (end[0] - start[0], end[1] - start[1])
    for axis, low, high in ((0, room.left(), room.right()), (1, room.top(), room.bottom())):
        if way[axis] == 0:
            if not low <= start[axis] <= high:
                return None
            continue
        first, second = (low - start[axis]) / way[axis], (high - start[axis]) / way[axis]
        enter, leave = max(enter, min(first, second)), min(leave, max(first, second))
    if enter > leave:
        return None
    a, b = ((start[0] + part * way[0], start[1] + part * way[1]) for part in (enter, leave))
    return (a, b)


_COMPASS = ((0, -1), (1, 0), (0, 1), (-1, 0))


def _star(points: int, outer: float, inner: float) -> QPolygonF:
    turns = ((pi * step / points, outer if step % 2 == 0 else inner) for step in range(2 * points))
    return QPolygonF([QPointF(radius * sin(angle), -radius * cos(angle)) for angle, radius in turns])


def _cross(reach: float, half: float) -> QPainterPath:
    upright, level = QPainterPath(), QPainterPath()
    upright.addRect(QRectF(-half, -reach, 2 * half, 2 * reach))
    level.addRect(QRectF(-reach, -half, 2 * reach, 2 * half))
    return upright.united(level)


def _two_arrows(radius: float, *, upright: bool) -> QPainterPath:
    path = QPainterPath()
    for side in (-1, 1):
        corners = [(side * 0.35, -0.95), (side * 1.5, 0.0), (side * 0.35, 0.95)]
        turned = [(y, x) if upright else (x, y) for x, y in corners]
        path.addPolygon(QPolygonF([QPointF(x * radius, y * radius) for x, y in turned]))
        path.closeSubpath()
    return path


def _paint_rays(painter: QPainter, radius: float, tone: QColor) -> None:
    for pen in (QPen(_DARK, 3.2), QPen(tone, 1.5)):
        pen.setCapStyle(Qt.PenCapStyle.RoundCap)
        painter.setPen(pen)
        for step in range(8):
            x, y = sin(pi * step / 4), cos(pi * step / 4)
            inner, outer = radius * 1.75, radius * 2.35
            painter.drawLine(QPointF(x * inner, y * inner), QPointF(x * outer, y * outer))


_OUTLINES: Final[Mapping[HandleShape, _Outline]] = MappingProxyType({
    HandleShape.SUN_DISC: _round(1.1, 1.1),
    HandleShape.DIAL: _pointed(8, 1.5, 0.95),
    HandleShape.FOOT: _round(1.25, 0.75),
    HandleShape.CROSS: lambda radius, _cursor: _cross(radius * 1.3, radius * 0.42),
    HandleShape.SQUARE: _square,
    HandleShape.LEVER: _lever,
    HandleShape.DIAMOND: _diamond,
    HandleShape.ARROW: _pointed(3, 1.5, 0.75),
    HandleShape.PEG: _round(1.0, 1.0),
    HandleShape.GRIP: lambda radius, cursor: _two_arrows(radius, upright=cursor is Cursor.VERTICAL),
    HandleShape.RING: _round(1.2, 1.2, inner=0.55),
    HandleShape.SOLE: _sole(planted=True),
    HandleShape.SOLE_LIFTED: _sole(planted=False),
    HandleShape.GROUND_MARK: _level_bar,
    HandleShape.TURN: _round(0.85, 0.85, inner=0.4),
    HandleShape.ANCHOR: _pointed(4, 1.7, 0.55),
})  # fmt: skip
assert set(_OUTLINES) == set(HandleShape)
