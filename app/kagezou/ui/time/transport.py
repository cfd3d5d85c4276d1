"""The strip under the picture: the buttons of playback, the frame and the rate."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QKeyEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QLineEdit, QToolButton, QWidget

from kagezou.animation.timecode import parse_frame, rate_text, sheet_text
from kagezou.document.frame_numbers import number_of
from kagezou.errors import UsageProblem
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.icons import icon_size
from kagezou.ui.system.menu_words import plain
from kagezou.ui.system.words import translated
from kagezou.ui.time.playback import Player


class FrameField(QLineEdit):
    """The frame as a number to read and to type: ``84``, ``3+12``, ``+6``."""

    def __init__(self, bridge: Bridge) -> None:
        super().__init__()
        self._bridge = bridge
        self.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.setAccessibleName(self.tr("Frame"))
        self.setToolTip(self.tr("Frame; type 84, 3+12 (seconds + frames) or +6"))
        self.setFixedWidth(self.fontMetrics().horizontalAdvance("0000000") + 16)
        self.editingFinished.connect(self._accept)
        bridge.frame_changed.connect(self._show)
        bridge.session_replaced.connect(self._show)
        bridge.document_changed.connect(self._follow)
        self._show()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self._show()
            self.clearFocus()
            return
        super().keyPressEvent(event)

    def _accept(self) -> None:
        canvas = self._bridge.document.canvas
        try:
            frame = parse_frame(self.text(), self._bridge.frame, canvas.frame_rate, canvas.first_frame)
        except UsageProblem as problem:
            self.setToolTip(translated(problem))
            frame = self._bridge.frame
        self._bridge.session.go_to(frame)
        self._show()
        if self.hasFocus():
            self.clearFocus()

    def _follow(self) -> None:
        """Show the number that the frame bears now; what is being typed stays."""
        if not self.isModified():
            self._show()

    def _show(self) -> None:
        self.setText(str(number_of(self._bridge.document.canvas, self._bridge.frame)))


class Transport(QWidget):
    """Playback buttons, frame field, length, and ``rate``: the one that is really reached; a click asks for another."""

    def __init__(self, bridge: Bridge, player: Player, actions: list[QAction | None]) -> None:
        super().__init__()
        self.setObjectName("transport")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self._bridge = bridge
        self._player = player
        self.frame_field = FrameField(bridge)
        self._position = QLabel()
        self.rate = QToolButton()
        self.rate.setAccessibleName(self.tr("Frames a second"))
        self.rate.setToolTip(self.tr("Frames a second; a click opens the settings of the cut"))
        self.rate.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.rate.setMinimumWidth(self.fontMetrics().horizontalAdvance("000.0 / 000.00 fps ") + 8)
        self._lay_out(actions)
        bridge.frame_changed.connect(self._show_position)
        bridge.document_changed.connect(self._show_position)
        bridge.session_replaced.connect(self._show_rate_wanted)
        player.rate_measured.connect(self._show_rate)
        player.playing_changed.connect(self._show_rate_wanted)
        bridge.document_changed.connect(self._show_new_rate)
        self._shown_rate = bridge.document.canvas.frame_rate
        self._show_position()
        self._show_rate_wanted()

    def ask_frame(self) -> None:
        """Let a frame be typed."""
        self.frame_field.setFocus(Qt.FocusReason.ShortcutFocusReason)
        self.frame_field.selectAll()

    def _lay_out(self, actions: list[QAction | None]) -> None:
        row = QHBoxLayout(self)
        row.setContentsMargins(8, 3, 8, 4)
        row.setSpacing(2)
        row.addWidget(self.frame_field)
        row.addSpacing(6)
        row.addWidget(self._position)
        row.addStretch(1)
        for action in actions:
            if action is None:
                row.addSpacing(8)
            else:
                row.addWidget(_button(action))
        row.addStretch(1)
        row.addWidget(self.rate)

    def _show_position(self) -> None:
        canvas = self._bridge.document.canvas
        here = sheet_text(self._bridge.frame, canvas.frame_rate)
        whole = sheet_text(canvas.length_frames, canvas.frame_rate)
        last = number_of(canvas, canvas.length_frames)
        self._position.setText(f"/ {last}    {here} / {whole}")

    def _show_new_rate(self) -> None:
        rate = self._bridge.document.canvas.frame_rate
        if rate != self._shown_rate:
            self._shown_rate = rate
            self._show_rate_wanted()

    def _show_rate_wanted(self) -> None:
        self.rate.setText(f"{self._wanted} fps")

    def _show_rate(self, frames_per_second: float) -> None:
        kept = frames_per_second >= 0.97 * float(self._bridge.document.canvas.frame_rate)
        # The word says it too: colour alone does not reach everyone.
        note = "" if kept else " " + self.tr("(slow)")
        self.rate.setText(f"{frames_per_second:.1f} / {self._wanted} fps{note}")

    @property
    def _wanted(self) -> str:
        return rate_text(self._bridge.document.canvas.frame_rate)


def _button(action: QAction) -> QToolButton:
    button = QToolButton()
    button.setDefaultAction(action)
    button.setIconSize(icon_size(button.fontMetrics()))
    button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
    button.setAccessibleName(plain(action.text()))
    return button
