"""A set piece on the ground: where it stands, the arm out of its front that turns it, and a wall's lean.

The lean is set on a small picture of the wall seen from its side, beside its foot: seen from the front, a wall that
leans back and one that leans over can look alike.
"""

from math import atan2, cos, degrees, hypot, radians, sin

from kagezou.document import set_properties as lines
from kagezou.document.model import Document
from kagezou.document.piece_kinds import matters
from kagezou.geometry.ground import place_on, world_from_canvas_on
from kagezou.geometry.sight import seen
from kagezou.geometry.vectors import Point2, Vector3, dot
from kagezou.message import Message
from kagezou.scene.piece_frames import PieceFrame
from kagezou.tools.drag import SNAP_VIEW_PX, Aim
from kagezou.tools.frame_geometry import FrameGeometry
from kagezou.tools.ground import kept_near
from kagezou.tools.handle import Cursor, Guide, GuideKind, Handle, HandleShape
from kagezou.tools.sight import between, moved, place_seen_at
from kagezou.tools.sun import unwound

POSITION = "piece.position"
TURN = "piece.turn"
LEAN = "piece.lean"

ARM_VIEW_PX = 56.0
"""How far before the piece's front it is turned by, were the ground seen from straight above."""

LEAN_ARM_VIEW_PX = 46.0
LEAN_AWAY_VIEW_PX = 30.0
"""How far beside the wall's foot its side view stands."""

_LEAST_ARM_VIEW_PX = 20.0
_MOST_STRETCHED = 5.0
"""On a ground seen nearly edge-on the arm is stretched toward that length, up to so many times."""

_TURN_PER_VIEW_PX = 0.5
_LEAST_DEPTH = 0.02
"""The least part of its depth by which a drag leaves a piece before the horizon."""

_ARC_POINTS = 17


def handles(geometry: FrameGeometry) -> tuple[Handle, ...]:
    """Return what moves, turns and leans the piece worked on."""
    piece = geometry.piece
    if piece is None:
        return ()
    made: list[Handle] = []
    if matters(lines.PIECE_LEAN, piece.measures.kind):
        made.append(
            Handle(
                LEAN, HandleShape.LEVER, _lean_end(geometry, piece, piece.measures.lean_deg),
                geometry.address(lines.PIECE_LEAN), lines.PIECE_LEAN.label, Cursor.HORIZONTAL, piece_id=piece.id,
            )
        )  # fmt: skip
    if matters(lines.PIECE_ANGLE, piece.measures.kind):
        made.append(
            Handle(
                TURN, HandleShape.LEVER, seen(geometry.camera, _front(geometry, piece)),
                geometry.address(lines.PIECE_ANGLE), lines.PIECE_ANGLE.label, Cursor.ROTATE,
                piece_id=piece.id,
            )
        )  # fmt: skip
    made.append(
        Handle(
            POSITION, HandleShape.PEG, seen(geometry.camera, piece.stand.origin),
            geometry.address(lines.PIECE_POSITION), Message("Set piece"), piece_id=piece.id, stays_in_view=True,
        )
    )  # fmt: skip
    return tuple(made)


def guides(geometry: FrameGeometry) -> tuple[Guide, ...]:
    """Return the arms of the piece worked on."""
    piece = geometry.piece
    if piece is None or not matters(lines.PIECE_ANGLE, piece.measures.kind):
        return ()
    ends = (piece.stand.origin, _front(geometry, piece))
    made = [Guide(GuideKind.PIECE_ARM, tuple(seen(geometry.camera, end) for end in ends))]
    if matters(lines.PIECE_LEAN, piece.measures.kind):
        low, high = lines.PIECE_LEAN.low, lines.PIECE_LEAN.high
        arc = (low + (high - low) * step / (_ARC_POINTS - 1) for step in range(_ARC_POINTS))
        made.append(Guide(GuideKind.LEAN_ARC, tuple(_lean_end(geometry, piece, angle) for angle in arc)))
        arm = (_lean_pivot(geometry, piece), _lean_end(geometry, piece, piece.measures.lean_deg))
        made.append(Guide(GuideKind.LEAN_ARM, arm))
    return tuple(made)


def move_position(geometry: FrameGeometry, _handle: Handle, aim: Aim) -> Document:
    """Move a piece over the ground, never beyond its horizon; it is drawn to the ground line."""
    if geometry.piece is None:
        return geometry.document
    x, y = aim.straightened(geometry.along).target
    if aim.modifiers.snap and not aim.modifiers.constrain:
        x, y = _drawn_to_line(geometry, (x, y))
    return geometry.edited(lines.PIECE_POSITION, before_horizon(geometry, kept_near((x, y))))


