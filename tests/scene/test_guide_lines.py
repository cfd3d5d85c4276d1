"""Ground, set and feet as lines over a picture."""

from itertools import pairwise
from math import hypot

import pytest

from kagezou.document.address import resolve
from kagezou.document.edits import set_constant, set_key
from kagezou.document.model import Document
from kagezou.scene.guide_lines import guide_lines
from kagezou.scene.set_outlines import set_lines
from tests.tools.tool_scenes import document_with, with_piece


def valued(document: Document, **values: object) -> Document:
    for path, value in values.items():
        document = set_constant(document, resolve(document, path), value)
    return document


def test_the_ground_line_crosses_the_whole_picture_at_its_roll() -> None:
    document = valued(document_with(), **{"ground.position": [500, 800], "ground.roll": 30.0})
    (x0, y0), (x1, y1) = guide_lines(document, 1).ground[0]
    assert (x0 + x1) / 2 == pytest.approx(500)
    assert (y1 - y0) / (x1 - x0) == pytest.approx(3**-0.5)
    assert hypot(x1 - x0, y1 - y0) > 2 * hypot(document.canvas.width_px, document.canvas.height_px)


@pytest.mark.parametrize("declination", [10.0, 40.0, 80.0])
def test_squares_of_the_ground_are_as_flat_as_it_is_seen(declination: float) -> None:
    document = valued(document_with(), **{"ground.declination": declination})
    points = [point for line in guide_lines(document, 1).ground[1:] for point in line]
    wide, high = (max(each) - min(each) for each in zip(*points, strict=True))
    assert wide == pytest.approx(document.canvas.height_px / 2)
    flat = valued(document, **{"ground.declination": 60.0})
    lower = [point[1] for line in guide_lines(flat, 1).ground[1:] for point in line]
    assert (high > max(lower) - min(lower)) == (declination < 60)


def test_every_grounding_point_has_a_ring_on_the_frames_on_which_it_holds() -> None:
    document = document_with()
    at = resolve(document, "layers.A.grounding")
    document = set_key(document, at, 1, [[300, 700]])
    document = set_key(document, at, 5, [[300, 700], [420, 720]])
    assert [len(guide_lines(document, frame).contacts) for frame in (1, 4, 5)] == [1, 1, 2]
    (ring,) = guide_lines(document, 1).contacts
    radii = [hypot(x - 300, y - 700) for x, y in ring]
    assert max(radii) == pytest.approx(min(radii))
    assert ring[0] == pytest.approx(ring[-1])
    assert max(hypot(b[0] - a[0], b[1] - a[1]) for a, b in pairwise(ring)) < radii[0] / 2


def test_a_hidden_figure_has_no_rings() -> None:
    document = valued(document_with(), **{"layers.A.grounding": [[300, 700]]})
    assert guide_lines(document, 1).contacts
    assert not guide_lines(valued(document, **{"layers.A.visible": False}), 1).contacts


def test_the_set_has_its_own_lines() -> None:
    document = with_piece(document_with(), "wall", position=[500, 700])
    found, of_set = guide_lines(document, 1), set_lines(document, 1)
    assert (found.edges, found.floor) == (of_set.edges, of_set.floor)
