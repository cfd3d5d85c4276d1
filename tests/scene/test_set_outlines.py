"""The lines of a set: its edges as they are seen, and those on the ground among them."""

import numpy as np
import pytest

from kagezou.document import properties as p
from kagezou.scene.set_outlines import outlines_of, set_lines
from tests.tools.tool_scenes import document_with, with_piece


def test_the_floor_line_of_a_wall_is_its_lower_edge() -> None:
    document = with_piece(document_with(), "wall", position=[500, 800], width=300, height=400)
    (outline,) = outlines_of(document, 1)
    (floor,) = outline.floor
    assert np.allclose(floor, [(350.0, 800.0), (650.0, 800.0)])
    lines = set_lines(document, 1)
    assert (lines.edges, lines.floor) == (outline.seen, outline.floor)
    assert lines == set_lines(document, 2)


def test_a_box_shows_three_sides_of_its_floor_and_a_sphere_only_touches_the_ground() -> None:
    turned = with_piece(document_with(), "box", position=[500, 800], width=100, height=80, depth=60, angle=20)
    (outline,) = outlines_of(turned, 1)
    # Turned, the two sides toward the viewer are seen, the two behind are hidden.
    assert len(outline.floor) == 2
    assert set_lines(with_piece(document_with(), "sphere", position=[500, 800], width=80), 1).floor == ()


def test_the_floor_line_of_a_cylinder_is_the_half_of_its_rim_toward_the_viewer() -> None:
    document = with_piece(document_with(), "cylinder", position=[500, 800], width=100, height=200)
    rows = [y for line in set_lines(document, 1).floor for _, y in line]
    assert min(rows) >= 799
    assert max(rows) == pytest.approx(825, abs=0.5)


def test_without_a_set_and_on_a_ground_seen_edge_on_there_is_nothing() -> None:
    assert set_lines(document_with(), 1).edges == ()
    assert outlines_of(with_piece(document_with((p.GROUND_DECLINATION, 90.0)), "box"), 1) == ()