def move_turn(geometry: FrameGeometry, _handle: Handle, aim: Aim) -> Document:
    """Turn a piece so that its front looks at the hand; its sides are drawn to the ground line."""
    piece = geometry.piece
    if piece is None:
        return geometry.document
    ground, stand = geometry.ground, piece.stand
    place = place_seen_at(geometry.camera, _front(geometry, piece), ground.normal, aim.target)
    if place is None:
        right = aim.offset[0] * geometry.along[0] + aim.offset[1] * geometry.along[1]
        turned = piece.angle_deg - _TURN_PER_VIEW_PX * right * geometry.view.zoom
        return geometry.edited(lines.PIECE_ANGLE, aim.angle(turned))
    way = between(stand.origin, place)
    right, nearer = dot(way, ground.u), dot(way, ground.v)
    if hypot(right, nearer) < 1e-6:
        return geometry.document
    shown = geometry.value(lines.PIECE_ANGLE, aim.shown)
    angle = unwound(degrees(atan2(-right, nearer)), shown, lines.PIECE_ANGLE)
    square = 90.0 * round(angle / 90)
    reach, turn = hypot(right, nearer), radians(square)
    there = moved(stand.origin, (-reach * sin(turn), ground.u), (reach * cos(turn), ground.v))
    x, y = seen(geometry.camera, there)
    is_near = hypot(x - aim.target[0], y - aim.target[1]) <= geometry.view.canvas_length(SNAP_VIEW_PX)
    snaps = is_near and aim.modifiers.snap and not aim.modifiers.constrain
    return geometry.edited(lines.PIECE_ANGLE, square if snaps else aim.angle(angle))


def move_lean(geometry: FrameGeometry, _handle: Handle, aim: Aim) -> Document:
    """Lean a wall as its side view is leant: to the right is back."""
    if geometry.piece is None:
        return geometry.document
    pivot, along, across = _lean_pivot(geometry, geometry.piece), geometry.along, geometry.across
    x, y = aim.target[0] - pivot[0], aim.target[1] - pivot[1]
    back, up = x * along[0] + y * along[1], -(x * across[0] + y * across[1])
    if hypot(back, up) < 1e-6:
        return geometry.document
    miss = abs(back) if up > 0 else hypot(back, up)
    return geometry.edited(lines.PIECE_LEAN, aim.angle_or_zero(degrees(atan2(back, up)), miss, geometry))


def before_horizon(geometry: FrameGeometry, wanted: Point2, start: Point2 | None = None) -> Point2:
    """Return a canvas point of the ground: the wanted one, or the last on the way to it before the horizon.

    Parameters
    ----------
    geometry
        Whose ground it is.
    wanted
        Canvas px.
    start
        Where the way begins, on the ground; without it where the piece worked on stands.
    """
    lift = world_from_canvas_on(geometry.camera, geometry.ground)
    if start is None:
        start = seen(geometry.camera, geometry.piece.stand.origin) if geometry.piece else wanted
    if lift is None or place_on(geometry.camera, geometry.ground, start) is None:
        return wanted
    near, far = (float(lift[3] @ (*point, 1.0)) for point in (start, wanted))
    least = _LEAST_DEPTH * near
    if far >= least:
        return wanted
    part = (near - least) / (near - far)
    return (start[0] + part * (wanted[0] - start[0]), start[1] + part * (wanted[1] - start[1]))


def _drawn_to_line(geometry: FrameGeometry, target: Point2) -> Point2:
    """Return the target, on the ground line if it is that near."""
    gx, gy = geometry.ground.origin[:2]
    across = geometry.across
    off = (target[0] - gx) * across[0] + (target[1] - gy) * across[1]
    if abs(off) > geometry.view.canvas_length(SNAP_VIEW_PX):
        return target
    return (target[0] - off * across[0], target[1] - off * across[1])


def _front(geometry: FrameGeometry, piece: PieceFrame) -> Vector3:
    """Return the end of the arm out of a piece's front, on the ground."""
    stand, camera = piece.stand, geometry.camera
    depth = piece.measures.depth_px / 2 if matters(lines.PIECE_DEPTH, piece.measures.kind) else 0.0
    arm = geometry.view.canvas_length(ARM_VIEW_PX) * piece.scale
    start, end = (seen(camera, moved(stand.origin, (way, stand.v))) for way in (depth, depth + arm))
    length = max(hypot(end[0] - start[0], end[1] - start[1]), 1e-6)
    stretched = geometry.view.canvas_length(_LEAST_ARM_VIEW_PX) / length
    return moved(stand.origin, (depth + arm * min(max(stretched, 1.0), _MOST_STRETCHED), stand.v))


def _lean_pivot(geometry: FrameGeometry, piece: PieceFrame) -> Point2:
    """Return where the side view of a wall stands: beside its right foot, kept within the picture."""
    stand, canvas_length = piece.stand, geometry.view.canvas_length
    sides = (moved(stand.origin, (side * piece.measures.width_px / 2, stand.u)) for side in (-1, 1))
    foot = max((seen(geometry.camera, end) for end in sides), key=lambda end: end[0])
    away, room, canvas = canvas_length(LEAN_AWAY_VIEW_PX), canvas_length(LEAN_ARM_VIEW_PX), geometry.document.canvas
    x, y = foot[0] + away * geometry.along[0], foot[1] + away * geometry.along[1]
    return (
        min(max(x, room / 2), max(canvas.width_px - room / 2, room / 2)),
        min(max(y, room * 1.3), max(float(canvas.height_px), room * 1.3)),
    )


def _lean_end(geometry: FrameGeometry, piece: PieceFrame, lean_deg: float) -> Point2:
    (x, y), along, across = _lean_pivot(geometry, piece), geometry.along, geometry.across
    arm, lean = geometry.view.canvas_length(LEAN_ARM_VIEW_PX), radians(lean_deg)
    back, up = arm * sin(lean), arm * cos(lean)
    return (x + back * along[0] - up * across[0], y + back * along[1] - up * across[1])
