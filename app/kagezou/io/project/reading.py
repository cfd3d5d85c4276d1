"""From the JSON of a project of the current version to the document."""

import re
from collections.abc import Iterable, Mapping
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from types import MappingProxyType
from typing import Final

from kagezou.animation.ease import Ease
from kagezou.animation.track import Interpolation, Key, Track, Value, components_of
from kagezou.document.edits import still
from kagezou.document.layer_marks import LABELS, LayerMarks
from kagezou.document.linking import LINKABLE
from kagezou.document.model import BroughtLight, Canvas, Cels, Document, Drawing, Exposure, Layer, Piece, Tracks
from kagezou.document.paper import on_paper
from kagezou.document.properties import FOV, OF_DOCUMENT, OF_LAYER, OF_PIECE
from kagezou.document.property import AnyProperty, ValueProblem
from kagezou.document.set_pieces import MAX_PIECES
from kagezou.document.slate import MAX_FIRST_FRAME, MAX_WORD_CHARACTERS, NO_SLATE, Slate
from kagezou.errors import ProjectProblem
from kagezou.geometry.box import Box
from kagezou.geometry.vanishing import Line, VanishingLines
from kagezou.io.files.json_text import Reader
from kagezou.io.project import fields as fields
from kagezou.io.project.feet import read_feet
from kagezou.io.project.paths import MAX_PATH_CHARACTERS, local_path
from kagezou.io.project.review import read_review
from kagezou.message import Message
from kagezou.picture_source import Paper, PicturePart

_FRAME_RATE: Final = re.compile(r"[0-9]{1,18}(/[0-9]{1,18})?")
_MAX_FRAME: Final = 1_000_000
_MAX_PX: Final = 1_000_000
_MAX_SPEED: Final = 1e12


def document_of(project: Reader, folder: Path) -> Document:
    """Return the document of a project that lies in ``folder``.

    Raises
    ------
    ProjectProblem
        With the JSON path of the first thing that is wrong.
    """
    found = _record(project, fields.PROJECT)
    found["app_version"].text(fields.MAX_NAME_CHARACTERS)
    layers = tuple(_layer(each, folder) for each in found["layers"].items(fields.MAX_LAYERS))
    review = read_review(found, {layer.id for layer in layers})
    document = Document(
        canvas=_canvas(found["canvas"]),
        behind=_background(found["background"], folder),
        layers=layers,
        tracks=_tracks(found["tracks"], OF_DOCUMENT),
        work_area=review.work_area,
        markers=review.markers,
        notes=review.notes,
        pieces=tuple(_piece(each, folder) for each in found["set"].items(MAX_PIECES)) if "set" in found else (),
        vanishing=_vanishing(found["vanishing"], found.get("vanishing_fov")) if "vanishing" in found else None,
        linked=_linked(found["linked"]) if "linked" in found else frozenset(),
        brought_light=_brought_light(found["brought_light"]) if "brought_light" in found else None,
        timesheet=found["timesheet"].text(fields.MAX_SHEET_CHARACTERS) if "timesheet" in found else "",
        slate=_slate(found["slate"]) if "slate" in found else NO_SLATE,
    )
    if row_count(document) > fields.MAX_ROWS:
        raise project.problem(Message("more than {most_rows} drawings, exposures and keys", most_rows=fields.MAX_ROWS))
    return document


def _record(reader: Reader, known: fields.Fields) -> dict[str, Reader]:
    required = [name for name, field in known.items() if not field.optional]
    return reader.record(required, [name for name, field in known.items() if field.optional])


def row_count(document: Document) -> int:
    """Return how many drawings, exposures and keys a document has."""
    brought = document.brought_light
    set_aside = [] if brought is None else [brought.tracks, brought.before]
    owned = [
        document.tracks,
        *set_aside,
        *(layer.tracks for layer in document.layers),
        *(each.tracks for each in document.pieces),
    ]
    tracks = [track for tracks in owned for track in tracks.values()]
    cels = [layer.cels for layer in document.layers]
    return sum(len(track.keys) for track in tracks) + sum(len(each.drawings) + len(each.exposures) for each in cels)


