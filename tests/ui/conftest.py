"""What the tests of the window share: an application as the program makes it, settings of their own, small cels."""

import os
import shutil
from collections.abc import Callable, Iterator
from itertools import count
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QCoreApplication, QEvent, QSettings, SignalInstance
from PySide6.QtGui import QGuiApplication, QOpenGLContext
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot
from pytestqt.wait_signal import SignalBlocker

from kagezou.importing.staging import CharacterSource
from kagezou.io.images.writing import write_rgba
from kagezou.ui.application import make_application
from kagezou.ui.panels.inspector import Inspector
from kagezou.ui.panels.layer_list import LayerList
from kagezou.ui.project import loading, saving
from kagezou.ui.project.dialogs import Dialogs
from kagezou.ui.project.feet_finder import FeetFinder
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.system.language import Language
from kagezou.ui.system.listeners import forget_listeners, senders_within
from kagezou.ui.system.settings import Settings
from kagezou.ui.system.thumbnails import Thumbnails
from kagezou.ui.viewport import reading, resolution
from kagezou.ui.window.main_window import MainWindow
from tests.ui.viewing import OwnClipboard

FRAMES = 6

if os.name == "posix" and not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
    # Without a screen Qt would end the whole test run; the tests that need OpenGL say so themselves.
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")


WAIT_MS = 60_000
"""How long something may take that is waited for: a busy machine is slow, which says nothing about the program."""


class PatientBot(QtBot):
    """Waits as long as a slow machine may need."""

    def waitUntil(self, callback: Callable[[], bool | None], *, timeout: int = WAIT_MS) -> None:
        super().waitUntil(callback, timeout=timeout)

    def waitSignal(
        self,
        signal: SignalInstance,
        *,
        timeout: int = WAIT_MS,
        raising: bool | None = None,
        check_params_cb: Callable[..., bool] | None = None,
    ) -> SignalBlocker:
        return super().waitSignal(signal, timeout=timeout, raising=raising, check_params_cb=check_params_cb)


@pytest.fixture
def qtbot(qapp: QApplication, request: pytest.FixtureRequest) -> QtBot:  # noqa: ARG001 - widgets need the application
    return PatientBot(request)


@pytest.fixture(scope="session")
def qapp() -> QApplication:
    """The application with the program's own surface format, palette and style."""
    application = QApplication.instance()
    return application if isinstance(application, QApplication) else make_application()


@pytest.fixture(autouse=True)
def english(qapp: QApplication) -> Iterator[Language]:
    language = Language(qapp)
    language.speak("en")
    yield language
    language.fall_silent()


@pytest.fixture(autouse=True)
def patient(monkeypatch: pytest.MonkeyPatch) -> None:
    """Loads and saves are waited for, so that what comes after may look at once; tests of them are impatient."""
    monkeypatch.setattr(loading, "PATIENCE_S", 30.0)
    monkeypatch.setattr(saving, "PATIENCE_S", 30.0)
    monkeypatch.setattr(reading, "PATIENCE_S", 30.0)


@pytest.fixture(autouse=True)
def steady(monkeypatch: pytest.MonkeyPatch) -> None:
    """No picture is late, however busy the machine: what is compared is drawn at full resolution."""
    monkeypatch.setattr(resolution, "DUE_S", 60.0)


