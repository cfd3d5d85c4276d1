"""Cameras of set files: where they stand, what they see, and how they move."""

from fractions import Fraction
from math import atan, cos, degrees, pi, sin
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from kagezou.errors import InputProblem
from kagezou.io.sets.cameras import cameras_of, up_axis_of
from kagezou.io.sets.mesh_cache import read_set
from tests.io.sets.mesh_files import glb, tree_with, triangle_tree

RATE = Fraction(24)
PERSPECTIVE = {"type": "perspective", "perspective": {"yfov": pi / 4, "aspectRatio": 1.5, "znear": 0.1}}
FLAT = {"type": "orthographic", "name": "front", "orthographic": {"xmag": 3.0, "ymag": 2.0, "zfar": 9, "znear": 0}}


def turned(angle: float) -> list[float]:
    """A turn about y as a quaternion."""
    return [0.0, sin(angle / 2), 0.0, cos(angle / 2)]


def moving(tmp_path: Path, way: str, output: NDArray[np.float64], path: str = "translation") -> Path:
    times = np.array([0.0, 0.5], "<f4")
    tree, data = tree_with([times, output.astype("<f4")])
    tree |= {
        "scenes": [{"nodes": [0]}],
        "nodes": [{"name": "cam", "camera": 0}],
        "cameras": [PERSPECTIVE],
        "animations": [
            {
                "samplers": [{"input": 0, "output": 1, "interpolation": way}],
                "channels": [
                    {"sampler": 0, "target": {"node": 0, "path": path}},
                    {"sampler": 0, "target": {"node": 0, "path": "weights"}},
                ],
            }
        ],
    }
    return glb(tmp_path / "a.glb", tree, data)


def test_cameras_of_one_name_are_told_apart(tmp_path: Path) -> None:
    tree, data = triangle_tree(
        cameras=[PERSPECTIVE],
        scenes=[{"nodes": [0, 1, 2]}],
        nodes=[{"name": "shot", "camera": 0}, {"name": "shot 2", "camera": 0}, {"name": "shot", "camera": 0}],
    )
    found = cameras_of(glb(tmp_path / "a.glb", tree, data), RATE)
    assert [camera.name for camera in found] == ["shot", "shot 2", "shot 3"]


def test_every_camera_with_its_lens_and_its_parents(tmp_path: Path) -> None:
    tree, data = triangle_tree(
        cameras=[PERSPECTIVE, FLAT],
        scenes=[{"nodes": [1]}],
        nodes=[
            {"mesh": 0},
            {"translation": [5, 0, 0], "rotation": turned(pi / 2), "scale": [2, 2, 2], "children": [2, 3]},
            {"name": "shot", "camera": 0, "translation": [0, 0, 1]},
            {"camera": 1},
        ],
    )
    shot, front = cameras_of(glb(tmp_path / "a.glb", tree, data), RATE)
    assert (shot.name, shot.is_perspective, shot.aspect) == ("shot", True, 1.5)
    assert shot.height == pytest.approx(45.0)
    assert (front.name, front.is_perspective, front.height, front.aspect) == ("front", False, 4.0, 1.5)
    assert shot.pose(1)[:3, 3] == pytest.approx([7, 0, 0]), "moved along the turned, scaled z"
    assert shot.pose(1)[:3, 2] == pytest.approx([1, 0, 0]), "and without the scale"
    assert np.linalg.det(shot.pose(1)[:3, :3]) == pytest.approx(1.0)


def test_a_way_is_read_on_every_frame(tmp_path: Path) -> None:
    (camera,) = cameras_of(moving(tmp_path, "LINEAR", np.array([[0, 0, 0], [6, 0, 0]])), RATE)
    assert len(camera.poses) == 13
    assert [camera.pose(frame)[0, 3] for frame in (1, 4, 13)] == pytest.approx([0.0, 1.5, 6.0])
    (jump,) = cameras_of(moving(tmp_path, "STEP", np.array([[0, 0, 0], [6, 0, 0]])), RATE)
    assert [jump.pose(frame)[0, 3] for frame in (1, 12, 13)] == pytest.approx([0.0, 0.0, 6.0])
    spline = np.array([[0, 0, 0], [0, 0, 0], [12, 0, 0], [12, 0, 0], [6, 0, 0], [0, 0, 0]])
    (eased,) = cameras_of(moving(tmp_path, "CUBICSPLINE", spline), RATE)
    # A Hermite spline with the slope of the straight way at both ends is the straight way.
    assert [eased.pose(frame)[0, 3] for frame in (1, 4, 13)] == pytest.approx([0.0, 1.5, 6.0])


