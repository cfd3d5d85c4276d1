"""The bar over the picture that settles an imported set: its camera, its up axis, where one stands, how large it is."""

from collections.abc import Sequence
from enum import StrEnum

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QLabel, QPushButton, QToolButton, QVBoxLayout, QWidget

from kagezou.ui.system.icons import icon
from kagezou.ui.widgets.scrub_field import ScrubField

KEEP_VIEW = -1
"""The choice of no camera."""

_LEAST, _MOST = 0.001, 100000.0


class Measure(StrEnum):
    """The unit of a length."""

    HEIGHTS = "heights"
    METRES = "metres"


class SetBar(QWidget):
    """Shows choices and sends what is chosen; what they mean is decided elsewhere. Hidden until there is a set."""

    camera_chosen = Signal(int)
    """A camera of the file by its number, or KEEP_VIEW."""
    up_chosen = Signal(str)
    standing = Signal(bool)
    """Whether the next click says where one stands."""
    sizing = Signal(bool)
    """Whether the next two clicks mark a length."""
    length_entered = Signal(float, str)
    """The marked length, and in which Measure."""
    closed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("set_bar")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self._name = QLabel()
        self._name.setObjectName("set_name")
        self._name.setTextFormat(Qt.TextFormat.PlainText)
        self.camera = QComboBox()
        self.up = QComboBox()
        self.stand = self._switch(
            self.tr("Stand On…"), self.tr("Click the place of the set on which a character stands")
        )
        self.size_by_points = self._switch("", "")
        self.length = ScrubField(step=0.01, decimals=3)
        self.measure = QComboBox()
        self._length_row = QWidget()
        self._hint = QLabel()
        self._hint.setObjectName("set_hint")
        self._make_choices()
        self._lay_out()
        self._connect()
        self.hide()

    @property
    def hint(self) -> str:
        """What it says now."""
        return self._hint.text()

    def show_set(self, name: str, cameras: Sequence[str], camera: int, up: str) -> None:
        """Show a set and what is chosen for it."""
        with QSignalBlocker(self.camera), QSignalBlocker(self.up):
            self._name.setText(name)
            self.camera.clear()
            for number, words in enumerate(cameras):
                self.camera.addItem(words, number)
            self.camera.addItem(self.tr("Keep this view") if cameras else self.tr("None in the file"), KEEP_VIEW)
            self.camera.setCurrentIndex(self.camera.findData(camera))
            self.camera.setEnabled(bool(cameras))
            self.up.setCurrentIndex(self.up.findData(up))
        self.size_by_points.setEnabled(camera == KEEP_VIEW)
        self.size_by_points.setToolTip(
            self.tr("Click two points of the set, then say how long that is")
            if camera == KEEP_VIEW
            else self.tr("The camera of the file settles the size")
        )
        self.show()

    def show_length(self, *, shown: bool) -> None:
        """Ask how long what was marked is, or no longer."""
        self._length_row.setVisible(shown)
        if shown:
            self.say("")
            self.length.set_value(1.0)
            self.length.setFocus()

    def say(self, words: str) -> None:
        """Say what to click now, or what came of it; nothing for an empty text."""
        self._hint.setText(words)
        self._hint.setVisible(bool(words))

    def hold(self, switch: QPushButton) -> None:
        """Keep one of the switches down."""
        with QSignalBlocker(switch):
            switch.setChecked(True)

    def release(self) -> None:
        """Let both switches up."""
        for switch in (self.stand, self.size_by_points):
            with QSignalBlocker(switch):
                switch.setChecked(False)

    def _make_choices(self) -> None:
        self.size_by_points.setText(self.tr("Size by Two Points…"))
        for axis in ("y", "z"):
            self.up.addItem(axis.upper(), axis)
        self.camera.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToContents)
        self.camera.setToolTip(self.tr("The camera of the file that the picture is seen with"))
        self.up.setToolTip(self.tr("Which axis of the file points up"))
        self.length.set_range(_LEAST, _MOST)
        self.length.setFixedWidth(10 * self.fontMetrics().horizontalAdvance("0"))
        self.measure.addItem(self.tr("figure heights"), Measure.HEIGHTS.value)
        self.measure.addItem(self.tr("metres (a figure has 1.6)"), Measure.METRES.value)

    def _switch(self, words: str, tip: str) -> QPushButton:
        made = QPushButton(words)
        made.setObjectName("small_button")
        made.setCheckable(True)
        made.setToolTip(tip)
        return made

    def _lay_out(self) -> None:
        close = QToolButton()
        close.setIcon(icon("close"))
        close.setToolTip(self.tr("Done"))
        close.setAccessibleName(self.tr("Done"))
        close.clicked.connect(self.closed)
        row = QHBoxLayout()
        row.setSpacing(8)
        row.addWidget(self._name)
        row.addSpacing(10)
        for words, field in ((self.tr("Camera"), self.camera), (self.tr("Up"), self.up)):
            label = QLabel(words)
            label.setBuddy(field)
            field.setAccessibleName(words)
            row.addWidget(label)
            row.addWidget(field)
            row.addSpacing(6)
        row.addWidget(self.stand)
        row.addWidget(self.size_by_points)
        row.addStretch(1)
        row.addWidget(close)
        below = QHBoxLayout(self._length_row)
        below.setContentsMargins(0, 0, 0, 0)
        below.setSpacing(8)
        question = self.tr("Between the two points there are")
        self.length.setAccessibleName(question)
        self._enter = QPushButton(self.tr("Set Size"))
        self._enter.setObjectName("small_button")
        for part in (QLabel(question), self.length, self.measure, self._enter):
            below.addWidget(part)
        below.addStretch(1)
        self._length_row.hide()
        self._hint.hide()
        column = QVBoxLayout(self)
        column.setContentsMargins(10, 5, 6, 5)
        column.setSpacing(5)
        column.addLayout(row)
        column.addWidget(self._length_row)
        column.addWidget(self._hint)

    def _connect(self) -> None:
        self.camera.activated.connect(lambda _: self.camera_chosen.emit(self.camera.currentData()))
        self.up.activated.connect(lambda _: self.up_chosen.emit(self.up.currentData()))
        self.stand.toggled.connect(self.standing)
        self.size_by_points.toggled.connect(self.sizing)
        for change in (self.length.dragged, self.length.entered):
            change.connect(self.length.set_value)
        self._enter.clicked.connect(lambda: self.length_entered.emit(self.length.value, self.measure.currentData()))
