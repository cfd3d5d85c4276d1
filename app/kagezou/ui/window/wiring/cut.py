"""Who tells whom about the settings of the cut, and about what it takes of others."""

from PySide6.QtCore import QCoreApplication, Qt

from kagezou.document.cut_settings import ChangedCut
from kagezou.document.model import Document
from kagezou.io.project.file import load
from kagezou.message import Message
from kagezou.ui.project.cut_settings_dialog import CutSettingsDialog
from kagezou.ui.project.load import Load
from kagezou.ui.project.taking_dialog import TakingDialog
from kagezou.ui.system.words import translated
from kagezou.ui.widgets.message_bar import Severity
from kagezou.ui.window.parts import Parts


def connect_cut(parts: Parts) -> None:
    """Connect the dialog with its command, and with the places where size and rate are shown."""
    parts.actions.on("cut_settings", lambda: ask_settings(parts))
    parts.actions.on("take_from", lambda: take_from(parts))
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


def take_from(parts: Parts) -> None:
    """Ask for another project, read it beside the window, and ask what of it is taken."""
    path = parts.project.dialogs.project_to_take_from()
    if path is not None:

        def ask(source: Document) -> None:
            ask_what_to_take(parts, source, path.stem)

        parts.project.loading.start(Load(path.name, lambda _progress: load(path), ask))


def ask_what_to_take(parts: Parts, source: Document, name: str) -> TakingDialog:
    """Open the dialog over the window; what is taken is one step, and what was and was not is said."""
    session = parts.bridge.session
    dialog = TakingDialog(session.document, source, name, parts.viewport.window())
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)

    def take(document: Document, notes: tuple[Message, ...]) -> None:
        session.edit(QCoreApplication.translate("TakingDialog", "Take from project"), document)
        parts.bar.say("taken", "  ·  ".join(map(translated, notes)), Severity.NOTE)

    parts.time.player.stop()
    dialog.chosen.connect(take)
    dialog.open()
    return dialog
