"""The choices of an export, of which only those of its kind are shown; what cannot be chosen says why."""

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QComboBox, QFormLayout, QHBoxLayout, QLabel, QSpinBox, QWidget

from kagezou.document.model import Document
from kagezou.export.plan import ExportKind, ExportPlan, depths_of

_LAYERS, _LAYERED, _VIDEO, _EFFECTS, _FARM = tuple(ExportKind)
_FRAMES = (_LAYERS, _LAYERED, _EFFECTS, _FARM)

GAP_PX = 8
"""Between a label and its field."""


class ExportOptions(QWidget):
    """A form of choices.

    Parameters
    ----------
    document
        What is exported.
    """

    changed = Signal(dict)
    """What was chosen: names of fields of a plan and their values."""

    def __init__(self, document: Document) -> None:
        super().__init__()
        self._document = document
        self.format_box, self.depth_box, self.video_box = QComboBox(), QComboBox(), QComboBox()
        self.format_box.setAccessibleName(self.tr("Format"))
        self.depth_box.setAccessibleName(self.tr("Depth"))
        self.video_box.setAccessibleName(self.tr("Picture"))
        self.chunk = QSpinBox()
        self._ticks: dict[str, QCheckBox] = {}
        self._mattes: dict[str, QCheckBox] = {}
        self._rows: list[tuple[QWidget, tuple[ExportKind, ...]]] = []
        self._form = QFormLayout(self)
        self._form.setContentsMargins(0, 0, 0, 0)
        self._form.setHorizontalSpacing(GAP_PX)
        self._lay_out()

    def show_plan(self, plan: ExportPlan) -> None:
        """Show the choices of the plan's kind as they stand."""
        for widget, kinds in self._rows:
            self._form.setRowVisible(widget, plan.kind in kinds)
        self.depth_box.setVisible(plan.kind in _FRAMES)
        titles = self._format_words()
        _fill(self.format_box, {titles.get(each, each.upper()): each for each in plan.formats}, plan.format)
        depths = depths_of(plan.format)
        _fill(self.depth_box, {self.tr("%1 bit").replace("%1", str(each)): each for each in depths}, plan.depth)
        only = self.tr("%1 has no other depth.").replace("%1", plan.format.upper())
        _allow(self.depth_box, "" if len(depths) > 1 else only)
        _fill(self.video_box, self._pictures(), plan.video_layer)
        apart = self.tr("One file with all layers has it already.") if plan.is_layered else ""
        for name in ("composite", "receivers"):
            _allow(self._ticks[name], apart)
        for name, box in self._ticks.items():
            _tick(box, on=bool(getattr(plan, name)))
        for matte, box in self._mattes.items():
            _tick(box, on=matte in plan.mattes)
        self.chunk.blockSignals(True)
        self.chunk.setValue(plan.chunk)
        self.chunk.blockSignals(False)

    def _lay_out(self) -> None:
        self.format_box.activated.connect(lambda: self.changed.emit({"format": self.format_box.currentData()}))
        self.depth_box.activated.connect(lambda: self.changed.emit({"depth": self.depth_box.currentData()}))
        self.video_box.activated.connect(lambda: self.changed.emit({"video_layer": self.video_box.currentData()}))
        row = QHBoxLayout()
        row.setSpacing(GAP_PX)
        row.addWidget(self.format_box, 1)
        row.addWidget(self.depth_box)
        self.labels = (QLabel(self.tr("Format")), QLabel(self.tr("Picture")))
        self._form.addRow(self.labels[0], row)
        self._form.addRow(self.labels[1], self.video_box)
        self._rows.append((self.video_box, (_VIDEO,)))
        self._add(self.tr("All layers of a frame in one file"), "in_one", (_FARM,))
        self._add(self.tr("Composite with background and characters"), "composite", (_LAYERS, _FARM))
        self._add(self.tr("Mattes: the ground and every set piece"), "receivers", (_LAYERS, _FARM))
        self._add(self.tr("Only the work area"), "only_work_area", (_LAYERS, _LAYERED, _VIDEO, _FARM))
        if self._document.work_area is None:
            _refuse(self._ticks["only_work_area"], self.tr("the cut has none"))
        self._add(self.tr("Each different shadow once, held by time remapping"), "per_drawing", (_EFFECTS,))
        self._add(self.tr("Copy characters and background into the folder"), "copies", (_EFFECTS,))
        for matte, words in self._matte_words().items():
            box = self._mattes[matte] = QCheckBox(words)
            box.toggled.connect(self._choose_mattes)
            self._put(box, (_EFFECTS,))
        self.chunk.setRange(1, 1000)
        self.chunk.setSuffix(self.tr(" frames a task"))
        self.chunk.valueChanged.connect(lambda value: self.changed.emit({"chunk": value}))
        self._put(self.chunk, (_FARM,))
        trusting = self.tr("Leave frames alone that would come out the same")
        self._add(trusting, "skip_existing", (_LAYERS, _LAYERED, _EFFECTS))

    def _add(self, words: str, name: str, kinds: tuple[ExportKind, ...]) -> None:
        box = self._ticks[name] = QCheckBox(words)
        box.toggled.connect(lambda on: self.changed.emit({name: on}))
        self._put(box, kinds)

    def _put(self, widget: QWidget, kinds: tuple[ExportKind, ...]) -> None:
        self._form.addRow("", widget)
        self._rows.append((widget, kinds))

    def _choose_mattes(self) -> None:
        self.changed.emit({"mattes": tuple(each for each, box in self._mattes.items() if box.isChecked())})

    def _pictures(self) -> dict[str, str]:
        """Return what a video may show: its words and the layer's name, which is empty for everything."""
        shadow = self.tr("Shadow of %1")
        layers = {shadow.replace("%1", layer.name): layer.name for layer in self._document.layers}
        return {self.tr("Finished picture"): ""} | layers

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
    box.setText(f"{box.text()} ({reason})")
    _allow(box, reason[:1].upper() + reason[1:])
