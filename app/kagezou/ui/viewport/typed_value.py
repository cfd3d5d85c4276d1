"""Numbers typed while a handle is held: the values are set exactly instead of by the way the hand goes."""

from kagezou.document.address import value_of
from kagezou.document.edits import set_value
from kagezou.document.model import Document
from kagezou.document.typed_number import evaluate
from kagezou.errors import UsageProblem
from kagezou.tools.handle import Handle

LETTERS = frozenset("0123456789.+-*/%=,")
"""What may be typed; a comma parts the numbers, in the order in which they stand beside the pointer."""


def with_typed(handle: Handle, document: Document, frame: int, text: str) -> Document | None:
    """Return the document with a handle's values as typed, or None while the text is none.

    ``45`` is a value, ``+10`` and ``*2`` change the one that is there, ``412,203`` sets two and ``,203`` only the
    second.
    """
    parts = text.split(",")
    try:
        for address in handle.addresses:
            value = value_of(document, address, frame)
            typed, parts = _typed(value, parts, handle.index)
            if typed != value:
                document = set_value(document, address, typed, frame)
        if not text or parts:
            return None
    except UsageProblem:
        # Half a number is no mistake yet.
        return None
    return document


def _typed(value: object, parts: list[str], index: int | None) -> tuple[object, list[str]]:
    """Return a value with its numbers taken from the first of the parts, and the parts that are left."""
    if isinstance(value, float):
        return (evaluate(parts[0], value) if parts and parts[0].strip() else value), parts[1:]
    if isinstance(value, tuple) and index is not None:
        point, rest = _typed(value[index], parts, None)
        return (*value[:index], point, *value[index + 1 :]), rest
    if isinstance(value, tuple):
        numbers = []
        for number in value:
            made, parts = _typed(number, parts, None)
            numbers.append(made)
        return tuple(numbers), parts
    return value, parts
