"""Which light a new project has, so that it shows a good shadow at once.

A good shadow lies wholly on the canvas, behind the figure and beside it; and a lamp can be reached with the mouse.
Candidates are made from the shadow that is wanted: a light that throws the head's shadow onto a point of the ground
stands on the line from that point through the head. Each is then judged by the true geometry.

The light is a lamp; it is the sun where figures travel so far that the lamp's shadows of them would swing round.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import product
from math import asin, atan2, degrees, hypot
from typing import Final, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera
from kagezou.geometry.card import vertical_piece
from kagezou.geometry.ground import Plane, place_on
from kagezou.geometry.light import is_over, lamp, sun
from kagezou.geometry.shadow import cast_on
from kagezou.geometry.vectors import Matrix, Point2, Vector3, Vector4, dot
from kagezou.importing.figures import Figure
from kagezou.importing.travel import Station, turn_of_shadows

_RISE = (0.5, 0.4, 0.6, 0.3, 0.7, 0.2)
"""How far up the screen from the foot the head's shadow may fall, in figure heights."""

_ASIDE = (0.6, -0.6, 0.75, -0.75, 0.45, -0.45, 0.3, -0.3, 0.9, -0.9, 0.2, -0.2, 0.1, -0.1)
"""How far to the side of the head its shadow may fall, in figure heights."""

_REACH = (2.5, 2.0, 3.0, 4.0, 6.0, 1.7, 10.0)
"""How far the lamp may be from the head's shadow, as a multiple of the head's own distance from it."""

MOST_TURN_DEG: Final = 20.0
"""By more than this the shadow of a lamp must not turn while its figure travels."""

_LOWEST_SUN_DEG = 10.0
_ENOUGH = 0.35
_LITTLE = 0.1
_MARGIN_OF_CANVAS = 0.005

_T = TypeVar("_T")

_CARD = vertical_piece((0.0, 0.0), 0.0)
"""Characters that were just brought in stand in the plane of the canvas."""


@dataclass(frozen=True, slots=True)
class FirstLight:
    """The light of a new project.

    Parameters
    ----------
    lamp
        Where a lamp stands, whole px of the world.
    sun
        Azimuth and elevation of the sun, whole degrees; None where the lamp is the light.
    """

    lamp: Vector3
    sun: Point2 | None = None


class _Verdict(NamedTuple):
    """How good a light is; the first difference decides.

    Parameters
    ----------
    whole
        Whether the shadow lies wholly on the canvas and some of it is seen.
    plain
        Whether it is whole and much of it is seen.
    lasting
        Whether it is whole also where the figure goes later.
    near
        2 where it can be grasped beside the figure, as the sun always can, 1 where the view must be zoomed out for a
        lamp, 0 beyond.
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
class _Trial:
    """What lights are judged on; points are (N, 2), canvas px.

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


def first_light(
    canvas: Box,
    camera: Camera,
    ground: Plane,
    figures: Sequence[Figure],
    later: Matrix,
    ways: Sequence[Sequence[Station]] = (),
) -> FirstLight:
    """Return a light whose shadow of the figures is good.

    Parameters
    ----------
    canvas, camera, ground
        Where the figures stand.
    figures
        Of the first drawings, at least one.
    later
        Points (N, 2) on the outlines of later figures, canvas px.
    ways
        The stations of each figure over the cut.
    """
    outline = np.concatenate([figure.outline() for figure in figures])
    filling = np.concatenate([figure.points() for figure in figures])
    trial = _Trial(canvas, camera, ground, tuple(figures), outline, filling, later)
    main = max(figures, key=lambda figure: figure.box.height)
    place = _best(trial, ((each, lamp(each)) for each in _lamps(trial, main))) or _overhead(main)
    if turn_of_shadows(camera, ground, lamp(place), ways) <= MOST_TURN_DEG:
        return FirstLight(place)
    suns = ((each, sun(ground, *each)) for each in _suns(trial, main))
    return FirstLight(place, _best(trial, suns))


def _best(trial: _Trial, candidates: Iterable[tuple[_T, Vector4]]) -> _T | None:
    """Return what stands for the best of some lights, the first of equally good ones; None where there are none."""
    best: tuple[_Verdict, _T] | None = None
    for each, light in candidates:
        verdict = _verdict(trial, light)
        if best is None or verdict > best[0]:
            best = verdict, each
        if verdict == _BEST:
            break
    return None if best is None else best[1]


def _lamps(trial: _Trial, main: Figure) -> Iterator[Vector3]:
    """Yield lamps, the most usual first."""
    for (rise, aside), reach in product(product(_RISE, _ASIDE), _REACH):
        fallen = _fallen(trial, main, rise, aside)
        if fallen is None:
            continue
        x, y, z = (float(round(g + reach * (p - g))) for g, p in zip(fallen, (*main.head, 0.0), strict=True))
        if z >= 1 and is_over(trial.ground, lamp((x, y, z))):
            yield (x, y, z)


def _suns(trial: _Trial, main: Figure) -> Iterator[Point2]:
    """Yield azimuths and elevations, the most usual first."""
    ground = trial.ground
    for rise, aside in product(_RISE, _ASIDE):
        fallen = _fallen(trial, main, rise, aside)
        if fallen is None:
            continue
        way = (main.head[0] - fallen[0], main.head[1] - fallen[1], -fallen[2])
        right, nearer, up = (dot(way, axis) for axis in (ground.u, ground.v, ground.normal))
        elevation = round(degrees(asin(up / hypot(*way))))
        if elevation >= _LOWEST_SUN_DEG:
            yield (float(round(degrees(atan2(right, nearer)))), float(elevation))


def _fallen(trial: _Trial, main: Figure, rise: float, aside: float) -> Vector3 | None:
    """Return the place on the ground where the head's shadow is wanted, so far beside and over the feet."""
    height = main.box.height
    return place_on(trial.camera, trial.ground, (main.head[0] + aside * height, main.foot[1] - rise * height))


def _overhead(main: Figure) -> Vector3:
    """Return a lamp for a ground that no candidate can light, such as one seen edge-on."""
    x, y = main.head
    return (float(round(x)), float(round(y - main.box.height)), float(main.box.height))


def _verdict(trial: _Trial, light: Vector4) -> _Verdict:
    filling = _shadow(trial, light, trial.filling)
    seen = _within(trial.canvas, filling)
    for figure in trial.figures:
        seen &= ~figure.covers(filling)
    visible = float(seen.mean())
    whole = visible >= _LITTLE and bool(_within(trial.inner, _shadow(trial, light, trial.outline)).all())
    return _Verdict(
        whole=whole,
        plain=whole and visible >= _ENOUGH,
        lasting=whole and bool(_within(trial.inner, _shadow(trial, light, trial.later)).all()),
        near=_nearness(trial.canvas, light),
        visible=1.0 if whole and visible >= _ENOUGH else visible,
    )


def _shadow(trial: _Trial, light: Vector4, points: Matrix) -> Matrix:
    """Return where the shadows of drawing points (N, 2) fall, canvas px; far off for those that fall nowhere."""
    cast = cast_on(trial.camera, trial.ground, _CARD, light)
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


def _nearness(canvas: Box, light: Vector4) -> int:
    x, y, _, w = light
    if w == 0:
        return 2
    across, down = (x - canvas.left) / canvas.width, (y - canvas.top) / canvas.height
    if -0.05 <= across <= 1.05 and -0.2 <= down <= 0.6:
        return 2
    return 1 if -1 <= across <= 2 and -1 <= down <= 1 else 0
