"""Exporting from the window: every kind, what is told beforehand, and what is remembered."""

import json
from pathlib import Path
from threading import Event

import pytest
from PySide6.QtCore import QPoint, QRect, QStandardPaths, Qt, QUrl
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QApplication,
    QCheckBox,
    QComboBox,
    QLabel,
    QProgressBar,
    QPushButton,
    QToolButton,
    QWidget,
)
from pytestqt.qtbot import QtBot

from kagezou.document import review
from kagezou.document.edits import set_exposures
from kagezou.errors import OutputProblem, UsageProblem
from kagezou.export.choices import ExportChoices, Place
from kagezou.export.exporters import video_file
from kagezou.export.exporters.exporter import ExportOutcome
from kagezou.export.exporters.hand_off import HAND_OFF
from kagezou.export.exporters.shadow_layers import SHADOW_LAYERS
from kagezou.export.exporters.table import exporter_of, sound
from kagezou.export.presets import presets_in, rename_preset, save_preset
from kagezou.export.remembered import dumps_choices, loads_choices
from kagezou.export.request import Cancelled, Progress
from kagezou.message import Message
from kagezou.render.gpu.context import OpenContext
from kagezou.ui.export.dialog import ExportDialog
from kagezou.ui.export.places import MOST, place_for, remember_place
from kagezou.ui.export.result import ExportResult
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.system.language import Language
from kagezou.ui.system.settings import Settings
from kagezou.ui.widgets.missing_parts import MissingParts
from kagezou.ui.window.main_window import MainWindow


@pytest.fixture
def place(tmp_path: Path) -> Place:
    return Place(tmp_path / "out", tmp_path / "walk.kage", "walk")


@pytest.fixture
def dialog(qtbot: QtBot, filled: OpenProject, place: Place) -> ExportDialog:
    made = ExportDialog(filled.bridge.document, ExportChoices(), place, place.folder.with_name("presets"))
    qtbot.addWidget(made)
    made.show()
    return made


def lines(dialog: ExportDialog) -> list[str]:
    return [dialog.preview.item(row).text() for row in range(dialog.preview.count())]


def data_of(box: QComboBox) -> list[object]:
    return [box.itemData(row) for row in range(box.count())]


def pick(box: QComboBox, value: object) -> None:
    """Choose from a box as a hand does."""
    box.setCurrentIndex(box.findData(value))
    box.activated.emit(box.currentIndex())


def choose(dialog: ExportDialog, words: str) -> None:
    """Choose a kind from the list with the pointer."""
    targets = dialog.targets
    item = next(item for row in range(targets.count()) if (item := targets.item(row)).text() == words)
    place = targets.visualItemRect(item).center()
    QTest.mouseClick(targets.viewport(), Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, place)


def tick(dialog: ExportDialog, words: str) -> None:
    boxes = [box for box in dialog.findChildren(QCheckBox) if words in box.text() and box.isVisible()]
    assert boxes, words
    boxes[0].click()


def test_the_preview_follows_every_choice(dialog: ExportDialog) -> None:
    assert lines(dialog) == ["Walker_shadow/Walker_shadow_0001.png  × 6"]
    tick(dialog, "Composite")
    dialog.change(format="exr")
    assert lines(dialog) == ["Walker_shadow/Walker_shadow_0001.exr  × 6", "composite/composite_0001.exr  × 6"]
    assert dialog.options.depth_box.currentData() == 16
    choose(dialog, "After Effects")
    tick(dialog, "near the feet")
    assert lines(dialog) == [
        "walk.jsx",
        "shadows/Walker_shadow/  6 × .exr",
        "matte_core/Walker_shadow/  6 × .exr",
        "characters/Walker/  6 × .png",
    ]
    tick(dialog, "every set piece")
    tick(dialog, "Copy characters")
    tick(dialog, "Each different shadow once")
    assert lines(dialog)[1:] == [
        "shadows/Walker_shadow/  6 × .exr",
        "matte_core/Walker_shadow/  .exr",
        "matte_receivers/ground_matte/  .exr",
    ]
    choose(dialog, "Render farm job")
    assert lines(dialog)[:4] == ["template.json", "parameter_values.json", "asset_references.json", "1 × 10"]
    assert lines(dialog)[4:] == [
        "    Walker_shadow/Walker_shadow_0001.exr  × 6",
        "    composite/composite_0001.exr  × 6",
    ]
    assert dialog.go.isEnabled()


