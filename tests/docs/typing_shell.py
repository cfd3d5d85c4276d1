"""What a shell makes of a typed line, and why some lines are not typed in a test."""

import re
from functools import cache
from importlib import import_module
from pathlib import Path

from kagezou.__main__ import main
from kagezou.cli.arguments import Parser

_NETWORK = "takes packages from the network; tests/packaging tries the wheel and the set-up"
_SET_UP = "sets a whole environment up; tests/packaging/test_dev.py tests what it does"
_FARM = "hands work to a farm, or to its program; tests/packaging/test_workers.py runs the bundle"
_TOOL = "a program of its own that is not there everywhere"
_CHECKOUT = "works on the sources themselves"
NOT_RUN = {
    "kagezou demo": "the world of these tests is what it draws; tests/packaging/test_wheel.py runs it whole",
    "kagezou bench": "measures for minutes; tests/cli/bench tests its parts",
    "kagezou integrate": "changes the desktop of whoever runs it; tests/cli/verbs/test_integrate.py does so elsewhere",
    "kagezou render c012.kage -o c012_shadows --composite --watch": "goes on until it is stopped; tests/batch does so",
    "kagezou piece walk.kage add street mesh": "needs a set of a 3-D program; tests/cli/verbs/test_piece.py makes one",
    "kagezou render /cuts/walk.kage": "is filled in by a farm's manager",
    "kagezou farm --program": "names a program that all workers see",
    "pip install": _NETWORK,
    "python3 -m venv": _NETWORK,
    "python3 packaging/dev.py": _SET_UP,
    "python3 packaging/bundle.py": "packs for minutes; it tries what it packs itself",
    "python -m kagezou.io.project.format": _CHECKOUT,
    "python first.py": "test_the_first_script_runs runs it",
    "openjd run": _FARM,
    "deadline bundle": _FARM,
    "export KAGEZOU_AFTER_EXPORT": "names a script of a studio",
    "blender --python": _TOOL,
    "rattler-build": _TOOL,
}
"""Beginnings of lines that are not run, each with its reason."""


def reason_not_to_run(text: str) -> str:
    """Return why a line is not run; empty where it is."""
    return next((reason for start, reason in NOT_RUN.items() if text.startswith(start)), "")


def typed(words: list[str], folder: Path) -> list[str]:
    """Return words as a program gets them, with names of files in the place of patterns."""
    found: list[str] = []
    for word in words:
        names = (
            sorted(each.relative_to(folder).as_posix() for each in folder.glob(word))
            if re.search(r"[*?]", word)
            else []
        )
        found += names or [word.replace("$PWD", str(folder))]
    return found


def run(words: list[str], known: dict[tuple[str, ...], bytes]) -> int:
    """Run a command here and return its code; a project that was made of the same before, elsewhere, is laid here."""
    project, rest = Path(words[1] if words[1:] else ""), tuple(words[2:])
    if words[0] != "new":
        return main(words)
    if rest in known:
        project.write_bytes(known[rest])
        return 0
    code = main(words)
    if code == 0:
        known[rest] = project.read_bytes()
    return code


@cache
def help_of(verb: str) -> str:
    """Return what a command says of itself."""
    module = import_module(f"kagezou.cli.verbs.{verb.replace('-', '_')}")
    parser = Parser(verb, module.DESCRIPTION, module.EXAMPLES)
    module.add_arguments(parser)
    return parser.format_help()
