"""The cards of the welcome page: a project of before, and a look to begin with."""

from datetime import datetime
from pathlib import Path

from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QImage, QPainter, QPainterPath, QPaintEvent, QPixmap, QResizeEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QSizePolicy, QVBoxLayout, QWidget

from kagezou.ui.system.theme import WELL

_ROUND_PX = 4.0


class CardPicture(QWidget):
    """A picture with round corners, sharp on any screen; a dark well while there is none.

    Parameters
    ----------
    size
        Its size, logical px.
    """

    def __init__(self, size: QSize) -> None:
        super().__init__()
        self.setFixedSize(size)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._pixmap = QPixmap()

    @property
    def is_empty(self) -> bool:
        """Whether there is nothing to see yet."""
        return self._pixmap.isNull()

    def show_picture(self, picture: QPixmap) -> None:
        """Show a picture."""
        self._pixmap = picture
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHints(QPainter.RenderHint.Antialiasing | QPainter.RenderHint.SmoothPixmapTransform)
        path = QPainterPath()
        path.addRoundedRect(QRectF(self.rect()), _ROUND_PX, _ROUND_PX)
        painter.setClipPath(path)
        painter.fillPath(path, WELL)
        if not self._pixmap.isNull():
            painter.drawPixmap(self.rect(), self._pixmap)
        painter.end()


class WelcomeCard(QPushButton):
    """A button that is as large as what lies in it.

    Parameters
    ----------
    words
        What it is called where it cannot be seen.
    """

    def __init__(self, words: str) -> None:
        super().__init__()
        self.setObjectName("welcome_card")
        self.setAccessibleName(words)
        self.setCursor(Qt.CursorShape.PointingHandCursor)

    def sizeHint(self) -> QSize:
        layout = self.layout()
        return layout.sizeHint() if layout is not None else super().sizeHint()

    def minimumSizeHint(self) -> QSize:
        layout = self.layout()
        return layout.minimumSize() if layout is not None else super().minimumSizeHint()


class RecentCard(WelcomeCard):
    """A project of before: its picture, name, folder and when it was last saved."""

    def __init__(self, path: Path) -> None:
        super().__init__(path.stem)
        self.path = path
        self.setToolTip(str(path))
        letter = self.fontMetrics().height()
        self.picture = CardPicture(QSize(round(5.4 * letter), round(5.4 * letter * 9 / 16)))
        name = _label(path.stem, "welcome_name")
        self._folder = _label("", "welcome_hint")
        self._folder.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        when = _label(_when(path), "welcome_hint")
        words = QVBoxLayout()
        words.setSpacing(0)
        for label in (name, self._folder, when):
            words.addWidget(label)
        row = QHBoxLayout(self)
        row.setContentsMargins(7, 6, 9, 6)
        row.setSpacing(11)
        row.addWidget(self.picture)
        row.addLayout(words, 1)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        room = self.width() - self.picture.width() - 28
        shown = short(self.path.parent)
        self._folder.setText(self.fontMetrics().elidedText(shown, Qt.TextElideMode.ElideMiddle, room))

    def show_picture(self, image: QImage) -> None:
        """Show what the project looks like."""
        self.picture.show_picture(QPixmap.fromImage(image))


class StyleCard(WelcomeCard):
    """A look: chosen or not.

    Parameters
    ----------
    name
        What people read.
    picture
        The file of its picture.
    """

    def __init__(self, name: str, picture: Path) -> None:
        super().__init__(name)
        self.setCheckable(True)
        self.setToolTip(name)
        letter = self.fontMetrics().averageCharWidth()
        shown = CardPicture(QSize(12 * letter, round(12 * letter * 2 / 3)))
        shown.show_picture(QPixmap(str(picture)))
        label = _label(name, "welcome_hint")
        label.setAlignment(Qt.AlignmentFlag.AlignHCenter)
        label.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        column = QVBoxLayout(self)
        column.setContentsMargins(6, 6, 6, 4)
        column.setSpacing(4)
        column.addWidget(shown)
        column.addWidget(label)


def short(folder: Path) -> str:
    """Return a folder as people write it."""
    home = Path.home()
    return f"~/{folder.relative_to(home).as_posix()}" if folder.is_relative_to(home) else str(folder)


def _when(path: Path) -> str:
    try:
        seconds = path.stat().st_mtime
    except OSError:
        return ""
    return f"{datetime.fromtimestamp(seconds).astimezone():%Y-%m-%d %H:%M}"


def _label(text: str, name: str) -> QLabel:
    label = QLabel(text)
    label.setObjectName(name)
    label.setTextFormat(Qt.TextFormat.PlainText)
    label.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
    return label
