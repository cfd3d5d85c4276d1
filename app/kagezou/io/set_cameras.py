"""What a set's file says of cameras and of its axes, whatever its format."""

from fractions import Fraction
from pathlib import Path
from typing import Final

from kagezou.geometry.set_camera import SetCamera
from kagezou.io.gltf_cameras import gltf_cameras
from kagezou.io.usd import is_z_up
from kagezou.io.usd_cameras import usd_cameras

_GLTF: Final = (".glb", ".gltf")
_USD: Final = (".usd", ".usda", ".usdc", ".usdz")


def cameras_of(path: Path, frame_rate: Fraction) -> tuple[SetCamera, ...]:
    """Return the cameras of a file, read for a cut of a frame rate; formats without cameras have none.

    Raises
    ------
    InputProblem
        The file is broken.
    """
    suffix = path.suffix.lower()
    if suffix in _GLTF:
        return gltf_cameras(path, frame_rate)
    return usd_cameras(path, frame_rate) if suffix in _USD else ()


def up_axis_of(path: Path) -> str:
    """Return which axis points up, "y" or "z": glTF says y, USD says it itself, others are taken for y."""
    return "z" if path.suffix.lower() in _USD and is_z_up(path) else "y"
