"""What the set-up command asks of the system, composes for apt and says when it may not install."""

import importlib
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[2]


class Modules:
    """The modules of the set-up command, imported as the command itself imports them."""

    def __init__(self) -> None:
        self.system: ModuleType = importlib.import_module("dev_system")


@pytest.fixture
def modules(monkeypatch: pytest.MonkeyPatch) -> Modules:
    monkeypatch.syspath_prepend(str(ROOT / "packaging"))
    return Modules()


@pytest.fixture
def answer(monkeypatch: pytest.MonkeyPatch, modules: Modules) -> Callable[[str], None]:
    """Let every child process print a given text."""

    def set_answer(text: str, code: int = 0) -> None:
        def run(command: list[str], **_: Any) -> subprocess.CompletedProcess[str]:
            return subprocess.CompletedProcess(command, code, stdout=text, stderr="")

        monkeypatch.setattr(modules.system.subprocess, "run", run)

    return set_answer


class Machine:
    """A pretended Linux: what it has and offers, what was run on it and what was said."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, system: ModuleType) -> None:
        self.installed: set[str] = set()
        self.available: set[str] = set()
        self.apt = True
        self.root: list[str] | None = []
        self.commands: list[list[str]] = []
        self.sentences: list[str] = []
        self.failing: tuple[str, ...] = ()
        monkeypatch.setattr(system.sys, "platform", "linux")
        monkeypatch.setattr(system, "has_apt", lambda: self.apt)
        monkeypatch.setattr(system, "way_to_root", lambda: self.root)
        monkeypatch.setattr(system, "installed_packages", lambda names: self.installed & set(names))
        monkeypatch.setattr(system, "available_packages", lambda names: self.available & set(names))
        monkeypatch.setattr(system, "is_found", lambda probe: probe == "")

        def run(command: list[str], problem: str) -> None:
            self.commands.append(list(command))
            if any(word in command for word in self.failing):
                raise system.SetupProblem(problem)

        monkeypatch.setattr(system, "run_quietly", run)


@pytest.fixture
def machine(monkeypatch: pytest.MonkeyPatch, modules: Modules) -> Machine:
    return Machine(monkeypatch, modules.system)


def names_of(libraries: Any) -> list[str]:
    return [library.packages[-1] for library in libraries]


def test_dpkg_counts_only_fully_installed_packages(modules: Modules, answer: Callable[[str], None]) -> None:
    answer("libegl1 installed\nlibgl1 config-files\nxvfb not-installed\nlibdbus-1-3 half-installed\n")
    assert modules.system.installed_packages(["libegl1", "libgl1", "xvfb", "libdbus-1-3"]) == {"libegl1"}


def test_apt_offers_only_packages_with_a_candidate(modules: Modules, answer: Callable[[str], None]) -> None:
    answer(
        "libglib2.0-0:\n  Installed: (none)\n  Candidate: (none)\n  Version table:\n"
        "libglib2.0-0t64:\n  Installed: (none)\n  Candidate: 2.80.0-6\n  Version table:\n     2.80.0-6 500\n"
    )
    assert modules.system.available_packages(["libglib2.0-0", "libglib2.0-0t64"]) == {"libglib2.0-0t64"}


@pytest.mark.parametrize(
    ("offered", "chosen"),
    [
        ({"libglib2.0-0t64"}, "libglib2.0-0t64"),
        ({"libglib2.0-0"}, "libglib2.0-0"),
        ({"libglib2.0-0", "libglib2.0-0t64"}, "libglib2.0-0t64"),
        (set(), "libglib2.0-0"),
    ],
)
def test_the_name_of_glib_is_the_release_s_own(modules: Modules, offered: set[str], chosen: str) -> None:
    glib = [library for library in modules.system.WINDOW if library.words == "GLib 2"]
    assert modules.system.package_names(glib, offered) == [chosen]


def test_a_package_under_its_newer_name_is_not_missing(modules: Modules, machine: Machine) -> None:
    machine.installed = {"libglib2.0-0t64", "libdbus-1-3"}
    missing = names_of(modules.system.missing_libraries(modules.system.WINDOW))
    assert "libglib2.0-0" not in missing
    assert "libdbus-1-3" not in missing
    assert "libxcb-cursor0" in missing


def test_root_refreshes_once_then_installs_only_what_is_missing(modules: Modules, machine: Machine) -> None:
    machine.installed = {"libegl1"}
    modules.system.supply(modules.system.HEADLESS, (), machine.sentences.append)
    update, install = machine.commands
    assert update[-1] == "update"
    assert install[:3] == ["env", "DEBIAN_FRONTEND=noninteractive", "apt-get"]
    assert "--no-install-recommends" in install
    assert install[-2:] == ["libgl1", "libgl1-mesa-dri"]


def test_sudo_stands_before_the_whole_command(modules: Modules, machine: Machine) -> None:
    machine.root = ["sudo", "-n"]
    modules.system.supply(modules.system.HEADLESS, (), machine.sentences.append)
    assert [command[:3] for command in machine.commands] == [["sudo", "-n", "apt-get"], ["sudo", "-n", "env"]]


def test_nothing_missing_runs_and_says_nothing(modules: Modules, machine: Machine) -> None:
    machine.installed = {"libegl1", "libgl1", "libgl1-mesa-dri"}
    modules.system.supply(modules.system.HEADLESS, (), machine.sentences.append)
    assert machine.commands == []
    assert machine.sentences == []


def test_a_broken_package_source_does_not_stop_the_install(modules: Modules, machine: Machine) -> None:
    machine.failing = ("update",)
    modules.system.supply(modules.system.HEADLESS, (), machine.sentences.append)
    assert "install" in machine.commands[-1]


def test_what_is_going_to_be_installed_is_said_before_anything_runs(modules: Modules, machine: Machine) -> None:
    machine.installed = {"libegl1"}
    said: list[tuple[str, int]] = []
    modules.system.supply(modules.system.HEADLESS, (), lambda text: said.append((text, len(machine.commands))))
    first, ran = said[0]
    assert ran == 0
    assert "\n" not in first
    assert "2 system packages" in first
    assert "libgl1 libgl1-mesa-dri" in first


def test_a_no_installs_nothing_and_says_what_to_type(modules: Modules, machine: Machine) -> None:
    with pytest.raises(modules.system.SetupProblem, match="Nothing was installed; add --yes, or type: sudo apt-get"):
        modules.system.supply(modules.system.HEADLESS, (), machine.sentences.append, lambda _: False)
    modules.system.supply((), modules.system.WINDOW, machine.sentences.append, lambda _: False)
    assert machine.sentences[-1].endswith("going on.)")
    assert machine.commands == []


@pytest.mark.parametrize(
    ("terminal", "answer", "root", "goes_on"),
    [
        (True, "y", ["sudo", "-n"], True),
        (True, "YES", [], True),
        (True, "", [], False),
        (True, "n", ["sudo", "-n"], False),
        (False, "y", ["sudo", "-n"], False),
        (False, "", [], True),
    ],
)
def test_whoever_sits_at_a_terminal_is_asked(
    modules: Modules, monkeypatch: pytest.MonkeyPatch, answer: str, root: list[str], *, terminal: bool, goes_on: bool
) -> None:
    monkeypatch.setattr(modules.system.sys.stdin, "isatty", lambda: terminal, raising=False)
    monkeypatch.setattr("builtins.input", lambda _: answer)
    assert modules.system.may_install(root) is goes_on


def test_a_terminal_that_closes_is_a_no(modules: Modules, monkeypatch: pytest.MonkeyPatch) -> None:
    def ends(_: str) -> str:
        raise EOFError

    monkeypatch.setattr(modules.system.sys.stdin, "isatty", lambda: True, raising=False)
    monkeypatch.setattr("builtins.input", ends)
    assert not modules.system.may_install([])


def test_without_root_the_sentence_holds_the_line_to_type(modules: Modules, machine: Machine) -> None:
    machine.root = None
    machine.available = {"libglib2.0-0t64"}
    with pytest.raises(modules.system.SetupProblem) as stopped:
        modules.system.supply(modules.system.WINDOW, (), machine.sentences.append)
    sentence = str(stopped.value)
    assert "\n" not in sentence
    line = "sudo apt-get update && sudo apt-get install -y --no-install-recommends libglib2.0-0t64 libdbus-1-3 "
    assert line in sentence
    assert machine.commands == []


def test_without_root_a_missing_wish_is_only_mentioned(modules: Modules, machine: Machine) -> None:
    machine.root = None
    machine.installed = {"libegl1", "libgl1", "libgl1-mesa-dri"}
    modules.system.supply(modules.system.HEADLESS, modules.system.WINDOW, machine.sentences.append)
    assert len(machine.sentences) == 1
    assert "libxcb-cursor0" in machine.sentences[0]


def test_without_apt_the_libraries_are_named_in_words(modules: Modules, machine: Machine) -> None:
    machine.apt = False
    with pytest.raises(modules.system.SetupProblem, match=r"package manager: EGL, OpenGL \(libGL\)\.$"):
        modules.system.supply(modules.system.HEADLESS, (), machine.sentences.append)


def test_other_systems_need_no_system_libraries(
    modules: Modules, machine: Machine, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(modules.system.sys, "platform", "win32")
    modules.system.supply(modules.system.HEADLESS, modules.system.WINDOW, machine.sentences.append)
    assert machine.commands == []


def test_a_python_without_ensurepip_asks_for_its_own_venv_package(
    modules: Modules, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(modules.system.importlib.util, "find_spec", lambda name: None if name == "ensurepip" else name)
    (library,) = modules.system.virtual_environment_support((3, 12))
    assert library.packages == ("python3.12-venv",)


def test_probes_find_programs_modules_and_libraries(modules: Modules) -> None:
    found = modules.system.is_found
    assert found("")
    assert found("import ensurepip_no_such") is False
    assert found("import json")
    assert found("libnosuchlibrary.so.9") is False
    assert found("no-such-program") is False


def test_a_failed_command_shows_its_end_and_stops_with_a_sentence(
    modules: Modules, capfd: pytest.CaptureFixture[str]
) -> None:
    command = [sys.executable, "-c", "print('the cause'); raise SystemExit(7)"]
    with pytest.raises(modules.system.SetupProblem, match="It failed with code 7"):
        modules.system.run_quietly(command, "It failed")
    assert "the cause" in capfd.readouterr().out
