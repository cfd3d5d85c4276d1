"""Where cameras of files stand, as rigid poses."""

import numpy as np

from kagezou.geometry.vectors import Matrix


def rigid(pose: Matrix) -> Matrix:
    """Return a camera's pose (4, 4) without scale, shear and mirroring, none of which turns where it looks.

    It looks along its own −z as before, its y as near to where it was as that allows.

    Raises
    ------
    ValueError
        It has no direction to look in.
    """
    made = np.eye(4)
    with np.errstate(all="ignore"):
        back = pose[:3, 2] / np.linalg.norm(pose[:3, 2])
        up = pose[:3, 1] / np.linalg.norm(pose[:3, 1])
        up = up - (up @ back) * back
        made[:3, 2] = back
        made[:3, 1] = up / np.linalg.norm(up)
        made[:3, 0] = np.cross(made[:3, 1], back)
    made[:3, 3] = pose[:3, 3]
    if not np.isfinite(made).all():
        raise ValueError(pose)
    return made


def is_mirrored(pose: Matrix) -> bool:
    """Whether what a camera at a pose (4, 4) sees is the wrong way round."""
    return bool(np.linalg.det(pose[:3, :3]) < 0)
