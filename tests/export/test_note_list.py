"""Notes as lists to hand on."""

import csv
import io
from pathlib import Path

import pytest

from kagezou.document import review
from kagezou.document.address import Address
from kagezou.document.model import Document
from kagezou.document.properties import LIGHT_POSITION, OPACITY
from kagezou.export.note_list import note_rows, notes_as_csv, notes_as_text
from tests.export.small_cuts import cut


@pytest.fixture
def document(tmp_path: Path) -> Document:
    made = cut(tmp_path, count=2, length=48)
    opacity = Address(OPACITY, made.layers[0].id)
    made = review.add_note(made, opacity, 30, "Lighter\nat the end", "佐藤")
    made = review.add_note(made, Address(LIGHT_POSITION), 7, "=Slower, please")
    made = review.answer_note(made, made.notes[0], "0.6?\nor less", "Kim")
    made = review.answer_note(made, made.notes[0], "Yes")
    return review.tick_note(made, made.notes[0], done=True)


def plain(text: str, _about: str) -> str:
    return text


def loud(text: str, _about: str) -> str:
    return text.upper()


def test_lines_are_in_the_order_of_frames_with_answers_below(document: Document) -> None:
    assert notes_as_text(document, plain) == (
        "[ ] 7 (0+07)  Light position\n"
        "    =Slower, please\n"
        "\n"
        "[x] 30 (1+06)  A · Opacity (佐藤)\n"
        "    Lighter\n"
        "    at the end\n"
        "    > Kim: 0.6?\n"
        "      or less\n"
        "    > Yes\n"
    )
    assert [row.layer for row in note_rows(document)] == ["", "A"]


def test_a_table_is_read_by_spreadsheets(document: Document) -> None:
    text = notes_as_csv(document, loud)
    assert text.startswith("\ufeff"), "else Japanese is garbled there"
    rows = list(csv.reader(io.StringIO(text.removeprefix("\ufeff"), newline="")))
    assert rows[0] == ["FRAME", "TIME", "LAYER", "PROPERTY", "NOTE", "AUTHOR", "ANSWERS", "DONE"]
    assert rows[1] == ["7", "0+07", "", "LIGHT POSITION", "'=Slower, please", "", "", "0"]
    assert rows[2] == ["30", "1+06", "A", "OPACITY", "Lighter\nat the end", "佐藤", "Kim: 0.6?\nor less\nYes", "1"]


def test_no_notes_are_no_lines(document: Document) -> None:
    empty = review.change_note(review.change_note(document, document.notes[1], ""), document.notes[0], "")
    assert notes_as_text(empty, plain) == ""
    assert len(notes_as_csv(empty, plain).splitlines()) == 1
