"""The shapes of keys: each half says how the value moves on that side, so that colour alone says nothing."""

from functools import cache

from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QPainterPath, QPolygonF

from kagezou.animation.track import Interpolation, Track

Half = Interpolation | None
"""How a value moves on one side of a key; None where there is no key on that side."""


def halves_of(track: Track, index: int) -> tuple[Half, Half]:
    """Return how a value reaches and leaves the key with this index."""
    before = track.keys[index - 1].interpolation if index else None
    after = track.keys[index].interpolation if index + 1 < len(track.keys) else None
    return before, after


@cache
def half_path(half: Half, *, is_left: bool, radius: float) -> QPainterPath:
    """Return one half of a key around (0, 0): a diamond's, an hourglass's for beziers, a square's for holds."""
    side = -radius if is_left else radius
    path = QPainterPath()
    match half:
        case Interpolation.HOLD:
            inner = radius * 0.82
            path.addRect(QRectF(min(side * 0.82, 0), -inner, inner, 2 * inner))
        case Interpolation.BEZIER:
            waist = side * 0.4
            outline = [(0, -radius), (side, -radius), (waist, 0), (side, radius), (0, radius)]
            path.addPolygon(QPolygonF([QPointF(x, y) for x, y in outline]))
        case _:
            path.addPolygon(QPolygonF([QPointF(0, -radius), QPointF(side, 0), QPointF(0, radius)]))
    path.closeSubpath()
    return path
