"""Contact sheets of whole cuts: a style on each character, a row of frames, and its shadow over the cut in words."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import reduce
from typing import Final

import numpy as np

from kagezou.animation.frames import spread_frames
from kagezou.cli.contact_sheet import Picture, cell_of, framed
from kagezou.document.model import Document
from kagezou.document.style import Style
from kagezou.document.styling import put_style
from kagezou.export.cut_measures import ShadowSeen
from kagezou.export.portraits import Portraits
from kagezou.geometry.box import Box
from kagezou.render.prepare.backdrop import Backdrop

_COLUMNS: Final = 12
_SIDE_PX: Final = 160


@dataclass(frozen=True, slots=True)
class CutSheet:
    """A sheet and a line on each of its rows.

    Parameters
    ----------
    picture
        (H, W, 4).
    lines
        One a character, from the top.
    """

    picture: Picture
    lines: tuple[str, ...]


def cut_sheet(cuts: Sequence[Document], style: Style) -> CutSheet:
    """Return the first figure of each cut in a style with its light, over the cut, with the context that is current."""
    rows, lines = [], []
    for cut in cuts:
        figure_id = cut.layers[0].id
        dressed = put_style(cut, [layer.id for layer in cut.layers], style, 1, with_light=True).document
        portraits = Portraits(dressed, figure_id, 1, _SIDE_PX)
        rows.append(_row(portraits, dressed))
        seen = portraits.over_cut(dressed, range(1, cut.canvas.length_frames + 1))
        lines.append(f"{cut.layers[0].name}\t{'  '.join(words_on(seen))}")
        portraits.close()
    widest = max(row.shape[1] for row in rows)
    return CutSheet(framed([_widened(row, widest) for row in rows]), tuple(lines))


def words_on(seen: Sequence[ShadowSeen]) -> Iterator[str]:
    """Yield what an artist would ask about a shadow over a cut."""
    if not seen:
        yield "no shadow"
        return
    areas = np.array([each.area_px2 for each in seen])
    islands, holes = ([len(parts) for parts in each] for each in _parts(seen))
    yield f"islands {min(islands)}-{max(islands)}"
    yield f"holes {min(holes)}-{max(holes)}"
    yield f"least island {min(each.part_areas_px2[-1] for each in seen):.0f} px2"
    yield f"area {areas.min() / areas.mean():.2f}-{areas.max() / areas.mean():.2f} of its mean"
    yield f"hidden {100 * np.mean([each.hidden for each in seen]):.0f} %"
    under = sum(each.is_under_figure for each in seen)
    yield f"direction within {swing_deg(seen):.0f} deg" if 2 * under < len(seen) else "under the figure"
    moved = [(each.outline_px, each.drawing_px) for each in seen]
    shadow, drawing = (
        float(np.mean([0.0 if one is None else one for one in each])) for each in zip(*moved, strict=True)
    )
    yield f"outline {shadow:.1f} px a frame, the drawing's {drawing:.1f}"


def swing_deg(seen: Sequence[ShadowSeen]) -> float:
    """Return by how much the direction of a shadow changes over a cut, degrees."""
    turns = np.radians([each.direction_deg for each in seen])
    middle = np.angle(np.exp(1j * turns).mean())
    away = np.degrees(np.angle(np.exp(1j * (turns - middle))))
    return float(away.max() - away.min())


def _mean(numbers: Iterable[float | None]) -> float:
    """Return the mean of what is known; 0 where nothing is."""
    known = [each for each in numbers if each is not None]
    return sum(known) / max(len(known), 1)


def _parts(seen: Sequence[ShadowSeen]) -> tuple[list[tuple[float, ...]], list[tuple[float, ...]]]:
    return [each.part_areas_px2 for each in seen], [each.hole_areas_px2 for each in seen]


def _row(portraits: Portraits, document: Document) -> Picture:
    frames = spread_frames(document.canvas.length_frames, _COLUMNS)
    around = reduce(Box.union, (portraits.box(document, frame) for frame in frames))
    backdrop = Backdrop.BACKGROUND if document.background else Backdrop.WHITE
    cells = [cell_of(portraits.draw(document, around, backdrop, frame), _SIDE_PX) for frame in frames]
    return np.concatenate(cells, axis=1)


def _widened(row: Picture, width: int) -> Picture:
    """Return a row with grey to its right."""
    return np.pad(row, [(0, 0), (0, width - row.shape[1]), (0, 0)], mode="edge")
