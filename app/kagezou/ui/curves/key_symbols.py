"""The shapes of keys on curves: they say how the value goes on, so that colour alone says nothing."""

from PySide6.QtCore import QRectF
from PySide6.QtGui import QPainterPath, QTransform

from kagezou.animation.track import Interpolation


def _hourglass() -> QPainterPath:
    path = QPainterPath()
    path.moveTo(-0.5, -0.5)
    for x, y in ((0.5, -0.5), (0.2, 0.0), (0.5, 0.5), (-0.5, 0.5), (-0.2, 0.0)):
        path.lineTo(x, y)
    path.closeSubpath()
    return path


def _square() -> QPainterPath:
    path = QPainterPath()
    path.addRect(QRectF(-0.42, -0.42, 0.84, 0.84))
    return path


def _diamond() -> QPainterPath:
    return QTransform().rotate(45).scale(0.84, 0.84).map(_square())


SYMBOLS = {
    Interpolation.HOLD: _square(),
    Interpolation.LINEAR: _diamond(),
    Interpolation.BEZIER: _hourglass(),
}
