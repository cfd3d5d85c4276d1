"""Names of folders that hold one thing in several states: ``A``, ``A_R1``, ``A.R2``, or ``walk_v1`` and ``walk_v2``."""

import re
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from kagezou.io.names.marks import half_width, key

_STATE: Final = re.compile(
    r"(?P<base>.+?)[ _.\-]+[(\[]?(?:(?P<version>version|ver|v)|retake|rtk|rt|r|リテイク|リテーク|修正)"
    r"[ _.\-]?(?P<number>\d{1,3})[)\]]?",
    re.IGNORECASE,
)


@dataclass(frozen=True, slots=True)
class States:
    """Names of one thing by their indices, oldest first; versions replace it as a whole, retakes single drawings."""

    indices: tuple[int, ...]
    are_versions: bool


def states_among(names: Sequence[str]) -> tuple[States, ...]:
    """Return which of names that lie together are states of one thing; each has at least two."""
    found: dict[str, list[tuple[int, int]]] = defaultdict(list)
    versions: set[str] = set()
    for index, name in enumerate(names):
        state = _STATE.fullmatch(half_width(name).strip())
        base = key(state["base"] if state else half_width(name))
        found[base].append((int(state["number"]) if state else -1, index))
        if state and state["version"]:
            versions.add(base)
    return tuple(
        States(tuple(index for _, index in sorted(members)), base in versions)
        for base, members in found.items()
        if len(members) > 1 and len({number for number, _ in members}) == len(members)
    )
