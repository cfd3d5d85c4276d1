"""The set-up command's verbs: what they need, run and print."""

import ast
import importlib
import os
import re
import sys
import tomllib
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[2]


class Modules:
    """The modules of the set-up command, imported as the command itself imports them."""

    def __init__(self) -> None:
        self.dev: ModuleType = importlib.import_module("dev")
        self.system: ModuleType = importlib.import_module("dev_system")
        self.venv: ModuleType = importlib.import_module("dev_venv")
        self.display: ModuleType = importlib.import_module("dev_display")


@pytest.fixture
def modules(monkeypatch: pytest.MonkeyPatch) -> Modules:
    monkeypatch.syspath_prepend(str(ROOT / "packaging"))
    return Modules()


def test_the_python_range_is_the_project_s(modules: Modules) -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    oldest, newest = modules.dev.OLDEST, modules.dev.NEWEST
    assert project["requires-python"] == f">={oldest[0]}.{oldest[1]},<{newest[0]}.{newest[1] + 1}"
    assert modules.dev.python_problem(oldest) is None
    assert modules.dev.python_problem(newest) is None
    assert modules.dev.python_problem((3, 10)) == "Kagezou needs Python 3.11 to 3.14; this is 3.10."
    assert modules.dev.python_problem((3, 15)) is not None


@pytest.mark.parametrize("name", ["dev", "dev_system", "dev_venv", "dev_display", "dev_lock"])
def test_an_older_python_gets_as_far_as_the_sentence(name: str) -> None:
    text = (ROOT / "packaging" / f"{name}.py").read_text(encoding="utf-8")
    tree = ast.parse(text, feature_version=(3, 8))
    assert any(isinstance(node, ast.ImportFrom) and node.module == "__future__" for node in tree.body)
    imported = {alias.name for node in ast.walk(tree) if isinstance(node, ast.Import) for alias in node.names} | {
        node.module or "" for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)
    }
    ours = {"dev_system", "dev_venv", "dev_display", "dev_translations", "dev_lock"}
    assert {module.split(".")[0] for module in imported} - ours <= sys.stdlib_module_names


@pytest.mark.parametrize("arguments", [[], ["demonstrate"], ["lint", "app"]])
def test_a_wrong_command_line_shows_the_verbs(
    modules: Modules, capsys: pytest.CaptureFixture[str], arguments: list[str]
) -> None:
    assert modules.dev.main(arguments) == 2
    shown = capsys.readouterr().err
    assert all(re.search(rf"dev\.py {verb}\b", shown) for verb in modules.dev.VERBS)


