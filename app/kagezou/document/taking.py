"""Taking light, ground, looks or the set of one cut into another: cuts of an episode are often lit alike.

What is taken is the source's on a canvas of the target's size, with its keys. Looks go from figure to figure by name,
in the measure of their heights; a figure that the source does not know gets the look of its first.
"""

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum

from kagezou.document.address import Address, track_of
from kagezou.document.alike_names import folded
from kagezou.document.edits import set_track
from kagezou.document.figure_properties import BACKGROUND_POSITION, SHADOWS_UNITE
from kagezou.document.model import Document, Layer
from kagezou.document.properties import OF_DOCUMENT
from kagezou.document.property import AnyProperty
from kagezou.document.refitting import Refit, refitted
from kagezou.document.style import LINES, style_of
from kagezou.document.styling import put_style
from kagezou.message import Message, first_names


class Part(StrEnum):
    """What can be taken."""

    LIGHT = "light"
    LOOK = "look"
    GROUND = "ground"
    SET = "set"


@dataclass(frozen=True, slots=True)
class Taken:
    """The target with what was taken, and what is to be said of it."""

    document: Document
    notes: tuple[Message, ...]


def taken(
    target: Document,
    source: Document,
    parts: Collection[Part],
    frame: int = 1,
    figure_ids: Collection[str] | None = None,
) -> Taken:
    """Return a cut with parts of another one.

    Parameters
    ----------
    target, source
        The cuts; drawings, exposures and feet of the target stay.
    parts
        What is taken.
    frame
        Of the source: looks are those of this frame, as a look has no keys.
    figure_ids
        The layers of the target's figures that get a look; None for all.
    """
    notes: list[Message] = []
    canvas = target.canvas
    fitting = refitted(source, canvas.width_px, canvas.height_px, Refit.SCALE).document
    document = target
    for prop in OF_DOCUMENT.values():
        if _part_of(prop) in parts:
            document = set_track(document, Address(prop), track_of(fitting, Address(prop)))
    if Part.SET in parts:
        document = replace(document, pieces=fitting.pieces)
    if Part.LOOK in parts:
        layers = [each for each in figures_of(document) if figure_ids is None or each.id in figure_ids]
        document, said = _with_looks(document, fitting, frame, layers)
        notes += said
    notes += _late_keys(document, source, parts)
    return Taken(document, tuple(notes))


def _part_of(prop: AnyProperty) -> Part | None:
    """Return with what a property of the scene is taken; None for what belongs to the cut itself."""
    if prop is BACKGROUND_POSITION:
        return None
    if prop.name.startswith("light.") or prop is SHADOWS_UNITE:
        return Part.LIGHT
    return Part.SET if prop.name.startswith("set.") else Part.GROUND


def figures_of(document: Document) -> tuple[Layer, ...]:
    """Return the layers whose looks go from cut to cut: those of whole figures."""
    return tuple(layer for layer in document.layers if layer.joins is None)


def model_of(layer: Layer, source: Document) -> Layer | None:
    """Return the figure of a source whose look a figure gets: that of its name, else the first; None without any."""
    figures = figures_of(source)
    named = (each for each in figures if folded(each.name) == folded(layer.name))
    return next(named, figures[0] if figures else None)


def _with_looks(
    document: Document, source: Document, frame: int, layers: Sequence[Layer]
) -> tuple[Document, list[Message]]:
    figures = figures_of(source)
    if not figures:
        return document, [Message("there is no character in it whose look could be taken")]
    notes: list[Message] = []
    unknown: list[str] = []
    for layer in layers:
        like = model_of(layer, source) or figures[0]
        if folded(like.name) != folded(layer.name):
            unknown.append(layer.name)
        document = put_style(document, [layer.id], style_of(source, like.id, frame, "look"), 1).document
    if unknown and len(figures) > 1:
        names = first_names(unknown)
        notes.append(Message("{names}: not there, so they look as {first} does", names=names, first=figures[0].name))
    keyed = [layer.name for layer in figures if any(_is_keyed(layer, prop) for prop in LINES)]
    if keyed:
        names = first_names(keyed)
        notes.append(Message("{names}: the look of frame {frame} was taken, without keys", names=names, frame=frame))
    return document, notes


def _is_keyed(layer: Layer, prop: AnyProperty) -> bool:
    track = layer.tracks.get(prop.name)
    return track is not None and track.is_keyed


def _late_keys(document: Document, source: Document, parts: Collection[Part]) -> Iterator[Message]:
    """Say that keys were taken that lie behind the end of a shorter cut."""
    last = document.canvas.length_frames
    if source.canvas.length_frames <= last:
        return
    props = [prop for prop in OF_DOCUMENT.values() if _part_of(prop) in parts]
    late = [prop.name for prop in props if any(key.frame > last for key in track_of(document, Address(prop)).keys)]
    if late:
        yield Message("keys behind the end of the cut: {names}", names=first_names(late))
