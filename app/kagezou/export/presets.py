"""Export presets: named ways to export, each a small file: the user's own, and a studio's, which stay as they are."""

import json
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Final

from kagezou.errors import InputProblem, Problem, ProjectProblem, UsageProblem
from kagezou.export.choices import ExportChoices
from kagezou.export.names import safe_names
from kagezou.export.remembered import choices_of
from kagezou.io.files.atomic import write_bytes
from kagezou.io.files.faults import output_problem, shown
from kagezou.io.files.json_text import Reader, parse
from kagezou.io.files.small_files import folder_problems, remove_file, small_text
from kagezou.locations import PRESET_FOLDERS, studio_folders
from kagezou.message import Message

SUFFIX: Final = ".json"
VERSION: Final = 1
_MAX_BYTES: Final = 1 << 16
_MAX_NAME: Final = 80


@dataclass(frozen=True, slots=True)
class Preset:
    """A way to export, what it is called, where it lies, and whether in a folder of ``KAGEZOU_PRESETS``."""

    name: str
    choices: ExportChoices
    path: Path
    is_studio: bool = False


def presets_there(own_folder: Path) -> tuple[tuple[Preset, ...], tuple[Problem, ...]]:
    """Return the studio's presets and the user's own, and what is wrong with files and folders that cannot be read.

    Of those with one name the user's own counts, else that of the studio's first folder.
    """
    studio: dict[str, Preset] = {}
    problems: list[Problem] = []
    for folder in studio_folders(PRESET_FOLDERS):
        problems += folder_problems(folder, PRESET_FOLDERS)
        found, others = presets_in(folder)
        problems += others
        for each in found:
            studio.setdefault(each.name, replace(each, is_studio=True))
    own, others = presets_in(own_folder)
    names = {each.name for each in own}
    return (*(each for each in studio.values() if each.name not in names), *own), (*problems, *others)


def presets_in(folder: Path) -> tuple[tuple[Preset, ...], tuple[Problem, ...]]:
    """Return the presets of a folder by their names, and what is wrong with files that cannot be read."""
    found: list[Preset] = []
    problems: list[Problem] = []
    try:
        paths = sorted(path for path in folder.iterdir() if path.suffix == SUFFIX)
    except OSError:
        return (), ()
    for path in paths:
        try:
            found.append(load_preset(path))
        except Problem as problem:
            problems.append(problem)
    return tuple(sorted(found, key=lambda each: each.name.casefold())), tuple(problems)


def load_preset(path: Path) -> Preset:
    """Read a preset; what it says of an export that is not understood has its usual value.

    Raises
    ------
    InputProblem
        It cannot be read or is no preset.
    """
    try:
        text = small_text(path, _MAX_BYTES, Message("it is too large for one"))
        found = Reader(parse(text)).record(("export_preset", "name", "plan"))
        found["export_preset"].whole(VERSION, VERSION)
        return Preset(_checked(str(found["name"].value)), choices_of(found["plan"].value), path)
    except (ProjectProblem, UsageProblem) as problem:
        raise InputProblem(
            Message("{path} is not an export preset: {cause}", path=shown(path), cause=problem)
        ) from problem


def save_preset(folder: Path, name: str, choices: ExportChoices) -> Preset:
    """Write a preset; one of the same name is replaced.

    Raises
    ------
    UsageProblem
        The name cannot be one.
    OutputProblem, DiskFullProblem
        It cannot be written; what was there is still there.
    """
    name = _checked(name)
    same = next((each.path for each in presets_in(folder)[0] if each.name == name), None)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise output_problem(folder, error) from error
    path = same or _free_path(folder, name)
    record = {"export_preset": VERSION, "name": name, "plan": asdict(choices)}
    write_bytes(path, (json.dumps(record, ensure_ascii=False, indent=2) + "\n").encode())
    return Preset(name, choices, path)


def rename_preset(folder: Path, preset: Preset, name: str) -> Preset:
    """Give a preset another name.

    Raises
    ------
    UsageProblem
        The name cannot be one, or another preset has it.
    OutputProblem, DiskFullProblem
        It cannot be written; the preset keeps its name.
    """
    name = _checked(name)
    if name == preset.name:
        return preset
    if any(each.name == name for each in presets_in(folder)[0]):
        raise UsageProblem(Message("there is an export preset {name!r} already", name=name))
    renamed = save_preset(folder, name, preset.choices)
    remove_preset(preset)
    return renamed


def remove_preset(preset: Preset) -> None:
    """Take a preset away.

    Raises
    ------
    OutputProblem
        Its file cannot be removed.
    """
    remove_file(preset.path)


def _checked(name: str) -> str:
    """Return a name without spaces around it, if it can be one."""
    name = name.strip()
    if not name or len(name) > _MAX_NAME or not name.isprintable():
        raise UsageProblem(
            Message(
                "an export preset is named by 1 to {most_name} printable characters, not {name!r}",
                most_name=_MAX_NAME,
                name=name[:60],
            )
        )
    return name


def _free_path(folder: Path, name: str) -> Path:
    """Return a path for a new preset: two names may look alike to a file system."""
    stem = safe_names([name])[name]
    path, number = folder / f"{stem}{SUFFIX}", 2
    while path.exists():
        path, number = folder / f"{stem}_{number}{SUFFIX}", number + 1
    return path
