"""Layers in the window: locked, alone, labelled, copied; other drawings, drawings found again, names set apart."""

import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt, QUrl
from PySide6.QtWidgets import QAbstractItemView, QDialog, QFileDialog, QMenu
from pytestqt.qtbot import QtBot

from kagezou.document.address import Address
from kagezou.document.edits import rename_layer, set_constant, set_key
from kagezou.document.layer_marks import LABELS
from kagezou.document.properties import OPACITY, VISIBLE
from kagezou.document.values import value_at
from kagezou.io.images.writing import write_rgba
from kagezou.tools.handle import Handle
from kagezou.ui.panels.layer_model import Role
from kagezou.ui.project.dialogs import Dialogs
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.project.retake_result import RetakeResult
from kagezou.ui.system.settings import Settings
from kagezou.ui.timeline.rows import RowKind
from kagezou.ui.window.main_window import MainWindow
from tests.ui.conftest import figure_rgba
from tests.ui.viewing import OwnClipboard


@pytest.fixture
def plain(qtbot: QtBot, settings: Settings, filled: OpenProject) -> MainWindow:
    made = MainWindow(filled, settings, OwnClipboard())
    qtbot.addWidget(made, before_close_func=MainWindow.close_unasked)
    return made


def row_names(window: MainWindow) -> list[str]:
    names = window.parts.time.timeline.names
    return [names.name_of(row) for row in window.parts.time.timeline.rows.rows if row.is_group]


def context_menu(window: MainWindow, row: int = 0) -> QMenu:
    view = window.parts.panels.layers.view
    at = view.visualRect(window.parts.panels.layers.model.index(row)).center()
    view.customContextMenuRequested.emit(QPoint(at))
    return [menu for menu in view.findChildren(QMenu) if any(each.text() == "Rename" for each in menu.actions())][-1]


def handle_layers(window: MainWindow) -> set[str | None]:
    handles: tuple[Handle, ...] = window.parts.viewport.controller.handles.handles
    return {handle.layer_id for handle in handles}


def test_the_menu_of_a_layer_has_what_the_layer_menu_has(plain: MainWindow) -> None:
    words = [action.text() for action in context_menu(plain).actions()]
    for name in ("replace", "relink", "folder", "duplicate", "lock", "solo"):
        assert plain.parts.actions[f"layer_{name}"].text() in words
    assert plain.parts.menus.labels.menuAction() in context_menu(plain).actions()


def test_a_locked_layer_is_left_alone_and_that_is_said(plain: MainWindow) -> None:
    parts, bridge = plain.parts, plain.parts.bridge
    layer_id = bridge.document.layers[0].id
    assert layer_id in handle_layers(plain)
    parts.actions["layer_lock"].trigger()
    assert bridge.document.layers[0].marks.is_locked
    assert parts.actions["layer_lock"].isChecked()
    assert layer_id not in handle_layers(plain)
    before = bridge.document
    bridge.session.edit("key", set_key(before, Address(OPACITY, layer_id), 2, 0.3))
    assert bridge.document is before
    assert "Walker is locked" in parts.bar.text
    parts.panels.layers.remove_current()
    assert bridge.document is before
    parts.actions["layer_lock"].trigger()
    assert not parts.actions["layer_lock"].isChecked()
    bridge.session.edit("key", set_constant(bridge.document, Address(OPACITY, layer_id), 0.3))
    assert bridge.document is not before


def test_a_layer_is_looked_at_alone_and_nothing_but_the_picture_changes(plain: MainWindow) -> None:
    parts, bridge = plain.parts, plain.parts.bridge
    parts.actions["layer_duplicate"].trigger()
    assert [layer.name for layer in bridge.document.layers] == ["Walker", "Walker 2"]
    assert bridge.layer_id == bridge.document.layers[1].id
    assert bridge.shown is bridge.document
    parts.actions["layer_solo"].trigger()
    seen = [value_at(layer.tracks, VISIBLE, 1) for layer in bridge.shown.layers]
    assert seen == [False, True]
    assert [value_at(layer.tracks, VISIBLE, 1) for layer in bridge.document.layers] == [True, True]
    parts.actions["layer_solo"].trigger()
    assert bridge.shown is bridge.document


def test_a_label_is_seen_in_the_list_and_in_the_timeline(plain: MainWindow) -> None:
    parts = plain.parts
    (green,) = [action for action in parts.menus.labels.actions() if action.text() == "Green"]
    green.trigger()
    assert parts.bridge.document.layers[0].marks.label == "green"
    plain.resize(1280, 720)
    plain.show()
    wanted = LABELS["green"]
    for widget in (parts.panels.layers.view.viewport(), parts.time.timeline.names):
        image = widget.grab().toImage()
        assert wanted in {image.pixelColor(1, y).name() for y in range(image.height())}


