"""What a light sees of the meshes: a map fitted to what is seen, lies in their shadow and in that of a character."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

import numpy as np

from kagezou.geometry.box import Box
from kagezou.geometry.ground import Plane, world_from_canvas_on
from kagezou.geometry.polygon import box_polygon
from kagezou.geometry.vectors import Matrix, Vector4
from kagezou.render.gpu.gl import GL
from kagezou.render.gpu.program import Variants
from kagezou.render.gpu.targets import DeepTarget, Format
from kagezou.render.meshes.eye_view import MAP_UNIT, TRIANGLES_UNIT, MeshView
from kagezou.render.prepare.light_windows import LightCone, LightWindows
from kagezou.render.prepare.uniforms import Uniform
from kagezou.scene.pieces import PieceScene

_STEP_PX: Final = 512
_LARGEST_PX: Final = 2048
"""A map has no more texels a side than the canvas has px, in such steps and up to there: edges are finer than them."""

_KEPT_MAPS = 4
"""As many as an overhead light has lamps."""

_NOTHING = (0.0, 0.0, 1.0, 1.0)
"""The window of a face that has none."""

_MARGIN = 0.0625
"""So much wider than a character is the first map of a light, so that it may turn and step a little."""


@dataclass(frozen=True, slots=True, eq=False)
class LightMap:
    """Windows, and what is seen in them.

    Parameters
    ----------
    windows
        One, or those on the faces of a cube.
    boxes
        Where each lies in the target.
    target
        What is seen.
    """

    windows: LightWindows
    boxes: tuple[Box, ...]
    target: DeepTarget

    @property
    def switches(self) -> frozenset[str]:
        """The switches of ``meshes/light.glsl``."""
        return frozenset({"MESHES", "ALL_AROUND"} if len(self.boxes) > 1 else {"MESHES"})

    def uniforms(self, origin: Matrix) -> dict[str, Uniform]:
        """Return what ``meshes/light.glsl`` wants, for places around a point (3,) told around the meshes' origin."""
        axes = self.windows.axes
        windows = [_NOTHING if each is None else (*each.centre, *each.half) for each in self.windows.faces]
        return {
            "u_map": MAP_UNIT,
            "u_triangles": TRIANGLES_UNIT,
            "u_map_axes": axes.rows,
            "u_map_windows": np.array(windows),
            "u_map_boxes": np.array([(each.left, each.top, each.width, each.height) for each in self.boxes]),
            "u_map_light": axes.light,
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

    def hull(self, view: MeshView) -> Matrix | None:
        """Return a hull (8, 3, N) around it all, about the origin of the meshes; None where there is no end of it."""
        if self.is_endless:
            return None
        lift = None if self.ground is None else world_from_canvas_on(view.camera, self.ground)
        if lift is None:
            return np.zeros((8, 3, 0))
        seen = lift @ np.column_stack([box_polygon(view.canvas), np.ones(4)]).T
        if not (seen[3] > 1e-9 * np.abs(lift).max()).all():
            return None
        corners = (seen[:3] / seen[3]).T - view.on_gpu.origin
        return np.asarray(np.concatenate([corners, corners])[..., np.newaxis])


@dataclass(frozen=True, slots=True, eq=False)
class Taken:
    """Who takes the light, and of what.

    Parameters
    ----------
    by
        Which pieces take it.
    around
        World points (N, 3) around all that would be lit: what is beyond them is not asked about; None for everything.
    """

    by: Callable[[PieceScene], bool]
    around: Matrix | None = None

    def hull(self, view: MeshView) -> Matrix | None:
        """Return what would be lit as a hull (N, 3, 1), about the origin of the meshes."""
        return None if self.around is None else (self.around - view.on_gpu.origin)[..., np.newaxis]


@dataclass(slots=True, eq=False)
class _Kept:
    """A map and of whom it is.

    Parameters
    ----------
    first
        The cone of who asked first; None for everything.
    is_for_all
        Whether it shows more than that.
    has_others
        Whether somebody beyond the first cone has asked.
    """

    view: MeshView
    what: tuple[Vector4, Surroundings, tuple[bool, ...]]
    first: LightCone | None
    found: LightMap | None
    is_for_all: bool
    has_others: bool = False

    def answers(self, hull: Matrix | None) -> bool:
        """Whether it has all that is asked about."""
        is_first = self.first is not None and hull is not None and self.first.holds(hull)
        is_same = is_first or (self.first is None and hull is None)
        self.has_others = self.has_others or not is_same
        return is_first or self.is_for_all


class LightMaps:
    """Draws the maps of lights; the last few are kept.

    The first map of a light is fitted to the character it is asked about. Where another one is asked about then, the
    map is drawn once more for everything, and so at once for the lights that follow, until one has but one character.
    """

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
        for target in (*(kept.found.target for kept in self._kept if kept.found is not None), *self._spare):
            target.close()
        self._kept.clear()
        self._spare.clear()

    def map_of(self, view: MeshView, light: Vector4, around: Surroundings, taken: Taken) -> LightMap | None:
        """Return what a light sees of the meshes of those that take it; None where they take nothing.

        Parameters
        ----------
        view, around
            The meshes and what is seen of them, and what else their shadow may be seen on.
        light
            Homogeneous, world px.
        taken
            By whom, and of what.
        """
        what = (light, around, tuple(taken.by(each.piece) for each in view.on_gpu.placed))
        hull = taken.hull(view)
        for index, kept in enumerate(self._kept):
            if kept.view is view and kept.what == what:
                self._kept.append(self._kept.pop(index))
                if not kept.answers(hull):
                    self._let_go(self._kept.pop())
                    self._kept.append(self._made(view, what, kept.first, taken, is_for_all=True))
                    self._kept[-1].has_others = True
                return self._kept[-1].found
        lamp = view.local(np.array(light))
        first = None if hull is None else LightCone.around(lamp, hull, _MARGIN)
        likes = [kept for kept in self._kept if kept.view is view and kept.what[2] == what[2]]
        is_for_all = first is None or any(kept.has_others for kept in likes)
        self._kept.append(self._made(view, what, first, taken, is_for_all=is_for_all))
        return self._kept[-1].found

    def _made(
        self,
        view: MeshView,
        what: tuple[Vector4, Surroundings, tuple[bool, ...]],
        first: LightCone | None,
        taken: Taken,
        *,
        is_for_all: bool,
    ) -> _Kept:
        """Draw the map of a light, for a cone or for everything."""
        windows = None
        if any(what[2]):
            receivers = _with(view.blocks[:, :3], what[1].hull(view))
            asked = None if is_for_all else first
            windows = LightWindows.of(view.local(np.array(what[0])), asked, receivers, view.on_gpu.hulls_of(taken.by))
        found = None
        if windows is not None:
            most = min(-(-max(view.canvas.width, view.canvas.height) // _STEP_PX) * _STEP_PX, _LARGEST_PX)
            boxes = windows.boxes(most, are_fine=is_for_all)
            found = LightMap(windows, boxes, self._free_target(view, boxes))
            self._draw(view, found, taken.by)
        return _Kept(view, what, first, found, is_for_all)

    def _let_go(self, kept: _Kept) -> None:
        if kept.found is not None:
            self._spare.append(kept.found.target)

    def _free_target(self, view: MeshView, boxes: tuple[Box, ...]) -> DeepTarget:
        """Return a target that holds boxes; maps of other views and the least lately used go for it."""
        for kept in [each for each in self._kept if each.view is not view] + self._kept[: 1 - _KEPT_MAPS]:
            if kept in self._kept:
                self._kept.remove(kept)
                self._let_go(kept)
        width, height = boxes[-1].right, max(each.bottom for each in boxes)
        while self._spare:
            target = self._spare.pop()
            if (target.box.width, target.box.height) == (width, height):
                return target
            target.close()
        return DeepTarget(width, height, Format.FLOAT2)

    def _draw(self, view: MeshView, light_map: LightMap, wanted: Callable[[PieceScene], bool]) -> None:
        light_map.target.begin()
        program = self._programs[frozenset({"AWAY"})]
        for window, box in zip(light_map.windows.faces, light_map.boxes, strict=True):
            if window is not None:
                for place in (GL.glViewport, GL.glScissor):
                    place(box.left, box.top, box.width, box.height)
                rows, away = window.clip_rows()
                program.use({"u_clip_rows": rows, "u_away": away})
                view.on_gpu.draw(program, wanted, rows)
        self.maps_drawn += 1


def _with(receivers: Matrix, others: Matrix | None) -> Matrix | None:
    return None if others is None else np.concatenate([receivers, others], axis=2)
