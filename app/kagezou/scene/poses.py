"""What poses do to shadows in a jump: one that stretches in the air casts no more than those on the ground around it.

A figure crouches before it jumps and stretches when it does, so its shadow would grow while it rises, the more the
nearer the lamp. How much a pose casts is told by the box around it, which is known without its pixels.
"""

from dataclasses import dataclass, replace

import numpy as np

from kagezou.document.model import Document, Layer
from kagezou.geometry.box import Box
from kagezou.geometry.card import Card, card_for
from kagezou.geometry.placement import Placement
from kagezou.geometry.shadow import Cast, cast_card
from kagezou.geometry.vectors import Matrix, Point2, Vector4
from kagezou.scene.figure_card import Moment, card_of, card_on_feet, feet_at
from kagezou.scene.lift import Lift, lift_at, middle_below
from kagezou.scene.placing import figure_box
from kagezou.scene.stances import stances_of

_UNIT = Box(0, 0, 1000, 1000)
_WIDE_CANVASES = 4
"""So far around the canvas shadows are measured; a low lamp casts without end."""


_HALVINGS = 14


@dataclass(frozen=True, slots=True)
class _Pose:
    """The box around a figure, canvas px from the ground below it."""

    left: float
    top: float
    width: float
    height: float

    @classmethod
    def of(cls, box: Box, below: Point2) -> "_Pose":
        return cls(box.left - below[0], box.top - below[1], box.width, box.height)

    def at(self, below: Point2, size: float = 1.0) -> Placement:
        """Return what lays the unit box where the pose is, over another place of the ground and as much smaller."""
        position = (below[0] + size * self.left, below[1] + size * self.top)
        scale = (size * self.width / _UNIT.width, size * self.height / _UNIT.height)
        return Placement(position, (0.0, 0.0), scale)


def casting_of(on: Moment, figure: Layer, since: int, light: Vector4) -> tuple[Card, Lift | None]:
    """Return the card on which a figure casts, and in the air how it is lowered while it does, its pose counted.

    Parameters
    ----------
    on, figure
        The frame, and a layer with a figure of its own.
    since
        The frame whose values of stance and shadow count.
    light
        Homogeneous.
    """
    lift = lift_at(on.document, figure, on.frame, since)
    if lift is None:
        return card_of(on, figure, since), None
    lowered = replace(lift, size=lift.size * pose_size(on, figure, lift, light))
    return card_on_feet(on, figure, since, lowered.lowered_standing), lowered


def pose_size(on: Moment, figure: Layer, lift: Lift, light: Vector4) -> float:
    """Return the size, at most 1, at which a pose in the air casts as much as those around the jump, seen as boxes.

    Between the pose it jumps off with and the one it lands with that passes over evenly in time.

    Parameters
    ----------
    on, figure
        The frame, and the layer with the figure.
    lift
        How it is in the air.
    light
        Homogeneous.
    """
    wanted = _around_jump(on, figure)
    x, y = lift.about
    own = _Pose.of(figure_box(on.document, figure.id, on.frame), (x, y - lift.height_px))
    cast = _flat_cast(on, lift.about, light)
    if cast is None or not wanted:
        return 1.0
    most = sum(share * _area(on, cast, pose.at(lift.about)) for share, pose in wanted)
    if _area(on, cast, own.at(lift.about)) <= most:
        return 1.0
    # Near a lamp a shadow grows faster than the square of the figure; there is no formula for the way back.
    low, high = 0.0, 1.0
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        low, high = (low, middle) if _area(on, cast, own.at(lift.about, middle)) > most else (middle, high)
    return high


def _around_jump(on: Moment, figure: Layer) -> list[tuple[float, _Pose]]:
    """Return the poses on the ground before and after a jump, and how much each counts; none where there are none."""
    found = stances_of(on.document, figure.id)
    start, before, after = (None, None, None) if found is None else found.around_jump(on.frame)
    if before is None or after is None or start is None:
        return [(1.0, pose) for frame in (before, after) if (pose := _pose(on.document, figure, frame)) is not None]
    share = (start - before) / (after - before)
    ends = ((1 - share, _pose(on.document, figure, before)), (share, _pose(on.document, figure, after)))
    return [(each, pose) for each, pose in ends if pose is not None]


def _pose(document: Document, figure: Layer, frame: int | None) -> _Pose | None:
    standing = None if frame is None else feet_at(document, figure, frame)
    if standing is None or frame is None:
        return None
    return _Pose.of(figure_box(document, figure.id, frame), middle_below(standing[0]))


def _flat_cast(on: Moment, below: Point2, light: Vector4) -> Cast | None:
    """Return what a flat card over a place of the ground casts."""
    card = card_for(on.camera, on.ground, [below], 0.0, 1.0)
    return next(iter(cast_card(on.camera, on.ground, card, light)), None)


def _area(on: Moment, cast: Cast, placement: Placement) -> float:
    """Return the area of the shadow of a placed box, canvas px²."""
    if not placement.is_seen:
        return 0.0
    width, height = on.camera.width_px, on.camera.height_px
    wide = Box(0, 0, width, height).grown(_WIDE_CANVASES * max(width, height))
    return _area_of(cast.of_moved(placement).region(wide, _UNIT, 0.0))


def _area_of(polygon: Matrix) -> float:
    x, y = polygon[:, 0], polygon[:, 1]
    return abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1))) / 2
