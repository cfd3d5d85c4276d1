"""From the document and what was written to the composition."""

import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import product
from pathlib import Path
from typing import Final

from kagezou.document.address import Address, track_of
from kagezou.document.companion_properties import CONTACT_STRENGTH, REFLECTION_OPACITY
from kagezou.document.model import Document, Layer
from kagezou.document.note import Note
from kagezou.document.properties import OF_DOCUMENT, OF_LAYER
from kagezou.export.after_effects import comp as ae
from kagezou.export.after_effects.channels import seconds
from kagezou.export.after_effects.drawings import CelFootage
from kagezou.export.after_effects.drawn_layers import background_layer, cel_layer
from kagezou.export.after_effects.guides import guides_of
from kagezou.export.after_effects.laying import Laying
from kagezou.export.after_effects.renderings import (
    CLAY,
    CONTACTS,
    RECEIVED,
    REFLECTIONS,
    SHADOW_MATTES,
    SHADOWS,
    TOGETHER,
    Rendering,
)
from kagezou.export.after_effects.shadows import ShadowFootage, Shown, shadow_layers, united_comps
from kagezou.export.selection import received_ways
from kagezou.export.subjects import GROUND, SET, SET_UNDER, ReceivedSubject, TogetherSubject
from kagezou.export.uniting import CutGroups

_CLAY_NAMES: Final = {SET: "Set clay", SET_UNDER: "Set clay under background"}

Remap = tuple[tuple[float, int | None], ...]


@dataclass(frozen=True, slots=True)
class RenderedFootage:
    """A sequence that was rendered.

    Parameters
    ----------
    first
        The first file.
    count
        How many files there are.
    pictures
        For one picture a drawing the picture of each frame, from 0.
    """

    first: Path
    count: int
    pictures: tuple[int, ...] | None = None


@dataclass(frozen=True, slots=True)
class Written:
    """What lies in the folder, or is referred to.

    Parameters
    ----------
    folder
        Where the script will lie.
    rendered
        What was rendered, and whose it is (see `Subject`) → its footage.
    cels
        Layer id → the drawings.
    background
        The background's pictures, None where there are none to see.
    united
        Which shadows unite.
    lit
        Whether the lit area is asked for; it is made of the mattes of the shadows alone.
    """

    folder: Path
    rendered: Mapping[tuple[Rendering, str], RenderedFootage]
    cels: Mapping[str, CelFootage]
    background: CelFootage | None
    lit: bool = False
    united: CutGroups = field(default_factory=lambda: CutGroups((), {}))


def hand_off(document: Document, name: str, project: str, written: Written) -> ae.HandOff:
    """Return everything that the script needs to build the composition of a cut."""
    canvas = document.canvas
    rate = canvas.frame_rate
    first, last = document.played
    shown = _shown(document, written)
    laying = Laying.of(document)
    shadows = shadow_layers(document, written.united, shown, laying)
    beside = _beside(document, written, laying)
    main = ae.Comp(
        "main",
        name,
        (*_background(document, written), *shadows, *beside, *_characters(document, written)),
        guides_of(document),
        _markers(document),
    )
    return ae.HandOff(
        project=project,
        name=name,
        width=canvas.width_px,
        height=canvas.height_px,
        frame_rate=float(rate),
        frames=canvas.length_frames,
        duration=float(canvas.length_frames / rate),
        first_frame=canvas.first_frame,
        work_area=(seconds(first, rate), float((last - first + 1) / rate)),
        footage=_footage(document, written),
        comps=(*_lit(document, written), *united_comps(document, written.united.of_several(), shown), main),
    )


