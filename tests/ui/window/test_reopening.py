"""Opening projects again and again leaves nothing of those that are gone, whatever runs meanwhile."""

import gc
from collections import Counter
from pathlib import Path
from weakref import ReferenceType, ref

from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot
from shiboken6 import isValid

from kagezou.document.address import Address
from kagezou.document.edits import set_constant
from kagezou.document.model import Drawing, Layer
from kagezou.document.properties import GROUND_DECLINATION
from kagezou.io.project.recovery_file import read_recovery_file
from kagezou.session.session import Session
from kagezou.ui.application import Application
from kagezou.ui.panels.property_row import PropertyRow
from kagezou.ui.project.welcome_cards import RecentCard
from kagezou.ui.system.settings import Settings
from kagezou.ui.window.main_window import MainWindow

ROUNDS = 4


def alive() -> Counter[str]:
    gc.collect()
    return Counter(type(each).__qualname__ for each in gc.get_objects() if type(each) in WATCHED)


WATCHED = (Session, Layer, Drawing, PropertyRow, RecentCard)


def test_every_round_ends_with_as_much_as_the_one_before(qtbot: QtBot, walking: MainWindow, tmp_path: Path) -> None:
    parts = walking.parts
    projects = [tmp_path / "one.kage", tmp_path / "two.kage"]
    for path in projects:
        parts.open_project.save(path)

    def work_on_each() -> None:
        for path in projects:
            parts.project.open_path(path)
            qtbot.waitUntil(lambda: not parts.project.loading.is_running)
            session = parts.bridge.session
            session.edit("Turn", set_constant(session.document, Address(GROUND_DECLINATION), 21.0))
            session.select(None)
            session.select(session.document.layers[0].id)
            # No loop of its own: what waits for one would pile up.
            QApplication.processEvents()
            QApplication.processEvents()
            session.mark_saved()

    work_on_each()
    work_on_each()
    before, widgets = alive(), len(QApplication.allWidgets())
    for _ in range(ROUNDS):
        work_on_each()
    assert alive() == before
    assert len(QApplication.allWidgets()) <= widgets


def test_another_language_leaves_nothing_of_the_window_before(qtbot: QtBot, settings: Settings, cels: Path) -> None:
    application = QApplication.instance()
    assert isinstance(application, QApplication)
    program = Application(application, settings)
    program.show()
    program.window.parts.project.bring([cels])
    qtbot.waitUntil(lambda: not program.window.parts.project.loading.is_running)
    parts = program.window.parts
    gone: list[ReferenceType[QWidget]] = [ref(program.window), ref(parts.panels.inspector), ref(parts.time.timeline)]
    del parts
    program.speak("ja")
    program.speak("en")
    qtbot.waitUntil(lambda: not any(isValid(each()) for each in gone if each() is not None))
    session = program.open_project.bridge.session
    # Whoever was still called would meet widgets that are no more; pytest-qt reports what a slot raises.
    session.edit("Turn", set_constant(session.document, Address(GROUND_DECLINATION), 33.0))
    session.go_to(2)
    session.select(None)
    gc.collect()
    assert [each() for each in gone] == [None, None, None]
    program.autosave.keep()
    program.autosave.wait()
    assert read_recovery_file(program.autosave.file).document == session.document, "who keeps the work still listens"
    session.mark_saved()
    program.put_away()
