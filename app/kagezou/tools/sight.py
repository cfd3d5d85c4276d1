"""Ways in the world, and from a canvas point back onto a plane: what drags are worked out by."""

from math import copysign, hypot, sqrt

from kagezou.geometry.camera import Camera
from kagezou.geometry.sight import MIN_DEPTH, depth_of
from kagezou.geometry.vectors import Point2, Vector3, Vector4, dot

EDGE_ON = 0.02
"""A plane is seen edge-on when the eye is nearer to it than this part of the eye's distance from the drawing."""

REACH_PX = 1e5
"""How far from the canvas's origin a drag can carry anything, along each axis."""

_BEYOND_HORIZON_PX = 1e7


def moved(point: Vector3, *steps: tuple[float, Vector3]) -> Vector3:
    """Return a point moved by so many px along each of the directions."""
    x, y, z = point
    for amount, (dx, dy, dz) in steps:
        x, y, z = x + amount * dx, y + amount * dy, z + amount * dz
    return (x, y, z)


def between(start: Vector3, end: Vector3) -> Vector3:
    """Return the way from one point to another."""
    return (end[0] - start[0], end[1] - start[1], end[2] - start[2])


def is_edge_on(camera: Camera, point: Vector3, normal: Vector3) -> bool:
    """Whether a plane, looked at in one of its points, is so nearly edge-on that its places cannot be told apart."""
    ex, ey, distance, w = camera.eye
    if depth_of(camera, point) < MIN_DEPTH:
        return abs(normal[2]) < EDGE_ON
    to_eye = (ex - w * point[0], ey - w * point[1], distance - w * point[2])
    return abs(dot(normal, to_eye)) < EDGE_ON * distance


def place_seen_at(camera: Camera, start: Vector3, normal: Vector3, canvas_px: Point2) -> Vector3 | None:
    """Return the point, seen at ``canvas_px``, of the plane through ``start`` with a unit normal.

    Beyond the plane's horizon it is a point very far away in the plane, toward which all nearer ones tend.
    None where the plane is seen edge-on.
    """
    if is_edge_on(camera, start, normal):
        return None
    if camera.eye[3] == 0:
        return _straight(start, normal, canvas_px)
    near, true = _beside_the_eye(camera, start, normal, canvas_px), _in_perspective(camera, start, normal, canvas_px)
    # A steep plane can be seen twice; the way the start is seen goes first, so that a drag does not jump.
    first, second = (true, near) if depth_of(camera, start) >= MIN_DEPTH else (near, true)
    found = first or second
    if found is not None:
        return found
    ray = _ray(camera, canvas_px)
    along = moved(ray, (-dot(ray, normal), normal))
    length = sqrt(dot(along, along))
    return moved(start, (_BEYOND_HORIZON_PX / length, along)) if length > 0 else None


def part_seen_at(camera: Camera, base: Vector3, way: Vector3, canvas_px: Point2) -> float | None:
    """Return how many times ``way`` must be gone from ``base`` to be seen as near to a canvas point as can be.

    None where the line is seen end-on, or the place would lie beside the eye.
    """
    ex, ey, distance, w = camera.eye
    near, falls = 1.0 - w * base[2] / distance, -w * way[2] / distance
    start, toward = (base[0] - w * ex, base[1] - w * ey), (canvas_px[0] - w * ex, canvas_px[1] - w * ey)
    # A line is seen as a line: this is its direction on the canvas, whatever the part.
    dx, dy = (way[i] * near - start[i] * falls for i in (0, 1))
    if hypot(dx, dy) <= EDGE_ON * sqrt(dot(way, way)) * max(near, MIN_DEPTH):
        return None
    gain = (way[0] - toward[0] * falls) * dx + (way[1] - toward[1] * falls) * dy
    if abs(gain) < 1e-12:
        return None
    part = ((toward[0] * near - start[0]) * dx + (toward[1] * near - start[1]) * dy) / gain
    return part if near + part * falls > MIN_DEPTH else None


def within_reach(start: Vector3, end: Vector3) -> Vector3:
    """Return ``end``, or the last point on the way to it whose coordinates are within ``REACH_PX`` (or start's own)."""
    part = 1.0
    for a, b in zip(start, end, strict=True):
        bound = max(REACH_PX, abs(a))
        if abs(b) > bound:
            part = min(part, (copysign(bound, b) - a) / (b - a))
    return end if part == 1.0 else moved(start, (part, between(start, end)))


def on_plane(camera: Camera, plane: Vector4, canvas_px: Point2) -> Vector3 | None:
    """Return the point of a plane (n, d) truly seen at ``canvas_px``, or None where there is none before the eye."""
    normal = plane[:3]
    ex, ey, ez, ew = camera.eye
    ray = _ray(camera, canvas_px)
    facing = dot(normal, ray)
    begin = (ex, ey, ez) if ew else (*canvas_px, 0.0)
    if abs(facing) < 1e-9 * abs(ez):
        return None
    part = -(dot(normal, begin) + plane[3]) / facing
    return moved(begin, (part, ray)) if not ew or part >= MIN_DEPTH else None


def _ray(camera: Camera, canvas_px: Point2) -> Vector3:
    """Return the view ray's way from the eye to the drawing (orthographic: one px away from the viewer)."""
    ex, ey, distance, w = camera.eye
    return (canvas_px[0] - ex, canvas_px[1] - ey, -distance) if w else (0.0, 0.0, -1.0)


def _straight(start: Vector3, normal: Vector3, xy: Point2) -> Vector3:
    dx, dy = xy[0] - start[0], xy[1] - start[1]
    return (xy[0], xy[1], start[2] - (normal[0] * dx + normal[1] * dy) / normal[2])


def _in_perspective(camera: Camera, start: Vector3, normal: Vector3, canvas_px: Point2) -> Vector3 | None:
    return on_plane(camera, (*normal, -dot(normal, start)), canvas_px)


def _beside_the_eye(camera: Camera, start: Vector3, normal: Vector3, canvas_px: Point2) -> Vector3 | None:
    if abs(normal[2]) < EDGE_ON:
        return None
    ex, ey, _, _ = camera.eye
    xy = (ex + MIN_DEPTH * (canvas_px[0] - ex), ey + MIN_DEPTH * (canvas_px[1] - ey))
    place = _straight(start, normal, xy)
    return place if depth_of(camera, place) <= MIN_DEPTH else None
