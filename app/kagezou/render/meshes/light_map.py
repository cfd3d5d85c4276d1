"""What a light sees of the meshes: a map fitted to what is both in the picture and in their shadow."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

import numpy as np

from kagezou.geometry.ground import Plane, world_from_canvas_on
from kagezou.geometry.polygon import box_polygon
from kagezou.geometry.vectors import Matrix, Vector4
from kagezou.render.gpu.program import Variants
from kagezou.render.gpu.targets import DeepTarget, Format, Texture
from kagezou.render.meshes.eye_view import MAP_UNIT, TRIANGLES_UNIT, MeshView
from kagezou.render.prepare.mask_tiles import Flags
from kagezou.render.prepare.uniforms import Uniform
from kagezou.scene.pieces import PieceScene

_STEP_PX: Final = 512
_LARGEST_PX: Final = 2048
"""A map has as many texels a side as the canvas has px, in such steps and up to there: edges are finer than them."""

_KEPT_MAPS = 4
"""As many as an overhead light has lamps."""

_WIDEST = 8.0
"""The tangent of the widest angle from its middle that a lamp's map shows."""

_NEAREST = 0.02
"""What is nearer to a lamp than this part of the distance of what it lights is cut off."""


@dataclass(frozen=True, slots=True, eq=False)
class LightWindow:
    """The light's own axes and the window its map shows.

    Parameters
    ----------
    light
        Homogeneous, (4,), around the origin of the meshes.
    axes
        (3, 3), rows: across, up, away from the light.
    centre, half
        The window in light space: for a lamp in parts of the distance, for the sun in px.
    near, far
        The distances kept, px.
    """

    light: Matrix
    axes: Matrix
    centre: Matrix
    half: Matrix
    near: float
    far: float

    def may_hold(self, points: Matrix) -> Flags:
        """Return which of the hulls of points (K, 3, N) may lie in the window."""
        flat, away = _flat(self.axes, self.light, points.transpose(0, 2, 1).reshape(-1, 3))
        flat = flat.reshape(len(points), -1, 2)
        is_beside = (away.reshape(len(points), -1) <= 0).any(axis=0) if self.light[3] else False
        low, high = flat.min(axis=0) - self.centre, flat.max(axis=0) - self.centre
        return np.asarray(is_beside | ((low < self.half) & (high > -self.half)).all(axis=1))

    def clip_rows(self) -> tuple[Matrix, Matrix]:
        """Return the (4, 4) map from places to clip space, and the form (4,) of the distance."""
        axes = np.column_stack([self.axes, -self.axes @ self.light[:3] * self.light[3]])
        away = axes[2]
        one = np.array([0.0, 0.0, 0.0, 1.0])
        near, far = self.near, self.far
        if self.light[3] == 0:
            w, depth = one, (2 * away - (near + far) * one) / (far - near)
        else:
            w, depth = away, ((far + near) * away - 2 * far * near * one) / (far - near)
        across = [(axes[k] - self.centre[k] * w) / self.half[k] for k in (0, 1)]
        return np.array([*across, depth, w]), away

    @staticmethod
    def around(light: Matrix, receivers: Matrix, ground: Matrix | None, casters: Matrix) -> "LightWindow | None":
        """Return the window that holds what casters (N, 3) throw on receivers (M, 3); None where they throw nothing.

        Parameters
        ----------
        light
            (4,).
        ground
            (K, 3): more receivers; None for endless ones.
        """
        axes = _axes(light, receivers if len(receivers) else casters)
        thrown, distances = _flat(axes, light, casters)
        before = distances > (0.0 if light[3] else -np.inf)
        if not before.any():
            return None
        low, high = np.full(2, -_WIDEST if light[3] else -np.inf), np.full(2, _WIDEST if light[3] else np.inf)
        if before.all():
            low, high = np.maximum(low, thrown.min(axis=0)), np.minimum(high, thrown.max(axis=0))
        if ground is not None and len(receivers) + len(ground):
            lit, away = _flat(axes, light, np.concatenate([receivers, ground]))
            if not light[3] or (away > 0).all():
                low, high = np.maximum(low, lit.min(axis=0)), np.minimum(high, lit.max(axis=0))
        if not (low < high).all():
            return None
        least, most = float(distances[before].min()), float(distances[before].max())
        if light[3]:
            least = max(least * 0.99, _NEAREST * most)
        reach = max(most - least, 1.0)
        return LightWindow(
            light=light,
            axes=axes,
            centre=(low + high) / 2,
            half=(high - low) / 2 * 1.002 + 1e-6,
            near=least if light[3] else least - 0.001 * reach,
            far=most + 0.001 * reach,
        )


@dataclass(frozen=True, slots=True, eq=False)
class LightMap:
    """A window and what is seen in it."""

    window: LightWindow
    texture: Texture

    def uniforms(self, origin: Matrix) -> dict[str, Uniform]:
        """Return what ``meshes/light.glsl`` wants, for places around a point (3,) told around the meshes' origin."""
        window = self.window
        return {
            "u_map": MAP_UNIT,
            "u_triangles": TRIANGLES_UNIT,
            "u_map_side": self.texture.width_px,
            "u_map_axes": window.axes,
            "u_map_window": np.concatenate([window.centre, window.half]),
            "u_map_light": window.light,
            "u_map_shift": origin,
        }