def _canvas(reader: Reader) -> Canvas:
    found = _record(reader, fields.CANVAS)
    rate = found["frame_rate"].text(64)
    if not _FRAME_RATE.fullmatch(rate) or not 0 < _ratio(rate) <= 1000:
        raise found["frame_rate"].refused(Message('a frame rate such as "24" or "24000/1001"'))
    return Canvas(
        width_px=found["width_px"].whole(1, 16384),
        height_px=found["height_px"].whole(1, 16384),
        frame_rate=_ratio(rate),
        length_frames=found["length_frames"].whole(1, _MAX_FRAME),
        first_frame=found["first_frame"].whole(0, MAX_FIRST_FRAME) if "first_frame" in found else 1,
    )


def _slate(reader: Reader) -> Slate:
    return Slate(**{key: _word(word) for key, word in _record(reader, fields.SLATE).items()})


def _word(reader: Reader) -> str:
    text = reader.text(MAX_WORD_CHARACTERS)
    if not text.isprintable() or text != text.strip() or not text:
        raise reader.refused(Message("printable text without spaces around it"))
    return text


def _ratio(text: str) -> Fraction:
    """Return the number ``text`` stands for; 0 where it divides by zero, which no frame rate is."""
    above, _, below = text.partition("/")
    return Fraction(int(above), int(below or 1)) if int(below or 1) else Fraction(0)


def _layer(reader: Reader, folder: Path) -> Layer:
    found = _record(reader, fields.LAYER)
    return Layer(
        id=_name(found["id"]),
        name=_name(found["name"]),
        cels=on_paper(read_feet(found, _cels(found["drawings"], found["exposures"], folder)), _paper(found)),
        figure=_figure(found["figure"]),
        tracks=_tracks(found["tracks"], OF_LAYER),
        joins=_name(found["joins"]) if "joins" in found else None,
        marks=_marks(found),
    )


def _marks(found: Mapping[str, Reader]) -> LayerMarks:
    for key in ("locked", "solo"):
        if key in found and found[key].value is not True:
            raise found[key].refused(Message("true"))
    label = found["label"].word(list(LABELS)) if "label" in found else ""
    return LayerMarks("locked" in found, "solo" in found, label)


def _paper(found: Mapping[str, Reader]) -> Paper:
    return Paper(found["paper"].word(list(Paper))) if "paper" in found else Paper.WHITE


def _linked(reader: Reader) -> frozenset[str]:
    return frozenset(each.word(list(LINKABLE)) for each in reader.items(len(LINKABLE)))


def _brought_light(reader: Reader) -> BroughtLight:
    found = _record(reader, fields.BROUGHT_LIGHT)
    tracks = _tracks(found["tracks"], OF_DOCUMENT)
    return BroughtLight(tracks, _tracks(found["before"], {name: OF_DOCUMENT[name] for name in tracks}))


def _piece(reader: Reader, folder: Path) -> Piece:
    found = _record(reader, fields.PIECE)
    source = _path(found["source"], folder) if "source" in found else None
    return Piece(_name(found["id"]), _name(found["name"]), _tracks(found["tracks"], OF_PIECE), source)


def _vanishing(reader: Reader, kept_fov: Reader | None) -> VanishingLines:
    first, second, third, fourth = (_line(each) for each in reader.items(4, least=4))
    fov = None if kept_fov is None else kept_fov.number(FOV.low, FOV.high)
    return VanishingLines((first, second), (third, fourth), fov)


def _line(reader: Reader) -> Line:
    start, end = (each.items(2, least=2) for each in reader.items(2, least=2))
    (ax, ay), (bx, by) = ((x.number(-_MAX_PX, _MAX_PX), y.number(-_MAX_PX, _MAX_PX)) for x, y in (start, end))
    return ((ax, ay), (bx, by))


def _name(reader: Reader) -> str:
    name = reader.text(fields.MAX_NAME_CHARACTERS)
    if not name.isprintable() or not name.strip():
        raise reader.refused(Message("a printable name"))
    return name


def _figure(reader: Reader) -> Box:
    left, top, right, bottom = (side.whole(-_MAX_PX, _MAX_PX) for side in reader.items(4, least=4))
    box = Box(left, top, right, bottom)
    if box.is_empty:
        raise reader.refused(Message("a box with pixels in it"))
    return box


def _cels(drawings: Reader, exposures: Reader, folder: Path) -> Cels:
    cels = tuple(_drawing(each, folder) for each in drawings.items(fields.MAX_ROWS))
    return Cels(cels, _exposures(exposures, len(cels)))


