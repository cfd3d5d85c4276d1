"""How this program is called in a process of its own, installed or as a bundle without a Python beside it."""

import runpy
import sys
from collections.abc import Sequence
from typing import Final

_AS_MODULE: Final = "--as-module"
_AS_SCRIPT: Final = "--as-script"
_OURS: Final = "kagezou."


def is_bundle() -> bool:
    """Return whether the program is a bundle: its executable is the program, not a Python."""
    return bool(getattr(sys, "frozen", False))


def program_words() -> tuple[str, ...]:
    """Return the words that call the program."""
    return (sys.executable,) if is_bundle() else (sys.executable, "-m", "kagezou")


def module_words(module: str) -> tuple[str, ...]:
    """Return the words that run a module of the program."""
    return (sys.executable, _AS_MODULE, module) if is_bundle() else (sys.executable, "-m", module)


def script_words(script: str) -> tuple[str, ...]:
    """Return the words that run a script of Python with what the program has."""
    return (sys.executable, _AS_SCRIPT, script) if is_bundle() else (sys.executable, script)


def ran_as_child(words: Sequence[str]) -> bool:
    """Run a module of the program or a script where a bundle was called for that; False where it was not."""
    if not is_bundle() or len(words) < 2 or words[0] not in (_AS_MODULE, _AS_SCRIPT):
        return False
    name, sys.argv = words[1], [words[1], *words[2:]]
    if words[0] == _AS_SCRIPT:
        runpy.run_path(name, run_name="__main__")
    elif name.startswith(_OURS):
        runpy.run_module(name, run_name="__main__", alter_sys=True)
    else:
        return False
    return True
