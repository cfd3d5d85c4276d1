"""Who tells whom: the connections between the parts of the main window, by subject."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtGui import QCursor
from PySide6.QtWidgets import QApplication

from kagezou.extras import EXTRAS
from kagezou.importing.understood import drawings_line
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.ui.panels.style_use import put_on
from kagezou.ui.project.cut_names import output_name
from kagezou.ui.system.preferences import preferences_in
from kagezou.ui.system.words import named, translated
from kagezou.ui.viewport.frame_painter import Broken
from kagezou.ui.widgets.message_bar import Severity
from kagezou.ui.widgets.missing_parts import MissingParts
from kagezou.ui.window.about import about_dialog
from kagezou.ui.window.panel_layout import PanelLayout
from kagezou.ui.window.parts import Parts
from kagezou.ui.window.verbs import WindowVerbs
from kagezou.ui.window.wiring.sets import remove_touched

if TYPE_CHECKING:
    from kagezou.export.choices import ExportChoices, Place
    from kagezou.export.exporters.exporter import ExportOutcome

_QUEUED = Qt.ConnectionType.QueuedConnection


def connect_project(parts: Parts, verbs: WindowVerbs) -> None:
    """Connect files, history and layers."""
    actions, project, bridge, session = parts.actions, parts.project, parts.bridge, lambda: parts.bridge.session
    for name, do in {
        "new": project.new,
        "open": project.open,
        "save": project.save,
        "save_as": project.save_as,
        "save_increment": project.save_increment,
        "import": project.import_folder,
        "import_pictures": project.import_pictures,
        "import_set": lambda: project.bring(filter(None, [project.dialogs.set_file()])),
        "import_timesheet": project.import_timesheet,
        "export_timesheet": project.export_timesheet,
        "background": lambda: project.put_background(project.dialogs.background()),
        "background_pictures": lambda: project.put_background(project.dialogs.folder_of_background()),
        "no_background": project.remove_background,
        "export": lambda: _export(parts),
        "quit": verbs.close,
        "undo": lambda: session().undo(),
        "redo": lambda: session().redo(),
        "delete": lambda: _delete(parts),
        "rename_layer": lambda: _rename(parts),
        "copy_look": parts.panels.layers.looks.copy,
        "paste_look": parts.panels.layers.looks.paste,
        "missing_parts": lambda: _show_missing_parts(parts),
        "about": lambda: about_dialog(parts.viewport.window(), parts.viewport.device).open(),
    }.items():
        actions.on(name, do)
    parts.exporting.ended.connect(lambda outcome: _show_result(parts, outcome))
    _connect_welcome(parts)
    parts.panels.layers.add_asked.connect(project.import_folder)
    project.done.connect(parts.status.say)
    project.recent_changed.connect(lambda: _show_recent(parts))
    for changed in (parts.open_project.path_changed, bridge.saved_changed, project.saving.changed):
        changed.connect(verbs.show_title)
    bridge.document_changed.connect(verbs.show_page)
    bridge.document_changed.connect(lambda: _begin_with_style(parts))
    bridge.history_changed.connect(lambda: parts.menus.show_steps(session().undo_name, session().redo_name))
    parts.menus.show_steps(session().undo_name, session().redo_name)
    _show_recent(parts)


def connect_view(parts: Parts, verbs: WindowVerbs) -> None:
    """Connect what has to do with looking."""
    actions, viewport, settings = parts.actions, parts.viewport, parts.settings
    viewpoint = viewport.viewpoint
    actions.on("fit", viewpoint.fit)
    actions.on("actual", viewpoint.show_actual_pixels)
    actions.on("zoom_in", lambda: viewpoint.zoom_middle(2))
    actions.on("zoom_out", lambda: viewpoint.zoom_middle(-2))
    actions["handles"].setChecked(True)
    actions.on_toggled("handles", lambda _: verbs.show_handles())
    viewpoint.changed.connect(lambda: parts.status.show_zoom(viewpoint.percent))
    parts.status.show_zoom(viewpoint.percent)

    def choose(backdrop: Backdrop) -> None:
        viewport.show_backdrop(backdrop)
        settings.set_word("backdrop", backdrop.value)

    kept = settings.word("backdrop", Backdrop.BACKGROUND.value)
    known = [each.value for each in Backdrop if each is not Backdrop.TRANSPARENT]
    viewport.show_backdrop(Backdrop(kept) if kept in known else Backdrop.BACKGROUND)
    parts.menus.add_backdrops(viewport.backdrop, choose)
    parts.menus.add_languages(settings.language, verbs.choose_language)


def connect_frame(parts: Parts, layout: PanelLayout, verbs: WindowVerbs) -> None:
    """Connect what belongs to the window itself: its panels, its shortcuts and the search among its commands."""
    actions = parts.actions

    def reset() -> None:
        actions["hide_docks"].setChecked(False)
        layout.reset()

    actions.on("command_search", parts.search.open)
    actions.on("shortcuts", parts.keyboard.show_sheet)
    actions.on("edit_shortcuts", parts.keyboard.edit)
    actions.on("reset_layout", reset)
    actions.on("timeline", lambda: layout.show("timeline"))
    actions.on_toggled("hide_docks", layout.hide)
    actions.on("fill_window", lambda: layout.fill(QApplication.widgetAt(QCursor.pos())))
    actions.on_toggled("full_screen", verbs.show_full_screen)


def connect_messages(parts: Parts) -> None:
    """Connect what went wrong, and what one should know, with the bar that says it."""
    bar, viewport = parts.bar, parts.viewport
    broken: set[str] = set()

    def show_broken(files: tuple[Broken, ...]) -> None:
        now = {str(each.source): translated(each.problem) for each in files}
        for source in broken - now.keys():
            bar.withdraw(source)
        for source, sentence in now.items():
            if source not in broken:
                bar.say(source, sentence, Severity.WARNING)
        broken.clear()
        broken.update(now)

    viewport.failed.connect(lambda sentence: bar.say("graphics", sentence), _QUEUED)
    viewport.broken_changed.connect(show_broken, _QUEUED)
    parts.panels.layers.looks.refused.connect(lambda sentence: bar.say("look", sentence, Severity.NOTE))
    parts.panels.layers.looks.noted.connect(lambda said: bar.say("style", said, Severity.NOTE))
    parts.panels.styles.failed.connect(lambda sentence: bar.say("styles", sentence))
    parts.panels.styles.noted.connect(lambda said: bar.say("style", said, Severity.NOTE))
    viewport.controller.refused.connect(lambda sentence: bar.say("hand", sentence, Severity.NOTE))
    viewport.started.connect(parts.status.show_device, _QUEUED)
    parts.open_project.noted.connect(lambda note: bar.say(str(note), translated(note), Severity.WARNING))

    def say_found(layer_ids: tuple[str, ...]) -> None:
        # Of several characters a list was shown before they came; what else is to be said goes before.
        if len(layer_ids) == 1 and not bar.text:
            layer = parts.open_project.bridge.document.layer(layer_ids[0])
            bar.say("found", translated(drawings_line(layer.name, layer.cels.drawings)), Severity.NOTE)

    parts.open_project.imported.connect(say_found)


def _connect_welcome(parts: Parts) -> None:
    welcome, project = parts.welcome, parts.project
    welcome.cels_asked.connect(project.new)
    welcome.open_asked.connect(project.open)
    welcome.recent_asked.connect(project.open_recent)
    if parts.demo is not None:
        welcome.demo_asked.connect(parts.demo.open)


def _show_recent(parts: Parts) -> None:
    projects = parts.settings.recent
    parts.menus.show_recent(projects, parts.project.open_recent)
    parts.welcome.show_recent(projects)


def _begin_with_style(parts: Parts) -> None:
    """Put the look chosen on the first page on what was brought in; a project that has a file keeps its own."""
    bridge, style = parts.bridge, parts.welcome.style_chosen
    if style is None or parts.open_project.is_blank:
        return
    parts.welcome.forget_style()
    if parts.open_project.path is None:
        words = QCoreApplication.translate("StyleList", "Style: %1").replace("%1", named(style.name))
        everybody = tuple(layer.id for layer in bridge.document.layers)
        # Within the gesture that brought the character, if there is one: then both are one step.
        said = put_on(bridge, everybody, style, words, with_light=parts.panels.styles.brings_light)
        parts.bar.say("style", said, Severity.NOTE)


def _export(parts: Parts) -> None:
    if parts.exporting.is_running:
        parts.exporting.say_running()
        return
    # All kinds of export are loaded by the first who asks for one, not by everyone who opens the window.
    from kagezou.export.after.work import HandedOnWork
    from kagezou.export.exporters.table import exporter_of
    from kagezou.export.remembered import dumps_choices, loads_choices
    from kagezou.ui.export.dialog import ExportDialog
    from kagezou.ui.export.places import place_for, remember_place

    settings, document = parts.settings, parts.bridge.document
    place = place_for(settings, parts.open_project.path, output_name(document, parts.project.project_name))
    remembered = loads_choices(settings.word("export_plan", ""))
    dialog = ExportDialog(document, remembered, place, settings.preset_folder, parts.viewport.window())
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)

    def start(choices: "ExportChoices", chosen: "Place") -> None:
        settings.set_word("export_plan", dumps_choices(choices))
        remember_place(settings, chosen)
        work = exporter_of(choices).work(document, choices, chosen)
        command = preferences_in(settings).after_export or None
        parts.exporting.start(HandedOnWork(work, choices.kind, document, chosen.project, command))

    dialog.chosen.connect(start)
    dialog.open()


def _show_missing_parts(parts: Parts) -> None:
    MissingParts([each for each in EXTRAS if not each.is_there], parts.viewport.window()).open()


def _show_result(parts: Parts, outcome: "ExportOutcome") -> None:
    """Show what came of an export, in the place of what came of the one before."""
    from kagezou.ui.export.result import ExportResult

    window = parts.viewport.window()
    for before in window.findChildren(ExportResult):
        before.close()
    result = ExportResult(outcome, window)
    result.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    result.show()


def _rename(parts: Parts) -> None:
    (parts.sets.pieces if parts.bridge.piece_id else parts.panels.layers).rename_current()


def _delete(parts: Parts) -> None:
    if parts.panels.layers.view.hasFocus():
        parts.panels.layers.remove_current()
    elif parts.time.timeline.lanes.hasFocus() and parts.time.timeline.drawings.are_chosen:
        parts.time.timeline.drawings.empty()
    elif (parts.viewport.hasFocus() or not parts.time.keys.delete()) and not parts.viewport.contacts.remove_selected():
        remove_touched(parts)
