"""The settings of the cut in one dialog, which says what comes of them before anything is changed."""

from dataclasses import replace
from typing import Final

from PySide6.QtCore import QCoreApplication, Qt, Signal
from PySide6.QtWidgets import (
    QButtonGroup,
    QComboBox,
    QDialog,
    QFormLayout,
    QLabel,
    QLineEdit,
    QPushButton,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from kagezou.animation.timecode import parse_frame, parse_rate, rate_text, sheet_text
from kagezou.document.cut_settings import ChangedCut, CutSettings, with_settings
from kagezou.document.frame_numbers import number_of
from kagezou.document.model import Document
from kagezou.document.refitting import Refit
from kagezou.document.slate import MAX_FIRST_FRAME, MAX_WORD_CHARACTERS, Slate
from kagezou.errors import UsageProblem
from kagezou.ui.project.canvas_sizes import SizeRow
from kagezou.ui.system.words import translated
from kagezou.ui.widgets.in_row import GAP_PX, in_row
from kagezou.ui.widgets.number_boxes import WholeNumberBox

RATES: Final = ("23.976", "24", "25", "29.97", "30", "12", "12.5", "15", "50", "59.94", "60")
_MOST_FRAMES: Final = 1_000_000
_SAID_LINES: Final = 9


class CutSettingsDialog(QDialog):
    """Shows the settings of a document and what another choice would do.

    Parameters
    ----------
    document
        The document; it is not changed.
    parent
        The window.
    """

    chosen = Signal(object)
    """A ChangedCut that the person agreed to."""

    def __init__(self, document: Document, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Cut Settings"))
        self._document = document
        self._changed: ChangedCut | None = None
        self.name, self.scene, self.cut = QLineEdit(), QLineEdit(), QLineEdit()
        self.size_row = SizeRow(document)
        self.refits = QButtonGroup(self)
        self.rate = QComboBox()
        self.length, self.seconds = WholeNumberBox(), QLineEdit()
        self.first, self.last = WholeNumberBox(), QLabel()
        self.says = QLabel()
        self.agree = QPushButton(self.tr("Change"))
        self._fill()
        self._lay_out()
        self._connect()
        self.refresh()

    @property
    def refit(self) -> Refit:
        """What becomes of the drawings."""
        return list(Refit)[self.refits.checkedId()]

    def settings(self) -> CutSettings:
        """Return what is chosen; UsageProblem where something typed is no setting."""
        width, height = self.size_row.size_px
        # A rate that only looks rounded stays as exact as it is.
        rate = self._document.canvas.frame_rate
        if self.rate.currentText().strip() != rate_text(rate):
            rate = parse_rate(self.rate.currentText())
        canvas = replace(
            self._document.canvas,
            width_px=width,
            height_px=height,
            frame_rate=rate,
            length_frames=self.length.value(),
            first_frame=self.first.value(),
        )
        return CutSettings(canvas, Slate(self.name.text(), self.scene.text(), self.cut.text()))

    def refresh(self) -> None:
        """Show what would come of the choice, or why it cannot be."""
        canvas = self._document.canvas
        is_resized = self.size_row.size_px != (canvas.width_px, canvas.height_px)
        for button in self.refits.buttons():
            button.setEnabled(is_resized and not self._document.is_blank)
        try:
            settings = self.settings()
            self._changed = with_settings(self._document, settings, self.refit)
        except UsageProblem as problem:
            self._changed = None
            self._say([translated(problem)], is_problem=True)
        else:
            self._show_time(settings)
            is_same = self._changed.document is self._document
            self._say(
                [self.tr("Nothing.")] if is_same else list(map(translated, self._changed.notes)), is_problem=False
            )
        self.agree.setEnabled(self._changed is not None)

    def _show_time(self, settings: CutSettings) -> None:
        canvas = settings.canvas
        if not self.seconds.isModified():
            self.seconds.setText(sheet_text(canvas.length_frames, canvas.frame_rate))
        last = number_of(canvas, canvas.length_frames)
        self.last.setText(self.tr("to %1").replace("%1", str(last)))

    def _say(self, sentences: list[str], *, is_problem: bool) -> None:
        self.says.setText("\n".join(f"•  {each}" for each in sentences))
        self.says.setObjectName("problem" if is_problem else "welcome_hint")
        self.says.style().unpolish(self.says)
        self.says.style().polish(self.says)

    def _take_seconds(self) -> None:
        """Take a length that was typed as seconds and frames."""
        try:
            rate = self.settings().canvas.frame_rate
            frames = parse_frame(self.seconds.text(), self.length.value(), rate)
        except UsageProblem as problem:
            self._say([translated(problem)], is_problem=True)
            self.agree.setEnabled(False)
            return
        self.length.setValue(frames)
        self.refresh()

    def _end_seconds(self) -> None:
        """Write the length as it is, whatever was typed."""
        self.seconds.setModified(False)
        self.refresh()

    def _accept(self) -> None:
        self.refresh()
        if self._changed is not None:
            self.chosen.emit(self._changed)
            self.accept()

    def _fill(self) -> None:
        canvas, slate = self._document.canvas, self._document.slate
        for field, text in ((self.name, slate.name), (self.scene, slate.scene), (self.cut, slate.cut)):
            field.setMaxLength(MAX_WORD_CHARACTERS)
            field.setText(text)
        self.rate.setEditable(True)
        self.rate.setInsertPolicy(QComboBox.InsertPolicy.NoInsert)
        self.rate.addItems(RATES)
        self.rate.setCurrentText(rate_text(canvas.frame_rate))
        for box, low, high, value in (
            (self.length, 1, _MOST_FRAMES, canvas.length_frames),
            (self.first, 0, MAX_FIRST_FRAME, canvas.first_frame),
        ):
            box.setAlignment(Qt.AlignmentFlag.AlignRight)
            box.setRange(low, high)
            box.setValue(value)
        self.says.setWordWrap(True)
        self.says.setTextFormat(Qt.TextFormat.PlainText)
        self.says.setAlignment(Qt.AlignmentFlag.AlignTop)

    def _connect(self) -> None:
        self.size_row.changed.connect(self.refresh)
        self.refits.idClicked.connect(lambda _id: self.refresh())
        self.rate.currentTextChanged.connect(lambda _text: self.refresh())
        self.length.valueChanged.connect(lambda _value: self.refresh())
        self.first.valueChanged.connect(lambda _value: self.refresh())
        self.seconds.textEdited.connect(lambda _text: self._take_seconds())
        self.seconds.editingFinished.connect(self._end_seconds)
        for field in (self.name, self.scene, self.cut):
            field.textChanged.connect(lambda _text: self.refresh())
        self.agree.clicked.connect(self._accept)

    def _lay_out(self) -> None:
        form = QFormLayout()
        form.setHorizontalSpacing(2 * GAP_PX)
        form.setVerticalSpacing(GAP_PX + 2)
        form.addRow(self.tr("Title"), self.name)
        form.addRow(self.tr("Scene"), in_row(self.scene, QLabel(self.tr("Cut", "its number")), self.cut))
        form.addRow(self.tr("Picture size"), self.size_row)
        form.addRow(self.tr("What is on it"), in_row(*_refit_buttons(self.refits)))
        form.addRow(self.tr("Frames a second"), in_row(self.rate, None))
        frames, seconds = QLabel(self.tr("frames")), QLabel(self.tr("seconds + frames"))
        form.addRow(self.tr("Length"), in_row(self.length, frames, self.seconds, seconds, None))
        form.addRow(self.tr("First frame"), in_row(self.first, self.last, None))
        letter = self.fontMetrics().horizontalAdvance("0")
        for field in (self.length, self.first, self.rate):
            field.setFixedWidth(14 * letter)
        self.seconds.setFixedWidth(10 * letter)
        heading = QLabel(self.tr("What will change"))
        heading.setObjectName("heading")
        cancel = QPushButton(self.tr("Cancel"))
        cancel.setAutoDefault(False)
        cancel.clicked.connect(self.reject)
        self.agree.setDefault(True)
        column = QVBoxLayout(self)
        column.setContentsMargins(16, 16, 16, 14)
        column.setSpacing(10)
        column.addLayout(form)
        column.addWidget(heading)
        column.addWidget(self._scrolled_says(), 1)
        column.addWidget(in_row(None, cancel, self.agree))
        self.resize(72 * letter, self.sizeHint().height())
        self._name_fields()

    def _scrolled_says(self) -> QScrollArea:
        """Return the sentences with room for some; more are scrolled to, so that no field is squeezed."""
        area = QScrollArea()
        area.setWidget(self.says)
        area.setWidgetResizable(True)
        area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        area.setMinimumHeight(_SAID_LINES * self.fontMetrics().lineSpacing())
        return area

    def _name_fields(self) -> None:
        """Say aloud what stands beside each field."""
        for field, words in (
            (self.name, self.tr("Title")),
            (self.scene, self.tr("Scene")),
            (self.cut, self.tr("Cut", "its number")),
            (self.rate, self.tr("Frames a second")),
            (self.length, self.tr("Length in frames")),
            (self.seconds, self.tr("Length in seconds and frames")),
            (self.first, self.tr("First frame")),
        ):
            field.setAccessibleName(words)


def _refit_buttons(group: QButtonGroup) -> list[QPushButton]:
    """Return a button for each thing that may become of the drawings, of which one is down."""
    buttons = []
    for index, refit in enumerate(Refit):
        words, tip = _refit_words(refit)
        button = QPushButton(words)
        button.setCheckable(True)
        button.setAutoDefault(False)
        button.setObjectName("small_button")
        button.setToolTip(tip)
        button.setChecked(refit is Refit.CENTRE)
        group.addButton(button, index)
        buttons.append(button)
    return buttons


def _refit_words(refit: Refit) -> tuple[str, str]:
    translate = QCoreApplication.translate
    match refit:
        case Refit.STAY:
            return (
                translate("CutSettingsDialog", "Stay at Top Left"),
                translate("CutSettingsDialog", "Everything keeps its distance from the upper left corner."),
            )
        case Refit.CENTRE:
            return (
                translate("CutSettingsDialog", "To the Middle"),
                translate(
                    "CutSettingsDialog",
                    "What is in the middle stays there; margins come or go.",
                ),
            )
        case Refit.SCALE:
            return (
                translate("CutSettingsDialog", "Scale with It"),
                translate("CutSettingsDialog", "Drawings, light, set and all lengths are scaled alike."),
            )
