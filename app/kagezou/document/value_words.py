"""Values of properties as people and programs write and read them: the words of every door but the window's."""

import json
import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Final, NoReturn

from kagezou.animation.track import Interpolation, Key, Value
from kagezou.errors import UsageProblem
from kagezou.message import Message

Json = str | int | float | bool | None | Sequence["Json"] | Mapping[str, "Json"]

_COORDINATES: Final = re.compile(r"[-+]?[0-9]+(?:\.[0-9]+)?(?:\s*,\s*[-+]?[0-9]+(?:\.[0-9]+)?){1,2}")
"""Two or three numbers without brackets, which many shells keep for themselves."""


def json_of_value(value: Value) -> Json:
    """Return a value as JSON; whole numbers without a point, so that they read as they were typed."""
    match value:
        case int() | str():
            return value
        case float():
            return int(value) if value.is_integer() else value
        case tuple():
            return [json_of_value(part) for part in value]


def text_of_value(value: Value) -> str:
    """Return a value as the text that ``kagezou set`` takes and ``kagezou get`` prints."""
    return json.dumps(json_of_value(value), ensure_ascii=False)


def json_of_keys(given: Iterable[Key]) -> list[Json]:
    """Return keys in the order in which they are given."""
    keys: list[Json] = []
    for key in given:
        entry: dict[str, Json] = {
            "frame": key.frame,
            "value": json_of_value(key.value),
            "interp": key.interpolation.value,
        }
        if key.interpolation is Interpolation.BEZIER or key.ease_in or key.ease_out:
            entry["ease_in"] = [[ease.speed, ease.influence] for ease in key.ease_in]
            entry["ease_out"] = [[ease.speed, ease.influence] for ease in key.ease_out]
        keys.append(entry)
    return keys


class NotJson(UsageProblem):
    """What was typed as a value cannot be read."""


def value_of_text(path: str, text: str) -> object:
    """Return the JSON value that was typed for a property; one bare word or colour is itself, and ``x,y`` a list.

    Raises
    ------
    NotJson
        If it is neither.
    """
    try:
        value: object = json.loads(text, parse_constant=_no_constant)
    except (ValueError, RecursionError):
        if (coordinates := _COORDINATES.fullmatch(text.strip())) is not None:
            return [float(number) for number in coordinates[0].split(",")]
        bare = text.removeprefix("#")
        if text and bare.isascii() and bare.replace("_", "").isalnum():
            return text
        raise NotJson(
            Message(
                '{path}: {text!r} is not JSON: a number, true, "word", x,y or [x, y] or [[x, y], ...]',
                path=path,
                text=text[:60],
            )
        ) from None
    return value


def _no_constant(name: str) -> NoReturn:
    raise ValueError(name)
