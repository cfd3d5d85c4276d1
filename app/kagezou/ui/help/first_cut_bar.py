"""The bar of the guided first cut: what to do now, and how far one is."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QSizePolicy, QWidget

from kagezou.ui.help.first_cut import STEPS, FirstCut
from kagezou.ui.system.icons import icon, icon_size


class FirstCutBar(QWidget):
    """Stands over the picture, never on it; hidden while nobody is guided.

    Parameters
    ----------
    guide
        The steps.

    Attributes
    ----------
    guide
        The same.
    show_me, skip, leave
        Its buttons.
    """

    def __init__(self, guide: FirstCut) -> None:
        super().__init__()
        self.setObjectName("set_bar")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.guide = guide
        self._marks = [QLabel() for _ in STEPS]
        self._words = QLabel()
        self._words.setObjectName("set_name")
        self._words.setWordWrap(True)
        self._words.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self.show_me, self.skip = _button(self.tr("Show Me")), _button(self.tr("Skip"))
        self.leave = _button("")
        row = QHBoxLayout(self)
        row.setContentsMargins(12, 6, 8, 6)
        row.setSpacing(8)
        marks = QHBoxLayout()
        marks.setSpacing(3)
        for mark in self._marks:
            marks.addWidget(mark)
        row.addLayout(marks)
        row.addWidget(self._words, 1)
        for button in (self.show_me, self.skip, self.leave):
            row.addWidget(button)
        guide.changed.connect(self._show)
        self._show()

    @property
    def text(self) -> str:
        """What it says now."""
        return self._words.text()

    def _show(self) -> None:
        number, step = self.guide.number, self.guide.step
        self.setVisible(number is not None)
        if number is None:
            return
        size = icon_size(self.fontMetrics(), small=True)
        for place, mark in enumerate(self._marks):
            name = "check" if place < number else "key" if place == number else "dot"
            mark.setPixmap(icon(name).pixmap(size, self.devicePixelRatioF()))
        done = self.tr("Step %1 of %2").replace("%1", str(min(number + 1, len(STEPS)))).replace("%2", str(len(STEPS)))
        self.setAccessibleName(done)
        self._words.setText(self.guide.words)
        self.show_me.setVisible(step is not None and bool(step.about))
        self.skip.setVisible(step is not None)
        self.leave.setText(self.tr("Leave") if step is not None else self.tr("Close"))


def _button(words: str) -> QPushButton:
    button = QPushButton(words)
    button.setObjectName("small_button")
    button.setAutoDefault(False)
    return button
