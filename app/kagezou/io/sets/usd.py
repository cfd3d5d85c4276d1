"""Sets from USD files, where the optional package for them is installed."""

from importlib import import_module
from pathlib import Path
from typing import Any, Final

import numpy as np

from kagezou.errors import InputProblem
from kagezou.io.files.faults import input_problem
from kagezou.io.sets.bounded_bytes import check_inside, state_of
from kagezou.message import Message

MISSING: Final = Message("USD files need the package usd-core: pip install 'kagezou[usd]'")


def read_usd(path: Path, most: int) -> tuple[Any, Any]:
    """Return the points (N, 3) and triangles (M, 3) of all meshes of a stage, each where it stands at its first frame.

    Raises
    ------
    InputProblem
        The package is missing, the file is broken, or there are more than ``most`` triangles.
    """
    stage = open_stage(path)
    Usd, UsdGeom = pxr("Usd"), pxr("UsdGeom")  # noqa: N806 - modules
    points: list[Any] = []
    corners: list[Any] = []
    placed = UsdGeom.XformCache(Usd.TimeCode.EarliestTime())
    count = total = 0
    for prim in stage.Traverse(Usd.TraverseInstanceProxies()):
        mesh = UsdGeom.Mesh(prim)
        if not mesh or UsdGeom.Imageable(prim).ComputeVisibility() == UsdGeom.Tokens.invisible:
            continue
        counts, indices, local = (
            np.asarray(each.Get(Usd.TimeCode.EarliestTime()) or ())
            for each in (mesh.GetFaceVertexCountsAttr(), mesh.GetFaceVertexIndicesAttr(), mesh.GetPointsAttr())
        )
        if not len(counts) or not len(local):
            continue
        if counts.min() < 3 or counts.sum() != len(indices) or indices.min() < 0 or indices.max() >= len(local):
            raise input_problem(path, Message("it is damaged: a triangle names a missing corner"))
        total += int((counts - 2).sum())
        if total > most:
            raise input_problem(
                path, Message("it has more than the {most} triangles that can be worked with", most=most)
            )
        # USD's matrices act on rows.
        matrix = np.asarray(placed.GetLocalToWorldTransform(prim))
        points.append(np.c_[local.astype(np.float64), np.ones(len(local))] @ matrix[:, :3])
        corners.append(_fans(counts, indices) + count)
        count += len(local)
    if not points:
        raise input_problem(path, Message("there are no triangles in it"))
    return np.concatenate(points), np.concatenate(corners)


def is_z_up(path: Path) -> bool:
    """Whether a stage says that its third axis points up."""
    return str(pxr("UsdGeom").GetStageUpAxis(open_stage(path))) == "Z"


def pxr(name: str) -> Any:
    """Return a module of USD's package, which has no types; InputProblem where the package is missing."""
    try:
        return import_module(f"pxr.{name}")
    except ImportError as error:
        raise InputProblem(MISSING) from error


def open_stage(path: Path) -> Any:
    """Open a stage; InputProblem where the package for it is missing or the file is broken."""
    state_of(path)
    stages = pxr("Usd").Stage
    try:
        _check_layers(path)
        stage = stages.Open(str(path), stages.LoadAll)
    except pxr("Tf").ErrorException as error:
        raise input_problem(path, Message("it cannot be read as USD: the file is damaged")) from error
    if stage is None:
        raise input_problem(path, Message("it cannot be read as USD: the file is damaged"))
    return stage


def _check_layers(path: Path) -> None:
    """See that a stage is made of nothing outside of its folder, before that is opened."""
    layers = pxr("Sdf").Layer
    waiting, seen = [path], {path}
    while waiting:
        place = waiting.pop()
        layer = layers.FindOrOpen(str(place))
        # A package holds its own layers.
        is_package = place.suffix.lower() == ".usdz"
        for name in () if layer is None or is_package else layer.GetCompositionAssetDependencies():
            check_inside(place, name)
            if (other := place.parent / name) not in seen:
                seen.add(other)
                waiting.append(other)


def _fans(counts: Any, indices: Any) -> Any:
    """Return polygons, given by the lengths and corners of all, as triangles around their first corners."""
    starts = np.repeat(np.cumsum(counts) - counts, counts - 2)
    fans = counts - 2
    steps = np.arange(1, fans.sum() + 1) - np.repeat(np.cumsum(fans) - fans, fans)
    return np.stack([indices[starts], indices[starts + steps], indices[starts + steps + 1]], axis=1)
