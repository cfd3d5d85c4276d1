"""One command from a fresh machine to a running program or to the tests' verdict.

::

    python3 packaging/dev.py demo [...]    set up, then render the demo
    python3 packaging/dev.py app [...]     set up, then start the program
    python3 packaging/dev.py test [...]    set up, then lint, types, floors and tests (arguments go to pytest)
    python3 packaging/dev.py test --thorough    the same with the whole of every sweep (an hour, not minutes)
    python3 packaging/dev.py endurance     set up, then work in the window for an hour; tells what grows (--minutes)
    python3 packaging/dev.py lint          set up, then lint, types and floors
    python3 packaging/dev.py setup         set up only
    python3 packaging/dev.py hooks         set up, then have git run the checks before every commit
    python3 packaging/dev.py site          set up, then make the manual as a website in build/site
    python3 packaging/dev.py pictures      set up, then make every picture of the docs anew
    python3 packaging/dev.py translate     set up, then bring the catalogues of translations up to date
    python3 packaging/dev.py lock          name the exact packages and their hashes anew, in packaging/requirements

What the system lacks is named first; it is installed after a yes at the terminal, with --yes, where CI is set, or by
root with no terminal to ask at. Python packages come in the locked versions, into .venv alone.

Needs nothing but a Python of the supported range; what is already done is not done again.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from threading import Thread

import dev_lock
from dev_display import private_display
from dev_system import (
    HEADLESS,
    TESTS,
    TRANSLATIONS,
    WINDOW,
    SetupProblem,
    always,
    may_install,
    supply,
    virtual_environment_support,
)
from dev_venv import Environment

ROOT = Path(__file__).resolve().parents[1]
OLDEST, NEWEST = (3, 11), (3, 14)
PROCESSES = min(os.cpu_count() or 1, 4)
IN_PARALLEL = ("--numprocesses", str(PROCESSES), "--dist", "loadscope")
"""Tests side by side, each process with a screen of its own."""
SINGLE_THREADS = {"LP_NUM_THREADS": "0", "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
"""For processes that share the cores: threads of their own for drawing and sums only get in each other's way."""
THOROUGH = "--thorough"
COVERED = ("tests/geometry", "tests/animation")
VERBS = ("demo", "app", "test", "lint", "setup", "hooks", "translate", "site", "pictures", "lock", "endurance")
PLAIN = ("lint", "setup", "hooks", "translate", "site", "pictures", "lock")
"""Verbs that take no arguments and read the sources alone, but for ``setup``."""
PICTURES = ("dev_style_pictures.py", "dev_filter_pictures.py", "dev_made_pictures.py", "dev_window_pictures.py")
CHECKS = (
    ("ruff check", ("-m", "ruff", "check", ".")),
    ("ruff format", ("-m", "ruff", "format", "--check", ".")),
    ("lint-imports", ("-c", "from importlinter.cli import lint_imports_command as run; run()")),
    ("mypy", ("-m", "mypy")),
)
BESIDE = CHECKS[-1:]
"""What takes a minute on one core: beside all of the tests, which leave parts of the cores idle."""


def say(sentence: str) -> None:
    """Print at once: child processes write to the same place."""
    print(sentence, flush=True)


def python_problem(version: tuple[int, int]) -> str | None:
    """Return why this Python will not do, or None."""
    if OLDEST <= version <= NEWEST:
        return None
    span = f"{OLDEST[0]}.{OLDEST[1]} to {NEWEST[0]}.{NEWEST[1]}"
    return f"Kagezou needs Python {span}; this is {version[0]}.{version[1]}."


def has_display(environment: Mapping[str, str]) -> bool:
    """Tell whether a window could open here."""
    return bool(environment.get("DISPLAY") or environment.get("WAYLAND_DISPLAY"))


