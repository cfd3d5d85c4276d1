"""The shape of a blur's kernel: round, or as long as the shadow itself (spec 3)."""

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.vectors import Matrix


def elongated(covered: NDArray[np.float32], elongation: float) -> Matrix:
    """Return the ``ground_from_blurred`` of a kernel Σ = σ²[(1 - e)I + e·C/√det C] (spec 3).

    Parameters
    ----------
    covered
        (H, W): the shadow on the receiver, in square texels; columns along the contact line, rows away from it.
    elongation
        e, 0 to 1.
    """
    weights = np.maximum(covered, 0.0).astype(np.float64)
    total = float(weights.sum())
    if total <= 0 or elongation <= 0:
        return np.eye(2)
    y, x = np.mgrid[0 : weights.shape[0], 0 : weights.shape[1]] + 0.5
    x, y = (each - (weights * each).sum() / total for each in (x, y))
    # A texel is not a point: it has a twelfth of its width squared of its own, so that no shadow is infinitely thin.
    xx, xy, yy = (
        (weights * each).sum() / total + extra for each, extra in ((x * x, 1 / 12), (x * y, 0), (y * y, 1 / 12))
    )
    shape = np.array([[xx, xy], [xy, yy]]) / np.sqrt(xx * yy - xy * xy)
    (a, b), (_, c) = (1 - elongation) * np.eye(2) + elongation * shape
    # The root of this matrix that leaves v alone: an upper triangle.
    along = b / np.sqrt(c)
    return np.array([[np.sqrt(a - along * along), along], [0.0, np.sqrt(c)]])
