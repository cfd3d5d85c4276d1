"""Generated documents for property tests: every kind of property, constant and keyed, and cels of any shape."""

from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from types import MappingProxyType

from hypothesis import strategies as st

from kagezou.animation.ease import Ease
from kagezou.animation.track import Interpolation, Key, Track, Value, components_of
from kagezou.document.edits import still
from kagezou.document.layer_marks import NO_MARKS, LayerMarks
from kagezou.document.linking import LINKABLE
from kagezou.document.model import (
    BroughtLight,
    Canvas,
    Cels,
    Document,
    Drawing,
    Exposure,
    Layer,
    Marker,
    Piece,
    Tracks,
)
from kagezou.document.note import Note, NoteAnswer
from kagezou.document.properties import OF_DOCUMENT, OF_LAYER, OF_PIECE
from kagezou.document.property import AnyProperty, Kind
from kagezou.document.slate import Slate
from kagezou.geometry.box import Box
from kagezou.geometry.vanishing import VanishingLines
from kagezou.picture_source import Paper

FOLDER = Path("/cuts/c012").absolute()  # Windows adds a drive

coordinates = st.floats(-1e6, 1e6, allow_subnormal=False)
points = st.tuples(coordinates, coordinates)
names = st.text(st.characters(codec="utf-8", exclude_categories=("C", "Z")), min_size=1, max_size=12)


lines = st.tuples(points, points)
vanishing_lines = st.builds(VanishingLines, st.tuples(lines, lines), st.tuples(lines, lines))


def values(prop: AnyProperty) -> st.SearchStrategy[Value]:
    match prop.kind:
        case Kind.NUMBER:
            return st.floats(prop.low, prop.high, allow_subnormal=False)
        case Kind.POINT:
            return points
        case Kind.PLACE:
            return st.tuples(coordinates, coordinates, coordinates)
        case Kind.POINTS:
            return st.lists(points, max_size=4).map(tuple)
        case Kind.COLOR:
            return st.integers(0, 0xFFFFFF).map(lambda number: f"#{number:06X}")
        case Kind.CHOICE:
            return st.sampled_from(prop.choices)
        case Kind.SWITCH:
            return st.booleans()


eases = st.builds(Ease, st.floats(-1e6, 1e6), st.floats(0, 1))


@st.composite
def keys(draw: st.DrawFn, prop: AnyProperty, frame: int) -> Key:
    value = draw(values(prop))
    interpolation = Interpolation.HOLD if prop.holds_only else draw(st.sampled_from(list(Interpolation)))
    most = len(components_of(value) or ())
    each = st.lists(eases, max_size=most).map(tuple)
    return Key(frame, value, interpolation, draw(each), draw(each))


@st.composite
def tracks(draw: st.DrawFn, prop: AnyProperty) -> Track:
    frames = sorted(draw(st.sets(st.integers(1, 1000), max_size=4)))
    return Track(draw(values(prop)), tuple(draw(keys(prop, frame)) for frame in frames))


@st.composite
def track_tables(draw: st.DrawFn, table: dict[str, AnyProperty]) -> Tracks:
    chosen = draw(st.sets(st.sampled_from(sorted(table)), max_size=4))
    return MappingProxyType({name: draw(tracks(table[name])) for name in sorted(chosen)})


# Any bytes but the separator and NUL may stand in a file's name; those that are no UTF-8 come as lone surrogates.
file_names = st.one_of(
    st.text(st.characters(codec="utf-8", exclude_characters="/\0"), min_size=1, max_size=12),
    st.binary(min_size=1, max_size=8).map(lambda raw: raw.decode("utf-8", "surrogateescape")),
).filter(lambda name: name not in {".", ".."} and "/" not in name and "\0" not in name)
folders = st.sampled_from([FOLDER, FOLDER / "A", FOLDER.parent, Path("/elsewhere/deep"), Path("/")])
paths = st.builds(lambda folder, name: folder / name, folders, file_names)


@st.composite
def cels(draw: st.DrawFn) -> Cels:
    paper = draw(st.sampled_from(list(Paper)))
    drawings = tuple(Drawing(draw(names), path, paper=paper) for path in draw(st.lists(paths, max_size=4)))
    frames = sorted(draw(st.sets(st.integers(-5, 100), max_size=6)))
    index = st.one_of(st.none(), st.integers(0, len(drawings) - 1)) if drawings else st.none()
    return Cels(drawings, tuple(Exposure(frame, draw(index)) for frame in frames))


