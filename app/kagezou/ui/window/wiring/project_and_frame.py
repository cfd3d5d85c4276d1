"""Who tells whom: the connections between the parts of the main window, by subject."""

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication, Qt

from kagezou.document.style import apply_style
from kagezou.export.choices import ExportChoices, Place
from kagezou.export.exporters.table import exporter_of
from kagezou.export.remembered import dumps_choices, loads_choices
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.ui.commands.search import CommandSearch
from kagezou.ui.export.dialog import ExportDialog
from kagezou.ui.system.words import named, translated
from kagezou.ui.viewport.stage import Broken
from kagezou.ui.widgets.message_bar import Severity
from kagezou.ui.window.about import about_dialog
from kagezou.ui.window.panel_layout import TabKey
from kagezou.ui.window.wiring.sets import remove_touched

if TYPE_CHECKING:
    from kagezou.ui.window.main_window import MainWindow

_QUEUED = Qt.ConnectionType.QueuedConnection


def connect_project(window: "MainWindow") -> None:
    """Connect files, history and layers."""
    actions, project, session = window.actions_of, window.project, lambda: window.open_project.bridge.session
    bridge, welcome = window.open_project.bridge, window.welcome
    for name, do in {
        "new": project.new,
        "open": project.open,
        "save": project.save,
        "save_as": project.save_as,
        "save_increment": project.save_increment,
        "import": project.import_folder,
        "import_pictures": project.import_pictures,
        "import_set": project.import_set,
        "import_timesheet": project.import_timesheet,
        "export_timesheet": project.export_timesheet,
        "background": project.set_background,
        "no_background": project.remove_background,
        "export": lambda: _export(window),
        "quit": window.close,
        "undo": lambda: session().undo(),
        "redo": lambda: session().redo(),
        "delete": lambda: _delete(window),
        "rename_layer": lambda: _rename(window),
        "copy_look": window.layers.looks.copy,
        "paste_look": window.layers.looks.paste,
        "about": lambda: about_dialog(window, window.viewport.device).open(),
    }.items():
        actions.on(name, do)
    welcome.cels_asked.connect(project.new)
    welcome.open_asked.connect(project.open)
    welcome.recent_asked.connect(project.open_recent)
    if window.demo is not None:
        welcome.demo_asked.connect(window.demo.open)
    window.layers.add_asked.connect(project.import_folder)
    project.recent_changed.connect(lambda: _show_recent(window))
    window.open_project.path_changed.connect(window.show_title)
    bridge.saved_changed.connect(window.show_title)
    bridge.document_changed.connect(window.show_page)
    bridge.document_changed.connect(lambda: _begin_with_style(window))
    bridge.history_changed.connect(lambda: window.menus.show_steps(session().undo_name, session().redo_name))
    window.menus.show_steps(session().undo_name, session().redo_name)
    _show_recent(window)


def connect_view(window: "MainWindow") -> None:
    """Connect what has to do with looking."""
    actions, viewport, settings = window.actions_of, window.viewport, window.settings
    viewpoint = viewport.viewpoint
    actions.on("fit", viewpoint.fit)
    actions.on("actual", viewpoint.show_actual_pixels)
    actions.on("zoom_in", lambda: viewpoint.zoom_middle(2))
    actions.on("zoom_out", lambda: viewpoint.zoom_middle(-2))
    actions["handles"].setChecked(True)
    actions.on_toggled("handles", lambda _: window.show_handles())
    viewpoint.changed.connect(lambda: window.status.show_zoom(viewpoint.percent))
    window.status.show_zoom(viewpoint.percent)

    def choose(backdrop: Backdrop) -> None:
        viewport.show_backdrop(backdrop)
        settings.set_word("backdrop", backdrop.value)

    kept = settings.word("backdrop", Backdrop.BACKGROUND.value)
    known = [each.value for each in Backdrop if each is not Backdrop.TRANSPARENT]
    viewport.show_backdrop(Backdrop(kept) if kept in known else Backdrop.BACKGROUND)
    window.menus.add_backdrops(viewport.backdrop, choose)
    window.menus.add_languages(settings.language, window.language_chosen.emit)


