"""How workers of a farm get the program: an environment for pip that runs, and a recipe for conda that stays true."""

import os
import re
import subprocess
import sys
import sysconfig
import tomllib
from pathlib import Path
from typing import Any

import pytest
import yaml

from kagezou import __version__
from kagezou.export.farm import FarmRequest, write_bundle
from kagezou.export.request import ExportRequest
from kagezou.io.project.file import save
from tests.export.small_cuts import bytes_below, cut, export
from tests.packaging.test_wheel import OFFLINE, ROOT, pip

ENVIRONMENT = ROOT / "packaging/farm/pip_environment.yaml"
CONDA_NAMES = {
    "pyopengl": "pyopengl",
    "openimageio": "py-openimageio",
    "isal": "python-isal",
    "mapbox-earcut": "mapbox_earcut",
    "pyside6-essentials": "pyside6",
    "zlib-ng": "python-zlib-ng",
}


def openjd(*words: str, **more: str) -> subprocess.CompletedProcess[str]:
    command = [str(Path(sys.executable).with_name("openjd")), *words]
    environment = {**os.environ, **more}
    return subprocess.run(command, capture_output=True, text=True, check=False, timeout=300, env=environment)


def test_the_environment_passes_the_specifications_own_checks() -> None:
    done = openjd("check", str(ENVIRONMENT))
    assert done.returncode == 0, done.stdout
    assert "passes validation" in done.stdout


@pytest.mark.skipif(os.name != "posix", reason="Python is called python3")
def test_a_worker_that_has_nothing_gets_the_program_and_renders(tmp_path: Path) -> None:
    built = pip("wheel", "--no-deps", "--wheel-dir", str(tmp_path / "wheels"), str(ROOT))
    if built.returncode != 0 and any(sign in built.stdout + built.stderr for sign in OFFLINE):
        pytest.skip("the build backend cannot be fetched: no package index is reachable")
    (wheel,) = (tmp_path / "wheels").glob("kagezou-*.whl")
    document = cut(tmp_path / "in", 2)
    save(document, tmp_path / "cut.kage")
    job = FarmRequest(tmp_path / "cut.kage", ExportRequest(tmp_path / "farm"))
    write_bundle(document, job, tmp_path / "job")
    words = ["run", str(tmp_path / "job/template.json"), "--step", "Render", "--environment", str(ENVIRONMENT)]
    given = {
        "ProjectFile": tmp_path / "cut.kage",
        "OutputDir": tmp_path / "farm",
        "KagezouPackage": wheel,
        # What the program needs is taken from this environment; the program itself is not.
        "PipArguments": "--no-deps --no-index",
        "Python": sys.executable,
    }
    words += [word for name, value in given.items() for word in ("-p", f"{name}={value}")]
    done = openjd(*words, PYTHONPATH=sysconfig.get_path("purelib"), PATH="/usr/bin:/bin")
    assert done.returncode == 0, done.stdout
    assert "kagezou-environment" in done.stdout
    export(document, tmp_path / "local")
    assert bytes_below(tmp_path / "farm") == bytes_below(tmp_path / "local")


def test_a_worker_that_cannot_get_it_says_so(tmp_path: Path) -> None:
    document = cut(tmp_path / "in", 1)
    save(document, tmp_path / "cut.kage")
    write_bundle(document, FarmRequest(tmp_path / "cut.kage", ExportRequest(tmp_path / "farm")), tmp_path / "job")
    words = ["run", str(tmp_path / "job/template.json"), "--step", "Render", "--environment", str(ENVIRONMENT)]
    words += ["-p", f"ProjectFile={tmp_path / 'cut.kage'}", "-p", f"OutputDir={tmp_path / 'farm'}"]
    words += ["-p", f"Python={sys.executable}", "-p", "KagezouPackage=./nothing.whl", "-p", "PipArguments=--no-index"]
    done = openjd(*words)
    assert done.returncode != 0
    assert "openjd_fail: pip cannot install ./nothing.whl" in done.stdout


def test_the_conda_recipe_needs_what_the_project_needs() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    recipe: Any = yaml.safe_load((ROOT / "packaging/conda/recipe.yaml").read_text())
    assert recipe["context"]["version"] == __version__
    wanted = {"python": project["requires-python"]}
    for line in project["dependencies"]:
        found = re.fullmatch(r"([A-Za-z0-9-]+)([<>=,.0-9]+)(?:;.*)?", line.replace(" ", "").split(";")[0])
        assert found, line
        # The last of several lines for one package is that of the newest Python.
        wanted[CONDA_NAMES.get(found[1].lower(), found[1].lower())] = found[2]
    assert dict(line.split(" ", 1) for line in recipe["requirements"]["run"]) == wanted
    assert {each.split(" = ")[0] for each in recipe["build"]["python"]["entry_points"]} == {"kagezou"}
