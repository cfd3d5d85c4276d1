"""Files of shortcuts: the sets that come with the program, a studio's, and those the user hands on."""

import json
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from types import MappingProxyType

from kagezou.document.local_name import LocalName
from kagezou.errors import InputProblem, Problem, ProjectProblem
from kagezou.io.files.atomic import write_bytes
from kagezou.io.files.faults import shown
from kagezou.io.files.json_text import JsonRow, Reader, formatted, parse
from kagezou.io.files.small_files import folder_problems, small_text
from kagezou.locations import SHORTCUT_FOLDERS, resource_folder, studio_folders
from kagezou.message import Message

SUFFIX = ".json"
VERSION = 1
MAX_BYTES = 1 << 18
_MOST_COMMANDS = 1000
_MOST_KEYS = 8
_LONGEST = 80

Keys = Mapping[str, tuple[str, ...]]
"""The keys of commands by the commands' names, as Qt writes keys: ``Ctrl+Shift+P``."""


@dataclass(frozen=True, slots=True)
class KeySet:
    """Shortcuts under a name; commands it does not name keep the table's own.

    Parameters
    ----------
    code
        Its file's name without order and suffix.
    name
        What people read.
    keys
        The keys that differ from the table's.
    is_studio
        Whether it lies in a folder of ``KAGEZOU_SHORTCUTS``.
    """

    code: str
    name: LocalName
    keys: Keys
    is_studio: bool = False


def bundled_key_sets() -> tuple[KeySet, ...]:
    """Return the sets that come with the program, the program's own first."""
    folder = resource_folder() / "shortcuts"
    return tuple(load_key_set(path) for path in sorted(folder.iterdir()) if path.suffix == SUFFIX)


def key_sets_there() -> tuple[tuple[KeySet, ...], tuple[Problem, ...]]:
    """Return the program's sets and the studio's, and what is wrong with files and folders that cannot be read.

    A set of the studio's takes the place of one of the program's, or of a later folder's, with the same file name.
    """
    sets = {each.code: each for each in bundled_key_sets()}
    problems: list[Problem] = []
    for folder in reversed(studio_folders(SHORTCUT_FOLDERS)):
        problems += folder_problems(folder, SHORTCUT_FOLDERS)
        for path in _files(folder):
            try:
                found = load_key_set(path)
            except Problem as problem:
                problems.append(problem)
            else:
                sets[found.code] = replace(found, is_studio=True)
    return tuple(sets.values()), tuple(problems)


def _files(folder: Path) -> list[Path]:
    try:
        return sorted(path for path in folder.iterdir() if path.suffix == SUFFIX)
    except OSError:
        return []


def load_key_set(path: Path) -> KeySet:
    """Read a set of shortcuts.

    Raises
    ------
    InputProblem
        If it cannot be read or is none; one sentence naming the file and the place.
    """
    try:
        text = small_text(path, MAX_BYTES, Message("it is too large for shortcuts"))
        return _key_set(Reader(parse(text)), path.stem.lstrip("0123456789-"))
    except ProjectProblem as problem:
        raise InputProblem(
            Message("{path} does not hold shortcuts: {cause}", path=shown(path), cause=problem)
        ) from problem


def save_key_set(path: Path, key_set: KeySet) -> None:
    """Write a set of shortcuts as a whole.

    Raises
    ------
    OutputProblem, DiskFullProblem
        If it cannot be written; what was there is still there.
    """
    record = {
        "shortcuts": VERSION,
        "name": JsonRow({"en": key_set.name.en, "ja": key_set.name.in_language("ja")}),
        "keys": {name: JsonRow(list(keys)) for name, keys in key_set.keys.items()},
    }
    write_bytes(path, formatted(record).encode())


def keys_from_text(text: str) -> Keys:
    """Return the keys that a text of :func:`text_of_keys` holds.

    Raises
    ------
    ProjectProblem
        If it holds something else.
    """
    return _keys(Reader(parse(text)))


def text_of_keys(keys: Keys) -> str:
    """Return keys as one line of text."""
    return json.dumps({name: list(each) for name, each in keys.items()})


def _key_set(reader: Reader, code: str) -> KeySet:
    found = reader.record(("shortcuts", "name", "keys"))
    found["shortcuts"].whole(VERSION, VERSION)
    names = found["name"].record(("en", "ja"))
    name = LocalName.of(names["en"].text(_LONGEST), ja=names["ja"].text(_LONGEST))
    return KeySet(code, name, _keys(found["keys"]))


def _keys(reader: Reader) -> Keys:
    members = reader.members()
    if len(members) > _MOST_COMMANDS:
        raise reader.problem(Message("it names more than {most_commands} commands", most_commands=_MOST_COMMANDS))
    return MappingProxyType(
        {name: tuple(each.text(_LONGEST) for each in keys.items(_MOST_KEYS)) for name, keys in members.items()}
    )
