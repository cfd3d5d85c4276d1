"""Looking a cut through: what is locked, what is shown, and what can still be said."""

import csv
import io
from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDockWidget, QFileDialog, QInputDialog, QToolBar, QWidget
from pytestqt.qtbot import QtBot

from kagezou.document import edits, review
from kagezou.document.address import Address
from kagezou.document.model import Document
from kagezou.document.note import NoteAnswer
from kagezou.document.properties import LIGHT_POSITION, OPACITY
from kagezou.io.project.file import load
from kagezou.ui.window.main_window import MainWindow

LIGHT = Address(LIGHT_POSITION)


def document_of(window: MainWindow) -> Document:
    return window.parts.open_project.bridge.document


@pytest.fixture
def noted(walking: MainWindow) -> MainWindow:
    """A cut with two notes and between them a jump of the light."""
    document = document_of(walking)
    opacity = Address(OPACITY, document.layers[0].id)
    for frame, x in ((1, 0.0), (3, 0.0), (4, 400.0), (6, 400.0)):
        document = edits.set_key(document, LIGHT, frame, (x, -200.0, 900.0))
    document = review.add_note(review.add_note(document, LIGHT, 2, "Slower"), opacity, 6, "Lighter", "Sato")
    walking.parts.open_project.bridge.session.edit("Notes", document)
    return walking


def is_locked(window: MainWindow) -> bool:
    return window.parts.open_project.bridge.session.is_locked


def press(window: MainWindow, key: Qt.Key, modifiers: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier) -> None:
    QTest.keyClick(window, key, modifiers)


def seen_docks(window: MainWindow) -> list[str]:
    return [dock.objectName() for dock in window.findChildren(QDockWidget) if dock.isVisible()]


def test_it_shows_picture_and_curves_and_brings_all_back(noted: MainWindow, qtbot: QtBot) -> None:
    parts = noted.parts
    before, height = set(seen_docks(noted)), parts.viewport.height()
    parts.actions["review"].trigger()
    qtbot.waitUntil(lambda: seen_docks(noted) == ["curves"])
    editor = parts.curves.made()
    qtbot.waitUntil(lambda: 2 * editor.graph.width() >= noted.width())
    assert not any(bar.isVisible() for bar in noted.findChildren(QToolBar))
    assert parts.review_bar.isVisible()
    assert parts.review_bar.words.text() == "Notes: 2, flags: 1"
    assert parts.viewport.width() == noted.width()
    parts.actions["review"].trigger()
    qtbot.waitUntil(lambda: set(seen_docks(noted)) == before)
    qtbot.waitUntil(lambda: parts.viewport.height() == height)
    assert not parts.review_bar.isVisible()
    assert all(bar.isVisible() for bar in noted.findChildren(QToolBar))
    assert editor.tree.isVisibleTo(editor)


