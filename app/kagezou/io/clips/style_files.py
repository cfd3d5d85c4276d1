"""Style files: those that come with the program, over them a studio's, and the user's own over both.

A file may name as few lines as it likes; a line of the look that it does not name has its default.
"""

import json
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from types import MappingProxyType

from kagezou.animation.track import Value
from kagezou.document.local_name import LocalName
from kagezou.document.property import AnyProperty
from kagezou.document.style import LINES, NO_VALUES, SCENE_LINES, Style, Values
from kagezou.errors import InputProblem, Problem, ProjectProblem, UsageProblem
from kagezou.io.files.atomic import write_bytes
from kagezou.io.files.faults import shown
from kagezou.io.files.json_text import Reader, parse
from kagezou.io.files.small_files import folder_problems, small_text
from kagezou.locations import STYLE_FOLDERS, resource_folder, studio_folders
from kagezou.message import Message, nearest

SUFFIX = ".json"
VERSION = 1
MAX_BYTES = 1 << 20
_TALLEST_PX = 100_000.0


@dataclass(frozen=True, slots=True)
class StyleFile:
    """A style and where it lies."""

    style: Style
    path: Path
    is_own: bool
    """Whether it is the user's, and may be taken away."""
    is_studio: bool = False
    """Whether it lies in a folder of ``KAGEZOU_STYLES``."""


@cache
def bundled_styles() -> tuple[StyleFile, ...]:
    """Return the styles that come with the program; read once."""
    return tuple(StyleFile(load_style(path), path, is_own=False) for path in _files(resource_folder() / "styles"))


def styles_there(own_folder: Path) -> tuple[tuple[StyleFile, ...], tuple[Problem, ...]]:
    """Return all styles there are, and what is wrong with files and folders that cannot be read.

    Of those with one name the user's own counts, else the first one of the studio's, else the program's.
    """
    studio, problems = studio_styles()
    own, others = own_styles(own_folder)
    by_name: dict[str, StyleFile] = {}
    for each in (*bundled_styles(), *reversed(studio), *own):
        by_name[each.style.name.en.casefold()] = each
    ordered = (*bundled_styles(), *studio, *own)
    return tuple(each for each in ordered if by_name[each.style.name.en.casefold()] == each), (*problems, *others)


def studio_styles() -> tuple[tuple[StyleFile, ...], tuple[Problem, ...]]:
    """Return the styles in the folders of ``KAGEZOU_STYLES``, those of the first before the others, and problems."""
    found: list[StyleFile] = []
    problems: list[Problem] = []
    for folder in studio_folders(STYLE_FOLDERS):
        problems += folder_problems(folder, STYLE_FOLDERS)
        styles, others = own_styles(folder)
        found += (replace(each, is_own=False, is_studio=True) for each in styles)
        problems += others
    return tuple(found), tuple(problems)


def named_style(name: str, there: Iterable[StyleFile]) -> Style:
    """Return the style of a name, in English or Japanese, whatever its case.

    Raises
    ------
    UsageProblem
        There is none.
    """
    styles = [each.style for each in there]
    wanted = name.casefold()
    for each in styles:
        if wanted in (each.name.en.casefold(), each.name.in_language("ja").casefold()):
            return each
    near = nearest(name, (each.name.en for each in styles))
    hint: Message | str = f"; did you mean {near}?" if near is not None else Message("; kagezou style lists them")
    raise UsageProblem(Message("there is no style {style!r}{hint}", style=name, hint=hint))


def own_styles(folder: Path) -> tuple[tuple[StyleFile, ...], tuple[Problem, ...]]:
    """Return the styles in the user's folder, and what is wrong with files that cannot be read."""
    found: list[StyleFile] = []
    problems: list[Problem] = []
    for path in _files(folder):
        try:
            found.append(StyleFile(load_style(path), path, is_own=True))
        except Problem as problem:
            problems.append(problem)
    return tuple(found), tuple(problems)


def load_style(path: Path) -> Style:
    """Read a style.

    Raises
    ------
    InputProblem
        If it cannot be read or is no style; one sentence naming the file and the place.
    """
    try:
        return _style(Reader(parse(small_text(path, MAX_BYTES, Message("it is too large for a style")))))
    except (ProjectProblem, UsageProblem) as problem:
        raise InputProblem(Message("{path} is not a style: {cause}", path=shown(path), cause=problem)) from problem


def save_style(folder: Path, style: Style) -> Path:
    """Write a style into a folder, under its name; one of the same name is replaced.

    Raises
    ------
    UsageProblem
        If the name cannot be one.
    OutputProblem, DiskFullProblem
        If it cannot be written; what was there is still there.
    """
    path = path_of_style(folder, style)
    folder.mkdir(parents=True, exist_ok=True)
    write_bytes(path, dumps_style(style).encode())
    return path


def path_of_style(folder: Path, style: Style) -> Path:
    """Return where a style of this name is kept in a folder.

    Raises
    ------
    UsageProblem
        If the name cannot be one.
    """
    name = style.name.en.strip()
    stem = "".join(letter if letter.isalnum() or letter in " -_" else "_" for letter in name).strip()
    if not stem or len(name) > 80 or not name.isprintable():
        raise UsageProblem(
            Message("a style cannot be named {name!r}: a name is 1 to 80 letters and digits", name=name[:60])
        )
    return folder / f"{stem}{SUFFIX}"


def dumps_style(style: Style) -> str:
    """Return a style as the text of its file."""
    name = style.name.en.strip()
    record: dict[str, object] = {
        "style": VERSION,
        "name": {"en": name, "ja": style.name.in_language("ja").strip() or name},
        "figure_px": style.figure_px,
        "values": dict(style.values),
    }
    if style.scene:
        record["scene"] = dict(style.scene)
    return json.dumps(record, ensure_ascii=False, indent=2) + "\n"


def loads_style(text: str) -> Style | None:
    """Return the style that a text is, such as one from the clipboard; None if it is none."""
    try:
        return _style(Reader(parse(text))) if len(text) <= MAX_BYTES else None
    except (ProjectProblem, UsageProblem):
        return None


def _files(folder: Path) -> list[Path]:
    try:
        return sorted(path for path in folder.iterdir() if path.suffix == SUFFIX)
    except OSError:
        return []


def _style(reader: Reader) -> Style:
    found = reader.record(("style", "name", "figure_px", "values"), ("scene",))
    found["style"].whole(VERSION, VERSION)
    names = found["name"].record(("en", "ja"))
    return Style(
        LocalName.of(_name(names["en"]), ja=_name(names["ja"])),
        _height(found["figure_px"]),
        _values(found["values"], LINES),
        _values(found["scene"], SCENE_LINES) if "scene" in found else NO_VALUES,
    )


def _name(reader: Reader) -> str:
    text = reader.value
    if not isinstance(text, str) or not text.strip() or not text.isprintable() or len(text) > 80:
        raise reader.refused(Message("a name of 1 to 80 printable characters"))
    return text


def _height(reader: Reader) -> float:
    height = reader.value
    if isinstance(height, bool) or not isinstance(height, (int, float)) or not 1 <= height <= _TALLEST_PX:
        raise reader.refused(Message("a height from 1 to {tallest_px:g} px", tallest_px=_TALLEST_PX))
    return float(height)


def _values(reader: Reader, lines: Sequence[AnyProperty]) -> Values:
    props = {prop.name: prop for prop in lines}
    values: dict[str, Value] = {}
    for name, each in reader.members().items():
        if name not in props:
            raise reader.problem(Message("the key {name!r} is not a property that a style can set", name=name))
        values[name] = props[name].canonical(each.value)
    return MappingProxyType(values)