def connect_frame(window: "MainWindow") -> None:
    """Connect what belongs to the window itself: its panels, its shortcuts and the search among its commands."""
    actions, layout = window.actions_of, window.panel_layout
    search = CommandSearch(window, actions)

    def reset() -> None:
        actions["hide_docks"].setChecked(False)
        layout.reset()

    actions.on("command_search", search.open)
    actions.on("shortcuts", window.keyboard.show_sheet)
    actions.on("edit_shortcuts", window.keyboard.edit)
    actions.on("reset_layout", reset)
    actions.on("timeline", lambda: layout.show("timeline"))
    actions.on_toggled("hide_docks", layout.hide)
    actions.on_toggled("full_screen", lambda on: window.showFullScreen() if on else window.showNormal())
    TabKey(window, actions["hide_docks"], lambda: not window.open_project.is_blank)


def connect_messages(window: "MainWindow") -> None:
    """Connect what went wrong, and what one should know, with the bar that says it."""
    bar, viewport = window.bar, window.viewport
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
    window.layers.looks.refused.connect(lambda sentence: bar.say("look", sentence, Severity.NOTE))
    window.styles.failed.connect(lambda sentence: bar.say("styles", sentence))
    viewport.hand.refused.connect(lambda sentence: bar.say("hand", sentence, Severity.NOTE))
    viewport.started.connect(window.status.show_device, _QUEUED)
    window.open_project.noted.connect(lambda note: bar.say(str(note), translated(note), Severity.WARNING))


def _show_recent(window: "MainWindow") -> None:
    projects = window.settings.recent
    window.menus.show_recent(projects, window.project.open_recent)
    window.welcome.show_recent(projects)


def _begin_with_style(window: "MainWindow") -> None:
    """Put the look chosen on the first page on what was brought in; a project that has a file keeps its own."""
    bridge, style = window.open_project.bridge, window.welcome.style_chosen
    if style is None or window.open_project.is_blank:
        return
    window.welcome.forget_style()
    if window.open_project.path is None:
        document = bridge.document
        for layer in document.layers:
            document = apply_style(document, layer.id, style, bridge.frame)
        words = QCoreApplication.translate("StyleList", "Style: %1")
        # Within the gesture that brought the character, if there is one: then both are one step.
        bridge.session.edit(words.replace("%1", named(style.name)), document)


def _export(window: "MainWindow") -> None:
    if window.exporting.is_running:
        window.exporting.say_running()
        return
    settings, path, name = window.settings, window.open_project.path, window.project.project_name
    beside = Path.home() if path is None else path.parent
    folder = Path(settings.folder("export")) if settings.folder("export") else beside
    place = Place(folder / f"{name}_export", path, name)
    document = window.open_project.bridge.document
    remembered = loads_choices(settings.word("export_plan", ""))
    dialog = ExportDialog(document, remembered, place, settings.preset_folder, window)
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)

    def start(choices: ExportChoices, chosen: Place) -> None:
        settings.set_word("export_plan", dumps_choices(choices))
        settings.remember_folder("export", chosen.folder.parent)
        window.exporting.start(exporter_of(choices).work(document, choices, chosen))

    dialog.chosen.connect(start)
    dialog.open()


def _rename(window: "MainWindow") -> None:
    (window.set_list if window.open_project.bridge.piece_id else window.layers).rename_current()


def _delete(window: "MainWindow") -> None:
    if window.layers.view.hasFocus():
        window.layers.remove_current()
    elif window.timeline.lanes.hasFocus() and window.timeline.drawings.are_chosen:
        window.timeline.drawings.empty()
    elif (window.viewport.hasFocus() or not window.keys.delete()) and not window.viewport.hand.delete_selected():
        remove_touched(window)
