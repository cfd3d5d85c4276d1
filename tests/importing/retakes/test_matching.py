"""Which drawing became which: by name and picture, likeness, order; never two from one, never one from two."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.importing.retakes.matching import How, Known, Match, matched
from kagezou.importing.retakes.prints import SKETCH, Print

GRID = np.mgrid[0:SKETCH, 0:SKETCH] / SKETCH


def pose(number: float, blur: float = 0.0) -> Print:
    """Return the print of a figure whose legs swing with ``number``; a redrawn one differs by ``blur`` from it."""
    y, x = GRID
    body = (abs(x - 0.5) < 0.2) & (y < 0.55)
    swing = 0.4 * np.sin(number)
    legs = (y >= 0.55) & (abs(x - 0.5 - swing * (y - 0.55) * 2) < 0.12)
    alpha = (body | legs).astype(np.float32) * (1 - blur)
    sketch = np.stack([alpha * 0.3, alpha * 0.5, alpha * 0.7, alpha], -1).astype(np.float32)
    return Print(f"{number} {blur}".encode(), sketch, 0.5)


def known(*numbers: float, names: tuple[object, ...] | None = None, blur: float = 0.0) -> list[Known]:
    return [
        Known(name, pose(number, blur))
        for name, number in zip(names or range(1, len(numbers) + 1), numbers, strict=True)
    ]


def pairs(before: list[Known], after: list[Known]) -> dict[int, tuple[int, How]]:
    return {match.before: (match.after, match.how) for match in matched(before, after)}


def test_nothing_changed() -> None:
    assert pairs(known(0, 1, 2), known(0, 1, 2)) == {each: (each, How.SAME) for each in range(3)}


def test_one_drawn_anew_keeps_its_name() -> None:
    found = pairs(known(0, 1, 2), known(0, 40, 2))
    assert found == {0: (0, How.SAME), 1: (1, How.NAME), 2: (2, How.SAME)}


def test_drawings_put_in_between_give_all_behind_them_other_numbers() -> None:
    found = pairs(known(0, 1, 2, 3), known(0, 1, 0.4, 0.6, 2, 3))
    assert found == {0: (0, How.SAME), 1: (1, How.SAME), 2: (4, How.PICTURE), 3: (5, How.PICTURE)}


def test_the_same_though_every_line_was_cleaned_up() -> None:
    """Names lie here too: behind the new one, each old pose lies under another number."""
    found = pairs(known(0, 1, 2, 3.2), known(0, 1, 0.5, 2, 3.2, blur=0.02))
    assert {old: new for old, (new, _) in found.items()} == {0: 0, 1: 1, 2: 3, 3: 4}


def test_all_renumbered_and_some_gone() -> None:
    found = pairs(known(0, 1, 2, 3), known(1, 3, names=(101, 102)))
    assert found == {1: (0, How.PICTURE), 3: (1, How.PICTURE)}


def test_renamed_and_drawn_again_are_known_by_likeness_in_their_order() -> None:
    found = pairs(known(0, 1, 2), known(0, 1, 2, names=("a", "b", "c"), blur=0.05))
    assert found == {each: (each, How.LIKENESS) for each in range(3)}


def test_what_cannot_be_read_is_known_by_name_and_else_by_order() -> None:
    before = [Known(name, None) for name in (1, 2, 3)]
    assert pairs(before, known(0, 1, 2)) == {each: (each, How.NAME) for each in range(3)}
    assert pairs(before, known(0, 1, 2, names=("a", "b", "c"))) == {each: (each, How.ORDER) for each in range(3)}
    assert pairs(before, known(0, 1, names=("a", "b"))) == {}, "which of the three is gone nobody can say"


def test_order_counts_between_two_that_are_known() -> None:
    before = known(0, 1, 2, 30)
    after = [known(0)[0], Known("x", pose(11, 0.6)), Known("y", pose(12, 0.6)), *known(30, names=(4,))]
    found = pairs(before, after)
    assert found[1] == (1, How.ORDER)
    assert found[2] == (2, How.ORDER)


def test_where_drawings_changed_places_order_says_nothing() -> None:
    before = [*known(0, 1), Known("lost", None)]
    after = [*known(1, 0, names=("a", "b")), Known("new", None)]
    assert pairs(before, after) == {0: (1, How.PICTURE), 1: (0, How.PICTURE)}


def test_equal_pictures_keep_their_order() -> None:
    before, after = known(5, 5, 5), known(5, 5, 5, names=("a", "b", "c"))
    assert pairs(before, after) == {each: (each, How.PICTURE) for each in range(3)}


@pytest.mark.parametrize("sides", [(0, 3), (3, 0), (0, 0)])
def test_without_drawings_there_is_nothing_to_match(sides: tuple[int, int]) -> None:
    assert matched(known(*range(sides[0])), known(*range(sides[1]))) == ()


KNOWN = st.lists(
    st.builds(
        lambda name, number, blur, is_read: Known(name, pose(number, blur) if is_read else None),
        st.integers(1, 6),
        st.integers(0, 5),
        st.sampled_from((0.0, 0.03, 0.5)),
        st.booleans(),
    ),
    max_size=7,
)


@given(KNOWN, KNOWN)
def test_each_is_in_one_match_at_most(before: list[Known], after: list[Known]) -> None:
    found = matched(before, after)
    assert len({match.before for match in found}) == len(found)
    assert [match.after for match in found] == sorted({match.after for match in found})
    assert all(0 <= match.before < len(before) and 0 <= match.after < len(after) for match in found)


@given(KNOWN)
def test_the_same_drawings_are_all_known_again(drawings: list[Known]) -> None:
    distinct = [each for number, each in enumerate(drawings) if each.name not in {x.name for x in drawings[:number]}]
    assert [(match.before, match.after) for match in matched(distinct, distinct)] == [
        (number, number) for number in range(len(distinct))
    ]


def test_a_match_is_a_value() -> None:
    assert Match(0, 1, How.NAME) == Match(0, 1, How.NAME)