def test_a_turn_goes_the_shorter_way_evenly(tmp_path: Path) -> None:
    end = [-part for part in turned(pi / 2)]
    (camera,) = cameras_of(moving(tmp_path, "LINEAR", np.array([turned(0), end]), "rotation"), RATE)
    assert camera.pose(5)[:3, 2] == pytest.approx([sin(pi / 6), 0, cos(pi / 6)], abs=1e-6)
    (still,) = cameras_of(moving(tmp_path, "LINEAR", np.array([turned(1), turned(1)]), "rotation"), RATE)
    assert still.pose(5)[:3, 2] == pytest.approx([sin(1), 0, cos(1)], abs=1e-6)


@pytest.mark.parametrize(
    "lens",
    [
        {"type": "perspective", "perspective": {"yfov": 0}},
        {"type": "perspective"},
        {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 0}},
        {"type": "fisheye", "fisheye": {}},
    ],
)
def test_a_broken_lens_is_one_sentence(tmp_path: Path, lens: dict[str, object]) -> None:
    tree, data = triangle_tree(cameras=[lens], nodes=[{"mesh": 0}, {"camera": 0}])
    with pytest.raises(InputProblem, match="not a complete glTF"):
        cameras_of(glb(tmp_path / "a.glb", tree, data), RATE)


def test_broken_ways_are_one_sentence(tmp_path: Path) -> None:
    for output in (np.zeros((3, 3)), np.full((2, 3), np.nan)):
        with pytest.raises(InputProblem, match="not a complete glTF"):
            cameras_of(moving(tmp_path, "LINEAR", output), RATE)
    path = moving(tmp_path, "LINEAR", np.zeros((2, 3)))
    with pytest.raises(InputProblem, match="more than the 20000"):
        cameras_of(path, Fraction(100_000))


def test_the_real_camera_is_the_one_it_was_made_from(samples: Path) -> None:
    import json

    folder = samples / "bg3d_dungeon_stairs"
    (camera,) = cameras_of(folder / "scene.glb", RATE)
    told = json.loads((folder / "camera.json").read_text())
    assert camera.name == "shot_cam"
    assert camera.height == pytest.approx(told["vfov_deg"])
    assert camera.pose(1) == pytest.approx(np.array(told["camera_to_world"]), abs=1e-5)
    assert not camera.is_animated
    assert up_axis_of(folder / "scene.glb") == "y"


def test_cameras_of_a_stage(tmp_path: Path) -> None:
    pytest.importorskip("pxr", reason="the package usd-core is not installed")
    path = tmp_path / "a.usda"
    path.write_text(
        '#usda 1.0\n(\n upAxis = "Z"\n startTimeCode = 1\n endTimeCode = 13\n timeCodesPerSecond = 24\n)\n'
        'def Camera "dolly" {\n float focalLength = 50\n float horizontalAperture = 36\n float verticalAperture = 24\n'
        " double3 xformOp:translate.timeSamples = {1: (0, 0, 0), 13: (6, 0, 0)}\n"
        ' uniform token[] xformOpOrder = ["xformOp:translate"]\n}\n'
        'def Camera "flat" {\n token projection = "orthographic"\n float verticalAperture = 40\n}\n'
    )
    dolly, flat = cameras_of(path, RATE)
    assert dolly.height == pytest.approx(26.9915, abs=1e-3)
    assert [dolly.pose(frame)[0, 3] for frame in (1, 4, 13, 40)] == pytest.approx([0.0, 1.5, 6.0, 6.0])
    assert (flat.is_perspective, flat.is_animated) == (False, False)
    assert flat.height == pytest.approx(4.0)
    assert up_axis_of(path) == "z"


