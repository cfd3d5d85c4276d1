"""The pages of the manual: Markdown files, in the order in which the first page links them.

A page may hold the line ``<!-- properties: light, ground -->``; in its place come the properties of these sections of
the inspector, written from the property table, so that no property is without an explanation.
"""

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from kagezou.document.property import MAX_COORDINATE_PX, AnyProperty, Kind, Scope
from kagezou.locations import manual_folder
from kagezou.ui.system.language import ENGLISH
from kagezou.ui.system.words import choice_name, translated

FIRST: Final = "index"
"""The page with the contents."""

_LINK = re.compile(r"\]\(([a-z-]+)\.md\)")
_WITHIN_JAPANESE = re.compile(r"(?<=[\u3001-\u9fff\uff01-\uffef])\n *(?=[\u3001-\u9fff\uff01-\uffef])")
"""Where a line ends within a Japanese sentence, which has no spaces: shown, it would become one."""
_PROPERTIES = re.compile(r"^<!-- properties: (.+) -->$", re.MULTILINE)
MOST_TURNS_DEG: Final = 36_000.0
"""A range of so many degrees only keeps numbers sane; it says nothing to people."""
_OWNERS: Final = {Scope.DOCUMENT: "", Scope.LAYER: "layers.NAME.", Scope.PIECE: "set.NAME."}


@dataclass(frozen=True, slots=True)
class Page:
    """One page.

    Parameters
    ----------
    name
        Its file's name without the ending.
    title
        Its first heading.
    text
        The whole Markdown.
    """

    name: str
    title: str
    text: str


def pages_in(language: str) -> dict[str, Page]:
    """Return the manual in a language by name, the contents first; what is not translated is there in English."""
    first = _page(FIRST, language)
    names = dict.fromkeys((FIRST, *_LINK.findall(first.text)))
    return {name: first if name == FIRST else _page(name, language) for name in names}


def with_properties(text: str, sections: Mapping[str, Iterable[AnyProperty]]) -> str:
    """Return a page with the properties of its sections written out; KeyError where there is no such section."""

    def written(found: re.Match[str]) -> str:
        names = [name.strip() for name in found[1].split(",")]
        return "\n".join(_line(prop) for name in names for prop in sections[name])

    return _PROPERTIES.sub(written, text)


def sections_of(text: str) -> tuple[str, ...]:
    """Return the names of the sections whose properties a page explains."""
    return tuple(name.strip() for found in _PROPERTIES.finditer(text) for name in found[1].split(","))


def _page(name: str, language: str) -> Page:
    path = _path(name, language)
    text = _WITHIN_JAPANESE.sub("", path.read_text(encoding="utf-8"))
    title = next(line for line in text.splitlines() if line.startswith("# "))
    return Page(name, title.removeprefix("# "), text)


def _path(name: str, language: str) -> Path:
    path = manual_folder() / language / f"{name}.md"
    return path if path.is_file() else manual_folder() / ENGLISH / f"{name}.md"


def _line(prop: AnyProperty) -> str:
    """Return what a property is, as one item of a list: its name, what it does, its range, its path."""
    facts = [f"`{_OWNERS[prop.scope]}{prop.name}`", *_range(prop)]
    return f"- **{translated(prop.label)}**: {translated(prop.help)} ({', '.join(facts)})"


def _range(prop: AnyProperty) -> list[str]:
    if prop.kind is Kind.CHOICE:
        return [" / ".join(choice_name(choice) for choice in prop.choices)]
    if prop.kind is not Kind.NUMBER or prop.high >= (MOST_TURNS_DEG if prop.unit == "°" else MAX_COORDINATE_PX):
        return [prop.unit] if prop.unit else []
    return [f"{prop.low:g} – {prop.high:g} {prop.unit}".rstrip()]
