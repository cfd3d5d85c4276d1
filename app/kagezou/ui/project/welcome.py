"""What an empty window shows: where to begin."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QImage
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QScrollArea,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from kagezou.document.style import Style
from kagezou.io.clips.style_files import StyleFile, bundled_styles
from kagezou.ui.project.recent_pictures import ProjectPictures
from kagezou.ui.project.welcome_cards import RecentCard, StyleCard
from kagezou.ui.system.icons import application_icon, icon
from kagezou.ui.system.words import named
from kagezou.ui.widgets.retiring import retire

_LETTERS_WIDE = 118
_MOST_RECENT = 5


class Welcome(QScrollArea):
    """A place to drop cels on, the ways to begin, the projects of before, and looks to begin with.

    Parameters
    ----------
    picture_folder
        Where pictures of projects are kept.
    """

    cels_asked = Signal()
    open_asked = Signal()
    demo_asked = Signal()
    guide_asked = Signal()
    recent_asked = Signal(Path)

    def __init__(self, picture_folder: Path) -> None:
        super().__init__()
        self.setObjectName("welcome")
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.pictures = ProjectPictures(picture_folder)
        self.pictures.made.connect(self._show_picture)
        self.cards: list[RecentCard] = []
        self.looks: list[tuple[StyleCard, StyleFile]] = []
        self._recent = QVBoxLayout()
        self._recent.setSpacing(2)
        self._drop = QFrame()
        self._drop_words = QLabel(self.tr("Drop a folder of cels here"))
        self._guide = _button(self.tr("New here? A guided first cut in five steps"), self.guide_asked.emit)
        self._lay_out()
        self.show_recent([])

    @property
    def style_chosen(self) -> Style | None:
        """The look to begin with, if one is chosen."""
        return next((file.style for card, file in self.looks if card.isChecked()), None)

    def forget_style(self) -> None:
        """Choose no look any more."""
        self._choose(None)

    def show_recent(self, projects: list[Path]) -> None:
        """List the projects of before that are still there."""
        there = [path for path in projects if path.is_file()][:_MOST_RECENT]
        if [card.path for card in self.cards] != there or not there:
            items = iter(lambda: self._recent.takeAt(0), None)
            retire([old for item in items if (old := item.widget()) is not None])
            self.cards = [RecentCard(path) for path in there]
            for card in self.cards:
                card.clicked.connect(lambda _checked, path=card.path: self.recent_asked.emit(path))
                self._recent.addWidget(card)
            if not there:
                self._recent.addWidget(_hint(self.tr("Projects that you save or open are listed here.")))
        self.pictures.ask(there)

    def show_hovered(self, words: str | None) -> None:
        """Light the drop area up while something is held over the window, and say what will become of it."""
        self._drop_words.setText(words or self.tr("Drop a folder of cels here"))
        self._drop.setProperty("hovered", words is not None)
        self._drop.style().unpolish(self._drop)
        self._drop.style().polish(self._drop)

    def offer_demo(self, *, offered: bool) -> None:
        """Show or hide the way to the demo."""
        self._demo.setVisible(offered)
        self._guide.setVisible(offered)

    def _lay_out(self) -> None:
        begin = QVBoxLayout()
        begin.setSpacing(10)
        begin.addWidget(self._drop_area(), 1)
        begin.addLayout(self._buttons())
        recent = QVBoxLayout()
        recent.setSpacing(6)
        recent.addWidget(_heading(self.tr("Recent projects")))
        recent.addLayout(self._recent)
        recent.addStretch(1)
        recent.addWidget(self._guide)
        columns = QHBoxLayout()
        columns.setSpacing(32)
        columns.addLayout(begin, 11)
        columns.addLayout(recent, 10)
        page = QWidget()
        page.setObjectName("welcome_page")
        middle = QWidget()
        middle.setMaximumWidth(_LETTERS_WIDE * self.fontMetrics().averageCharWidth())
        middle.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        column = QVBoxLayout(middle)
        column.setSpacing(22)
        column.addStretch(2)
        column.addLayout(self._title())
        column.addLayout(columns)
        column.addLayout(self._looks())
        column.addStretch(3)
        row = QHBoxLayout(page)
        row.setContentsMargins(24, 8, 24, 8)
        row.addStretch(1)
        row.addWidget(middle, 100)
        row.addStretch(1)
        self.setWidget(page)

    def _title(self) -> QHBoxLayout:
        picture = QLabel()
        picture.setPixmap(application_icon().pixmap(QSize(52, 52), self.devicePixelRatioF()))
        title = QLabel("Kagezou")
        title.setObjectName("welcome_title")
        words = QVBoxLayout()
        words.setSpacing(0)
        words.addWidget(title)
        words.addWidget(_hint(self.tr("Cast shadows for drawn animation")))
        row = QHBoxLayout()
        row.setSpacing(16)
        row.addWidget(picture)
        row.addLayout(words)
        row.addStretch(1)
        return row

    def _drop_area(self) -> QFrame:
        self._drop.setObjectName("welcome_drop")
        picture = QLabel()
        picture.setPixmap(icon("cels").pixmap(QSize(36, 36), self.devicePixelRatioF()))
        picture.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._drop_words.setObjectName("welcome_name")
        self._drop_words.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._drop_words.setWordWrap(True)
        hint = _hint(self.tr("Numbered images with transparency, one folder a character; or a .kage project"))
        hint.setAlignment(Qt.AlignmentFlag.AlignCenter)
        column = QVBoxLayout(self._drop)
        column.setContentsMargins(24, 22, 24, 22)
        column.setSpacing(8)
        column.addStretch(1)
        for widget in (picture, self._drop_words, hint):
            column.addWidget(widget)
        column.addStretch(1)
        return self._drop

    def _buttons(self) -> QHBoxLayout:
        self._demo = _button(self.tr("Open the demo"), self.demo_asked.emit)
        row = QHBoxLayout()
        row.setSpacing(8)
        row.addWidget(_button(self.tr("Choose cels…"), self.cels_asked.emit))
        row.addWidget(_button(self.tr("Open a project…"), self.open_asked.emit))
        row.addWidget(self._demo)
        return row

    def _looks(self) -> QVBoxLayout:
        row = QHBoxLayout()
        row.setSpacing(6)
        for file in bundled_styles():
            card = StyleCard(named(file.style.name), file.path.parent / "pictures" / f"{file.path.stem}.png")
            card.clicked.connect(lambda on, chosen=card: self._choose(chosen if on else None))
            self.looks.append((card, file))
            row.addWidget(card)
        row.addStretch(1)
        column = QVBoxLayout()
        column.setSpacing(6)
        column.addWidget(_heading(self.tr("Begin with a style")))
        column.addWidget(_hint(self.tr("The next character gets it; the Styles panel changes it at any time.")))
        column.addLayout(row)
        return column

    def _choose(self, chosen: StyleCard | None) -> None:
        for card, _ in self.looks:
            card.setChecked(card is chosen)

    def _show_picture(self, path: Path, image: QImage) -> None:
        for card in self.cards:
            if card.path == path:
                card.show_picture(image)


def _heading(text: str) -> QLabel:
    label = QLabel(text)
    label.setObjectName("sheet_heading")
    # With a style of its own a label would step in by half a letter.
    label.setIndent(0)
    return label


def _hint(text: str) -> QLabel:
    label = QLabel(text)
    label.setObjectName("welcome_hint")
    label.setWordWrap(True)
    return label


def _button(words: str, do: Callable[[], None]) -> QPushButton:
    button = QPushButton(words)
    button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
    button.clicked.connect(lambda _checked: do())
    return button
