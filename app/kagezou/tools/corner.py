"""A corner of a room in two drags: the ground line, and the line on which a wall stands on that ground.

What a hand draws lies on the picture; the scene is made so that it is seen there.
"""

from collections.abc import Callable, Generator
from math import atan2, cos, degrees, hypot, radians, sin, sqrt

from kagezou.document import set_properties as lines
from kagezou.document.model import Document
from kagezou.document.properties import GROUND_POSITION, GROUND_ROLL
from kagezou.document.set_pieces import add_piece, stood_up
from kagezou.geometry.ground import place_on
from kagezou.geometry.sets.measures import PieceKind
from kagezou.geometry.sets.shapes import stand_on
from kagezou.geometry.sight import depth_of, seen
from kagezou.geometry.vectors import Point2, Vector3, dot
from kagezou.tools.drag import STEP_DEG, Drag
from kagezou.tools.frame_geometry import FrameGeometry
from kagezou.tools.ground import kept_near
from kagezou.tools.pointer import Pointer
from kagezou.tools.set_piece import before_horizon
from kagezou.tools.sight import between, moved, part_seen_at
from kagezou.tools.view import CanvasView
from kagezou.tools.wall_fitting import FigureSide, reach_on, sides_of

LEAST_VIEW_PX = 12.0
"""A shorter drag draws nothing."""

_ABOVE_FIGURE = 0.2
_LEAST_OF_FIGURE = 0.6
_MOST_OF_CANVAS = 3.0
"""A wall reaches over the figure by a part of its height, and is neither much lower than it nor endless."""

_RIM_OF_FIGURE = 0.1
"""How much of a wall is left over the highest shadow on it."""

_STEEP_DEG = 60.0

Lay = Callable[[Point2, Point2], Document]
"""Makes of the two ends of a line, canvas px, the document that has it."""


def drawing(document: Document, lay: Lay) -> Drag:
    """Return a drag, ready for the press, that draws a line; constrained in steps of 15°."""
    drag = _drawing(document, lay)
    next(drag)
    return drag


def ground_line(document: Document, frame: int) -> Lay:
    """Return what lays the ground's line; its position stays under or over where it was."""
    geometry = FrameGeometry.of(document, frame, None, CanvasView())

    def lay(start: Point2, end: Point2) -> Document:
        way = (end[0] - start[0], end[1] - start[1])
        sign = -1.0 if way[0] < 0 else 1.0
        roll = degrees(atan2(sign * way[1], sign * way[0]))
        x, y = geometry.ground.origin[:2]
        along = (cos(radians(roll)), sin(radians(roll)))
        if abs(roll) < _STEEP_DEG:
            place = (x, start[1] + (x - start[0]) * along[1] / along[0])
        else:
            part = (x - start[0]) * along[0] + (y - start[1]) * along[1]
            place = (start[0] + part * along[0], start[1] + part * along[1])
        return geometry.edited(GROUND_ROLL, roll, geometry.edited(GROUND_POSITION, kept_near(place)))

    return lay


def wall_line(document: Document, frame: int, layer_id: str | None, name: str) -> Lay:
    """Return what puts a wall on a line of the ground; the line ends before the horizon, and figures stand up.

    It is as high as it must be to be seen over the figure, and for the shadows on it over the whole cut.

    Parameters
    ----------
    document, frame
        What is looked at.
    layer_id
        The layer whose figure the wall reaches over; None for the topmost.
    name
        As for :func:`~kagezou.document.set_pieces.add_piece`, which also says what is refused.
    """
    if layer_id is None and document.layers:
        layer_id = document.layers[-1].id
    standing = stood_up(document)
    geometry, sides = FrameGeometry.of(standing, frame, layer_id, CanvasView()), sides_of(standing, frame)

    def lay(start: Point2, end: Point2) -> Document:
        end = before_horizon(geometry, kept_near(end), start)
        ends = [place_on(geometry.camera, geometry.ground, point) for point in (start, end)]
        if ends[0] is None or ends[1] is None:
            return document
        return add_piece(standing, name, PieceKind.WALL, _wall_between(geometry, sides, ends[0], ends[1]))

    return lay


