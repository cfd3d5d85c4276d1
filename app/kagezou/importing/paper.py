"""Which white is clear in drawings without alpha, chosen by what the first of them show."""

from typing import Final

from kagezou.document.model import Cels
from kagezou.document.paper import on_paper
from kagezou.errors import InputProblem
from kagezou.io.images.enclosed import enclosed_part
from kagezou.io.images.reading import has_alpha
from kagezou.message import Message
from kagezou.picture_source import Paper

_LOOKED_AT: Final = 3
_SIZEABLE: Final = 0.04
"""Of the figure. Gaps between limbs were up to 0.012 of it and eyes 0.004, a white shirt from 0.067."""


def on_found_paper(name: str, cels: Cels) -> tuple[Cels, list[Message]]:
    """Return the cels of a layer on the paper that fits its first drawings, and what is to be said about it.

    Drawings that cannot be opened are passed over.
    """
    enclosed: list[float] = []
    for drawing in cels.drawings:
        try:
            if not enclosed and has_alpha(drawing.source):
                return cels, []
            enclosed.append(enclosed_part(drawing.source))
        except InputProblem:
            continue
        if len(enclosed) == _LOOKED_AT:
            break
    if not enclosed or sum(enclosed) / len(enclosed) < _SIZEABLE:
        note = Message("{name}: its drawings have no alpha; pure white is taken as clear", name=name)
        return cels, [note] if enclosed else []
    return on_paper(cels, Paper.BORDER), [
        Message(
            "{name}: its drawings have no alpha; white inside their outlines stays, also between arm and body, "
            "and white that reaches the border is taken as clear (layers.{name}.paper)",
            name=name,
        )
    ]
