"""Values in digital timesheets, as far as writers bend them: numbers as texts, texts as numbers, symbols."""

from typing import Final

from kagezou.io.files.json_text import Reader
from kagezou.message import Message

MAX_FRAMES: Final = 1_000_000
MAX_COLUMNS: Final = 1000

NO_NUMBERS: Final = {"cut": "1", "scene": "1"}
"""What stands in the head of a sheet whose writer knows neither cut nor scene, as OpenToonz writes it."""

SYMBOL: Final = "SYMBOL_"
"""A value that begins so is none: the empty cel, or a mark on a cel that goes on."""


def member(reader: Reader, name: str) -> Reader:
    """Return what a key holds; a ProjectProblem without it."""
    found = reader.members().get(name)
    if found is None:
        raise reader.problem(Message("the key {name!r} is missing", name=name))
    return found


def whole(reader: Reader, low: int, high: int) -> int:
    """Return a whole number, which some writers write as a text or with a decimal point."""
    value = reader.value
    is_text = isinstance(value, str) and value.strip().isdecimal() and len(value) <= len(str(high))
    if is_text or (isinstance(value, float) and value.is_integer() and low <= value <= high):
        reader = Reader(int(str(value).removesuffix(".0")), reader.place)
    return reader.whole(low, high)


def text_of_value(reader: Reader | None) -> str:
    """Return a text trimmed; some writers put numbers where texts belong."""
    if reader is None or isinstance(reader.value, (bool, dict, list, float)) or reader.value is None:
        return ""
    return str(reader.value).strip()


def texts_of(row: Reader) -> list[str]:
    """Return all values of a row."""
    data = row.members().get("data")
    texts: list[str] = []
    for item in data.items(MAX_COLUMNS) if data is not None else ():
        values = item.members().get("values")
        texts += [text_of_value(value) for value in values.items(MAX_COLUMNS)] if values is not None else []
    return texts
