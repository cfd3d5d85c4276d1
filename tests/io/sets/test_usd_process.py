"""USD files are read in a process of their own: whatever becomes of that, the program gets a set or a sentence."""

import sys
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path

import pytest

from kagezou.errors import InputProblem
from kagezou.io.sets import usd
from kagezou.io.sets.cameras import cameras_of, up_axis_of
from kagezou.io.sets.mesh_cache import MeshCache, read_set
from tests.io.sets.usd_files import mesh, stage

pytest.importorskip("pxr", reason="the package usd-core is not installed")

MOVING = """
def Camera "cam" {
    double3 xformOp:translate.timeSamples = {1: (0, 0, 0), 25: (6, 0, 0)}
    uniform token[] xformOpOrder = ["xformOp:translate"]
}
"""
LENGTH = "startTimeCode = 1\nendTimeCode = 25\ntimeCodesPerSecond = 24\n"


@pytest.fixture
def runs(monkeypatch: pytest.MonkeyPatch) -> list[Path]:
    """Every process that is started."""
    made: list[Path] = []
    run = usd._run

    def counted(path: Path, rate: Fraction, out: Path) -> None:
        made.append(path)
        run(path, rate, out)

    monkeypatch.setattr(usd, "_run", counted)
    return made


@pytest.mark.parametrize(
    ("how", "sentence"),
    [("aborts", "cannot be read as USD"), ("writes half", "cannot be read as USD"), ("ends", "cannot be read as USD"),
     ("hangs", "takes longer than 1 seconds: given up")],
)  # fmt: skip
@pytest.mark.parametrize("ask", [read_set, up_axis_of, lambda path: cameras_of(path, Fraction(24))])
def test_a_process_that_fails_is_one_sentence(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, how: str, sentence: str, ask: Callable[[Path], object]
) -> None:
    monkeypatch.setattr(usd, "CHILD", "tests.io.sets.usd_children")
    monkeypatch.setattr(usd, "MAX_SECONDS", 1 if how == "hangs" else 60)
    monkeypatch.setenv("KAGEZOU_TEST_CHILD", how)
    path = stage(tmp_path / "a.usda", mesh("m"))
    with pytest.raises(InputProblem, match=sentence) as caught:
        ask(path)
    assert str(caught.value).startswith(str(path))
    monkeypatch.undo()
    assert len(read_set(path).mesh.triangles) == 2, "the next try is a new one"


@pytest.mark.skipif(sys.platform != "linux", reason="only there memory is bounded")
def test_a_process_that_needs_too_much_memory_says_so(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(usd, "CHILD", "tests.io.sets.usd_children")
    monkeypatch.setenv("KAGEZOU_TEST_CHILD", "needs memory")
    with pytest.raises(InputProblem, match="not enough memory"):
        read_set(stage(tmp_path / "a.usda", mesh("m")))


def test_triangles_cameras_and_axis_need_one_process(tmp_path: Path, runs: list[Path]) -> None:
    path = stage(tmp_path / "a.usda", mesh("m") + MOVING, 'upAxis = "Z"\n' + LENGTH)
    cache = MeshCache()
    assert len(cache.mesh(path).triangles) == 2
    (camera,) = cameras_of(path, Fraction(24))
    assert len(camera.poses) == 25
    assert up_axis_of(path) == "z"
    assert not cache.notes(path)
    assert runs == [path]
    (slow,) = cameras_of(path, Fraction(12))
    assert len(slow.poses) == 13
    assert slow.pose(13)[0, 3] == pytest.approx(6)
    assert runs == [path, path], "at another rate it stands elsewhere on each frame"


def test_a_still_stage_is_the_same_at_every_rate(tmp_path: Path, runs: list[Path]) -> None:
    path = stage(tmp_path / "a.usda", mesh("m") + 'def Camera "c" {}')
    for rate in (24, 25, 30):
        assert len(cameras_of(path, Fraction(rate))) == 1
    read_set(path)
    assert runs == [path]
    stage(path, mesh("m") + 'def Camera "c" {}\ndef Camera "d" {}')
    assert len(cameras_of(path, Fraction(24))) == 2
    assert runs == [path, path], "the file has changed"


def test_a_camera_that_makes_no_sense_leaves_the_set_alone_and_the_other_way_round(tmp_path: Path) -> None:
    path = stage(tmp_path / "a.usda", mesh("m") + 'def Camera "c" {\n float focalLength = nan\n}\n')
    assert len(read_set(path).mesh.triangles) == 2
    with pytest.raises(InputProblem, match="makes no sense"):
        cameras_of(path, Fraction(24))
    path = stage(tmp_path / "b.usda", mesh("m").replace("[4]", "[5]") + 'def Camera "c" {}')
    assert len(cameras_of(path, Fraction(24))) == 1
    with pytest.raises(InputProblem, match="missing corner"):
        read_set(path)


def test_without_the_package_the_command_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(usd, "find_spec", lambda _: None)
    with pytest.raises(InputProblem, match="pip install 'usd-core>="):
        read_set(stage(tmp_path / "a.usda", mesh("m")))
