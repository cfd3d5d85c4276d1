"""Who tells whom about layers: their marks, their files, and what is missing of them."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtGui import QColor, QGuiApplication, QIcon, QPixmap

from kagezou.document.edits import duplicate_layers
from kagezou.document.layer_marks import LABELS, LayerMarks
from kagezou.document.marking import set_marks
from kagezou.importing.retakes.report import Report
from kagezou.message import first_names
from kagezou.ui.project.retake_result import RetakeResult
from kagezou.ui.system.words import translated
from kagezou.ui.widgets.message_bar import Severity
from kagezou.ui.window.parts import Parts

translate = QCoreApplication.translate
_LOCKED = "locked-layer"


def connect_layers(parts: Parts) -> None:
    """Connect the commands on layers, and what is said of those that are locked or miss drawings."""
    actions, files = parts.actions, parts.files.layers
    for name, do in {
        "layer_replace": files.replace,
        "layer_relink": files.relink,
        "layer_folder": files.show_folder,
        "layer_duplicate": lambda: _duplicate(parts),
        "layer_lock": lambda: _lock(parts),
        "layer_solo": lambda: _solo(parts),
    }.items():
        actions.on(name, do)
    parts.menus.add_labels(_label_choices(parts))
    parts.panels.layers.menu_opening.connect(parts.menus.fill_layers)
    parts.panels.layers.model.refused.connect(lambda said: parts.bar.say("layer-name", said, Severity.NOTE))
    files.noted.connect(lambda note: parts.bar.say(str(note), translated(note), Severity.NOTE))
    files.retaken.connect(lambda report: _show_retake(parts, report))
    files.changed.connect(parts.feet.search)
    parts.bridge.layer_refused.connect(lambda names: _say_locked(parts, names))
    for signal in (parts.bridge.document_changed, parts.bridge.selection_changed):
        signal.connect(lambda: _show_marks(parts))
    _connect_missing(parts)
    _show_marks(parts)


def _connect_missing(parts: Parts) -> None:
    missing = parts.files.missing

    def show() -> None:
        parts.panels.layers.model.show_missing(missing.files)
        parts.time.timeline.names.show_missing(missing.files)

    missing.changed.connect(show)
    application = QGuiApplication.instance()
    if isinstance(application, QGuiApplication):
        # Who comes back from another program may have moved files there.
        application.applicationStateChanged.connect(missing.come_back)


def _show_retake(parts: Parts, report: Report) -> None:
    """Show what came of a retake, in the place of what came of the one before."""
    window = parts.viewport.window()
    for before in window.findChildren(RetakeResult):
        before.close()
    result = RetakeResult(report, window)
    result.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    result.frame_asked.connect(parts.bridge.session.go_to)
    result.show()


def _chosen_marks(parts: Parts) -> list[LayerMarks]:
    document = parts.bridge.document
    return [document.layer(layer_id).marks for layer_id in parts.bridge.layer_ids]


def _show_marks(parts: Parts) -> None:
    """Tick what all chosen layers are, and offer only what there is a layer for."""
    marks = _chosen_marks(parts)
    for name, is_on in (
        ("layer_lock", [each.is_locked for each in marks]),
        ("layer_solo", [each.is_solo for each in marks]),
    ):
        parts.actions[name].setChecked(bool(is_on) and all(is_on))
    for name in ("replace", "relink", "folder", "duplicate", "lock", "solo"):
        parts.actions[f"layer_{name}"].setEnabled(bool(marks))
    parts.menus.labels.setEnabled(bool(marks))


def _mark(parts: Parts, step: str, change: Callable[[LayerMarks], LayerMarks]) -> None:
    bridge = parts.bridge
    bridge.session.edit(step, set_marks(bridge.document, bridge.layer_ids, change))
    # A switch that was clicked has changed by itself, whatever came of it.
    _show_marks(parts)


def _lock(parts: Parts) -> None:
    """Lock all chosen layers, or unlock them where all are."""
    is_on = not all(each.is_locked for each in _chosen_marks(parts))
    _mark(parts, translate("Layers", "Lock layer"), lambda marks: replace(marks, is_locked=is_on))


def _solo(parts: Parts) -> None:
    """Look at all chosen layers alone, or at all again where all are."""
    is_on = not all(each.is_solo for each in _chosen_marks(parts))
    _mark(parts, translate("Layers", "Solo layer"), lambda marks: replace(marks, is_solo=is_on))


def _duplicate(parts: Parts) -> None:
    bridge = parts.bridge
    document, ids = duplicate_layers(bridge.document, bridge.layer_ids)
    if ids:
        bridge.session.edit(translate("Layers", "Duplicate layer"), document)
        bridge.session.select(ids[0], others=frozenset(ids[1:]))


def _say_locked(parts: Parts, names: tuple[str, ...]) -> None:
    words = translate("Layers", "%1 is locked, so nothing is changed. Lock Layer in the Layer menu unlocks it.")
    parts.bar.say(_LOCKED, words.replace("%1", first_names(names)), Severity.NOTE)


def _label_choices(parts: Parts) -> list[tuple[str, QIcon, Callable[[], None]]]:
    step = translate("Layers", "Label layer")

    def put(label: str) -> None:
        _mark(parts, step, lambda marks: replace(marks, label=label))

    words = {
        "": translate("Layers", "None", "no label"),
        "red": translate("Layers", "Red"),
        "orange": translate("Layers", "Orange"),
        "yellow": translate("Layers", "Yellow"),
        "green": translate("Layers", "Green"),
        "blue": translate("Layers", "Blue"),
        "purple": translate("Layers", "Purple"),
        "pink": translate("Layers", "Pink"),
    }
    return [(words[label], _patch(label), partial(put, label)) for label in words]


def _patch(label: str) -> QIcon:
    """Return a patch of a label's colour."""
    pixmap = QPixmap(14, 14)
    pixmap.fill(QColor(LABELS[label]) if label else Qt.GlobalColor.transparent)
    return QIcon(pixmap)
