"""The window has an icon, a command and the name of a step for every kind of set piece."""

import pytest

from kagezou.document.piece_kinds import BUILT_KINDS
from kagezou.geometry.sets.measures import PieceKind
from kagezou.locations import resource_folder
from kagezou.ui.commands.table import set_commands
from kagezou.ui.system.kind_words import KIND_WORDS


@pytest.mark.parametrize("kind", PieceKind)
def test_a_row_is_whole(kind: PieceKind) -> None:
    words = KIND_WORDS[kind]
    assert (resource_folder() / "icons" / f"{words.icon}.svg").is_file()
    assert words.step.startswith("Add ")
    assert bool(words.command) == (kind in BUILT_KINDS)


def test_every_built_kind_has_its_command() -> None:
    commands = {command.name: command for command in set_commands()}
    for kind in BUILT_KINDS:
        command = commands[f"add_{kind}"]
        assert (command.source, command.icon) == (KIND_WORDS[kind].command, KIND_WORDS[kind].icon)
