"""Messages as JSON and back, so that what one process found out is said by another, in any language."""

from collections.abc import Mapping
from typing import Final

from kagezou.errors import Problem
from kagezou.message import Message

_MOST_DEEP: Final = 8

Json = None | bool | int | float | str | list["Json"] | dict[str, "Json"]


def json_of_message(message: Message) -> Json:
    """Return a message as JSON; values that JSON does not know are kept as text."""
    return {
        "text": message.text,
        "about": message.about,
        "values": {name: _json_of_value(value) for name, value in message.values.items()},
    }


def message_of_json(tree: object) -> Message:
    """Return a message of its JSON; what is none is said as it stands."""
    return _message(tree, 0)


def _json_of_value(value: object) -> Json:
    if isinstance(value, Message):
        return json_of_message(value)
    if isinstance(value, Problem):
        return json_of_message(value.message)
    return value if isinstance(value, bool | int | float | str) else str(value)


def _message(tree: object, depth: int) -> Message:
    match tree:
        case {"text": str(text), "about": str(about), "values": Mapping() as values} if depth < _MOST_DEEP:
            found = Message.retold(text, about, {str(name): _value(each, depth) for name, each in values.items()})
            if _can_be_said(found):
                return found
    return Message.retold("{said}", "", {"said": str(tree)})


def _value(value: object, depth: int) -> object:
    return _message(value, depth + 1) if isinstance(value, Mapping) else value


def _can_be_said(message: Message) -> bool:
    """Return whether a message has all its values: a file that came from elsewhere may lack some."""
    try:
        str(message)
    except (LookupError, ValueError, AttributeError):
        return False
    return True
