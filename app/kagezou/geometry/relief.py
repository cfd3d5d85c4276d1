"""The relief card: a body parallel to the screen whose legs reach to their feet's depth.

Over the canvas, with feet i at (x_i, y_i) and the depths z_i of the places where the ground lies below them, their mean
m and the figure's height H::

    s(x)    piecewise linear through (x_i, z_i), constant outside      which foot a column belongs to
    a(h)    1 for h <= FOOT, 0 for h >= HIP, linear between            h = (y_foot(x) - y) / H
    z(x,y)  m + a·(s(x) - m)

cut into flat pieces by the columns of the feet and the rows of foot and hip. What all of the card has beside that,
being turned and being stood up, is a slope that is taken off the feet's depths before and given back after: so feet
stay where they are.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import pairwise
from typing import Final

from kagezou.geometry.camera import Camera
from kagezou.geometry.card import (
    MIN_SPACING_OF_FIGURE,
    Card,
    CardPiece,
    card_for,
    piece_through,
    rising_piece,
    slope_of,
    standing_piece,
    turned_form,
)
from kagezou.geometry.contact import contact_line, risen
from kagezou.geometry.ground import Plane, place_on
from kagezou.geometry.lean import Lean, line_through
from kagezou.geometry.vectors import Point2, Vector3

FOOT: Final = 0.06
HIP: Final = 0.42
"""Between these parts of the figure's height over its feet a leg reaches from its foot's depth to the body's."""

_BESIDE: Final = 0.1
"""A lifted foot nearer than this part of the height, in x, goes over to the depth of the foot that it passes."""

_CARDS_KEPT: Final = 256
"""Cards of so many frames and figures; a light that is dragged leaves them as they are."""

_SAME_COLUMN_PX: Final = 1e-3
_FLAT_PX: Final = 1e-6


@dataclass(frozen=True, slots=True)
class Foothold:
    """A foot of a figure and the ground below it.

    Parameters
    ----------
    place
        The foot's lowest point, canvas px.
    ground_row
        The canvas row at which the ground lies below it; its own row where it stands.
    is_planted
        Whether it carries the figure.
    """

    place: Point2
    ground_row: float
    is_planted: bool


@dataclass(frozen=True, slots=True)
class _Foot:
    """A foothold and its place on the ground; it is drawn at ``row`` and ``depth``, that without the card's lean."""

    at: Point2
    place: Vector3
    is_planted: bool
    row: float
    depth: float


@dataclass(frozen=True, slots=True)
class _Leg:
    """What a foot is to the pieces beside it.

    Parameters
    ----------
    column
        The canvas line over the foot, positive to the right.
    foot, hip
        Where the leg leaves the foot's depth, and where it reaches the body's, world px.
    foot_px, hip_px
        Where these are seen.
    """

    column: Vector3
    foot: Vector3
    hip: Vector3
    foot_px: Point2
    hip_px: Point2


def relief_card(
    camera: Camera,
    ground: Plane,
    footholds: Sequence[Foothold],
    height_px: float,
    tilt_deg: float = 0.0,
    upright: float = 0.0,
) -> Card:
    """Return the card of a figure that stands on feet; ``contacts`` are the planted ones, or all where none is.

    One foot gives the flat card through its place on the ground. Feet whose ground would lie above the horizon are
    left out. A lifted foot that passes another goes over to its depth, so that nothing jumps when they change sides;
    planted feet closer in x than 0.02 of the height come to their common middle, and the card says so.

    Parameters
    ----------
    camera, ground
        What the feet are seen with and stand on.
    footholds
        In any order.
    height_px
        Height of the figure.
    tilt_deg, upright
        How the body is turned, and how far it is stood up along the ground's normal; planted feet stay.
    """
    return _card_on(camera, ground, tuple(footholds), height_px, tilt_deg, upright)


@lru_cache(_CARDS_KEPT)
def _card_on(
    camera: Camera, ground: Plane, footholds: tuple[Foothold, ...], height_px: float, tilt_deg: float, upright: float
) -> Card:
    """Return the card as :func:`relief_card` does, the very one while nothing that it is made of changes."""
    found = ((hold, place_on(camera, ground, (hold.place[0], hold.ground_row))) for hold in footholds)
    seen = sorted(((hold, place) for hold, place in found if place is not None), key=lambda each: each[0].place)
    if len(seen) < 2:
        alone = [(hold.place[0], hold.ground_row) for hold, _ in seen]
        return card_for(camera, ground, alone, tilt_deg, height_px, upright)
    height = max(height_px, 1.0)
    lean = Lean.of(camera, ground, [hold.place for hold, _ in seen], slope_of(tilt_deg), upright)
    feet = [
        _Foot((hold.place[0], hold.ground_row), place, hold.is_planted, hold.place[1], lean.depth_of(place))
        for hold, place in seen
    ]
    standing = [foot.place for foot in feet if foot.is_planted] or [foot.place for foot in feet]
    return Card(
        pieces=_pieces(camera, lean, feet, height),
        contacts=tuple(standing),
        tilt_deg=tilt_deg,
        merged=_are_close([foot for foot in feet if foot.is_planted], height),
        upright=lean.upright,
        contact_line=contact_line(
            ground, lean, [foot.place for foot in feet], (feet[-1].at[0] - feet[0].at[0]) / height
        ),
    )


