"""The words of notes: where they are pinned, and what is said."""

from kagezou.document.address import Address
from kagezou.document.frame_numbers import number_of
from kagezou.document.model import Document
from kagezou.document.note import Note
from kagezou.document.properties import OF_DOCUMENT, OF_LAYER
from kagezou.ui.system.words import translated


def note_heading(note: Note, document: Document) -> str:
    """Return where a note is pinned, and who wrote it."""
    prop = (OF_DOCUMENT if note.layer_id is None else OF_LAYER)[note.property]
    author = f" — {note.author}" if note.author else ""
    return f"{number_of(document.canvas, note.frame)}   {owner_words(document, Address(prop, note.layer_id))}{author}"


def note_words(note: Note) -> str:
    """Return what is said in a note, with the answers below."""
    answers = (f"↳ {each.author}{': ' if each.author else ''}{each.text}" for each in note.answers)
    return "\n".join((note.text, *answers))


def owner_words(document: Document, address: Address) -> str:
    """Return a property with the layer or the set piece it is of."""
    label = translated(address.property.label)
    if address.piece_id is not None:
        return f"{document.piece(address.piece_id).name} · {label}"
    return label if address.layer_id is None else f"{document.layer(address.layer_id).name} · {label}"
