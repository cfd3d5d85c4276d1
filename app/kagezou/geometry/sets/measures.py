"""Which kinds of set pieces there are, and what one is built from."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from enum import StrEnum
from types import MappingProxyType
from typing import TypeVar

Row = TypeVar("Row")


class PieceKind(StrEnum):
    """What a set piece is, in the order in which people read the kinds."""

    WALL = "wall"
    BOX = "box"
    STEPS = "steps"
    RAMP = "ramp"
    CYLINDER = "cylinder"
    SPHERE = "sphere"
    MESH = "mesh"
    """Read from a file; measures build nothing of it."""


def by_kind(rows: Mapping[PieceKind, Row]) -> Mapping[PieceKind, Row]:
    """Return a table of kinds; LookupError, as the table is imported, where a kind was forgotten."""
    missing = [kind.name for kind in PieceKind if kind not in rows]
    if missing:
        raise LookupError(f"a table of kinds has no row for {', '.join(missing)}")
    return MappingProxyType({kind: rows[kind] for kind in PieceKind})


@dataclass(frozen=True, slots=True)
class Measures:
    """What a piece is made from: its kind, and the sizes, angles and counts of its properties.

    Sizes are world px; where a piece is not placed yet they are canvas px at the depth where it is to stand.
    """

    kind: PieceKind
    width_px: float
    height_px: float
    depth_px: float
    lean_deg: float = 0.0
    count: int = 1

    def scaled(self, scale: float) -> "Measures":
        """Return the same with every size times ``scale``."""
        width, height, depth = (size * scale for size in (self.width_px, self.height_px, self.depth_px))
        return replace(self, width_px=width, height_px=height, depth_px=depth)
