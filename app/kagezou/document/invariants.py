"""What is true of every document; checked after each edit in tests and after each load."""

from itertools import pairwise

from kagezou.animation.track import Interpolation
from kagezou.document.address import Address, addresses, path_of, track_of
from kagezou.document.linking import LINKABLE
from kagezou.document.model import Canvas, Document
from kagezou.document.properties import OF_DOCUMENT, OF_LAYER
from kagezou.document.slate import MAX_FIRST_FRAME
from kagezou.errors import ProjectProblem, UsageProblem
from kagezou.message import Message


def check(document: Document) -> None:
    """Raise ProjectProblem, naming the place, if the document is not sound."""
    check_structure(document)
    _check_tracks(document)


def check_structure(document: Document) -> None:
    """Raise ProjectProblem, naming the place, if the document is not sound but for single keys and values."""
    check_canvas(document.canvas)
    ids = [layer.id for layer in document.layers]
    names = [layer.name for layer in document.layers]
    if len(set(ids)) != len(ids):
        raise ProjectProblem(Message("layers: two layers have the same id"))
    if len(set(names)) != len(names):
        raise ProjectProblem(Message("layers: two layers have the same name"))
    for layer in document.layers:
        frames = [exposure.frame for exposure in layer.cels.exposures]
        if any(after <= before for before, after in pairwise(frames)):
            raise ProjectProblem(Message("layers.{layer}: exposures are out of order", layer=layer.name))
        shown = [exposure.drawing for exposure in layer.cels.exposures if exposure.drawing is not None]
        if any(not 0 <= index < len(layer.cels.drawings) for index in shown):
            raise ProjectProblem(Message("layers.{layer}: an exposure names a missing drawing", layer=layer.name))
    _check_joins(document)
    _check_paper(document)
    _check_pieces(document)
    _check_links(document)
    _check_review(document)


def _check_review(document: Document) -> None:
    first, last = document.work_area or (1, 1)
    if not 1 <= first <= last:
        raise ProjectProblem(
            Message("work_area: frames {first} to {last} are not a range of frames", first=first, last=last)
        )
    frames = [marker.frame for marker in document.markers]
    if frames != sorted(set(frames)) or (frames and frames[0] < 1):
        raise ProjectProblem(Message("markers: markers are out of order"))
    ids = {layer.id for layer in document.layers}
    for note in document.notes:
        known = OF_DOCUMENT if note.layer_id is None else OF_LAYER if note.layer_id in ids else {}
        if note.property not in known:
            raise ProjectProblem(
                Message(
                    "notes: there is no property {property!r} of layer {layer_id!r}",
                    property=note.property,
                    layer_id=note.layer_id,
                )
            )


def _check_links(document: Document) -> None:
    for name in sorted(document.linked):
        if name not in LINKABLE:
            raise ProjectProblem(Message("linked: {name!r} cannot be the same for all layers", name=name))
        tracks = [track_of(document, Address(LINKABLE[name], layer.id)) for layer in document.layers]
        if any(track != tracks[0] for track in tracks):
            raise ProjectProblem(Message("linked: {name} is not the same for all layers", name=name))


def _check_joins(document: Document) -> None:
    by_id = {layer.id: layer for layer in document.layers}
    for layer in document.layers:
        if layer.joins is None:
            continue
        figure = by_id.get(layer.joins)
        if figure is None or figure is layer or figure.joins is not None:
            raise ProjectProblem(
                Message("layers.{layer}: it joins a layer that is no figure of its own", layer=layer.name)
            )


def _check_paper(document: Document) -> None:
    for layer in document.layers:
        if len({drawing.paper for drawing in layer.cels.drawings}) > 1:
            raise ProjectProblem(Message("layers.{layer}: its drawings are on different paper", layer=layer.name))


def _check_pieces(document: Document) -> None:
    if len({piece.id for piece in document.pieces}) != len(document.pieces):
        raise ProjectProblem(Message("set: two pieces have the same id"))
    if len({piece.name for piece in document.pieces}) != len(document.pieces):
        raise ProjectProblem(Message("set: two pieces have the same name"))


def check_canvas(canvas: Canvas) -> None:
    """Raise ProjectProblem if size, rate, length or numbering is beyond what a cut can have."""
    if not (1 <= canvas.width_px <= 16384 and 1 <= canvas.height_px <= 16384):
        raise ProjectProblem(
            Message(
                "canvas: {width_px}x{height_px} is not within 1x1 to 16384x16384 px",
                width_px=canvas.width_px,
                height_px=canvas.height_px,
            )
        )
    if not 0 < canvas.frame_rate <= 1000:
        raise ProjectProblem(
            Message("canvas: {frame_rate} frames a second is not within 0 to 1000", frame_rate=canvas.frame_rate)
        )
    if not 1 <= canvas.length_frames <= 1_000_000:
        raise ProjectProblem(
            Message(
                "canvas: a cut of {length_frames} frames is not within 1 to 1000000", length_frames=canvas.length_frames
            )
        )
    if not 0 <= canvas.first_frame <= MAX_FIRST_FRAME:
        raise ProjectProblem(
            Message(
                "canvas: a first frame of {first} is not within 0 to {most}",
                first=canvas.first_frame,
                most=MAX_FIRST_FRAME,
            )
        )


def _check_tracks(document: Document) -> None:
    for address in addresses(document):
        track = track_of(document, address)
        path = path_of(document, address)
        frames = [key.frame for key in track.keys]
        if frames != sorted(set(frames)) or (frames and frames[0] < 1):
            raise ProjectProblem(Message("{path}: keys are out of order", path=path))
        for value, where in (
            (track.constant, Message("constant")),
            *((key.value, Message("frame {frame}", frame=key.frame)) for key in track.keys),
        ):
            try:
                canonical = address.property.canonical(value)
            except UsageProblem as problem:
                raise ProjectProblem(
                    Message("{path}: {where}: {problem}", path=path, where=where, problem=problem)
                ) from problem
            if canonical != value:
                raise ProjectProblem(
                    Message(
                        "{path}: {where}: {value!r} is not kept in its canonical form",
                        path=path,
                        where=where,
                        value=value,
                    )
                )
        if address.property.holds_only and any(key.interpolation is not Interpolation.HOLD for key in track.keys):
            raise ProjectProblem(Message("{path}: a switch or choice can only be held", path=path))
