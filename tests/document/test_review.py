"""Work area, markers and notes."""

from pathlib import Path

import pytest

from kagezou.document import edits, review
from kagezou.document.address import Address
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure, Marker
from kagezou.document.note import Note, NoteAnswer
from kagezou.document.properties import OPACITY
from kagezou.errors import UsageProblem
from kagezou.geometry.box import Box


@pytest.fixture
def document() -> Document:
    cels = Cels((Drawing("1", Path("/c/1.png")),), (Exposure(1, 0),))
    return edits.add_layer(Document(Canvas(100, 100, length_frames=48)), "A", cels, Box(0, 0, 9, 9))


def test_the_work_area_lies_within_the_cut(document: Document) -> None:
    assert document.played == (1, 48)
    narrowed = review.set_work_area(document, 30, 10)
    assert narrowed.work_area == narrowed.played == (10, 30)
    assert review.set_work_area(document, 40, None).work_area == (40, 48)
    assert review.set_work_area(document, 0, 99) is document
    assert review.set_work_area(narrowed, None, None).work_area is None


def test_a_work_area_behind_the_end_of_a_shortened_cut_is_not_played(document: Document) -> None:
    narrowed = review.set_work_area(document, 30, 40)
    assert edits.set_canvas(narrowed, Canvas(100, 100, length_frames=35)).played == (30, 35)
    assert edits.set_canvas(narrowed, Canvas(100, 100, length_frames=20)).played == (1, 20)


def test_markers_are_kept_in_order_one_a_frame(document: Document) -> None:
    marked = review.set_marker(review.set_marker(document, Marker(20, "turn")), Marker(5, "step", 3))
    assert marked.markers == (Marker(5, "step", 3), Marker(20, "turn"))
    assert review.set_marker(marked, Marker(20, "stop")).markers[1].comment == "stop"
    assert review.set_marker(marked, Marker(20, "turn")) is marked
    assert review.move_marker(marked, 20, -3).markers == (Marker(1, "turn"), Marker(5, "step", 3))
    assert review.move_marker(marked, 20, 5).markers == (Marker(5, "turn"),)
    assert review.move_marker(marked, 7, 9) is marked
    assert review.remove_marker(marked, 5).markers == (Marker(20, "turn"),)
    assert review.remove_marker(marked, 6) is marked


@pytest.mark.parametrize("marker", [Marker(0), Marker(1, "", -1), Marker(1, "x" * 4001)])
def test_an_impossible_marker_is_refused(document: Document, marker: Marker) -> None:
    with pytest.raises(UsageProblem):
        review.set_marker(document, marker)


def test_notes_are_pinned_changed_and_go_with_their_layer(document: Document) -> None:
    address = Address(OPACITY, document.layers[0].id)
    noted = review.add_note(document, address, 7, "Lighter\nhere", "佐藤")
    note = Note(7, "shadow.opacity", "Lighter\nhere", document.layers[0].id, "佐藤")
    assert noted.notes == (note,)
    assert review.change_note(noted, note, "Darker").notes[0].text == "Darker"
    assert review.change_note(noted, note, note.text) is noted
    assert review.change_note(noted, note, " ").notes == ()
    assert edits.remove_layer(noted, document.layers[0].id).notes == ()
    with pytest.raises(UsageProblem):
        review.add_note(document, address, 7, "  ")
    with pytest.raises(UsageProblem):
        review.change_note(noted, note, "x" * 4001)


def test_notes_are_answered_and_ticked_off(document: Document) -> None:
    address = Address(OPACITY, document.layers[0].id)
    noted = review.add_note(review.add_note(document, address, 7, "Lighter"), address, 9, "Longer")
    first, second = noted.notes
    answered = review.answer_note(noted, first, "0.6?", "Kim")
    told = Note(7, "shadow.opacity", "Lighter", address.layer_id, answers=(NoteAnswer("0.6?", "Kim"),))
    assert answered.notes == (told, second)
    again = review.answer_note(answered, answered.notes[0], "Yes")
    assert [each.text for each in again.notes[0].answers] == ["0.6?", "Yes"]
    ticked = review.tick_note(again, again.notes[0], done=True)
    assert [each.is_done for each in ticked.notes] == [True, False]
    assert review.tick_note(ticked, ticked.notes[0], done=True) is ticked
    assert ticked.notes[0].is_as(first)
    assert not ticked.notes[0].is_as(second)
    assert review.tick_note(ticked, ticked.notes[0], done=False).notes == again.notes
    assert review.change_note(ticked, ticked.notes[0], "Darker").notes[0].answers == ticked.notes[0].answers


@pytest.mark.parametrize("text", ["", " \n", "x" * 4001])
def test_an_answer_needs_words_and_not_too_many(document: Document, text: str) -> None:
    noted = review.add_note(document, Address(OPACITY, document.layers[0].id), 7, "Lighter")
    with pytest.raises(UsageProblem):
        review.answer_note(noted, noted.notes[0], text)


def test_a_note_has_so_many_answers(document: Document) -> None:
    noted = review.add_note(document, Address(OPACITY, document.layers[0].id), 7, "Lighter")
    for number in range(review.MAX_ANSWERS):
        noted = review.answer_note(noted, noted.notes[0], str(number))
    with pytest.raises(UsageProblem, match="at most 200"):
        review.answer_note(noted, noted.notes[0], "one more")
