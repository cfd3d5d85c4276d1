"""The guided first cut: each step is done by what it asks for, by nothing else, and moves on by itself."""

from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, Qt
from pytestqt.qtbot import QtBot

from kagezou.document.address import Address
from kagezou.document.edits import set_constant, set_key
from kagezou.document.model import Document
from kagezou.document.properties import (
    DISTANCE,
    GROUND_DECLINATION,
    LIGHT_AZIMUTH,
    LIGHT_POSITION,
    OPACITY,
    SIMPLIFY,
)
from kagezou.export.exporters.exporter import ExportOutcome
from kagezou.importing.staging import CharacterSource, new_document
from kagezou.io.project.file import save
from kagezou.message import Message
from kagezou.ui.help.first_cut import STEPS, FirstCut, sets_keys
from kagezou.ui.help.first_cut_bar import FirstCutBar
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.system.settings import Settings
from kagezou.ui.window.main_window import MainWindow
from tests.ui.viewing import OwnClipboard, drag

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def document(filled: OpenProject) -> Document:
    return filled.bridge.document


def with_value(document: Document, number: int, value: float) -> Document:
    """Return the document with a value that a step asks for."""
    layer_id = document.layers[0].id
    addresses = (
        Address(LIGHT_AZIMUTH),
        Address(GROUND_DECLINATION),
        Address(SIMPLIFY, layer_id),
        Address(DISTANCE, layer_id),
    )
    return set_constant(document, addresses[number], value)


def test_a_step_is_done_by_its_own_property_alone(document: Document) -> None:
    guide = FirstCut()
    guide.begin(document)
    for number in range(3):
        assert guide.number == number
        for other in {0, 1, 2} - {number}:
            guide.see(with_value(document, other, 33.0))
            assert guide.number == number, "what another step asks for is not this one"
        guide.see(with_value(document, number, 44.0))
    assert guide.number == 3


def test_any_way_of_changing_the_shape_counts(document: Document) -> None:
    guide = FirstCut()
    guide.begin(document)
    guide.skip(document)
    guide.skip(document)
    guide.see(with_value(document, 3, 100.0))
    assert guide.number == 3


def test_one_key_is_no_change_over_time(document: Document) -> None:
    opacity = Address(OPACITY, document.layers[0].id)
    once = set_key(document, opacity, 1, 0.2)
    assert not sets_keys(document, once)
    assert sets_keys(document, set_key(once, opacity, 3, 0.8))
    assert sets_keys(once, set_key(once, opacity, 3, 0.8))
    keyed = set_key(
        set_key(document, Address(LIGHT_POSITION), 1, (0.0, 0.0, 9.0)), Address(LIGHT_POSITION), 4, (9.0, 0.0, 9.0)
    )
    assert not sets_keys(keyed, keyed), "keys that were there before are not set now"
    assert sets_keys(keyed, set_key(keyed, Address(LIGHT_POSITION), 2, (5.0, 0.0, 9.0)))


def test_what_is_new_has_nothing_to_be_compared_with(document: Document) -> None:
    fewer = replace(document, layers=())
    more = with_value(document, 2, 44.0)
    assert not any(step.is_done(fewer, more) for step in STEPS if step.is_done is not None)


def test_the_last_step_is_an_export(document: Document) -> None:
    guide = FirstCut()
    seen: list[int | None] = []
    guide.changed.connect(lambda: seen.append(guide.number))
    guide.see_export(document)
    assert seen == [], "nobody is guided"
    guide.begin(document)
    guide.see_export(document)
    assert seen == [0]
    for _ in range(4):
        guide.skip(document)
    guide.see(with_value(document, 0, 44.0))
    assert seen == [0, 1, 2, 3, 4]
    guide.see_export(document)
    assert seen[-1] == len(STEPS)
    assert guide.step is None
    guide.skip(document)
    assert seen[-1] == len(STEPS)
    guide.end()
    assert seen[-1] is None


@pytest.fixture
def guided(
    qtbot: QtBot,
    open_project: OpenProject,
    settings: Settings,
    cels: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> MainWindow:
    """The whole window with the guide begun from the menu, on a demo that somebody makes."""

    def make(folder: Path, _progress: object) -> Path:
        folder.mkdir(parents=True)
        path = folder / "demo.kage"
        save(new_document((CharacterSource("Child", cels),)).document, path)
        return path

    monkeypatch.setattr("kagezou.ui.project.demo.demo_folder", lambda: tmp_path / "demo")
    made = MainWindow(open_project, settings, OwnClipboard(), make)
    qtbot.addWidget(made, before_close_func=MainWindow.close_unasked)
    made.resize(1100, 760)
    made.show()
    qtbot.waitExposed(made)
    made.parts.actions["first_cut"].trigger()
    qtbot.waitUntil(lambda: bool(made.findChildren(FirstCutBar)) and bar_of(made).isVisible())
    return made


def bar_of(window: MainWindow) -> FirstCutBar:
    (bar,) = window.findChildren(FirstCutBar)
    return bar


def test_it_leads_through_a_cut(qtbot: QtBot, guided: MainWindow) -> None:
    bar, parts = bar_of(guided), guided.parts
    assert bar.text == "Drag the light in the picture, here the sun on its dial under the feet: the shadow follows."
    qtbot.waitUntil(lambda: parts.viewport.controller.handles.find("light.lamp") is not None)
    drag(qtbot, parts.viewport, "light.lamp", QPoint(30, 10), let_go=False)
    assert bar.guide.number == 0, "while the hand drags, the words stay"
    qtbot.mouseRelease(parts.viewport, LEFT)
    qtbot.waitUntil(lambda: bar.guide.number == 1)
    qtbot.mouseClick(bar.show_me, LEFT)
    row = parts.panels.inspector.row("ground.declination")
    assert row.label.property("chosen"), "the row it is about is marked"
    bridge = parts.bridge
    bridge.session.edit("Declination", set_constant(bridge.document, Address(GROUND_DECLINATION), 40.0))
    assert bar.guide.number == 2
    qtbot.mouseClick(bar.skip, LEFT)
    qtbot.mouseClick(bar.skip, LEFT)
    assert bar.guide.number == 4
    outcome = ExportOutcome((), 0, cancelled=True, problem=None, where=Path(), notes=(), next_steps=())
    parts.exporting.ended.emit(outcome)
    assert bar.guide.number == 4, "an export that was stopped is none"
    parts.exporting.ended.emit(ExportOutcome((), 0, False, Message("full"), Path(), (), ()))
    assert bar.guide.number == 4
    parts.exporting.ended.emit(ExportOutcome((), 1, False, None, Path(), (), ()))
    assert not bar.skip.isVisible()
    assert bar.text.startswith("That was a whole cut.")
    qtbot.mouseClick(bar.leave, LEFT)
    assert not bar.isVisible()


def test_another_project_ends_it(guided: MainWindow, tmp_path: Path) -> None:
    other = tmp_path / "other.kage"
    save(guided.parts.bridge.document, other)
    guided.parts.bridge.session.mark_saved()
    guided.parts.project.open_path(other)
    assert not bar_of(guided).isVisible()
