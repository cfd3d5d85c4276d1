"""Drawing convex polygons and boxes given in canvas px."""

from ctypes import c_void_p

import numpy as np

from kagezou.geometry.box import Box
from kagezou.geometry.polygon import box_polygon
from kagezou.geometry.vectors import Matrix
from kagezou.render.gl import GL

MAX_CORNERS = 64


class Polygons:
    """One small vertex buffer that every pass draws from."""

    def __init__(self) -> None:
        self._array = int(GL.glGenVertexArrays(1))
        self._buffer = int(GL.glGenBuffers(1))
        GL.glBindVertexArray(self._array)
        GL.glBindBuffer(GL.GL_ARRAY_BUFFER, self._buffer)
        GL.glBufferData(GL.GL_ARRAY_BUFFER, MAX_CORNERS * 8, None, GL.GL_STREAM_DRAW)
        GL.glEnableVertexAttribArray(0)
        GL.glVertexAttribPointer(0, 2, GL.GL_FLOAT, False, 8, c_void_p(0))  # noqa: FBT003 - the call's own order

    def draw(self, corners: Matrix) -> None:
        """Draw a convex polygon (N, 2), canvas px, N >= 3, with the program in use."""
        points = np.ascontiguousarray(corners[:MAX_CORNERS], dtype=np.float32)
        GL.glBindVertexArray(self._array)
        GL.glBindBuffer(GL.GL_ARRAY_BUFFER, self._buffer)
        GL.glBufferData(GL.GL_ARRAY_BUFFER, points.nbytes, points, GL.GL_STREAM_DRAW)
        GL.glDrawArrays(GL.GL_TRIANGLE_FAN, 0, len(points))

    def draw_box(self, box: Box) -> None:
        """Draw a box of whole pixels with the program in use."""
        self.draw(box_polygon(box))

    def close(self) -> None:
        """Give the memory back."""
        GL.glDeleteBuffers(1, [self._buffer])
        GL.glDeleteVertexArrays(1, [self._array])
