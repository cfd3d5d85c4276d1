"""The windows that explain: about the program, and the sheet of its shortcuts."""

from collections.abc import Sequence
from platform import python_version

from PySide6.QtCore import QCoreApplication, QSize, Qt, qVersion
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QGridLayout, QLabel, QScrollArea, QVBoxLayout, QWidget

from kagezou import __version__
from kagezou.ui.commands import Command, plain
from kagezou.ui.icons import application_icon


def about_dialog(parent: QWidget, graphics: str) -> QDialog:
    """Return the window about the program; ``graphics`` names what draws."""
    translate = QCoreApplication.translate
    dialog = _dialog(parent, translate("Help", "About Kagezou"))
    picture = QLabel()
    picture.setPixmap(application_icon().pixmap(QSize(64, 64)))
    picture.setAlignment(Qt.AlignmentFlag.AlignHCenter)
    name = QLabel("Kagezou")
    name.setObjectName("welcome_title")
    name.setAlignment(Qt.AlignmentFlag.AlignHCenter)
    lines = (
        translate("Help", "Cast-shadow layers for 2D animation, from the alpha of the character drawings."),
        translate("Help", "Version %1").replace("%1", __version__),
        f"Python {python_version()}    Qt {qVersion()}",
        translate("Help", "Graphics: %1").replace("%1", graphics or translate("Help", "none")),
    )
    words = QLabel("\n".join(lines))
    words.setAlignment(Qt.AlignmentFlag.AlignHCenter)
    words.setWordWrap(True)
    words.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
    _fill(dialog, [picture, name, words])
    return dialog


def shortcuts_dialog(parent: QWidget, commands: Sequence[Command]) -> QDialog:
    """Return the sheet of shortcuts: every command that has one, and what the hand does on the picture."""
    dialog = _dialog(parent, QCoreApplication.translate("Help", "Keyboard Shortcuts"))
    sheet = QWidget()
    grid = QGridLayout(sheet)
    grid.setHorizontalSpacing(28)
    grid.setVerticalSpacing(5)
    lines = [(plain(command.text), _keys(command)) for command in commands if command.keys]
    for row, (words, keys) in enumerate((*_gestures(), *lines)):
        label = QLabel(words)
        label.setObjectName("shortcut_words")
        grid.addWidget(label, row, 0)
        grid.addWidget(QLabel(keys), row, 1)
    area = QScrollArea()
    area.setWidget(sheet)
    area.setWidgetResizable(True)
    _fill(dialog, [area])
    dialog.resize(sheet.sizeHint().width() + 60, 640)
    return dialog


def _gestures() -> tuple[tuple[str, str], ...]:
    translate = QCoreApplication.translate
    return (
        (translate("Help", "Play / stop"), translate("Help", "Space")),
        (translate("Help", "Move the picture"), translate("Help", "Space + drag, middle mouse button")),
        (translate("Help", "Zoom at the pointer"), translate("Help", "Wheel")),
        (translate("Help", "Add a grounding point"), translate("Help", "Double click on the character")),
        (translate("Help", "Keep to one axis, or to steps of 15°"), translate("Help", "Shift while dragging")),
        (translate("Help", "Move the counterpart the opposite way"), translate("Help", "Alt while dragging")),
        (translate("Help", "Drag at a tenth of the speed"), translate("Help", "Shift + Alt while dragging")),
        (translate("Help", "Do not snap"), translate("Help", "Ctrl while dragging")),
        (translate("Help", "Take a drag back"), translate("Help", "Esc, right mouse button")),
        (translate("Help", "Select the next handle"), translate("Help", "Tab")),
        (translate("Help", "Nudge the selected handle, by 1 or 10 px"), translate("Help", "Arrow keys, with Shift")),
        (
            translate("Help", "Change a number faster or slower"),
            translate("Help", "Shift or Ctrl while dragging it"),
        ),
        (translate("Help", "Calculate in a number field"), "*2   /3   +10   -=10   50%"),
    )


def _keys(command: Command) -> str:
    native = QKeySequence.SequenceFormat.NativeText
    return ",   ".join(QKeySequence(keys).toString(native) for keys in command.keys)


def _dialog(parent: QWidget, title: str) -> QDialog:
    dialog = QDialog(parent)
    dialog.setWindowTitle(title)
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    return dialog


def _fill(dialog: QDialog, widgets: Sequence[QWidget]) -> None:
    column = QVBoxLayout(dialog)
    column.setContentsMargins(24, 20, 24, 16)
    column.setSpacing(12)
    for widget in widgets:
        column.addWidget(widget)
    buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
    buttons.button(QDialogButtonBox.StandardButton.Close).setText(QCoreApplication.translate("Help", "Close"))
    buttons.rejected.connect(dialog.reject)
    column.addWidget(buttons)
