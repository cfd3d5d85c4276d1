"""The floor of 1280 × 720: every word of the window and its dialogs can be read whole, in both languages."""

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QRect
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QCheckBox,
    QComboBox,
    QDialog,
    QLabel,
    QPushButton,
    QRadioButton,
    QSizePolicy,
    QToolButton,
    QWidget,
)
from pytestqt.qtbot import QtBot

from kagezou.document.address import Address
from kagezou.document.edits import set_key
from kagezou.document.key_edits import KeyRef
from kagezou.document.properties import GROUND_DECLINATION, LIGHT_POSITION
from kagezou.importing.staging import CharacterSource
from kagezou.ui.help.first_cut import STEPS
from kagezou.ui.help.first_cut_bar import FirstCutBar
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.system.language import Language
from kagezou.ui.system.settings import Settings
from kagezou.ui.window.main_window import MainWindow
from kagezou.ui.window.wiring.cut import ask_what_to_take
from tests.ui.viewing import OwnClipboard

FLOOR = (1280, 720)
DECLINATION = Address(GROUND_DECLINATION)


def cut(widget: QWidget) -> Iterator[str]:
    """Yield what of a widget's words, and of those in it, has not the room that it asks for."""
    for each in (widget, *widget.findChildren(QWidget)):
        if not each.isVisibleTo(widget.window()) or each.width() == 0:
            continue
        needed = _needed_px(each)
        if needed is not None and needed > each.width() + 1:
            words = each.text() if isinstance(each, QAbstractButton | QLabel) else ""
            yield f"{type(each).__name__} {each.objectName()} {words!r}: {needed} px in {each.width()}"
        if isinstance(each, QLabel) and each.wordWrap() and each.heightForWidth(each.width()) > each.height() + 1:
            yield f"QLabel {each.text()!r}: {each.heightForWidth(each.width())} px high in {each.height()}"


def _needed_px(widget: QWidget) -> int | None:
    """Return the width that a widget asks for its words; None where they may be shortened or there are none."""
    if widget.sizePolicy().horizontalPolicy() is QSizePolicy.Policy.Ignored:
        return None
    match widget:
        case QPushButton() | QCheckBox() | QRadioButton():
            return widget.minimumSizeHint().width() if widget.text() else None
        case QToolButton():
            return (
                widget.sizeHint().width() if (widget.text() and not widget.icon().isNull()) or widget.text() else None
            )
        case QLabel() if widget.text() and not widget.wordWrap():
            return widget.minimumSizeHint().width()
        case QComboBox() if widget.currentText():
            return widget.fontMetrics().horizontalAdvance(widget.currentText()) + 24
    return None


@pytest.fixture
def keyed(open_project: OpenProject, cels: Path) -> OpenProject:
    """A cut with keys of the lamp and of the declination, one of them selected."""
    open_project.bring((CharacterSource("Walker", cels),)).at_once()
    session = open_project.bridge.session
    document = session.document
    for frame, degrees in ((1, 30.0), (5, 50.0)):
        document = set_key(document, DECLINATION, frame, degrees)
        document = set_key(document, Address(LIGHT_POSITION), frame, (degrees, -200.0, 900.0))
    session.edit("Key", document)
    session.select_keys(frozenset({KeyRef(DECLINATION, 1)}))
    return open_project


@pytest.fixture(params=["en", "ja"])
def small(
    qtbot: QtBot, keyed: OpenProject, settings: Settings, english: Language, request: pytest.FixtureRequest
) -> Iterator[MainWindow]:
    """The whole window at the floor, in a language."""
    if QGuiApplication.platformName() == "offscreen":
        pytest.skip("no display that can show OpenGL; run under Xvfb")
    english.speak(request.param)
    made = MainWindow(keyed, settings, OwnClipboard(), _no_demo)
    made.resize(*FLOOR)
    made.show()
    qtbot.waitExposed(made)
    yield made
    made.close_unasked()
    made.deleteLater()


def _no_demo(folder: Path, _progress: object) -> Path:
    raise AssertionError(f"nobody asked for a demo in {folder}")


def test_the_window_takes_no_more_than_the_floor(small: MainWindow) -> None:
    QApplication.processEvents()
    assert (small.width(), small.height()) <= FLOOR
    assert small.minimumSizeHint().width() <= FLOOR[0]
    assert small.minimumSizeHint().height() <= FLOOR[1]


def test_every_word_of_the_panels_is_whole(qtbot: QtBot, small: MainWindow) -> None:
    found: list[str] = []
    inspector = small.parts.panels.inspector
    for section in inspector.sections.values():
        section.open(opened=True)
        section.more.setChecked(True)
    for name in ("layers", "inspector", "styles", "timeline", "curves"):
        small.docks.layout.show(name)
        panel = next(dock for dock in small.docks.all if dock.objectName() == name)
        qtbot.waitUntil(panel.isVisible)
        # What finds no room goes into a menu once the layout has said how much there is, which it does in turns.
        for _turn in range(20):
            QApplication.processEvents()
        found += [f"{name}: {each}" for each in cut(panel)]
    assert found == []


def test_the_guide_and_every_page_of_the_manual_are_whole(qtbot: QtBot, small: MainWindow) -> None:
    (bar,) = small.findChildren(FirstCutBar)
    bar.guide.begin(small.parts.bridge.document)
    for _step in (*STEPS, None):
        QApplication.processEvents()
        assert list(cut(bar)) == [], bar.text
        assert small.minimumSizeHint().width() <= FLOOR[0]
        bar.guide.skip(small.parts.bridge.document)
    small.help.open_at(("index", ""))
    manual = small.help.manual
    assert manual is not None
    manual.resize(1000, 640)
    qtbot.waitExposed(manual)
    for name in manual.names:
        manual.open(name)
        QApplication.processEvents()
        assert manual.pages.page == name
        assert not manual.pages.horizontalScrollBar().isVisible(), name
    assert list(cut(manual)) == []


DIALOGS: dict[str, Callable[[MainWindow], object]] = {
    "export": lambda window: window.parts.actions["export"].trigger(),
    "cut settings": lambda window: window.parts.actions["cut_settings"].trigger(),
    "taking": lambda window: ask_what_to_take(window.parts, window.parts.bridge.document, "master"),
    "preferences": lambda window: window.parts.actions["preferences"].trigger(),
    "shortcuts": lambda window: window.parts.actions["shortcuts"].trigger(),
    "edit shortcuts": lambda window: window.parts.actions["edit_shortcuts"].trigger(),
    "missing parts": lambda window: window.parts.actions["missing_parts"].trigger(),
    "about": lambda window: window.parts.actions["about"].trigger(),
    "velocity": lambda window: window.parts.actions["velocity"].trigger(),
}


def test_every_dialog_fits_and_is_read_whole(qtbot: QtBot, small: MainWindow) -> None:
    def opened() -> QDialog | None:
        shown = [each for each in small.findChildren(QDialog) if each.isVisible()]
        return shown[0] if shown else None

    # One window shows them one after the other: to make it takes longer than to look at a dialog.
    found: list[str] = []
    for name, show in DIALOGS.items():
        show(small)
        qtbot.waitUntil(lambda: opened() is not None)
        dialog = opened()
        assert dialog is not None
        qtbot.waitExposed(dialog)
        QApplication.processEvents()
        if not QRect(0, 0, *FLOOR).contains(QRect(0, 0, dialog.width(), dialog.height())):
            found.append(f"{name}: {dialog.width()} × {dialog.height()}")
        found += [f"{name}: {each}" for each in cut(dialog)]
        dialog.close()
        qtbot.waitUntil(lambda: opened() is None)
    assert found == []
