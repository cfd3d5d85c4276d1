"""The example of a Rez package: evaluated with what Rez would give it, and by Rez where that is installed."""

import runpy
import tomllib
from collections import defaultdict
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest

from kagezou.version import __version__

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "packaging" / "rez" / "package.py"


class Variables:
    """Stands for Rez's ``env``: keeps what is appended to each variable."""

    def __init__(self) -> None:
        self.appended: dict[str, list[str]] = defaultdict(list)

    def __getattr__(self, name: str) -> Any:
        return self.appended[name]


def evaluated() -> dict[str, Any]:
    found: dict[str, Any] = {"env": Variables()}
    exec(compile(PACKAGE.read_text(encoding="utf-8"), str(PACKAGE), "exec"), found)
    return found


def test_it_is_of_this_version_and_python() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    package = evaluated()
    assert (package["name"], package["version"]) == (project["name"], __version__)
    low, high = project["requires-python"].removeprefix(">=").split(",<")
    assert package["requires"] == [f"python-{low}+<{high}"]
    assert set(package["tools"]) == {*project["scripts"], *project["gui-scripts"]}


def test_its_folders_are_those_that_the_program_looks_in() -> None:
    from kagezou.locations import PRESET_FOLDERS, SHORTCUT_FOLDERS, STYLE_FOLDERS

    package = evaluated()
    package["commands"]()
    appended = package["env"].appended
    assert {STYLE_FOLDERS, PRESET_FOLDERS, SHORTCUT_FOLDERS, "PATH", "PYTHONPATH"} == set(appended)
    assert all(each.startswith("{root}/") for each in (*appended["PATH"], *appended[STYLE_FOLDERS]))


def test_a_build_fills_the_folders_of_the_studio(tmp_path: Path) -> None:
    source, target = tmp_path / "source", tmp_path / "target"
    (source / "studio" / "styles").mkdir(parents=True)
    (source / "studio" / "styles" / "dusk.json").write_text("{}")
    build = runpy.run_path(str(PACKAGE.with_name("build.py")))
    build["fill_studio"](source, target)
    build["main"]([])
    found = {path.relative_to(target).as_posix() for path in target.rglob("*")}
    assert found == {"studio", "studio/styles", "studio/styles/dusk.json", "studio/presets", "studio/shortcuts"}


def has_rez() -> bool:
    """Whether Rez is installed; the folder of the example bears its name and is no module."""
    found = find_spec("rez")
    return found is not None and found.origin is not None


@pytest.mark.skipif(not has_rez(), reason="Rez is not installed")
def test_rez_reads_it() -> None:
    package = import_module("rez.packages").get_developer_package(str(PACKAGE.parent))
    assert (package.name, str(package.version)) == ("kagezou", __version__)
    assert package.tools == ["kagezou", "kagezou-window"]
