"""What the groups and layers of a PSD file are: cels of characters, single drawings, a background, or nothing.

Animators number their cels and hide all but one; illustrators name the parts of one figure and show them together.
"""

import re
import unicodedata
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from typing import Final

from kagezou.io.names.runs import ends_numbered, runs_of
from kagezou.io.psd.tree import PsdNode, PsdTree
from kagezou.message import Message

_UNNAMED: Final = frozenset({
    "layer", "レイヤー", "图层", "圖層", "레이어", "ebene", "calque", "capa", "livello", "camada", "слой",
    "group", "グループ", "フォルダー", "gruppe", "groupe", "grupo", "gruppo",
})  # fmt: skip
"""What drawing programs call a layer that nobody named."""

_BACKGROUND: Final = re.compile(
    "(bg|lo|background|layout|paper|背景|背景原図|原図|美術|レイアウト|用紙|hintergrund|fond|fondo|sfondo)"
    r"[ _.\-]*[0-9]{0,4}"
)


_COLUMN: Final = re.compile(r"[a-z]|[a-z][0-9]|[0-9]+")
_OF_CHARACTERS: Final = frozenset({
    "characters", "character", "chara", "charas", "chars", "char", "cels", "cel", "cells", "cell", "animation", "anim",
    "all", "キャラ", "キャラクター", "セル", "動画", "原画", "作画", "cut", "scene",
})  # fmt: skip
"""What a group is called that holds characters, not the parts of one."""


@dataclass(frozen=True, slots=True)
class PsdCel:
    """A drawing of a character: what a timesheet calls it, and the layer or group that it is."""

    name: str
    node: PsdNode


@dataclass(frozen=True, slots=True)
class PsdCharacter:
    """A character layer to be; its cels are in the order of their numbers.

    ``joins`` is the name of the one whose figure it is a part of, None for a figure of its own.
    """

    name: str
    cels: tuple[PsdCel, ...]
    joins: str | None = None


@dataclass(frozen=True, slots=True)
class PsdCharacters:
    """What a PSD file brings.

    Parameters
    ----------
    characters
        From the lowest up.
    backgrounds
        Layers that are named like a background, from the lowest up; a background is opaque as well.
    hidden, empty
        What is left out.
    unnumbered
        What is left out as it lies among cels and is none.
    notes
        What had to be guessed, and which cels are older than others of their number.
    """

    characters: tuple[PsdCharacter, ...] = ()
    backgrounds: tuple[PsdNode, ...] = ()
    hidden: tuple[PsdNode, ...] = ()
    empty: tuple[PsdNode, ...] = ()
    unnumbered: tuple[PsdNode, ...] = ()
    notes: tuple[Message, ...] = ()


@dataclass(frozen=True, slots=True)
class _Number:
    prefix: str
    number: int
    suffix: str
    is_outdated: bool

    @property
    def is_unnamed(self) -> bool:
        return self.prefix in _UNNAMED


def is_background_name(name: str) -> bool:
    """Return whether a layer, a file or a folder is called like a background."""
    return _BACKGROUND.fullmatch(_plain(name)) is not None


def characters_in(tree: PsdTree, name: str) -> PsdCharacters:
    """Return what a PSD file called ``name`` brings.

    A group of numbered layers is a character, its layers are its cels, the hidden ones too. Numbered layers beside the
    groups are cels of a character called like the file. Groups with such groups in them are opened; any other group,
    and any other layer, is a drawing of its own.
    """
    sorting = _Sorting()
    sorting.sort(tree.layers, name)
    return PsdCharacters(
        tuple(sorting.characters),
        tuple(sorting.backgrounds),
        tuple(sorting.hidden),
        tuple(sorting.empty),
        tuple(sorting.unnumbered),
        tuple(dict.fromkeys(sorting.notes)),
    )


@dataclass(slots=True)
class _Sorting:
    characters: list[PsdCharacter] = field(default_factory=list)
    backgrounds: list[PsdNode] = field(default_factory=list)
    hidden: list[PsdNode] = field(default_factory=list)
    empty: list[PsdNode] = field(default_factory=list)
    unnumbered: list[PsdNode] = field(default_factory=list)
    notes: list[Message] = field(default_factory=list)

    def sort(self, nodes: Sequence[PsdNode], owner: str) -> None:
        """Take in what lies beside each other, within ``owner``."""
        sheaves = _loose_sheaves(nodes)
        taken = {id(node): prefix for prefix, members in sheaves.items() for _, node in members}
        for node in nodes:
            if id(node) in taken:
                members = sheaves.pop(taken[id(node)], None)
                if members is not None:
                    is_only = len(set(taken.values())) == 1
                    self._add(owner if is_only else taken[id(node)] or owner, members)
            elif not node.is_clipped:
                self._take(node)

    def _add(self, name: str, members: Sequence[tuple[_Number, PsdNode]]) -> None:
        self.characters.append(_character(name, [member for member in members if not member[0].is_outdated]))
        for run in runs_of([node.name for _, node in members]).runs:
            self.notes += run.doubts
        if older := [node.name for number, node in members if number.is_outdated]:
            names = ", ".join(dict.fromkeys(older))
            self.notes.append(Message("{name}: newer retakes count instead of {names}", name=name, names=names))

    def _take(self, node: PsdNode) -> None:
        if not node.is_visible:
            self.hidden.append(node)
            return
        cels = _cels_in(node)
        if is_background_name(node.name) and not cels and _shows(node):
            self.backgrounds.append(node)
        elif cels:
            self._add(node.name, cels)
            self.unnumbered += filter(_shows, _beside(cels, node))
        elif _holds_sheaf(node):
            first = len(self.characters)
            self.sort(node.children or (), node.name)
            if not any(map(_holds_sheaf, node.children or ())):
                self.characters[first:] = _one_figure(node.name, self.characters[first:])
        elif _shows(node):
            self.characters.append(PsdCharacter(node.name, (PsdCel(node.name, node),)))
        else:
            self.empty.append(node)


