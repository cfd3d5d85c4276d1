"""Strict reading of JSON with the place of every mistake, and writing it so that it can be read and compared by line.

The standard reader is lenient where a project must not be: it takes NaN, turns 1e999 into infinity, lets the last of
two equal keys win and dives until the stack ends.
"""

import json
import re
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import isfinite
from typing import Final, Never

from kagezou.errors import ProjectProblem
from kagezou.message import Message

MOST_VALUES: Final = 2_000_000
"""So many lists, objects and commas may be in a text."""

_MAX_DIGITS: Final = 18
_SHOWN_CHARACTERS: Final = 60
_PLAIN_NAME: Final = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
_LONE_SURROGATE: Final = re.compile("[\ud800-\udfff]")


def parse(text: str, most_values: int = MOST_VALUES) -> object:
    """Return the JSON value that ``text`` holds; a byte order mark before it is allowed.

    Raises
    ------
    ProjectProblem
        If it is not JSON, a number is not finite or too long, a key stands twice, it is nested too deep, or it has more
        than ``most_values`` lists, objects and commas.
    """
    # Each value takes far more memory than its text; commas within texts are counted as well, which is no matter.
    if value_count(text) > most_values:
        raise ProjectProblem(Message("it has more than {most} values", most=most_values))
    try:
        return json.loads(
            text.removeprefix("\ufeff"),
            object_pairs_hook=_members,
            parse_constant=_no_constant,
            parse_float=_finite,
            parse_int=_short,
        )
    except json.JSONDecodeError as error:
        if not text.strip("\ufeff \t\r\n"):
            raise ProjectProblem(Message("the file is empty")) from error
        raise ProjectProblem(
            Message(
                "it is not complete JSON text (line {lineno}, column {colno})", lineno=error.lineno, colno=error.colno
            )
        ) from error
    except RecursionError as error:
        raise ProjectProblem(Message("it is nested too deep")) from error


def value_count(text: str) -> int:
    """Return how many lists, objects and commas are in a text."""
    return text.count(",") + text.count("[") + text.count("{")


def _members(pairs: list[tuple[str, object]]) -> dict[str, object]:
    members = dict(pairs)
    if len(members) != len(pairs):
        counts = Counter(name for name, _ in pairs)
        twice = counts.most_common(1)[0][0]
        raise ProjectProblem(Message("the key {twice} stands twice in one object", twice=brief(twice)))
    return members


def _no_constant(name: str) -> Never:
    raise ProjectProblem(Message("{name} is not a number of a project", name=name))


def _finite(text: str) -> float:
    number = float(text)
    if not isfinite(number):
        raise ProjectProblem(Message("the number {text} is out of range", text=brief(text)))
    return number


def _short(text: str) -> int:
    if len(text) > _MAX_DIGITS:
        raise ProjectProblem(Message("the number {text} is out of range", text=brief(text)))
    return int(text)


def brief(value: object) -> str:
    """Return a value for a message: on one line, printable and short."""
    match value:
        case dict():
            return "an object"
        case list():
            return f"a list of {len(value)}"
        case None:
            return "null"
        case bool():
            return str(value).lower()
    shown = ascii(value) if isinstance(value, str) and not value.isprintable() else repr(value)
    return shown if len(shown) <= _SHOWN_CHARACTERS else shown[: _SHOWN_CHARACTERS - 3] + "..."


