"""How far a wall must reach so that the figures' shadows fit on it, over the whole cut."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Final

from kagezou.animation.frames import spread_frames
from kagezou.document.model import Document
from kagezou.geometry.ground import Plane
from kagezou.geometry.vectors import Vector3, Vector4, dot
from kagezou.tools.frame_geometry import FrameGeometry
from kagezou.tools.sight import between, moved, on_plane
from kagezou.tools.view import CanvasView

_MOST_FRAMES: Final = 49


@dataclass(frozen=True, slots=True)
class FigureSide:
    """One side of a figure on its card, from its foot to its top, world px, and the light that it stands in."""

    foot: Vector3
    top: Vector3
    light: Vector4


@dataclass(frozen=True, slots=True)
class Reach:
    """Where shadows fall on a wall: from where to where along it, and how high, world px from its stand's origin."""

    left: float
    right: float
    top: float


def sides_of(document: Document, frame: int) -> tuple[FigureSide, ...]:
    """Return the sides of all figures on a frame and on some others, spread over the cut."""
    frames = {frame, *spread_frames(document.canvas.length_frames, _MOST_FRAMES)}
    figures = [layer.id for layer in document.layers if layer.joins is None]
    return tuple(
        side
        for at in sorted(frames)
        for each in figures
        for side in _sides(FrameGeometry.of(document, at, each, CanvasView()))
    )


def _sides(geometry: FrameGeometry) -> Iterator[FigureSide]:
    box, card = geometry.figure_box, geometry.card
    if card is None or box.is_empty or not geometry.is_figure_shown:
        return
    for x in (float(box.left), float(box.right)):
        ends = [(x, float(y)) for y in (box.bottom, box.top)]
        foot, top = (on_plane(geometry.camera, card.piece_at(end).plane, end) for end in ends)
        if foot is not None and top is not None:
            yield FigureSide(foot, top, geometry.light)


def reach_on(sides: Iterable[FigureSide], stand: Plane, most_px: float) -> Reach | None:
    """Return where the shadows of figures' sides fall on the upright wall of a stand; None where none does.

    Shadows that would fall farther than ``most_px`` along the wall or over it count as far as that.
    """
    places: list[tuple[float, float]] = []
    for side in sides:
        low, high = (_fallen(stand, end, side.light) for end in (side.foot, side.top))
        if high is None or high[1] <= 0:
            continue
        places.append(high)
        if low is not None:
            part = max(low[1] / (low[1] - high[1]), 0.0) if low[1] < 0 else 0.0
            places.append((low[0] + part * (high[0] - low[0]), max(low[1], 0.0)))
    if not places:
        return None
    along = [min(max(place[0], -most_px), most_px) for place in places]
    return Reach(min(along), max(along), min(max(place[1] for place in places), most_px))


def _fallen(stand: Plane, place: Vector3, light: Vector4) -> tuple[float, float] | None:
    """Return where the shadow of a place falls on a wall's plane: along the wall, and how high."""
    x, y, z, w = light
    ray = (w * place[0] - x, w * place[1] - y, w * place[2] - z)
    before, nearing = dot(between(stand.origin, place), stand.v), -dot(ray, stand.v)
    if before < 0 or nearing <= 1e-9:
        return None
    hit = between(stand.origin, moved(place, (before / nearing, ray)))
    return (dot(hit, stand.u), dot(hit, stand.normal))
