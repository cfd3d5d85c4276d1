"""The window about the program."""

from collections.abc import Sequence
from platform import python_version

from PySide6.QtCore import QCoreApplication, QSize, Qt, qVersion
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QLabel, QVBoxLayout, QWidget

from kagezou.ui.system.icons import application_icon
from kagezou.version import __version__


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
        translate("Help", "Under the Apache License 2.0. Qt is used under the GNU LGPL 3."),
    )
    words = QLabel("\n".join(lines))
    words.setAlignment(Qt.AlignmentFlag.AlignHCenter)
    words.setWordWrap(True)
    words.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
    _fill(dialog, [picture, name, words])
    return dialog


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
