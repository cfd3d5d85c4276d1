"""How files are called: a pattern to choose or to type, and the number of the first."""

from typing import Final

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QComboBox, QLabel, QSpinBox

from kagezou.export.choices import AS_CUT, ExportChoices
from kagezou.export.file_names import MAX_FIRST, USUAL
from kagezou.ui.widgets.number_boxes import WholeNumberBox

PATTERNS: Final = (
    USUAL,
    "{layer}_{kind}/{layer}_{kind}.{frame:04d}",
    "{layer}_{kind}.{frame:04d}",
    "{cut}/{kind}/{cut}_{layer}_{kind}.{frame:04d}",
)
"""What is offered; anything else may be typed."""


class NamingRows(QObject):
    """A box of patterns that takes typing, and the number of the first file, each with its words before it.

    Parameters
    ----------
    first
        The number that the cut's first frame bears.
    """

    changed = Signal(dict)
    """What was chosen: names of fields of the choices and their values."""

    def __init__(self, first: int) -> None:
        super().__init__()
        self.pattern, self.start = QComboBox(), WholeNumberBox()
        self.pattern.setEditable(True)
        self.pattern.addItems(PATTERNS)
        self.pattern.setMinimumContentsLength(18)
        self.pattern.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.pattern.setAccessibleName(self.tr("File names"))
        self.pattern.setToolTip(
            self.tr(
                "Folders and name of a file: {layer}, {kind}, {name}, {scene}, {cut} and, once, {frame}; "
                "{frame:04d} says its digits."
            )
        )
        self.start.setRange(AS_CUT, MAX_FIRST)
        self.start.setSpecialValueText(self.tr("as in the cut (%1)").replace("%1", str(first)))
        self.start.setAccessibleName(self.tr("Number of the first frame"))
        self.start.setToolTip(self.tr("The number in the file of the cut's first frame, such as 1001."))
        self.rows = (_named(self.tr("File names"), self.pattern), _named(self.tr("First number"), self.start))
        self.pattern.editTextChanged.connect(lambda text: self.changed.emit({"names": text.strip() or USUAL}))
        self.start.valueChanged.connect(lambda value: self.changed.emit({"start": value}))

    def show_choices(self, choices: ExportChoices) -> None:
        """Show the choices; what is being typed keeps its cursor."""
        self.blockSignals(True)
        if (self.pattern.currentText().strip() or USUAL) != choices.names:
            self.pattern.setEditText(choices.names)
        self.start.setValue(choices.start)
        self.blockSignals(False)


def _named(words: str, field: QComboBox | QSpinBox) -> tuple[QLabel, QComboBox | QSpinBox]:
    """Return the words of a field, which lead to it, and the field."""
    label = QLabel(words)
    label.setBuddy(field)
    return label, field
