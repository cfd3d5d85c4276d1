"""What a document has at the paths people write: a value as it is shown, and its keys."""

from dataclasses import dataclass

from kagezou.animation.track import Key, Value
from kagezou.document.address import Address, resolve, track_of
from kagezou.document.cut_settings import CutSettings
from kagezou.document.cut_words import cut_word_at
from kagezou.document.model import Document
from kagezou.document.properties import TILT
from kagezou.document.whole_cut import saying_at
from kagezou.scene.evaluate import camera_at, ground_at
from kagezou.scene.figure_card import card_at


@dataclass(frozen=True, slots=True)
class SpokenValue:
    """What is found at a path.

    Parameters
    ----------
    value
        On the frame that was asked for, else the constant; None where it has keys and no frame was asked for.
    unit
        Of the value; empty for none.
    keys
        In the order of their frames.
    is_measured
        Whether the drawings tell it: the tilt of a layer with two grounding points.
    """

    value: Value | None
    unit: str = ""
    keys: tuple[Key, ...] = ()
    is_measured: bool = False


def spoken_value(document: Document, path: str, frame: int | None = None) -> SpokenValue:
    """Return what a document has at a path such as ``light.position``, ``layers.Hero.joins`` or ``canvas.size``.

    Raises
    ------
    UsageProblem
        There is no such path, with the nearest one there is.
    """
    word = cut_word_at(path)
    if word is not None:
        return SpokenValue(word.value(CutSettings.of(document)))
    said = saying_at(document, path)
    if said is not None:
        return SpokenValue(said.value)
    address = resolve(document, path)
    track, unit = track_of(document, address), address.property.unit
    measured = _measured_tilt(document, address, frame or 1)
    if measured is not None:
        return SpokenValue(measured, unit, track.keys, is_measured=True)
    if frame is not None:
        return SpokenValue(track.value_at(frame), unit, track.keys)
    return SpokenValue(None if track.is_keyed else track.constant, unit, track.keys)


def _measured_tilt(document: Document, address: Address, frame: int) -> float | None:
    """Return the angle that is shown where grounding points tell a body's tilt; None for all else."""
    if address.property is not TILT or address.layer_id is None:
        return None
    layer = document.layer(address.layer_id)
    card = card_at(document, layer, frame, camera_at(document, frame), ground_at(document, frame))
    return card.tilt_deg if card.is_tilt_measured else None
