"""Changing a document by the words people write for it: one vocabulary of paths and values for every door."""

from collections.abc import Iterable
from dataclasses import dataclass

from kagezou.animation.ease import EASY
from kagezou.animation.track import Interpolation
from kagezou.document.address import Address, path_of, resolve, track_of
from kagezou.document.cut_settings import ChangedCut, CutSettings, with_settings
from kagezou.document.cut_words import CutWord
from kagezou.document.ease_edits import set_ease
from kagezou.document.edits import set_constant, set_key
from kagezou.document.key_edits import KeyRef
from kagezou.document.model import Document
from kagezou.document.piece_kinds import kind_of, matters
from kagezou.document.refitting import Refit
from kagezou.document.whole_cut import saying_at
from kagezou.errors import UsageProblem
from kagezou.message import Message


@dataclass(frozen=True, slots=True)
class AsKey:
    """That a value is a key and does not hold for the whole cut.

    Parameters
    ----------
    frame
        Counted from 1.
    interpolation
        How the value goes on from it; None for as its neighbours do.
    is_eased
        Whether the way to it from the key before is eased at both of its ends.
    """

    frame: int
    interpolation: Interpolation | None = None
    is_eased: bool = False


def knows(document: Document, path: str) -> bool:
    """Return whether a path names something of the scene, a layer or a set piece."""
    if saying_at(document, path) is not None:
        return True
    try:
        resolve(document, path)
    except UsageProblem:
        return False
    return True


def put(document: Document, path: str, raw: object, key: AsKey | None = None) -> Document:
    """Return the document with a value at a path; without a key for the whole cut, and the property's keys go.

    Parameters
    ----------
    path
        Such as ``light.position`` or ``layers.Hero.shadow.opacity``.
    raw
        A JSON value, or one of the property.

    Raises
    ------
    UsageProblem
        There is no such path, the value cannot be its, it means nothing for the kind of set piece, or there can be no
        such key.
    """
    said = saying_at(document, path)
    if said is not None:
        return said.changed(raw, None if key is None else key.frame)
    address = resolve(document, path)
    if key is None:
        _check_meaning(document, address, path, 1)
        return set_constant(document, address, raw)
    _check_meaning(document, address, path, key.frame)
    document = set_key(document, address, key.frame, raw, key.interpolation)
    return _eased(document, address, key.frame) if key.is_eased else document


def with_cut_words(document: Document, words: Iterable[tuple[CutWord, object]], refit: Refit) -> ChangedCut:
    """Return the document with other settings of the cut, and what comes of them.

    Raises
    ------
    UsageProblem
        A setting cannot be that.
    """
    settings = CutSettings.of(document)
    for word, said in words:
        settings = word.said(settings, said)
    return with_settings(document, settings, refit)


def _check_meaning(document: Document, address: Address, path: str, frame: int) -> None:
    """Refuse a property that does nothing for the kind of set piece."""
    if address.piece_id is None:
        return
    kind = kind_of(document.piece(address.piece_id), frame)
    if not matters(address.property, kind):
        raise UsageProblem(Message("{path}: it means nothing for the kind {kind}", path=path, kind=kind.value))


def _eased(document: Document, address: Address, frame: int) -> Document:
    """Return the document with an ease from the key before to the one that was just set."""
    path = path_of(document, address)
    before = [key.frame for key in track_of(document, address).keys if key.frame < frame]
    if not before:
        raise UsageProblem(Message("{path}: there is no key before frame {frame} to ease from", path=path, frame=frame))
    if address.property.holds_only:
        raise UsageProblem(Message("{path}: its values are held, and none lies between two of them", path=path))
    document = set_ease(document, frozenset({KeyRef(address, before[-1])}), None, (EASY,))
    return set_ease(document, frozenset({KeyRef(address, frame)}), (EASY,), None)
