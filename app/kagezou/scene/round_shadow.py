"""The round shadow: a disc on the ground under a figure, as wide as its stance and body ask for (figures)."""

from collections.abc import Sequence
from dataclasses import replace
from math import dist
from typing import Final

from kagezou.document.figures import height_of
from kagezou.document.model import Layer
from kagezou.geometry.box import Box, centred_offset
from kagezou.geometry.card import Card
from kagezou.geometry.contact import contact_plane
from kagezou.geometry.disc import Ellipse, GroundDisc, floating_discs, light_over
from kagezou.geometry.ground import place_on
from kagezou.geometry.placement import Placement
from kagezou.geometry.relief import Foothold
from kagezou.geometry.vectors import Point2, Vector3
from kagezou.scene.disc import DISC_PX, DISC_RADIUS_PX, Disc
from kagezou.scene.figure_card import Moment, feet_at
from kagezou.scene.lift import Lift
from kagezou.scene.placing import figure_box
from kagezou.scene.scene import ShadowCast
from kagezou.scene.stances import FigureStances, stances_of
from kagezou.standing.seen import Standing

_BODY_OF_FIGURE: Final = 0.275
"""The radius of the disc of a figure that stands on one place, as a part of its height.

Between two artists: the shadow of one was 0.64 to 0.74 of the figure's height wide, that of the other 0.48 to 0.59.
"""

_OF_REACH: Final = 0.2
"""By this part of the way from the middle to the outermost foot, as it is around that moment, it is larger."""

_BEYOND_FEET: Final = 0.05
"""So far beyond the outermost foot it goes at least, as a part of the height."""

_AROUND_S: Final = 0.25
"""Over the drawings so long before and after the stance is evened out: about a step of a walk."""

_COUNTS_NO_MORE: Final = 0.3
"""A foot so high over the lowest one, as a part of the height, hardly counts."""

_LEAST_WEIGHT: Final = 1e-6

_END_ON: Final = 1e-6

_Weighted = tuple[Vector3, float]


def rounded(on: Moment, figure: Layer, since: int, lift: Lift | None, cast: ShadowCast) -> ShadowCast | None:
    """Return a cast with the disc under the figure instead of its cels; None where the ground is seen edge-on.

    Parameters
    ----------
    on, figure
        The frame, and the layer with the figure.
    since
        The frame whose way to stand counts.
    lift
        How it is in the air; None on the ground.
    cast
        What it casts; without feet its card says where the figure stands: on its points, or on the contact line
        below the middle of its box.
    """
    standing, found = feet_at(on.document, figure, on.frame, since), stances_of(on.document, figure.id)
    tall = height_of(figure, since) if found is None else found.height_px
    own = _places(on, standing[0], tall) if standing else []
    own = own or [(place, 1.0) for place in cast.card.contacts or (below_box(on, figure, cast.card),)]
    around = (_around(on, found) if standing and found else []) or [own]
    middle = _mean([(_mean(places), 1.0) for places in around])
    usual = sum(_reach(_mean(places), places) for places in around) / len(around)
    radius = max(_BODY_OF_FIGURE * tall + _OF_REACH * usual, _reach(middle, own) + _BEYOND_FEET * tall)
    size = 1.0 if lift is None else lift.size
    return cast_by_discs(on, [GroundDisc(middle, max(size * radius, 1.0))], max(tall, 1.0), cast)


def cast_by_discs(on: Moment, discs: Sequence[GroundDisc], height_px: float, cast: ShadowCast) -> ShadowCast | None:
    """Return a cast with discs on the ground instead of cels; None where the ground is seen edge-on.

    Parameters
    ----------
    on
        The frame.
    discs
        At least one.
    height_px
        How high over the ground the discs float that cast them.
    cast
        What is kept but for the silhouette, its card and the lights.
    """
    seen = floating_discs(on.camera, on.ground, discs, height_px)
    if seen is None:
        return None
    card, ellipses = seen
    figure = tuple(Disc(_laid(on, ellipse)) for ellipse in ellipses)
    return replace(cast, figure=figure, translucent=False, card=card, lights=(light_over(on.ground),))


def _around(on: Moment, found: FigureStances) -> list[list[_Weighted]]:
    """Return the places of the feet in the stances around a frame, which even out what single drawings do."""
    stances = found.around(on.frame, _AROUND_S * float(on.document.canvas.frame_rate))
    return [places for stance in stances if (places := _places(on, stance.feet, found.height_px))]


def below_box(on: Moment, figure: Layer, card: Card) -> Vector3:
    """Return the place of the contact line that is seen under the middle of the boxes around a figure, world px."""
    frames = _held_around(figure, on.frame, _AROUND_S * float(on.document.canvas.frame_rate))
    x = sum(figure_box(on.document, figure.id, frame).middle[0] for frame in frames) / len(frames)
    line = contact_plane(card, on.ground)
    px, _, pw = on.camera.canvas_from_world() @ (*line.origin, 1.0)
    ax, _, aw = on.camera.canvas_from_world() @ (*line.u, 0.0)
    # A line that is seen end-on is under every column.
    along = (x * pw - px) / (ax - x * aw) if abs(ax - x * aw) > _END_ON else 0.0
    return line.point(float(along), 0.0)


def _held_around(figure: Layer, frame: int, frames: float) -> list[int]:
    """Return a frame and as many before as after it on which drawings begin, at most so many frames away."""
    since = figure.cels.exposed_since(frame)
    before = [each.frame for each in figure.cels.exposures if since - frames <= each.frame < since]
    after = [each.frame for each in figure.cels.exposures if since < each.frame <= since + frames]
    count = min(len(before), len(after))
    return [*before[len(before) - count :], frame, *after[:count]]


def _places(on: Moment, feet: Sequence[Foothold | Standing], tall: float) -> list[_Weighted]:
    """Return the places on the ground below feet, and how much each counts; a foot above the horizon has none.

    The higher a foot is over the lowest one the less it counts: a kick does not take the shadow with it.
    """
    lowest = min((foot.ground_row - foot.place[1] for foot in feet), default=0.0)
    found: list[_Weighted] = []
    for foot in feet:
        place = place_on(on.camera, on.ground, (foot.place[0], foot.ground_row))
        up = (foot.ground_row - foot.place[1] - lowest) / (_COUNTS_NO_MORE * tall)
        if place is not None:
            found.append((place, (1 - min(up, 1.0)) ** 2 + _LEAST_WEIGHT))
    return found


def _mean(places: Sequence[_Weighted]) -> Vector3:
    whole = sum(weight for _, weight in places)
    x, y, z = (sum(weight * place[axis] for place, weight in places) / whole for axis in range(3))
    return (x, y, z)


def _reach(middle: Vector3, places: Sequence[_Weighted]) -> float:
    """Return how far the outermost foot is from a place."""
    return max(min(weight, 1.0) * dist(middle, place) for place, weight in places)


def _laid(on: Moment, ellipse: Ellipse) -> Placement:
    """Return how the unit disc lies on the canvas where it is seen as an ellipse."""
    first, second = ellipse.half_axes
    scale = (first / DISC_RADIUS_PX, second / DISC_RADIUS_PX)
    return Placement(ellipse.middle, _disc_middle(on), scale, ellipse.rotation_deg)


def _disc_middle(on: Moment) -> Point2:
    """Return where the middle of the unit disc lies before it is placed, canvas px."""
    canvas = Box(0, 0, on.camera.width_px, on.camera.height_px)
    left, top = centred_offset(canvas, DISC_PX, DISC_PX)
    return (left + DISC_PX / 2, top + DISC_PX / 2)
