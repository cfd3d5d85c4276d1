"""What the staging has to know of drawings' pixels: where the figure is, where it stands, how far it moves."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from kagezou.document.model import Drawing
from kagezou.errors import InputProblem
from kagezou.geometry.box import Box, centred_offset
from kagezou.geometry.vectors import Matrix, Point2
from kagezou.importing.progress import LoadPhase, Progress, no_progress
from kagezou.io.images.reading import read_matte
from kagezou.message import Message
from kagezou.picture_source import PictureSource

_POINTS = 600
_OUTLINE_ROWS = 80
"""So many pixels and rows of a figure stand for all of them when a light is sought."""

LATER_DRAWINGS = 4
"""So many other drawings of a layer are looked at to see how far it moves."""


@dataclass(frozen=True, slots=True, eq=False)
class Figure:
    """The solid part of a drawing on the canvas: alpha of 0.5 and more.

    Parameters
    ----------
    solid
        (H, W), the solid pixels of the drawing.
    offset
        Where the drawing's top left pixel lies, canvas px.
    """

    solid: NDArray[np.bool_]
    offset: tuple[int, int]

    @property
    def box(self) -> Box:
        """The smallest box around it, canvas px."""
        rows, columns = np.flatnonzero(self.solid.any(axis=1)), np.flatnonzero(self.solid.any(axis=0))
        return Box(int(columns[0]), int(rows[0]), int(columns[-1]) + 1, int(rows[-1]) + 1).moved(*self.offset)

    @property
    def foot(self) -> Point2:
        """The middle of its lowest row of pixels, on that row's lower edge, canvas px."""
        return self._middle_of_row(-1, 1.0)

    @property
    def head(self) -> Point2:
        """The middle of its highest row of pixels, on that row's upper edge, canvas px."""
        return self._middle_of_row(0, 0.0)

    @property
    def is_cut_off(self) -> bool:
        """Whether it reaches the lower edge of its drawing, so that its feet may be missing."""
        return bool(self.solid[-1].any())

    def on(self, canvas: Box) -> "Figure":
        """Return it as it lies on another canvas."""
        height, width = self.solid.shape
        return replace(self, offset=centred_offset(canvas, width, height))

    def points(self) -> Matrix:
        """Return the centres of some of its pixels, evenly spread, (N, 2), canvas px, y down."""
        y, x = np.nonzero(self.solid)
        every = max(len(x) // _POINTS, 1)
        return self._placed(x[::every], y[::every])

    def outline(self) -> Matrix:
        """Return the outermost pixels of some of its rows, the first and the last among them, (N, 2), canvas px."""
        rows = np.flatnonzero(self.solid.any(axis=1))
        rows = np.append(rows[:: max(len(rows) // _OUTLINE_ROWS, 1)], rows[-1])
        solid = self.solid[rows]
        left = solid.argmax(axis=1)
        right = solid.shape[1] - 1 - solid[:, ::-1].argmax(axis=1)
        return np.concatenate([self._placed(left, rows), self._placed(right, rows)])

    def covers(self, points: Matrix) -> NDArray[np.bool_]:
        """Return for canvas points (N, 2) whether the figure lies on them."""
        x, y = np.floor(points - self.offset).astype(np.int64).T
        height, width = self.solid.shape
        inside = (x >= 0) & (x < width) & (y >= 0) & (y < height)
        covered = np.zeros(len(points), dtype=np.bool_)
        covered[inside] = self.solid[y[inside], x[inside]]
        return covered

    def _middle_of_row(self, index: int, edge: float) -> Point2:
        row = int(np.flatnonzero(self.solid.any(axis=1))[index])
        middle = float(np.flatnonzero(self.solid[row]).mean()) + 0.5
        return (self.offset[0] + middle, self.offset[1] + row + edge)

    def _placed(self, x: NDArray[np.int64], y: NDArray[np.int64]) -> Matrix:
        return np.column_stack([x, y]) + (np.asarray(self.offset) + 0.5)


def figure_in(source: PictureSource, canvas: Box) -> Figure | None:
    """Return the figure of the drawing from ``source``, or None where nothing in it is solid.

    Raises
    ------
    InputProblem
        The drawing cannot be read.
    """
    alpha = read_matte(source).whole()
    solid = alpha > np.iinfo(alpha.dtype).max // 2
    height, width = solid.shape
    return Figure(solid, centred_offset(canvas, width, height)) if solid.any() else None


@dataclass(frozen=True, slots=True, eq=False)
class MeasuredFigure:
    """What was seen of a layer's drawings.

    Parameters
    ----------
    figure
        Of the first drawing that has one; None where none of those looked at has.
    later
        Points on the outlines of a few other figures spread over the drawings, (N, 2) float64, canvas px.
    boxes
        Around all of these figures in the order of the drawings, canvas px.
    notes
        What could not be read, one sentence each.
    """

    figure: Figure | None
    later: Matrix
    boxes: tuple[Box, ...]
    notes: tuple[Message, ...]


def measured_figure(drawings: Sequence[Drawing], canvas: Box, progress: Progress = no_progress) -> MeasuredFigure:
    """Return the figure of the first drawing that has one, and where the figure goes later."""
    notes: list[Message] = []
    first: Figure | None = None
    seen = 0
    for drawing in drawings:
        progress(LoadPhase.MEASURING, 0, LATER_DRAWINGS + 1)
        seen += 1
        first = _tried(drawing, canvas, notes)
        if first is not None:
            break
    chosen = _spread(drawings[seen:])
    tried = []
    for index, drawing in enumerate(chosen):
        progress(LoadPhase.MEASURING, index + 1, len(chosen) + 1)
        tried.append(_tried(drawing, canvas, notes))
    others = [figure for figure in tried if figure is not None]
    later = np.concatenate([figure.outline() for figure in others]) if others else np.empty((0, 2))
    boxes = tuple(figure.box for figure in (first, *others) if figure is not None)
    return MeasuredFigure(first, later, boxes, tuple(notes))


def _spread(drawings: Sequence[Drawing]) -> list[Drawing]:
    """Return a few drawings evenly spread over all of them, the last one among them."""
    count = min(LATER_DRAWINGS, len(drawings))
    return [drawings[(each + 1) * len(drawings) // count - 1] for each in range(count)]


def _tried(drawing: Drawing, canvas: Box, notes: list[Message]) -> Figure | None:
    try:
        return figure_in(drawing.source, canvas)
    except InputProblem as problem:
        notes.append(problem.message)
        return None
