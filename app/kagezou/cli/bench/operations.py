"""What each operation of a person costs, from the edit of a document to finished pixels."""

import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from statistics import median
from typing import Final

from kagezou.animation.track import Value
from kagezou.document import properties
from kagezou.document.address import Address
from kagezou.document.companion_properties import CONTACT_SIZE, CONTACT_STRENGTH, REFLECTION_OPACITY
from kagezou.document.edits import add_layer, join_layer, set_constant, set_drawings
from kagezou.document.figure_properties import POSITION
from kagezou.document.model import Document, Drawing, drawing_size
from kagezou.document.set_pieces import add_piece
from kagezou.document.set_properties import GROUND_RECEIVES
from kagezou.document.values import value_at
from kagezou.document.wave_properties import SLIT_GROWTH, SLITS
from kagezou.geometry.box import centred_offset
from kagezou.geometry.sets.measures import PieceKind
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from kagezou.standing.foot import Foot, FootPin, Verdict

ROUNDS: Final = 60
_WARM_UP: Final = 4

Change = Callable[[Document, int], tuple[Document, int]]
"""Returns the document and the frame of a round; no two rounds of one change show the same."""


@dataclass(frozen=True, slots=True)
class Operation:
    """The cost of one operation; the ratio is to one plain copy of the whole picture."""

    name: str
    median_ms: float
    ratio: float

    @property
    def fps(self) -> float:
        """How many a second."""
        return 1000.0 / self.median_ms


@dataclass(frozen=True, slots=True)
class Measured:
    """What was measured on one canvas."""

    copy_ms: float
    operations: tuple[Operation, ...]


