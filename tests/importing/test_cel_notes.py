"""What is said about drawings that may not lie on the canvas as was meant."""

import numpy as np

from kagezou.document.model import Cels
from kagezou.geometry.box import Box
from kagezou.importing.cel_notes import notes_on
from kagezou.importing.figures import Figure
from kagezou.importing.new_cels import NewCels

CANVAS = Box(0, 0, 100, 80)


def told(size_px: tuple[int, int], rows: slice | None) -> list[str]:
    figure = None
    if rows is not None:
        solid = np.zeros((size_px[1], size_px[0]), np.bool_)
        solid[rows, 10:20] = True
        figure = Figure(solid, (0, 0))
    return [str(note) for note in notes_on("Hero", NewCels("Hero", Cels(), size_px, 1, ()), figure, CANVAS)]


def test_a_figure_within_its_drawing_and_the_canvas_needs_no_words() -> None:
    assert told((100, 80), slice(5, 60)) == []


def test_each_thing_that_is_odd_is_said() -> None:
    assert told((120, 80), slice(5, 60)) == ["Hero: its drawings of 120 × 80 px reach over the canvas of 100 × 80 px"]
    (nothing,) = told((100, 80), None)
    assert "nothing solid" in nothing
    larger, cut_off = told((100, 90), slice(5, 90))
    assert "100 × 90 px" in larger
    assert "lower edge" in cut_off