@dataclass(frozen=True, slots=True)
class Reader:
    """A JSON value and its place; whatever is asked of it that it is not becomes one sentence.

    Parameters
    ----------
    value
        As :func:`parse` gives it.
    place
        The JSON path, ``$`` for the whole.
    """

    value: object
    place: str = "$"

    def problem(self, cause: Message) -> ProjectProblem:
        """Return the problem of this place."""
        return ProjectProblem(Message("{place}: {cause}", place=self.place, cause=cause))

    def refused(self, wanted: Message) -> ProjectProblem:
        """Return the problem that this value is not what is wanted."""
        return self.problem(Message("{value} is not {wanted}", value=brief(self.value), wanted=wanted))

    def members(self) -> dict[str, "Reader"]:
        """Return the members of an object by name."""
        if not isinstance(self.value, dict):
            raise self.refused(Message("an object"))
        return {name: Reader(value, self.place + _step(name)) for name, value in self.value.items()}

    def record(self, required: Sequence[str], optional: Sequence[str] = ()) -> dict[str, "Reader"]:
        """Return the members of an object that has all the required keys and, beside the optional ones, no others."""
        members = self.members()
        for name in required:
            if name not in members:
                raise self.problem(Message("the key {name!r} is missing", name=name))
        for name in members:
            if name not in required and name not in optional:
                raise self.problem(Message("the key {name} is not known", name=brief(name)))
        return members

    def items(self, most: int, least: int = 0) -> Iterator["Reader"]:
        """Yield the items of a list of ``least`` to ``most``."""
        if not isinstance(self.value, list):
            raise self.refused(Message("a list"))
        if not least <= len(self.value) <= most:
            raise self.problem(_miscounted(len(self.value), least, most))
        return (Reader(value, f"{self.place}[{index}]") for index, value in enumerate(self.value))

    def whole(self, low: int, high: int) -> int:
        """Return a whole number from ``low`` to ``high``; true and 1.0 are none."""
        if isinstance(self.value, bool) or not isinstance(self.value, int) or not low <= self.value <= high:
            raise self.refused(Message("a whole number from {low} to {high}", low=low, high=high))
        return self.value

    def number(self, low: float, high: float) -> float:
        """Return a number from ``low`` to ``high``."""
        if isinstance(self.value, bool) or not isinstance(self.value, (int, float)) or not low <= self.value <= high:
            raise self.refused(Message("a number from {low:g} to {high:g}", low=low, high=high))
        return float(self.value)

    def switch(self) -> bool:
        """Return true or false."""
        if not isinstance(self.value, bool):
            raise self.refused(Message("true or false"))
        return self.value

    def text(self, most: int, least: int = 1) -> str:
        """Return a text of ``least`` to ``most`` characters."""
        if not isinstance(self.value, str) or not least <= len(self.value) <= most:
            raise self.refused(Message("a text of {least} to {most} characters", least=least, most=most))
        return self.value

    def word(self, words: Sequence[str]) -> str:
        """Return one of some words."""
        if not isinstance(self.value, str) or self.value not in words:
            raise self.refused(Message("one of {words}", words=", ".join(words)))
        return self.value


def _miscounted(count: int, least: int, most: int) -> Message:
    if least == most:
        return Message("it has {count} items, not {most}", count=count, most=most)
    return Message("it has {count} items, not {least} to {most}", count=count, least=least, most=most)


def _step(name: str) -> str:
    return f".{name}" if _PLAIN_NAME.fullmatch(name) else f"[{brief(name)}]"


@dataclass(frozen=True, slots=True)
class JsonRow:
    """A value that :func:`formatted` writes on one line."""

    value: object


def formatted(value: object) -> str:
    """Return a JSON value as text: objects and lists one member a line, rows on one line, LF at the ends."""
    return "".join(_pieces(value, "\n")) + "\n"


def _pieces(value: object, line: str) -> Iterator[str]:
    """Yield the text of a value; ``line`` is the line feed with the indentation around it."""
    if isinstance(value, dict) and value:
        opening, closing = "{", "}"
        parts = [(f"{_on_one_line(name)}: ", each) for name, each in value.items()]
    elif isinstance(value, list) and value:
        opening, closing = "[", "]"
        parts = [("", each) for each in value]
    else:
        yield _on_one_line(value.value if isinstance(value, JsonRow) else value)
        return
    for index, (head, each) in enumerate(parts):
        yield f"{',' if index else opening}{line}  {head}"
        yield from _pieces(each, line + "  ")
    yield f"{line}{closing}"


def _on_one_line(value: object) -> str:
    """Return JSON text in Unicode; bytes of file names that are no UTF-8 stay escaped, as they cannot be encoded."""
    text = json.dumps(value, ensure_ascii=False, allow_nan=False)
    return _LONE_SURROGATE.sub(lambda found: f"\\u{ord(found[0]):04x}", text)