def test_only_what_a_kind_knows_is_asked(dialog: ExportDialog) -> None:
    def seen() -> str:
        return " ".join(box.text() for box in dialog.findChildren(QCheckBox) if box.isVisible())

    assert "near the feet" not in seen()
    choose(dialog, "After Effects")
    assert "near the feet" in seen()
    assert "Composite" not in seen()
    assert data_of(dialog.options.format_box) == ["png", "exr"]


def test_mattes_of_what_is_fallen_on_are_written_for_any_compositor(dialog: ExportDialog) -> None:
    tick(dialog, "the ground and every set piece")
    assert lines(dialog) == ["Walker_shadow/Walker_shadow_0001.png  × 6", "ground_matte/ground_matte_0001.png  × 6"]


def test_a_farm_makes_layered_frames_too(dialog: ExportDialog) -> None:
    choose(dialog, "Render farm job")
    tick(dialog, "Composite")
    tick(dialog, "All layers of a frame in one file")
    assert data_of(dialog.options.format_box) == ["psd", "exr"]
    box = next(box for box in dialog.findChildren(QCheckBox) if "Composite" in box.text())
    assert not box.isEnabled()
    assert box.toolTip() == "One file with all layers has it already."
    assert dialog.go.isEnabled(), "a composite asked for before stands not in the way"
    tick(dialog, "All layers of a frame in one file")
    assert data_of(dialog.options.format_box) == ["png", "tga", "tiff", "exr"]
    assert box.isEnabled()
    assert box.isChecked()


def test_layered_frames_show_their_layers(dialog: ExportDialog) -> None:
    choose(dialog, "Layered frames")
    assert data_of(dialog.options.format_box) == ["psd", "exr"]
    assert lines(dialog) == ["layered/layered_0001.psd  × 6", "    Walker", "    Walker_shadow"]
    assert dialog.options.depth_box.isEnabled()
    assert data_of(dialog.options.depth_box) == [8, 16]
    assert dialog.choices.depth == 8
    pick(dialog.options.format_box, "exr")
    assert lines(dialog)[0] == "layered/layered_0001.exr  × 6"
    assert dialog.choices.depth == 16
    assert not dialog.options.depth_box.isEnabled()
    assert dialog.options.depth_box.toolTip() == "EXR has no other depth."
    pick(dialog.options.format_box, "psd")
    assert dialog.choices.depth == 8, "16 was not chosen"
    pick(dialog.options.depth_box, 16)
    assert dialog.choices.depth == 16


def test_a_video_shows_the_picture_or_a_shadow(dialog: ExportDialog) -> None:
    dialog.change(format="tiff", depth=16)
    choose(dialog, "Video")
    assert lines(dialog) == ["walk.mp4  6 @ 24 fps  240 × 200"]
    assert not dialog.options.depth_box.isVisible()
    pick(dialog.options.format_box, "mov")
    assert data_of(dialog.options.video_box) == ["", "Walker"]
    pick(dialog.options.video_box, "Walker")
    assert lines(dialog) == ["walk_Walker_shadow.mov  6 @ 24 fps  240 × 200"]
    choose(dialog, "Shadow layers")
    assert dialog.choices.format == "tiff", "each kind keeps its format"
    choose(dialog, "Video")
    assert dialog.choices.format == "mov"


def test_what_stands_in_for_missing_drawings_is_asked_whatever_is_made(dialog: ExportDialog) -> None:
    box = dialog.options.missing_box
    assert data_of(box) == ["fail", "empty", "hold"]
    for row in range(dialog.targets.count()):
        item = dialog.targets.item(row)
        assert item is not None
        choose(dialog, item.text())
        assert box.isVisible(), item.text()
    pick(box, "hold")
    assert dialog.choices.missing == "hold"
    choose(dialog, "Shadow layers")
    assert box.currentText() == "Hold the nearest drawing"


def test_what_cannot_be_chosen_says_why(qtbot: QtBot, filled: OpenProject, place: Place) -> None:
    made = ExportDialog(filled.bridge.document, ExportChoices(only_work_area=True), place, place.folder)
    qtbot.addWidget(made)
    made.show()
    area = next(box for box in made.findChildren(QCheckBox) if "work area" in box.text())
    assert area.text() == "Only the work area (the cut has none)"
    assert (area.isEnabled(), area.isChecked()) == (False, False)
    assert made.presets.remove_button.toolTip() == "Choose one of your presets first."


