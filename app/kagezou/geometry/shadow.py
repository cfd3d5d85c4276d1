"""Where the shadow of a card falls on a flat receiver, in closed form (spec 2; paper 3.4).

The shadow map of a flat card is known exactly: the ray from a receiver point to the light meets the card's plane in
one point, and that point is seen at one place of the drawing. For a flat receiver the whole chain
canvas → receiver → card → drawing is one homography, with no texel grid between and so no bias, no acne and no gap
where a foot meets its shadow.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import combinations
from typing import Final

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.box import Box
from kagezou.geometry.camera import Camera
from kagezou.geometry.card import Card, CardPiece
from kagezou.geometry.ground import Plane, world_from_canvas_on
from kagezou.geometry.placement import Placement
from kagezou.geometry.polygon import box_polygon, clipped, distance_form, distance_forms, rectangle_edges, shifted
from kagezou.geometry.vectors import Matrix, Vector4, coinciding, height_over

_CASTS_KEPT: Final = 256
"""Enough for all lights and receivers of a scene, whose drawings change from frame to frame while they stay."""


@dataclass(frozen=True, slots=True, eq=False)
class Cast:
    """The shadow of one card piece from one light on one flat receiver, as seen on the canvas.

    Parameters
    ----------
    art_from_canvas
        (3, 3) homography from a canvas px of the receiver to the canvas px of the drawing that shades it.
    receiver_from_canvas
        (3, 3) homography to the receiver's (u, v) in px.
    side, horizon
        Distance forms (3,) in canvas px, each >= 0 inside: the side of the card away from the light, and the receiver
        in front of the eye.
    limits
        Distance forms (K, 3) of the piece's edges. The shadow lies where all forms are positive.
    number
        That of the piece on its card.
    sheet
        A number that all have whose shadows continue one another: those add up, of others the greater one counts.
    """

    art_from_canvas: Matrix
    receiver_from_canvas: Matrix
    side: Matrix
    horizon: Matrix
    limits: Matrix
    number: int = 0
    sheet: int = 0

    def seen_through(self, canvas_from_target: Matrix) -> "Cast":
        """Return the same shadow on another picture of the receiver, given as a (3, 3) homography to the canvas.

        Points beyond the other picture's own horizon are not part of it.
        """
        art = self.art_from_canvas @ canvas_from_target
        return replace(
            self,
            art_from_canvas=art / np.abs(art).max(),
            receiver_from_canvas=self.receiver_from_canvas @ canvas_from_target,
            side=distance_form(self.side @ canvas_from_target),
            horizon=distance_form(canvas_from_target[2]),
            limits=distance_forms(self.limits @ canvas_from_target),
        )

    def of_moved(self, placement: Placement) -> "Cast":
        """Return the same shadow with the drawing's px as they lie before a placement moves them."""
        art = placement.centred_from_canvas() @ self.art_from_canvas
        return replace(self, art_from_canvas=art / np.abs(art).max())

    def region(self, canvas: Box, art: Box, margin_px: float = 1.0) -> Matrix:
        """Return the convex polygon (N, 2) of ``canvas`` that can hold shadow of the drawing's box ``art``.

        Grown by ``margin_px`` on the canvas, so that partly covered pixels of the rim lie inside. N may be 0.
        """
        frame = rectangle_edges(self.art_from_canvas, (art.left, art.top), (art.right, art.bottom))
        polygon = clipped(box_polygon(canvas), shifted(self.horizon, -0.01))
        for edge in (self.side, *self.limits, *frame):
            polygon = clipped(polygon, shifted(edge, margin_px))
        return polygon


@dataclass(frozen=True, slots=True, eq=False)
class SpaceCast:
    """The shadow of one card piece from one light, anywhere in space.

    Parameters
    ----------
    art_from_world
        (3, 4) map from a shaded world point to the canvas px of the drawing that shades it.
    side
        A form (4,) over the world, >= 0 beyond the card.
    limits
        Forms (K, 4) of the piece's edges, >= 0 in what is shaded by the piece.
    """

    art_from_world: Matrix
    side: Matrix
    limits: Matrix

    @property
    def forms(self) -> Matrix:
        """The side and the limits, (1 + K, 4)."""
        return np.vstack([self.side, self.limits])

    def of_moved(self, placement: Placement) -> "SpaceCast":
        """Return the same shadow with the drawing's px as they lie before a placement moves them."""
        return replace(self, art_from_world=placement.centred_from_canvas() @ self.art_from_world)


def cast_in_space(camera: Camera, piece: CardPiece, light: Vector4) -> SpaceCast | None:
    """Return what a piece casts, or None where the light stands within its plane."""
    found = _cast_in_space(camera, (piece,), light)
    if not found.casts[0]:
        return None
    return SpaceCast(found.art_from_world[0], found.sides[0], found.limits)


def cast_on(camera: Camera, receiver: Plane, piece: CardPiece, light: Vector4) -> Cast | None:
    """Return the cast of one piece, or None where nothing is cast or seen.

    Nothing is cast by a light on the dark side of the receiver or within the card's own plane, nothing by a card on
    itself, and nothing is seen of a receiver edge-on.
    """
    return next(iter(_cast_on(camera, receiver, (piece,), light)), None)


