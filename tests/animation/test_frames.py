"""Frame ranges as people type them."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.animation.frames import format_frames, parse_frames, spread_frames
from kagezou.errors import UsageProblem


@pytest.mark.parametrize(
    ("text", "frames"),
    [
        ("3", (3,)),
        ("1-4", (1, 2, 3, 4)),
        ("1-3,20", (1, 2, 3, 20)),
        ("1-9x4", (1, 5, 9)),
        (" 20 , 1-3 ", (1, 2, 3, 20)),
        ("2,2,1-3", (1, 2, 3)),
        ("1-3x0", (1, 2, 3)),
    ],
)
def test_what_people_type(text: str, frames: tuple[int, ...]) -> None:
    assert parse_frames(text) == frames


@pytest.mark.parametrize("text", ["", "a", "1-", "-3", "1--3", "1-3x", "1.5", "1,,2", "x2", "1-3-5"])
def test_what_is_no_list_of_frames(text: str) -> None:
    with pytest.raises(UsageProblem, match="neither a frame such as 12 nor a range such as 1-48"):
        parse_frames(text)


@pytest.mark.parametrize("text", ["0", "5-3", "0-3", "1-1000001", "9" * 30])
def test_what_does_not_count_upward_from_one(text: str) -> None:
    with pytest.raises(UsageProblem, match="must count upward from frame 1"):
        parse_frames(text)


def test_the_shortest_text() -> None:
    assert format_frames([]) == ""
    assert format_frames([7]) == "7"
    assert format_frames([3, 1, 2, 2, 9, 11, 12]) == "1-3,9,11-12"


@given(st.sets(st.integers(1, 500), min_size=1))
def test_round_trip(frames: set[int]) -> None:
    assert parse_frames(format_frames(frames)) == tuple(sorted(frames))


@pytest.mark.parametrize(
    ("length", "most", "frames"),
    [(1, 5, (1,)), (2, 5, (1, 2)), (9, 5, (1, 3, 5, 7, 9)), (100, 2, (1, 100)), (4, 4, (1, 2, 3, 4))],
)
def test_frames_are_spread_over_a_cut(length: int, most: int, frames: tuple[int, ...]) -> None:
    assert spread_frames(length, most) == frames