def _footage(document: Document, written: Written) -> tuple[ae.Footage, ...]:
    names = {SET: "Set", SET_UNDER: "Set", GROUND: "Ground"} | {layer.id: layer.name for layer in document.layers}
    names |= {piece.id: piece.name for piece in document.pieces}
    names |= {ReceivedSubject(layer.id, is_over=True).owner: f"{layer.name} normal" for layer in document.layers}
    for group, over in product(written.united.together(), (False, True)):
        title = ", ".join(names[each] for each in group.ids)
        names[TogetherSubject(group.ids, is_over=over).owner] = f"{title} united{' normal' if over else ''}"
    made = []
    if written.background is not None:
        first, count = written.background.first, written.background.count
        title = first.stem if count == 1 else "background"
        made.append(_item("background", title, first, written.folder, count=count, into="Background"))
    for layer_id, cels in written.cels.items():
        tag, title = f"cels:{layer_id}", names[layer_id]
        made.append(_item(tag, title, cels.first, written.folder, count=cels.count, into="Characters"))
    for (rendering, owner), footage in written.rendered.items():
        tag, title = f"{rendering.tag}:{owner}", rendering.footage_name.format(names[owner])
        title = _CLAY_NAMES[owner] if rendering == CLAY else title
        into = "Mattes" if rendering.is_matte else "Set" if rendering == CLAY else "Shadows"
        made.append(_item(tag, title, footage.first, written.folder, count=footage.count, into=into))
    return tuple(made)


def _background(document: Document, written: Written) -> tuple[ae.CompLayer, ...]:
    """Return the background and the sets drawn as clay, those under it first."""
    rate = document.canvas.frame_rate
    clay = {
        owner: ae.CompLayer(
            tag=f"{CLAY.tag}:{owner}",
            name=_CLAY_NAMES[owner],
            footage=f"{CLAY.tag}:{owner}",
            blend="NORMAL",
            opacity=ae.Channel(100.0),
            remap=_remap(footage.pictures, rate),
        )
        for (rendering, owner), footage in written.rendered.items()
        if rendering == CLAY
    }
    behind = None if written.background is None else background_layer(document, written.background)
    return tuple(each for each in (clay.get(SET_UNDER), behind, clay.get(SET)) if each is not None)


def _shown(document: Document, written: Written) -> Shown:
    """Return the shadows that were rendered, and what stands at them."""
    rate = document.canvas.frame_rate
    return {
        owner: ShadowFootage(_remap(footage.pictures, rate), _notes(document, owner))
        for (rendering, owner), footage in written.rendered.items()
        if rendering in (SHADOWS, TOGETHER)
    }


def _characters(document: Document, written: Written) -> tuple[ae.CompLayer, ...]:
    made = []
    for layer in document.layers:
        if layer.id in written.cels:
            # Notes about a figure stand at its shadow, and a part of it has none.
            notes = () if layer.joins is None else _notes(document, layer.id)
            made.append(cel_layer(document, layer, written.cels[layer.id], notes))
        made.extend(_received(document, layer, written))
    return tuple(made)


def _received(document: Document, layer: Layer, written: Written) -> Iterator[ae.CompLayer]:
    """Yield what others cast on a character, laid over it as they lay their shadows."""
    for place, multiply in enumerate(received_ways(document, layer)):
        subject = ReceivedSubject(layer.id, multiply, bool(place))
        if (RECEIVED, subject.owner) in written.rendered:
            yield ae.CompLayer(
                tag=f"received:{subject.owner}",
                name=f"{layer.name} received{' normal' if subject.is_over else ''}",
                footage=f"received:{subject.owner}",
                blend="MULTIPLY" if multiply else "NORMAL",
                opacity=ae.Channel(100.0),
                remap=_remap(written.rendered[RECEIVED, subject.owner].pictures, document.canvas.frame_rate),
            )


def _beside(document: Document, written: Written, laying: Laying) -> Iterator[ae.CompLayer]:
    """Yield what figures have beside their shadows: the patches under their feet, and over them their reflections."""
    rate = document.canvas.frame_rate
    for rendering, prop, ways_of in (
        (CONTACTS, CONTACT_STRENGTH, laying.of_contact),
        (REFLECTIONS, REFLECTION_OPACITY, laying.of_reflection),
    ):
        for layer in (each for each in document.layers if (rendering, each.id) in written.rendered):
            plain = ae.CompLayer(
                tag=f"{rendering.tag}:{layer.id}",
                name=rendering.footage_name.format(layer.name),
                footage=f"{rendering.tag}:{layer.id}",
                blend="NORMAL",
                opacity=ae.Channel(100.0),
                remap=_remap(written.rendered[rendering, layer.id].pictures, rate),
            )
            track = track_of(document, Address(prop, layer.id))
            yield from laying.layers(ways_of(layer.id), track, plain, default=rendering == CONTACTS)


