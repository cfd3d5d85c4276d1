"""The cameras of a glTF file: perspective and orthographic, standing still or animated."""

from bisect import bisect_right
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from math import ceil, degrees
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.set_camera import SetCamera
from kagezou.geometry.vectors import Matrix
from kagezou.io.files.faults import input_problem
from kagezou.io.sets.camera_poses import rigid
from kagezou.io.sets.gltf import Gltf, read_gltf
from kagezou.io.sets.gltf_accessors import numbers
from kagezou.io.sets.gltf_nodes import RESTS, local_place
from kagezou.io.sets.gltf_tree import SHAPELESS, Tree, damaged
from kagezou.message import Message

MAX_FRAMES: Final = 20_000
_HARDLY: Final = 1e-6


@dataclass(frozen=True, slots=True, eq=False)
class _Channel:
    """One animated part of a node: times (T,), values (T, width), or (3 T, width) for a cubic spline."""

    times: NDArray[np.float64]
    values: NDArray[np.float64]
    way: str

    def at(self, time: float) -> NDArray[np.float64]:
        is_cubic = self.way == "CUBICSPLINE"
        points = self.values[1::3] if is_cubic else self.values
        after = bisect_right(self.times, time)
        if after == 0 or after == len(self.times):
            return np.array(points[min(after, len(points) - 1)])
        start, end = points[after - 1], points[after]
        span = self.times[after] - self.times[after - 1]
        part = (time - self.times[after - 1]) / span
        if self.way == "STEP":
            return np.array(start)
        if is_cubic:
            out, into = span * self.values[3 * after - 1], span * self.values[3 * after]
            two, three = part * part, part * part * part
            return np.asarray(
                (2 * three - 3 * two + 1) * start
                + (three - 2 * two + part) * out
                + (3 * two - 2 * three) * end
                + (three - two) * into
            )
        return _turned(start, end, part) if len(start) == 4 else (1 - part) * start + part * end


def gltf_cameras(path: Path, frame_rate: Fraction) -> tuple[SetCamera, ...]:
    """Return every camera that hangs on a node, in the order of the nodes.

    Parameters
    ----------
    path
        A ``.glb`` or ``.gltf`` file.
    frame_rate
        Of the cut: a camera that moves is read on each of its frames.

    Raises
    ------
    InputProblem
        The file is broken.
    """
    file = read_gltf(path)
    try:
        animated = _channels(file)
        return tuple(
            _camera(file, number, animated, frame_rate)
            for number, node in enumerate(file.tree.get("nodes", ()))
            if "camera" in node
        )
    except SHAPELESS as error:
        raise damaged(path) from error


def _camera(file: Gltf, number: int, animated: dict[tuple[int, str], _Channel], frame_rate: Fraction) -> SetCamera:
    node = file.tree["nodes"][number]
    camera = file.tree["cameras"][node["camera"]]
    chain = _chain(file, number)
    ends = [float(channel.times[-1]) for (on, _), channel in animated.items() if on in chain]
    frames = ceil(max(ends) * frame_rate - _HARDLY) + 1 if ends else 1
    if frames > MAX_FRAMES:
        raise input_problem(
            file.path,
            Message(
                "a camera moves for {frames} frames, more than the {most_frames} that are read",
                frames=frames,
                most_frames=MAX_FRAMES,
            ),
        )
    poses = np.stack([rigid(_pose(file, chain, animated, float(frame / frame_rate))) for frame in range(frames)])
    lens = camera[camera["type"]]
    if camera["type"] == "perspective":
        height, aspect = degrees(float(lens["yfov"])), float(lens.get("aspectRatio", 0.0))
        valid = 0 < height < 180
    else:
        height, aspect = 2 * float(lens["ymag"]), float(lens["xmag"]) / float(lens["ymag"])
        valid = height > 0
    if not valid or not np.isfinite([height, aspect]).all():
        raise damaged(file.path)
    name = str(node.get("name") or camera.get("name") or f"camera {node['camera'] + 1}")
    return SetCamera(name, camera["type"] == "perspective", height, aspect, poses)


def _pose(file: Gltf, chain: list[int], animated: dict[tuple[int, str], _Channel], time: float) -> Matrix:
    made = np.eye(4)
    for number in reversed(chain):
        made = made @ local_place(node := file.tree["nodes"][number], partial(_part, node, number, animated, time))
    return made


def _part(
    node: Tree, number: int, animated: dict[tuple[int, str], _Channel], time: float, name: str
) -> NDArray[np.float64]:
    """Return a part of a node's place at a time."""
    if (number, name) in animated:
        return animated[number, name].at(time)
    return np.array(node.get(name, RESTS[name]), np.float64)


def _chain(file: Gltf, number: int) -> list[int]:
    """Return a node and those that it hangs on."""
    chain = [number]
    while chain[-1] in file.parents:
        chain.append(file.parents[chain[-1]])
    return chain


def _channels(file: Gltf) -> dict[tuple[int, str], _Channel]:
    """Return what of the first animation moves cameras; others are takes of their own."""
    nodes = file.tree.get("nodes", ())
    moved = {on for number, node in enumerate(nodes) if "camera" in node for on in _chain(file, number)}
    found: dict[tuple[int, str], _Channel] = {}
    for animation in file.tree.get("animations", ())[:1]:
        for channel in animation["channels"]:
            target = channel["target"]
            if target.get("path") not in RESTS or target.get("node") not in moved:
                continue
            sampler = animation["samplers"][channel["sampler"]]
            times = numbers(file, sampler["input"], "SCALAR")[:, 0]
            values = numbers(file, sampler["output"], "VEC4" if target["path"] == "rotation" else "VEC3")
            way = sampler.get("interpolation", "LINEAR")
            expected = len(times) * (3 if way == "CUBICSPLINE" else 1)
            rises = len(times) > 0 and bool((np.diff(times) > 0).all())
            if not rises or len(values) != expected or not np.isfinite(values).all() or not np.isfinite(times).all():
                raise damaged(file.path)
            found[target["node"], target["path"]] = _Channel(times, values, way)
    return found


def _turned(start: NDArray[np.float64], end: NDArray[np.float64], part: float) -> NDArray[np.float64]:
    """Return a quaternion between two, on the shorter way."""
    cosine = float(start @ end)
    if cosine < 0:
        end, cosine = -end, -cosine
    if cosine > 1 - 1e-9:
        return (1 - part) * start + part * end
    angle = np.arccos(min(cosine, 1.0))
    return np.asarray((np.sin((1 - part) * angle) * start + np.sin(part * angle) * end) / np.sin(angle))
