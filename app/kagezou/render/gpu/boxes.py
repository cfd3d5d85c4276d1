"""Drawing boxes given in canvas px."""

from ctypes import c_void_p

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.box import Box
from kagezou.render.gpu.gl import GL, deleted, made

_CORNERS = (0, 1, 2, 1, 2, 3, 0, 1, 2, 3, 0, 3)
"""Two triangles of a box (left, top, right, bottom), as pairs (x, y)."""


class Boxes:
    """One small vertex buffer that every pass draws from."""

    def __init__(self) -> None:
        self._array = made(GL.glGenVertexArrays)
        self._buffer = made(GL.glGenBuffers)
        self._numbered = made(GL.glGenVertexArrays)
        for array, components in ((self._numbered, 3), (self._array, 2)):
            GL.glBindVertexArray(array)
            GL.glBindBuffer(GL.GL_ARRAY_BUFFER, self._buffer)
            GL.glEnableVertexAttribArray(0)
            GL.glVertexAttribPointer(0, components, GL.GL_FLOAT, False, 4 * components, c_void_p(0))  # noqa: FBT003 - the call's own order

    def draw(self, boxes: NDArray[np.float64]) -> None:
        """Draw boxes (N, 4): left, top, right, bottom in canvas px, with the program in use."""
        points = np.ascontiguousarray(boxes[:, _CORNERS], dtype=np.float32)
        self._load(self._array, points)
        GL.glDrawArrays(GL.GL_TRIANGLES, 0, len(points) * 6)

    def load_numbered(self, boxes: NDArray[np.float64], numbers: NDArray[np.int64]) -> None:
        """Hand over boxes as :meth:`draw` does, each with a number as a third coordinate, for :meth:`draw_loaded`."""
        corners = boxes[:, _CORNERS].reshape(len(boxes), 6, 2)
        points = np.empty((len(boxes), 6, 3), np.float32)
        points[..., :2] = corners
        points[..., 2] = numbers[:, np.newaxis]
        self._load(self._numbered, points)

    def draw_triangles(self, corners: NDArray[np.float64]) -> None:
        """Draw triangles (3·n, 3), each corner x and y in px and a number as for :meth:`load_numbered`."""
        self._load(self._numbered, np.ascontiguousarray(corners, np.float32))
        GL.glDrawArrays(GL.GL_TRIANGLES, 0, len(corners))

    def draw_loaded(self, first: int, count: int) -> None:
        """Draw ``count`` of the boxes handed over last, from ``first`` on, with the program in use."""
        GL.glDrawArrays(GL.GL_TRIANGLES, first * 6, count * 6)

    def draw_one(self, box: Box) -> None:
        """Draw one box with the program in use."""
        self.draw(np.array([[box.left, box.top, box.right, box.bottom]], dtype=np.float64))

    def _load(self, array: int, points: NDArray[np.float32]) -> None:
        GL.glBindVertexArray(array)
        GL.glBindBuffer(GL.GL_ARRAY_BUFFER, self._buffer)
        GL.glBufferData(GL.GL_ARRAY_BUFFER, points.nbytes, c_void_p(points.ctypes.data), GL.GL_STREAM_DRAW)

    def close(self) -> None:
        """Give the memory back."""
        deleted(GL.glDeleteBuffers, self._buffer)
        deleted(GL.glDeleteVertexArrays, self._array)
        deleted(GL.glDeleteVertexArrays, self._numbered)
