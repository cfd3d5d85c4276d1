"""What of a light's view is worth a map: windows fitted to what is seen, takes its light, and is asked about at all."""

from dataclasses import dataclass
from math import ceil
from typing import Final

import numpy as np

from kagezou.geometry.box import Box
from kagezou.geometry.vectors import Matrix
from kagezou.render.prepare.mask_tiles import Flags

WIDEST: Final = 2.0
"""The tangent of the widest angle from its middle that one window of a lamp shows; what is wider takes a cube."""

FACES: Final = 6

_TURNS: Final = ((0, 1, 2), (1, 2, 0), (2, 0, 1))
"""Which of the light's axes are those of a face of the cube, as ``on_face`` of ``meshes/light.glsl`` has it."""

_NEAREST: Final = 0.002
"""What is nearer to a lamp than this part of the distance of the farthest triangle is cut off."""

_TEXEL_PX: Final = 1.5
"""A texel is so wide where the window is farthest away: edges are finer, only what is thinner may be missed."""

_STEP_TEXELS = 64
_MOST_TEXELS = 4 << 20
"""Of all faces together: with more, they are all as much coarser."""

_LEAST_TEXELS = 512
"""Of the longer side of a window: narrow triangles near the light cost little."""

_WIDEST_FACE_TEXELS = 1024
"""Six beside each other are no wider than the textures of any driver."""

_RIM = 1.002
"""So much larger is a window than what it holds."""


