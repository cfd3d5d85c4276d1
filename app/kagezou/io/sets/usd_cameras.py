"""The cameras of a USD stage, standing still or animated."""

from fractions import Fraction
from math import ceil
from pathlib import Path
from typing import Any, Final

import numpy as np

from kagezou.geometry.set_camera import SetCamera
from kagezou.io.files.faults import input_problem
from kagezou.io.sets.gltf_cameras import MAX_FRAMES
from kagezou.io.sets.usd import open_stage, pxr
from kagezou.message import Message

_APERTURE_UNIT: Final = 0.1
"""Apertures are in tenths of the stage's unit."""

_STILL: Final = 1e-9


def usd_cameras(path: Path, frame_rate: Fraction) -> tuple[SetCamera, ...]:
    """Return every camera of a stage, in the order of its tree.

    Raises
    ------
    InputProblem
        The package for USD is missing, or the file is broken.
    """
    stage = open_stage(path)
    Usd, UsdGeom = pxr("Usd"), pxr("UsdGeom")  # noqa: N806 - modules
    first, last, rate = stage.GetStartTimeCode(), stage.GetEndTimeCode(), stage.GetTimeCodesPerSecond()
    count = ceil((last - first) / rate * frame_rate - _STILL) + 1 if last > first and rate > 0 else 1
    if count > MAX_FRAMES:
        raise input_problem(
            path,
            Message(
                "it lasts {count} frames, more than the {most_frames} that are read",
                count=count,
                most_frames=MAX_FRAMES,
            ),
        )
    times = [Usd.TimeCode(first + float(frame / frame_rate) * rate) for frame in range(count)]
    found = []
    for prim in stage.Traverse():
        camera = UsdGeom.Camera(prim)
        if camera:
            poses = np.stack([_pose(UsdGeom.XformCache(time), prim) for time in times])
            made = _camera(prim.GetName(), [camera.GetCamera(time) for time in times], poses)
            most = 180.0 if made.is_perspective else np.inf
            sizes = np.array([made.height, *made.heights])
            if not np.isfinite(poses).all() or not (
                np.isfinite(sizes).all() and (sizes > 0).all() and max(sizes) < most
            ):
                raise input_problem(path, Message("the camera {made!r} in it makes no sense", made=made.name))
            found.append(made)
    return tuple(found)


def _camera(name: str, lenses: list[Any], poses: Any) -> SetCamera:
    first = lenses[0]
    is_perspective = first.projection == first.Perspective
    heights = [
        float(lens.GetFieldOfView(lens.FOVVertical) if is_perspective else lens.verticalAperture * _APERTURE_UNIT)
        for lens in lenses
    ]
    stands = bool(np.abs(poses - poses[0]).max() < _STILL)
    zooms = max(heights) - min(heights) > _STILL
    return SetCamera(
        name,
        is_perspective,
        heights[0],
        float(first.aspectRatio),
        poses[:1] if stands else poses,
        tuple(heights) if zooms else (),
    )


def _pose(placed: Any, prim: Any) -> Any:
    # USD's matrices act on rows.
    matrix = np.asarray(placed.GetLocalToWorldTransform(prim)).T
    made = np.eye(4)
    with np.errstate(all="ignore"):
        made[:3, :3] = matrix[:3, :3] / np.linalg.norm(matrix[:3, :3], axis=0)
    made[:3, 3] = matrix[:3, 3]
    return made
