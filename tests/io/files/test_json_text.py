"""Strict JSON: what is taken, what is not, and where it says that it stands."""

import pytest

from kagezou.errors import ProjectProblem
from kagezou.io.files.json_text import Reader, parse


def test_whole_numbers_have_at_most_eighteen_digits() -> None:
    assert parse("9" * 18) == 10**18 - 1
    with pytest.raises(ProjectProblem, match=f"the number '{'9' * 19}' is out of range"):
        parse("9" * 19)


@pytest.mark.parametrize("value", [True, False])
def test_true_and_false_are_no_numbers(*, value: bool) -> None:
    with pytest.raises(ProjectProblem, match="is not a number from 0 to 2"):
        Reader(value).number(0, 2)
    with pytest.raises(ProjectProblem, match="is not a whole number from 0 to 2"):
        Reader(value).whole(0, 2)


def test_numbers_hold_their_ends() -> None:
    assert [Reader(value).number(0, 2) for value in (0, 2, 0.5)] == [0.0, 2.0, 0.5]
    for value in (-0.001, 2.001, "1", None):
        with pytest.raises(ProjectProblem, match="is not a number"):
            Reader(value).number(0, 2)


def test_a_list_says_how_many_items_it_should_have() -> None:
    reader = Reader([1, 2, 3], "$.a")
    assert [item.place for item in reader.items(3, 3)] == ["$.a[0]", "$.a[1]", "$.a[2]"]
    with pytest.raises(ProjectProblem, match=r"^\$\.a: it has 3 items, not 2$"):
        reader.items(2, 2)
    with pytest.raises(ProjectProblem, match=r"^\$\.a: it has 3 items, not 4 to 9$"):
        reader.items(9, 4)
