"""What a set's file says of cameras and of its axes, whatever its format."""

from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Final

from kagezou.geometry.set_camera import SetCamera
from kagezou.io.sets.gltf_cameras import gltf_cameras
from kagezou.io.sets.usd import is_z_up, usd_cameras
from kagezou.message import Message

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
        return _told_apart(gltf_cameras(path, frame_rate))
    return _told_apart(usd_cameras(path, frame_rate)) if suffix in _USD else ()


def _told_apart(cameras: tuple[SetCamera, ...]) -> tuple[SetCamera, ...]:
    """Return cameras of which no two have one name: a number stands behind that of the second."""
    taken: set[str] = set()
    made = []
    for camera in cameras:
        tries = (camera.name, *(f"{camera.name} {number}" for number in range(2, len(cameras) + 2)))
        name = next(each for each in tries if each not in taken)
        taken.add(name)
        made.append(replace(camera, name=name))
    return tuple(made)


def notes_on_up(path: Path) -> tuple[Message, ...]:
    """Return what is assumed of the axis that points up, where files of this format do not say it."""
    if path.suffix.lower() in (*_GLTF, *_USD):
        return ()
    return (Message("it does not say which axis points up: y is taken"),)


def up_axis_of(path: Path) -> str:
    """Return which axis points up, "y" or "z": glTF says y, USD says it itself, others are taken for y."""
    return "z" if path.suffix.lower() in _USD and is_z_up(path) else "y"
