"""When the drawings of a retake are seen, and where frames and keys go."""

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.document.model import Cels, Drawing, Exposure
from kagezou.importing.retakes.timing import Retimed, retimed


def cels(*exposures: tuple[int, int | None], count: int | None = None) -> Cels:
    """Return drawings named by letters, as numbers would say when they are seen."""
    highest = max((drawing for _, drawing in exposures if drawing is not None), default=-1)
    letters = "abcdefghijkl"[: highest + 1 if count is None else count]
    drawings = tuple(Drawing(letter, Path(f"/cels/{letter}.png")) for letter in letters)
    return Cels(drawings, tuple(Exposure(frame, drawing) for frame, drawing in exposures))


def numbered(*frames: tuple[int, int]) -> Cels:
    """Return drawings by their frames and numbers."""
    drawings = tuple(Drawing(str(number), Path(f"/cels/{number}.png")) for _, number in frames)
    return Cels(drawings, tuple(Exposure(frame, index) for index, (frame, _) in enumerate(frames)))


def shown(retake: Retimed) -> list[tuple[int, int | None]]:
    return [(each.frame, each.drawing) for each in retake.exposures]


ON_TWOS = cels((1, 0), (3, 1), (5, 2), (7, 3))


def test_drawings_put_in_are_held_as_the_one_before_and_move_what_is_behind() -> None:
    retake = retimed(ON_TWOS, cels(count=6), {0: 0, 1: 1, 2: 4, 3: 5}, 8)
    assert shown(retake) == [(1, 0), (3, 1), (5, 2), (7, 3), (9, 4), (11, 5)]
    assert retake.length_frames == 12
    assert [retake.moved(frame) for frame in (1, 2, 3, 4, 5, 6, 7, 8, 9)] == [1, 2, 3, 4, 9, 10, 11, 12, 13]


def test_drawings_that_are_gone_close_the_gap() -> None:
    retake = retimed(ON_TWOS, cels(count=2), {0: 0, 3: 1}, 8)
    assert shown(retake) == [(1, 0), (3, 1)]
    assert retake.gone == (3, 5)
    assert retake.closes_up
    assert [retake.moved(frame) for frame in (1, 2, 3, 5, 7, 8)] == [1, 2, 3, 3, 3, 4]


def test_held_longer_stays_held_longer() -> None:
    held = cels((1, 0), (9, 1), (11, 2))
    retake = retimed(held, cels(count=4), {0: 0, 1: 2, 2: 3}, 12)
    assert shown(retake) == [(1, 0), (9, 1), (17, 2), (19, 3)]


def test_the_last_drawing_is_only_held_on() -> None:
    retake = retimed(cels((1, 0), (2, 1)), cels(count=3), {0: 0, 1: 1}, 48)
    assert shown(retake) == [(1, 0), (2, 1), (3, 2)]
    assert retake.length_frames == 3


def test_the_timing_of_a_sheet_stays_on_its_frames() -> None:
    looped = cels((1, 0), (3, 1), (5, 0), (7, None), (9, 1))
    retake = retimed(looped, cels(count=4), {0: 2, 1: 3}, 24)
    assert shown(retake) == [(1, 2), (3, 3), (5, 2), (7, None), (9, 3)]
    assert retake.unseen == (0, 1)
    assert retake.moves == ()
    assert retake.moved(9) == 9


def test_where_a_drawing_of_a_sheet_is_gone_the_one_before_is_held() -> None:
    looped = cels((1, 0), (3, 1), (5, 2), (7, 1))
    retake = retimed(looped, cels(count=2), {0: 0, 2: 1}, 24)
    assert shown(retake) == [(1, 0), (5, 1)]
    assert retake.gone == (3, 7)
    assert not retake.closes_up
    first_gone = retimed(looped, cels(count=2), {1: 0, 2: 1}, 24)
    assert shown(first_gone) == [(1, None), (3, 0), (5, 1), (7, 0)]