@st.composite
def boxes(draw: st.DrawFn) -> Box:
    left, top = draw(st.integers(-3000, 3000)), draw(st.integers(-3000, 3000))
    return Box(left, top, left + draw(st.integers(1, 4000)), top + draw(st.integers(1, 4000)))


@st.composite
def layers(draw: st.DrawFn, number: int, name: str) -> Layer:
    marks = draw(st.sampled_from([NO_MARKS, LayerMarks(is_locked=True, label="red"), LayerMarks(is_solo=True)]))
    tracks = draw(track_tables(dict(OF_LAYER)))
    return Layer(f"layer-{number}", name, draw(cels()), draw(boxes()), tracks, marks=marks)


@st.composite
def backgrounds(draw: st.DrawFn) -> Cels:
    """Several pictures over time, which have no paper of their own."""
    drawn = draw(cels())
    plain = tuple(Drawing(each.name, each.path, each.part) for each in drawn.drawings)
    return replace(drawn, drawings=plain) if plain else Cels()


@st.composite
def work_areas(draw: st.DrawFn) -> tuple[int, int] | None:
    ends = sorted((draw(st.integers(1, 1000)), draw(st.integers(1, 1000))))
    return draw(st.sampled_from([None, (ends[0], ends[1])]))


said = st.text(st.characters(codec="utf-8"), max_size=20)


@st.composite
def notes(draw: st.DrawFn, layer_ids: list[str]) -> Note:
    layer_id = draw(st.sampled_from([None, *layer_ids]))
    name = draw(st.sampled_from(sorted(OF_DOCUMENT if layer_id is None else OF_LAYER)))
    words = draw(said.filter(lambda text: bool(text.strip())))
    answers = draw(st.lists(st.builds(NoteAnswer, said.filter(bool), said), max_size=2))
    return Note(draw(st.integers(1, 1000)), name, words, layer_id, draw(said), tuple(answers), draw(st.booleans()))


@st.composite
def pieces(draw: st.DrawFn, number: int, name: str) -> Piece:
    return Piece(f"piece-{number}", name, draw(track_tables(dict(OF_PIECE))), draw(st.one_of(st.none(), paths)))


@st.composite
def brought_lights(draw: st.DrawFn) -> BroughtLight:
    brought = draw(track_tables(dict(OF_DOCUMENT)))
    before = {name: draw(tracks(OF_DOCUMENT[name])) for name in brought if draw(st.booleans())}
    return BroughtLight(brought, MappingProxyType(before))


@st.composite
def documents(draw: st.DrawFn) -> Document:
    rate = Fraction(draw(st.integers(1, 60000)), draw(st.integers(60, 2000)))
    size = (draw(st.integers(1, 16384)), draw(st.integers(1, 16384)))
    canvas = Canvas(*size, rate, draw(st.integers(1, 1000)), draw(st.sampled_from([1, 0, 101])))
    chosen = draw(st.lists(names, max_size=3, unique=True))
    drawn = tuple(draw(layers(number, name)) for number, name in enumerate(chosen, start=1))
    marked = sorted(draw(st.sets(st.integers(1, 1000), max_size=3)))
    set_names = draw(st.lists(names, max_size=2, unique=True))
    linked = draw(st.sets(st.sampled_from(sorted(LINKABLE)), max_size=2))
    for name in linked if drawn else ():
        shared = drawn[0].tracks.get(name) or Track(LINKABLE[name].default)
        drawn = tuple(replace(each, tracks=MappingProxyType({**each.tracks, name: shared})) for each in drawn)
    return Document(
        canvas,
        draw(st.one_of(st.just(Cels()), paths.map(still), backgrounds())),
        drawn,
        draw(track_tables(dict(OF_DOCUMENT))),
        draw(work_areas()),
        tuple(Marker(frame, draw(said), draw(st.integers(0, 50))) for frame in marked),
        tuple(draw(st.lists(notes([layer.id for layer in drawn]), max_size=2))),
        tuple(draw(pieces(number, name)) for number, name in enumerate(set_names, start=1)),
        draw(st.one_of(st.none(), vanishing_lines)),
        frozenset(linked),
        draw(st.one_of(st.none(), brought_lights())),
        slate=draw(st.sampled_from([Slate(), Slate(cut="12A"), Slate("第3話", "2", "7")])),
    )