def _lit(document: Document, written: Written) -> tuple[ae.Comp, ...]:
    """Return the composition of what no shadow lies on: the shadows, turned black, over white."""
    mattes = {owner: each for (rendering, owner), each in written.rendered.items() if rendering == SHADOW_MATTES}
    if not mattes or not written.lit:
        return ()
    names = {SET: "Set"} | {layer.id: layer.name for layer in document.layers}
    rate = document.canvas.frame_rate
    layers = tuple(
        ae.CompLayer(
            tag=f"lit:{owner}",
            name=names[owner],
            footage=f"{SHADOW_MATTES.tag}:{owner}",
            blend="NORMAL",
            opacity=ae.Channel(100.0),
            remap=_remap(footage.pictures, rate),
            inverted=True,
        )
        for owner, footage in mattes.items()
    )
    return (ae.Comp("lit", "Lit area", layers, white=True),)


def _remap(pictures: tuple[int, ...] | None, rate: Fraction) -> Remap:
    """Return when another picture begins to be held, from the picture of every frame."""
    if pictures is None:
        return ()
    held: list[tuple[float, int | None]] = []
    for frame, picture in enumerate(pictures, start=1):
        if not held or held[-1][1] != picture:
            held.append((seconds(frame, rate), picture))
    return tuple(held)


def _notes(document: Document, layer_id: str) -> tuple[ae.CompMarker, ...]:
    """Return the notes about a layer; several on one frame are one marker, for a second one would replace the first."""
    said: dict[int, list[str]] = {}
    for note in document.notes:
        if note.layer_id == layer_id:
            said.setdefault(note.frame, []).append(_said(note))
    rate = document.canvas.frame_rate
    return tuple(_marker(frame, "\n".join(said[frame]), rate) for frame in sorted(said))


def _markers(document: Document) -> tuple[ae.CompMarker, ...]:
    """Return the markers of the cut, and the notes about the scene among them."""
    said = {marker.frame: [marker.comment] for marker in document.markers}
    durations = {marker.frame: marker.duration_frames for marker in document.markers}
    for note in document.notes:
        if note.layer_id is None:
            said.setdefault(note.frame, []).append(_said(note))
    rate = document.canvas.frame_rate
    return tuple(
        _marker(frame, "\n".join(filter(None, said[frame])), rate, durations.get(frame, 0)) for frame in sorted(said)
    )


def _said(note: Note) -> str:
    prop = (OF_DOCUMENT if note.layer_id is None else OF_LAYER)[note.property]
    tick = "✓ " if note.is_done else ""
    said = f"{tick}{note.author}{': ' if note.author else ''}{prop.label}: {note.text}"
    answers = (f"> {each.author}{': ' if each.author else ''}{each.text}" for each in note.answers)
    return "\n".join((said, *answers))


def _marker(frame: int, comment: str, rate: Fraction, duration_frames: int = 0) -> ae.CompMarker:
    return ae.CompMarker(seconds(frame, rate), comment, float(duration_frames / rate))


def _item(tag: str, title: str, path: Path, folder: Path, *, count: int, into: str) -> ae.Footage:
    """Return footage; what lies outside the script's folder has two paths, as either may be what stays true."""
    alpha = "PREMULTIPLIED" if path.suffix.lower() == ".exr" else "STRAIGHT"
    if path.is_relative_to(folder):
        return ae.Footage(tag, title, path.relative_to(folder).as_posix(), count, alpha, into)
    try:
        way = Path(os.path.relpath(path, folder)).as_posix()
    except ValueError:  # another drive
        way = path.as_posix()
    return ae.Footage(tag, title, way, count, alpha, into, path.as_posix())
