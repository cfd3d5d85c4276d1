"""How well a set piece catches shadows: rays through the picture, onto the piece and on toward the light.

Figures are coarse silhouettes, or the ellipses within their boxes where nothing is known of their pixels. So this is an
estimate, good enough to tell a readable shadow from scraps.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from kagezou.document.model import Document
from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera
from kagezou.geometry.card import Card, CardPiece
from kagezou.geometry.sets.bodies import Body
from kagezou.geometry.sets.ways import ENDLESS_PX, way_within, ways_to
from kagezou.geometry.vectors import Matrix, Vector4
from kagezou.io.pixels.connected import part_areas
from kagezou.tools.frame_geometry import FrameGeometry
from kagezou.tools.view import CanvasView

_CELLS: Final = 44
"""Into how many cells the longer side of a piece's picture is cut."""

_TOUCH_PX: Final = 0.05
"""A way that lies within a body for less only touches it."""

_LEAST_PART: Final = 0.01
"""A part of the shadow smaller than this part of the piece's picture does not count as one."""

Flags = NDArray[np.bool_]

_ACROSS: Final = (2 * np.arange(64) + 1) / 64 - 1
_ELLIPSE: Final[Flags] = np.hypot(_ACROSS, _ACROSS[:, None]) <= 1
"""A figure of which nothing is known but its box."""


@dataclass(frozen=True, slots=True, eq=False)
class Caster:
    """A figure by the layer it belongs to.

    Parameters
    ----------
    layer_id
        Which figure.
    card, box
        What it stands on, and around its picture, canvas px.
    shape
        Which cells (rows, columns) of the box it fills.
    """

    layer_id: str
    card: Card
    box: Box
    shape: Flags

    def covers(self, x: Matrix, y: Matrix) -> Flags:
        """Whether canvas points (N,) lie on the figure."""
        rows, columns = self.shape.shape
        column = np.floor((x - self.box.left) / self.box.width * columns)
        row = np.floor((y - self.box.top) / self.box.height * rows)
        inside = (column >= 0) & (column < columns) & (row >= 0) & (row < rows)
        covered = np.zeros(len(x), np.bool_)
        covered[inside] = self.shape[row[inside].astype(np.intp), column[inside].astype(np.intp)]
        return covered

    @property
    def area_px(self) -> float:
        """The area of the figure, canvas px²."""
        return float(self.shape.mean()) * self.box.width * self.box.height


@dataclass(frozen=True, slots=True)
class Catch:
    """What a piece catches on a frame.

    Parameters
    ----------
    shown
        Which part of its picture no figure covers.
    part
        Which part of what is seen and lit of it lies in shadow.
    area_px
        The shadow's area, canvas px².
    parts
        In how many parts it falls apart, tiny ones left out.
    """

    shown: float
    part: float
    area_px: float
    parts: int


def casters_of(document: Document, frame: int, shapes: Mapping[str, Flags]) -> tuple[Caster, ...]:
    """Return the figures that are shown on a frame; ``shapes`` are their silhouettes by the ids of their layers."""
    views = {
        layer.id: FrameGeometry.of(document, frame, layer.id, CanvasView())
        for layer in document.layers
        if layer.joins is None
    }
    return tuple(
        Caster(layer_id, view.card, view.figure_box, shapes.get(layer_id, _ELLIPSE))
        for layer_id, view in views.items()
        if view.card is not None and view.is_figure_shown and not view.figure_box.is_empty
    )


def catch_of(
    bodies: tuple[Body, ...], frame: Box, caster: Caster, others: tuple[Caster, ...], camera: Camera, light: Vector4
) -> Catch:
    """Return what closed bodies catch of a figure's shadow.

    Parameters
    ----------
    bodies
        The piece.
    frame
        Around its picture, canvas px.
    caster, others
        The figure, and all others: they too hide what is behind them in the picture.
    camera, light
        What it is seen with, and the light, homogeneous.
    """
    step = max(frame.width, frame.height, 1) / _CELLS
    x, y = np.meshgrid(
        np.arange(frame.left + step / 2, frame.right, step), np.arange(frame.top + step / 2, frame.bottom, step)
    )
    hits, found = _hits(bodies, camera, x.ravel(), y.ravel())
    covered = _any((each.covers(x.ravel(), y.ravel()) for each in (caster, *others)), x.size)
    seen = found & ~covered
    lit = seen & ~_is_behind(bodies, hits, light)
    dark = lit & _falls_on(caster, camera, light, hits)
    found_count, lit_count = int(found.sum()), int(lit.sum())
    least = _LEAST_PART * found_count
    return Catch(
        shown=int(seen.sum()) / max(found_count, 1),
        part=int(dark.sum()) / max(lit_count, 1),
        area_px=float(dark.sum()) * step * step,
        parts=int((part_areas(dark.reshape(x.shape), diagonal=False) > least).sum()),
    )


def _hits(bodies: tuple[Body, ...], camera: Camera, x: Matrix, y: Matrix) -> tuple[Matrix, Flags]:
    """Return where sight lines through canvas points meet bodies first, (N, 3), and which do."""
    eye, on_canvas = camera.eye, np.column_stack([x, y, np.zeros(len(x))])
    toward_eye, length = ways_to(eye, on_canvas)
    start = on_canvas + (length if eye[3] else np.zeros(len(x)))[:, None] * toward_eye
    ways, near = -toward_eye, np.full(len(x), np.inf)
    begin = np.full(len(x), 0.0 if eye[3] else -ENDLESS_PX)
    for body in bodies:
        enter, leave = way_within(body, start, ways, begin, np.full(len(x), ENDLESS_PX))
        near = np.where(leave > enter + _TOUCH_PX, np.minimum(near, enter), near)
    found: Flags = np.isfinite(near)
    return start + np.where(found, near, 0.0)[:, None] * ways, found


def _is_behind(bodies: tuple[Body, ...], points: Matrix, light: Vector4) -> Flags:
    """Whether the way from points to the light leads through the bodies."""
    ways, lengths = ways_to(light, points)
    spans = (way_within(body, points, ways, np.zeros(len(points)), lengths) for body in bodies)
    return _any((leave > enter + _TOUCH_PX for enter, leave in spans), len(points))


def _falls_on(caster: Caster, camera: Camera, light: Vector4, points: Matrix) -> Flags:
    """Whether a figure stands between points (N, 3) and the light."""
    ways, lengths = ways_to(light, points)
    pieces = (_crosses(caster, piece, camera, points, ways, lengths) for piece in caster.card.pieces)
    return _any(pieces, len(points))


def _crosses(caster: Caster, piece: CardPiece, camera: Camera, points: Matrix, ways: Matrix, lengths: Matrix) -> Flags:
    normal, offset = np.array(piece.plane[:3]), piece.plane[3]
    nearing = ways @ normal
    level = np.abs(nearing) < 1e-9
    far = -(points @ normal + offset) / np.where(level, 1.0, nearing)
    met = ~level & (far > _TOUCH_PX) & (far < lengths)
    at = points + np.where(met, far, 0.0)[:, None] * ways
    x, y, w = camera.canvas_from_world() @ np.column_stack([at, np.ones(len(at))]).T
    met &= w > 0
    x, y = (axis / np.where(met, w, 1.0) for axis in (x, y))
    for a, b, c in piece.limits:
        met &= a * x + b * y + c >= 0
    covered: Flags = met & caster.covers(x, y)
    return covered


def _any(flags: Iterable[Flags], count: int) -> Flags:
    """Return where any of some flags (N,) is set."""
    found = np.zeros(count, np.bool_)
    for each in flags:
        found |= each
    return found