def test_formats_without_cameras_have_none() -> None:
    assert cameras_of(Path("x.obj"), RATE) == ()


def test_a_usd_camera_may_zoom(tmp_path: Path) -> None:
    pytest.importorskip("pxr", reason="the package usd-core is not installed")
    (tmp_path / "a.usda").write_text(
        "#usda 1.0\n(\n startTimeCode = 0\n endTimeCode = 2\n timeCodesPerSecond = 24\n)\n"
        'def Camera "zoom" {\n float verticalAperture = 20\n float focalLength.timeSamples = { 0: 10, 2: 20 }\n}\n'
        'def Camera "still" {\n float verticalAperture = 20\n float focalLength = 10\n}\n'
    )
    zoom, still = cameras_of(tmp_path / "a.usda", RATE)
    assert zoom.heights == pytest.approx([2 * degrees(atan(10 / focal)) for focal in (10, 15, 20)])
    assert (len(zoom.poses), zoom.length_frames, still.length_frames) == (1, 3, 1)
    (tmp_path / "a.usda").write_text('#usda 1.0\ndef Camera "c" {\n float focalLength = nan\n}\n')
    with pytest.raises(InputProblem, match="makes no sense"):
        cameras_of(tmp_path / "a.usda", RATE)


@pytest.mark.parametrize("scale", [[-1, 1, 1], [1, -1, 1], [-2, 3, 1]])
def test_a_mirrored_camera_looks_where_it_looked_and_is_said(tmp_path: Path, scale: list[float]) -> None:
    nodes = [{"mesh": 0}, {"scale": scale, "children": [2]}, {"name": "shot", "camera": 0, "rotation": turned(0.3)}]
    tree, data = triangle_tree(cameras=[PERSPECTIVE], scenes=[{"nodes": [0, 1]}], nodes=nodes)
    path = glb(tmp_path / "a.glb", tree, data)
    (camera,) = cameras_of(path, RATE)
    back = np.array([sin(0.3), 0, cos(0.3)]) * scale
    assert camera.pose(1)[:3, 2] == pytest.approx(back / np.linalg.norm(back))
    assert np.linalg.det(camera.pose(1)[:3, :3]) == pytest.approx(1.0)
    assert camera.pose(1)[1, 1] == pytest.approx(np.sign(scale[1]))
    assert [str(note) for note in read_set(path).notes] == ["its cameras shot are mirrored, which is not done"]


def test_a_camera_under_uneven_scales_is_rigid(tmp_path: Path) -> None:
    nodes = [{"mesh": 0}, {"scale": [1, 5, 1], "children": [2]},
             {"camera": 0, "rotation": [sin(0.2), 0, 0, cos(0.2)]}]  # fmt: skip
    tree, data = triangle_tree(cameras=[PERSPECTIVE], scenes=[{"nodes": [0, 1]}], nodes=nodes)
    (camera,) = cameras_of(glb(tmp_path / "a.glb", tree, data), RATE)
    turn = camera.pose(1)[:3, :3]
    assert turn @ turn.T == pytest.approx(np.eye(3))
    back = np.array([0, -5 * sin(0.4), cos(0.4)])
    assert turn[:, 2] == pytest.approx(back / np.linalg.norm(back))


def test_a_broken_way_of_something_else_leaves_the_camera_alone(tmp_path: Path) -> None:
    tree, data = triangle_tree(cameras=[PERSPECTIVE], nodes=[{"mesh": 0}, {"camera": 0}], scenes=[{"nodes": [0, 1]}])
    channel = {"sampler": 0, "target": {"node": 0, "path": "translation"}}
    tree["animations"] = [{"samplers": [{"input": 0, "output": 99}], "channels": [channel]}]
    (camera,) = cameras_of(glb(tmp_path / "a.glb", tree, data), RATE)
    assert not camera.is_animated
    channel["target"] = {"node": 1, "path": "translation"}
    with pytest.raises(InputProblem):
        cameras_of(glb(tmp_path / "b.glb", tree, data), RATE)
