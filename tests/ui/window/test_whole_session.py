"""A whole session, as somebody has it: from a dropped folder to the exported shadows, with a crash on the way.

Where ``KAGEZOU_SCREENSHOTS`` names a folder, it is gone through in both sizes and both languages, and each state is
kept there as a picture to be looked at.
"""

import os
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from time import sleep

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from kagezou.animation.track import Interpolation
from kagezou.document.address import Address, track_of, value_of
from kagezou.document.properties import GROUND_DECLINATION, LIGHT_POSITION
from kagezou.importing.progress import LoadPhase, Progress
from kagezou.io.images.reading import read_cel
from kagezou.io.project.file import load
from kagezou.ui.application import Application
from kagezou.ui.export.dialog import ExportDialog
from kagezou.ui.project import loading
from kagezou.ui.project.load import Load
from kagezou.ui.project.recovery import RecoveryDialog
from kagezou.ui.system.settings import Settings
from kagezou.ui.window.main_window import MainWindow
from tests.ui import held_files
from tests.ui.project.test_recovery import OTHER_PROGRAM
from tests.ui.viewing import drag, move

LIGHT = Address(LIGHT_POSITION)
FOLDER = os.environ.get("KAGEZOU_SCREENSHOTS", "")
LARGE, SMALL = (1920, 1080), (1280, 720)
LEFT, NONE = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier

pytestmark = pytest.mark.skipif(os.name != "posix", reason="SIGKILL is POSIX's")


class Person:
    """Sits before the program: starts it, uses its widgets, and keeps pictures of what is seen.

    Parameters
    ----------
    size
        Of the window, px.
    language
        What the window speaks.
    """

    def __init__(self, qtbot: QtBot, settings: Settings, size: tuple[int, int], language: str) -> None:
        self.qtbot, self._settings, self._size = qtbot, settings, size
        self._name = f"{size[0]}x{size[1]}_{language}"
        self._shots = 0
        settings.language = language
        self.program = self._started()

    @property
    def window(self) -> MainWindow:
        return self.program.window

    def restart(self) -> None:
        self.program.put_away()
        self.program = self._started()

    def drop(self, path: Path) -> None:
        """Let go of a file or folder over the window."""
        data, middle = held_files.carried([path]), QPointF(self.window.rect().center())
        held_files.hold(self.window, data, middle, LEFT)
        self.keep_picture("held_over_the_window")
        held_files.let_go(self.window, data, middle, LEFT)
        self.see_picture()

    def see_picture(self) -> None:
        viewport = self.window.parts.viewport
        self.qtbot.waitUntil(lambda: viewport.frame_painter is not None and viewport.frame_painter.pictures_drawn > 0)
        QApplication.processEvents()

    def go_to(self, frame: int) -> None:
        """Type a frame."""
        field = self.window.parts.time.transport.frame_field
        field.setFocus()
        field.selectAll()
        self.qtbot.keyClicks(field, str(frame))
        self.qtbot.keyClick(field, Qt.Key.Key_Return)
        assert self.window.parts.open_project.bridge.frame == frame

    def do(self, *names: str) -> None:
        for name in names:
            self.window.parts.actions[name].trigger()
            QApplication.processEvents()

    def drag_key(self, frame: int, frames_on: int) -> None:
        """Drag a key of the lamp along the timeline."""
        timeline = self.window.parts.time.timeline
        row = next(index for index, each in enumerate(timeline.rows.rows) if each.addresses == (LIGHT,))
        start = QPointF(timeline.scale.middle_of(frame), timeline.rows.top_of(row) + timeline.rows.row_px / 2)
        way = QPointF(frames_on * timeline.scale.cell_px, 0)
        lanes = timeline.lanes
        QTest.mousePress(lanes, LEFT, NONE, start.toPoint())
        for part in (1, 2, 3, 4):
            move(lanes, start + way * part / 4, LEFT)
        QTest.mouseRelease(lanes, LEFT, NONE, (start + way).toPoint())

    def dialog(self, kind: type[ExportDialog] | type[RecoveryDialog]) -> ExportDialog | RecoveryDialog:
        self.qtbot.waitUntil(lambda: bool(self.window.findChildren(kind)))
        return self.window.findChildren(kind)[0]

    def keep_picture(self, name: str) -> None:
        """Keep what the screen shows, if it is asked for."""
        self._shots += 1
        if not FOLDER:
            return
        for _ in range(30):
            QApplication.processEvents()
            QTest.qWait(10)
        folder = Path(FOLDER) / self._name
        folder.mkdir(parents=True, exist_ok=True)
        width, height = self._size
        screen = QGuiApplication.primaryScreen().grabWindow(0, 0, 0, width, height)
        assert screen.save(str(folder / f"{self._shots:02d}_{name}.png"))

    def _started(self) -> Application:
        program = Application(QApplication.instance(), self._settings)  # type: ignore[arg-type]
        program.window.move(0, 0)
        program.window.resize(*self._size)
        program.show()
        program.window.resize(*self._size)
        self.qtbot.waitExposed(program.window)
        return program