def measured(document: Document, renderer: Renderer, hills: Path, rounds: int = ROUNDS) -> Measured:
    """Measure every operation with the context that is current; copies are measured in between.

    Parameters
    ----------
    document
        With one character layer at least, whose drawings are already in memory.
    hills
        The file of a large set.
    """
    # The sun has no place to be dragged from.
    document = _with(document, {Address(properties.LIGHT_KIND): "point"})
    changes = dict(_changes(document, hills))
    copies: list[float] = []
    times: dict[str, float] = {}
    for name, change in changes.items():
        count = min(rounds, document.canvas.length_frames - _WARM_UP) if name == "frame step" else rounds
        each = [_timed(document, change, renderer, number) for number in range(max(count, 1) + _WARM_UP)]
        times[name] = median(each[_WARM_UP:])
        copies += [_copy_timed(renderer) for _ in range(max(rounds // 4, 1))]
    copy_ms = median(copies)
    return Measured(copy_ms, tuple(Operation(name, ms, ms / copy_ms) for name, ms in times.items()))


def _timed(document: Document, change: Change, renderer: Renderer, number: int) -> float:
    started = time.perf_counter()
    changed, frame = change(document, number)
    renderer.draw_picture(evaluate(changed, frame))
    renderer.finish()
    return (time.perf_counter() - started) * 1000


def _copy_timed(renderer: Renderer) -> float:
    started = time.perf_counter()
    renderer.copy_picture()
    renderer.finish()
    return (time.perf_counter() - started) * 1000


def _changes(document: Document, hills: Path) -> Iterator[tuple[str, Change]]:
    yield from _changes_of_place(document)
    yield from _changes_of_shape(document)
    yield from _changes_on_sets(document, hills)
    yield "frame step", lambda same, n: (same, 1 + n % same.canvas.length_frames)


def _moved_light(document: Document) -> Change:
    light, height = Address(properties.LIGHT_POSITION), document.layers[-1].figure.height
    lamp = value_at(document.tracks, properties.LIGHT_POSITION, 1)
    return _setting(light, lambda n: (lamp[0] + _sweep(n, 0.3 * height), lamp[1], lamp[2]))


def _changes_of_place(document: Document) -> Iterator[tuple[str, Change]]:
    layer, foot = document.layers[-1], _foot(document)
    height = layer.figure.height
    ground, grounding = Address(properties.GROUND_POSITION), Address(properties.GROUNDING, layer.id)
    place = value_at(document.tracks, properties.GROUND_POSITION, 1)
    yield "light", _moved_light(document)
    yield "relief", _upon(_on_two_feet(document), _moved_light(document))
    yield "moved cel", _setting(Address(POSITION, layer.id), lambda n: _beside(document, _sweep(n, 0.2 * height)))
    yield "joined cels", _upon(_in_two_cels(document), _moved_light(document))
    yield "ground position", _setting(ground, lambda n: (place[0], place[1] + _sweep(n, 0.05 * height)))
    yield "declination", _setting(Address(properties.GROUND_DECLINATION), lambda n: 60.0 + _sweep(n, 12.0))
    yield "roll", _setting(Address(properties.GROUND_ROLL), lambda n: _sweep(n, 6.0))
    yield "tilt", _setting(Address(properties.TILT, layer.id), lambda n: _sweep(n, 30.0))
    yield "grounding point", _setting(grounding, lambda n: ((foot[0] + _sweep(n, 0.1 * height), foot[1]),))
    yield "reflection", _setting(Address(REFLECTION_OPACITY, layer.id), lambda n: 0.5 + _sweep(n, 0.4))
    touching = _with(_on_two_feet(document), {Address(CONTACT_STRENGTH, layer.id): 0.6})
    yield "contact", _upon(touching, _setting(Address(CONTACT_SIZE, layer.id), lambda n: 1.0 + _sweep(n, 0.2)))
    yield "opacity", _setting(Address(properties.OPACITY, layer.id), lambda n: 0.5 + _sweep(n, 0.4))


def _changes_of_shape(document: Document) -> Iterator[tuple[str, Change]]:
    layer, light = document.layers[-1], _moved_light(document)
    simplify, distance = Address(properties.SIMPLIFY, layer.id), Address(properties.DISTANCE, layer.id)
    simplified = _with(document, _simplification(document))
    first, second = (Address(lines.amplitude, layer.id) for lines in (properties.WAVE1, properties.WAVE2))
    waved = _with(simplified, {first: 10.0, second: 6.0})
    yield "simplify", _setting(simplify, lambda n: 40.0 + _sweep(n, 20.0))
    yield "distance", _upon(simplified, _setting(distance, lambda n: 200.0 + _sweep(n, 60.0)))
    yield "light, simplified", _upon(simplified, light)
    yield "light, simplified, waves", _upon(waved, light)
    yield "wave", _upon(waved, _setting(first, lambda n: 10.0 + _sweep(n, 4.0)))
    slits = {Address(SLITS, layer.id): 0.9, Address(SLIT_GROWTH, layer.id): 0.1}
    yield "light, simplified, slits", _upon(_with(waved, slits), light)
    yield "softness", _setting(Address(properties.SOFTNESS, layer.id), lambda n: 10.0 + _sweep(n, 6.0))
    yield "fade", _setting(Address(properties.FADE, layer.id), lambda n: 600.0 + _sweep(n, 200.0))


def _changes_on_sets(document: Document, hills: Path) -> Iterator[tuple[str, Change]]:
    foot, height, light = _foot(document), document.layers[-1].figure.height, _moved_light(document)
    simplified = _with(document, _simplification(document))
    yield "light on a set", _upon(_in_a_set(document, foot, height), light)
    yield "light on a wall, simplified", _upon(_by_a_wall(simplified, foot, height), light)
    yield "light on a set, simplified", _upon(_in_a_set(simplified, foot, height), light)
    yield "light on a mesh set", _upon(_on_hills(document, foot, hills), light)


def _on_two_feet(document: Document) -> Document:
    """Return the document with its uppermost character on two feet that carry, one behind the other."""
    layer, height = document.layers[-1], document.layers[-1].figure.height
    x, y = _foot(document)
    places = ((x - 0.09 * height, y), (x + 0.09 * height, y - 0.04 * height))

    def standing(drawing: Drawing) -> Drawing:
        left, top = centred_offset(document.canvas.box, *drawing_size(document.canvas, drawing))
        feet = tuple(Foot(track, (at[0] - left, at[1] - top)) for track, at in enumerate(places))
        return replace(drawing, feet=feet, pins=tuple(FootPin(foot.track, Verdict.PLANTED) for foot in feet))

    return set_drawings(document, layer.id, tuple(map(standing, layer.cels.drawings)))


def _in_two_cels(document: Document) -> Document:
    """Return the document with the drawings of its uppermost character twice, as two cels of one figure."""
    layer = document.layers[-1]
    document = add_layer(document, f"{layer.name} part", layer.cels, layer.figure)
    return join_layer(document, document.layers[-1].id, layer.id)


def _beside(document: Document, away: float) -> tuple[float, float]:
    x, y = document.canvas.box.middle
    return (x + away, y)


def _foot(document: Document) -> tuple[float, float]:
    figure = document.layers[-1].figure
    return (figure.left + figure.right) / 2, float(figure.bottom)


def _simplification(document: Document) -> Mapping[Address, Value]:
    """Return what simplifies the shadow of the uppermost character, with the distance from its feet."""
    layer = document.layers[-1].id
    return {Address(properties.SIMPLIFY, layer): 40.0, Address(properties.DISTANCE, layer): 200.0}


def _by_a_wall(document: Document, foot: tuple[float, float], height: int) -> Document:
    """Return the document with a wall behind the character."""
    x, y = foot
    wall: dict[str, object] = {
        "position": [x, y - 0.2 * height],
        "width": 1.3 * height,
        "height": 0.7 * height,
        "angle": -8,
    }
    return add_piece(document, "wall", PieceKind.WALL, wall)


def _in_a_set(document: Document, foot: tuple[float, float], height: int) -> Document:
    """Return the document with a wall and three boxes behind and beside the character."""
    x, y = foot
    document = _by_a_wall(document, foot, height)
    for across, back, angle in ((0.2, 0.07, 30), (-0.15, 0.1, 12), (0.08, 0.04, -20)):
        size = {"width": 0.2 * height, "height": 0.13 * height, "depth": 0.13 * height}
        place: dict[str, object] = {"position": [x + across * height, y - back * height], "angle": angle}
        document = add_piece(document, "box", PieceKind.BOX, {**size, **place})
    return document


def _on_hills(document: Document, foot: tuple[float, float], hills: Path) -> Document:
    """Return the document with the character on hills of a hundred thousand triangles that take the light, too."""
    wide = 1.8 * max(document.canvas.width_px, document.canvas.height_px)
    document = add_piece(document, "hills", PieceKind.MESH, {"position": [*foot], "scale": wide}, source=hills)
    return set_constant(document, Address(GROUND_RECEIVES), False)  # noqa: FBT003 - a value


def _setting(address: Address, value: Callable[[int], Value]) -> Change:
    return lambda document, number: (set_constant(document, address, value(number)), 1)


def _with(document: Document, values: Mapping[Address, Value]) -> Document:
    for address, value in values.items():
        document = set_constant(document, address, value)
    return document


def _upon(document: Document, change: Change) -> Change:
    """Return a change that starts from another document than the one it is handed."""
    return lambda _, number: change(document, number)


def _sweep(number: int, reach: float) -> float:
    """Return the value of a round within ±reach, near the one before and unlike every other."""
    turn = (number * 0.0137 + 0.25) % 1.0
    return reach * (4 * abs(turn - 0.5) - 1)