@pytest.fixture(autouse=True)
def _everything_taken(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whoever is asked which of the characters that were found are to be taken takes all."""
    monkeypatch.setattr(Dialogs, "characters", lambda _dialogs, found: found.sources)


@pytest.fixture(autouse=True)
def _on_the_line(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Nobody looks for feet beside the window, so that documents are what a test made; tests marked ``feet`` do."""
    if request.node.get_closest_marker("feet") is None:
        monkeypatch.setattr(FeetFinder, "search", lambda _finder, _layer_ids: None)


@pytest.fixture(autouse=True)
def _no_context_stays_current(qapp: QApplication) -> Iterator[None]:  # noqa: ARG001 - Qt objects need the application
    """A window's OpenGL context left current on the thread would keep later tests from making one without a display."""
    yield
    current = QOpenGLContext.currentContext()
    if current is not None:
        current.doneCurrent()


@pytest.fixture(autouse=True)
def _nothing_that_is_gone_stays(qapp: QApplication) -> Iterator[None]:
    """Windows that were put away are destroyed at once: they would hear every event of the tests that follow.

    What their signals call is let go of as well, or each would stay in memory, and Python look through all of them.
    """
    yield
    for window in qapp.topLevelWidgets():
        if isinstance(window, MainWindow) and not window.isVisible():
            project = window.parts.open_project
            outliving = (project, project.bridge)
            forget_listeners((*outliving, *senders_within(window.parts, beside=outliving)))
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


@pytest.fixture
def present(qtbot: QtBot) -> Iterator[Callable[[], None]]:
    """What brings the server's time: an X server refuses the focus to whoever's last event is old."""
    window = QWidget()
    qtbot.addWidget(window)
    window.show()
    titles = count()

    def pass_time() -> None:
        # A new title comes back as an event that bears the time.
        window.setWindowTitle(str(next(titles)))
        QGuiApplication.processEvents()

    yield pass_time
    window.close()


@pytest.fixture
def focus(qtbot: QtBot, present: Callable[[], None]) -> Callable[[QWidget], None]:
    """What gives a widget the keyboard, asking again until the window system grants it."""

    def give(widget: QWidget) -> None:
        def has_focus() -> bool:
            present()
            widget.window().activateWindow()
            widget.setFocus()
            QGuiApplication.processEvents()
            return widget.hasFocus()

        qtbot.waitUntil(has_focus)

    return give


@pytest.fixture
def clipboard() -> OwnClipboard:
    """The clipboard of the test alone."""
    return OwnClipboard()


@pytest.fixture
def settings(tmp_path: Path) -> Settings:
    store = QSettings(str(tmp_path / "settings.ini"), QSettings.Format.IniFormat)
    return Settings(store, tmp_path / "styles", tmp_path / "unsaved", tmp_path / "pictures", tmp_path / "spare")


@pytest.fixture(scope="session")
def drawn_once(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder that :func:`cels` is a copy of."""
    folder = tmp_path_factory.mktemp("cels")
    for frame in range(1, FRAMES + 1):
        write_rgba(folder / f"walk_{frame:04d}.png", figure_rgba(frame))
    return folder


@pytest.fixture
def cels(drawn_once: Path, tmp_path: Path) -> Path:
    """A folder with a short walk: a figure of a head, a body and two legs on 240 × 200 px."""
    return shutil.copytree(drawn_once, tmp_path / "walker", copy_function=shutil.copyfile)


@pytest.fixture
def open_project(qapp: QApplication) -> OpenProject:  # noqa: ARG001 - Qt objects need the application
    return OpenProject()


@pytest.fixture
def filled(open_project: OpenProject, cels: Path) -> OpenProject:
    """An open project with one character, taken for saved."""
    open_project.bring((CharacterSource("Walker", cels),)).at_once()
    open_project.bridge.session.mark_saved()
    return open_project


@pytest.fixture
def window(
    qtbot: QtBot, open_project: OpenProject, settings: Settings, clipboard: OwnClipboard
) -> Iterator[MainWindow]:
    """The whole window on a screen that can show OpenGL."""
    if QGuiApplication.platformName() == "offscreen":
        pytest.skip("no display that can show OpenGL; run under Xvfb")
    made = MainWindow(open_project, settings, clipboard)
    made.resize(1100, 760)
    made.show()
    qtbot.waitExposed(made)
    yield made
    made.close_unasked()
    made.deleteLater()
    QApplication.processEvents()


@pytest.fixture
def walking(qtbot: QtBot, window: MainWindow, cels: Path) -> MainWindow:
    """The window with one character, its first picture on screen."""
    window.parts.project.bring([cels])
    window.parts.open_project.bridge.session.mark_saved()
    qtbot.waitUntil(
        lambda: (
            window.parts.viewport.frame_painter is not None and window.parts.viewport.frame_painter.pictures_drawn > 0
        )
    )
    window.parts.bar.clear()
    return window


def figure_rgba(frame: int) -> np.ndarray[tuple[int, int, int], np.dtype[np.uint8]]:
    rgba = np.zeros((200, 240, 4), np.uint8)
    y, x = np.mgrid[0:200, 0:240]
    rgba[(x - 120) ** 2 + (y - 60) ** 2 < 22**2] = (230, 190, 150, 255)
    rgba[80:130, 105:135] = (60, 110, 190, 255)
    stride = 3 * (frame % 4)
    rgba[130:170, 106 - stride : 116 - stride] = (70, 60, 50, 255)
    rgba[130:170, 124 + stride : 134 + stride] = (70, 60, 50, 255)
    return rgba


@pytest.fixture
def active(qtbot: QtBot, walking: MainWindow, present: Callable[[], None]) -> MainWindow:
    """The window with a character and the keyboard."""

    def is_active() -> bool:
        present()
        walking.activateWindow()
        QGuiApplication.processEvents()
        return walking.isActiveWindow()

    qtbot.waitUntil(is_active)
    return walking


@pytest.fixture
def inspector(qtbot: QtBot, filled: OpenProject, clipboard: OwnClipboard) -> Inspector:
    """The panel of properties, shown."""
    made = Inspector(filled.bridge, clipboard)
    qtbot.addWidget(made)
    made.resize(360, 900)
    made.show()
    return made


@pytest.fixture
def layers(qtbot: QtBot, filled: OpenProject, clipboard: OwnClipboard) -> LayerList:
    """The list of layers, shown."""
    thumbnails = Thumbnails()
    made = LayerList(filled.bridge, clipboard, thumbnails)
    made.destroyed.connect(thumbnails.finish)
    qtbot.addWidget(made)
    made.resize(300, 400)
    made.show()
    return made
