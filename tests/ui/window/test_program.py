"""The program around the window: starting, changing the language while it runs, and what nobody foresaw."""

import os
import subprocess
import sys
import threading
from pathlib import Path

import pytest
from PySide6.QtCore import QTimer, qInstallMessageHandler, qWarning
from PySide6.QtGui import QGuiApplication, QSurfaceFormat
from PySide6.QtWidgets import QApplication

from kagezou.errors import InputProblem
from kagezou.io.files import crash_reports
from kagezou.message import Message
from kagezou.ui.application import Application
from kagezou.ui.system import unforeseen
from kagezou.ui.system.settings import Settings
from kagezou.ui.widgets.message_bar import MessageBar, Severity
from kagezou.ui.window.main_window import MainWindow
from kagezou.version import __version__


def test_every_context_is_asked_to_be_opengl_3_3_core(qapp: QApplication) -> None:
    assert QGuiApplication.instance() is qapp
    wanted = QSurfaceFormat.defaultFormat()
    assert (wanted.majorVersion(), wanted.minorVersion()) == (3, 3)
    assert wanted.profile() is QSurfaceFormat.OpenGLContextProfile.CoreProfile
    assert wanted.samples() == 0


def test_changing_the_language_does_not_end_the_program(
    qapp: QApplication, settings: Settings, window: MainWindow
) -> None:
    window.close_unasked()
    program = Application(qapp, settings)
    program.show()
    QTimer.singleShot(50, lambda: program.speak("ja"))
    QTimer.singleShot(400, lambda: qapp.exit(7))
    assert qapp.exec() == 7
    assert program.window.isVisible()
    assert settings.language == "ja"
    program.put_away()


def test_the_layout_is_remembered(qapp: QApplication, settings: Settings, walking: MainWindow, cels: Path) -> None:
    walking.docks.all[0].hide()
    walking.close_unasked()
    program = Application(qapp, settings)
    program.show()
    program.window.parts.project.bring([cels])
    assert program.window.docks.all[0].isHidden()
    assert not program.window.docks.all[1].isHidden()
    program.put_away()


@pytest.mark.parametrize("scale", ["1.5", "2"])
def test_picking_is_right_on_screens_with_small_pixels(scale: str, window: MainWindow) -> None:
    window.close_unasked()
    wanted = "light.lamp or wheel or dropped_folder or actual"
    module = Path(__file__).parents[1] / "viewport" / "test_viewport.py"
    result = subprocess.run(
        [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", str(module), "-k", wanted],
        env={**os.environ, "QT_SCALE_FACTOR": scale},
        capture_output=True,
        text=True,
        timeout=900,
        check=False,
    )
    assert result.returncode == 0, result.stdout[-3000:]
    assert "skipped" not in result.stdout


def test_unforeseen_errors_are_written_down_and_said(
    qapp: QApplication, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(unforeseen, "user_log_path", lambda *_, **__: tmp_path)
    monkeypatch.setattr(crash_reports, "log_folder", lambda: tmp_path)
    hooks = sys.excepthook, threading.excepthook
    watching = unforeseen.UnforeseenErrors()
    said: list[str] = []
    watching.happened.connect(said.append)
    watching.about = lambda: ["unsaved work is kept in: /elsewhere"]
    handlers = list(unforeseen.log.handlers)
    try:
        watching.watch()
        for _ in range(3):
            sys.excepthook(ValueError, ValueError("a defect"), None)
        sys.excepthook(InputProblem, InputProblem(Message("A_0001.png: it is not there")), None)
        thread = threading.Thread(target=lambda: 1 / 0)
        thread.start()
        thread.join()
        qWarning("Qt minds something")
        qapp.processEvents()
    finally:
        qInstallMessageHandler(None)
        sys.excepthook, threading.excepthook = hooks
        for handler in set(unforeseen.log.handlers) - set(handlers):
            handler.close()
            unforeseen.log.removeHandler(handler)
    assert len(said) == 5
    assert "a defect" in said[0]
    reports = crash_reports.reports_in(tmp_path / "crashes")
    assert len(reports) == 2, "one of each kind, none of what was foreseen"
    texts = {path: path.read_text(encoding="utf-8").partition("\nlog: ")[0] for path in reports}
    (of_value,) = (path for path, written in texts.items() if "ValueError: a defect" in written)
    assert str(of_value) in said[0]
    assert said[0] == said[2]
    assert "unsaved work is kept in: /elsewhere" in texts[of_value]
    assert said[3] == "A_0001.png: it is not there"
    assert "ZeroDivisionError" in said[4]
    text = (tmp_path / "window.log").read_text(encoding="utf-8")
    assert f"Kagezou {__version__}, Python" in text.splitlines()[0]
    assert "is sent nowhere" in text.splitlines()[0]
    assert "Qt minds something" in text
    assert "ZeroDivisionError" in text


def test_the_bar_shows_the_gravest_message_and_counts_the_others(qapp: QApplication) -> None:
    assert qapp is not None
    bar = MessageBar()
    bar.say("a", "an error")
    bar.say("b", "a warning", Severity.WARNING)
    bar.say("c", "another error")
    assert bar.text == "another error"
    assert bar._count.text() == "and 2 more"
    bar.withdraw("c")
    assert bar.text == "an error"
    bar._dismiss()
    assert bar.text == "a warning"
    bar.clear()
    assert bar.isHidden()
