"""The trees of glTF files: lists of entries that name each other by number."""

import struct
from pathlib import Path
from typing import Any, Final

from kagezou.errors import InputProblem
from kagezou.io.files.faults import input_problem
from kagezou.message import Message

Tree = dict[str, Any]

SHAPELESS: Final = (
    KeyError,
    TypeError,
    AttributeError,
    ValueError,
    IndexError,
    OverflowError,
    ZeroDivisionError,
    struct.error,
)
"""A tree of the wrong shape shows itself in many ways."""


def list_of(path: Path, tree: Tree, name: str) -> list[Tree]:
    """Return a list of objects out of a tree, empty where there is none."""
    found = tree.get(name, [])
    if not isinstance(found, list):
        raise input_problem(path, Message("it is not a complete glTF file: {name!r} is not a list", name=name))
    return found


def entry_of(path: Path, tree: Tree, name: str, index: object) -> Tree:
    """Return an object of such a list."""
    found = list_of(path, tree, name)
    if not isinstance(index, int) or isinstance(index, bool) or not 0 <= index < len(found):
        raise input_problem(
            path, Message("it is damaged: there is no {name}[{index}]", name=name, index=repr(index)[:160])
        )
    entry = found[index]
    if not isinstance(entry, dict):
        raise TypeError(entry)
    return entry


def whole(number: object, least: int = 0) -> int:
    """Return a number of a tree that has to be a whole one, at least so large; ValueError else."""
    if isinstance(number, float) and number.is_integer():
        number = int(number)
    if not isinstance(number, int) or isinstance(number, bool) or number < least:
        raise ValueError(number)
    return number


def extension_of(entry: Tree, name: str) -> Tree | None:
    """Return an extension of an entry, None where it has none of that name."""
    found = entry.get("extensions", {}).get(name)
    return found if isinstance(found, dict) else None


def damaged(path: Path) -> InputProblem:
    """Return the problem of a file whose numbers do not fit together."""
    return input_problem(path, Message("it is not a complete glTF file"))
