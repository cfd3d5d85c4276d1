"""The picture that names what is seen on the canvas: the real viewport with words at its handles."""

from typing import Final

from PySide6.QtCore import QPoint, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QImage, QPainter, QPen

from dev_window import Pictured

_INK: Final = QColor("#FFFFFF")
_PLATE: Final = QColor(20, 22, 28, 215)
_LINE: Final = QColor("#FFD54A")
_LETTERS_PX: Final = 15
_PAD_PX: Final = 6
WORDS: Final[dict[str, tuple[str, str, QPoint]]] = {
    "light.sun": ("sun: turn and height", "太陽：向きと高さ", QPoint(40, 72)),
    "ground.position": ("ground position", "地面の位置", QPoint(-215, 20)),
    "ground.end": (
        "ground line; its end turns it (ground roll)",
        "接地ライン。端で回す（地面の回転）",
        QPoint(20, 38),
    ),
    "ground.declination": ("lever: declination", "つまみ：地面の角度", QPoint(-230, 5)),
    "tilt.lever": ("body tilt", "体の傾き", QPoint(-150, -10)),
    "foot": ("foot that carries", "支えている足（接地）", QPoint(150, -30)),
    "shadow.tip": ("tip of the shadow", "影の先端", QPoint(-205, -40)),
}
"""For each handle its words in English and Japanese, and where they stand beside it, px."""


def labelled(pictured: Pictured, code: str) -> QImage:
    """Return the viewport with its handles named, and the axes of the canvas at its corner."""
    pictured.go_to(16, 1.5)
    image = pictured.picture(pictured.parts.viewport)
    painter = QPainter(image)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    font = QFont(pictured.window.font())
    font.setPixelSize(_LETTERS_PX)
    painter.setFont(font)
    for name, (english, japanese, aside) in WORDS.items():
        place = _place(pictured, name)
        if place is not None:
            _label(painter, place, aside, japanese if code == "ja" else english)
    _axes(painter, pictured)
    painter.end()
    return image


def _place(pictured: Pictured, name: str) -> QPoint | None:
    handles = pictured.parts.viewport.controller.handles
    if name != "foot":
        return pictured.place(name) if handles.find(name) is not None else None
    found = [each.id for each in handles.handles if each.shape.value == "sole"]
    return pictured.place(found[0]) if found else None


def _label(painter: QPainter, place: QPoint, aside: QPoint, words: str) -> None:
    width = painter.fontMetrics().horizontalAdvance(words) + 2 * _PAD_PX
    height = painter.fontMetrics().height() + _PAD_PX
    corner = place + aside
    plate = QRectF(corner.x(), corner.y() - height / 2, width, height)
    painter.setPen(QPen(_LINE, 1.5))
    painter.drawLine(QPointF(place), QPointF(plate.left() if aside.x() > 0 else plate.right(), plate.center().y()))
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(_PLATE)
    painter.drawRoundedRect(plate, 4, 4)
    painter.setPen(_INK)
    painter.drawText(plate, Qt.AlignmentFlag.AlignCenter, words)


def _axes(painter: QPainter, pictured: Pictured) -> None:
    """Draw X and Y from the canvas' top left corner, and Z toward the viewer."""
    view = pictured.parts.viewport.viewpoint.view
    x, y = view.view_from_canvas((0.0, 0.0))
    origin = QPointF(x, y)
    painter.setPen(QPen(_LINE, 2))
    for end, beside, word in ((QPointF(70, 0), QPointF(-6, -6), "X"), (QPointF(0, 70), QPointF(-18, 4), "Y")):
        painter.drawLine(origin, origin + end)
        painter.drawText(origin + end + beside, word)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.drawEllipse(origin, 6, 6)
    painter.drawText(origin + QPointF(-20, -8), "Z")
