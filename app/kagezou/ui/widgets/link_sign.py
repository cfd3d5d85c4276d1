"""The sign of a link, wherever it is shown."""

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QPainter, QPen

from kagezou.ui.system.theme import BRIGHT, CHANGED, DIM


def paint_link_sign(painter: QPainter, middle: QPointF, *, linked: bool, hovered: bool = False) -> None:
    """Paint two links of a chain around a point: one through the other, or apart."""
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.translate(middle)
    painter.rotate(-45)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(QPen(BRIGHT if hovered else CHANGED if linked else DIM, 1.5))
    gap = -1.2 if linked else 1.4
    painter.drawRoundedRect(QRectF(gap, -2.2, 6, 4.4), 2.2, 2.2)
    painter.drawRoundedRect(QRectF(-6 - gap, -2.2, 6, 4.4), 2.2, 2.2)
    painter.restore()