@dataclass(frozen=True, slots=True)
class Surroundings:
    """What else the shadow of the meshes may be seen on.

    Parameters
    ----------
    ground
        Where that is shown; None for nowhere.
    is_endless
        Whether there are other pieces.
    """

    ground: Plane | None
    is_endless: bool

    def points(self, view: MeshView) -> Matrix | None:
        """Return points (N, 3) around it all, about the origin of the meshes; None where there is no end of it."""
        if self.is_endless:
            return None
        if self.ground is None:
            return np.zeros((0, 3))
        lift = world_from_canvas_on(view.camera, self.ground)
        if lift is None:
            return np.zeros((0, 3))
        seen = lift @ np.column_stack([box_polygon(view.canvas), np.ones(4)]).T
        if not (seen[3] > 1e-9 * np.abs(lift).max()).all():
            return None
        return np.asarray((seen[:3] / seen[3]).T - view.on_gpu.origin)


@dataclass(frozen=True, slots=True, eq=False)
class _Kept:
    view: MeshView
    what: tuple[Vector4, Surroundings, tuple[bool, ...]]
    found: LightMap | None
    target: DeepTarget | None


class LightMaps:
    """Draws the maps of lights; the last few are kept."""

    def __init__(self) -> None:
        self._programs = Variants("meshes/triangle.vert", "meshes/map.frag")
        self._kept: list[_Kept] = []
        self._spare: list[DeepTarget] = []
        self.maps_drawn = 0

    def close(self) -> None:
        """Give the memory back."""
        self.forget()
        self._programs.close()

    def forget(self) -> None:
        """Give back what is kept."""
        for target in (*(kept.target for kept in self._kept), *self._spare):
            if target is not None:
                target.close()
        self._kept.clear()
        self._spare.clear()

    def map_of(
        self, view: MeshView, light: Vector4, around: Surroundings, wanted: Callable[[PieceScene], bool]
    ) -> LightMap | None:
        """Return what a light sees of the meshes of the wanted pieces; None where they take nothing of it.

        Parameters
        ----------
        view, around
            The meshes and what is seen of them, and what else their shadow may be seen on.
        light
            Homogeneous, world px.
        wanted
            Which pieces.
        """
        what = (light, around, tuple(wanted(each.piece) for each in view.on_gpu.placed))
        for index, kept in enumerate(self._kept):
            if kept.view is view and kept.what == what:
                self._kept.append(self._kept.pop(index))
                return kept.found
        window = None
        if any(what[2]):
            casters = view.on_gpu.places_of(wanted)
            window = LightWindow.around(view.local(np.array(light)), view.blocks, around.points(view), casters)
        if window is None:
            self._keep(_Kept(view, what, None, None))
            return None
        target = self._free_target(view)
        self._draw(view, window, target, wanted)
        self._keep(_Kept(view, what, LightMap(window, target.texture), target))
        return self._kept[-1].found

    def _keep(self, kept: _Kept) -> None:
        self._kept.append(kept)

    def _free_target(self, view: MeshView) -> DeepTarget:
        """Return a target to draw in; maps of other views and the least lately used go for it."""
        for kept in [each for each in self._kept if each.view is not view] + self._kept[: 1 - _KEPT_MAPS]:
            if kept in self._kept:
                self._kept.remove(kept)
                self._spare += [] if kept.target is None else [kept.target]
        side = min(-(-max(view.canvas.width, view.canvas.height) // _STEP_PX) * _STEP_PX, _LARGEST_PX)
        while self._spare:
            target = self._spare.pop()
            if target.box.width == side:
                return target
            target.close()
        return DeepTarget(side, side, Format.FLOAT2)

    def _draw(
        self, view: MeshView, window: LightWindow, target: DeepTarget, wanted: Callable[[PieceScene], bool]
    ) -> None:
        target.begin()
        rows, away = window.clip_rows()
        program = self._programs[frozenset({"AWAY"})]
        program.use({"u_clip_rows": rows, "u_away": away})
        view.on_gpu.draw(program, wanted)
        self.maps_drawn += 1


def _axes(light: Matrix, points: Matrix) -> Matrix:
    """Return the light's axes (3, 3), the last one toward the middle of points as the light sees them."""
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
    return np.array([across, np.cross(away, across), away])


def _flat(axes: Matrix, light: Matrix, points: Matrix) -> tuple[Matrix, Matrix]:
    seen = (points - light[:3] * light[3]) @ axes.T
    if light[3] == 0:
        return seen[:, :2], seen[:, 2]
    # What lies beside or behind the lamp is as far out as can be.
    return seen[:, :2] / np.maximum(seen[:, 2:], 1e-3), seen[:, 2]
