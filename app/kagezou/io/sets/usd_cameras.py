"""The cameras of a USD stage, standing still or animated."""

from fractions import Fraction
from math import ceil
from pathlib import Path
from typing import Any, Final

import numpy as np

from kagezou.geometry.set_camera import SetCamera
from kagezou.geometry.vectors import Matrix
from kagezou.io.files.faults import input_problem
from kagezou.io.sets.camera_poses import rigid
from kagezou.io.sets.gltf_cameras import MAX_FRAMES
from kagezou.io.sets.usd_stage import pxr
from kagezou.message import Message

_APERTURE_UNIT: Final = 0.1
"""Apertures are in tenths of the stage's unit."""

_STILL: Final = 1e-9


def moves(stage: Any) -> bool:
    """Whether a stage lasts longer than one frame."""
    return bool(stage.GetEndTimeCode() > stage.GetStartTimeCode() and stage.GetTimeCodesPerSecond() > 0)


def camera_prims(stage: Any) -> list[Any]:
    """Return the prims of all cameras, those of instances with them."""
    predicate = pxr("Usd").TraverseInstanceProxies()
    return [prim for prim in stage.Traverse(predicate) if pxr("UsdGeom").Camera(prim)]


def cameras_in(path: Path, stage: Any, frame_rate: Fraction) -> tuple[SetCamera, ...]:
    """Return every camera of a stage, in the order of its tree.

    Raises
    ------
    InputProblem
        One of them makes no sense, or moves for too long.
    """
    Usd, UsdGeom = pxr("Usd"), pxr("UsdGeom")  # noqa: N806 - modules
    first, last, rate = stage.GetStartTimeCode(), stage.GetEndTimeCode(), stage.GetTimeCodesPerSecond()
    prims = camera_prims(stage)
    count = ceil((last - first) / rate * frame_rate - _STILL) + 1 if moves(stage) else 1
    if prims and count > MAX_FRAMES:
        raise input_problem(
            path,
            Message(
                "it lasts {count} frames, more than the {most_frames} that are read",
                count=count,
                most_frames=MAX_FRAMES,
            ),
        )
    times = [Usd.TimeCode(first + float(frame / frame_rate) * rate) for frame in range(count if prims else 0)]
    caches = [UsdGeom.XformCache(time) for time in times]
    found = []
    for prim in prims:
        lenses = [UsdGeom.Camera(prim).GetCamera(time) for time in times]
        try:
            made = _camera(prim.GetName(), lenses, np.stack([rigid(_pose(placed, prim)) for placed in caches]))
        except ValueError as error:
            raise _senseless(path, prim.GetName()) from error
        sizes = np.array([made.height, *made.heights])
        most = 180.0 if made.is_perspective else np.inf
        if not (np.isfinite(sizes).all() and (sizes > 0).all() and max(sizes) < most):
            raise _senseless(path, made.name)
        found.append(made)
    return tuple(found)


def _senseless(path: Path, name: str) -> Exception:
    return input_problem(path, Message("the camera {made!r} in it makes no sense", made=name))


def _camera(name: str, lenses: list[Any], poses: Matrix) -> SetCamera:
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
        bool(is_perspective),
        heights[0],
        float(first.aspectRatio),
        poses[:1] if stands else poses,
        tuple(heights) if zooms else (),
    )


def _pose(placed: Any, prim: Any) -> Matrix:
    # USD's matrices act on rows.
    return np.asarray(placed.GetLocalToWorldTransform(prim)).T
