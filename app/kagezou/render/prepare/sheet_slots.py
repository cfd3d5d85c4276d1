"""Where the shadow on each sheet of a chart is cast aside, and the polygons through which it is then laid."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.box import Box
from kagezou.geometry.polygon import bounding_box
from kagezou.geometry.sets.laid_flat import FlatOutline, moved
from kagezou.geometry.vectors import Matrix
from kagezou.render.prepare.filter_uniforms import MAX_BANDS

MOST_ROWS = 8192
"""No driver's textures are smaller."""

_TRIANGLE = 3


@dataclass(frozen=True, slots=True)
class SheetSlot:
    """A place aside for the shadow on one sheet.

    Parameters
    ----------
    sheet
        Its number in the development.
    part
        The part of the chart's picture in which the sheet is seen, px.
    box
        Where that part lies aside.
    """

    sheet: int
    part: Box
    box: Box

    @property
    def shift(self) -> tuple[int, int]:
        """From a px of the picture to that aside."""
        return (self.box.left - self.part.left, self.box.top - self.part.top)


@dataclass(frozen=True, slots=True, eq=False)
class SheetSlots:
    """Sheets that are cast aside together, and the polygons that are then laid, later ones over earlier ones.

    Parameters
    ----------
    slots
        No two of them share a px.
    triangles
        (3·n, 3): corners, px of the picture, and the number of the slot.
    """

    slots: tuple[SheetSlot, ...]
    triangles: NDArray[np.float64]

    @property
    def box(self) -> Box:
        """All that the slots take up aside."""
        return Box(0, 0, max(slot.box.right for slot in self.slots), max(slot.box.bottom for slot in self.slots))


def sheet_slots(outlines: Sequence[FlatOutline], picture_from_flat: Matrix, window: Box) -> Iterator[SheetSlots]:
    """Yield sheets to be cast aside together, each time as many as there is room for.

    Parameters
    ----------
    outlines
        Those of a chart, in the order in which they are laid.
    picture_from_flat
        (3, 3): from flat places to px of the chart's picture; keeps lines parallel.
    window
        The part of the picture that is drawn.
    """
    polygons = [(outline.sheet, moved(picture_from_flat, outline.corners)) for outline in outlines]
    parts = _parts(polygons, window)
    slots: dict[int, SheetSlot] = {}
    triangles: list[NDArray[np.float64]] = []
    for sheet, polygon in polygons:
        if sheet not in parts or len(polygon) < _TRIANGLE:
            continue
        if sheet not in slots:
            if slots and not _has_room(slots, parts[sheet], window.width):
                yield SheetSlots(tuple(slots.values()), np.concatenate(triangles))
                slots, triangles = {}, []
            slots[sheet] = SheetSlot(sheet, parts[sheet], _place(slots, parts[sheet], window.width))
        triangles.append(_fan(polygon, list(slots).index(sheet)))
    if slots:
        yield SheetSlots(tuple(slots.values()), np.concatenate(triangles))


def _parts(polygons: Sequence[tuple[int, Matrix]], window: Box) -> dict[int, Box]:
    """Return in which part of a window each sheet is seen; without those that are not."""
    parts: dict[int, Box] = {}
    for sheet, polygon in polygons:
        around = bounding_box(polygon)
        part = around and around.grown(1).intersection(window)
        if part is not None:
            parts[sheet] = parts[sheet].union(part) if sheet in parts else part
    return parts


def _has_room(slots: dict[int, SheetSlot], part: Box, width: int) -> bool:
    return len(slots) < MAX_BANDS and _place(slots, part, width).bottom <= MOST_ROWS


def _place(slots: dict[int, SheetSlot], part: Box, width: int) -> Box:
    """Return where a part has its place aside: beside the one before, or below all."""
    left, top = 0, 0
    if slots:
        last = list(slots.values())[-1].box
        is_beside = last.right + part.width <= width
        left = last.right if is_beside else 0
        top = last.top if is_beside else max(slot.box.bottom for slot in slots.values())
    return part.moved(left - part.left, top - part.top)


def _fan(polygon: Matrix, number: int) -> NDArray[np.float64]:
    """Return the triangles (3·n, 3) of a convex polygon (N, 2)."""
    corners = np.column_stack([polygon, np.full(len(polygon), float(number))])
    return np.asarray(corners[np.ravel([(0, second, second + 1) for second in range(1, len(corners) - 1)])])