def _pieces(camera: Camera, lean: Lean, feet: Sequence[_Foot], height: float) -> tuple[CardPiece, ...]:
    settled = _settled(feet, height)
    body = sum(foot.depth for foot in settled) / len(settled)
    legs = [_leg(camera, lean, foot, body, height) for foot in _in_columns(settled)]
    if len(legs) < 2 or max(abs(foot.depth - body) for foot in settled) < _FLAT_PX:
        return (standing_piece(legs[0].hip, lean),)
    # All hips lie on the body's plane, so that none is seen above the row of the one highest in the world.
    highest = min(legs, key=lambda leg: leg.hip[1])
    above = lean.row(camera, highest.hip)
    pieces: tuple[CardPiece, ...] = (replace(standing_piece(highest.hip, lean), limits=(above,)),)
    pieces += _outside(camera, lean, legs[0], (turned_form(legs[0].column), above))
    for left, right in pairwise(legs):
        pieces += _between(lean, left, right, above)
    return pieces + _outside(camera, lean, legs[-1], (legs[-1].column, above))


def _outside(camera: Camera, lean: Lean, leg: _Leg, bounds: tuple[Vector3, Vector3]) -> tuple[CardPiece, ...]:
    """Return the pieces beyond an outermost foot, which go on across as they are over the foot.

    ``bounds`` are the column, positive there, and the line above which all is the body's main piece. Below that lie
    what is left of the body, the leg and the foot.
    """
    side, above = bounds
    over_hip, over_foot = lean.row(camera, leg.hip), lean.row(camera, leg.foot)
    x, y, z = leg.foot
    across = (x + 1.0, y, z + lean.across)
    return (
        *_rest_of_body(lean, (leg,), above, (side, over_hip)),
        piece_through(leg.foot, across, leg.hip, (side, turned_form(over_hip), over_foot)),
        replace(standing_piece(leg.foot, lean), limits=(side, turned_form(over_foot))),
    )


def _between(lean: Lean, a: _Leg, b: _Leg, above: Vector3) -> tuple[CardPiece, ...]:
    """Return the pieces between neighbouring feet: what is left of the body, two triangles, and the feet's."""
    sides = (a.column, turned_form(b.column))
    over_hip, over_foot = line_through(a.hip_px, b.hip_px), line_through(a.foot_px, b.foot_px)
    over_diagonal = line_through(a.hip_px, b.foot_px)
    return (
        *_rest_of_body(lean, (a, b), above, (*sides, over_hip)),
        piece_through(a.hip, b.hip, b.foot, (*sides, turned_form(over_hip), over_diagonal)),
        piece_through(a.foot, b.foot, a.hip, (*sides, turned_form(over_diagonal), over_foot)),
        rising_piece(a.foot, b.foot, lean, (*sides, turned_form(over_foot))),
    )


def _rest_of_body(
    lean: Lean, legs: Sequence[_Leg], above: Vector3, limits: tuple[Vector3, ...]
) -> tuple[CardPiece, ...]:
    """Return the piece of the body below its main one, none where the legs' hips are on that line."""
    a, b, c = above
    if all(a * leg.hip_px[0] + b * leg.hip_px[1] + c > -_FLAT_PX for leg in legs):
        return ()
    return (replace(standing_piece(legs[0].hip, lean), limits=(*limits, turned_form(above))),)


def _leg(camera: Camera, lean: Lean, foot: _Foot, body: float, height: float) -> _Leg:
    a, b, c = column = lean.column(camera, foot.at, lean.seen_at(camera, foot.depth, foot.at))
    foot_row, hip_row = foot.row - FOOT * height, foot.row - HIP * height
    foot_px, hip_px = (-(b * foot_row + c) / a, foot_row), (-(b * hip_row + c) / a, hip_row)
    on_foot, on_body = lean.seen_at(camera, foot.depth, foot_px), lean.seen_at(camera, body, hip_px)
    return _Leg(column, on_foot, on_body, foot_px, hip_px)


def _settled(feet: Sequence[_Foot], height: float) -> list[_Foot]:
    """Return the feet with rows and depths that meet where their columns do."""
    near = (MIN_SPACING_OF_FIGURE / 2, MIN_SPACING_OF_FIGURE)
    standing = [foot for foot in feet if foot.is_planted]
    lifted = [foot for foot in feet if not foot.is_planted]
    firm = [
        _drawn_to(foot, [(other, 0.5) for other in standing if other is not foot], near, height) for foot in standing
    ]
    loose = [
        _drawn_to(
            foot,
            [*((other, 1.0) for other in firm), *((other, 0.5) for other in lifted if other is not foot)],
            (0.0, _BESIDE),
            height,
        )
        for foot in lifted
    ]
    return sorted((*firm, *loose), key=lambda foot: foot.at)


def _drawn_to(foot: _Foot, others: Sequence[tuple[_Foot, float]], near: tuple[float, float], height: float) -> _Foot:
    """Return a foot with its row and depth drawn toward those of others beside it.

    Parameters
    ----------
    others
        Each with the part of the way that the foot goes to it where their columns meet.
    near
        At which distance in x, as parts of the height, it is all the way there, and at which it has not begun.
    """
    total, row, depth = 1.0, foot.row, foot.depth
    for other, share in others:
        apart = risen((abs(other.at[0] - foot.at[0]) / height - near[0]) / (near[1] - near[0]))
        weight = 1 / max(apart, 1e-9) - 1
        total += weight
        row += weight * (foot.row + share * (other.row - foot.row))
        depth += weight * (foot.depth + share * (other.depth - foot.depth))
    return replace(foot, row=row / total, depth=depth / total)


def _in_columns(feet: Sequence[_Foot]) -> list[_Foot]:
    """Return the feet, one of those in one column: they have come to the same row and depth there."""
    kept = [feet[0]]
    kept += [foot for before, foot in pairwise(feet) if foot.at[0] - before.at[0] > _SAME_COLUMN_PX]
    return kept


def _are_close(feet: Sequence[_Foot], height: float) -> bool:
    return any(b.at[0] - a.at[0] < MIN_SPACING_OF_FIGURE * height for a, b in pairwise(feet))
