"""Frames as animators write them."""

from fractions import Fraction

import pytest

from kagezou.animation.timecode import Count, counted, parse_frame, parse_rate, rate_text, sheet_text
from kagezou.errors import UsageProblem


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


@pytest.mark.parametrize(
    ("count", "of_24", "of_film_on_video"),
    [
        (Count.FRAMES, ["1", "24", "25", "72", "73", "145", "1441"], ["1441"]),
        (Count.SECONDS, ["0+00", "0+23", "1+00", "2+23", "3+00", "6+00", "60+00"], ["60+00"]),
        (Count.SHEET_6, ["p1", "24", "25", "72", "73", "p2", "p11"], ["p11"]),
        (Count.SHEET_3, ["p1", "24", "25", "72", "p2", "p3", "p21"], ["p21"]),
        (
            Count.TIMECODE,
            ["00:00:00", "00:00:23", "00:01:00", "00:02:23", "00:03:00", "00:06:00", "01:00:00"],
            ["01:00:00"],
        ),
    ],
)
def test_a_ruler_counts_from_the_first_frame(count: Count, of_24: list[str], of_film_on_video: list[str]) -> None:
    frames = (1, 24, 25, 72, 73, 145, 1441)
    assert [counted(frame, Fraction(24), count) for frame in frames] == of_24
    assert [counted(1441, Fraction(24000, 1001), count)] == of_film_on_video


def test_a_rate_under_one_frame_a_second_counts_one() -> None:
    assert sheet_text(5, Fraction(1, 4)) == "5+00"


def test_numbers_may_begin_elsewhere_and_other_counts_do_not() -> None:
    assert parse_frame("104", 1, Fraction(24), 101) == 4
    assert parse_frame("0", 1, Fraction(24), 0) == 1
    assert parse_frame("+6", 4, Fraction(24), 101) == 10
    assert parse_frame("1+00", 4, Fraction(24), 101) == 24
    assert counted(4, Fraction(24), Count.FRAMES, 101) == "104"
    assert counted(25, Fraction(24), Count.SECONDS, 101) == "1+00"


@pytest.mark.parametrize(
    ("typed", "rate"),
    [
        ("24", Fraction(24)),
        (" 12.5 ", Fraction(25, 2)),
        ("23.976", Fraction(24000, 1001)),
        ("29.97", Fraction(30000, 1001)),
        ("30000/1001", Fraction(30000, 1001)),
        ("1/3", Fraction(1, 3)),
    ],
)
def test_a_rate_is_exact(typed: str, rate: Fraction) -> None:
    assert parse_rate(typed) == rate
    assert parse_rate(rate_text(rate)) == rate or rate == Fraction(1, 3)


@pytest.mark.parametrize("typed", ["", "0", "-24", "1001", "24/0", "24/00", "1e3", "²", "fast", "24 fps", "NaN"])
def test_what_is_no_rate_is_refused(typed: str) -> None:
    with pytest.raises(UsageProblem, match="frames a second"):
        parse_rate(typed)
