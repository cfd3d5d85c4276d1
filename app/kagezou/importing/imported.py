"""What every way of bringing something in returns."""

from dataclasses import dataclass

from kagezou.document.model import Document
from kagezou.message import Message


@dataclass(frozen=True, slots=True)
class Imported:
    """A document with something brought in.

    Parameters
    ----------
    document
        The document.
    notes
        What the user should know, one sentence each.
    layer_ids
        The layers that came, or that a timesheet changed, from bottom to top.
    """

    document: Document
    notes: tuple[Message, ...]
    layer_ids: tuple[str, ...]
