"""Messages: a text and its values, put together where they are shown."""

from pathlib import Path

import pytest

from kagezou.errors import InputProblem, Problem
from kagezou.message import Message, Translatable, first_names

JAPANESE = {
    "{path}: {cause}": "{path}：{cause}",
    "it does not exist": "見つかりません",
    "{count} of {whole}": "{whole} のうち {count}",
}


def translate(text: str, about: str) -> str:
    return "階段" if (text, about) == ("Steps", "stairs") else JAPANESE.get(text, text)


def test_english_is_what_the_command_line_shows() -> None:
    assert str(Message("{name!r} is {share:.1f} % of {count}", name="A", share=33.33, count=3)) == "'A' is 33.3 % of 3"


def test_values_stand_where_the_language_has_them() -> None:
    assert Message("{count} of {whole}", count=1, whole=3).formatted(translate) == "3 のうち 1"


def test_a_message_within_a_message_is_translated_with_it() -> None:
    cause = Message("it does not exist")
    message = Message("{path}: {cause}", path=Path("a.png"), cause=cause)
    assert str(message) == "a.png: it does not exist"
    assert message.formatted(translate) == "a.png：見つかりません"


def test_a_problem_within_a_message_is_translated_with_it() -> None:
    problem = InputProblem(Message("{path}: {cause}", path="a", cause=Message("it does not exist")))
    outer = Problem(Message("{path}: {cause}", path="b", cause=problem))
    assert str(outer) == "b: a: it does not exist"
    assert outer.formatted(translate) == "b：a：見つかりません"
    assert isinstance(outer, Translatable)


def test_braces_in_values_are_values() -> None:
    message = Message("{path}: {cause}", path="{name}", cause="{0}")
    assert str(message) == "{name}: {0}"


def test_a_sentence_of_its_own_begins_with_a_capital_and_a_name_stays() -> None:
    assert Message("it does not exist").sentence(lambda text, _: text) == "It does not exist"
    assert Message("{path}: {cause}", path="walk.kage", cause="x").sentence(lambda text, _: text) == "walk.kage: x"
    assert Message("it does not exist").sentence(translate) == "見つかりません"


def test_equal_texts_about_different_things_are_told_apart() -> None:
    assert Message("Steps", "stairs").formatted(translate) == "階段"
    assert Message("Steps").formatted(translate) == "Steps"
    assert Message("Steps", "stairs") != Message("Steps")


def test_messages_are_equal_by_text_and_values() -> None:
    assert Message("{a}", a=1) == Message("{a}", a=1)
    assert Message("{a}", a=1) != Message("{a}", a=2)
    assert len({Message("{a}", a=1), Message("{a}", a=1), Message("{b}", b=1)}) == 2
    assert Message("x") != "x"


def test_a_missing_value_is_an_error_of_the_program() -> None:
    with pytest.raises(KeyError):
        str(Message("{a}"))


def test_a_message_shows_itself_as_its_call() -> None:
    assert repr(Message("{a}", a="b")) == "Message('{a}', a='b')"


def test_of_many_names_the_first_are_told() -> None:
    assert first_names(["a", "b", "c"]) == "a, b, c"
    assert first_names(name for name in "abcd") == "a, b, c, …"
    assert first_names(["a", "b"], most=1) == "a, …"
    assert first_names([]) == ""
