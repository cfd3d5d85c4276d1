"""The whole window: projects come, are saved and go; what is wrong is said and the rest goes on."""

from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, QPointF
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from kagezou.document import properties
from kagezou.document.address import Address
from kagezou.document.edits import set_value
from kagezou.document.set_pieces import add_piece
from kagezou.geometry.sets.measures import PieceKind
from kagezou.io.project import file as project_file
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.ui.application import Application
from kagezou.ui.export.dialog import ExportDialog
from kagezou.ui.export.result import ExportResult
from kagezou.ui.project.dialogs import Answer
from kagezou.ui.system.settings import Settings
from kagezou.ui.viewport import frame_painter, picture_widget
from kagezou.ui.widgets.message_bar import Severity
from kagezou.ui.window.bars import TopBars
from kagezou.ui.window.main_window import MainWindow
from tests.ui import held_files
from tests.ui.viewing import drag, picture, shadow_is_on_canvas, write_garbage


class Replies:
    """Stands in for the dialogs, with answers given beforehand."""

    def __init__(self, path: Path | None = None, answer: Answer = Answer.CANCEL) -> None:
        self.path = path
        self.answer = answer
        self.asked: list[str] = []

    def __getattr__(self, name: str) -> object:
        def reply(*_: object) -> object:
            self.asked.append(name)
            if name == "unsaved":
                return self.answer
            return [self.path] if name == "pictures" else self.path

        return reply


def reply(window: MainWindow, path: Path | None = None, answer: Answer = Answer.CANCEL) -> Replies:
    replies = Replies(path, answer)
    window.parts.project.dialogs = replies  # type: ignore[assignment]
    return replies


def drop(window: MainWindow, *paths: Path, over: QWidget | None = None) -> None:
    data, place = held_files.carried(paths), QPointF(300, 300)
    assert held_files.hold(over or window, data, place).isAccepted()
    held_files.let_go(window, data, place)


def test_an_empty_window_says_where_to_begin(window: MainWindow) -> None:
    assert window.pages.currentWidget() is window.parts.welcome
    assert not window.parts.actions["export"].isEnabled()
    assert not window.parts.time.transport.isVisible()
    assert window.windowTitle() == "Untitled[*] — Kagezou"
    assert not window.isWindowModified()


def test_a_folder_dropped_on_the_window_becomes_a_layer(qtbot: QtBot, window: MainWindow, cels: Path) -> None:
    drop(window, cels)
    qtbot.waitUntil(lambda: window.parts.viewport.frame_painter is not None)
    assert [layer.name for layer in window.parts.open_project.bridge.document.layers] == ["walker"]
    assert window.parts.open_project.bridge.document.canvas.length_frames == 6
    assert shadow_is_on_canvas(window)
    assert window.isWindowModified()
    drop(window, cels, over=window.parts.panels.layers.view.viewport())
    assert [layer.name for layer in window.parts.open_project.bridge.document.layers] == ["walker", "walker 2"]
    window.parts.actions["undo"].trigger()
    window.parts.actions["undo"].trigger()
    assert window.pages.currentWidget() is window.parts.welcome


def test_something_useless_dropped_is_said(window: MainWindow, tmp_path: Path) -> None:
    (tmp_path / "notes.txt").write_text("x", encoding="utf-8")
    drop(window, tmp_path / "notes.txt")
    assert "notes.txt" in window.parts.bar.text
    assert window.parts.bar.isVisible()


def test_save_open_and_recent(walking: MainWindow, tmp_path: Path, cels: Path) -> None:
    project = tmp_path / "cut 12"
    reply(walking, project)
    document = set_value(walking.parts.open_project.bridge.document, Address(properties.GROUND_DECLINATION), 45.0, 1)
    walking.parts.open_project.bridge.session.edit("Lower", document)
    assert walking.isWindowModified()
    walking.parts.actions["save"].trigger()
    assert not walking.isWindowModified()
    assert walking.windowTitle() == "cut 12[*] — Kagezou"
    assert project_file.load(project.with_suffix(".kage")) == document
    assert walking.parts.settings.recent == [project.with_suffix(".kage")]

    reply(walking, cels)
    walking.parts.actions["new"].trigger()
    assert walking.parts.open_project.path is None
    assert walking.isWindowModified()
    replies = reply(walking, project.with_suffix(".kage"), Answer.DISCARD)
    walking.parts.actions["open"].trigger()
    assert replies.asked == ["unsaved", "project_to_open"]
    assert walking.parts.open_project.bridge.document == document
    assert walking.parts.open_project.is_saved
    assert shadow_is_on_canvas(walking)


def test_a_project_that_cannot_be_opened_leaves_everything(walking: MainWindow, tmp_path: Path) -> None:
    before = walking.parts.open_project.bridge.document
    (tmp_path / "broken.kage").write_text("{", encoding="utf-8")
    reply(walking, tmp_path / "broken.kage")
    walking.parts.actions["open"].trigger()
    assert walking.parts.open_project.bridge.document is before
    assert "broken.kage" in walking.parts.bar.text


