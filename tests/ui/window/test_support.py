"""What whoever helps wants to know: the report in the Help menu, and memory under the hand."""

from pathlib import Path

import pytest
from PySide6.QtCore import QEvent, QPoint
from PySide6.QtGui import QGuiApplication, QHelpEvent
from PySide6.QtWidgets import QApplication, QLabel

from kagezou.io.files.crash_reports import LOG_NAME, write_report
from kagezou.ui.system import support_report as reports
from kagezou.ui.system.settings import Settings
from kagezou.ui.system.support_report import Shown, support_report
from kagezou.ui.window.main_window import MainWindow
from kagezou.ui.window.wiring.crashes import say_incident, say_last_end
from kagezou.version import __version__

SHOWN = Shown("llvmpipe", "1920 x 1080 px, 24 frames", 2, 1, 3 << 20, 512 << 20)


def test_the_report_holds_versions_and_the_end_of_the_log(settings: Settings, tmp_path: Path) -> None:
    (tmp_path / LOG_NAME).write_text("".join(f"line {number}\n" for number in range(1000)), encoding="utf-8")
    text = support_report(SHOWN, settings, tmp_path)
    assert text.startswith(f"Kagezou {__version__}\n")
    assert "graphics: llvmpipe\n" in text
    assert "drawings in memory: 3 MB of 512 MB" in text
    assert "line 999" in text
    assert "line 900\n" not in text


def test_home_is_left_out_of_the_report(settings: Settings, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Path, "home", lambda: tmp_path)
    (tmp_path / LOG_NAME).write_text(f"unhandled: {tmp_path}/cuts/a.png\n", encoding="utf-8")
    text = support_report(SHOWN, settings, tmp_path)
    assert "unhandled: ~/cuts/a.png" in text
    assert str(tmp_path) not in text


def test_without_a_log_the_report_says_why(settings: Settings, tmp_path: Path) -> None:
    assert "(it cannot be read: No such file or directory)" in support_report(SHOWN, settings, tmp_path / "none")


def test_the_report_ends_with_the_last_crash(settings: Settings, tmp_path: Path) -> None:
    write_report("ValueError: older", [], tmp_path / "crashes")
    assert "ValueError: older" in support_report(SHOWN, settings, tmp_path)


def test_a_crash_is_said_and_its_report_can_be_copied(window: MainWindow, tmp_path: Path) -> None:
    report = write_report("ValueError: a defect", ["graphics: llvmpipe"], tmp_path)
    say_last_end(window.parts, report)
    assert str(report) in window.parts.bar.text
    copy, _folder = window.parts.bar.offered
    copy.click()
    assert "ValueError: a defect" in QGuiApplication.clipboard().text()
    say_incident(window.parts, "Something went wrong", None)
    assert window.parts.bar.offered == [], "nothing is offered where no report could be written"
    say_incident(window.parts, "Something went wrong", report)
    report.unlink()
    window.parts.bar.offered[0].click()
    assert "No such file" in window.parts.status.currentMessage()


def test_the_help_menu_copies_the_report(walking: MainWindow) -> None:
    QGuiApplication.clipboard().setText("before")
    walking.parts.actions["support_report"].trigger()
    text = QGuiApplication.clipboard().text()
    assert "cut: 240 x 200 px" in text
    assert ", 1 layers, 0 set pieces" in text
    assert "on the clipboard" in walking.parts.status.currentMessage()


def test_memory_is_said_under_the_hand_as_it_is_then(walking: MainWindow, monkeypatch: pytest.MonkeyPatch) -> None:
    zoom = walking.parts.status.labels[-1]
    assert isinstance(zoom, QLabel)
    monkeypatch.setattr(reports, "free_memory", lambda: 7 << 20)
    walking.parts.open_project.cels.limit(64 << 20)
    where = QPoint(2, 2)
    QApplication.sendEvent(zoom, QHelpEvent(QEvent.Type.ToolTip, where, zoom.mapToGlobal(where)))
    assert "of 64 MB. Free memory: 7 MB" in zoom.toolTip()
