"""From the colours of one device or colour space to sRGB, by curves to linear light and a matrix of it."""

import functools
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from kagezou.io.pixels.colour import coded_from_linear, linear_from_coded

Matrix = NDArray[np.float64]
Chromaticities = tuple[float, float, float, float, float, float, float, float]
"""x and y of red, green, blue and white."""

REC709: Final[Chromaticities] = (0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290)
D50: Final = np.array([0.9642, 1.0, 0.8249])
_ROWS: Final = 64
_CODES: Final = 65536
_BRADFORD: Final = np.array([[0.8951, 0.2664, -0.1614], [-0.7502, 1.7135, 0.0367], [0.0389, -0.0685, 1.0296]])
_ALIKE: Final = 1e-3
_ALIKE_CODES: Final = 257
"""So many codes of 16 bit are one of 8 bit: nobody sees that."""


@dataclass(frozen=True, eq=False, slots=True)
class ColourChange:
    """How pixels become sRGB.

    Attributes
    ----------
    curves
        (3, 65536) ``float32``, the linear light of each code of red, green and blue; None where pixels are linear.
    matrix
        (3, 3), from their light to that of sRGB; white stays white.
    """

    curves: NDArray[np.float32] | None
    matrix: NDArray[np.float32]

    def lit(self, light: NDArray[np.float32]) -> NDArray[np.float32]:
        """Return linear light (H, W, 3) of the file as that of sRGB; it may be below 0 and above 1."""
        # Plain sums and products: what is no number stays in its own pixel, and no library warns of it.
        with np.errstate(all="ignore"):
            return np.stack(
                [sum((light[..., each] * row[each] for each in (1, 2)), light[..., 0] * row[0]) for row in self.matrix],
                axis=-1,
            )

    def put_on(self, colour: NDArray[Any]) -> None:
        """Change codes (H, W, 3), ``uint8`` or ``uint16``, in place."""
        curves = self.curves
        step = 257 if colour.dtype == np.uint8 else 1
        for top in range(0, colour.shape[0], _ROWS):
            part = colour[top : top + _ROWS]
            if curves is None:
                light = linear_from_coded(part)
            else:
                codes = part.astype(np.uint16) * np.uint16(step)
                light = np.stack([curves[each][codes[..., each]] for each in range(3)], axis=-1)
            coded = coded_from_linear(self.lit(light))
            part[...] = coded if step == 1 else (coded.astype(np.uint32) + 128) // 257


def light_change(source: Chromaticities, curves: NDArray[np.float32] | None = None) -> ColourChange | None:
    """Return the change from primaries to sRGB, None where nothing is to be seen of it or they are impossible.

    Parameters
    ----------
    source
        The primaries and the white of the file.
    curves
        As `ColourChange` has them; None for linear light.
    """
    try:
        matrix = np.linalg.inv(xyz_of(REC709)) @ xyz_of(source)
    except (np.linalg.LinAlgError, FloatingPointError, ZeroDivisionError):
        return None
    return change_of(matrix, curves) if np.isfinite(matrix).all() else None


def change_of(matrix: Matrix, curves: NDArray[np.float32] | None) -> ColourChange | None:
    """Return the change by a matrix from light of the file to that of sRGB, None where nothing is to be seen of it."""
    # White is white in both; rounded numbers of a file must not take pure white away.
    whole = matrix.sum(axis=1, keepdims=True)
    if (np.abs(whole - 1) < 0.02).all():
        matrix = matrix / whole
    change = ColourChange(curves, matrix.astype(np.float32))
    if curves is None:
        return None if np.abs(matrix - np.eye(3)).max() < _ALIKE else change
    return None if _is_unseen(change) else change


def _is_unseen(change: ColourChange) -> bool:
    """Whether no code of a lattice and no gray is changed by more than one code of 8 bit."""
    steps = np.linspace(0, _CODES - 1, 9).round().astype(np.uint16)
    lattice = np.stack(np.meshgrid(steps, steps, steps), axis=-1).reshape(-1, 1, 3)
    grays = np.repeat(np.arange(0, _CODES, 257, dtype=np.uint16)[:, None, None], 3, axis=2)
    codes = np.concatenate([lattice, grays])
    changed = codes.copy()
    change.put_on(changed)
    return bool(np.abs(changed.astype(np.int64) - codes).max() <= _ALIKE_CODES)


def xyz_of(source: Chromaticities) -> Matrix:
    """Return the matrix from light of primaries to XYZ as seen under D50; their white is the white there.

    Raises
    ------
    LinAlgError, ZeroDivisionError
        They span no colours.
    """
    points = np.asarray(source, np.float64).reshape(4, 2)
    if not np.isfinite(points).all() or (np.abs(points[:, 1]) < 1e-6).any():
        raise np.linalg.LinAlgError
    x, y = points.T
    xyz = np.stack([x / y, np.ones(4), (1 - x - y) / y])
    white = xyz[:, 3]
    native = xyz[:, :3] * np.linalg.solve(xyz[:, :3], white)
    cones = np.diag((_BRADFORD @ D50) / (_BRADFORD @ white))
    adapted: Matrix = np.linalg.inv(_BRADFORD) @ cones @ _BRADFORD @ native
    return adapted


@functools.cache
def power_curves(exponent: float) -> NDArray[np.float32]:
    """Return the curves of a device whose light is its code, 0 to 1, to the power of ``exponent``."""
    return _shared(np.linspace(0.0, 1.0, _CODES) ** exponent)


@functools.cache
def srgb_curves() -> NDArray[np.float32]:
    """Return the curves of sRGB."""
    return _shared(linear_from_coded(np.arange(_CODES, dtype=np.uint16)))


def _shared(curve: NDArray[Any]) -> NDArray[np.float32]:
    return np.broadcast_to(curve.astype(np.float32), (3, _CODES))
