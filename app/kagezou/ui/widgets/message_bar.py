"""The bar over the picture that says what is wrong without standing in the way."""

from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum

from PySide6.QtCore import QSize, Qt, QTimer
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QSizePolicy, QToolButton, QWidget

from kagezou.ui.system.icons import icon

NOTE_SHOWN_MS = 6000


class Severity(StrEnum):
    """How much a message weighs, the lightest first."""

    NOTE = "note"
    """Goes by itself."""
    WARNING = "warning"
    ERROR = "error"


@dataclass(frozen=True, slots=True)
class Offer:
    """What can be done about a message.

    Parameters
    ----------
    words
        On the button.
    do
        What it does.
    """

    words: str
    do: Callable[[], object]


@dataclass(frozen=True, slots=True)
class _Message:
    text: str
    severity: Severity
    offers: tuple[Offer, ...] = ()


class MessageBar(QWidget):
    """Shows the latest of the gravest messages that stand; hidden while there is none."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("message_bar")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self._messages: dict[str, _Message] = {}
        self._text = QLabel()
        self._text.setWordWrap(True)
        self._text.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self._text.setTextFormat(Qt.TextFormat.PlainText)
        self._text.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self._count = QLabel()
        self._sign = QLabel()
        self._offers = QHBoxLayout()
        self.offered: list[QPushButton] = []
        """The buttons of the message that is shown."""
        self._going = QTimer(self)
        self._going.setSingleShot(True)
        self._going.timeout.connect(self._drop_notes)
        self._lay_out()
        self.hide()

    @property
    def text(self) -> str:
        """What is shown now, empty if nothing is."""
        return self._messages[self._foremost].text if self._messages else ""

    def say(self, key: str, text: str, severity: Severity = Severity.ERROR, offers: tuple[Offer, ...] = ()) -> None:
        """Show a message, with a button for each offer; it takes the place of the one with the same key."""
        self._messages.pop(key, None)
        self._messages[key] = _Message(text, severity, offers)
        if severity is Severity.NOTE:
            self._going.start(NOTE_SHOWN_MS)
        self._show_foremost()

    def withdraw(self, key: str) -> None:
        """Take a message away because its cause is gone."""
        if self._messages.pop(key, None) is not None:
            self._show_foremost()

    def clear(self) -> None:
        """Take every message away."""
        self._messages.clear()
        self._show_foremost()

    @property
    def _foremost(self) -> str:
        """The key of the latest among the gravest messages."""
        weights = list(Severity)
        return max(reversed(self._messages), key=lambda key: weights.index(self._messages[key].severity))

    def _lay_out(self) -> None:
        close = QToolButton()
        close.setIcon(icon("close"))
        close.setToolTip(self.tr("Dismiss"))
        close.setAccessibleName(self.tr("Dismiss"))
        close.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        close.clicked.connect(self._dismiss)
        row = QHBoxLayout(self)
        row.setContentsMargins(10, 3, 6, 3)
        row.setSpacing(8)
        row.addWidget(self._sign)
        row.addWidget(self._text, 1)
        row.addLayout(self._offers)
        row.addWidget(self._count)
        row.addWidget(close)

    def _dismiss(self) -> None:
        if self._messages:
            del self._messages[self._foremost]
        self._show_foremost()

    def _show_offers(self, offers: tuple[Offer, ...]) -> None:
        for button in self.offered:
            self._offers.removeWidget(button)
            button.hide()
            # Not at once: it may be the one that was just pressed.
            button.deleteLater()
        self.offered = []
        for offer in offers:
            button = QPushButton(offer.words)
            button.setObjectName("small_button")
            button.clicked.connect(lambda _=False, do=offer.do: do())
            self._offers.addWidget(button)
            self.offered.append(button)

    def _drop_notes(self) -> None:
        self._messages = {key: m for key, m in self._messages.items() if m.severity is not Severity.NOTE}
        self._show_foremost()

    def _show_foremost(self) -> None:
        if self._messages:
            foremost = self._messages[self._foremost]
            self._text.setText(foremost.text)
            self._show_offers(foremost.offers)
            sign = "info" if foremost.severity is Severity.NOTE else "warning"
            self._sign.setPixmap(icon(sign).pixmap(QSize(16, 16)))
            more = len(self._messages) - 1
            self._count.setText(self.tr("and %n more", "", more) if more else "")
            self.setProperty("severity", foremost.severity.value)
            self.style().unpolish(self)
            self.style().polish(self)
        self.setVisible(bool(self._messages))