def test_nothing_can_be_changed_but_what_is_said(
    noted: MainWindow, qtbot: QtBot, focus: Callable[[QWidget], None]
) -> None:
    parts, before = noted.parts, document_of(noted)
    parts.actions["review"].trigger()
    session = parts.open_project.bridge.session
    assert is_locked(noted)
    session.select_keys(frozenset())
    focus(parts.viewport)
    for name in ("set_keys", "delete", "paste_keys", "undo", "marker", "work_in", "ease_both"):
        parts.actions[name].trigger()
    place = QPoint(parts.viewport.width() // 2, parts.viewport.height() // 2)
    QTest.mousePress(parts.viewport, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, place)
    QTest.mouseMove(parts.viewport, place + QPoint(40, 10))
    QTest.mouseRelease(
        parts.viewport, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, place + QPoint(40, 10)
    )
    assert document_of(noted) is before
    qtbot.mouseClick(parts.review_bar.following, Qt.MouseButton.LeftButton)
    qtbot.mouseClick(parts.review_bar.ticked, Qt.MouseButton.LeftButton)
    assert [note.is_done for note in document_of(noted).notes] == [True, False]
    assert is_locked(noted)
    qtbot.mouseClick(parts.review_bar.answer, Qt.MouseButton.LeftButton)
    dialog = parts.curves.made().notes.findChild(QInputDialog)
    assert dialog is not None
    dialog.setTextValue("Like this?")
    dialog.accept()
    qtbot.waitUntil(lambda: bool(document_of(noted).notes[0].answers))
    author = parts.curves.made().notes.author
    assert document_of(noted).notes[0].answers == (NoteAnswer("Like this?", author),)
    assert parts.review_bar.words.text().endswith("Like this?")
    assert parts.review_bar.ticked.isChecked()
    parts.actions["review"].trigger()
    assert not is_locked(noted)
    session.undo()
    assert not document_of(noted).notes[0].answers


def test_one_goes_from_note_to_flag_to_note_and_stays_at_the_ends(noted: MainWindow, qtbot: QtBot) -> None:
    parts = noted.parts
    bridge, bar = parts.open_project.bridge, parts.review_bar
    parts.actions["review"].trigger()
    seen = []
    for _ in range(3):
        qtbot.mouseClick(bar.following, Qt.MouseButton.LeftButton)
        seen.append((bar.place.text(), bridge.frame, bar.ticked.isEnabled()))
    assert seen == [("1 / 3", 2, True), ("2 / 3", 4, False), ("3 / 3", 6, True)]
    assert "Walker".lower() in bar.words.text().lower()
    assert bar.words.text().endswith("Lighter")
    qtbot.mouseClick(bar.following, Qt.MouseButton.LeftButton)
    assert (bar.place.text(), parts.bar.text) == ("3 / 3", "This is the last one.")
    qtbot.mouseClick(bar.previous, Qt.MouseButton.LeftButton)
    assert bar.words.text() == "4   Light position   jumps by 400 px"
    bridge.session.go_to(1)
    parts.actions["remark_next"].trigger()
    assert bridge.frame == 6, "on from the one that is looked at"


def test_the_keys_do_it_too_and_escape_leaves(
    noted: MainWindow, qtbot: QtBot, active: MainWindow, focus: Callable[[QWidget], None]
) -> None:
    assert active is noted
    parts, bridge = noted.parts, noted.parts.open_project.bridge
    focus(parts.viewport)
    three = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.AltModifier | Qt.KeyboardModifier.ShiftModifier
    press(noted, Qt.Key.Key_R, three)
    qtbot.waitUntil(lambda: noted.review.is_on)
    press(noted, Qt.Key.Key_PageDown, Qt.KeyboardModifier.AltModifier | Qt.KeyboardModifier.ShiftModifier)
    qtbot.waitUntil(lambda: bridge.frame == 2)
    press(noted, Qt.Key.Key_Return, Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.AltModifier)
    qtbot.waitUntil(lambda: document_of(noted).notes[0].is_done)
    press(noted, Qt.Key.Key_Escape)
    qtbot.waitUntil(lambda: not noted.review.is_on)
    assert not is_locked(noted)
    assert not parts.actions["review"].isChecked()


def test_who_only_looked_before_goes_on_doing_so(noted: MainWindow) -> None:
    parts = noted.parts
    parts.actions["look_only"].trigger()
    parts.actions["review"].trigger()
    parts.actions["review"].trigger()
    assert is_locked(noted)
    assert parts.actions["look_only"].isChecked()


def test_unlocking_ends_the_review(noted: MainWindow) -> None:
    noted.parts.actions["review"].trigger()
    noted.parts.actions["look_only"].trigger()
    assert not noted.review.is_on
    assert not is_locked(noted)


def test_walking_needs_no_review_and_says_what_is_there(noted: MainWindow) -> None:
    noted.parts.actions["remark_next"].trigger()
    assert noted.parts.bar.text.startswith("2   Light position")
    assert noted.parts.bar.text.endswith("Slower")


def test_nothing_to_look_at_is_said(walking: MainWindow) -> None:
    walking.parts.actions["remark_next"].trigger()
    assert walking.parts.bar.text == "There are no notes, and nothing stands out."
    walking.parts.actions["remark_tick"].trigger()
    assert walking.parts.bar.text == "Go to a note first."


def test_notes_show_in_the_ruler_with_their_words(noted: MainWindow, qtbot: QtBot) -> None:
    ruler = noted.parts.time.timeline.ruler
    (note,) = [each for each in document_of(noted).notes if each.frame == 2]
    place = QPoint(round(ruler._scale.middle_of(2)), ruler.height() - 15)
    before = ruler.grab().toImage()
    QTest.mouseMove(ruler, place)
    qtbot.waitUntil(lambda: "Slower" in ruler.toolTip())
    assert "Light position" in ruler.toolTip()
    session = noted.parts.open_project.bridge.session
    session.edit("Tick", review.tick_note(document_of(noted), note, done=True))
    assert ruler.grab().toImage() != before, "what is done is told from what is not"


@pytest.mark.parametrize(("name", "form"), [("n.csv", "csv"), ("n.txt", "text"), ("n", "csv")])
def test_notes_become_a_file(
    noted: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, form: str
) -> None:
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(tmp_path / name), "Table (*.csv)"))
    noted.parts.actions["export_notes"].trigger()
    target = tmp_path / (name if "." in name else f"{name}.csv")
    text = target.read_text("utf-8")
    assert noted.parts.bar.text == f"The notes are in {target}"
    if form == "text":
        assert text.startswith("[ ] 2 (0+02)  Light position\n    Slower\n")
    else:
        rows = list(csv.reader(io.StringIO(text.removeprefix("\ufeff"), newline="")))
        assert [row[4] for row in rows] == ["Note", "Slower", "Lighter"]


def test_a_place_that_refuses_is_said(noted: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    gone = tmp_path / "gone" / "n.csv"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(gone), ""))
    noted.parts.actions["export_notes"].trigger()
    assert str(gone) in noted.parts.bar.text


def test_what_was_said_in_a_review_is_saved(noted: MainWindow, qtbot: QtBot, tmp_path: Path) -> None:
    noted.parts.actions["review"].trigger()
    noted.parts.actions["remark_next"].trigger()
    qtbot.mouseClick(noted.parts.review_bar.ticked, Qt.MouseButton.LeftButton)
    noted.parts.open_project.save(tmp_path / "n.kage")
    assert [note.is_done for note in load(tmp_path / "n.kage").notes] == [True, False]
