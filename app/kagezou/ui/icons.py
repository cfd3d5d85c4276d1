"""The program's own icons: SVG files drawn in one grey, given their tones here and sharp at any screen scale."""

from functools import cache

from PySide6.QtCore import QByteArray, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFontMetrics, QIcon, QPainter, QPixmap
from PySide6.QtSvg import QSvgRenderer

from kagezou.locations import resource_folder
from kagezou.ui.theme import BRIGHT, OFF, TEXT

_DRAWN_IN = "#d0d0d0"
_SIZES = (16, 20, 24, 32, 48, 64)


@cache
def icon(name: str) -> QIcon:
    """Return an icon by its file's name."""
    text = (resource_folder() / "icons" / f"{name}.svg").read_text(encoding="utf-8")
    made = QIcon()
    for size in _SIZES:
        made.addPixmap(_drawn(text, TEXT, size), QIcon.Mode.Normal, QIcon.State.Off)
        made.addPixmap(_drawn(text, BRIGHT, size), QIcon.Mode.Active, QIcon.State.Off)
        made.addPixmap(_drawn(text, OFF, size), QIcon.Mode.Disabled, QIcon.State.Off)
        made.addPixmap(_drawn(text, BRIGHT, size), QIcon.Mode.Normal, QIcon.State.On)
    return made


def icon_size(metrics: QFontMetrics, *, small: bool = False) -> QSize:
    """Return the size of icons beside text of a font, so that they grow with it."""
    side = max(12 if small else 18, round(metrics.height() * (0.7 if small else 1.0)))
    return QSize(side, side)


def application_icon() -> QIcon:
    """Return the icon of the program itself."""
    text = (resource_folder() / "icons" / "kagezou.svg").read_text(encoding="utf-8")
    made = QIcon()
    for size in (16, 32, 48, 128, 256):
        made.addPixmap(_drawn(text, TEXT, size))
    return made


def _drawn(text: str, color: QColor, size: int) -> QPixmap:
    renderer = QSvgRenderer(QByteArray(text.replace(_DRAWN_IN, color.name()).encode()))
    pixmap = QPixmap(QSize(size, size))
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    renderer.render(painter, QRectF(0, 0, size, size))
    painter.end()
    return pixmap
