"""Loading beside the window: the window lives on, a load can be given up, fails in one sentence, and waits its turn."""

import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from time import sleep

import numpy as np
import pytest
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from kagezou.document.address import Address
from kagezou.document.edits import set_constant
from kagezou.document.properties import GROUND_ROLL
from kagezou.document.review import set_work_area
from kagezou.errors import InputProblem
from kagezou.importing import cel_sizes
from kagezou.importing.progress import Cancelled, LoadPhase, Progress
from kagezou.importing.staging import CharacterSource, new_document
from kagezou.io.images import cel_cache as cels_room
from kagezou.io.images.reading import Cel, ImageInfo, probe, read_cel
from kagezou.io.project import file as project_file
from kagezou.ui.project import loading
from kagezou.ui.project.dialogs import Answer
from kagezou.ui.project.load import Load
from kagezou.ui.project.loading import Loading
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.project.reading_ahead import played_drawings
from kagezou.ui.viewport import reading
from kagezou.ui.window.main_window import MainWindow
from tests.ui.viewing import picture, write_garbage


@pytest.fixture(autouse=True)
def impatient(patient: None, monkeypatch: pytest.MonkeyPatch) -> None:  # noqa: ARG001 - comes after it
    monkeypatch.setattr(loading, "PATIENCE_S", 0.0)


def slow_down(monkeypatch: pytest.MonkeyPatch, wait: Callable[[Path], None]) -> None:
    """Have something waited for before each drawing's header is read."""

    def slow(path: Path) -> ImageInfo:
        wait(path)
        return probe(path)

    monkeypatch.setattr(cel_sizes, "probe", slow)


