"""What the first drawings of a character show that is said once: a painted shadow, light without cover."""

from pathlib import Path
from typing import Final

from kagezou.document.model import Cels
from kagezou.errors import InputProblem
from kagezou.importing.file_notes import said_once
from kagezou.io.images.casting_mattes import painted_part
from kagezou.io.images.reading import FOURTH_IS_ZERO, GLOW_IS_NOT_USED, read_cel
from kagezou.message import Message

_LOOKED_AT: Final = 3
_SAID: Final = frozenset({FOURTH_IS_ZERO, GLOW_IS_NOT_USED})


def notes_on_first_drawings(name: str, cels: Cels) -> tuple[Message, ...]:
    """Return what is to be said of the pixels of a layer's first drawings; what cannot be read is passed."""
    found: list[tuple[Path, tuple[Message, ...]]] = []
    for drawing in cels.drawings[:_LOOKED_AT]:
        try:
            cel = read_cel(drawing.source)
        except InputProblem:
            continue
        found.append((drawing.path, tuple(note for note in cel.notes if note in _SAID)))
        if painted_part(cel) > 0:
            return (
                *said_once(name, found),
                Message(
                    "{name}: a shadow seems to be painted into its drawings, half-transparent at the base, and casts "
                    "with them; layers.{name}.shadow.painted=left_out leaves it out",
                    name=name,
                ),
            )
    return said_once(name, found)
