"""Exporting from the window: every kind, what is told beforehand, and what is remembered."""

import json
from pathlib import Path

import pytest
from PySide6.QtWidgets import QCheckBox, QRadioButton
from pytestqt.qtbot import QtBot

from kagezou.document import review
from kagezou.errors import UsageProblem
from kagezou.ui.desk import Desk
from kagezou.ui.export_dialog import ExportDialog
from kagezou.ui.export_plan import ExportKind, ExportPlan, Place, dumps_plan, loads_plan, preview, sound
from kagezou.ui.main_window import MainWindow


@pytest.fixture
def place(tmp_path: Path) -> Place:
    return Place(tmp_path / "out", tmp_path / "walk.kage", "walk")


@pytest.fixture
def dialog(qtbot: QtBot, filled: Desk, place: Place) -> ExportDialog:
    made = ExportDialog(filled.bridge.document, ExportPlan(), place)
    qtbot.addWidget(made)
    made.show()
    return made


def lines(dialog: ExportDialog) -> list[str]:
    return [dialog.preview.item(row).text() for row in range(dialog.preview.count())]


def choose(dialog: ExportDialog, words: str) -> None:
    next(button for button in dialog.findChildren(QRadioButton) if button.text() == words).setChecked(True)


def tick(dialog: ExportDialog, words: str) -> None:
    box = next(box for box in dialog.findChildren(QCheckBox) if words in box.text())
    assert box.isVisible(), words
    box.click()


def test_the_preview_follows_every_choice(dialog: ExportDialog) -> None:
    assert lines(dialog) == ["Walker_shadow/  6 × .png"]
    tick(dialog, "Composite")
    dialog.change(format="exr")
    assert lines(dialog) == ["Walker_shadow/  6 × .exr", "composite/  6 × .exr"]
    assert dialog.depth_box.currentData() == 16
    choose(dialog, "After Effects")
    tick(dialog, "near the feet")
    assert lines(dialog) == [
        "walk.jsx",
        "shadows/Walker_shadow/  .exr",
        "matte_core/  .exr",
        "characters/",
        "background/",
    ]
    choose(dialog, "Render farm job")
    assert lines(dialog) == ["template.json", "parameter_values.json", "asset_references.json", "1 × 10"]
    assert dialog.go.isEnabled()


def test_only_what_a_kind_knows_is_asked(dialog: ExportDialog) -> None:
    def seen() -> str:
        return " ".join(box.text() for box in dialog.findChildren(QCheckBox) if box.isVisible())

    assert "Matte" not in seen()
    choose(dialog, "After Effects")
    assert "Matte" in seen()
    assert "Composite" not in seen()
    assert [dialog.format_box.itemData(row) for row in range(dialog.format_box.count())] == ["png", "exr"]


def test_a_farm_needs_a_saved_project_and_every_export_a_folder(qtbot: QtBot, filled: Desk, tmp_path: Path) -> None:
    made = ExportDialog(filled.bridge.document, ExportPlan(ExportKind.FARM), Place(tmp_path, None, "Untitled"))
    qtbot.addWidget(made)
    made.show()
    assert made.says.text() == "A farm renders a saved project; save this one first"
    assert not made.go.isEnabled()
    choose(made, "Shadow layers")
    assert made.go.isEnabled()
    made.folder.setText(" ")
    assert made.says.text() == "Choose a folder."
    assert not made.go.isEnabled()


def test_the_work_area_alone(filled: Desk, place: Place) -> None:
    document = review.set_work_area(filled.bridge.document, 2, 4)
    assert preview(document, ExportPlan(only_work_area=True), place) == ("Walker_shadow/  3 × .png",)
    assert preview(document, ExportPlan(), place) == ("Walker_shadow/  6 × .png",)


def test_nothing_to_export_is_said(desk: Desk, place: Place) -> None:
    with pytest.raises(UsageProblem, match="nothing to render"):
        preview(desk.bridge.document, ExportPlan(), place)


@pytest.mark.parametrize(
    "plan",
    [
        ExportPlan(),
        ExportPlan(ExportKind.AFTER_EFFECTS, per_drawing=True, mattes=("core", "lit"), copies=False),
        ExportPlan(ExportKind.FARM, only_work_area=True, format="tiff", depth=16, chunk=24),
    ],
)
def test_a_plan_is_remembered(plan: ExportPlan) -> None:
    assert loads_plan(dumps_plan(plan)) == plan


@pytest.mark.parametrize("text", ["", "{", "[1]", '{"kind": "film", "chunk": "x", "mattes": 3, "format": "bmp"}'])
def test_what_is_no_plan_is_the_usual_one(text: str) -> None:
    assert loads_plan(text) == ExportPlan()


def test_a_plan_is_made_sound() -> None:
    assert sound(ExportPlan(format="tga", depth=16)).depth == 8
    assert sound(ExportPlan(ExportKind.AFTER_EFFECTS, format="tiff")).format == "png"
    assert sound(ExportPlan(chunk=0)).chunk == 1


@pytest.mark.parametrize(
    ("kind", "made"),
    [
        (ExportKind.LAYERS, "walker_shadow/walker_shadow_0006.png"),
        (ExportKind.AFTER_EFFECTS, "walk.jsx"),
        (ExportKind.FARM, "template.json"),
    ],
)
def test_the_window_exports_each_kind_beside_itself(
    qtbot: QtBot, walking: MainWindow, tmp_path: Path, kind: ExportKind, made: str
) -> None:
    walking.desk.save(tmp_path / "walk.kage")
    walking.settings.set_word("export_plan", dumps_plan(ExportPlan(kind)))
    walking.settings.remember_folder("export", tmp_path)
    walking.actions_of["export"].trigger()
    dialog = walking.findChild(ExportDialog)
    assert dialog is not None
    assert dialog.plan.kind is kind
    dialog.go.click()
    qtbot.waitUntil(lambda: not walking.exporting.is_running, timeout=20000)
    assert (tmp_path / "walk_export" / made).exists()
    assert "Exported" in walking.bar.text
    assert json.loads(walking.settings.word("export_plan", ""))["kind"] == kind
