"""Which keys every command lies on: the table, changed by a set such as OpenToonz's, changed by the user."""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property

from PySide6.QtGui import QKeySequence

from kagezou.io.clips.shortcut_files import Keys, KeySet
from kagezou.ui.commands.table import Command


@dataclass(frozen=True)
class Shortcuts:
    """The shortcuts of the window; a key never lies on two commands.

    Parameters
    ----------
    table
        The keys of the command table.
    key_set
        What other program's keys are asked for.
    own
        The commands whose keys the user chose, with all their keys.
    """

    table: Keys
    key_set: KeySet
    own: Keys

    @cached_property
    def of_the_set(self) -> dict[str, tuple[str, ...]]:
        """The keys of every command before the user's own choice."""
        return overlaid(self.table, self.key_set.keys)

    @cached_property
    def keys(self) -> dict[str, tuple[str, ...]]:
        """The keys of every command."""
        return overlaid(self.of_the_set, self.own)

    def owner(self, key: str) -> str | None:
        """Return the command that a key lies on."""
        return next((name for name, keys in self.keys.items() if key in keys), None)

    def is_own(self, name: str) -> bool:
        """Whether the user changed the keys of a command."""
        return self.keys[name] != self.of_the_set[name]

    def given(self, name: str, key: str) -> "Shortcuts":
        """Return the shortcuts with a key put on a command, taken from the one that had it."""
        keys = {other: tuple(each for each in has if each != key) for other, has in self.keys.items()}
        return self.with_keys({**keys, name: (*keys[name], key)})

    def taken(self, name: str, key: str) -> "Shortcuts":
        """Return the shortcuts with a key taken from a command."""
        return self.with_keys({**self.keys, name: tuple(each for each in self.keys[name] if each != key)})

    def reset(self, name: str) -> "Shortcuts":
        """Return the shortcuts with the set's keys on a command; whoever had got them loses them again."""
        wanted = self.of_the_set[name]
        keys = {other: tuple(each for each in has if each not in wanted) for other, has in self.keys.items()}
        return self.with_keys({**keys, name: wanted})

    def with_keys(self, keys: Keys) -> "Shortcuts":
        """Return the shortcuts with these keys, as far as they differ from the set's taken for the user's own."""
        whole = overlaid(self.table, keys)
        return replace(self, own={name: each for name, each in whole.items() if each != self.of_the_set[name]})


def table_of(commands: Iterable[Command]) -> Keys:
    """Return the keys of the command table."""
    return {command.name: normal(command.keys) for command in commands}


def overlaid(lower: Keys, upper: Keys) -> dict[str, tuple[str, ...]]:
    """Return keys with those of some commands replaced; a key claimed above leaves the command it lay on below.

    Names that ``lower`` lacks are left out: a file may know commands that this version does not have.
    """
    known = {name: normal(keys) for name, keys in upper.items() if name in lower}
    claimed: set[str] = set()
    result: dict[str, tuple[str, ...]] = {}
    for name, keys in known.items():
        result[name] = tuple(each for each in keys if each not in claimed)
        claimed.update(keys)
    for name, keys in lower.items():
        if name not in known:
            result[name] = tuple(each for each in keys if each not in claimed)
    return {name: result[name] for name in lower}


def normal(keys: Iterable[str]) -> tuple[str, ...]:
    """Return keys in Qt's own spelling, each once, without those that Qt does not know."""
    spelled = (spelling(each) for each in keys)
    return tuple(dict.fromkeys(each for each in spelled if each))


def spelling(key: str) -> str:
    """Return Qt's spelling of a key, empty for one that it does not know."""
    return QKeySequence(key).toString(QKeySequence.SequenceFormat.PortableText)
