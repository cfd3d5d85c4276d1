"""Who tells whom about the settings of the cut."""

from PySide6.QtCore import QCoreApplication, Qt

from kagezou.document.cut_settings import ChangedCut
from kagezou.ui.project.cut_settings_dialog import CutSettingsDialog
from kagezou.ui.window.parts import Parts


def connect_cut(parts: Parts) -> None:
    """Connect the dialog with its command, and with the places where size and rate are shown."""
    parts.actions.on("cut_settings", lambda: ask_settings(parts))
    parts.status.canvas.clicked.connect(parts.actions["cut_settings"].trigger)
    parts.time.transport.rate.clicked.connect(parts.actions["cut_settings"].trigger)
    parts.files.canvas_offer.settings_asked.connect(lambda width, height: ask_settings(parts, (width, height)))


def ask_settings(parts: Parts, size_px: tuple[int, int] | None = None) -> CutSettingsDialog:
    """Open the dialog over the window, with another size of the picture where one is meant."""
    session = parts.bridge.session
    dialog = CutSettingsDialog(session.document, parts.viewport.window())
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)

    def change(changed: ChangedCut) -> None:
        session.edit(QCoreApplication.translate("CutSettingsDialog", "Change cut settings"), changed.document)

    if size_px is not None:
        dialog.size_row.show_size(*size_px)
    parts.time.player.stop()
    dialog.chosen.connect(change)
    dialog.open()
    return dialog
