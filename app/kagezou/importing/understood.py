"""What was understood of the files that a document was made of: for each character how many drawings, and which."""

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Final

from kagezou.animation.frames import format_frames
from kagezou.document.model import Document, Drawing
from kagezou.io.files.faults import shown
from kagezou.message import Message

_NUMBER: Final = re.compile(r"(-?[0-9]{1,18})(?:[a-z]{0,2}|\.[1-9])", re.IGNORECASE)
_MOST_CHARACTERS: Final = 40


def understood(document: Document) -> tuple[Message, ...]:
    """Return one line a layer, from the lowest up: how many drawings, their numbers, the first and the last."""
    return tuple(drawings_line(layer.name, layer.cels.drawings) for layer in document.layers if layer.cels.drawings)


def drawings_line(name: str, drawings: Sequence[Drawing]) -> Message:
    """Return what drawings of a character were found, at least one."""
    first, last = _called(drawings[0]), _called(drawings[-1])
    count = len(drawings)
    if count == 1:
        return Message("{name}: one drawing, {first}", name=name, first=first)
    numbers = numbers_text([drawing.name for drawing in drawings])
    if not numbers:
        return Message("{name}: {count} drawings, {first} … {last}", name=name, count=count, first=first, last=last)
    return Message(
        "{name}: {count} drawings, {numbers}, {first} … {last}",
        name=name,
        count=count,
        numbers=numbers,
        first=first,
        last=last,
    )


def numbers_text(names: Sequence[str]) -> str:
    """Return the numbers of drawings by their names, short; nothing where one has none."""
    found = [_NUMBER.fullmatch(name) for name in names]
    numbers = [int(each[1]) for each in found if each]
    if len(numbers) < len(names) or not numbers:
        return ""
    text = format_frames(numbers) if min(numbers) >= 0 else ""
    return text if text and len(text) <= _MOST_CHARACTERS else f"{min(numbers)} … {max(numbers)}"


def _called(drawing: Drawing) -> str:
    name = shown(Path(drawing.path.name))
    return f"{name}: {drawing.part}" if drawing.part else name
