"""Parts of one cut in another: light, ground and set with their keys, looks by name and height."""

from dataclasses import replace
from pathlib import Path

import pytest

from kagezou.document.address import Address, track_of, value_of
from kagezou.document.edits import add_layer, set_constant, set_key
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure
from kagezou.document.properties import (
    FOV,
    GROUND_DECLINATION,
    GROUND_POSITION,
    LIGHT_KIND,
    LIGHT_POSITION,
    OPACITY,
    SIMPLIFY,
)
from kagezou.document.set_pieces import add_piece
from kagezou.document.taking import Part, taken
from kagezou.geometry.box import Box

LIGHT = Address(LIGHT_POSITION)


def cut(*figures: tuple[str, int], size: tuple[int, int] = (400, 300), frames: int = 24) -> Document:
    """Return a cut of figures by name and height."""
    document = Document(Canvas(*size, length_frames=frames))
    for name, height in figures:
        cels = Cels((Drawing("1", Path(f"/cels/{name}.png")),), (Exposure(1, 0),))
        document = add_layer(document, name, cels, Box(100, 300 - height, 140, 300))
    return document


def lit(document: Document) -> Document:
    document = set_key(set_key(document, LIGHT, 1, (10.0, -20.0, 30.0)), LIGHT, 20, (110.0, -20.0, 30.0))
    document = set_constant(document, Address(GROUND_POSITION), (200.0, 250.0))
    return set_constant(document, Address(GROUND_DECLINATION), 40.0)


def test_only_what_is_asked_for_is_taken() -> None:
    source, target = lit(cut(("A", 100))), cut(("A", 100))
    done = taken(target, source, [Part.LIGHT]).document
    assert track_of(done, LIGHT) == track_of(source, LIGHT), "with its keys"
    assert value_of(done, Address(GROUND_DECLINATION), 1) == value_of(target, Address(GROUND_DECLINATION), 1)
    assert done.layers == target.layers
    done = taken(target, source, [Part.GROUND]).document
    assert not track_of(done, LIGHT).is_keyed
    assert value_of(done, Address(GROUND_DECLINATION), 1) == 40.0
    assert taken(target, source, []).document == target


def test_on_another_canvas_places_are_scaled() -> None:
    target = cut(("A", 200), size=(800, 600))
    done = taken(target, lit(cut(("A", 100))), [Part.LIGHT, Part.GROUND]).document
    assert value_of(done, LIGHT, 20) == (220.0, -40.0, 60.0)
    assert value_of(done, Address(GROUND_POSITION), 1) == (400.0, 500.0)
    assert done.canvas == target.canvas


def test_looks_go_by_name_in_the_measure_of_the_heights() -> None:
    source = cut(("A", 100), ("B", 100))
    for layer, simplify in zip(source.layers, (10.0, 30.0), strict=True):
        source = set_constant(source, Address(SIMPLIFY, layer.id), simplify)
    target = cut(("b", 200), ("C", 50))
    done = taken(target, source, [Part.LOOK])
    simplified = [value_of(done.document, Address(SIMPLIFY, layer.id), 1) for layer in done.document.layers]
    assert simplified == [pytest.approx(60.0), pytest.approx(5.0)]
    assert [str(note) for note in done.notes] == ["C: not there, so they look as A does"]


def test_a_look_has_no_keys_and_that_is_said() -> None:
    source = cut(("A", 100))
    opacity = Address(OPACITY, source.layers[0].id)
    source = set_key(set_key(source, opacity, 1, 0.2), opacity, 9, 0.8)
    done = taken(cut(("X", 100)), source, [Part.LOOK], frame=9)
    assert value_of(done.document, Address(OPACITY, done.document.layers[0].id), 1) == 0.8
    assert [str(note) for note in done.notes] == ["A: the look of frame 9 was taken, without keys"]
    assert str(taken(cut(("X", 100)), cut(), [Part.LOOK]).notes[0]).startswith("there is no character")


def test_a_set_takes_the_place_of_the_one_there_is() -> None:
    source = add_piece(lit(cut(("A", 100))), "back", "wall")
    target = add_piece(add_piece(cut(("A", 100)), "old", "box"), "older", "box")
    done = taken(target, source, [Part.SET]).document
    assert [piece.name for piece in done.pieces] == ["back"]
    assert not track_of(done, LIGHT).is_keyed
    assert value_of(done, Address(FOV), 1) == value_of(target, Address(FOV), 1)
    assert value_of(done, Address(LIGHT_KIND), 1) == value_of(target, Address(LIGHT_KIND), 1)


def test_keys_behind_the_end_are_said() -> None:
    done = taken(cut(("A", 100), frames=12), lit(cut(("A", 100))), [Part.LIGHT])
    assert [str(note) for note in done.notes] == ["keys behind the end of the cut: light.position"]
    assert taken(cut(frames=12), replace(lit(cut()), tracks={}), [Part.LIGHT]).notes == ()