@lru_cache(_CASTS_KEPT)
def cast_card(camera: Camera, receiver: Plane, card: Card, light: Vector4) -> tuple[Cast, ...]:
    """Return the casts of all pieces of a card, left out where nothing is cast or seen.

    A pixel on the edge between two neighbours holds a part of each. Where their shadows lie on either side of the
    edge those parts add up: they are of one sheet. A shadow that is folded back over itself is of several.
    """
    casts = _cast_on(camera, receiver, card.pieces, light)
    sheets = _sheets([(card.pieces[cast.number], cast) for cast in casts])
    return tuple(replace(cast, sheet=sheet) if sheet else cast for cast, sheet in zip(casts, sheets, strict=True))


@dataclass(frozen=True, slots=True, eq=False)
class _SpaceCasts:
    """What P pieces cast in space: (P, 3, 4), (P, 4), and limits (K, 4) of all pieces, each with its owner (K,).

    ``casts`` (P,) says for which pieces the light does not stand within their plane.
    """

    art_from_world: Matrix
    sides: Matrix
    limits: Matrix
    owners: NDArray[np.intp]
    casts: NDArray[np.bool_]


@dataclass(frozen=True, slots=True, eq=False)
class _Flats:
    """Of P pieces what no light changes: planes (P, 4), lengths of normals (P,), edges (K, 3, 1), their owners (K,)."""

    planes: Matrix
    lengths: Matrix
    forms: Matrix
    owners: NDArray[np.intp]


@lru_cache(_CASTS_KEPT)
def _flats_of(pieces: tuple[CardPiece, ...]) -> _Flats:
    """Return what no light changes; not to be changed by anybody else either."""
    planes = np.array([piece.plane for piece in pieces])
    forms = np.array([form for piece in pieces for form in piece.limits]).reshape(-1, 3, 1)
    owners = np.repeat(np.arange(len(pieces)), [len(piece.limits) for piece in pieces])
    return _Flats(planes, np.linalg.norm(planes[:, :3], axis=1), forms, owners)


def _cast_in_space(camera: Camera, pieces: tuple[CardPiece, ...], light: Vector4) -> _SpaceCasts:
    flats, toward = _flats_of(pieces), np.asarray(light)
    planes, forms, owners = flats.planes, flats.forms, flats.owners
    facing = planes @ toward
    scale = flats.lengths * max(1.0, float(np.linalg.norm(toward[:3])))
    # Projection from the light L onto the plane π: X ↦ (π·L) X − (π·X) L; the sign makes w > 0 where L, π and X
    # lie in that order, which is the shadow-map depth test.
    front = np.where(facing > 0, 1.0, -1.0)[:, np.newaxis]
    onto = facing[:, np.newaxis, np.newaxis] * np.eye(4) - planes[:, np.newaxis, :] * toward[:, np.newaxis]
    art = camera.canvas_from_world() @ (front[..., np.newaxis] * onto)
    own = art[owners]
    limits = forms[:, 0] * own[:, 0] + forms[:, 1] * own[:, 1] + forms[:, 2] * own[:, 2]
    return _SpaceCasts(art, -front * planes, limits, owners, np.abs(facing) >= 1e-9 * scale)


def _cast_on(camera: Camera, receiver: Plane, pieces: tuple[CardPiece, ...], light: Vector4) -> list[Cast]:
    """Return the casts of pieces as :func:`cast_on` does those of one; their numbers say which they are of."""
    lift = world_from_canvas_on(camera, receiver)
    if lift is None or height_over(receiver.equation, light) <= 0:
        return []
    space = _cast_in_space(camera, pieces, light)
    is_same = coinciding(receiver.equation, _flats_of(pieces).planes)
    arts = space.art_from_world @ lift
    arts = arts / np.abs(arts).max(axis=(1, 2), keepdims=True)
    sides, limits = distance_forms(space.sides @ lift), distance_forms(space.limits @ lift)
    receiver_from_canvas, horizon = plane_coordinates(receiver) @ lift, distance_form(lift[3])
    return [
        Cast(arts[number], receiver_from_canvas, sides[number], horizon, limits[space.owners == number], number)
        for number in range(len(pieces))
        if space.casts[number] and not is_same[number]
    ]


def _sheets(casts: Sequence[tuple[CardPiece, Cast]]) -> list[int]:
    """Return for each cast the number of the first one it is joined to by neighbours that are turned as it is."""
    if len(casts) < 2:
        return [0] * len(casts)
    turns = np.linalg.det([cast.art_from_canvas for _, cast in casts]) > 0
    if turns.all() or not turns.any():
        return [0] * len(casts)
    numbers = list(range(len(casts)))
    for one, other in combinations(range(len(casts)), 2):
        if turns[one] == turns[other] and numbers[one] != numbers[other] and casts[one][0].adjoins(casts[other][0]):
            low, high = sorted((numbers[one], numbers[other]))
            numbers = [low if each == high else each for each in numbers]
    return numbers


def plane_coordinates(receiver: Plane) -> Matrix:
    """Return the (3, 4) map from the world to the receiver's own (u, v, 1)."""
    axes = np.array([receiver.u, receiver.v])
    shift = -axes @ np.asarray(receiver.origin)
    return np.vstack([np.column_stack([axes, shift]), [0.0, 0.0, 0.0, 1.0]])
