"""Meshes as they are shown in the picture: as grey clay, or as a wireframe without the lines that are hidden."""

from collections.abc import Iterable
from ctypes import c_void_p
from dataclasses import dataclass
from enum import Enum

import numpy as np

from kagezou.geometry.vectors import Matrix
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.gl import GL, deleted, made
from kagezou.render.gpu.program import Program
from kagezou.render.gpu.targets import Format, Target, Texture
from kagezou.render.meshes.buffers import FLAG_OF_DISPLAY, UNDER
from kagezou.render.meshes.eye_view import MeshView

_HALF_PX, _RIM_PX = 0.6, 0.75
"""Half the width of a line of a wireframe, and how far its soft rim reaches beyond."""

_NEAREST_W = 0.01


class Display(Enum):
    """How a mesh is shown."""

    WIREFRAME = "wireframe"
    CLAY = "clay"


@dataclass(frozen=True, slots=True, eq=False)
class SetPicture:
    """A picture of meshes, of the canvas' size: RGBA for clay, covered parts for a wireframe."""

    texture: Texture
    display: Display
    is_under: bool


class MeshDisplays:
    """Draws meshes for the picture; kept while neither they nor the camera move."""

    def __init__(self, boxes: Boxes) -> None:
        self._boxes = boxes
        self._clay = Program("common/box.vert", "meshes/clay.frag")
        self._line = Program("meshes/line.vert", "meshes/line.frag")
        self._array, self._buffer = made(GL.glGenVertexArrays), made(GL.glGenBuffers)
        self._view: MeshView | None = None
        self._kept: dict[tuple[Display, bool], SetPicture] = {}

    def close(self) -> None:
        """Give the memory back."""
        self.forget()
        self._clay.close()
        self._line.close()
        deleted(GL.glDeleteBuffers, self._buffer)
        deleted(GL.glDeleteVertexArrays, self._array)

    def forget(self) -> None:
        """Give back what is kept."""
        for picture in self._kept.values():
            picture.texture.close()
        self._kept.clear()
        self._view = None

    def pictures(self, view: MeshView, displays: Iterable[Display]) -> tuple[SetPicture, ...]:
        """Return what is to be shown of the meshes in these ways, those under the background first."""
        if self._view is not view:
            self.forget()
            self._view = view
        pieces = [each.piece for each in view.on_gpu.placed]
        wanted = [
            (display, is_under)
            for is_under in (True, False)
            for display in displays
            if any((piece.display, piece.is_under) == (display.value, is_under) for piece in pieces)
        ]
        for display, is_under in wanted:
            if (display, is_under) not in self._kept:
                draw = self._draw_clay if display is Display.CLAY else self._draw_lines
                self._kept[display, is_under] = SetPicture(draw(view, is_under=is_under), display, is_under)
        return tuple(self._kept[each] for each in wanted)

    def _draw_clay(self, view: MeshView, *, is_under: bool) -> Texture:
        target = Target(view.canvas.width, view.canvas.height, Format.RGBA8)
        target.bind()
        view.bind()
        clay = FLAG_OF_DISPLAY[Display.CLAY.value]
        flags = {"u_asked": clay | UNDER, "u_wanted": clay | (UNDER if is_under else 0)}
        self._clay.use({"u_target_size_px": target.size_px, **flags, **view.uniforms()})
        self._boxes.draw_one(target.box)
        return target.texture_alone()

    def _draw_lines(self, view: MeshView, *, is_under: bool) -> Texture:
        target = Target(view.canvas.width, view.canvas.height, Format.ALPHA8)
        target.clear()
        GL.glEnable(GL.GL_BLEND)
        GL.glBlendFunc(GL.GL_ONE, GL.GL_ONE)
        GL.glBlendEquation(GL.GL_MAX)
        view.bind()
        self._line.use({"u_target_size_px": target.size_px, "u_half_px": _HALF_PX, **view.uniforms()})
        ends = view.on_gpu.line_ends(
            lambda piece: (piece.display, piece.is_under) == (Display.WIREFRAME.value, is_under)
        )
        self._draw_quads(_quads(view, ends))
        return target.texture_alone()

    def _draw_quads(self, quads: Matrix) -> None:
        """Draw quads (N, 6, 5): canvas px, px across and beyond, nearness."""
        if not len(quads):
            return
        numbers = np.ascontiguousarray(quads, dtype=np.float32)
        GL.glBindVertexArray(self._array)
        GL.glBindBuffer(GL.GL_ARRAY_BUFFER, self._buffer)
        GL.glBufferData(GL.GL_ARRAY_BUFFER, numbers.nbytes, c_void_p(numbers.ctypes.data), GL.GL_STREAM_DRAW)
        for place, size, offset in ((0, 2, 0), (1, 2, 8), (2, 1, 16)):
            GL.glEnableVertexAttribArray(place)
            GL.glVertexAttribPointer(place, size, GL.GL_FLOAT, False, 20, c_void_p(offset))  # noqa: FBT003 - GL's order
        GL.glDrawArrays(GL.GL_TRIANGLES, 0, len(numbers) * 6)


def _quads(view: MeshView, ends: Matrix) -> Matrix:
    """Return lines, given by their ends (N, 2, 3) in the world, as quads (N, 6, 5) on the canvas."""
    seen = np.concatenate([ends, np.ones((*ends.shape[:2], 1))], axis=2) @ view.camera.canvas_from_world().T
    seen, depth = _before_eye(seen, ends[..., 2])
    places = seen[..., :2] / seen[..., 2:]
    nearness = -depth if view.camera.eye[3] == 0 else 1 / seen[..., 2]
    along = places[:, 1] - places[:, 0]
    length = np.linalg.norm(along, axis=1)
    reach = _HALF_PX + _RIM_PX
    box = view.canvas.grown(2)
    low, high = places.min(axis=1), places.max(axis=1)
    near = (low < [box.right, box.bottom]).all(axis=1) & (high > [box.left, box.top]).all(axis=1) & (length > 1e-3)
    places, nearness, along, length = places[near], nearness[near], along[near], length[near]
    along = along / length[:, np.newaxis]
    across = np.stack([-along[:, 1], along[:, 0]], axis=1)
    corners = []
    slope = (nearness[:, 1] - nearness[:, 0]) / length
    for end, side in ((0, -1), (1, -1), (0, 1), (0, 1), (1, -1), (1, 1)):
        beyond = reach if end else -reach
        place = places[:, end] + along * beyond + across * (side * reach)
        beside = np.full(len(place), side * reach)
        value = nearness[:, end] + slope * beyond
        corners.append(np.column_stack([place, beside, np.zeros(len(place)), value]))
    return np.stack(corners, axis=1)


def _before_eye(seen: Matrix, depth: Matrix) -> tuple[Matrix, Matrix]:
    """Cut lines, by the homogeneous pictures (N, 2, 3) and the z (N, 2) of their ends, to what lies before the eye."""
    w = seen[..., 2]
    kept = w.max(axis=1) > _NEAREST_W
    seen, depth, w = seen[kept].copy(), depth[kept].copy(), w[kept]
    for end in (0, 1):
        cut = w[:, end] < _NEAREST_W
        part = ((_NEAREST_W - w[cut, end]) / (w[cut, 1 - end] - w[cut, end]))[:, np.newaxis]
        seen[cut, end] += part * (seen[cut, 1 - end] - seen[cut, end])
        depth[cut, end] += part[:, 0] * (depth[cut, 1 - end] - depth[cut, end])
    return seen, depth
