"""What a shell makes of a typed line, and why some lines are not typed in a test."""

import glob
import re
from functools import cache
from importlib import import_module
from pathlib import Path

from kagezou.cli.arguments import Parser

_WHERE_IT_IS_TESTED = "tests/packaging runs it"
_INSTALLS = "installs packages from the network"
_OTHER_PROGRAM = "another program, that is not there everywhere"
NOT_RUN = {
    "kagezou demo": "the world of these tests is what it draws; tests/packaging/test_wheel.py runs it whole",
}
"""Beginnings of lines that are not run, each with its reason."""


def reason_not_to_run(text: str) -> str:
    """Return why a line is not run; empty where it is."""
    return next((reason for start, reason in NOT_RUN.items() if text.startswith(start)), "")


def typed(words: list[str], folder: Path) -> list[str]:
    """Return words as a program gets them, with names of files in the place of patterns."""
    found: list[str] = []
    for word in words:
        names = sorted(glob.glob(word, root_dir=folder)) if re.search(r"[*?]", word) else []
        found += names or [word.replace("$PWD", str(folder))]
    return found


@cache
def help_of(verb: str) -> str:
    """Return what a command says of itself."""
    module = import_module(f"kagezou.cli.verbs.{verb.replace('-', '_')}")
    parser = Parser(verb, module.DESCRIPTION, module.EXAMPLES)
    module.add_arguments(parser)
    return parser.format_help()