def test_a_missing_part_is_offered_where_it_is_wanted_and_taken_at_once(
    dialog: ExportDialog, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(video_file, "is_there", lambda: False)
    dialog.refresh()
    shown = " ".join(label.text() for label in dialog.findChildren(QLabel) if label.isVisible())
    assert "pip" not in shown
    assert not dialog.how.isVisible(), "who wants no video is not asked"
    choose(dialog, "Video")
    assert dialog.says.text() == "Writing videos needs a part that is not installed"
    assert not dialog.go.isEnabled()
    dialog.how.click()
    (how,) = dialog.findChildren(MissingParts)
    assert how.command.text().endswith("-m pip install 'av>=18,<21'")
    how.copy.click()
    assert QGuiApplication.clipboard().text() == how.command.text()
    monkeypatch.setattr(video_file, "is_there", lambda: True)
    how.accept()
    assert dialog.says.text() == ""
    assert dialog.go.isEnabled()
    assert not dialog.how.isVisible()


def places(dialog: ExportDialog) -> dict[str, QRect]:
    """Return where in the dialog every widget that is seen stands; words that follow the choice are left out."""
    seen = {}
    for widget in dialog.findChildren(QWidget):
        if widget.isVisible() and not isinstance(widget.parent(), QComboBox):
            words = widget.text() if isinstance(widget, QCheckBox | QPushButton) else ""
            seen[f"{type(widget).__name__} {words} {id(widget)}"] = QRect(
                widget.mapTo(dialog, QPoint(0, 0)), widget.size()
            )
    return seen


@pytest.mark.parametrize("language", ["en", "ja"])
def test_nothing_moves_and_all_of_it_fits_a_small_screen(
    english: Language, language: str, qtbot: QtBot, filled: OpenProject, place: Place
) -> None:
    english.speak(language)
    made = ExportDialog(filled.bridge.document, ExportChoices(), place, place.folder)
    qtbot.addWidget(made)
    made.show()
    size = made.size()
    before: dict[str, QRect] = {}
    for row in range(made.targets.count()):
        made.targets.setCurrentRow(row)
        QApplication.processEvents()
        now = places(made)
        moved = [name for name, where in now.items() if before.get(name, where) != where]
        assert not moved, [(name, before[name], now[name]) for name in moved]
        assert made.size() == size
        before |= now
        for box in made.findChildren(QCheckBox):
            if box.isVisible():
                assert box.width() >= box.sizeHint().width(), box.text()
        for label in made.findChildren(QLabel):
            if label.isVisible() and not label.wordWrap():
                assert label.width() >= label.sizeHint().width(), label.text()
    assert made.width() <= 1280
    assert made.height() <= 680
    assert not made.targets.verticalScrollBar().isVisible()


class TestPresets:
    def test_a_preset_is_saved_chosen_renamed_and_removed(self, dialog: ExportDialog, place: Place) -> None:
        row = dialog.presets
        assert row.box.currentText() == "None saved yet"
        assert not row.rename_button.isEnabled()
        dialog.change(kind="after effects", mattes=("core",), copies=False)
        row.save("撮影へ / AE")
        assert row.box.currentText() == "撮影へ / AE"
        dialog.change(kind="layers")
        assert row.box.currentText() == "Choices of your own"
        row.save("plain")
        assert [row.box.itemText(each) for each in range(row.box.count())] == ["plain", "撮影へ / AE"]
        row.box.setCurrentIndex(1)
        row.box.activated.emit(1)
        assert dialog.choices == ExportChoices("after effects", mattes=("core",), copies=False)
        core = next(box for box in dialog.findChildren(QCheckBox) if "near the feet" in box.text())
        assert core.isChecked()
        assert dialog.targets.currentItem().text() == "After Effects"
        row.rename("to AE")
        assert row.box.currentText() == "to AE"
        assert len(list(place.folder.with_name("presets").iterdir())) == 2
        row.remove()
        assert row.box.currentText() == "Choices of your own"
        assert [preset.name for preset in presets_in(place.folder.with_name("presets"))[0]] == ["plain"]

    def test_a_name_is_saved_over_and_two_names_of_one_file_are_kept_apart(self, tmp_path: Path) -> None:
        first = save_preset(tmp_path, "a/b", ExportChoices())
        second = save_preset(tmp_path, "a_b", ExportChoices(depth=16))
        again = save_preset(tmp_path, " a/b ", ExportChoices(format="tga"))
        assert first.path == again.path != second.path
        assert {preset.name: preset.choices.format for preset in presets_in(tmp_path)[0]} == {
            "a/b": "tga",
            "a_b": "png",
        }
        with pytest.raises(UsageProblem, match="already"):
            rename_preset(tmp_path, again, "a_b")

    @pytest.mark.parametrize("name", ["", "   ", "x" * 81, "a\nb"])
    def test_what_is_no_name_is_refused(self, dialog: ExportDialog, name: str) -> None:
        dialog.presets.save(name)
        assert "1 to 80 printable characters" in dialog.says.text()
        assert dialog.presets.box.currentText() == "None saved yet"

    @pytest.mark.parametrize(
        ("text", "words"),
        [
            ("{", "not complete JSON"),
            ('{"export_preset": 2, "name": "a", "plan": {}}', "export_preset"),
            ('{"export_preset": 1, "name": "", "plan": {}}', "printable characters"),
            ("[" * 70000, "too large"),
        ],
    )
    def test_a_broken_file_is_told_and_the_others_are_there(
        self, qtbot: QtBot, filled: OpenProject, place: Place, tmp_path: Path, text: str, words: str
    ) -> None:
        save_preset(tmp_path / "presets", "good", ExportChoices())
        (tmp_path / "presets" / "bad.json").write_text(text, encoding="utf-8")
        made = ExportDialog(filled.bridge.document, ExportChoices(), place, tmp_path / "presets")
        qtbot.addWidget(made)
        assert "bad.json is not an export preset" in made.says.text()
        assert words in made.says.text()
        assert made.presets.box.currentText() == "good"
        assert made.go.isEnabled()

    def test_a_preset_of_a_layer_that_is_not_here_shows_the_picture(self, dialog: ExportDialog) -> None:
        dialog.show_choices(ExportChoices("video", format="mov", video_layer="Somebody"))
        assert lines(dialog) == ["walk.mov  6 @ 24 fps  240 × 200"]


def test_a_farm_needs_a_saved_project_and_every_export_a_folder(
    qtbot: QtBot, filled: OpenProject, tmp_path: Path
) -> None:
    made = ExportDialog(filled.bridge.document, ExportChoices("farm"), Place(tmp_path, None, "Untitled"), tmp_path)
    qtbot.addWidget(made)
    made.show()
    assert made.says.text() == "A farm renders a saved project; save this one first"
    assert not made.go.isEnabled()
    choose(made, "Shadow layers")
    assert made.go.isEnabled()
    made.folder.setText(" ")
    assert made.says.text() == "Choose a folder."
    assert not made.go.isEnabled()


def test_the_work_area_alone(filled: OpenProject, place: Place) -> None:
    document = review.set_work_area(filled.bridge.document, 2, 4)
    for choices, line in (
        (ExportChoices(only_work_area=True), "Walker_shadow/Walker_shadow_0002.png  × 3"),
        (ExportChoices(), "Walker_shadow/Walker_shadow_0001.png  × 6"),
    ):
        assert SHADOW_LAYERS.preview(document, choices, place) == (line,)


def test_nothing_to_export_is_said(open_project: OpenProject, place: Place) -> None:
    with pytest.raises(UsageProblem, match="nothing to render"):
        SHADOW_LAYERS.preview(open_project.bridge.document, ExportChoices(), place)


@pytest.mark.parametrize(
    "choices",
    [
        ExportChoices(),
        ExportChoices("after effects", per_drawing=True, mattes=("core", "lit"), copies=False),
        ExportChoices("farm", only_work_area=True, format="tiff", depth=16, chunk=24),
        ExportChoices("video", format="mov", video_layer="主役"),
    ],
)
def test_choices_are_remembered(choices: ExportChoices) -> None:
    assert loads_choices(dumps_choices(choices)) == choices


@pytest.mark.parametrize("text", ["", "{", "[1]", '{"kind": "film", "chunk": "x", "mattes": 3, "format": "bmp"}'])
def test_what_is_no_choice_is_the_usual_one(text: str) -> None:
    assert loads_choices(text) == ExportChoices()


def test_choices_are_made_sound() -> None:
    assert sound(ExportChoices(format="tga", depth=16)).depth == 8
    assert sound(ExportChoices("after effects", format="tiff")).format == "png"
    assert sound(ExportChoices(chunk=0)).chunk == 1
    assert sound(ExportChoices("layered")).format == "psd"
    assert sound(ExportChoices("layered", format="exr")).depth == 16
    assert sound(ExportChoices("layered", format="psd", depth=16)).depth == 16
    assert sound(ExportChoices("video", format="exr", depth=16)) == ExportChoices("video", format="mp4")


@pytest.mark.parametrize(
    ("kind", "made"),
    [
        ("layers", "walker_shadow/walker_shadow_0006.png"),
        ("layered", "layered/layered_0006.psd"),
        ("video", "walk.mp4"),
        ("after effects", "walk.jsx"),
        ("farm", "template.json"),
    ],
)
def test_the_window_exports_each_kind_beside_itself(
    qtbot: QtBot, walking: MainWindow, tmp_path: Path, kind: str, made: str
) -> None:
    walking.parts.open_project.save(tmp_path / "walk.kage")
    walking.parts.settings.set_word("export_plan", dumps_choices(ExportChoices(kind)))
    walking.parts.actions["export"].trigger()
    dialog = walking.findChild(ExportDialog)
    assert dialog is not None
    assert dialog.choices.kind == kind
    dialog.go.click()
    qtbot.waitUntil(lambda: not walking.parts.exporting.is_running)
    assert (tmp_path / "walk_export" / made).exists()
    result = walking.findChild(ExportResult)
    assert result is not None
    assert result.title.text() == "The export is complete."
    assert json.loads(walking.parts.settings.word("export_plan", ""))["kind"] == kind
    assert not list((tmp_path / "walk_export").rglob("*.part*"))


def test_what_a_hand_off_had_to_do_otherwise_is_told(walking: MainWindow, qtbot: QtBot, place: Place) -> None:
    def notes_shown() -> list[str]:
        qtbot.waitUntil(lambda: len(walking.findChildren(ExportResult)) == 1)
        return walking.findChildren(ExportResult)[0].notes

    choices = ExportChoices("after effects", copies=False)
    shown = walking.parts.open_project.bridge.document.layers[0].cels.drawings
    middle = shown[2].path
    middle.rename(middle.with_name("aside.png"))
    document = walking.parts.open_project.bridge.document
    layer = document.layers[0]
    kept = tuple(each for each in layer.cels.exposures if each.drawing != 2)
    walking.parts.open_project.bridge.session.edit("Expose", set_exposures(document, layer.id, kept))
    walking.parts.exporting.start(HAND_OFF.work(walking.parts.open_project.bridge.document, choices, place))
    qtbot.waitUntil(lambda: not walking.parts.exporting.is_running)
    assert notes_shown() == ["The drawings of 'walker' are not a sequence without gaps, so they were copied"]
    middle.with_name("aside.png").rename(middle)
    walking.parts.exporting.start(HAND_OFF.work(walking.parts.open_project.bridge.document, choices, place))
    qtbot.waitUntil(lambda: not walking.parts.exporting.is_running)
    assert notes_shown() == []


class TestResult:
    def exported(self, qtbot: QtBot, window: MainWindow, place: Place, choices: ExportChoices) -> ExportResult:
        document = window.parts.open_project.bridge.document
        window.parts.exporting.start(exporter_of(choices).work(document, choices, place))
        qtbot.waitUntil(lambda: not window.parts.exporting.is_running)
        qtbot.waitUntil(lambda: len(window.findChildren(ExportResult)) == 1)
        return window.findChildren(ExportResult)[0]

    @pytest.mark.parametrize(
        ("choices", "counts", "step"),
        [
            (
                ExportChoices(composite=True, receivers=True),
                [("Shadow frames", "6"), ("Mattes", "6"), ("Composites", "6")],
                "Import each folder as one sequence of 24 frames a second, with straight (unmatted) alpha.",
            ),
            (
                ExportChoices("layered", format="psd"),
                [("Layered frames", "6")],
                "Each file is one frame; Photoshop and Clip Studio Paint open it with its layers.",
            ),
            (
                ExportChoices("after effects", mattes=("core",)),
                [("Shadow frames", "6"), ("Mattes", "6"), ("Copies of the drawings", "6"), ("Script", "1")],
                "In After Effects: File > Scripts > Run Script File…, and choose walk.jsx.",
            ),
            (
                ExportChoices("video", format="mp4"),
                [("Video", "1")],
                "It plays in any player and browser: look at it, or send it round.",
            ),
        ],
    )
    def test_it_says_what_there_is_and_what_to_do_next(
        self,
        qtbot: QtBot,
        walking: MainWindow,
        place: Place,
        choices: ExportChoices,
        counts: list[tuple[str, str]],
        step: str,
    ) -> None:
        result = self.exported(qtbot, walking, place, choices)
        assert result.counts == counts
        assert result.steps[0] == step
        assert len(result.steps) in (2, 3)
        assert result.path.text().startswith(str(place.folder))
        files = [path for path in place.folder.rglob("*") if path.is_file() and not path.name.startswith(".")]
        assert len(files) == sum(int(count) for _, count in counts)

    def test_it_is_shown_and_copied(
        self, qtbot: QtBot, walking: MainWindow, place: Place, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        opened: list[str] = []

        def open_url(url: QUrl) -> bool:
            opened.append(url.toLocalFile())
            return len(opened) < 2

        monkeypatch.setattr("kagezou.ui.system.desktop.QDesktopServices.openUrl", open_url)
        result = self.exported(qtbot, walking, place, ExportChoices())
        qtbot.mouseClick(result.copy_button, Qt.MouseButton.LeftButton)
        assert QGuiApplication.clipboard().text() == str(place.folder)
        qtbot.mouseClick(result.show_button, Qt.MouseButton.LeftButton)
        assert opened == [str(place.folder)]
        assert not result.says.isVisible()
        qtbot.mouseClick(result.show_button, Qt.MouseButton.LeftButton)
        assert "No program of this desktop opens folders" in result.says.text()

    def test_a_second_export_takes_its_place_and_says_what_was_there(
        self, qtbot: QtBot, walking: MainWindow, place: Place
    ) -> None:
        self.exported(qtbot, walking, place, ExportChoices())
        result = self.exported(qtbot, walking, place, ExportChoices())
        words = " ".join(label.text() for label in result.findChildren(QLabel))
        assert "left as they were: 6" in words

    def test_a_stopped_export_says_what_is_there_and_how_to_go_on(
        self, qtbot: QtBot, walking: MainWindow, place: Place
    ) -> None:
        choices = ExportChoices("after effects")
        document = walking.parts.open_project.bridge.document
        work = HAND_OFF.work(document, choices, place)

        def slow(open_context: OpenContext, progress: Progress, cancelled: Cancelled) -> ExportOutcome:
            def note(finished: int, whole: int) -> None:
                progress(finished, whole)
                while finished == 8 and not cancelled():
                    Event().wait(0.01)

            return work(open_context, note, cancelled)

        exporting = walking.parts.exporting
        exporting.start(slow)
        bar, stop = exporting.findChild(QProgressBar), exporting.findChild(QToolButton)
        assert bar is not None
        assert stop is not None
        qtbot.waitUntil(lambda: (bar.value(), bar.maximum()) == (8, 13))
        qtbot.mouseClick(stop, Qt.MouseButton.LeftButton)
        qtbot.waitUntil(lambda: len(walking.findChildren(ExportResult)) == 1)
        result = walking.findChildren(ExportResult)[0]
        files = [path for path in place.folder.rglob("*") if path.is_file() and not path.name.startswith(".")]
        assert result.title.text() == f"The export was stopped: {len(files)} of 13 files are there, all whole."
        assert result.counts[0] == ("Shadow frames", "6")
        assert result.counts[2] == ("Script", "0 of 1")
        assert "it goes on where it was" in result.steps[1]
        assert result.steps[2] == "The script is written last, when all it needs is there."
        assert not list(place.folder.glob("*.jsx"))
        assert not list(place.folder.rglob("*.part*"))

    def test_what_was_written_before_a_problem_is_said_to_be_whole(self, qtbot: QtBot, walking: MainWindow) -> None:
        def failing(_open: OpenContext, progress: Progress, _cancelled: Cancelled) -> ExportOutcome:
            progress(2, 6)
            raise OutputProblem(Message("the disk refuses"))

        walking.parts.exporting.start(failing)
        qtbot.waitUntil(lambda: not walking.parts.exporting.is_running)
        said = walking.parts.bar.text
        assert said == "The disk refuses\nEvery file that was written before is whole and stays."
        assert walking.findChild(ExportResult) is None

        def failing_at_once(_open: OpenContext, _progress: Progress, _cancelled: Cancelled) -> ExportOutcome:
            raise OutputProblem(Message("the disk refuses"))

        walking.parts.exporting.start(failing_at_once)
        qtbot.waitUntil(lambda: not walking.parts.exporting.is_running)
        assert walking.parts.bar.text == "The disk refuses"


class TestPlaces:
    def test_an_export_goes_beside_its_project(self, settings: Settings, tmp_path: Path) -> None:
        project = tmp_path / "cut012.kage"
        assert place_for(settings, project, "cut012").folder == tmp_path / "cut012_export"

    def test_another_folder_is_remembered_for_its_project_alone(self, settings: Settings, tmp_path: Path) -> None:
        first, second = tmp_path / "a.kage", tmp_path / "b.kage"
        remember_place(settings, Place(tmp_path / "elsewhere", first, "a"))
        assert place_for(settings, first, "a").folder == tmp_path / "elsewhere"
        assert place_for(settings, second, "b").folder == tmp_path / "b_export"
        remember_place(settings, Place(tmp_path / "a_export", first, "a"))
        assert place_for(settings, first, "a").folder == tmp_path / "a_export"

    def test_a_disk_that_is_gone_is_not_proposed(self, settings: Settings, tmp_path: Path) -> None:
        project = tmp_path / "a.kage"
        remember_place(settings, Place(tmp_path / "stick" / "out", project, "a"))
        assert place_for(settings, project, "a").folder == tmp_path / "a_export"

    def test_an_unsaved_project_goes_to_the_documents_and_that_is_said(
        self, qtbot: QtBot, filled: OpenProject, settings: Settings, tmp_path: Path
    ) -> None:
        documents = QStandardPaths.writableLocation(QStandardPaths.StandardLocation.DocumentsLocation)
        place = place_for(settings, None, "Untitled")
        assert place.folder == Path(documents) / "Untitled_export"
        remember_place(settings, place)
        made = ExportDialog(filled.bridge.document, ExportChoices(), place, tmp_path)
        qtbot.addWidget(made)
        assert "not saved yet" in made.place_note.text()

    def test_what_is_remembered_is_bounded_and_may_be_spoilt(self, settings: Settings, tmp_path: Path) -> None:
        for number in range(MOST + 5):
            remember_place(settings, Place(tmp_path / "x", tmp_path / f"{number}.kage", str(number)))
        assert place_for(settings, tmp_path / "0.kage", "0").folder == tmp_path / "0_export"
        assert place_for(settings, tmp_path / f"{MOST}.kage", "n").folder == tmp_path / "x"
        settings.set_word("export_folders", "{")
        assert place_for(settings, tmp_path / f"{MOST}.kage", "n").folder == tmp_path / "n_export"


def test_files_are_called_as_it_is_typed(filled: OpenProject, place: Place, tmp_path: Path) -> None:
    made = ExportDialog(filled.bridge.document, ExportChoices(), place, tmp_path)
    naming = made.options.naming
    naming.pattern.setEditText("{layer}_{kind}.{frame:04d}")
    naming.start.setValue(1001)
    assert lines(made) == ["Walker_shadow.1001.png  × 6"]
    assert (made.choices.names, made.choices.start) == ("{layer}_{kind}.{frame:04d}", 1001)
    naming.pattern.setEditText("{layer}_{shot}")
    assert "{shot}" in made.says.text()
    assert not made.go.isEnabled()
    assert naming.pattern.currentText() == "{layer}_{shot}"
    naming.pattern.setEditText("")
    naming.start.setValue(naming.start.minimum())
    assert lines(made) == ["Walker_shadow/Walker_shadow_0001.png  × 6"]
    assert made.go.isEnabled()