def is_on_ground(document: Document, frame: int, canvas_px: Point2) -> bool:
    """Whether the ground is seen at a canvas point, so that a wall can begin there."""
    geometry = FrameGeometry.of(document, frame, None, CanvasView())
    return place_on(geometry.camera, geometry.ground, canvas_px) is not None


def _drawing(document: Document, lay: Lay) -> Generator[Document, Pointer, None]:
    start = yield document
    pointer = yield document
    while True:
        length = hypot(pointer.view_px[0] - start.view_px[0], pointer.view_px[1] - start.view_px[1])
        is_line = length >= LEAST_VIEW_PX
        pointer = yield lay(start.canvas_px, straightened(start, pointer)) if is_line else document


def straightened(start: Pointer, pointer: Pointer) -> Point2:
    """Return where a line ends, canvas px: at the hand, or if constrained in whole steps of an angle."""
    if not pointer.modifiers.constrain:
        return pointer.canvas_px
    dx, dy = (b - a for a, b in zip(start.canvas_px, pointer.canvas_px, strict=True))
    angle = radians(round(degrees(atan2(dy, dx)) / STEP_DEG) * STEP_DEG)
    part = dx * cos(angle) + dy * sin(angle)
    return (start.canvas_px[0] + part * cos(angle), start.canvas_px[1] + part * sin(angle))


def _wall_between(
    geometry: FrameGeometry, sides: tuple[FigureSide, ...], start: Vector3, end: Vector3
) -> dict[str, object]:
    """Return the properties of a wall whose foot runs between two places of the ground, its front to the viewer."""
    camera, ground, way = geometry.camera, geometry.ground, between(start, end)
    middle = moved(start, (0.5, way))
    angle = degrees(atan2(dot(way, ground.v), dot(way, ground.u)))
    if dot(stand_on(ground, middle, angle).v, camera.toward_eye((*middle, 1.0))) < 0:
        angle += 180.0 if angle <= 0 else -180.0
    width = sqrt(dot(way, way)) / depth_of(camera, middle)
    high = _height_at(geometry, middle)
    most = _MOST_OF_CANVAS * geometry.document.canvas.height_px
    reach = reach_on(sides, stand_on(ground, middle, angle), most * depth_of(camera, middle))
    if reach is not None:
        high = min(max(high, reach.top / depth_of(camera, middle) + _RIM_OF_FIGURE * geometry.figure_box.height), most)
    sizes = {lines.PIECE_WIDTH: width, lines.PIECE_HEIGHT: high}
    x, y = seen(camera, middle)
    return {
        lines.PIECE_POSITION.name: (x, y),
        lines.PIECE_ANGLE.name: angle,
        **{prop.name: min(max(size, prop.low), prop.high) for prop, size in sizes.items()},
    }


def _height_at(geometry: FrameGeometry, place: Vector3) -> float:
    """Return how high a wall must be to be seen over the figure, canvas px at its depth."""
    canvas = geometry.document.canvas
    x, y = seen(geometry.camera, place)
    figure = geometry.figure_box if geometry.layer is not None else canvas.box
    tall = figure.height * (1.0 if geometry.layer is not None else 0.5)
    top = ((figure.left + figure.right) / 2, figure.bottom - tall)
    up = (-geometry.across[0], -geometry.across[1])
    rises = (top[0] - x) * up[0] + (top[1] - y) * up[1] + _ABOVE_FIGURE * tall
    scale = depth_of(geometry.camera, place)
    aim = (x + rises * up[0], y + rises * up[1])
    nowhere: Vector3 = (0.0, 0.0, 0.0)
    height = part_seen_at(geometry.camera, place, moved(nowhere, (scale, geometry.ground.normal)), aim)
    return min(max(height or 0.0, _LEAST_OF_FIGURE * tall), _MOST_OF_CANVAS * canvas.height_px)
