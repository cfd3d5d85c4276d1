"""The program's own icons: SVG files drawn in one grey, given their tones here, and sharp at any size and scale."""

from functools import cache

from PySide6.QtCore import QByteArray, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFontMetrics, QIcon, QIconEngine, QPainter, QPixmap
from PySide6.QtSvg import QSvgRenderer

from kagezou.locations import resource_folder
from kagezou.ui.system.theme import BRIGHT, OFF, TEXT

_DRAWN_IN = "#d0d0d0"


class SvgIcon(QIconEngine):
    """Draws an icon anew at the size that is asked for, never a scaled picture of another size.

    Parameters
    ----------
    text
        The SVG.
    """

    def __init__(self, text: str) -> None:
        super().__init__()
        self._text = text
        self._drawn: dict[tuple[int, int, str], QPixmap] = {}

    def paint(self, painter: QPainter, rect: QRect, mode: QIcon.Mode, state: QIcon.State) -> None:
        _renderer(self._text, _tone(mode, state)).render(painter, QRectF(rect))

    def pixmap(self, size: QSize, mode: QIcon.Mode, state: QIcon.State) -> QPixmap:
        return self.scaledPixmap(size, mode, state, 1.0)

    def scaledPixmap(self, size: QSize, mode: QIcon.Mode, state: QIcon.State, scale: float) -> QPixmap:
        wide, high = round(size.width() * scale), round(size.height() * scale)
        key = (wide, high, _tone(mode, state).name())
        if key not in self._drawn:
            self._drawn[key] = _drawn(self._text, _tone(mode, state), QSize(wide, high))
        pixmap = QPixmap(self._drawn[key])
        pixmap.setDevicePixelRatio(scale)
        return pixmap

    def clone(self) -> QIconEngine:
        return SvgIcon(self._text)


@cache
def icon(name: str) -> QIcon:
    """Return an icon by its file's name."""
    return QIcon(SvgIcon((resource_folder() / "icons" / f"{name}.svg").read_text(encoding="utf-8")))


@cache
def kind_icon(kind: str) -> QIcon:
    """Return the picture of a kind of set piece."""
    is_drawn = (resource_folder() / "icons" / f"{kind}.svg").is_file()
    return icon(kind if is_drawn else "box")


def icon_size(metrics: QFontMetrics, *, small: bool = False) -> QSize:
    """Return the size of icons beside text of a font, so that they grow with it."""
    side = max(12 if small else 18, round(metrics.height() * (0.7 if small else 1.0)))
    return QSize(side, side)


def application_icon() -> QIcon:
    """Return the icon of the program itself; the system wants it as pictures."""
    text = (resource_folder() / "icons" / "kagezou.svg").read_text(encoding="utf-8")
    made = QIcon()
    for size in (16, 32, 48, 128, 256):
        made.addPixmap(_drawn(text, TEXT, QSize(size, size)))
    return made


def _tone(mode: QIcon.Mode, state: QIcon.State) -> QColor:
    if mode is QIcon.Mode.Disabled:
        return OFF
    return BRIGHT if mode is QIcon.Mode.Active or state is QIcon.State.On else TEXT


def _renderer(text: str, color: QColor) -> QSvgRenderer:
    return _renderer_in(text, color.name())


@cache
def _renderer_in(text: str, color: str) -> QSvgRenderer:
    # Lists paint their icons anew with every painting, and reading one takes longer than drawing it.
    return QSvgRenderer(QByteArray(text.replace(_DRAWN_IN, color).encode()))


def _drawn(text: str, color: QColor, size: QSize) -> QPixmap:
    pixmap = QPixmap(size)
    if size.isEmpty():
        # A bar that has no room yet asks for nothing.
        return pixmap
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    _renderer(text, color).render(painter, QRectF(0, 0, size.width(), size.height()))
    painter.end()
    return pixmap
