"""Feet and sizes of drawings in the project file: rows beside the drawings, left out where there are none."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Final

from kagezou.document.model import Cels, Drawing
from kagezou.geometry.box import Box
from kagezou.geometry.vectors import Point2
from kagezou.io.files.json_text import JsonRow, Reader
from kagezou.io.project.fields import MAX_ROWS
from kagezou.message import Message
from kagezou.standing.foot import Foot, FootPin, Verdict

_MAX_TRACK: Final = 10_000
_MAX_FEET: Final = 64
_MAX_PX: Final = 1_000_000
_MAX_SIDE_PX: Final = 1_000_000


def feet_tree(drawings: Sequence[Drawing]) -> dict[str, object]:
    """Return what is known of the drawings of a layer as JSON rows; what there is nothing of is left out."""
    feet = [
        JsonRow([index, _sides(drawing.figure), [[foot.track, *foot.place] for foot in drawing.feet]])
        for index, drawing in enumerate(drawings)
        if drawing.feet is not None
    ]
    pins = [
        JsonRow([index, pin.track, pin.verdict, pin.place, pin.ground_row])
        for index, drawing in enumerate(drawings)
        for pin in drawing.pins
    ]
    rows = {"sizes": [JsonRow(row) for row in _size_rows(drawings)], "feet": feet, "pins": pins}
    return {name: value for name, value in rows.items() if value}


def _size_rows(drawings: Sequence[Drawing]) -> Iterator[list[int]]:
    """Yield the size of each drawing that differs from the one before it; 0 × 0 where it is not known."""
    last: tuple[int, int] | None = None
    for index, drawing in enumerate(drawings):
        if drawing.size_px != last:
            yield [index, *(drawing.size_px or (0, 0))]
            last = drawing.size_px


def read_feet(found: Mapping[str, Reader], cels: Cels) -> Cels:
    """Return the cels with what a layer's record says about feet and sizes.

    Raises
    ------
    ProjectProblem
        With the JSON path of the first thing that is wrong.
    """
    drawings = list(cels.drawings)
    for index, row in _indexed(found.get("sizes"), 3, len(drawings)):
        width, height = (side.whole(0, _MAX_SIDE_PX) for side in row[1:])
        size = (width, height) if width and height else None
        drawings[index:] = [replace(drawing, size_px=size) for drawing in drawings[index:]]
    for index, row in _indexed(found.get("feet"), 3, len(drawings)):
        feet = tuple(_foot(each) for each in row[2].items(_MAX_FEET))
        drawings[index] = replace(drawings[index], figure=_box(row[1]), feet=feet)
    for index, row in _indexed(found.get("pins"), 5, len(drawings)):
        drawing = drawings[index]
        drawings[index] = replace(drawing, pins=(*drawing.pins, _pin(row)))
    return replace(cels, drawings=tuple(drawings))


def _indexed(rows: Reader | None, count: int, drawings: int) -> Iterator[tuple[int, list[Reader]]]:
    """Yield the rows with the index of a drawing that each begins with."""
    if rows is None or not drawings:
        return
    for row in rows.items(MAX_ROWS):
        parts = list(row.items(count, least=count))
        yield parts[0].whole(0, drawings - 1), parts


def _sides(box: Box | None) -> list[int] | None:
    return None if box is None else [box.left, box.top, box.right, box.bottom]


def _box(reader: Reader) -> Box | None:
    if reader.value is None:
        return None
    left, top, right, bottom = (side.whole(-_MAX_PX, _MAX_PX) for side in reader.items(4, least=4))
    box = Box(left, top, right, bottom)
    if box.is_empty:
        raise reader.refused(Message("a box with pixels in it"))
    return box


def _foot(reader: Reader) -> Foot:
    track, x, y = reader.items(3, least=3)
    return Foot(track.whole(0, _MAX_TRACK), (_px(x), _px(y)))


def _pin(row: list[Reader]) -> FootPin:
    _, track, verdict, place, ground = row
    words = [str(each) for each in Verdict]
    return FootPin(
        track.whole(0, _MAX_TRACK),
        None if verdict.value is None else Verdict(verdict.word(words)),
        None if place.value is None else _place(place),
        None if ground.value is None else _px(ground),
    )


def _place(reader: Reader) -> Point2:
    x, y = reader.items(2, least=2)
    return (_px(x), _px(y))


def _px(reader: Reader) -> float:
    return reader.number(-_MAX_PX, _MAX_PX)
