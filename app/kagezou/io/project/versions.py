"""The versions of the project format, each named by what it brought, and the steps from one to the next.

The rule: the version rises with a release whose files an older release would refuse or read wrongly, which is every
release that adds a property, a key or a choice, or changes what one means. It rises at most once a release, and with it
come a step that leads older files over and a sample project of the version before among the tests. A program reads all
versions up to its own; of a newer one it says which Kagezou is needed, before it looks at anything else in the file.
"""

import re
from collections.abc import Callable, Mapping
from enum import IntEnum
from types import MappingProxyType
from typing import Final

from kagezou.io.files.json_text import Reader
from kagezou.message import Message
from kagezou.version import __version__

FORMAT_NAME: Final = "kagezou-project"

_PROGRAM: Final = re.compile(r"[0-9]{1,4}(\.[0-9A-Za-z+]{1,12}){0,4}")
"""A number of a program, such as 1.2 or 1.2.0rc1; anything else that a file claims is not repeated."""

Tree = dict[str, object]
"""A whole project as JSON gives it."""


class FormatVersion(IntEnum):
    """What the number ``version`` in a project stands for."""

    FIRST_SHADOWS = 1
    FIGURES = 2


BROUGHT: Final[Mapping[FormatVersion, str]] = MappingProxyType({
    FormatVersion.FIRST_SHADOWS: "Canvas, background, character layers, light, ground and the look of a shadow.",
    FormatVersion.FIGURES: "Figures of several layers, moved layers, feet, height, shadows that unite.",
})  # fmt: skip

CURRENT: Final = max(FormatVersion)


def _with_shadows_apart(tree: Tree) -> Tree:
    """Lead a project over to ``FIGURES``: its shadows go on darkening each other where they meet."""
    tracks = tree.get("tracks")
    if not isinstance(tracks, dict):
        return tree  # The reader says what is wrong.
    return {**tree, "tracks": {**tracks, "scene.shadows_unite": False}}


UPGRADES: Final[Mapping[FormatVersion, Callable[[Tree], Tree]]] = MappingProxyType({
    FormatVersion.FIRST_SHADOWS: _with_shadows_apart,
})  # fmt: skip
"""Version → the step from it to the next one; a pure function of trees. Every version but the current has one."""


def upgraded(tree: object) -> Tree:
    """Return a project of any known version as one of the current version.

    Raises
    ------
    ProjectProblem
        If it is no project, or one from a newer program.
    """
    if not isinstance(tree, dict) or tree.get("format") != FORMAT_NAME:
        raise Reader(tree).problem(Message("it is not a Kagezou project"))
    number = Reader(tree.get("version"), "$.version").whole(1, 10**9)
    if number > CURRENT:
        raise Reader(tree, "$.version").problem(_too_new(number, tree.get("app_version")))
    for version in range(number, CURRENT):
        tree = UPGRADES[FormatVersion(version)](tree)
    return tree


def _too_new(number: int, made_by: object) -> Message:
    """Return what is said to a file of a newer version: which program reads it; the one that wrote it does."""
    if not isinstance(made_by, str) or not _PROGRAM.fullmatch(made_by):
        return Message(
            "this project needs a newer Kagezou (format version {number}); this is Kagezou {own}",
            number=number,
            own=__version__,
        )
    return Message(
        "this project needs Kagezou {program} or newer (format version {number}); this is Kagezou {own}",
        program=made_by,
        number=number,
        own=__version__,
    )
