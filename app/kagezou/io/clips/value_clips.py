"""Values of properties as text, as they go through the clipboard from window to window.

One value is the JSON that ``kagezou set PATH=JSON`` takes; several are an object of values by property name.
"""

import json
from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

from kagezou.animation.track import Value
from kagezou.document.property import AnyProperty
from kagezou.errors import ProjectProblem, UsageProblem
from kagezou.io.files.json_text import Reader, parse

_KIND: Final = "kagezou-values"
_MAX_CHARACTERS: Final = 1 << 20


def dumps_value(value: Value) -> str:
    """Return one value as text."""
    return json.dumps(value, ensure_ascii=False)


def dumps_values(values: Mapping[str, Value]) -> str:
    """Return values by property name as text."""
    return json.dumps({_KIND: dict(values)}, ensure_ascii=False, indent=2) + "\n"


def loads_value(text: str, prop: AnyProperty) -> Value | None:
    """Return the value for a property that a text holds, alone or among others; None if there is none."""
    try:
        raw = parse(text) if len(text) <= _MAX_CHARACTERS else None
        if isinstance(raw, dict):
            return loads_values(text, {prop.name: prop}).get(prop.name)
        return prop.canonical(raw)
    except (ProjectProblem, UsageProblem):
        return None


def loads_values(text: str, props: Mapping[str, AnyProperty]) -> Mapping[str, Value]:
    """Return those values of a text that are of these properties and valid; none if it is no such text."""
    if len(text) > _MAX_CHARACTERS:
        return MappingProxyType({})
    found: dict[str, Value] = {}
    try:
        members = Reader(parse(text)).record([_KIND])[_KIND].members()
        for name, each in members.items():
            if name in props:
                found[name] = props[name].canonical(each.value)
    except (ProjectProblem, UsageProblem):
        return MappingProxyType({})
    return MappingProxyType(found)
