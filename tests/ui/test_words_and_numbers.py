"""Typing: arithmetic in number fields, frames as animators write them, files that are dropped. No widgets."""

from fractions import Fraction
from pathlib import Path

import pytest

from kagezou.animation.timecode import parse_frame, sheet_text
from kagezou.document.keyed_frames import next_key, previous_key
from kagezou.document.typed_number import evaluate
from kagezou.errors import UsageProblem
from kagezou.ui.project.dropped_files import dropped_files_of, whole_sequence


@pytest.mark.parametrize(
    ("typed", "result"),
    [
        ("12.5", 12.5),
        ("-3", -3.0),
        ("12,5", 12.5),
        ("(3+4)*2", 14.0),
        ("*2", 20.0),
        ("/4", 2.5),
        ("+10", 20.0),
        ("-=4", 6.0),
        ("+=4", 14.0),
        ("50%", 5.0),
        ("−1", -1.0),
    ],
)
def test_a_number_field_calculates(typed: str, result: float) -> None:
    assert evaluate(typed, 10.0) == result


@pytest.mark.parametrize(
    "typed", ["", "abc", "__import__('os')", "1/0", "2**9999", "1e999", "True", "[1]", "%", "()", "9" * 61, "1 2", "x%"]
)
def test_anything_else_is_refused_in_one_sentence(typed: str) -> None:
    with pytest.raises(UsageProblem, match="not a number"):
        evaluate(typed, 10.0)


@pytest.mark.parametrize(
    ("typed", "frame"), [("84", 84), ("3+12", 84), ("3:12", 84), ("+6", 16), ("-4", 6), (" 12 ", 12), ("0+01", 1)]
)
def test_frames_are_typed_as_animators_write_them(typed: str, frame: int) -> None:
    assert parse_frame(typed, 10, Fraction(24)) == frame


@pytest.mark.parametrize("typed", ["", "a", "1.5", "1+2+3", "++2", "12345678"])
def test_a_text_that_is_no_frame_is_refused(typed: str) -> None:
    with pytest.raises(UsageProblem, match="is not a frame"):
        parse_frame(typed, 1, Fraction(24))


@pytest.mark.parametrize(
    ("frame", "rate", "text"),
    [
        (84, Fraction(24), "3+12"),
        (24, Fraction(24), "1+00"),
        (1, Fraction(24), "0+01"),
        (48, Fraction(24000, 1001), "2+00"),
    ],
)
def test_a_length_is_written_in_seconds_and_frames(frame: int, rate: Fraction, text: str) -> None:
    assert sheet_text(frame, rate) == text


def test_previous_and_next_key() -> None:
    assert previous_key((3, 9), 9) == 3
    assert previous_key((3, 9), 3) is None
    assert next_key((3, 9), 3) == 9
    assert next_key((3, 9), 9) is None


def test_dropped_files_are_sorted_out(tmp_path: Path) -> None:
    folder = tmp_path / "A"
    folder.mkdir()
    numbered = [tmp_path / f"walk_{n:03d}.png" for n in (1, 2, 3)]
    assert dropped_files_of([folder]).characters[0].path == folder
    assert [source.path for source in dropped_files_of(numbered).characters] == [tmp_path / "walk_#.png"]
    assert [source.path for source in dropped_files_of(numbered[:1]).characters] == numbered[:1]
    assert dropped_files_of([tmp_path / "cut.kage", folder]).project == tmp_path / "cut.kage"
    assert dropped_files_of([tmp_path / "room.jpg"]).background == tmp_path / "room.jpg"
    assert dropped_files_of([tmp_path / "notes.txt"]).is_empty


def test_a_numbered_picture_stands_for_its_sequence() -> None:
    assert whole_sequence(Path("/c/A0001.png")) == Path("/c/A#.png")
    assert whole_sequence(Path("/c/A_12a.tga")) == Path("/c/A_#a.tga")
    assert whole_sequence(Path("/c/hero.png")) == Path("/c/hero.png")
