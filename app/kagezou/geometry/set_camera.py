"""A camera of an imported set, as its file has it."""

from dataclasses import dataclass
from math import radians, tan

import numpy as np

from kagezou.geometry.vectors import Matrix, Point2, Vector3


@dataclass(frozen=True, slots=True, eq=False)
class SetCamera:
    """Where a camera stands in its set, frame by frame; it looks along its own −z, its y points up, its x to the right.

    Parameters
    ----------
    name
        As in the file.
    is_perspective
        Else orthographic.
    height
        Perspective: the vertical field of view in degrees; orthographic: how high the picture is, in the file's units.
    aspect
        Width by height of its picture; 0 where the file does not say.
    poses
        (F, 4, 4) rigid, from camera coordinates to the mesh's: one for each frame from the first on, or a single one
        for a camera that stands still. After the last one it stands still.
    heights
        What ``height`` is on each frame, for a camera that zooms; nothing for one that does not.
    """

    name: str
    is_perspective: bool
    height: float
    aspect: float
    poses: Matrix
    heights: tuple[float, ...] = ()

    @property
    def length_frames(self) -> int:
        """How many frames it moves or zooms for; 1 if it does neither."""
        return max(len(self.poses), len(self.heights))

    @property
    def is_animated(self) -> bool:
        """Whether it moves or zooms."""
        return self.length_frames > 1

    def height_at(self, frame: int) -> float:
        """Return its height on a frame, counted from 1."""
        return self.heights[min(max(frame, 1), len(self.heights)) - 1] if self.heights else self.height

    def pose(self, frame: int) -> Matrix:
        """Return its pose (4, 4) on a frame, counted from 1."""
        return np.asarray(self.poses[min(max(frame, 1), len(self.poses)) - 1])

    def sees(self, point: Vector3, frame: int, size_px: Point2) -> Point2:
        """Return where it shows a point of the mesh on a canvas that is as high as its picture, canvas px, y down."""
        x, y, z, _ = np.linalg.inv(self.pose(frame)) @ np.array([*point, 1.0])
        width, height = size_px
        own = self.height_at(frame)
        scale = (height / 2) / tan(radians(own) / 2) / -z if self.is_perspective else height / own
        return (width / 2 + float(scale * x), height / 2 - float(scale * y))
