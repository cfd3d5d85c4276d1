"""The choices of an export: each has a place of its own, and only those of the exporter are shown there."""

from typing import Final

from PySide6.QtCore import QCoreApplication, Signal
from PySide6.QtWidgets import QCheckBox, QComboBox, QGridLayout, QHBoxLayout, QLabel, QSizePolicy, QWidget

from kagezou.document.model import Document
from kagezou.export.choices import ExportChoices
from kagezou.export.exporters.exporter import Option
from kagezou.export.exporters.table import MAX_CHUNK, depths_of, exporter_of
from kagezou.export.request import Missing
from kagezou.ui.export.naming_row import NamingRows
from kagezou.ui.widgets.number_boxes import WholeNumberBox

GAP_PX = 8
"""Between a label and its field."""

_ROW_GAP_PX: Final = 6
_ARROW_PX: Final = 36
"""What a box has beside its words."""

_ROWS: Final = {
    Option.ONLY_WORK_AREA: 1,
    Option.PER_DRAWING: 1,
    Option.SKIP_EXISTING: 2,
    Option.VIDEO_LAYER: 2,
    Option.IN_ONE: 2,
    Option.UNITED: 3,
    Option.COPIES: 3,
    Option.COMPOSITE: 4,
    Option.MATTES: 4,
    Option.RECEIVERS: 5,
    Option.CHUNK: 6,
    Option.NAMES: 7,
    Option.CONTROLS: 9,
    Option.MISSING: 10,
}
"""The place of each, which nothing that is offered with it has; the mattes go on in the rows below theirs."""


