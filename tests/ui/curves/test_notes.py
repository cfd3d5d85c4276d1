"""Notes in the list: ticked off, answered and changed by its own controls, and locked with the rest."""

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QInputDialog
from pytestqt.qtbot import QtBot

from kagezou.document import review
from kagezou.document.address import Address
from kagezou.document.note import Note, NoteAnswer
from kagezou.document.properties import LIGHT_POSITION, OPACITY
from kagezou.ui.curves.annotating import Annotating
from kagezou.ui.curves.note_list import NoteList
from kagezou.ui.project.open_project import OpenProject

LIGHT = Address(LIGHT_POSITION)


@pytest.fixture
def notes(qtbot: QtBot, filled: OpenProject) -> NoteList:
    """The list with two notes, shown."""
    document = filled.bridge.document
    document = review.add_note(document, Address(OPACITY, document.layers[0].id), 5, "Lighter", "Sato")
    filled.bridge.session.edit("Notes", review.add_note(document, LIGHT, 2, "Slower"))
    made = NoteList(filled.bridge, Annotating(filled.bridge), lambda: LIGHT)
    filled.bridge.document_changed.connect(made.refresh)
    made.author = "Kim"
    qtbot.addWidget(made)
    made.resize(300, 300)
    made.show()
    return made


def said(filled: OpenProject) -> list[Note]:
    return sorted(filled.bridge.document.notes, key=lambda each: each.frame)


def box_of(notes: NoteList, row: int) -> QPoint:
    """Return the middle of the box before a row."""
    row_rect = notes.list.visualItemRect(notes.list.item(row))
    return QPoint(row_rect.left() + 9, row_rect.center().y())


def answer(notes: NoteList, text: str) -> None:
    dialog = notes.findChild(QInputDialog)
    assert dialog is not None
    dialog.setTextValue(text)
    dialog.accept()


def test_they_are_listed_in_the_order_of_frames_with_layer_and_author(notes: NoteList) -> None:
    texts = [notes.list.item(row).text() for row in range(notes.list.count())]
    assert texts == ["2   Light position\nSlower", "5   Walker · Opacity — Sato\nLighter"]


def test_a_click_on_its_box_ticks_a_note_off_and_takes_the_tick_away(
    notes: NoteList, filled: OpenProject, qtbot: QtBot
) -> None:
    left, none = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    QTest.mouseClick(notes.list.viewport(), left, none, box_of(notes, 1))
    qtbot.waitUntil(lambda: [note.is_done for note in said(filled)] == [False, True])
    assert notes.list.item(1).checkState() is Qt.CheckState.Checked
    assert notes.list.item(1).font().strikeOut()
    QTest.mouseClick(notes.list.viewport(), left, none, box_of(notes, 1))
    qtbot.waitUntil(lambda: [note.is_done for note in said(filled)] == [False, False])
    assert filled.bridge.session.undo_name == "Tick note"


def test_a_note_is_answered(notes: NoteList, filled: OpenProject, qtbot: QtBot) -> None:
    notes.list.setCurrentRow(1)
    qtbot.mouseClick(notes.answer_button, Qt.MouseButton.LeftButton)
    answer(notes, "0.6?")
    qtbot.waitUntil(lambda: bool(said(filled)[1].answers))
    assert said(filled)[1].answers == (NoteAnswer("0.6?", "Kim"),)
    assert notes.list.item(1).text().endswith("Lighter\n↳ Kim: 0.6?")
    assert notes.list.currentRow() == 1, "the note stays chosen"


def test_an_answer_without_words_is_refused(notes: NoteList, filled: OpenProject) -> None:
    refused: list[str] = []
    notes.refused.connect(refused.append)
    notes.answer(said(filled)[0], "  ")
    assert refused == ["An answer needs words, and a note has at most 200 answers"]
    notes.answer(said(filled)[0], "x" * 5000)
    assert len(refused) == 2


def test_a_new_note_is_signed(notes: NoteList, filled: OpenProject, qtbot: QtBot) -> None:
    filled.bridge.session.go_to(4)
    qtbot.mouseClick(notes.add_button, Qt.MouseButton.LeftButton)
    answer(notes, "Look")
    qtbot.waitUntil(lambda: len(said(filled)) == 3)
    assert said(filled)[1] == Note(4, "light.position", "Look", None, "Kim")


def test_look_only_locks_them_and_a_review_does_not(notes: NoteList, filled: OpenProject, qtbot: QtBot) -> None:
    before = filled.bridge.document
    filled.bridge.lock(True)
    assert not notes.answer_button.isEnabled()
    assert not notes.add_button.isEnabled()
    left, none = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    QTest.mouseClick(notes.list.viewport(), left, none, box_of(notes, 1))
    notes.change(said(filled)[0], "")
    assert filled.bridge.document is before
    notes._annotating.review(on=True)
    assert notes.answer_button.isEnabled()
    QTest.mouseClick(notes.list.viewport(), left, none, box_of(notes, 1))
    qtbot.waitUntil(lambda: [note.is_done for note in said(filled)] == [False, True])
    assert filled.bridge.is_locked
