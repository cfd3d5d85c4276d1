"""When the set-up command makes, mends, keeps or believes the private Python environment."""

import importlib
import os
import subprocess
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[2]


class Modules:
    """The modules of the set-up command, imported as the command itself imports them."""

    def __init__(self) -> None:
        self.system: ModuleType = importlib.import_module("dev_system")
        self.venv: ModuleType = importlib.import_module("dev_venv")


@pytest.fixture
def modules(monkeypatch: pytest.MonkeyPatch) -> Modules:
    monkeypatch.syspath_prepend(str(ROOT / "packaging"))
    return Modules()


@pytest.fixture
def environment(modules: Modules, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Any:
    (tmp_path / "pyproject.toml").write_text("[project]\n", encoding="utf-8")
    monkeypatch.setattr(modules.venv, "reason_not_to_lock", str)
    return modules.venv.Environment(tmp_path, (3, 11))


@pytest.fixture
def commands(modules: Modules, monkeypatch: pytest.MonkeyPatch) -> list[list[str]]:
    """Replace making and filling environments by a record and an empty interpreter file."""
    seen: list[list[str]] = []

    def run(command: list[str], _: str) -> None:
        seen.append(command)
        if "venv" in command:
            python = modules.venv.Environment(Path(command[-1]).parent, (3, 11)).python
            python.parent.mkdir(parents=True)
            python.touch()

    monkeypatch.setattr(modules.venv, "run_quietly", run)
    return seen


def quiet(_: str) -> None:
    pass


def test_the_first_run_makes_and_fills_and_the_second_does_nothing(environment: Any, commands: list[list[str]]) -> None:
    environment.prepare("dev", quiet)
    make, fill, lay = commands
    assert make[-2:] == ["venv", str(environment.folder)]
    assert fill[-3:-1] == ["--require-hashes", "--requirement"]
    assert Path(fill[-1]) == environment.root / "packaging" / "requirements" / "dev.txt"
    assert lay[-4:] == ["--no-deps", "--no-build-isolation", "--editable", str(environment.root)]
    assert environment.is_ready("dev")
    assert not environment.unfinished_mark.exists()
    environment.prepare("dev", quiet)
    assert len(commands) == 3


@pytest.mark.skipif(os.name == "nt", reason="links need a right of their own on Windows")
def test_sources_are_compiled_even_where_python_may_not_write_what_it_compiles(
    environment: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    environment.python.parent.mkdir(parents=True)
    environment.python.symlink_to(sys.executable)
    source = environment.root / "app" / "room" / "module.py"
    source.parent.mkdir(parents=True)
    source.write_text("VALUE = 1\n", encoding="ascii")
    (source.parent / "broken.py").write_text("VALUE =\n", encoding="ascii")
    monkeypatch.setenv("PYTHONDONTWRITEBYTECODE", "1")
    environment.compile_sources()
    assert [each.name.split(".")[0] for each in source.parent.glob("__pycache__/*.pyc")] == ["module"]


def test_the_larger_installation_serves_the_smaller_need_and_not_the_other_way(
    environment: Any, commands: list[list[str]]
) -> None:
    environment.prepare("", quiet)
    assert environment.is_ready("")
    assert not environment.is_ready("dev")
    environment.stamp_file.write_text(environment.stamp("dev"), encoding="ascii")
    assert environment.is_ready("")
    assert commands[-1][-1] == str(environment.root)


def test_the_stamp_follows_pyproject_lock_extra_python_and_folder(
    modules: Modules, environment: Any, tmp_path: Path
) -> None:
    moved = tmp_path / "moved"
    moved.mkdir()
    (moved / "pyproject.toml").write_bytes((tmp_path / "pyproject.toml").read_bytes())
    stamps = {environment.stamp(""), environment.stamp("dev")}
    stamps.add(modules.venv.Environment(tmp_path, (3, 12)).stamp(""))
    stamps.add(modules.venv.Environment(moved, (3, 11)).stamp(""))
    (tmp_path / "pyproject.toml").write_text("[project]\nname = 'x'\n", encoding="utf-8")
    stamps.add(environment.stamp(""))
    lock = modules.venv.lock_file(tmp_path, "")
    lock.parent.mkdir(parents=True)
    lock.write_text("numpy==2\n", encoding="utf-8")
    stamps.add(environment.stamp(""))
    assert len(stamps) == 6


def test_a_system_too_old_for_the_lock_takes_what_fits_and_says_why(
    modules: Modules, environment: Any, commands: list[list[str]], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(modules.venv, "reason_not_to_lock", lambda: "it is old")
    said: list[str] = []
    environment.prepare("dev", said.append)
    assert commands[-1][-2:] == ["--editable", f"{environment.root}[dev]"]
    assert "--require-hashes" not in commands[-1]
    assert any("as it is old." in each for each in said)


@pytest.mark.usefixtures("commands")
def test_an_interrupted_set_up_is_made_anew(environment: Any) -> None:
    environment.prepare("", quiet)
    environment.unfinished_mark.touch()
    leftover = environment.folder / "half-written"
    leftover.touch()
    assert not environment.is_ready("")
    environment.prepare("", quiet)
    assert not leftover.exists()
    assert environment.is_ready("")


@pytest.mark.usefixtures("commands")
def test_a_failed_install_is_not_taken_for_a_finished_one(
    modules: Modules, environment: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    environment.prepare("", quiet)
    (environment.root / "pyproject.toml").write_text("[project]\nname = 'x'\n", encoding="utf-8")
    monkeypatch.setattr(modules.venv.Environment, "is_usable", lambda _: True)

    def fail(_: list[str], problem: str) -> None:
        raise modules.system.SetupProblem(problem)

    monkeypatch.setattr(modules.venv, "run_quietly", fail)
    with pytest.raises(modules.system.SetupProblem):
        environment.prepare("", quiet)
    assert environment.unfinished_mark.exists()
    assert not environment.is_ready("")


def test_a_hand_made_environment_of_the_right_python_is_kept(
    modules: Modules, environment: Any, commands: list[list[str]], monkeypatch: pytest.MonkeyPatch
) -> None:
    environment.python.parent.mkdir(parents=True)
    environment.python.touch()
    monkeypatch.setattr(modules.venv.subprocess, "run", lambda *_, **__: subprocess.CompletedProcess([], 0, "3 11\n"))
    environment.prepare("dev", quiet)
    assert [command[-2] for command in commands] == ["--requirement", "--editable"]


@pytest.mark.parametrize("said", ["3 12\n", "", "Traceback"])
def test_an_environment_of_another_python_is_rebuilt(
    modules: Modules, environment: Any, commands: list[list[str]], monkeypatch: pytest.MonkeyPatch, said: str
) -> None:
    environment.python.parent.mkdir(parents=True)
    environment.python.touch()
    monkeypatch.setattr(modules.venv.subprocess, "run", lambda *_, **__: subprocess.CompletedProcess([], 0, said))
    environment.prepare("dev", quiet)
    assert [command[-2] for command in commands] == ["venv", "--requirement", "--editable"]


def test_the_interpreter_that_runs_is_never_deleted(
    modules: Modules, environment: Any, commands: list[list[str]], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(modules.venv.sys, "prefix", str(environment.folder))
    with pytest.raises(modules.system.SetupProblem, match="a Python outside it"):
        environment.prepare("", quiet)
    assert commands == []


def test_a_removal_that_breaks_off_leaves_nothing_that_looks_usable(
    modules: Modules, environment: Any, commands: list[list[str]], monkeypatch: pytest.MonkeyPatch
) -> None:
    environment.prepare("", quiet)
    environment.unfinished_mark.touch()

    def break_off(folder: Path) -> None:
        (folder / "kagezou-unfinished").unlink()
        raise OSError("Directory not empty")

    monkeypatch.setattr(modules.venv.shutil, "rmtree", break_off)
    with pytest.raises(modules.system.SetupProblem, match="in use"):
        environment.prepare("", quiet)
    assert not environment.is_ready("")
    assert not environment.is_usable()
    assert len(commands) == 3