class ExportOptions(QWidget):
    """A form of choices, as large for every exporter.

    Parameters
    ----------
    document
        What is exported.
    """

    changed = Signal(dict)
    """What was chosen: names of fields of the choices and their values."""

    def __init__(self, document: Document) -> None:
        super().__init__()
        self._document = document
        self.format_box, self.depth_box, self.video_box = QComboBox(), QComboBox(), QComboBox()
        self.missing_box = QComboBox()
        self.format_box.setAccessibleName(self.tr("Format"))
        self.depth_box.setAccessibleName(self.tr("Depth"))
        self.video_box.setAccessibleName(self.tr("Picture"))
        self.missing_box.setAccessibleName(self.tr("Missing drawings"))
        self.chunk, self.naming = WholeNumberBox(), NamingRows(document.canvas.first_frame)
        self._ticks: dict[Option, QCheckBox] = {}
        self._mattes: dict[str, QCheckBox] = {}
        self._shown_for: list[tuple[QWidget, Option]] = []
        self._labels: list[QLabel] = []
        self._form = QGridLayout(self)
        self._form.setContentsMargins(0, 0, 0, 0)
        self._form.setHorizontalSpacing(GAP_PX)
        # A row of which nothing is shown would lose its spacing.
        self._form.setVerticalSpacing(0)
        self._lay_out()

    def show_choices(self, choices: ExportChoices) -> None:
        """Show what the exporter lets one choose, as it stands."""
        exporter = exporter_of(choices)
        for widget, option in self._shown_for:
            widget.setVisible(option in exporter.options)
        titles = self._format_words()
        formats = {titles.get(each, each.upper()): each for each in exporter.formats(choices)}
        _fill(self.format_box, formats, choices.format)
        depths = depths_of(choices.format)
        _fill(self.depth_box, {self.tr("%1 bit").replace("%1", str(each)): each for each in depths}, choices.depth)
        only = self.tr("%1 has no other depth.").replace("%1", choices.format.upper())
        _allow(self.depth_box, "" if len(depths) > 1 else only)
        _fill(self.video_box, self._pictures(), choices.video_layer)
        _fill(self.missing_box, self._ways_without(), choices.missing)
        apart = self.tr("One file with all layers has it already.") if exporter.is_layered(choices) else ""
        for option in (Option.UNITED, Option.COMPOSITE, Option.RECEIVERS):
            _allow(self._ticks[option], apart)
        for option, box in self._ticks.items():
            _tick(box, on=bool(getattr(choices, option)))
        for matte, box in self._mattes.items():
            _tick(box, on=matte in choices.mattes)
        self.chunk.blockSignals(True)
        self.chunk.setValue(choices.chunk)
        self.chunk.blockSignals(False)
        self.naming.show_choices(choices)

    def _lay_out(self) -> None:
        self._tell(self.format_box, "format")
        self._tell(self.depth_box, "depth")
        self._tell(self.video_box, "video_layer")
        self._tell(self.missing_box, "missing")
        row = QHBoxLayout()
        row.setSpacing(GAP_PX)
        row.addWidget(self.format_box, 1)
        row.addWidget(self.depth_box)
        self._shown_for.append((self.depth_box, Option.DEPTH))
        self._form.addWidget(QLabel(self.tr("Format")), 0, 0)
        self._form.addLayout(row, 0, 1)
        self._put_labelled(QLabel(self.tr("Picture")), self.video_box, Option.VIDEO_LAYER)
        self._put_labelled(QLabel(self.tr("Missing drawings")), self.missing_box, Option.MISSING)
        self._add(self.tr("All layers of a frame in one file"), Option.IN_ONE)
        self._add(self.tr("Shadows of a look as one besides"), Option.UNITED)
        self._add(self.tr("Composite with background and characters"), Option.COMPOSITE)
        self._add(self.tr("Mattes: the ground and every set piece"), Option.RECEIVERS)
        self._add(self.tr("Only the work area"), Option.ONLY_WORK_AREA)
        if self._document.work_area is None:
            _refuse(self._ticks[Option.ONLY_WORK_AREA], self.tr("the cut has none"))
        self._add(self.tr("Each different shadow once, held by time remapping"), Option.PER_DRAWING)
        self._add(self.tr("Copy characters and background into the folder"), Option.COPIES)
        self._add(self.tr("A null whose sliders drive all shadows"), Option.CONTROLS)
        for number, (matte, words) in enumerate(self._matte_words().items()):
            box = self._mattes[matte] = QCheckBox(words)
            box.toggled.connect(self._choose_mattes)
            self._put(box, Option.MATTES, number)
        self.chunk.setRange(1, MAX_CHUNK)
        self.chunk.setSuffix(self.tr(" frames a task"))
        self.chunk.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        self.chunk.valueChanged.connect(lambda value: self.changed.emit({"chunk": value}))
        self._put(self.chunk, Option.CHUNK)
        self.naming.changed.connect(self.changed)
        for below, (label, field) in enumerate(self.naming.rows):
            self._put_labelled(label, field, Option.NAMES, below)
        trusting = self.tr("Leave frames alone that would come out the same")
        self._add(trusting, Option.SKIP_EXISTING)
        self._keep_room()

    def _tell(self, box: QComboBox, field: str) -> None:
        box.activated.connect(lambda: self.changed.emit({field: box.currentData()}))

    def _add(self, words: str, option: Option) -> None:
        box = self._ticks[option] = QCheckBox(words)
        box.toggled.connect(lambda on: self.changed.emit({option.value: on}))
        self._put(box, option)

    def _put(self, widget: QWidget, option: Option, below: int = 0) -> None:
        self._form.addWidget(widget, _ROWS[option] + below, 0, 1, 2)
        self._shown_for.append((widget, option))

    def _put_labelled(self, label: QLabel, field: QWidget, option: Option, below: int = 0) -> None:
        self._form.addWidget(label, _ROWS[option] + below, 0)
        self._form.addWidget(field, _ROWS[option] + below, 1)
        self._labels.append(label)
        self._shown_for += [(each, option) for each in (label, field)]

    def _keep_room(self) -> None:
        """Make every row as high as its highest widget, and the form as wide as its widest, shown or not."""
        widgets = [widget for widget, _ in self._shown_for]
        self.depth_box.setMinimumContentsLength(6)
        for each in (*widgets, self.format_box):
            each.ensurePolished()
        high = max(each.sizeHint().height() for each in (*widgets, self.format_box)) + _ROW_GAP_PX
        for row in range(_ROWS[Option.MISSING] + 1):
            self._form.setRowMinimumHeight(row, high)
        self._form.setRowStretch(self._form.rowCount(), 1)
        self._form.setColumnStretch(1, 1)
        labels = max(each.sizeHint().width() for each in self._labels)
        self._form.setColumnMinimumWidth(0, labels)
        words = max(map(self.fontMetrics().horizontalAdvance, self._format_words().values()))
        beside = labels + self.depth_box.sizeHint().width() + 2 * GAP_PX
        self.setMinimumWidth(max(*(each.sizeHint().width() for each in widgets), words + _ARROW_PX + beside))
        for box in (self.format_box, self.video_box, self.missing_box, self.naming.pattern):
            box.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        policy = self.depth_box.sizePolicy()
        policy.setRetainSizeWhenHidden(True)
        self.depth_box.setSizePolicy(policy)

    def _choose_mattes(self) -> None:
        self.changed.emit({"mattes": tuple(each for each, box in self._mattes.items() if box.isChecked())})

    def _pictures(self) -> dict[str, str]:
        """Return what a video may show: its words and the layer's name, which is empty for everything."""
        shadow = self.tr("Shadow of %1")
        layers = {shadow.replace("%1", layer.name): layer.name for layer in self._document.layers}
        return {self.tr("Finished picture"): ""} | layers

    def _ways_without(self) -> dict[str, str]:
        """Return what may stand in for a drawing that is not there."""
        return {
            self.tr("Export nothing, name them"): Missing.FAIL.value,
            self.tr("Leave the frames empty"): Missing.EMPTY.value,
            self.tr("Hold the nearest drawing"): Missing.HOLD.value,
        }

    def _format_words(self) -> dict[str, str]:
        return {
            "psd": self.tr("PSD, opacity and blend mode kept"),
            "exr": "EXR",
            "mp4": self.tr("MP4, H.264, to look at"),
            "mov": self.tr("MOV, ProRes 4444, with alpha"),
        }

    def _matte_words(self) -> dict[str, str]:
        return {
            "shadow": self.tr("Matte: the shadow alone"),
            "core": self.tr("Matte: the part near the feet"),
            "distance": self.tr("Matte: distance from the feet"),
            "lit": self.tr("Matte: what no shadow lies on"),
            "receivers": self.tr("Mattes: the ground and every set piece"),
        }


def _fill(box: QComboBox, choices: dict[str, str] | dict[str, int], chosen: object) -> None:
    box.clear()
    for words, value in choices.items():
        box.addItem(words, value)
    box.setCurrentIndex(max(box.findData(chosen), 0))


def _tick(box: QCheckBox, *, on: bool) -> None:
    box.blockSignals(True)
    box.setChecked(on and box.isEnabled())
    box.blockSignals(False)


def _allow(widget: QWidget, reason: str) -> None:
    """Let a widget be used unless there is a reason against it, which it then tells."""
    widget.setEnabled(not reason)
    widget.setToolTip(reason)


def _refuse(box: QCheckBox, reason: str) -> None:
    """Keep a box from being ticked, and say why beside its words."""
    words = QCoreApplication.translate("ExportOptions", "%1 (%2)", "an option, and why it is not there")
    box.setText(words.replace("%1", box.text()).replace("%2", reason))
    _allow(box, reason[:1].upper() + reason[1:])
