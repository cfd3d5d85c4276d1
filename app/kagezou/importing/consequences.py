"""What follows from a change: the sun where a first lamp would no longer do, and what is said of it."""

from kagezou.document.figure_properties import PLACEMENT_LINES
from kagezou.document.model import Document
from kagezou.importing.lighting import relit, turning_note
from kagezou.message import Message
from kagezou.scene.heavy_sets import heavy_notes
from kagezou.scene.misfits import misfits_of, new_misfits


def settled(before: Document, placed: Document, after: Document) -> tuple[Document, tuple[Message, ...]]:
    """Return a changed document with what follows from the change, and what is to be said.

    Parameters
    ----------
    before
        As it was.
    placed
        The same on the canvas that ``after`` has, with the same layers.
    after
        As it was changed.
    """
    notes: list[Message] = []
    if _are_moved(placed, after):
        after, said = relit(after)
        turning = turning_note(placed, after)
        notes += said if turning is None else (*said, turning)
    notes += heavy_notes(before, after)
    notes += (misfit.message for misfit in new_misfits(misfits_of(before), misfits_of(after)))
    return after, tuple(notes)


def _are_moved(before: Document, after: Document) -> bool:
    """Whether layers move their drawings otherwise than before."""
    pairs = zip(before.layers, after.layers, strict=True)
    return any(old.tracks.get(prop.name) != new.tracks.get(prop.name) for old, new in pairs for prop in PLACEMENT_LINES)
