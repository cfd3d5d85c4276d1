"""Edits: functions that make a new document of an old one. Nothing else changes a document.

An edit that would change nothing returns the very same document, so that ``new is old`` tells.
"""

from collections.abc import Collection, Mapping
from dataclasses import replace
from itertools import count
from types import MappingProxyType
from typing import TypeVar

from kagezou.animation.ease import EASY, Ease
from kagezou.animation.track import Interpolation, Key, Track, components_of
from kagezou.document.address import Address, track_of
from kagezou.document.alike_names import folded, unlike
from kagezou.document.figures import parts_of
from kagezou.document.layer_marks import NO_MARKS
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure, Layer, Piece, Tracks
from kagezou.errors import UsageProblem
from kagezou.geometry.box import Box
from kagezou.message import Message
from kagezou.picture_source import PicturePart, PictureSource, file_of

Owner = TypeVar("Owner", Document, Layer, Piece)
"""What has tracks."""


def set_track(document: Document, address: Address, track: Track) -> Document:
    """Put a whole track at an address; of a linked property all layers get it."""
    if track == track_of(document, address):
        return document
    name = address.property.name
    if address.piece_id is not None:
        return _with_piece_track(document, address.piece_id, name, track)
    if address.layer_id is None:
        return replace(document, tracks=_with(document.tracks, name, track))
    if name in document.linked:
        layers = (replace(layer, tracks=_with(layer.tracks, name, track)) for layer in document.layers)
        return replace(document, layers=tuple(layers))
    layer = document.layer(address.layer_id)
    return _with_layer(document, replace(layer, tracks=_with(layer.tracks, name, track)))


def set_constant(document: Document, address: Address, raw: object) -> Document:
    """Give a property one value for the whole cut; its keys go."""
    return set_track(document, address, Track(address.property.canonical(raw)))


def unset(document: Document, address: Address) -> Document:
    """Take away a property's track, as if nobody had ever set it; a linked property's from all layers."""
    name = address.property.name
    if address.piece_id is not None:
        pieces = (_without_track(each, name) if each.id == address.piece_id else each for each in document.pieces)
        changed = replace(document, pieces=tuple(pieces))
    elif address.layer_id is None:
        changed = _without_track(document, name)
    else:
        owners = {layer.id for layer in document.layers} if name in document.linked else {address.layer_id}
        layers = (_without_track(each, name) if each.id in owners else each for each in document.layers)
        changed = replace(document, layers=tuple(layers))
    return document if changed == document else changed


def set_key(
    document: Document, address: Address, frame: int, raw: object, interpolation: Interpolation | None = None
) -> Document:
    """Set a key; without an interpolation a new key goes on as the one before it does, else linear (or hold).

    Raises
    ------
    UsageProblem
        If the value is not valid, the frame is before 1, or a switch or choice is asked to move.
    """
    prop = address.property
    if frame < 1:
        raise UsageProblem(
            Message("{line}: a key cannot lie on frame {frame}, frames count from 1", line=prop.name, frame=frame)
        )
    if prop.holds_only and interpolation not in (None, Interpolation.HOLD):
        raise UsageProblem(
            Message(
                "{line}: a switch or choice can only be held, not keyed {interpolation}",
                line=prop.name,
                interpolation=interpolation,
            )
        )
    track = track_of(document, address)
    value = prop.canonical(raw)
    old = track.key_at(frame)
    chosen = Interpolation.HOLD if prop.holds_only else interpolation or _usual(track, frame)
    if old is not None and chosen == old.interpolation:
        key = replace(old, value=value)
    else:
        eases = _easy(len(components_of(value) or ())) if chosen is Interpolation.BEZIER else ()
        key = Key(frame, value, chosen, eases, eases)
    return set_track(document, address, track.with_key(key))


def set_value(document: Document, address: Address, raw: object, frame: int) -> Document:
    """Set what is seen at a frame: a key where the property is keyed, else its constant."""
    if track_of(document, address).is_keyed:
        return set_key(document, address, frame, raw)
    return set_constant(document, address, raw)


def remove_key(document: Document, address: Address, frame: int) -> Document:
    """Take a key away; the last one leaves its value as the constant."""
    return set_track(document, address, track_of(document, address).without_key(frame))


def add_layer(document: Document, name: str, cels: Cels, figure: Box, tracks: Tracks | None = None) -> Document:
    """Put a character layer on top, under a free name near ``name``; the cut grows to its last exposure.

    Linked properties are those of the layers there are.
    """
    others = document.layers[0].tracks if document.layers else {}
    own = {each: track for each, track in (tracks or {}).items() if not (others and each in document.linked)}
    shared = {each: track for each, track in others.items() if each in document.linked}
    layer = Layer(_free_id(document), free_name(document, name), cels, figure, _frozen({**own, **shared}))
    last = max((exposure.frame for exposure in cels.exposures), default=1)
    canvas = replace(document.canvas, length_frames=max(document.canvas.length_frames, last))
    return replace(document, canvas=canvas, layers=(*document.layers, layer))


def remove_layer(document: Document, layer_id: str) -> Document:
    """Take a layer away, and the notes about it; what joined it becomes a figure of its own."""
    layers = tuple(
        replace(layer, joins=None) if layer.joins == layer_id else layer
        for layer in document.layers
        if layer.id != layer_id
    )
    return replace(document, layers=layers, notes=tuple(note for note in document.notes if note.layer_id != layer_id))


def rename_layer(document: Document, layer_id: str, name: str) -> Document:
    """Give a layer another name, which must be free and printable."""
    layer = document.layer(layer_id)
    if name == layer.name:
        return document
    _check_name(name)
    if any(folded(other.name) == folded(name) for other in document.layers if other is not layer):
        raise UsageProblem(Message("there is already a layer named {name!r}", name=name))
    return _with_layer(document, replace(layer, name=name))


