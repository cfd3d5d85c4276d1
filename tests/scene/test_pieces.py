"""From set pieces to the bodies of a frame."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from kagezou.document.address import resolve
from kagezou.document.edits import add_layer, set_constant, set_key
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure
from kagezou.document.set_pieces import add_piece
from kagezou.geometry.box import Box
from kagezou.geometry.sets.bodies import Ball, Drum, Solid
from kagezou.scene.evaluate import evaluate

CELS = Cels((Drawing("1", Path("/c/1.png")),), (Exposure(1, 0),))


def with_values(document: Document, **values: object) -> Document:
    for name, value in values.items():
        document = set_constant(document, resolve(document, name.replace("__", ".")), value)
    return document


def a_room(kind: str, **values: object) -> Document:
    document = add_layer(Document(Canvas(1000, 1000)), "A", CELS, Box(400, 300, 600, 900))
    document = with_values(document, ground__position=[500, 900], light__position=[200, -300, 900])
    return add_piece(document, "it", kind, values)


@pytest.mark.parametrize(
    ("kind", "count", "body"),
    [("wall", 1, Solid), ("box", 1, Solid), ("steps", 5, Solid), ("ramp", 1, Solid), ("cylinder", 1, Drum),
     ("sphere", 1, Ball)],
)  # fmt: skip
def test_every_kind_has_its_bodies_and_every_cast_the_set(kind: str, count: int, body: type) -> None:
    scene = evaluate(a_room(kind, count=4.6), 1)
    bodies = scene.pieces[0].bodies
    assert [type(each) for each in bodies] == [body] * count
    cast = scene.layers[0].cast
    assert cast is not None
    assert cast.pieces is scene.pieces
    assert scene.set_shadow is None
    assert hash(cast) == hash(evaluate(a_room(kind, count=4.6), 1).layers[0].cast)


def test_a_size_is_told_as_it_is_seen() -> None:
    """In perspective as well as without it the base of a wall is as long on the canvas as it was set."""
    for fov in (0.0, 50.0):
        document = with_values(a_room("wall", position=[500, 700], width=300), camera__fov=fov)
        scene = evaluate(document, 1)
        body = scene.pieces[0].bodies[0]
        assert isinstance(body, Solid)
        ends = [scene.camera.canvas_from_world() @ np.append(corner, 1.0) for corner in body.facets[0].corners[:2]]
        (left, y), (right, _) = ((x / w, y / w) for x, y, w in ends)
        assert right - left == pytest.approx(300)
        assert y == pytest.approx(700)
        assert (left + right) / 2 == pytest.approx(500)


def test_pieces_move_with_their_keys() -> None:
    document = a_room("box")
    address = resolve(document, "set.it.angle")
    document = set_key(set_key(document, address, 1, 0.0), address, 11, 90.0)
    first, middle = (evaluate(document, frame).pieces for frame in (1, 6))
    assert first != middle
    assert middle == evaluate(a_room("box", angle=45.0), 1).pieces


def test_what_is_switched_off_or_above_the_horizon_is_not_there() -> None:
    assert evaluate(a_room("box", present=False), 1).pieces == ()
    beyond = with_values(a_room("box", position=[500, -4000]), camera__fov=60.0)
    assert evaluate(beyond, 1).pieces == ()


def test_a_caster_blocks_and_has_a_shadow_of_the_set() -> None:
    document = a_room("box", casts=True, blocks=False)
    document = with_values(document, set__shadow__opacity=0.25, set__shadow__blend="normal")
    scene = evaluate(document, 1)
    assert scene.pieces[0].blocks
    assert scene.set_shadow is not None
    assert (scene.set_shadow.look.opacity, scene.set_shadow.look.multiply) == (0.25, False)
    assert len(scene.set_shadow.cast.lights) == 1
    below = with_values(document, light__position=[500, 2000, 0])
    dark = evaluate(below, 1).set_shadow
    assert dark is not None
    assert dark.cast.lights == ()
    assert replace(dark.cast, lights=scene.set_shadow.cast.lights) == scene.set_shadow.cast
