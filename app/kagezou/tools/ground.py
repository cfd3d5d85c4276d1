"""The ground: its position, the end of its line that rolls it, and the lever of its declination.

The lever lies on the ground's axis toward the viewer, of one length on screen were the ground seen from straight above
it; it is drawn without perspective, so that one height of it means one declination under every camera.
"""

from math import acos, atan2, cos, degrees, hypot, inf, radians

from kagezou.document import properties
from kagezou.document.model import Document
from kagezou.geometry.sight import seen
from kagezou.geometry.vectors import Point2
from kagezou.message import Message
from kagezou.tools.drag import SNAP_VIEW_PX, Aim
from kagezou.tools.frame_geometry import FrameGeometry
from kagezou.tools.handle import Cursor, Guide, GuideKind, Handle, HandleShape
from kagezou.tools.sight import REACH_PX

POSITION = "ground.position"
END = "ground.end"
DECLINATION = "ground.declination"

LEVER_VIEW_PX = 140.0
"""Length of the declination lever on the ground."""

END_INSET_VIEW_PX = 28.0
"""How far inside the picture's edge the end of the ground line is taken hold of."""

MIN_END_VIEW_PX = 80.0
"""The least distance of that end from the ground's position."""

_OUTLINE_OF_FIGURE = 0.5


def handles(geometry: FrameGeometry) -> tuple[Handle, ...]:
    """Return the three handles of the ground."""
    layer_id = geometry.layer.id if geometry.layer else None
    lever = geometry.view.canvas_length(LEVER_VIEW_PX) * cos(radians(geometry.value(properties.GROUND_DECLINATION)))
    return (
        Handle(
            DECLINATION, HandleShape.LEVER, _off(geometry, geometry.across, lever),
            geometry.address(properties.GROUND_DECLINATION), properties.GROUND_DECLINATION.label, Cursor.VERTICAL,
            layer_id=layer_id,
        ),
        Handle(
            END, HandleShape.SQUARE, _off(geometry, geometry.along, _side(geometry) * _end_distance(geometry)),
            geometry.address(properties.GROUND_ROLL), properties.GROUND_ROLL.label, Cursor.ROTATE, layer_id=layer_id,
        ),
        Handle(
            POSITION, HandleShape.CROSS, _position(geometry), geometry.address(properties.GROUND_POSITION),
            Message("Ground"), layer_id=layer_id,
        ),
    )  # fmt: skip


def guides(geometry: FrameGeometry) -> tuple[Guide, ...]:
    """Return the ground line, a square of the ground around its position, and the lever's arm."""
    canvas = geometry.document.canvas
    reach = hypot(canvas.width_px, canvas.height_px) + hypot(*_position(geometry))
    half = _OUTLINE_OF_FIGURE * (geometry.layer.figure.height if geometry.layer else canvas.height_px / 2)
    ground = geometry.ground
    corners = tuple(
        seen(geometry.camera, ground.point(u * half, v * half)) for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1))
    )
    lever = geometry.view.canvas_length(LEVER_VIEW_PX)
    return (
        Guide(GuideKind.GROUND_OUTLINE, corners, closed=True),
        Guide(GuideKind.GROUND_LINE, (_off(geometry, geometry.along, -reach), _off(geometry, geometry.along, reach))),
        Guide(GuideKind.DECLINATION, (_position(geometry), _off(geometry, geometry.across, lever))),
    )


def move_position(geometry: FrameGeometry, _handle: Handle, aim: Aim) -> Document:
    """Move the ground; it is drawn to the height of the figure's lowest pixel."""
    x, y = aim.straightened((1.0, 0.0)).target
    if geometry.layer and aim.modifiers.snap and not aim.modifiers.constrain:
        lowest = float(geometry.layer.figure.bottom)
        if abs(y - lowest) <= geometry.view.canvas_length(SNAP_VIEW_PX):
            y = lowest
    return geometry.edited(properties.GROUND_POSITION, kept_near((x, y)))


def move_end(geometry: FrameGeometry, handle: Handle, aim: Aim) -> Document:
    """Roll the ground about its position."""
    origin = _position(geometry)
    side = 1.0 if _dot(_between(origin, handle.canvas_px), geometry.along) >= 0 else -1.0
    x, y = (side * part for part in _between(origin, aim.target))
    if hypot(x, y) < 1e-6:
        return geometry.document
    roll = degrees(atan2(y, x))
    miss = abs(y) if x > 0 else inf
    return geometry.edited(properties.GROUND_ROLL, aim.angle_or_zero(roll, miss, geometry))


def move_declination(geometry: FrameGeometry, _handle: Handle, aim: Aim) -> Document:
    """Raise or lower the lever's end: the ground is seen more from the edge or more from above."""
    down = _dot(_between(_position(geometry), aim.target), geometry.across)
    part = down / geometry.view.canvas_length(LEVER_VIEW_PX)
    return geometry.edited(properties.GROUND_DECLINATION, aim.angle(degrees(acos(min(max(part, 0.0), 1.0)))))


def kept_near(point: Point2) -> Point2:
    """Return a canvas point kept within the reach of drags."""
    x, y = (min(max(part, -REACH_PX), REACH_PX) for part in point)
    return (x, y)


def _position(geometry: FrameGeometry) -> Point2:
    return geometry.ground.origin[:2]


def _off(geometry: FrameGeometry, direction: Point2, distance: float) -> Point2:
    x, y = _position(geometry)
    return (x + distance * direction[0], y + distance * direction[1])


def _side(geometry: FrameGeometry) -> float:
    """Return which end of the line is taken hold of: the one that has more of the picture, whatever the roll."""
    return 1.0 if _position(geometry)[0] <= geometry.document.canvas.width_px / 2 else -1.0


def _end_distance(geometry: FrameGeometry) -> float:
    """Return how far along the line its end is taken hold of: shortly before it leaves the picture, canvas px."""
    canvas, side = geometry.document.canvas, _side(geometry)
    leaves = min(
        _leaves(at, side * way, size)
        for at, way, size in zip(_position(geometry), geometry.along, (canvas.width_px, canvas.height_px), strict=True)
    )
    inside = leaves - geometry.view.canvas_length(END_INSET_VIEW_PX) if leaves < inf else 0.0
    return max(inside, geometry.view.canvas_length(MIN_END_VIEW_PX))


def _leaves(at: float, way: float, size: float) -> float:
    """Return after which distance a coordinate leaves 0 to ``size``, going ``way`` for each px; inf if it does not."""
    if abs(way) < 1e-9:
        return inf
    return max(((size if way > 0 else 0.0) - at) / way, 0.0)


def _between(start: Point2, end: Point2) -> Point2:
    return (end[0] - start[0], end[1] - start[1])


def _dot(a: Point2, b: Point2) -> float:
    return a[0] * b[0] + a[1] * b[1]
