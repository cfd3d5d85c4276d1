"""The wheel, installed in a clean place: it finds what it draws with, and draws."""

import importlib.util
import os
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
OFFLINE = ("NewConnectionError", "Failed to establish", "No matching distribution found for hatchling", "timed out")


def pip(*arguments: str) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "PIP_RETRIES": "1", "PIP_DISABLE_PIP_VERSION_CHECK": "1"}
    command = [sys.executable, "-m", "pip", *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=False, timeout=300, env=environment)


@pytest.fixture(scope="module")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder that holds this project as its wheel brings it, and nothing else."""
    wheels, target = tmp_path_factory.mktemp("wheels"), tmp_path_factory.mktemp("target")
    built = pip("wheel", "--no-deps", "--wheel-dir", str(wheels), str(ROOT))
    said = built.stdout + built.stderr
    if built.returncode != 0 and any(sign in said for sign in OFFLINE):
        pytest.skip("the build backend cannot be fetched: no package index is reachable")
    assert built.returncode == 0, said
    (wheel,) = wheels.glob("kagezou-*.whl")
    placed = pip("install", "--no-deps", "--target", str(target), str(wheel))
    assert placed.returncode == 0, placed.stdout + placed.stderr
    return target


def run_installed(installed: Path, cwd: Path, arguments: Sequence[str]) -> subprocess.CompletedProcess[str]:
    # The path comes before site-packages, so the wheel wins over the editable installation under test.
    environment = {**os.environ, "PYTHONPATH": str(installed)}
    command = [sys.executable, *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=False, timeout=300, cwd=cwd, env=environment)


def test_the_wheel_carries_its_shaders_resources_and_manual(installed: Path, tmp_path: Path) -> None:
    program = (
        "from kagezou.locations import manual_folder, resource_folder, shader_folder\n"
        "for folder in (shader_folder(), resource_folder(), manual_folder()):\n"
        "    print(folder)\n"
        "    assert any(folder.iterdir()), folder\n"
    )
    done = run_installed(installed, tmp_path, ["-c", program])
    assert done.returncode == 0, done.stderr
    package = installed.resolve() / "kagezou"
    folders = [package / name for name in ("shaders", "resources", "docs")]
    assert [Path(line) for line in done.stdout.splitlines()] == folders


def test_the_wheel_carries_types_and_the_manuals_scripts(installed: Path, tmp_path: Path) -> None:
    package = installed / "kagezou"
    assert (package / "py.typed").is_file()
    assert list((package / "docs" / "scripts").glob("*.py"))
    done = run_installed(installed, tmp_path, ["-c", "import kagezou; print(kagezou.__file__, kagezou.Cut.__name__)"])
    assert done.stdout.split() == [str(package / "__init__.py"), "Cut"], done.stderr


@pytest.mark.skipif(importlib.util.find_spec("kagezou.__main__") is None, reason="the program has no door yet")
def test_the_wheel_renders_the_demo(installed: Path, tmp_path: Path) -> None:
    done = run_installed(installed, tmp_path, ["-m", "kagezou", "demo", str(tmp_path / "out")])
    assert done.returncode == 0, done.stderr
    pictures = list((tmp_path / "out").rglob("*.png"))
    assert pictures
    assert all(picture.stat().st_size > 0 for picture in pictures)