def set_up(verb: str, *, yes: bool = False) -> Environment:
    """Bring system libraries and ``.venv`` to what the verb needs; ``yes`` installs without asking."""
    ask = always if yes or os.environ.get("CI", "") not in ("", "0", "false") else may_install
    environment = Environment(ROOT, sys.version_info[:2])
    extra = "" if verb in ("demo", "app") else "dev"
    support = () if environment.is_ready(extra) else virtual_environment_support(environment.version)
    if verb in ("lint", "hooks", "site"):  # read the sources, draw nothing
        supply(support, (), say, ask)
    elif verb == "translate":
        supply([*support, *TRANSLATIONS], (), say, ask)
    elif verb in ("test", "setup", "pictures", "endurance"):
        supply([*support, *HEADLESS, *WINDOW, *TESTS], (), say, ask)
    elif verb == "app" or has_display(os.environ):
        supply([*support, *HEADLESS, *WINDOW], (), say, ask)
    else:
        supply([*support, *HEADLESS], WINDOW, say, ask)
    environment.prepare(extra, say)
    environment.compile_sources()
    return environment


def run_checks(environment: Environment, checks: Sequence[tuple[str, tuple[str, ...]]] = CHECKS) -> list[str]:
    """Run checks that need no screen, also after one failed; return the names of those that failed."""
    failed = []
    for name, arguments in checks:
        say(f"-- {name}")
        started = time.monotonic()
        code = subprocess.call([str(environment.python), *arguments], cwd=ROOT)
        say(_outcome(name, code, started))
        if code != 0:
            failed.append(name)
    return failed


@contextmanager
def checks_beside(environment: Environment, checks: Sequence[tuple[str, tuple[str, ...]]]) -> Iterator[list[str]]:
    """Run checks beside the block, each telling what it found when it is done; yield names of those that failed.

    The names are complete when the block is left; where it is left by an exception, the checks end at once.
    """
    failed: list[str] = []
    running: list[tuple[subprocess.Popen[str], Thread]] = []

    def tell(name: str, process: subprocess.Popen[str], started: float) -> None:
        said = process.communicate()[0]
        if process.returncode != 0:
            failed.append(name)
        # In one piece, as the tests print at the same time.
        say(f"\n-- {name}\n{said}{_outcome(name, process.returncode, started)}")

    try:
        for name, arguments in checks:
            command = [str(environment.python), *arguments]
            process = subprocess.Popen(
                command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace"
            )
            teller = Thread(target=tell, args=(name, process, time.monotonic()))
            running.append((process, teller))
            teller.start()
        yield failed
    except BaseException:
        for process, _ in running:
            process.kill()
        raise
    finally:
        for _, teller in running:
            teller.join()


def _outcome(name: str, code: int, started: float) -> str:
    return f"-- {name}: {'ok' if code == 0 else 'FAILED'} after {time.monotonic() - started:.1f} s"


def run_tests(environment: Environment, arguments: Sequence[str]) -> int:
    """Run pytest on a screen of its own; the last line on stdout is pytest's summary."""
    # Counting covered lines makes tests slower, and only these rooms must be covered whole, by their own tests.
    covered = (*COVERED, "--cov", "--cov-report=term-missing:skip-covered", *IN_PARALLEL)
    others = (*(f"--ignore={folder}" for folder in COVERED), *IN_PARALLEL)
    failed = 0
    thorough = {"KAGEZOU_THOROUGH": "1"} if THOROUGH in arguments else {}
    arguments = _parts(arguments)
    with private_display() as screen:
        variables = {**SINGLE_THREADS, **screen, **thorough}
        for selection in (tuple(arguments),) if arguments else (covered, others):
            say("-- pytest")
            command = [str(environment.python), "-m", "pytest", *selection]
            failed = subprocess.call(command, cwd=ROOT, env=variables) or failed
    return failed


def _parts(arguments: Sequence[str]) -> list[str]:
    """Return what chooses a part of the tests."""
    return [each for each in arguments if each != THOROUGH]