def duplicate_layers(document: Document, layer_ids: Collection[str]) -> tuple[Document, tuple[str, ...]]:
    """Put a copy of each layer right above it, a figure's with copies of all its parts; returns the copies' ids too."""
    wanted = [layer for layer in document.layers if layer.id in layer_ids or layer.joins in layer_ids]
    copies: dict[str, str] = {}
    for layer in wanted:
        copies[layer.id] = _free_id(document)
        copy = replace(layer, id=copies[layer.id], name=free_name(document, layer.name), marks=NO_MARKS)
        place = [each.id for each in document.layers].index(layer.id) + 1
        document = replace(document, layers=(*document.layers[:place], copy, *document.layers[place:]))
    made = frozenset(copies.values())
    # A copied part is one of the copied figure.
    layers = (
        replace(each, joins=copies.get(each.joins or "", each.joins)) if each.id in made else each
        for each in document.layers
    )
    return replace(document, layers=tuple(layers)), tuple(copies.values())


def move_layer(document: Document, layer_id: str, index: int) -> Document:
    """Put a layer at a place counted from the bottom."""
    layer = document.layer(layer_id)
    others = [other for other in document.layers if other.id != layer_id]
    others.insert(index, layer)
    moved = tuple(others)
    return document if moved == document.layers else replace(document, layers=moved)


def join_layer(document: Document, layer_id: str, figure_id: str | None) -> Document:
    """Make a layer a part of another one's figure, or with None a figure of its own.

    What joined the layer goes with it; a layer that is itself a part stands for its figure.

    Raises
    ------
    UsageProblem
        A layer cannot join itself.
    """
    if figure_id is not None:
        figure_id = document.layer(figure_id).joins or figure_id
    if figure_id == layer_id:
        name = document.layer(layer_id).name
        raise UsageProblem(Message("{name} cannot be a part of its own figure", name=name))
    if document.layer(layer_id).joins == figure_id:
        return document
    moving = {layer_id} if figure_id is None else {layer_id, *(part.id for part in parts_of(document, layer_id)[1:])}
    layers = (replace(layer, joins=figure_id) if layer.id in moving else layer for layer in document.layers)
    return replace(document, layers=tuple(layers))


def set_exposures(document: Document, layer_id: str, exposures: tuple[Exposure, ...]) -> Document:
    """Give a layer other exposures of its drawings."""
    layer = document.layer(layer_id)
    cels = replace(layer.cels, exposures=exposures)
    return document if cels == layer.cels else _with_layer(document, replace(layer, cels=cels))


def set_drawings(document: Document, layer_id: str, drawings: tuple[Drawing, ...]) -> Document:
    """Give a layer other drawings in the places of those it has."""
    layer = document.layer(layer_id)
    cels = replace(layer.cels, drawings=drawings)
    return document if cels == layer.cels else _with_layer(document, replace(layer, cels=cels))


def set_canvas(document: Document, canvas: Canvas) -> Document:
    """Change size, frame rate or length."""
    return document if canvas == document.canvas else replace(document, canvas=canvas)


def set_background(document: Document, source: PictureSource | None) -> Document:
    """Put one picture under everything for the whole cut, or take away what is there."""
    return set_background_cels(document, Cels() if source is None else still(source))


def set_background_cels(document: Document, cels: Cels) -> Document:
    """Put pictures under everything, each when it is exposed."""
    return document if cels == document.behind else replace(document, behind=cels)


def still(source: PictureSource) -> Cels:
    """Return one picture that is seen for the whole cut."""
    path, part = file_of(source), source.address if isinstance(source, PicturePart) else None
    return Cels((Drawing(path.stem, path, part),), (Exposure(1, 0),))


def free_name(document: Document, name: str) -> str:
    """Return ``name``, or with a number behind it where a layer has it already, in any case of its letters."""
    _check_name(name)
    return unlike(name, (layer.name for layer in document.layers))


def _check_name(name: str) -> None:
    if not name.strip() or not name.isprintable() or len(name) > 200:
        raise UsageProblem(
            Message("a layer cannot be named {name!r}: a name is 1 to 200 printable characters", name=name[:60])
        )


def _free_id(document: Document) -> str:
    taken = {layer.id for layer in document.layers}
    return next(each for each in (f"layer-{n}" for n in count(1)) if each not in taken)


def _with_layer(document: Document, changed: Layer) -> Document:
    layers = tuple(changed if layer.id == changed.id else layer for layer in document.layers)
    return replace(document, layers=layers)


def _with_piece_track(document: Document, piece_id: str, name: str, track: Track) -> Document:
    piece = document.piece(piece_id)
    changed = replace(piece, tracks=_with(piece.tracks, name, track))
    return replace(document, pieces=tuple(changed if each.id == piece_id else each for each in document.pieces))


def _without_track(owner: Owner, name: str) -> Owner:
    return replace(owner, tracks=_frozen({each: track for each, track in owner.tracks.items() if each != name}))


def _with(tracks: Tracks, name: str, track: Track) -> Tracks:
    return _frozen({**tracks, name: track})


def _frozen(tracks: Mapping[str, Track]) -> Tracks:
    return MappingProxyType(dict(tracks))


def _usual(track: Track, frame: int) -> Interpolation:
    """Return how a new key at ``frame`` goes on: as its neighbour before it, or after it, else linear."""
    before = [key for key in track.keys if key.frame <= frame]
    near = before[-1] if before else next(iter(track.keys), None)
    return near.interpolation if near else Interpolation.LINEAR


def _easy(components: int) -> tuple[Ease, ...]:
    return (EASY,) * components
