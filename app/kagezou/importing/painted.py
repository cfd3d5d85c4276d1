"""Shadows that are painted into drawings: noticed, and said once a character."""

from typing import Final

from kagezou.document.model import Cels
from kagezou.errors import InputProblem
from kagezou.io.images.casting_mattes import painted_part
from kagezou.io.images.reading import read_cel
from kagezou.message import Message

_LOOKED_AT: Final = 3


def notes_on_painted_shadows(name: str, cels: Cels) -> tuple[Message, ...]:
    """Return what is to be said where the first drawings of a layer hold a shadow; what cannot be read is passed."""
    for drawing in cels.drawings[:_LOOKED_AT]:
        try:
            part = painted_part(read_cel(drawing.source))
        except InputProblem:
            continue
        if part > 0:
            return (
                Message(
                    "{name}: a shadow seems to be painted into its drawings, half-transparent at the base, and casts "
                    "with them; layers.{name}.shadow.painted=left_out leaves it out",
                    name=name,
                ),
            )
    return ()
