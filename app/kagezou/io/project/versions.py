"""The versions of the project format, each named by what it brought, and the steps from one to the next."""

from collections.abc import Callable, Mapping
from enum import IntEnum
from types import MappingProxyType
from typing import Final

from kagezou.io.files.json_text import Reader, brief
from kagezou.message import Message

FORMAT_NAME: Final = "kagezou-project"

Tree = dict[str, object]
"""A whole project as JSON gives it."""


class FormatVersion(IntEnum):
    """What the number ``version`` in a project stands for."""

    FIRST_SHADOWS = 1


BROUGHT: Final[Mapping[FormatVersion, str]] = MappingProxyType({
    FormatVersion.FIRST_SHADOWS: "Canvas, background, character layers, light, ground and the look of a shadow.",
})  # fmt: skip

CURRENT: Final = max(FormatVersion)

UPGRADES: Final[Mapping[FormatVersion, Callable[[Tree], Tree]]] = MappingProxyType({})
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
        made_by = tree.get("app_version")
        raise Reader(tree, "$.version").problem(_too_new(number, made_by if isinstance(made_by, str) else None))
    for version in range(number, CURRENT):
        tree = UPGRADES[FormatVersion(version)](tree)
    return tree


def _too_new(number: int, made_by: str | None) -> Message:
    if made_by is None:
        return Message(
            "this project needs a newer Kagezou that knows format version {number}; this one knows up to {current}",
            number=number,
            current=int(CURRENT),
        )
    return Message(
        "this project needs a newer Kagezou that knows format version {number} (Kagezou {program}); "
        "this one knows up to {current}",
        number=number,
        program=brief(made_by),
        current=int(CURRENT),
    )
