"""What a camera sees of the meshes: the triangles in every pixel, kept while neither has moved."""

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera
from kagezou.geometry.vectors import Matrix
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.gl import GL, integer
from kagezou.render.gpu.program import Program
from kagezou.render.gpu.targets import DeepTarget, Format, Target, Texture
from kagezou.render.meshes.buffers import MeshBuffers
from kagezou.render.prepare.mask_tiles import Flags
from kagezou.render.prepare.shadow_tiles import TILE_PX, TileGrid, whole_grid
from kagezou.render.prepare.uniforms import Uniform

PIXELS_UNIT, SAMPLES_UNIT, TRIANGLES_UNIT, MAP_UNIT, PAST_UNIT = 3, 4, 5, 6, 7
"""Texture units; those before are the caster's."""

_FINE_SIDE, _COARSE_SIDE = 4, 2
"""Samples of a pixel, each way."""

_FINE_BYTES = 160 << 20
"""With more samples than these hold the coarse side has to do."""

_FLAT_PX = 0.04
"""Samples of a pixel that lie no farther from one plane are drawn as if they lay in it."""

_NEAREST_W = 0.01
"""What is nearer to the eye than this part of its distance from the drawing is cut off."""

_BLOCK_TILES = 8


@dataclass(eq=False)
class MeshView:
    """Meshes seen by a camera.

    Parameters
    ----------
    on_gpu, camera, canvas
        What is seen, with what, and on which box.
    pixels
        The triangles of the pixels, as ``meshes/surface.glsl`` wants them.
    ranges
        (rows, columns, 4): for each tile between which lengths of their rays meshes are met, and whether nothing else
        is seen in it.
    """

    on_gpu: MeshBuffers
    camera: Camera
    canvas: Box
    pixels: Texture
    ranges: Matrix = field(default_factory=lambda: np.zeros((0, 0, 4)))

    @cached_property
    def grid(self) -> TileGrid:
        """All tiles of the canvas."""
        return whole_grid(self.canvas)

    @cached_property
    def seen(self) -> Flags:
        """(N,): in which tiles a mesh is seen."""
        return np.asarray((self.ranges[..., 0] <= self.ranges[..., 1]).ravel())

    @cached_property
    def filled(self) -> Flags:
        """(N,): in which tiles nothing but meshes is seen."""
        return np.asarray((self.ranges[..., 2] > 0).ravel())

    @cached_property
    def hulls(self) -> Matrix:
        """(8, 4, T): for each tile in which a mesh is seen, points around all that is seen of it, about the origin."""
        corners = self.grid.corners()[:, :, self.seen]
        low, high = self.ranges[..., 0].ravel()[self.seen], self.ranges[..., 1].ravel()[self.seen]
        return np.concatenate([self._along(corners, low), self._along(corners, high)])

    @cached_property
    def blocks(self) -> Matrix:
        """(8, 4, B): the same for the squares of tiles in which a mesh is seen: fewer points around it all."""
        held = self._held_blocks
        row, column = np.nonzero(held)
        px = TILE_PX * _BLOCK_TILES
        edges = [((column + dx) * float(px), (row + dy) * float(px)) for dy in (0, 1) for dx in (0, 1)]
        corners = np.array([[x, y, np.ones_like(x)] for x, y in edges])
        low, high = (each[held] for each in self._block_ranges)
        return np.concatenate([self._along(corners, low), self._along(corners, high)])

    @cached_property
    def block_of_tile(self) -> NDArray[np.intp]:
        """(T,): in which of the squares each tile lies in which a mesh is seen."""
        held = self._held_blocks
        numbers = np.cumsum(held).reshape(held.shape) - 1
        rows, columns = np.nonzero(self.seen.reshape(self.ranges.shape[:2]))
        return np.asarray(numbers[rows // _BLOCK_TILES, columns // _BLOCK_TILES])

    @cached_property
    def ball(self) -> tuple[Matrix, float]:
        """The middle (3,), around the origin, and the radius of a ball around all that is seen."""
        points = self.blocks[:, :3].transpose(0, 2, 1).reshape(-1, 3)
        if len(points) == 0:
            return np.zeros(3), 0.0
        middle = (points.min(axis=0) + points.max(axis=0)) / 2
        return middle, float(np.linalg.norm(points - middle, axis=1).max())

    @cached_property
    def _block_ranges(self) -> tuple[Matrix, Matrix]:
        """Between which lengths of rays meshes are met in each square of tiles; the first is greater where none is."""
        rows, columns = self.ranges.shape[:2]
        low = np.full((-(-rows // _BLOCK_TILES), -(-columns // _BLOCK_TILES)), np.inf)
        high = -low
        at = tuple(axis // _BLOCK_TILES for axis in np.mgrid[:rows, :columns])
        np.minimum.at(low, at, self.ranges[..., 0])
        np.maximum.at(high, at, self.ranges[..., 1])
        return low, high

    @property
    def _held_blocks(self) -> Flags:
        low, high = self._block_ranges
        return np.asarray(low <= high)

    def uniforms(self) -> dict[str, Uniform]:
        """Return what ``meshes/surface.glsl`` wants, its textures on units of their own."""
        return {"u_pixels": PIXELS_UNIT, **surface_uniforms(self.on_gpu, self.camera, self.canvas)}

    def bind(self) -> None:
        """Bind the textures."""
        self.pixels.bind(PIXELS_UNIT)
        self.on_gpu.texture.bind(TRIANGLES_UNIT)

    def local(self, point: Matrix) -> Matrix:
        """Return a homogeneous point (4,) around the origin."""
        return _local(self.on_gpu, point)

    def local_form(self, form: Matrix) -> Matrix:
        """Return a form (4,) over the world as one over places around the origin."""
        return np.append(form[:3], form[3] + form[:3] @ self.on_gpu.origin)

    def close(self) -> None:
        """Give the memory back."""
        self.pixels.close()

    def _along(self, corners: Matrix, reach: Matrix) -> Matrix:
        """Return the points (4, 4, T) at lengths (T,) of the rays through canvas points (4, 3, T)."""
        eye = np.array(self.camera.eye)
        start = np.stack([corners[:, 0], corners[:, 1], np.zeros_like(corners[:, 0])], axis=1)
        along = start * eye[3] - eye[:3, np.newaxis]
        points = start + along * reach - self.on_gpu.origin[:, np.newaxis]
        return np.concatenate([points, np.ones_like(points[:, :1])], axis=1)


class MeshViews:
    """Looks at meshes; the last view is kept."""

    def __init__(self, boxes: Boxes) -> None:
        self._boxes = boxes
        self._ids = Program("meshes/triangle.vert", "meshes/ids.frag")
        self._pixels = Program("common/box.vert", "meshes/pixels.frag")
        self._tiles = Program("common/box.vert", "meshes/tiles.frag")
        self._kept: MeshView | None = None
        self.views_drawn = 0

    def close(self) -> None:
        """Give the memory back."""
        self.forget()
        for program in (self._ids, self._pixels, self._tiles):
            program.close()

    def forget(self) -> None:
        """Give back what is kept."""
        if self._kept is not None:
            self._kept.close()
            self._kept = None

    def view(self, on_gpu: MeshBuffers, camera: Camera, canvas: Box) -> MeshView:
        """Return what a camera sees of the meshes."""
        kept = self._kept
        if kept is None or kept.on_gpu is not on_gpu or kept.camera != camera or kept.canvas != canvas:
            self.forget()
            kept = self._kept = self._look(on_gpu, camera, canvas)
            self.views_drawn += 1
        return kept

    def _look(self, on_gpu: MeshBuffers, camera: Camera, canvas: Box) -> MeshView:
        side = _side(canvas)
        target = DeepTarget(canvas.width * side, canvas.height * side, Format.COUNT)
        target.begin()
        rows = clip_rows(camera, canvas, on_gpu)
        if rows is not None:
            self._ids.use({"u_clip_rows": rows})
            on_gpu.draw(self._ids, lambda _: True, rows)
        samples = target.texture_alone()
        view = MeshView(on_gpu, camera, canvas, self._gathered(on_gpu, camera, canvas, (samples, side)))
        samples.close()
        view.ranges = self._ranges(view)
        return view

    def _gathered(self, on_gpu: MeshBuffers, camera: Camera, canvas: Box, seen: tuple[Texture, int]) -> Texture:
        """Return the pixels that samples, so many a side, are in."""
        target = Target(canvas.width, canvas.height, Format.COUNT4)
        target.bind()
        samples, side = seen
        samples.bind(SAMPLES_UNIT)
        on_gpu.texture.bind(TRIANGLES_UNIT)
        self._pixels.use(
            {
                "u_target_size_px": target.size_px,
                "u_samples": SAMPLES_UNIT,
                "u_side": side,
                "u_flat_px": _FLAT_PX,
                **surface_uniforms(on_gpu, camera, canvas),
            }
        )
        self._boxes.draw_one(target.box)
        return target.texture_alone()

    def _ranges(self, view: MeshView) -> Matrix:
        columns, rows = (-(-side // TILE_PX) for side in (view.canvas.width, view.canvas.height))
        target = Target(columns, rows, Format.FLOAT4)
        target.bind()
        view.bind()
        self._tiles.use({"u_target_size_px": target.size_px, "u_tile_px": TILE_PX, **view.uniforms()})
        self._boxes.draw_one(target.box)
        ranges = target.read_floats(target.box).astype(np.float64)
        target.close()
        return ranges


def surface_uniforms(on_gpu: MeshBuffers, camera: Camera, canvas: Box) -> dict[str, Uniform]:
    """Return what ``meshes/surface.glsl`` wants but the pixels."""
    origin = ((canvas.width // 2) + 0.5, (canvas.height // 2) + 0.5)
    return {
        "u_triangles": TRIANGLES_UNIT,
        "u_origin_px": origin,
        "u_origin_world": np.array([*origin, 0.0]) - on_gpu.origin,
        "u_eye": _local(on_gpu, np.array(camera.eye)),
    }


def _local(on_gpu: MeshBuffers, point: Matrix) -> Matrix:
    return np.append(point[:3] - point[3] * on_gpu.origin, point[3])


def clip_rows(camera: Camera, canvas: Box, on_gpu: MeshBuffers) -> Matrix | None:
    """Return the (4, 4) map from places around the origin to clip space; None where all lies behind the eye."""
    seen = camera.canvas_from_world()
    x, y, w = seen
    if camera.eye[3] == 0:
        z = on_gpu.places[:, 2] + on_gpu.origin[2]
        low, high = float(z.min()) - 1.0, float(z.max()) + 1.0
        depth = np.array([0.0, 0.0, -2.0, low + high]) / (high - low)
    else:
        away = on_gpu.places @ w[:3] + w[:3] @ on_gpu.origin + w[3]
        near, far = max(float(away.min()) * 0.999, _NEAREST_W), float(away.max()) * 1.001
        if far <= near:
            return None
        depth = (far + near) / (far - near) * w - np.array([0.0, 0.0, 0.0, 2 * far * near / (far - near)])
    rows = np.array([2 / canvas.width * x - w, 2 / canvas.height * y - w, depth, w])
    rows[:, 3] += rows[:, :3] @ on_gpu.origin
    return rows


def _side(canvas: Box) -> int:
    fine = canvas.width * canvas.height * _FINE_SIDE**2 * 4 <= _FINE_BYTES
    limit = integer(GL.GL_MAX_TEXTURE_SIZE)
    for side in (_FINE_SIDE, _COARSE_SIDE):
        if (fine or side == _COARSE_SIDE) and side * max(canvas.width, canvas.height) <= limit:
            return side
    return 1