def test_a_problem_is_one_sentence_and_not_a_traceback(
    modules: Modules, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def stop(*_: object, **__: object) -> int:
        raise modules.system.SetupProblem("Something is missing.")

    monkeypatch.setattr(modules.dev, "run_verb", stop)
    monkeypatch.setattr(modules.dev.signal, "signal", quiet_signal)
    assert modules.dev.main(["setup"]) == 1
    assert capsys.readouterr().err == "Something is missing.\n"


def quiet_signal(*_: object) -> None:
    pass


@pytest.mark.parametrize(
    ("failing", "tests", "code"), [(None, 0, 0), ("mypy", 0, 1), ("ruff check", 0, 1), (None, 5, 5), ("mypy", 5, 5)]
)
@pytest.mark.parametrize("part", [[], ["tests/io"]])
def test_every_check_runs_and_any_failure_counts(
    modules: Modules, monkeypatch: pytest.MonkeyPatch, failing: str | None, tests: int, code: int, part: list[str]
) -> None:
    ran: list[str] = []
    beside: list[str] = []

    def name_of(command: list[str]) -> str:
        return next((one for one, arguments in modules.dev.CHECKS if tuple(command[1:]) == arguments), "pytest")

    def call(command: list[str], **_: Any) -> int:
        ran.append(name_of(command))
        return tests if ran[-1] == "pytest" else int(ran[-1] == failing)

    class Started:
        def __init__(self, command: list[str], **_: Any) -> None:
            beside.append(name_of(command))
            self.returncode = int(beside[-1] == failing)
            assert "pytest" not in ran, "from the beginning"

        def communicate(self) -> tuple[str, None]:
            return "", None

    monkeypatch.setattr(modules.dev, "set_up", lambda _, **__: modules.venv.Environment(ROOT, (3, 11)))
    monkeypatch.setattr(modules.dev.subprocess, "call", call)
    monkeypatch.setattr(modules.dev.subprocess, "Popen", Started)
    monkeypatch.setattr(modules.dev, "private_display", FakeDisplay)
    assert modules.dev.run_verb("test", part) == code
    checks = [name for name, _ in modules.dev.CHECKS]
    if part:
        assert (ran, beside) == ([*checks, "pytest"], [])
    else:
        assert (ran, beside) == (["ruff check", "ruff format", "lint-imports", "pytest", "pytest"], ["mypy"])


def test_what_runs_beside_says_what_it_found_and_ends_with_the_tests(
    modules: Modules, capfd: pytest.CaptureFixture[str]
) -> None:
    environment = SimpleNamespace(python=Path(sys.executable))
    wrong = ("types", ("-c", "print('x.py:1: error'); raise SystemExit(1)"))
    with modules.dev.checks_beside(environment, [wrong, ("others", ("-c", "print('none')"))]) as failed:
        pass
    assert failed == ["types"]
    said = capfd.readouterr().out
    assert "\n-- types\nx.py:1: error\n-- types: FAILED after " in said
    assert "\n-- others\nnone\n-- others: ok after " in said
    endless = ("endless", ("-c", "while True: pass"))
    with pytest.raises(SystemExit), modules.dev.checks_beside(environment, [endless]):
        raise SystemExit(143)
    assert "endless: FAILED" in capfd.readouterr().out


def test_all_of_every_sweep_is_tried_when_asked_for(modules: Modules, monkeypatch: pytest.MonkeyPatch) -> None:
    ran: list[tuple[list[str], str | None]] = []

    def call(command: list[str], *, env: dict[str, str], **_: Any) -> int:
        ran.append((command, env.get("KAGEZOU_THOROUGH")))
        return 0

    monkeypatch.setattr(modules.dev.subprocess, "call", call)
    monkeypatch.setattr(modules.dev, "private_display", FakeDisplay)
    environment = modules.venv.Environment(ROOT, (3, 11))
    assert modules.dev.run_tests(environment, ["--thorough"]) == 0
    assert [thorough for _, thorough in ran] == ["1", "1"]
    assert modules.dev.run_tests(environment, ["tests/io", "--thorough"]) == 0
    assert (ran[-1][0][-1], ran[-1][1]) == ("tests/io", "1")
    assert modules.dev.run_tests(environment, ["tests/io"]) == 0
    assert ran[-1][1] is None


@pytest.mark.parametrize(
    ("verb", "started", "where"),
    [
        ("demo", ["-m", "kagezou", "demo", "x"], None),
        ("app", ["-m", "kagezou", "x"], None),
        ("endurance", [str(ROOT / "packaging" / "dev_endurance.py"), "x"], ROOT),
        ("hooks", ["-m", "pre_commit", "install"], ROOT),
        ("site", [str(ROOT / "packaging" / "dev_site.py")], ROOT),
    ],
)
def test_a_verb_starts_its_own_program_and_no_other(
    modules: Modules, monkeypatch: pytest.MonkeyPatch, verb: str, started: list[str], where: Path | None
) -> None:
    ran: list[tuple[list[str], object]] = []

    def call(command: list[str], cwd: Path | None = None, **_: Any) -> int:
        ran.append((command[1:], cwd))
        return 7

    monkeypatch.setattr(modules.dev, "set_up", lambda _, **__: modules.venv.Environment(ROOT, (3, 11)))
    monkeypatch.setattr(modules.dev.subprocess, "call", call)
    assert modules.dev.run_verb(verb, ["x"]) == 7
    assert ran == [(started, where)]


def test_every_verb_does_something_of_its_own(modules: Modules) -> None:
    others = {"test", "lint", "setup", "lock"}
    assert {*modules.dev.STARTED, *modules.dev.ALONE, *others} == set(modules.dev.VERBS)


class FakeDisplay:
    def __enter__(self) -> dict[str, str]:
        return {}

    def __exit__(self, *_: object) -> None:
        pass


@pytest.mark.parametrize(
    ("verb", "display", "needs_window"), [("demo", "", False), ("demo", ":0", True), ("app", "", True)]
)
def test_the_window_s_libraries_are_needed_only_where_a_window_can_open(
    modules: Modules, monkeypatch: pytest.MonkeyPatch, verb: str, display: str, *, needs_window: bool
) -> None:
    asked: list[tuple[list[Any], list[Any]]] = []
    monkeypatch.setenv("DISPLAY", display)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    monkeypatch.setattr(modules.dev, "supply", lambda needed, wished, *_: asked.append((needed, wished)))
    monkeypatch.setattr(modules.venv.Environment, "prepare", lambda *_: None)
    monkeypatch.setattr(modules.venv.Environment, "compile_sources", lambda _: None)
    modules.dev.set_up(verb)
    needed, wished = asked[0]
    assert set(modules.system.HEADLESS) <= set(needed)
    assert (set(modules.system.WINDOW) <= set(needed)) is needs_window
    assert set(modules.system.WINDOW) <= {*needed, *wished}


@pytest.mark.parametrize("verb", ["translate", "test", "setup"])
def test_what_qt_s_tools_for_translations_are_linked_with_is_there_where_they_run(
    modules: Modules, monkeypatch: pytest.MonkeyPatch, verb: str
) -> None:
    asked: list[list[Any]] = []
    monkeypatch.setattr(modules.dev, "supply", lambda needed, *_: asked.append(needed))
    monkeypatch.setattr(modules.venv.Environment, "prepare", lambda *_: None)
    monkeypatch.setattr(modules.venv.Environment, "compile_sources", lambda _: None)
    modules.dev.set_up(verb)
    assert set(modules.system.TRANSLATIONS) <= set(asked[0])
    assert len(asked[0]) == len(set(asked[0]))


@pytest.mark.parametrize(
    ("arguments", "ci", "asks"), [([], "", True), (["--yes"], "", False), ([], "true", False), ([], "0", True)]
)
def test_only_a_flag_or_a_ci_installs_without_asking(
    modules: Modules, monkeypatch: pytest.MonkeyPatch, arguments: list[str], ci: str, *, asks: bool
) -> None:
    asked: list[object] = []
    monkeypatch.setenv("CI", ci)
    monkeypatch.setattr(modules.dev, "supply", lambda _n, _w, _s, ask: asked.append(ask))
    monkeypatch.setattr(modules.venv.Environment, "prepare", lambda *_: None)
    monkeypatch.setattr(modules.venv.Environment, "compile_sources", lambda _: None)
    monkeypatch.setattr(modules.dev.signal, "signal", quiet_signal)
    assert modules.dev.main(["setup", *arguments]) == 0
    assert asked == [modules.system.may_install if asks else modules.system.always]


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux tests run on a virtual screen")
def test_the_private_screen_is_new_private_and_gone_afterwards(modules: Modules) -> None:
    with modules.display.private_display() as variables:
        assert variables["DISPLAY"] != os.environ.get("DISPLAY")
        socket = Path("/tmp/.X11-unix", f"X{variables['DISPLAY'].lstrip(':')}")
        assert socket.exists()
        runtime = Path(variables["XDG_RUNTIME_DIR"])
        assert runtime.stat().st_mode & 0o777 == 0o700
    assert not socket.exists()
    assert not runtime.exists()
