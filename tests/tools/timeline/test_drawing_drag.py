"""Drawings dragged along time, pointer by pointer."""

from dataclasses import replace
from pathlib import Path

import pytest

from kagezou.document.edits import add_layer, set_canvas, set_exposures
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure
from kagezou.geometry.box import Box
from kagezou.tools.timeline.drawing_drag import BarPart, DraggedDrawings, dragging_drawings, grip_on
from kagezou.tools.timeline.lane_pointer import LanePointer

LAYER = "layer-1"
CELL_PX = 20.0
PRESSED = LanePointer(0.0, CELL_PX)


@pytest.fixture
def document() -> Document:
    """Drawings on 1, 5 and 9 of a cut of 12 frames."""
    cels = Cels(
        tuple(Drawing(name, Path(f"{name}.png")) for name in "abc"), (Exposure(1, 0), Exposure(5, 1), Exposure(9, 2))
    )
    made = add_layer(Document(Canvas(100, 100)), "A", cels, Box(0, 0, 9, 9))
    return set_canvas(made, Canvas(100, 100, length_frames=12))


def dragged(document: Document, part: BarPart, run: tuple[int, int], frames: float, **asked: bool) -> DraggedDrawings:
    """Drag by so many frames; nothing catches unless it is asked for."""
    drag = dragging_drawings(document, grip_on(document, 1, LAYER, part, run))
    assert drag.send(PRESSED).document is document
    return drag.send(replace(LanePointer(frames * CELL_PX, CELL_PX, catches=False), **asked))


def starts(shown: DraggedDrawings) -> list[int]:
    assert shown.document.layer(LAYER).cels.exposures == shown.exposures
    return [each.frame for each in shown.exposures]


def test_a_start_is_moved_and_what_follows_stays(document: Document) -> None:
    shown = dragged(document, BarPart.START, (1, 1), 2)
    assert (starts(shown), shown.frame) == ([1, 7, 9], 7)


def test_with_ripple_what_follows_moves_along(document: Document) -> None:
    assert starts(dragged(document, BarPart.START, (1, 1), 2, ripples=True)) == [1, 7, 11]


def test_an_end_is_the_start_of_the_next(document: Document) -> None:
    assert grip_on(document, 1, LAYER, BarPart.END, (0, 0)).frame == 5
    assert starts(dragged(document, BarPart.END, (0, 0), 1)) == [1, 6, 9]


def test_the_middle_moves_a_run(document: Document) -> None:
    assert starts(dragged(document, BarPart.MIDDLE, (1, 2), 1)) == [1, 6, 10]


def test_the_last_end_lies_behind_the_cut_and_goes_no_further(document: Document) -> None:
    grip = grip_on(document, 1, LAYER, BarPart.END, (2, 2))
    assert grip.edge == 13
    shown = dragged(document, BarPart.END, (2, 2), 4)
    assert (shown.exposures, shown.frame, str(shown.note)) == (grip.exposures, 13, "the cut ends here")
    empty = dragged(document, BarPart.END, (2, 2), -2).exposures[-1]
    assert empty == Exposure(11, None), "from there on nothing is seen"


def test_the_cut_keeps_its_length_while_the_hand_is_down(document: Document) -> None:
    shown = dragged(document, BarPart.MIDDLE, (2, 2), 9)
    assert shown.document.canvas.length_frames == 12
    assert starts(shown)[-1] == 18


def test_what_is_dragged_catches_nothing_of_itself(document: Document) -> None:
    grip = grip_on(document, 3, LAYER, BarPart.START, (1, 1))
    assert grip.catching == (1, 3, 9, 12, 13)
    shown = dragged(document, BarPart.START, (1, 1), 3.7, catches=True, goes_over=True)
    assert (shown.frame, shown.caught_by) == (9, 9)


@pytest.mark.parametrize(
    ("part", "run", "frames", "kept", "over"),
    [
        (BarPart.START, (1, 1), 6, [1, 8, 9], [1, 11]),
        (BarPart.START, (2, 2), -7, [1, 5, 6], [1, 2]),
        (BarPart.END, (0, 0), 6, [1, 8, 9], [1, 11]),
        (BarPart.END, (0, 0), -6, [1, 2, 9], [1, 2, 9]),
        (BarPart.MIDDLE, (1, 1), 6, [1, 8, 12], [1, 11, 15]),
        (BarPart.MIDDLE, (1, 2), -7, [1, 2, 6], [1, 5]),
    ],
)
def test_no_neighbour_is_passed_over_unless_asked(
    document: Document, part: BarPart, run: tuple[int, int], frames: int, kept: list[int], over: list[int]
) -> None:
    shown = dragged(document, part, run, frames)
    assert starts(shown) == kept
    assert str(shown.note).startswith("stops at its neighbour")
    beyond = dragged(document, part, run, frames, goes_over=True)
    assert (starts(beyond), beyond.note) == (over, None)


def test_an_empty_cel_may_be_passed_over(document: Document) -> None:
    exposures = (Exposure(1, 0), Exposure(3, None), Exposure(5, 1), Exposure(9, 2))
    document = set_exposures(document, LAYER, exposures)
    assert starts(dragged(document, BarPart.END, (0, 0), 9)) == [1, 5, 9]
    assert starts(dragged(document, BarPart.START, (2, 2), -9)) == [1, 3, 9]


def test_every_document_is_made_of_the_first(document: Document) -> None:
    drag = dragging_drawings(document, grip_on(document, 1, LAYER, BarPart.MIDDLE, (1, 1)))
    drag.send(PRESSED)
    assert starts(drag.send(LanePointer(5 * CELL_PX, CELL_PX, catches=False))) != [1, 5, 9]
    back = drag.send(LanePointer(0.0, CELL_PX, catches=False))
    assert back.document.layer(LAYER).cels.exposures == document.layer(LAYER).cels.exposures
