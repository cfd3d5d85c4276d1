"""The bar of a review: which note or flag is looked at, and what can be said to it."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QCheckBox, QHBoxLayout, QLabel, QPushButton, QSizePolicy, QToolButton, QWidget

from kagezou.ui.system.icons import icon


class ReviewBar(QWidget):
    """Hidden while nothing is reviewed.

    Attributes
    ----------
    previous, following, ticked, answer, add, leave
        Its controls; the tick stands for the note that is looked at.
    """

    tick_asked = Signal(bool)

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("set_bar")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.previous = self._step("key-previous", self.tr("Previous note or flag"))
        self.following = self._step("key-next", self.tr("Next note or flag"))
        self.place = QLabel()
        self.words = QLabel()
        self.words.setWordWrap(True)
        self.words.setTextFormat(Qt.TextFormat.PlainText)
        self.words.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self.ticked = QCheckBox(self.tr("Done"))
        self.ticked.clicked.connect(self.tick_asked)
        self.answer = _button(self.tr("Answer…"))
        self.add = _button(self.tr("Add Note…"))
        self.leave = _button(self.tr("Leave Review (Esc)"))
        row = QHBoxLayout(self)
        row.setContentsMargins(8, 4, 8, 4)
        row.setSpacing(8)
        for widget in (self.previous, self.following, self.place):
            row.addWidget(widget)
        row.addWidget(self.words, 1)
        row.addWidget(self.ticked)
        for button in (self.answer, self.add, self.leave):
            row.addWidget(button)
        self.hide()

    def show_remark(self, place: str, words: str, *, is_note: bool, is_done: bool) -> None:
        """Show what is looked at, and whether it can be answered."""
        self.place.setText(place)
        self.words.setText(words)
        self.words.setToolTip(words)
        self.ticked.setEnabled(is_note)
        self.answer.setEnabled(is_note)
        self.ticked.setChecked(is_done)

    def _step(self, name: str, words: str) -> QToolButton:
        button = QToolButton()
        button.setIcon(icon(name))
        button.setToolTip(words)
        button.setAccessibleName(words)
        return button


def _button(words: str) -> QPushButton:
    button = QPushButton(words)
    button.setObjectName("small_button")
    button.setAutoDefault(False)
    return button