def test_missing_drawings_are_marked_and_found_again(
    qtbot: QtBot, plain: MainWindow, cels: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    parts, model = plain.parts, plain.parts.panels.layers.model
    assert not model.index(0).data(Role.IS_MISSING)
    moved = tmp_path / "moved" / "walker"
    shutil.move(cels, moved)
    parts.files.missing.come_back(Qt.ApplicationState.ApplicationActive)
    qtbot.waitUntil(lambda: bool(model.index(0).data(Role.IS_MISSING)))
    assert "6 missing" in model.index(0).data(Role.SUMMARY)
    assert "walk_0001.png" in model.index(0).data(Qt.ItemDataRole.ToolTipRole)
    assert str(cels) in model.index(0).data(Qt.ItemDataRole.ToolTipRole)
    monkeypatch.setattr(Dialogs, "folder_of_cels", lambda _dialogs: tmp_path / "moved")
    (moved / "walk_0006.png").unlink()
    parts.actions["layer_relink"].trigger()
    drawings = parts.bridge.document.layers[0].cels.drawings
    assert [drawing.path.parent for drawing in drawings] == [moved] * 5 + [cels]
    assert "5 of 6" in parts.bar.text or "walk_0006.png" in parts.bar.text
    qtbot.waitUntil(lambda: "1 missing" in model.index(0).data(Role.SUMMARY))
    parts.bridge.session.undo()
    assert parts.bridge.document.layers[0].cels.drawings[0].path.parent == cels


def test_where_nothing_is_missing_that_is_said(plain: MainWindow) -> None:
    plain.parts.actions["layer_relink"].trigger()
    assert "No drawing is missing" in plain.parts.bar.text


def test_other_drawings_take_the_place_and_keys_stay(
    plain: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    parts, bridge = plain.parts, plain.parts.bridge
    layer = bridge.document.layers[0]
    keyed = set_key(bridge.document, Address(OPACITY, layer.id), 2, 0.3)
    bridge.session.edit("key", keyed)
    folder = tmp_path / "cleaned"
    folder.mkdir()
    for number in range(1, 7):
        write_rgba(folder / f"clean_{number:04d}.png", figure_rgba(number))
    monkeypatch.setattr(Dialogs, "pictures", lambda _dialogs: [folder / "clean_0001.png"])
    parts.actions["layer_replace"].trigger()
    after = bridge.document.layers[0]
    assert [drawing.path.parent for drawing in after.cels.drawings] == [folder] * 6
    assert after.cels.exposures == layer.cels.exposures
    assert (after.id, after.name) == (layer.id, layer.name)
    assert after.tracks == keyed.layers[0].tracks
    assert bridge.session.undo_name == "Replace drawings"
    assert not plain.findChildren(RetakeResult), "the same pictures under the same numbers: nothing to read"


def test_what_became_of_each_drawing_is_shown_and_leads_to_where_to_look(
    qtbot: QtBot, plain: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    parts, bridge = plain.parts, plain.parts.bridge
    folder = tmp_path / "retake"
    folder.mkdir()
    for number, of in enumerate((1, 2, None, 3, 4, 5, 6), start=1):
        rgba = np.zeros((200, 240, 4), np.uint8) if of is None else figure_rgba(of)
        rgba[20:40, 20:200] = (255, 0, 0, 255) if of is None else rgba[20:40, 20:200]
        write_rgba(folder / f"retake_{number:04d}.png", rgba)
    monkeypatch.setattr(Dialogs, "pictures", lambda _dialogs: [folder / "retake_0001.png"])
    parts.actions["layer_replace"].trigger()
    (shown,) = plain.findChildren(RetakeResult)
    texts = [[item.text(column) for column in range(3)] for item in map(shown.rows.topLevelItem, range(7)) if item]
    assert texts[0] == ["–", "3", "new"], "what changed comes first"
    assert texts[-1] == ["2", "2", "name and picture"]
    assert "please look at frames 3" in shown.words.text().lower()
    bridge.session.go_to(1)
    qtbot.mouseClick(shown.look, Qt.MouseButton.LeftButton)
    assert bridge.frame == 3
    assert [marker.frame for marker in bridge.document.markers] == [3]
    bridge.session.undo()
    assert len(bridge.document.layers[0].cels.drawings) == 6, "one step"
    assert bridge.document.markers == ()


def test_the_folder_of_the_drawings_is_shown(plain: MainWindow, cels: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    opened: list[QUrl] = []
    monkeypatch.setattr(plain.parts.files.layers, "_show", opened.append)
    plain.parts.actions["layer_folder"].trigger()
    assert [url.toLocalFile() for url in opened] == [str(cels)]


@pytest.mark.parametrize("name", ["Scene", "scene", "SCENE"])
def test_no_two_rows_bear_one_name(plain: MainWindow, name: str) -> None:
    bridge = plain.parts.bridge
    assert row_names(plain) == ["Scene", "Walker"]
    bridge.session.edit("rename", rename_layer(bridge.document, bridge.document.layers[0].id, name))
    assert row_names(plain) == ["Scene (light, ground)", name]
    plain.parts.actions["add_box"].trigger()
    (piece,) = bridge.document.pieces
    bridge.session.edit("rename", replace(bridge.document, pieces=(replace(piece, name="sCeNe"),)))
    assert len({each.casefold() for each in row_names(plain)}) == 3
    rows = plain.parts.time.timeline.rows.rows
    assert [row.kind for row in rows if row.is_group] == [RowKind.SCENE, RowKind.PIECE, RowKind.LAYER]


def test_a_name_that_is_taken_is_refused_and_said(plain: MainWindow) -> None:
    plain.parts.actions["layer_duplicate"].trigger()
    model = plain.parts.panels.layers.model
    assert not model.setData(model.index(0), "WALKER")
    assert "already a layer named 'WALKER'" in plain.parts.bar.text


def test_several_folders_are_chosen_in_one_dialog(
    plain: MainWindow, cels: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    other = tmp_path / "runner"
    shutil.copytree(cels, other)

    def choose(dialog: QFileDialog) -> int:
        views = [
            view for view in dialog.findChildren(QAbstractItemView) if view.objectName() in ("listView", "treeView")
        ]
        assert [view.selectionMode() for view in views] == [QAbstractItemView.SelectionMode.ExtendedSelection] * 2
        monkeypatch.setattr(QFileDialog, "selectedFiles", lambda _dialog: [str(cels), str(other)])
        return QDialog.DialogCode.Accepted

    monkeypatch.setattr(QFileDialog, "exec", choose)
    plain.parts.actions["import"].trigger()
    names = {layer.name for layer in plain.parts.bridge.document.layers}
    assert len(names) == 3
    assert "runner" in {name.casefold() for name in names}
