"""Who tells whom about looking a cut through: the review, its steps, and the notes as a file."""

from pathlib import Path

from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QFileDialog, QMainWindow

from kagezou.errors import Problem
from kagezou.export.note_list import SUFFIXES, notes_as_csv, notes_as_text
from kagezou.io.files.atomic import write_bytes
from kagezou.ui.system.words import in_own_language, translated
from kagezou.ui.widgets.message_bar import Severity
from kagezou.ui.window.panel_layout import PanelLayout
from kagezou.ui.window.parts import Parts
from kagezou.ui.window.review_mode import ReviewMode


def connect_review(window: QMainWindow, parts: Parts, layout: PanelLayout) -> ReviewMode:
    """Connect the commands of a review."""
    review, actions = ReviewMode(window, parts, layout), parts.actions
    actions.on_toggled("review", review.turn)
    actions.on("remark_next", lambda: review.step(1))
    actions.on("remark_previous", lambda: review.step(-1))
    actions.on("remark_tick", review.tick)
    actions.on("export_notes", lambda: _export_notes(parts))
    return review


def _export_notes(parts: Parts) -> None:
    document, settings, translate = parts.bridge.document, parts.settings, QCoreApplication.translate
    if not document.notes:
        parts.bar.say("notes", translate("Notes", "There are no notes to export."), Severity.NOTE)
        return
    path = parts.open_project.path
    folder = Path(settings.folder("notes") or (Path.home() if path is None else path.parent))
    csv, text = translate("Notes", "Table") + " (*.csv)", translate("Notes", "Text") + " (*.txt)"
    name = f"{parts.project.project_name}_notes.csv"
    title = translate("Notes", "Export Notes")
    chosen, form = QFileDialog.getSaveFileName(parts.viewport.window(), title, str(folder / name), f"{csv};;{text}")
    if not chosen:
        return
    target = Path(chosen)
    if target.suffix.lower() not in SUFFIXES.values():
        target = target.with_name(target.name + (SUFFIXES["text"] if form == text else SUFFIXES["csv"]))
    settings.remember_folder("notes", target.parent)
    as_list = notes_as_text if target.suffix.lower() == SUFFIXES["text"] else notes_as_csv
    try:
        write_bytes(target, as_list(document, in_own_language).encode("utf-8"))
    except Problem as problem:
        parts.bar.say("notes", translated(problem))
    else:
        said = translate("Notes", "The notes are in %1").replace("%1", str(target))
        parts.bar.say("notes", said, Severity.NOTE)
