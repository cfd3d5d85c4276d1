"""Colour profiles of the ICC that are curves and a matrix, as those of screens and cameras' pictures are."""

import functools
import struct
from typing import Final

import numpy as np
from numpy.typing import NDArray

from kagezou.io.pixels.colour_change import D50, REC709, ColourChange, change_of, xyz_of
from kagezou.message import Message

_HEADER_BYTES: Final = 128
_MOST_TAGS: Final = 200
_CODES: Final = 65536
_PARAMETERS: Final = (1, 3, 4, 5, 7)
"""How many numbers the kinds of parametric curves have."""

NOT_USED: Final = Message("its colour profile is not used")
DAMAGED: Final = Message("its colour profile is damaged and not used")


@functools.lru_cache(maxsize=16)
def change_by_profile(data: bytes, *, is_gray: bool) -> ColourChange | Message | None:
    """Return the change from a profile's colours to sRGB.

    Parameters
    ----------
    data
        The profile.
    is_gray
        Whether the picture has gray alone.

    Returns
    -------
        None where nothing is to be seen of it; a note where it cannot be used.
    """
    try:
        with np.errstate(all="raise", under="ignore"):
            return _change(data, is_gray=is_gray)
    except (struct.error, ValueError, IndexError, ArithmeticError, np.linalg.LinAlgError):
        return DAMAGED


def _change(data: bytes, *, is_gray: bool) -> ColourChange | Message | None:
    if len(data) < _HEADER_BYTES + 4 or data[36:40] != b"acsp":
        return DAMAGED
    tags = _tags(data)
    srgb = np.linalg.inv(xyz_of(REC709))
    if data[16:20] == b"GRAY":
        if not is_gray or b"kTRC" not in tags:
            return NOT_USED
        curve = _curve(tags[b"kTRC"])
        return change_of(np.eye(3), np.broadcast_to(curve, (3, _CODES)))
    needed = {b"rXYZ", b"gXYZ", b"bXYZ", b"rTRC", b"gTRC", b"bTRC"}
    if data[16:20] != b"RGB " or data[20:24] != b"XYZ " or not needed <= set(tags):
        return NOT_USED
    columns = np.stack([_xyz(tags[name]) for name in (b"rXYZ", b"gXYZ", b"bXYZ")], axis=1)
    if np.abs(columns.sum(axis=1) - D50).max() > 0.1:
        return NOT_USED  # its white is none: a profile of an odd device
    curves = np.stack([_curve(tags[name]) for name in (b"rTRC", b"gTRC", b"bTRC")])
    return change_of(srgb @ columns, curves)


def _tags(data: bytes) -> dict[bytes, bytes]:
    (count,) = struct.unpack_from(">I", data, _HEADER_BYTES)
    found = {}
    for index in range(min(count, _MOST_TAGS)):
        name, at, length = struct.unpack_from(">4sII", data, _HEADER_BYTES + 4 + 12 * index)
        found[name] = data[at : at + length]
    return found


def _xyz(tag: bytes) -> NDArray[np.float64]:
    return np.array(struct.unpack_from(">3i", tag, 8)) / 65536


def _curve(tag: bytes) -> NDArray[np.float32]:
    """Return the light of every code of 16 bit."""
    codes = np.linspace(0.0, 1.0, _CODES)
    if tag[:4] == b"curv":
        (count,) = struct.unpack_from(">I", tag, 8)
        points = np.array(struct.unpack_from(f">{min(count, _CODES)}H", tag, 12), np.float64)
        if count == 0:
            light = codes
        elif count == 1:
            light = codes ** (points[0] / 256)
        else:
            light = np.interp(codes, np.linspace(0.0, 1.0, len(points)), points / 65535)
        return light.astype(np.float32)
    if tag[:4] != b"para":
        raise ValueError
    (kind,) = struct.unpack_from(">H", tag, 8)
    numbers = np.array(struct.unpack_from(f">{_PARAMETERS[kind]}i", tag, 12)) / 65536
    return _parametric(codes, kind, numbers).astype(np.float32)


def _parametric(codes: NDArray[np.float64], kind: int, numbers: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return a parametric curve; ``numbers`` are g, a, b, c, d, e and f of the standard as far as the kind has them."""
    g, a, b, c, d, e, f = (*map(float, numbers), *[0.0] * (7 - len(numbers)))
    if kind == 0:
        a, bound = 1.0, -1.0
    elif kind in {1, 2}:
        bound = -b / a
        # In kind 2 the number c stands on both sides.
        c, e, f = 0.0, c, c
    else:
        bound = d
    bent = np.maximum(a * codes + b, 0.0) ** g + e
    return np.clip(np.where(codes >= bound, bent, c * codes + f), 0.0, 1.0)
