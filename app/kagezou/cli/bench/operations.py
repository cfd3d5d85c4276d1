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
from kagezou.document.edits import set_constant
from kagezou.document.model import Document
from kagezou.document.set_pieces import add_piece
from kagezou.document.set_properties import GROUND_RECEIVES
from kagezou.document.values import value_at
from kagezou.geometry.relief import Foothold, relief_card
from kagezou.geometry.sets.measures import PieceKind
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from kagezou.scene.scene import Scene

ROUNDS: Final = 60
_WARM_UP: Final = 4

Change = Callable[[Document, int], tuple[Document, int]]
"""Returns the document and the frame of a round; no two rounds of one change show the same."""

Dressing = Callable[[Document, Scene], Scene]
"""Returns what is drawn of a document's scene."""


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
    changes = dict(_changes(document, hills))
    shown = {"relief": _on_two_feet}
    copies: list[float] = []
    times: dict[str, float] = {}
    for name, change in changes.items():
        count = min(rounds, document.canvas.length_frames - _WARM_UP) if name == "frame step" else rounds
        dressed = shown.get(name, _as_it_is)
        each = [_timed(document, (change, dressed), renderer, number) for number in range(max(count, 1) + _WARM_UP)]
        times[name] = median(each[_WARM_UP:])
        copies += [_copy_timed(renderer) for _ in range(max(rounds // 4, 1))]
    copy_ms = median(copies)
    return Measured(copy_ms, tuple(Operation(name, ms, ms / copy_ms) for name, ms in times.items()))


def _timed(document: Document, way: tuple[Change, Dressing], renderer: Renderer, number: int) -> float:
    change, dressed = way
    started = time.perf_counter()
    changed, frame = change(document, number)
    renderer.draw_picture(dressed(changed, evaluate(changed, frame)))
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
    yield "relief", _moved_light(document)
    yield "ground position", _setting(ground, lambda n: (place[0], place[1] + _sweep(n, 0.05 * height)))
    yield "declination", _setting(Address(properties.GROUND_DECLINATION), lambda n: 60.0 + _sweep(n, 12.0))
    yield "roll", _setting(Address(properties.GROUND_ROLL), lambda n: _sweep(n, 6.0))
    yield "tilt", _setting(Address(properties.TILT, layer.id), lambda n: _sweep(n, 30.0))
    yield "grounding point", _setting(grounding, lambda n: ((foot[0] + _sweep(n, 0.1 * height), foot[1]),))
    yield "opacity", _setting(Address(properties.OPACITY, layer.id), lambda n: 0.5 + _sweep(n, 0.4))


def _changes_of_shape(document: Document) -> Iterator[tuple[str, Change]]:
    layer, light = document.layers[-1], _moved_light(document)
    simplify, distance = Address(properties.SIMPLIFY, layer.id), Address(properties.DISTANCE, layer.id)
    simplified = _with(document, {simplify: 40.0, distance: 200.0})
    first, second = (Address(lines.amplitude, layer.id) for lines in (properties.WAVE1, properties.WAVE2))
    waved = _with(simplified, {first: 10.0, second: 6.0})
    yield "simplify", _setting(simplify, lambda n: 40.0 + _sweep(n, 20.0))
    yield "distance", _upon(simplified, _setting(distance, lambda n: 200.0 + _sweep(n, 60.0)))
    yield "light, simplified", _upon(simplified, light)
    yield "light, simplified, waves", _upon(waved, light)
    yield "wave", _upon(waved, _setting(first, lambda n: 10.0 + _sweep(n, 4.0)))
    yield "softness", _setting(Address(properties.SOFTNESS, layer.id), lambda n: 10.0 + _sweep(n, 6.0))
    yield "fade", _setting(Address(properties.FADE, layer.id), lambda n: 600.0 + _sweep(n, 200.0))


def _changes_on_sets(document: Document, hills: Path) -> Iterator[tuple[str, Change]]:
    foot, height, light = _foot(document), document.layers[-1].figure.height, _moved_light(document)
    yield "light on a set", _upon(_in_a_set(document, foot, height), light)
    yield "light on a mesh set", _upon(_on_hills(document, foot, hills), light)


def _as_it_is(_document: Document, scene: Scene) -> Scene:
    return scene


def _on_two_feet(document: Document, scene: Scene) -> Scene:
    """Return the scene with its uppermost character on a relief card of two feet, one behind the other."""
    figure, layer = document.layers[-1].figure, scene.layers[-1]
    if layer.cast is None:
        return scene
    (x, y), height = _foot(document), figure.height
    places = ((x - 0.09 * height, y), (x + 0.09 * height, y - 0.04 * height))
    feet = [Foothold(place, place[1], is_planted=True) for place in places]
    card = relief_card(scene.camera, scene.ground, feet, height)
    layer = replace(layer, cast=replace(layer.cast, card=card))
    return replace(scene, layers=(*scene.layers[:-1], layer))


def _foot(document: Document) -> tuple[float, float]:
    figure = document.layers[-1].figure
    return (figure.left + figure.right) / 2, float(figure.bottom)


def _in_a_set(document: Document, foot: tuple[float, float], height: int) -> Document:
    """Return the document with a wall and three boxes behind and beside the character."""
    x, y = foot
    wall: dict[str, object] = {
        "position": [x, y - 0.2 * height],
        "width": 1.3 * height,
        "height": 0.7 * height,
        "angle": -8,
    }
    document = add_piece(document, "wall", PieceKind.WALL, wall)
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