class Gate:
    """A reader that waits on a disk far away, until it is let through; looked at by the load's watch between files."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.opened = threading.Event()
        self.reached = threading.Event()

        def wait(_path: Path) -> None:
            self.reached.set()
            assert self.opened.wait(30)

        slow_down(monkeypatch, wait)


@pytest.fixture
def gate(monkeypatch: pytest.MonkeyPatch) -> Iterator[Gate]:
    made = Gate(monkeypatch)
    yield made
    made.opened.set()


def end_of_loading_threads() -> None:
    """Wait until no load reads any more, and let the window look at what came of it."""
    for thread in threading.enumerate():
        if thread.name == "load":
            thread.join(30)
            assert not thread.is_alive()
    QApplication.processEvents()


def end_of_reading(gate: Gate) -> None:
    """Let the reader through, and wait until all of it has been read."""
    gate.opened.set()
    end_of_loading_threads()


class Heart:
    """Beats in the event loop."""

    def __init__(self) -> None:
        self.beats = 0
        self.has_beaten = threading.Event()
        self._timer = QTimer()
        self._timer.setInterval(5)
        self._timer.timeout.connect(self._beat)
        self._timer.start()

    def _beat(self) -> None:
        self.beats += 1
        self.has_beaten.set()


def test_the_window_lives_on_while_drawings_are_read(qtbot: QtBot, window: MainWindow, cels: Path, gate: Gate) -> None:
    window.parts.project.bring([cels])
    heart = Heart()
    bar = window.parts.project.loading

    qtbot.waitUntil(lambda: gate.reached.is_set() and heart.beats > 5)
    assert bar.isVisible()
    assert cels.name in bar.text
    assert window.parts.open_project.is_blank

    gate.opened.set()
    qtbot.waitUntil(lambda: not window.parts.open_project.is_blank)
    assert not bar.isVisible()
    assert [layer.name for layer in window.parts.open_project.bridge.document.layers] == [cels.name]


def test_events_are_handled_while_hundreds_of_slow_files_are_read(
    qtbot: QtBot, window: MainWindow, cels: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = next(iter(sorted(cels.iterdir()))).read_bytes()
    for number in range(100, 400):
        (cels / f"walk_{number:04d}.png").write_bytes(first)
    heart = Heart()
    read = 0

    def wait(_path: Path) -> None:
        nonlocal read
        read += 1
        if read % 10 == 0:
            # On the window's own thread nobody could answer.
            heart.has_beaten.clear()
            assert heart.has_beaten.wait(30), "events are handled while a file is read"

    slow_down(monkeypatch, wait)
    window.parts.project.bring([cels])
    qtbot.waitUntil(lambda: not window.parts.project.loading.is_running)
    assert len(window.parts.open_project.bridge.document.layers[0].cels.drawings) == 306
    assert read >= 306
    assert heart.beats >= 30


def test_a_load_given_up_leaves_everything_as_it_was(qtbot: QtBot, walking: MainWindow, cels: Path, gate: Gate) -> None:
    session, document = walking.parts.open_project.bridge.session, walking.parts.open_project.bridge.document
    steps = session.history.made

    walking.parts.project.bring([cels])
    qtbot.waitUntil(gate.reached.is_set)
    walking.parts.project.loading.cancel_button.click()

    assert not walking.parts.project.loading.isVisible()
    end_of_reading(gate)
    assert walking.parts.open_project.bridge.document is document
    assert session.history.made == steps
    assert walking.parts.bar.text == ""


def test_a_load_that_fails_says_one_sentence(qtbot: QtBot, walking: MainWindow, tmp_path: Path) -> None:
    document = walking.parts.open_project.bridge.document
    (tmp_path / "empty").mkdir()

    walking.parts.project.bring([tmp_path / "empty"])
    qtbot.waitUntil(lambda: walking.parts.bar.text != "")

    assert walking.parts.bar.text.endswith("empty: there is no picture in this folder")
    assert walking.parts.open_project.bridge.document is document


def test_files_outside_the_projects_folder_are_said_when_it_is_opened_first(
    qtbot: QtBot, window: MainWindow, filled: OpenProject, tmp_path: Path
) -> None:
    project = tmp_path / "sent" / "walk.kage"
    project.parent.mkdir()
    project_file.save(filled.bridge.document, project)
    said: list[str] = []
    filled.noted.connect(lambda note: said.append(str(note)))
    for _ in range(2):
        window.parts.project.open_path(project)
        qtbot.waitUntil(lambda: filled.path == project and not window.parts.project.loading.is_running)
        filled.clear()
    assert len(said) == 1
    assert "outside the project's folder" in said[0]


def test_what_is_dropped_while_another_loads_comes_after_it(
    qtbot: QtBot, window: MainWindow, cels: Path, tmp_path: Path, gate: Gate
) -> None:
    still = tmp_path / "still.png"
    still.write_bytes(next(cels.iterdir()).read_bytes())

    window.parts.project.bring([cels])
    window.parts.project.bring([still])
    gate.opened.set()

    qtbot.waitUntil(lambda: len(window.parts.open_project.bridge.document.layers) == 2)
    assert [layer.name for layer in window.parts.open_project.bridge.document.layers] == [cels.name, "still"]


def test_another_project_takes_the_place_of_what_still_loads(
    qtbot: QtBot, window: MainWindow, cels: Path, tmp_path: Path, gate: Gate
) -> None:
    project = tmp_path / "other.kage"
    project_file.save(new_document(()).document, project)

    window.parts.project.bring([cels])
    window.parts.project.open_path(project)
    gate.opened.set()

    qtbot.waitUntil(lambda: not window.parts.project.loading.is_running)
    end_of_reading(gate)
    assert window.parts.open_project.path == project
    assert window.parts.open_project.is_blank


def test_a_character_comes_into_the_document_as_it_went_on_meanwhile(
    qtbot: QtBot, walking: MainWindow, cels: Path, gate: Gate
) -> None:
    walking.parts.project.bring([cels])
    qtbot.waitUntil(gate.reached.is_set)
    bridge = walking.parts.open_project.bridge
    bridge.session.edit("Tilt", set_constant(bridge.document, Address(GROUND_ROLL), 7.0))
    gate.opened.set()

    qtbot.waitUntil(lambda: len(bridge.document.layers) == 2)
    assert bridge.document.tracks["ground.roll"].constant == 7.0


def test_nothing_is_put_into_the_middle_of_a_drag(qtbot: QtBot, walking: MainWindow, cels: Path, gate: Gate) -> None:
    walking.parts.project.bring([cels])
    bridge = walking.parts.open_project.bridge
    drag = bridge.session.begin("Drag")
    end_of_reading(gate)
    # Looked at once more, it still may not be put.
    walking.parts.project.loading._look()
    assert len(bridge.document.layers) == 1

    drag.cancel()
    qtbot.waitUntil(lambda: len(bridge.document.layers) == 2)


def test_work_done_while_a_project_loads_is_asked_about(
    qtbot: QtBot, walking: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    project = tmp_path / "other.kage"
    project_file.save(new_document(()).document, project)
    opened = threading.Event()
    load = project_file.load
    monkeypatch.setattr(project_file, "load", lambda path: (opened.wait(30), load(path))[1])
    monkeypatch.setattr(walking.parts.project.dialogs, "unsaved", lambda _name: Answer.CANCEL)

    walking.parts.project.open_path(project)
    bridge = walking.parts.open_project.bridge
    bridge.session.edit("Tilt", set_constant(bridge.document, Address(GROUND_ROLL), 7.0))
    opened.set()
    qtbot.waitUntil(lambda: not walking.parts.project.loading.is_running)

    assert bridge.document.tracks["ground.roll"].constant == 7.0
    assert walking.parts.open_project.path is None
    bridge.session.mark_saved()


def test_the_window_closes_while_a_load_hangs(qtbot: QtBot, window: MainWindow, cels: Path, gate: Gate) -> None:
    window.parts.project.bring([cels])
    qtbot.waitUntil(gate.reached.is_set)

    assert window.close()

    assert not window.parts.project.loading.is_running
    gate.opened.set()
    QApplication.processEvents()
    assert window.parts.open_project.is_blank


@pytest.mark.usefixtures("qapp")
def test_the_bar_counts_and_tells_what_is_left(qtbot: QtBot, monkeypatch: pytest.MonkeyPatch) -> None:
    go_on = threading.Event()
    put: list[int] = []

    def read(progress: Progress) -> int:
        progress(LoadPhase.READING, 0, 8)
        sleep(0.05)
        progress(LoadPhase.READING, 2, 8)
        assert go_on.wait(30)
        return 3

    monkeypatch.setattr(loading, "_TELL_AFTER_S", 0.0)
    bar = Loading(lambda _problem: None, lambda: True)
    qtbot.addWidget(bar)
    bar.start(Load("walk", read, put.append))

    qtbot.waitUntil(lambda: bar.left_text.startswith("3 of 8"))
    assert bar.text == "Reading drawings of walk"
    assert bar.left_text.endswith("s left")
    go_on.set()
    qtbot.waitUntil(lambda: put == [3])


def _staged(progress: Progress, cels: Path) -> object:
    return new_document((CharacterSource(None, cels),), progress=progress)


def test_staging_tells_each_part_and_can_be_stopped_in_each(cels: Path) -> None:
    parts: list[LoadPhase] = []

    def listen(part: LoadPhase, done: int, whole: int) -> None:
        assert 0 <= done <= whole
        parts.append(part)

    _staged(listen, cels)
    assert list(dict.fromkeys(parts)) == [LoadPhase.FINDING, LoadPhase.OPENING, LoadPhase.MEASURING, LoadPhase.LIGHTING]

    def stop_at(wanted: LoadPhase) -> Callable[[LoadPhase, int, int], None]:
        def progress(part: LoadPhase, _done: int, _whole: int) -> None:
            if part is wanted:
                raise Cancelled

        return progress

    for wanted in dict.fromkeys(parts):
        with pytest.raises(Cancelled):
            _staged(stop_at(wanted), cels)


def test_what_a_quick_load_says_comes_at_once(
    walking: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(loading, "PATIENCE_S", 30.0)

    assert not walking.parts.project.open_path(tmp_path / "none.kage")
    with pytest.raises(InputProblem):
        walking.parts.open_project.bring((CharacterSource(None, tmp_path / "none"),)).at_once()


def test_the_work_area_is_read_into_memory_and_that_can_be_stopped(
    qtbot: QtBot, walking: MainWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    open_project = walking.parts.open_project
    open_project.cels.clear()
    go_on = threading.Event()
    read = open_project.cels.cel
    reached = threading.Event()

    def slow(path: Path) -> Cel:
        if path.stem.endswith("4"):
            reached.set()
            assert go_on.wait(30)
        return read(path)

    monkeypatch.setattr(open_project.cels, "cel", slow)
    bridge = open_project.bridge
    bridge.session.edit("Work area", set_work_area(bridge.document, 2, 5))
    walking.parts.actions["read_ahead"].trigger()
    qtbot.waitUntil(lambda: walking.parts.project.loading.left_text.startswith("3 of 4"))
    qtbot.waitUntil(reached.is_set)
    walking.parts.project.loading.cancel_button.click()
    go_on.set()
    end_of_loading_threads()
    assert not set(played_drawings(bridge.document)) <= open_project.cels.kept_sources()

    walking.parts.actions["read_ahead"].trigger()
    qtbot.waitUntil(lambda: set(played_drawings(bridge.document)) <= open_project.cels.kept_sources())
    bridge.session.mark_saved()


def test_reading_ahead_gives_way_to_what_is_dropped(qtbot: QtBot, walking: MainWindow, cels: Path) -> None:
    walking.parts.open_project.cels.clear()
    go_on = threading.Event()

    def hang(_watch: Progress) -> None:
        assert go_on.wait(30)

    walking.parts.project.loading.start(Load("ahead", hang, lambda _: None, gives_way=True))
    walking.parts.project.bring([cels])
    qtbot.waitUntil(lambda: len(walking.parts.open_project.bridge.document.layers) == 2)
    go_on.set()


def test_a_frame_whose_drawing_is_slow_keeps_the_last_picture_until_it_is_there(
    qtbot: QtBot, walking: MainWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(reading, "PATIENCE_S", 0.0)
    viewport, open_project = walking.parts.viewport, walking.parts.open_project
    before = picture(viewport)
    go_on = threading.Event()

    def slow(path: Path, *, white_is_clear: bool = True) -> Cel:
        assert go_on.wait(30)
        return read_cel(path, white_is_clear=white_is_clear)

    monkeypatch.setattr(cels_room, "read_cel", slow)
    open_project.cels.clear()
    open_project.bridge.session.go_to(3)
    stays = picture(viewport)
    assert np.array_equal(stays, before)
    assert not viewport.is_current

    go_on.set()
    qtbot.waitUntil(lambda: viewport.is_current)
    assert not np.array_equal(picture(viewport), before)


def test_a_drawing_that_cannot_be_read_is_told_after_the_picture_is_drawn_without_it(
    qtbot: QtBot, walking: MainWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(reading, "PATIENCE_S", 0.0)
    path = walking.parts.open_project.bridge.document.layers[0].cels.drawings[1].path
    write_garbage(path)
    walking.parts.open_project.bridge.session.go_to(2)
    qtbot.waitUntil(lambda: walking.parts.bar.text.startswith(str(path)))
    assert walking.parts.viewport.is_current
