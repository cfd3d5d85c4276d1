"""What an empty window shows: where to begin."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QPushButton, QSizePolicy, QVBoxLayout, QWidget

from kagezou.ui.icons import application_icon, icon

_WIDTH_PX = 560


class Welcome(QWidget):
    """A place to drop cels on, the ways to begin, and the projects of before."""

    cels_asked = Signal()
    open_asked = Signal()
    demo_asked = Signal()
    recent_asked = Signal(Path)

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("welcome")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self._recent = QVBoxLayout()
        self._recent.setSpacing(0)
        self._drop = QFrame()
        column = QVBoxLayout()
        column.setSpacing(18)
        column.addStretch(2)
        column.addLayout(self._title())
        column.addWidget(self._drop_area())
        column.addLayout(self._buttons())
        column.addLayout(self._recent)
        column.addStretch(3)
        row = QHBoxLayout(self)
        row.addStretch(1)
        middle = QWidget()
        middle.setMaximumWidth(_WIDTH_PX)
        middle.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        middle.setLayout(column)
        row.addWidget(middle, 10)
        row.addStretch(1)

    def show_recent(self, projects: list[Path]) -> None:
        """List the projects of before that are still there."""
        while (item := self._recent.takeAt(0)) is not None:
            if (old := item.widget()) is not None:
                old.deleteLater()
        there = [path for path in projects if path.is_file()][:5]
        if there:
            heading = QLabel(self.tr("Recent projects"))
            heading.setObjectName("welcome_hint")
            self._recent.addWidget(heading)
        for path in there:
            self._recent.addWidget(self._recent_button(path))

    def show_hovered(self, *, hovered: bool) -> None:
        """Light the drop area up while something is held over the window."""
        self._drop.setProperty("hovered", hovered)
        self._drop.style().unpolish(self._drop)
        self._drop.style().polish(self._drop)

    def offer_demo(self, *, offered: bool) -> None:
        """Show or hide the way to the demo."""
        self._demo.setVisible(offered)

    def _title(self) -> QHBoxLayout:
        picture = QLabel()
        picture.setPixmap(application_icon().pixmap(QSize(52, 52)))
        title = QLabel("Kagezou")
        title.setObjectName("welcome_title")
        under = QLabel(self.tr("Cast shadows for drawn animation"))
        under.setObjectName("welcome_hint")
        words = QVBoxLayout()
        words.setSpacing(0)
        words.addWidget(title)
        words.addWidget(under)
        row = QHBoxLayout()
        row.setSpacing(16)
        row.addStretch(1)
        row.addWidget(picture)
        row.addLayout(words)
        row.addStretch(1)
        return row

    def _drop_area(self) -> QFrame:
        self._drop.setObjectName("welcome_drop")
        picture = QLabel()
        picture.setPixmap(icon("cels").pixmap(QSize(32, 32)))
        picture.setAlignment(Qt.AlignmentFlag.AlignCenter)
        words = QLabel(self.tr("Drop a folder of cels here"))
        words.setAlignment(Qt.AlignmentFlag.AlignCenter)
        hint = QLabel(self.tr("Numbered images with transparency, one folder a character; or a .kage project"))
        hint.setObjectName("welcome_hint")
        hint.setAlignment(Qt.AlignmentFlag.AlignCenter)
        hint.setWordWrap(True)
        column = QVBoxLayout(self._drop)
        column.setContentsMargins(24, 26, 24, 26)
        column.setSpacing(8)
        for widget in (picture, words, hint):
            column.addWidget(widget)
        return self._drop

    def _buttons(self) -> QHBoxLayout:
        self._demo = _button(self.tr("Open the demo"), self.demo_asked.emit)
        row = QHBoxLayout()
        row.setSpacing(10)
        row.addWidget(_button(self.tr("Choose cels…"), self.cels_asked.emit))
        row.addWidget(_button(self.tr("Open a project…"), self.open_asked.emit))
        row.addWidget(self._demo)
        return row

    def _recent_button(self, path: Path) -> QPushButton:
        button = QPushButton(f"{path.stem}    {_short(path.parent)}")
        button.setObjectName("welcome_recent")
        button.setToolTip(str(path))
        button.setCursor(Qt.CursorShape.PointingHandCursor)
        button.clicked.connect(lambda: self.recent_asked.emit(path))
        return button


def _short(folder: Path) -> str:
    home = Path.home()
    return f"~/{folder.relative_to(home).as_posix()}" if folder.is_relative_to(home) else str(folder)


def _button(words: str, do: Callable[[], None]) -> QPushButton:
    button = QPushButton(words)
    button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
    button.clicked.connect(lambda _checked: do())
    return button
