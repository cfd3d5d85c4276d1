"""The layers of a file that holds a frame: which there are, in which groups, and what they are called."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final

CLAY_NAMES: Final = {True: "set_clay_under", False: "set_clay"}
"""What sets drawn as clay are called: those under the background picture, and those over it."""
OVER: Final = "_normal"
"""What the name of a layer ends in that lies over the one of the shadows that multiply."""


@dataclass(frozen=True, slots=True)
class LayerOfFrame:
    """A character of layered frames, also of those that do not show it.

    Parameters
    ----------
    id, name
        As of the document's layer.
    received
        How what others cast on it is laid at any time, the lower first: True for by multiplying. Nothing for a layer
        that receives nothing.
    group
        The name of the group in which its shadow unites with those of others over the whole cut; empty for none.
    together
        How the shadows of the group are laid, as of ``received``, where they are one picture; nothing where each is a
        layer.
    has_shadow
        Whether it is a figure of its own; a part of another's shares the shadow of that.
    has_contact, is_mirrored
        Whether it has patches under its feet, and whether the ground mirrors it, at any time.
    """

    id: str
    name: str
    received: tuple[bool, ...] = ()
    group: str = ""
    together: tuple[bool, ...] = ()
    has_shadow: bool = True
    has_contact: bool = False
    is_mirrored: bool = False


def two_names(name: str, ways: tuple[bool, ...]) -> list[str]:
    """Return the names of a layer, and of what lies over it in another way."""
    return [name, f"{name}{OVER}"][: len(ways)]


def groups_of(layers: tuple[LayerOfFrame, ...]) -> tuple[tuple[LayerOfFrame, ...], ...]:
    """Return layers by the groups of their shadows, in the order of the lowest of each; those without one alone."""
    groups: dict[tuple[str, str], tuple[LayerOfFrame, ...]] = {}
    for layer in (each for each in layers if each.has_shadow):
        key = (layer.group, "" if layer.group else layer.id)
        groups[key] = (*groups.get(key, ()), layer)
    return tuple(groups.values())


def all_unlike(names: Iterable[str]) -> tuple[str, ...]:
    """Return names of which no two are alike: the later one of two gets a ``_`` more."""
    unlike: list[str] = []
    for name in names:
        free = name
        while free in unlike:
            free += "_"
        unlike.append(free)
    return tuple(unlike)
