"""Arithmetic in number fields."""

import pytest

from kagezou.document.typed_number import evaluate
from kagezou.errors import UsageProblem


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
