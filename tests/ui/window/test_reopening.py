"""Opening projects again and again leaves nothing of those that are gone, whatever runs meanwhile."""

import gc
from collections import Counter
from pathlib import Path

from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from kagezou.document.address import Address
from kagezou.document.edits import set_constant
from kagezou.document.model import Drawing, Layer
from kagezou.document.properties import GROUND_DECLINATION
from kagezou.session.session import Session
from kagezou.ui.panels.property_row import PropertyRow
from kagezou.ui.project.welcome_cards import RecentCard
from kagezou.ui.window.main_window import MainWindow

ROUNDS = 4


def alive() -> Counter[str]:
    gc.collect()
    mine = (each for each in map(type, gc.get_objects()) if each.__module__.startswith("kagezou."))
    found = Counter(each.__qualname__ for each in mine)
    return Counter({name: found[name] for name in (each.__qualname__ for each in WATCHED)})


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
