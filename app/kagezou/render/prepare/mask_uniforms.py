"""A mask as ``sets/mask.frag`` wants it: its regions in a row, their lines and conics in tables."""

from dataclasses import dataclass, field

import numpy as np

from kagezou.geometry.sets.regions import Group
from kagezou.geometry.vectors import Matrix
from kagezou.render.prepare.mask_tiles import Mask
from kagezou.render.prepare.uniforms import Uniform

MAX_REGIONS, MAX_LINES, MAX_CONICS = 40, 120, 20

TABLE_SIZES = frozenset({f"MAX_REGIONS {MAX_REGIONS}", f"MAX_LINES {MAX_LINES}", f"MAX_CONICS {MAX_CONICS}"})
"""Switches of ``sets/mask.frag``: within what every driver has room for."""

LAST, OVERLAPS, OWN, LIGHT = 1, 2, 4, 8
"""Flags of a region: the last of its group, one of a group that overlaps, of the receiver itself, of the light."""


@dataclass(slots=True)
class _Tables:
    shift: Matrix
    regions: list[tuple[float, float, float, float]] = field(default_factory=list)
    lines: list[Matrix] = field(default_factory=list)
    line_count: int = 0
    conics: list[Matrix] = field(default_factory=list)

    def add(self, group: Group, flags: int) -> None:
        """Add a group; its last region closes it."""
        for index, region in enumerate(group.regions):
            first = self.line_count
            self.lines.append(region.lines)
            self.line_count += len(region.lines)
            conic = -1
            if region.conic is not None:
                conic = len(self.conics)
                self.conics.append(_packed(self.shift.T @ region.conic @ self.shift))
            is_last = LAST if index == len(group.regions) - 1 else 0
            overlaps = OVERLAPS if group.overlaps else 0
            self.regions.append((first, self.line_count, conic, flags | is_last | overlaps))


def fits(mask: Mask) -> bool:
    """Whether the tables have room for a mask."""
    regions = [region for group in mask.groups for region in group.regions]
    return (
        len(regions) <= MAX_REGIONS
        and sum(len(region.lines) for region in regions) <= MAX_LINES
        and sum(region.conic is not None for region in regions) <= MAX_CONICS
    )


def mask_uniforms(mask: Mask, origin_px: tuple[float, float]) -> dict[str, Uniform]:
    """Return the uniforms of a mask around a canvas point; what the tables have no room for is left out."""
    tables = _Tables(np.array([[1.0, 0.0, origin_px[0]], [0.0, 1.0, origin_px[1]], [0.0, 0.0, 1.0]]))
    if mask.outline is not None:
        tables.add(mask.outline, OWN)
    for group in mask.hidden:
        tables.add(group, 0)
    for group in mask.unlit:
        tables.add(group, LIGHT)
    uniforms: dict[str, Uniform] = {"u_origin_px": origin_px, "u_region_count": min(len(tables.regions), MAX_REGIONS)}
    if tables.regions:
        uniforms["u_regions"] = np.array(tables.regions[:MAX_REGIONS], dtype=np.float64)
    if tables.line_count:
        lines = np.concatenate(tables.lines)[:MAX_LINES] @ tables.shift
        uniforms["u_lines"] = np.column_stack([lines, np.zeros(len(lines))])
    if tables.conics:
        uniforms["u_conics"] = np.concatenate(tables.conics[:MAX_CONICS])
    return uniforms


def _packed(conic: Matrix) -> Matrix:
    """Return a conic (3, 3) as two rows of four, scaled to a slope of about one px at its rim."""
    scale = float(np.abs(conic[:2]).max()) or 1.0
    xx, xy, x, yy, y, one = (conic / scale)[np.triu_indices(3)]
    return np.array([[xx, 2 * xy, yy, 2 * x], [2 * y, one, 0.0, 0.0]])
