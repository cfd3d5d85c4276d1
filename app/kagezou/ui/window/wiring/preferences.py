"""Who tells whom about preferences."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QColor

from kagezou.ui.system.preferences import Preferences, preferences_in
from kagezou.ui.viewport.resolution import Resolution
from kagezou.ui.window.parts import Parts
from kagezou.ui.window.preferences_dialog import PreferencesDialog
from kagezou.ui.window.verbs import WindowVerbs


def connect_preferences(parts: Parts, verbs: WindowVerbs) -> None:
    """Put what is remembered into effect, and connect the dialog in which it is changed."""
    _take_effect(parts, preferences_in(parts.settings))
    parts.actions.on("preferences", lambda: ask_preferences(parts, verbs))


def ask_preferences(parts: Parts, verbs: WindowVerbs) -> PreferencesDialog:
    """Open the dialog over the window."""
    dialog = PreferencesDialog(parts.settings, parts.viewport.window())
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    dialog.changed.connect(lambda preferences: _take_effect(parts, preferences))
    dialog.resolution_chosen.connect(lambda word: _show_resolution(parts, Resolution(word)))
    # Queued: another language makes the window anew, and this dialog belongs to the old one.
    dialog.language_chosen.connect(verbs.choose_language, Qt.ConnectionType.QueuedConnection)
    dialog.open()
    return dialog


def _take_effect(parts: Parts, preferences: Preferences) -> None:
    parts.open_project.cels.limit(preferences.memory_bytes)
    parts.viewport.viewpoint.show_surround(QColor(preferences.surround))
    parts.curves.sign(preferences.signature)


def _show_resolution(parts: Parts, resolution: Resolution) -> None:
    """Choose it as in the menu, which shows it too."""
    parts.menus.resolutions.actions()[list(Resolution).index(resolution)].trigger()