def hooks(environment: Environment) -> int:
    """Have git run the checks before every commit."""
    return subprocess.call([str(environment.python), "-m", "pre_commit", "install"], cwd=ROOT)


def translate(environment: Environment) -> int:
    """Bring the catalogues up to date, and name what still has no translation."""
    # Only here: set-up itself must be readable by an older Python, to say that it is too old.
    import dev_translations

    place = [str(environment.python), "-c", "import PySide6; print(PySide6.__path__[0])"]
    tools = Path(subprocess.run(place, capture_output=True, text=True, check=True).stdout.strip())
    dev_translations.update(tools)
    for text in dev_translations.unfinished():
        say(f"not translated: {text}")
    return 0


def site(environment: Environment) -> int:
    """Make the manual as a website."""
    command = [str(environment.python), str(ROOT / "packaging" / "dev_site.py")]
    return subprocess.call(command, cwd=ROOT, env={**os.environ, "QT_QPA_PLATFORM": "offscreen"})


def pictures(environment: Environment) -> int:
    """Make every picture of the docs anew, on a screen of its own."""
    with private_display() as screen:
        for name in PICTURES:
            say(f"-- {name}")
            code = subprocess.call([str(environment.python), str(ROOT / "packaging" / name)], cwd=ROOT, env=screen)
            if code:
                return code
    return 0


STARTED = {
    "demo": ("-m", "kagezou", "demo"),
    "app": ("-m", "kagezou"),
    "endurance": (str(ROOT / "packaging" / "dev_endurance.py"),),
}
"""What verbs start that hand their arguments on; the program works where it is called."""
ALONE = {"hooks": hooks, "translate": translate, "site": site, "pictures": pictures}
"""Verbs that need nothing but an environment."""


def run_verb(verb: str, arguments: Sequence[str], *, yes: bool = False) -> int:
    """Set up for the verb, do it, and return the exit code."""
    if verb == "lock":
        dev_lock.make(ROOT, say)
        return 0
    environment = set_up(verb, yes=yes)
    if verb == "setup":
        say(f"Ready: {environment.python}")
        return 0
    if verb in ALONE:
        return ALONE[verb](environment)
    if verb in STARTED:
        command = [str(environment.python), *STARTED[verb], *arguments]
        return subprocess.call(command, cwd=ROOT if verb == "endurance" else None)
    # A part of the tests may be done sooner than what runs beside, and the last line is pytest's.
    beside = BESIDE if verb == "test" and not _parts(arguments) else ()
    failed = run_checks(environment, [each for each in CHECKS if each not in beside])
    if failed:
        say(f"Failed: {', '.join(failed)}.")
    if verb == "lint":
        return int(bool(failed))
    with checks_beside(environment, beside) as failed_beside:
        code = run_tests(environment, arguments)
    if failed_beside:
        sys.stderr.write(f"Failed: {', '.join(failed_beside)}.\n")
    return code or int(bool(failed or failed_beside))


def main(arguments: Sequence[str]) -> int:
    """Obey the command line; every foreseeable failure is one sentence and a code other than 0."""
    problem = python_problem(sys.version_info[:2])
    if problem:
        sys.stderr.write(f"{problem}\n")
        return 1
    yes = "--yes" in arguments
    arguments = [each for each in arguments if each != "--yes"]
    if not arguments or arguments[0] not in VERBS or (arguments[0] in PLAIN and arguments[1:]):
        wants_help = bool(arguments) and arguments[0] in ("-h", "--help")
        (sys.stdout if wants_help else sys.stderr).write(__doc__ or "")
        return 0 if wants_help else 2
    # As an exception, so that the virtual screen is taken down on the way out.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    try:
        return run_verb(arguments[0], arguments[1:], yes=yes)
    except SetupProblem as stop:
        sys.stderr.write(f"{stop}\n")
        return 1
    except KeyboardInterrupt:
        sys.stderr.write("Stopped.\n")
        return 130


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