def _drawing(reader: Reader, folder: Path) -> Drawing:
    name, path, *part = reader.items(3, least=2)
    # A layer that nobody named has an empty address.
    address = part[0].text(MAX_PATH_CHARACTERS, 0) if part else None
    return Drawing(name.text(MAX_PATH_CHARACTERS), _path(path, folder), address)


def _background(reader: Reader, folder: Path) -> Cels:
    if reader.value is None:
        return Cels()
    if isinstance(reader.value, dict):
        found = _record(reader, fields.BACKGROUND)
        return _cels(found["drawings"], found["exposures"], folder)
    if isinstance(reader.value, list):
        path, part = reader.items(2, least=2)
        return still(PicturePart(_path(path, folder), part.text(MAX_PATH_CHARACTERS)))
    return still(_path(reader, folder))


def _path(reader: Reader, folder: Path) -> Path:
    text = reader.text(MAX_PATH_CHARACTERS)
    try:
        return local_path(text, folder)
    except ProjectProblem as problem:
        raise reader.problem(problem.message) from problem


def _exposures(reader: Reader, drawing_count: int) -> tuple[Exposure, ...]:
    exposures: list[Exposure] = []
    for row in reader.items(fields.MAX_ROWS):
        frame, drawing = row.items(2, least=2)
        index = None
        if drawing.value is not None:
            if drawing_count == 0:
                raise drawing.problem(Message("the layer has no drawings"))
            index = drawing.whole(0, drawing_count - 1)
        exposures.append(Exposure(frame.whole(-_MAX_FRAME, _MAX_FRAME), index))
    _check_order(reader, (exposure.frame for exposure in exposures), "[0]")
    return tuple(exposures)


def _check_order(rows: Reader, frames: Iterable[int], inner: str) -> None:
    for index, (before, after) in enumerate(pairwise(frames), start=1):
        if after <= before:
            place = Reader(after, f"{rows.place}[{index}]{inner}")
            raise place.problem(Message("frame {after} does not come after frame {before}", after=after, before=before))


def _tracks(reader: Reader, known: Mapping[str, AnyProperty]) -> Tracks:
    tracks: dict[str, Track] = {}
    for name, track in reader.members().items():
        if name not in known:
            raise track.problem(Message("there is no such property"))
        tracks[name] = read_track(track, known[name])
    return MappingProxyType(tracks)


def read_track(reader: Reader, prop: AnyProperty) -> Track:
    """Return the track of a property: a value, or keys; raises as `read_key`."""
    if not isinstance(reader.value, dict):
        return Track(_value(reader, prop))
    found = _record(reader, fields.TRACK)
    keys = tuple(read_key(each, prop) for each in found["keys"].items(fields.MAX_ROWS, least=1))
    _check_order(found["keys"], (key.frame for key in keys), ".frame")
    constant = _value(found["constant"], prop) if "constant" in found else keys[0].value
    return Track(constant, keys)


def read_key(reader: Reader, prop: AnyProperty) -> Key:
    """Return the key of a property.

    Raises
    ------
    ProjectProblem
        With the JSON path of the first thing that is wrong.
    """
    found = _record(reader, fields.KEY)
    interpolation = Interpolation(found["interpolation"].word([str(each) for each in Interpolation]))
    if prop.holds_only and interpolation is not Interpolation.HOLD:
        raise found["interpolation"].problem(Message("a switch or choice can only be held"))
    value = _value(found["value"], prop)
    most = len(components_of(value) or ())
    return Key(
        frame=found["frame"].whole(1, _MAX_FRAME),
        value=value,
        interpolation=interpolation,
        ease_in=_eases(found.get("ease_in"), most),
        ease_out=_eases(found.get("ease_out"), most),
    )


def _value(reader: Reader, prop: AnyProperty) -> Value:
    try:
        return prop.canonical(reader.value)
    except ValueProblem as problem:
        raise reader.problem(problem.cause) from problem


def _eases(reader: Reader | None, most: int) -> tuple[Ease, ...]:
    if reader is None:
        return ()
    pairs = (row.items(2, least=2) for row in reader.items(most))
    return tuple(Ease(speed.number(-_MAX_SPEED, _MAX_SPEED), influence.number(0.0, 1.0)) for speed, influence in pairs)