@pytest.mark.parametrize(
    ("answer", "closes", "is_saved"),
    [(Answer.CANCEL, False, False), (Answer.DISCARD, True, False), (Answer.SAVE, True, True)],
)
def test_closing_asks_when_something_is_unsaved(
    walking: MainWindow, tmp_path: Path, answer: Answer, *, closes: bool, is_saved: bool
) -> None:
    document = set_value(walking.parts.open_project.bridge.document, Address(properties.GROUND_ROLL), 5.0, 1)
    walking.parts.open_project.bridge.session.edit("Roll", document)
    replies = reply(walking, tmp_path / "cut.kage", answer)
    assert walking.close() is closes
    assert replies.asked[0] == "unsaved"
    assert (tmp_path / "cut.kage").is_file() is is_saved


def test_closing_a_saved_project_asks_nothing(walking: MainWindow) -> None:
    replies = reply(walking)
    assert walking.close()
    assert replies.asked == []


def test_a_broken_cel_is_named_and_the_rest_is_shown(qtbot: QtBot, walking: MainWindow, cels: Path) -> None:
    walking.parts.project.bring([cels])
    document = walking.parts.open_project.bridge.document
    write_garbage(cels / "walk_0003.png")
    walking.parts.open_project.bridge.session.go_to(3)
    qtbot.waitUntil(lambda: "walk_0003.png" in walking.parts.bar.text)
    assert walking.parts.bar.isVisible()
    assert document is walking.parts.open_project.bridge.document
    walking.parts.open_project.bridge.session.go_to(4)
    qtbot.waitUntil(lambda: walking.parts.bar.text == "")
    assert shadow_is_on_canvas(walking)


