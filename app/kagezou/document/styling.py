"""Putting a style on characters: its look wholly, its light only where it is asked for, and what there is to say of it.

Two styles put on one after the other give the same as the second alone. A light that the first one brought goes with it
where it is still exactly as it was brought; one that somebody has changed since is the cut's own and stays.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from types import MappingProxyType
from typing import Final

from kagezou.animation.track import Value
from kagezou.document.address import Address, track_of, usual_value, value_of
from kagezou.document.changes import Change, changes_between, keys_set_between
from kagezou.document.edits import set_constant, set_key, unset
from kagezou.document.figures import height_of
from kagezou.document.model import BroughtLight, Document
from kagezou.document.properties import OF_DOCUMENT
from kagezou.document.property import AnyProperty, Kind
from kagezou.document.style import LINES, Style
from kagezou.message import Message

_POWERS: Final = MappingProxyType({"px": 1, "px²": 2})
"""Units of what grows with a character, and how often."""


class LeftOut(StrEnum):
    """Why a style's own light was left out."""

    NOTHING = "nothing was"
    NOT_ASKED = "it was not asked for"
    NOT_EVERYBODY = "light is everybody's, and the style is for some"


@dataclass(frozen=True, slots=True)
class Styled:
    """A document in a style, and what came of it.

    Parameters
    ----------
    document
        The very same one where nothing changed.
    style
        What was put on.
    frame
        Where keyed properties got their key.
    changes
        The properties that are seen otherwise than before at that frame.
    keyed
        The keyed properties that got a key there.
    limited
        The lengths that would have been beyond their range for characters of this height.
    left_out
        Whether and why the style's own light was left out.
    is_led_back
        Whether a light that another style had brought was taken back.
    """

    document: Document
    style: Style
    frame: int
    changes: tuple[Change, ...]
    keyed: tuple[Address, ...]
    limited: tuple[Address, ...]
    left_out: LeftOut
    is_led_back: bool


def put_style(
    document: Document, layer_ids: Iterable[str], style: Style, frame: int, *, with_light: bool = False
) -> Styled:
    """Put a style on figures: keyed properties get a key on ``frame``, the others a new constant.

    Parameters
    ----------
    document
        The cut.
    layer_ids
        Layers; one that is a part of a figure stands for its figure.
    style
        The look. What it does not name goes to its default.
    frame
        Counted from 1.
    with_light
        Whether the style's own light, ground and set-up are asked for. They come only with a style that is put on
        every figure of the cut.

    Raises
    ------
    UsageProblem
        If a keyed property would get a key before frame 1.
    """
    figures = tuple(dict.fromkeys(document.layer(each).joins or each for each in layer_ids))
    is_for_all = everybody(document) <= set(figures)
    dressed, limited = _dressed(document, figures, style, frame)
    dark = without_brought_light(dressed) if is_for_all else dressed
    lit = _lit(dark, style, frame) if is_for_all and with_light and style.scene else dark
    left_out = LeftOut.NOTHING
    if lit is dark and any(value_of(dark, _of_scene(name), frame) != value for name, value in style.scene.items()):
        left_out = LeftOut.NOT_EVERYBODY if with_light else LeftOut.NOT_ASKED
    is_led_back = lit is dark and dark.tracks != dressed.tracks
    changes, keyed = changes_between(document, lit, frame), keys_set_between(document, lit, frame)
    return Styled(lit, style, frame, changes, keyed, limited, left_out, is_led_back)


def everybody(document: Document) -> frozenset[str]:
    """Return the ids of all figures."""
    return frozenset(layer.id for layer in document.layers if layer.joins is None)


def without_brought_light(document: Document) -> Document:
    """Take a style's light back, wholly, if it is still exactly as it was brought; else it is the cut's own now."""
    brought = document.brought_light
    if brought is None:
        return document
    kept = replace(document, brought_light=None)
    if any(track_of(document, _of_scene(name)) != track for name, track in brought.tracks.items()):
        return kept
    others = {name: track for name, track in document.tracks.items() if name not in brought.tracks}
    return replace(kept, tracks=MappingProxyType({**others, **brought.before}))