def _one_figure(name: str, parts: Sequence[PsdCharacter]) -> Sequence[PsdCharacter]:
    """Return what lies in a group as parts of one figure, the lowest first; each by itself where they are characters.

    Groups called A, B, C are the columns of a timesheet, and a group called "characters" holds characters.
    """
    if len(parts) < 2 or _plain(name) in _OF_CHARACTERS or any(_COLUMN.fullmatch(_plain(part.name)) for part in parts):
        return parts
    figure = f"{name} {parts[0].name}"
    return [replace(part, name=f"{name} {part.name}", joins=None if part is parts[0] else figure) for part in parts]


def _loose_sheaves(nodes: Iterable[PsdNode]) -> dict[str, list[tuple[_Number, PsdNode]]]:
    """Return by what stands before their numbers the layers that are cels without a group of their own."""
    found: dict[str, list[tuple[_Number, PsdNode]]] = {}
    for number, node in _numbered(nodes):
        found.setdefault(number.prefix, []).append((number, node))
    return {prefix: members for prefix, members in found.items() if len(members) > 1 and not _is_one_picture(members)}


def _cels_in(group: PsdNode) -> list[tuple[_Number, PsdNode]]:
    """Return the numbered cels of a group; none where it is something else."""
    members = _numbered(group.children or ())
    prefixes = {number.prefix for number, _ in members}
    if len(prefixes) != 1 or _is_one_picture(members):
        return []
    # "arm1, arm2, body" is a figure in parts; "1, 2, frame" and "A1, A2, frame" in a group A are cels and a frame.
    is_plain = prefixes <= {"", _plain(group.name)}
    return [] if any(map(_shows, _beside(members, group))) and not is_plain else members


def _beside(cels: Iterable[tuple[_Number, PsdNode]], group: PsdNode) -> list[PsdNode]:
    """Return what lies in a group beside its cels."""
    known = {id(node) for _, node in cels}
    return [node for node in group.children or () if id(node) not in known and not node.is_clipped]


def _numbered(nodes: Iterable[PsdNode]) -> list[tuple[_Number, PsdNode]]:
    """Return the layers whose names end with a number, or with the same word behind it, as they lie."""
    among = [node for node in nodes if not node.is_clipped and not _is_sheaf(node)]
    cels = [node for node in among if ends_numbered(node.name)]
    if not cels:
        runs = runs_of([node.name for node in among]).runs
        cels = among if len(runs) == 1 < len(runs[0].places) and not runs[0].doubts else []
    found: dict[int, _Number] = {}
    for run in runs_of([node.name for node in cels]).runs:
        for place in run.places:
            found[place.index] = _Number(_plain(run.name), place.number, place.insert, is_outdated=False)
        for worse, better in run.replaced:
            found[worse] = replace(found[better], is_outdated=True)
        for other, better in run.twice:
            found[other] = found[better]
        for index in run.outdated:
            found[index] = _Number(_plain(run.name), 0, "", is_outdated=True)
    return [(found[index], node) for index, node in enumerate(cels) if index in found]


def _is_one_picture(members: Sequence[tuple[_Number, PsdNode]]) -> bool:
    """Whether layers that nobody named are seen together, as the parts of a picture are and cels are not."""
    return any(number.is_unnamed for number, _ in members) and sum(node.is_visible for _, node in members) > 1


def _is_sheaf(node: PsdNode) -> bool:
    """Whether a group holds several cels, or groups that do."""
    cels = _cels_in(node) if node.children else []
    return (len(cels) > 1 and not cels[0][0].is_unnamed) or _holds_sheaf(node)


def _holds_sheaf(node: PsdNode) -> bool:
    return any(child.children and (_cels_in(child) or _holds_sheaf(child)) for child in node.children or ())


def _shows(node: PsdNode) -> bool:
    """Whether there is something to be seen of a layer or a group."""
    if not node.is_visible or node.is_empty:
        return False
    return node.children is None or any(map(_shows, node.children))


def _character(name: str, members: Iterable[tuple[_Number, PsdNode]]) -> PsdCharacter:
    ordered = sorted(members, key=lambda member: (member[0].number, member[0].suffix.lower(), member[0].suffix))
    cels: list[PsdCel] = []
    for number, node in ordered:
        short = f"{number.number}{number.suffix}"
        cels.append(PsdCel(node.name if cels and cels[-1].name == short else short, node))
    return PsdCharacter(name, tuple(cels))


def _plain(name: str) -> str:
    return unicodedata.normalize("NFKC", name).strip().casefold()