def test_a_set_that_is_too_large_to_work_with_is_left_out_and_said(
    qtbot: QtBot, walking: MainWindow, cels: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    walking.parts.project.bring([cels])
    monkeypatch.setattr(frame_painter, "MOST_AT_HAND", 4)
    session = walking.parts.open_project.bridge.session
    session.edit("set", add_piece(session.document, "stairs", PieceKind.STEPS, {"count": 5}))
    qtbot.waitUntil(lambda: "left out here, but not of what is exported: stairs" in walking.parts.bar.text)
    session.undo()
    qtbot.waitUntil(lambda: walking.parts.bar.text == "")


def test_a_missing_cel_leaves_the_other_layer(qtbot: QtBot, walking: MainWindow, cels: Path, tmp_path: Path) -> None:
    still = tmp_path / "still.png"
    still.write_bytes((cels / "walk_0001.png").read_bytes())
    walking.parts.project.bring([still])
    still.unlink()
    walking.parts.viewport.reread()
    qtbot.waitUntil(lambda: "still.png" in walking.parts.bar.text)
    assert shadow_is_on_canvas(walking)


def test_undo_and_redo_are_named_and_follow_the_frame(qtbot: QtBot, walking: MainWindow) -> None:
    walking.parts.open_project.bridge.session.go_to(4)
    drag(qtbot, walking.parts.viewport, "ground.position", QPoint(10, 5))
    walking.parts.open_project.bridge.session.go_to(1)
    walking.parts.actions["undo"].trigger()
    assert walking.parts.open_project.bridge.frame == 4
    assert walking.parts.actions["redo"].text() == "&Redo Move Ground"
    assert walking.isWindowModified() is False


def test_frame_commands(walking: MainWindow) -> None:
    bridge, actions = walking.parts.open_project.bridge, walking.parts.actions
    for name, frame in (("forward", 2), ("last", 6), ("back", 5), ("first", 1), ("forward_10", 6), ("back_10", 1)):
        actions[name].trigger()
        assert bridge.frame == frame, name
    walking.parts.panels.inspector.row("ground.roll").edited.toggle_key()
    bridge.session.go_to(4)
    walking.parts.panels.inspector.row("ground.roll").edited.toggle_key()
    actions["key_previous"].trigger()
    assert bridge.frame == 1
    actions["key_next"].trigger()
    assert bridge.frame == 4


def test_backdrops_change_the_picture(walking: MainWindow) -> None:
    seen = set()
    for backdrop in (Backdrop.CHECKER, Backdrop.GREY, Backdrop.WHITE):
        walking.parts.viewport.show_backdrop(backdrop)
        seen.add(picture(walking.parts.viewport).tobytes())
    assert len(seen) == 3


def test_delete_removes_the_layer_while_the_list_has_the_focus(
    walking: MainWindow, focus: Callable[[QWidget], None]
) -> None:
    focus(walking.parts.panels.layers.view)
    walking.parts.actions["delete"].trigger()
    assert walking.parts.open_project.bridge.document.layers == ()


def start_export(window: MainWindow, folder: Path) -> None:
    window.parts.actions["export"].trigger()
    dialog = window.findChild(ExportDialog)
    assert dialog is not None
    assert window.help.place_of(dialog.folder) == ("export", "")
    dialog.folder.setText(str(folder))
    dialog.go.click()


def test_the_export_runs_beside_the_window(qtbot: QtBot, walking: MainWindow, tmp_path: Path) -> None:
    start_export(walking, tmp_path / "out")
    assert walking.parts.exporting.is_running
    qtbot.waitUntil(lambda: not walking.parts.exporting.is_running)
    files = sorted((tmp_path / "out" / "walker_shadow").glob("*.png"))
    assert [file.name for file in files] == [f"walker_shadow_{frame:04d}.png" for frame in range(1, 7)]
    result = walking.findChild(ExportResult)
    assert result is not None
    assert result.title.text() == "The export is complete."
    assert walking.help.place_of(result.title) == ("export", "")


def test_an_export_that_cannot_be_made_is_said(qtbot: QtBot, walking: MainWindow, cels: Path, tmp_path: Path) -> None:
    (cels / "walk_0002.png").unlink()
    start_export(walking, tmp_path / "out")
    qtbot.waitUntil(lambda: not walking.parts.exporting.is_running)
    assert "walk_0002.png" in walking.parts.bar.text


def test_a_driver_that_is_too_old_is_said_in_words(
    qtbot: QtBot, monkeypatch: pytest.MonkeyPatch, window: MainWindow, cels: Path
) -> None:
    monkeypatch.setattr(picture_widget, "NEEDED_VERSION", (9, 9))
    window.parts.project.bring([cels])
    qtbot.waitUntil(lambda: "OpenGL" in window.parts.bar.text)
    assert "needs 3.3" in window.parts.bar.text


def test_another_language_makes_another_window_over_the_same_project(
    qtbot: QtBot, qapp: QApplication, settings: Settings, walking: MainWindow, cels: Path
) -> None:
    walking.close_unasked()
    program = Application(qapp, settings)
    program.show()
    program.window.parts.project.bring([cels])
    document, old = program.open_project.bridge.document, program.window
    program.speak("ja")
    assert program.window is not old
    assert program.open_project.bridge.document is document
    assert program.window.parts.actions["save"].text() == "保存(&S)"
    assert program.window.parts.panels.inspector.row("tilt").label.text() == "体の傾き"
    qtbot.waitUntil(lambda: program.window.parts.viewport.frame_painter is not None)
    assert shadow_is_on_canvas(program.window)
    program.put_away()


def test_the_demo_is_made_once_and_opened(
    qtbot: QtBot, qapp: QApplication, settings: Settings, window: MainWindow, tmp_path: Path
) -> None:
    window.close_unasked()
    made: list[Path] = []

    def make(folder: Path, progress: object) -> Path:
        assert callable(progress)
        progress(1, 1)
        made.append(folder)
        folder.mkdir()
        window.parts.open_project.new(()).at_once()
        project_file.save(window.parts.open_project.bridge.document, folder / "demo.kage")
        return folder / "demo.kage"

    program = Application(qapp, settings, make)
    assert program.window.parts.demo is not None
    program.window.parts.demo._folder = tmp_path / "demo"
    program.show()
    for _ in range(2):
        program.window.parts.welcome.demo_asked.emit()
        qtbot.waitUntil(lambda: program.open_project.path == tmp_path / "demo" / "demo.kage")
        program.open_project.clear()
    assert len(made) == 1
    program.put_away()


def test_a_message_that_stands_leaves_the_window_at_rest(walking: MainWindow, monkeypatch: pytest.MonkeyPatch) -> None:
    placed: list[TopBars] = []
    place = TopBars._place

    def counted(bars: TopBars) -> None:
        placed.append(bars)
        place(bars)

    monkeypatch.setattr(TopBars, "_place", counted)
    walking.parts.bar.say("stands", "A message " * 30, Severity.WARNING)
    for _turn in range(20):
        QApplication.processEvents()
    assert placed
    needed = walking.parts.bar.heightForWidth(walking.pages.width())
    assert walking.top_bars.height() == walking.parts.bar.height() == needed
    placed.clear()
    for _turn in range(20):
        QApplication.processEvents()
    assert placed == []


def test_a_message_never_moves_the_picture(qtbot: QtBot, walking: MainWindow) -> None:
    before = walking.parts.viewport.geometry()
    walking.parts.bar.say("note", "Something to know", Severity.NOTE)
    QApplication.processEvents()
    assert walking.parts.bar.isVisible()
    assert walking.top_bars.isVisible()
    assert walking.top_bars.width() == walking.pages.width()
    assert walking.parts.viewport.geometry() == before
    qtbot.waitUntil(lambda: walking.parts.bar.height() >= walking.parts.bar.minimumSizeHint().height())
    assert walking.top_bars.height() == walking.parts.bar.height()
    walking.parts.bar.clear()
    qtbot.waitUntil(lambda: not walking.top_bars.isVisible())
