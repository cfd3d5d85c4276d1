"""What is gone through in a review: notes and flags in the order of their frames, and their words."""

from dataclasses import dataclass

from PySide6.QtCore import QCoreApplication

from kagezou.document.model import Document
from kagezou.document.note import Note
from kagezou.ui.curves.flags import Flag, FlagKind
from kagezou.ui.system.note_words import note_heading, note_words, owner_words
from kagezou.ui.system.shown_units import shown_unit


@dataclass(frozen=True, slots=True)
class Remark:
    """A note or a flag; just one of the two is there."""

    frame: int
    note: Note | None = None
    flag: Flag | None = None


def remarks_of(document: Document, flags: tuple[Flag, ...]) -> tuple[Remark, ...]:
    """Return the notes of a document and flags of it, in the order of frames, on one frame the notes first."""
    notes = [Remark(note.frame, note=note) for note in document.notes]
    return tuple(sorted([*notes, *(Remark(flag.frame, flag=flag) for flag in flags)], key=lambda each: each.frame))


def remark_words(remark: Remark, document: Document) -> str:
    """Return a remark in one line or several."""
    if remark.note is not None:
        return f"{note_heading(remark.note, document)}: {note_words(remark.note)}"
    assert remark.flag is not None
    return f"{remark.frame}   {owner_words(document, remark.flag.address)}   {flag_words(remark.flag)}"


def flag_words(flag: Flag) -> str:
    """Return what stands out."""
    translate = QCoreApplication.translate
    if flag.kind is FlagKind.OFF_EXPOSURES:
        if flag.others:
            words = translate("Flags", "and %1 more: keys between two drawings")
            return words.replace("%1", str(flag.others))
        return translate("Flags", "key between two drawings")
    shown = shown_unit(flag.address.property)
    size = flag.amount * shown.factor
    amount = (f"{size:.3g}" if size < 1 else f"{size:.0f}") + shown.behind()
    if flag.kind is FlagKind.JUMP:
        return translate("Flags", "jumps by %1").replace("%1", amount)
    words = translate("Flags", "moves by up to %1 a frame, to frame %2")
    return words.replace("%1", amount).replace("%2", str(flag.last))