def notes_on(styled: Styled, name: str, asking: str, called: Callable[[Address], str]) -> tuple[Message, ...]:
    """Return what a person should know of a style that was put on, besides what changed.

    Parameters
    ----------
    styled
        What came of it.
    name
        What the style is called.
    asking
        How its light is asked for.
    called
        What a property is called.
    """
    notes: list[Message] = []
    if styled.keyed:
        notes.append(_keyed_note(styled.frame, _names(styled.keyed, called)))
    if styled.limited:
        names = ", ".join(_names(styled.limited, called))
        notes.append(
            Message("{names} went to the end of the range: the character is very small or very tall", names=names)
        )
    what = Message("light") if styled.style.has_only_light else Message("light and ground")
    if styled.left_out is LeftOut.NOT_ASKED:
        notes.append(
            Message(
                "{style} came without its own {what}: {asking} brings that too", style=name, what=what, asking=asking
            )
        )
    elif styled.left_out is LeftOut.NOT_EVERYBODY:
        notes.append(
            Message(
                "{style} came without its own {what}: light is for all characters, and only some are meant",
                style=name,
                what=what,
            )
        )
    if styled.is_led_back:
        notes.append(Message("the light that another style had brought was taken back"))
    return tuple(notes)


def _names(found: Sequence[Address], called: Callable[[Address], str]) -> list[str]:
    return list(dict.fromkeys(called(each) for each in found))


def _keyed_note(frame: int, names: Sequence[str]) -> Message:
    if len(names) == 1:
        return Message("1 keyed property got a key on frame {frame}: {names}", frame=frame, names=names[0])
    return Message(
        "{count} keyed properties got a key on frame {frame}: {names}",
        count=len(names),
        frame=frame,
        names=", ".join(names),
    )


def _dressed(
    document: Document, figures: Sequence[str], style: Style, frame: int
) -> tuple[Document, tuple[Address, ...]]:
    """Return the document with the look alone, and the lengths that were kept to their range."""
    limited: list[Address] = []
    for figure_id in figures:
        scale = height_of(document.layer(figure_id), frame) / style.figure_px
        for prop in LINES:
            address = Address(prop, figure_id)
            value = _scaled(prop, style.values[prop.name], scale) if prop.name in style.values else prop.default
            within = min(max(value, prop.low), prop.high) if isinstance(value, float) else value
            limited += [address] if within != value else []
            document = _put(document, address, within, frame)
    return document, tuple(limited)


def _put(document: Document, address: Address, value: Value, frame: int) -> Document:
    """Set a key where the property is keyed; else its constant, of which nothing is kept where it is the usual one."""
    if track_of(document, address).is_keyed:
        return set_key(document, address, frame, value)
    if value == usual_value(document, address):
        return unset(document, address)
    return set_constant(document, address, value)


def _lit(document: Document, style: Style, frame: int) -> Document:
    """Return the document with the style's own light, and what it was before."""
    lit = document
    for name, value in style.scene.items():
        lit = _put(lit, _of_scene(name), value, frame)
    before = {name: document.tracks[name] for name in style.scene if name in document.tracks}
    tracks = {name: track_of(lit, _of_scene(name)) for name in style.scene}
    return replace(lit, brought_light=BroughtLight(MappingProxyType(tracks), MappingProxyType(before)))


def _of_scene(name: str) -> Address:
    return Address(OF_DOCUMENT[name])


def _scaled(prop: AnyProperty, value: Value, scale: float) -> Value:
    if prop.kind is not Kind.NUMBER or prop.unit not in _POWERS or not isinstance(value, float):
        return value
    return value * scale ** _POWERS[prop.unit]
