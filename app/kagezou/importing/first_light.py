"""Where a lamp is put so that a new project shows a good shadow at once.

A good shadow lies wholly on the canvas, behind the figure and beside it; and the lamp can be reached with the mouse.
Candidates are made from the shadow that is wanted: a lamp that throws the head's shadow onto a point of the ground
stands on the line from that point through the head. Each is then judged by the true geometry.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import product
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera
from kagezou.geometry.card import vertical_piece
from kagezou.geometry.ground import Plane, place_on
from kagezou.geometry.light import is_over, lamp
from kagezou.geometry.shadow import cast_on
from kagezou.geometry.vectors import Matrix, Vector3
from kagezou.importing.figures import Figure

_RISE = (0.5, 0.4, 0.6, 0.3, 0.7, 0.2)
"""How far up the screen from the foot the head's shadow may fall, in figure heights."""

_ASIDE = (0.6, -0.6, 0.75, -0.75, 0.45, -0.45, 0.3, -0.3, 0.9, -0.9, 0.2, -0.2, 0.1, -0.1)
"""How far to the side of the head its shadow may fall, in figure heights."""

_REACH = (2.5, 2.0, 3.0, 4.0, 6.0, 1.7, 10.0)
"""How far the lamp may be from the head's shadow, as a multiple of the head's own distance from it."""

_ENOUGH = 0.35
_LITTLE = 0.1
_MARGIN_OF_CANVAS = 0.005

_CARD = vertical_piece((0.0, 0.0), 0.0)
"""Characters that were just brought in stand in the plane of the canvas."""


class _Verdict(NamedTuple):
    """How good a lamp is; the first difference decides.

    Parameters
    ----------
    whole
        Whether the shadow lies wholly on the canvas and some of it is seen.
    plain
        Whether it is whole and much of it is seen.
    lasting
        Whether it is whole also where the figure goes later.
    near
        2 where the lamp can be grasped beside the figure, 1 where the view must be zoomed out for it, 0 beyond.
    visible
        The part of the shadow that is seen; counts only where it is little.
    """

    whole: bool
    plain: bool
    lasting: bool
    near: int
    visible: float


_BEST = _Verdict(whole=True, plain=True, lasting=True, near=2, visible=1.0)


@dataclass(frozen=True, slots=True, eq=False)
class _LampTrial:
    """What lamps are judged on; points are (N, 2), canvas px.

    Parameters
    ----------
    outline, filling
        Of all the first figures.
    later
        Of where they go.
    """

    canvas: Box
    camera: Camera
    ground: Plane
    figures: tuple[Figure, ...]
    outline: Matrix
    filling: Matrix
    later: Matrix

    @property
    def inner(self) -> Box:
        """The canvas without a narrow margin."""
        return self.canvas.grown(-1 - round(_MARGIN_OF_CANVAS * min(self.canvas.width, self.canvas.height)))


def first_light(canvas: Box, camera: Camera, ground: Plane, figures: Sequence[Figure], later: Matrix) -> Vector3:
    """Return where to put a lamp whose shadow of the figures is good, whole px of the world.

    Parameters
    ----------
    canvas, camera, ground
        Where the figures stand.
    figures
        Of the first drawings, at least one.
    later
        Points (N, 2) on the outlines of later figures, canvas px.
    """
    outline = np.concatenate([figure.outline() for figure in figures])
    filling = np.concatenate([figure.points() for figure in figures])
    trial = _LampTrial(canvas, camera, ground, tuple(figures), outline, filling, later)
    main = max(figures, key=lambda figure: figure.box.height)
    best, best_place = None, _overhead(main)
    for place in _candidates(trial, main):
        verdict = _verdict(trial, place)
        if best is None or verdict > best:
            best, best_place = verdict, place
        if verdict == _BEST:
            break
    return best_place


def _candidates(trial: _LampTrial, main: Figure) -> Iterator[Vector3]:
    """Yield lamps, the most usual first: of equally good ones the first is taken."""
    head, foot, height = main.head, main.foot, main.box.height
    for rise, aside, reach in product(_RISE, _ASIDE, _REACH):
        fallen = place_on(trial.camera, trial.ground, (head[0] + aside * height, foot[1] - rise * height))
        if fallen is None:
            continue
        x, y, z = (float(round(g + reach * (p - g))) for g, p in zip(fallen, (*head, 0.0), strict=True))
        if z >= 1 and is_over(trial.ground, lamp((x, y, z))):
            yield (x, y, z)


def _overhead(main: Figure) -> Vector3:
    """Return a lamp for a ground that no candidate can light, such as one seen edge-on."""
    x, y = main.head
    return (float(round(x)), float(round(y - main.box.height)), float(main.box.height))


def _verdict(trial: _LampTrial, place: Vector3) -> _Verdict:
    filling = _shadow(trial, place, trial.filling)
    seen = _within(trial.canvas, filling)
    for figure in trial.figures:
        seen &= ~figure.covers(filling)
    visible = float(seen.mean())
    whole = visible >= _LITTLE and bool(_within(trial.inner, _shadow(trial, place, trial.outline)).all())
    return _Verdict(
        whole=whole,
        plain=whole and visible >= _ENOUGH,
        lasting=whole and bool(_within(trial.inner, _shadow(trial, place, trial.later)).all()),
        near=_nearness(trial.canvas, place),
        visible=1.0 if whole and visible >= _ENOUGH else visible,
    )


def _shadow(trial: _LampTrial, place: Vector3, points: Matrix) -> Matrix:
    """Return where the shadows of drawing points (N, 2) fall, canvas px; far off for those that fall nowhere."""
    cast = cast_on(trial.camera, trial.ground, _CARD, lamp(place))
    if cast is None:
        return np.full_like(points, -1e9)
    homogeneous = np.column_stack([points, np.ones(len(points))]) @ np.linalg.inv(cast.art_from_canvas).T
    scale = np.abs(homogeneous).max(axis=1) * 1e-9
    falls = homogeneous[:, 2] > scale
    w = np.where(falls, homogeneous[:, 2], 1.0)
    return np.where(falls[:, None], homogeneous[:, :2] / w[:, None], -1e9)


def _within(box: Box, points: Matrix) -> NDArray[np.bool_]:
    x, y = points[:, 0], points[:, 1]
    return np.asarray((x >= box.left) & (x < box.right) & (y >= box.top) & (y < box.bottom))


def _nearness(canvas: Box, place: Vector3) -> int:
    across = (place[0] - canvas.left) / canvas.width
    down = (place[1] - canvas.top) / canvas.height
    if -0.05 <= across <= 1.05 and -0.2 <= down <= 0.6:
        return 2
    return 1 if -1 <= across <= 2 and -1 <= down <= 1 else 0
