"""The icons of the kinds of set pieces and what adding one is called, in one table."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from PySide6.QtCore import QCoreApplication

from kagezou.geometry.sets.measures import PieceKind, by_kind


def translate(_context: str, text: str) -> str:
    """Mark a text for the translators and leave it English until it is shown."""
    return text


@dataclass(frozen=True, slots=True)
class KindWords:
    """The English words of a kind.

    Parameters
    ----------
    icon
        The icon's name.
    step
        The name of the step of history that adds one.
    command
        The words of the command that adds one, with the menu's mnemonic; empty where there is none.
    """

    icon: str
    step: str
    command: str


KIND_WORDS: Final[Mapping[PieceKind, KindWords]] = by_kind({
    PieceKind.WALL: KindWords("wall", translate("SetCommands", "Add wall"), translate("Commands", "Add &Wall")),
    PieceKind.BOX: KindWords("box", translate("SetCommands", "Add box"), translate("Commands", "Add &Box")),
    PieceKind.STEPS: KindWords("steps", translate("SetCommands", "Add steps"), translate("Commands", "Add &Steps")),
    PieceKind.RAMP: KindWords("ramp", translate("SetCommands", "Add ramp"), translate("Commands", "Add &Ramp")),
    PieceKind.CYLINDER: KindWords(
        "cylinder", translate("SetCommands", "Add cylinder"), translate("Commands", "Add &Cylinder")
    ),
    PieceKind.SPHERE: KindWords("sphere", translate("SetCommands", "Add sphere"), translate("Commands", "Add S&phere")),
    PieceKind.MESH: KindWords("mesh", translate("SetCommands", "Add set piece"), ""),
})  # fmt: skip


def words_for_adding(kind: PieceKind) -> str:
    """Return the name of the step that adds a piece."""
    return QCoreApplication.translate("SetCommands", KIND_WORDS[kind].step)