@dataclass(frozen=True, slots=True, eq=False)
class LightAxes:
    """A light and the axes along which a window shows what it sees.

    Parameters
    ----------
    light
        Homogeneous, (4,).
    rows
        (3, 3): across, up, away from the light.
    """

    light: Matrix
    rows: Matrix

    @staticmethod
    def toward(light: Matrix, points: Matrix) -> "LightAxes":
        """Return the axes whose last one points at the middle of points (N, 3) as the light sees them."""
        if light[3]:
            toward = points - light[:3]
            away = (toward / np.maximum(np.linalg.norm(toward, axis=1, keepdims=True), 1e-9)).mean(axis=0)
        else:
            away = -light[:3]
        length = float(np.linalg.norm(away))
        away = away / length if length > 1e-6 else np.array([0.0, 0.0, -1.0])
        helper = np.array([1.0, 0.0, 0.0]) if abs(away[0]) < 0.9 else np.array([0.0, 1.0, 0.0])
        across = np.cross(helper, away)
        across /= np.linalg.norm(across)
        return LightAxes(light, np.array([across, np.cross(away, across), away]))

    def face(self, number: int) -> "LightAxes":
        """Return the axes of a face of the cube around a lamp: away, back, right, left, up, down."""
        rows = self.rows[list(_TURNS[number // 2])]
        return LightAxes(self.light, rows * [[1.0], [1.0], [1.0 if number % 2 == 0 else -1.0]])

    def bounds(self, hulls: Matrix) -> "_Bounds":
        """Return the bounds of hulls (K, 3, N)."""
        count = hulls.shape[2]
        points = hulls.transpose(1, 0, 2).reshape(3, -1) - (self.light[:3] * self.light[3])[:, np.newaxis]
        x, y, away = self.rows @ points
        places = np.array([x, y, away]).reshape(3, -1, count)
        if self.light[3]:
            # What lies beside or behind the lamp has no place there.
            is_before = away > 1e-3
            x, y = x / np.where(is_before, away, 1.0), y / np.where(is_before, away, 1.0)
            before = is_before.reshape(-1, count)
        else:
            before = np.ones((len(hulls), count), bool)
        flat, away = np.array([x, y]).reshape(2, -1, count), places[2]
        low, high = flat.min(axis=1), flat.max(axis=1)
        is_whole, is_beside = before.all(axis=0), ~before.any(axis=0)
        low[:, ~is_whole], high[:, ~is_whole] = -np.inf, np.inf
        low[:, is_beside], high[:, is_beside] = np.inf, -np.inf
        return _Bounds(low, high, away.min(axis=0), away.max(axis=0), is_whole, places if self.light[3] else None)


@dataclass(frozen=True, slots=True, eq=False)
class _Bounds:
    """Where N hulls lie: ``low`` and ``high`` (2, N) across and up, ``near`` and ``far`` (N,), and whether before.

    ``places`` (3, K, N) are those of the corners of hulls before a lamp, beside it or behind it.
    """

    low: Matrix
    high: Matrix
    near: Matrix
    far: Matrix
    is_before: Flags
    places: Matrix | None

    def touching(self, low: Matrix, high: Matrix) -> Flags:
        """Return which hulls may lie in a rectangle, from ``low`` (2,) to ``high`` (2,)."""
        may = ((high >= self.low.T) & (low <= self.high.T)).all(axis=1)
        if self.places is not None:
            # What is partly before the lamp has no bounds, but a side of the rectangle may still be beyond it.
            for axis in (0, 1):
                across, away = self.places[axis], self.places[2]
                is_beyond = (across > high[axis] * away).all(axis=0) | (across < low[axis] * away).all(axis=0)
                may &= ~is_beyond
        return np.asarray(may)


@dataclass(frozen=True, slots=True, eq=False)
class LightCone:
    """A rectangle of what a light sees, ``low`` (2,) to ``high`` (2,): for a lamp in parts of the distance, else px."""

    axes: LightAxes
    low: Matrix
    high: Matrix

    @staticmethod
    def around(light: Matrix, hulls: Matrix, margin: float = 0.0) -> "LightCone | None":
        """Return the cone around hulls (K, 3, N), wider by a part of its width; None where no window is as wide."""
        points = hulls.transpose(0, 2, 1).reshape(-1, 3)
        if len(points) == 0:
            return None
        axes = LightAxes.toward(light, points)
        bounds = axes.bounds(hulls)
        low, high = bounds.low.min(axis=1), bounds.high.max(axis=1)
        grown = margin * float((high - low).max()) if bounds.is_before.all() else 0.0
        low, high = low - grown, high + grown
        if light[3] and not (bounds.is_before.all() and max(-low.min(), high.max()) <= WIDEST):
            return None
        return LightCone(axes, low, high)

    def holds(self, hulls: Matrix) -> bool:
        """Whether hulls (K, 3, N) lie within."""
        bounds = self.axes.bounds(hulls)
        is_within = (self.low <= bounds.low.T).all() and (self.high >= bounds.high.T).all()
        return bool(is_within and bounds.is_before.all())


@dataclass(frozen=True, slots=True, eq=False)
class LightWindow:
    """The part of what a light sees that a map shows.

    Parameters
    ----------
    axes
        The light, around the origin of the meshes, and its axes.
    centre, half
        The window: for a lamp in parts of the distance, for the sun in px.
    near, far
        The distances kept, px.
    """

    axes: LightAxes
    centre: Matrix
    half: Matrix
    near: float
    far: float

    def may_hold(self, points: Matrix) -> Flags:
        """Return which of the hulls of points (K, 3, N) may lie in the window."""
        return self.axes.bounds(points).touching(self.centre - self.half, self.centre + self.half)

    def clip_rows(self) -> tuple[Matrix, Matrix]:
        """Return the (4, 4) map from places to clip space, and the form (4,) of the distance."""
        light = self.axes.light
        axes = np.column_stack([self.axes.rows, -self.axes.rows @ light[:3] * light[3]])
        away = axes[2]
        one = np.array([0.0, 0.0, 0.0, 1.0])
        near, far = self.near, self.far
        if light[3] == 0:
            w, depth = one, (2 * away - (near + far) * one) / (far - near)
        else:
            w, depth = away, ((far + near) * away - 2 * far * near * one) / (far - near)
        across = [(axes[k] - self.centre[k] * w) / self.half[k] for k in (0, 1)]
        return np.array([*across, depth, w]), away

    def size_texels(self, least: int, most: int) -> tuple[int, int]:
        """Return how many texels a map of it has, each way; the longer side has ``least`` and ``most`` at most."""
        sides = 2 * self.half * (self.far if self.axes.light[3] else 1.0) / _TEXEL_PX
        longer = float(sides.max())
        sides = sides * (min(max(longer, least), most) / longer)
        width, height = (min(ceil(side / _STEP_TEXELS) * _STEP_TEXELS, most) for side in sides.tolist())
        return width, height

    @staticmethod
    def fitted(cone: LightCone, receivers: Matrix | None, casters: Matrix) -> "LightWindow | None":
        """Return the window within a cone that holds what casters throw on receivers; None where they throw nothing.

        Parameters
        ----------
        receivers
            Hulls (K, 3, N); None for endless ones.
        casters
            Hulls (K, 3, N).
        """
        low, high, axes = cone.low, cone.high, cone.axes
        near, far = 0.0, 0.0
        for hulls in (receivers, casters):
            if hulls is None:
                continue
            bounds = axes.bounds(hulls)
            held = bounds.touching(low, high)
            if not held.any():
                return None
            low = np.maximum(low, bounds.low[:, held].min(axis=1))
            high = np.minimum(high, bounds.high[:, held].max(axis=1))
            near, far = float(bounds.near[held].min()), float(bounds.far[held].max())
        if not (low < high).all():
            return None
        if axes.light[3]:
            near = max(near * 0.99, _NEAREST * far)
        reach = max(far - near, 1.0)
        return LightWindow(
            axes=axes,
            centre=(low + high) / 2,
            half=(high - low) / 2 * _RIM + 1e-6,
            near=near if axes.light[3] else near - 0.001 * reach,
            far=far + 0.001 * reach,
        )


@dataclass(frozen=True, slots=True, eq=False)
class LightWindows:
    """All windows of a light: one, or those on the faces of a cube around a lamp that stands among what it lights.

    Parameters
    ----------
    axes
        The light's, of which those of the faces are made.
    faces
        One, or FACES; None for those on which nothing is thrown.
    """

    axes: LightAxes
    faces: tuple[LightWindow | None, ...]

    @staticmethod
    def of(light: Matrix, asked: LightCone | None, receivers: Matrix | None, casters: Matrix) -> "LightWindows | None":
        """Return the windows that hold what casters throw on receivers; None where they throw nothing.

        Parameters
        ----------
        asked
            What is asked about; None for everything.
        receivers, casters
            Hulls (K, 3, N); receivers are None where they are endless.
        """
        about = casters if receivers is None or receivers.shape[2] == 0 else receivers
        cone = asked or LightCone.around(light, about) or LightCone.around(light, casters)
        if cone is not None:
            found = LightWindow.fitted(cone, receivers, casters)
            return None if found is None else LightWindows(cone.axes, (found,))
        axes, most = LightAxes.toward(light, about.transpose(0, 2, 1).reshape(-1, 3)), np.ones(2)
        cones = [LightCone(axes.face(number), -most, most) for number in range(FACES)]
        faces = tuple(LightWindow.fitted(each, receivers, casters) for each in cones)
        return None if not any(faces) else LightWindows(axes, faces)

    def may_hold(self, points: Matrix) -> Flags:
        """Return which of the hulls of points (K, 3, N) may lie in one of the windows."""
        return np.asarray(np.logical_or.reduce([each.may_hold(points) for each in self.faces if each is not None]))

    def boxes(self, most: int, *, are_fine: bool) -> tuple[Box, ...]:
        """Return where in one map each face lies, none wider than ``most`` texels; empty for one without a window.

        Parameters
        ----------
        are_fine
            Whether one alone is as wide as that, however little it shows.
        """
        widest = most if len(self.faces) == 1 else min(most, _WIDEST_FACE_TEXELS)
        least = most if are_fine and len(self.faces) == 1 else _LEAST_TEXELS
        sizes = [(0, 0) if each is None else each.size_texels(least, widest) for each in self.faces]
        shrunk = min(1.0, float(np.sqrt(_MOST_TEXELS / sum(width * height for width, height in sizes))))
        found: list[Box] = []
        left = 0
        for width, height in sizes:
            right = left + ceil(width * shrunk / _STEP_TEXELS) * _STEP_TEXELS
            found.append(Box(left, 0, right, ceil(height * shrunk / _STEP_TEXELS) * _STEP_TEXELS))
            left = right
        return tuple(found)