def test_where_none_is_known_again_the_files_say_when() -> None:
    looped = cels((1, 0), (3, 1), (5, 0))
    retake = retimed(looped, cels((1, 0), (2, 1), (3, 2)), {}, 24)
    assert shown(retake) == [(1, 0), (2, 1), (3, 2)]
    assert retake.gone == (1, 3, 5)
    plain = retimed(ON_TWOS, cels((1, 0), (2, 1), (3, 2)), {}, 24)
    assert shown(plain) == [(1, 0), (3, 1), (5, 2)], "on twos as before"


def test_a_drawing_held_shorter_keeps_its_frames_within_it() -> None:
    before = cels((1, 0), (11, 1), (13, 2))
    retake = Retimed((), 0, ((1, 1), (11, 4), (13, 6)))
    assert [retake.moved(frame) for frame in (1, 3, 9, 10, 11)] == [1, 3, 3, 3, 4]
    assert before.index_at(10) == 0


def test_drawings_that_changed_places_move_no_frame() -> None:
    assert retimed(ON_TWOS, cels(count=4), {0: 3, 1: 2, 2: 1, 3: 0}, 8).moves == ()


def test_numbers_that_are_frames_still_are() -> None:
    before = numbered((3, 1), (5, 3), (7, 5))
    retake = retimed(before, numbered((1, 1), (3, 3), (4, 4), (5, 5)), {0: 0, 1: 1, 2: 3}, 24)
    assert shown(retake) == [(3, 0), (5, 1), (6, 2), (7, 3)]
    assert retake.moves == ()
    fewer = retimed(before, numbered((1, 5)), {2: 0}, 24)
    assert shown(fewer) == [(3, 0)]
    assert fewer.gone == (3, 5)
    assert fewer.moved(7) == 3
    assert retimed(before, Cels(), {}, 24).exposures == ()


def test_numbers_that_are_no_frames_are_only_names() -> None:
    retake = retimed(numbered((1, 1), (3, 2), (5, 3)), numbered((1, 1), (2, 2), (3, 3)), {0: 0, 1: 1, 2: 2}, 24)
    assert shown(retake) == [(1, 0), (3, 1), (5, 2)]


def test_no_drawings_before() -> None:
    retake = retimed(Cels(), cels(count=2), {}, 24)
    assert shown(retake) == [(1, 0), (2, 1)]
    assert retake.moved(7) == 7


@pytest.mark.parametrize("start", [1, 5])
def test_a_cut_that_begins_later_still_does(start: int) -> None:
    retake = retimed(cels((start, 0), (start + 1, 1)), cels(count=3), {0: 0, 1: 2}, 24)
    assert shown(retake)[0] == (start, 0)


@st.composite
def retakes(draw: st.DrawFn) -> tuple[Cels, int, dict[int, int], int]:
    held = draw(st.lists(st.integers(1, 4), min_size=1, max_size=8))
    starts = [1 + sum(held[:number]) for number in range(len(held))]
    count = draw(st.integers(1, 10))
    kept = draw(st.integers(0, min(len(held), count)))
    old = sorted(draw(st.permutations(range(len(held))))[:kept])
    new = sorted(draw(st.permutations(range(count)))[:kept])
    return cels(*zip(starts, range(len(held)), strict=True)), count, dict(zip(old, new, strict=True)), sum(held)


@given(retakes())
def test_frames_keep_their_order_and_go_with_their_drawing(case: tuple[Cels, int, dict[int, int], int]) -> None:
    before, count, became, length = case
    retake = retimed(before, cels(count=count), became, length)
    after = Cels(cels(count=count).drawings, retake.exposures)
    frames = [retake.moved(frame) for frame in range(1, length + 1)]
    assert frames == sorted(frames)
    assert [each.drawing for each in retake.exposures] == list(range(count))
    for each in before.exposures:
        assert each.drawing is not None
        if each.drawing in became:
            assert after.index_at(retake.moved(each.frame)) == became[each.drawing]
