"""A set of a hundred thousand triangles, as a file that an animator might have been given."""

from pathlib import Path
from typing import Final

import numpy as np

from kagezou.io.files.atomic import write_bytes

SIDE_QUADS: Final = 224
"""Quads each way: two triangles each."""

_HEIGHT = 0.03
_WAVES = ((15.0, 12.0, 0.0, 1.0), (39.0, 47.0, 1.0, 0.5))
"""Waves over the width in x and in z, where they start, and how high they are."""


def write_hills(path: Path) -> Path:
    """Write a binary PLY of hills, one unit wide and deep, y up, and return where it is."""
    side = np.linspace(-0.5, 0.5, SIDE_QUADS + 1)
    x, z = np.meshgrid(side, side)
    y = sum(high * np.sin(a * x + start) * np.cos(b * z) for a, b, start, high in _WAVES) * _HEIGHT
    points = np.stack([x, y, z], axis=-1).reshape(-1, 3).astype("<f4")
    at = np.arange(len(points), dtype="<i4").reshape(x.shape)
    quads = [at[:-1, :-1], at[1:, :-1], at[1:, 1:], at[:-1, 1:]]
    a, b, c, d = (corner.ravel() for corner in quads)
    faces = np.zeros(2 * len(a), dtype=[("count", "u1"), ("corners", "<i4", 3)])
    faces["count"] = 3
    faces["corners"] = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    header = (
        f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n"
        "property float x\nproperty float y\nproperty float z\n"
        f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    write_bytes(path, header.encode("ascii") + points.tobytes() + faces.tobytes())
    return path