@pytest.fixture
def meet(qtbot: QtBot, settings: Settings) -> Iterator[Callable[[tuple[int, int], str], Person]]:
    if QGuiApplication.platformName() == "offscreen":
        pytest.skip("no display that can show OpenGL; run under Xvfb")
    people: list[Person] = []

    def made(size: tuple[int, int], language: str) -> Person:
        people.append(Person(qtbot, settings, size, language))
        return people[-1]

    yield made
    for person in people:
        person.program.open_project.bridge.session.mark_saved()
        person.program.put_away()


def keep_picture_of_loading(person: Person, path: Path) -> None:
    """Keep a picture of the bar of a load, which is then given up."""
    go_on = threading.Event()

    def read(watch: Progress) -> None:
        watch(LoadPhase.OPENING, 0, 120)
        sleep(1.1)
        watch(LoadPhase.OPENING, 37, 120)
        go_on.wait(30)

    person.window.parts.project.loading.start(Load(path.name, read, lambda _nothing: None))
    QTest.qWait(1500)
    person.keep_picture("loading")
    person.window.parts.project.loading.cancel_button.click()
    go_on.set()


def all_steps(person: Person, name: str) -> int:
    """Undo or redo as long as there is something, and return how often."""
    count = 0
    while person.window.parts.actions[name].isEnabled():
        person.do(name)
        count += 1
    return count


def killed_while_working(project: Path, tmp_path: Path) -> None:
    """Another run of the program changes the saved project, and is killed."""
    command = [sys.executable, "-c", OTHER_PROGRAM, str(tmp_path), str(project)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as other:
        assert other.stdout is not None
        assert other.stdout.readline().strip() == "kept"
        other.send_signal(signal.SIGKILL)
        other.wait()


@pytest.mark.parametrize("size", [LARGE, SMALL] if FOLDER else [SMALL], ids=lambda size: f"{size[0]}x{size[1]}")
@pytest.mark.parametrize("language", ["en", "ja"] if FOLDER else ["ja"])
def test_a_whole_session(
    meet: Callable[[tuple[int, int], str], Person],
    source: Path,
    tmp_path: Path,
    size: tuple[int, int],
    language: str,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    person = meet(size, language)
    person.keep_picture("welcome")
    person.drop(source)
    session, viewport = person.program.open_project.bridge.session, person.window.parts.viewport
    opened = session.document
    person.keep_picture("opened")
    if FOLDER:
        with monkeypatch.context() as impatient:
            impatient.setattr(loading, "PATIENCE_S", 0.0)
            keep_picture_of_loading(person, source)

    drag(person.qtbot, viewport, "light.lamp", QPoint(60, 30), let_go=False)
    person.keep_picture("dragging_the_lamp")
    person.qtbot.mouseRelease(viewport, LEFT)
    assert value_of(session.document, LIGHT, 1) != value_of(opened, LIGHT, 1)

    row = next(each for each in person.window.parts.panels.inspector.rows if each.address == LIGHT)
    row.key.click()
    person.go_to(6)
    drag(person.qtbot, viewport, "light.lamp", QPoint(-90, -20))
    assert [key.frame for key in track_of(session.document, LIGHT).keys] == [1, 6]
    person.keep_picture("two_keys")

    person.drag_key(6, -2)
    assert [key.frame for key in track_of(session.document, LIGHT).keys] == [1, 4]
    person.keep_picture("key_dragged")

    person.do("curves", "select_keys", "ease_both")
    keys = track_of(session.document, LIGHT).keys
    assert [key.interpolation for key in keys] == [Interpolation.BEZIER] * 2
    person.keep_picture("eased_in_the_curve_editor")

    worked = session.document
    count = all_steps(person, "undo")
    assert person.window.parts.open_project.is_blank
    person.keep_picture("all_undone")
    assert all_steps(person, "redo") == count
    assert session.document == worked

    project = tmp_path / "cut.kage"
    monkeypatch.setattr(person.window.parts.project.dialogs, "project_to_save", lambda _name: project)
    person.do("save")
    assert load(project) == worked
    person.keep_picture("saved")

    person.program.put_away()
    killed_while_working(project, tmp_path)
    person.program = person._started()
    person.program.offer_recovery()
    recovery = person.dialog(RecoveryDialog)
    assert isinstance(recovery, RecoveryDialog)
    person.keep_picture("recovery")
    recovery.recover_button.click()
    person.see_picture()
    document = person.program.open_project.bridge.document
    assert value_of(document, Address(GROUND_DECLINATION), 1) == 22.0
    assert track_of(document, LIGHT) == track_of(worked, LIGHT)
    person.keep_picture("recovered")

    person.do("export")
    export = person.dialog(ExportDialog)
    assert isinstance(export, ExportDialog)
    export.folder.setText(str(tmp_path / "out"))
    person.keep_picture("export")
    export.go.click()
    person.qtbot.waitUntil(lambda: not person.window.parts.exporting.is_running, timeout=60_000)
    person.keep_picture("exported")
    written = sorted((tmp_path / "out").rglob("*_shadow_*.png"))
    assert len(written) == document.canvas.length_frames
    assert read_cel(written[0]).matte.box is not None


@pytest.fixture
def source(request: pytest.FixtureRequest, cels: Path) -> Path:
    """The folder that is dropped: a small walk, or for pictures to be looked at a real character."""
    if not FOLDER:
        return cels
    samples: Path = request.getfixturevalue("samples")
    return samples / "lottie_girl_jump" / "A"
