"""One ray at a time through the world of the definitions, in plain floats: no matrix, no homography, no plane algebra.

What shades a canvas point is found by walking: along the view ray onto the ground, from there toward the light, and
where that line meets the folded card z = f(x) one looks what the camera sees.
"""

from dataclasses import dataclass
from math import cos, inf, radians, sin, tan

Point = tuple[float, float]
Place = tuple[float, float, float]


@dataclass(frozen=True)
class World:
    """Spec 1 in numbers; ``folds`` are places (x, z) that the card goes through, or one place and its slope."""

    width: float
    height: float
    fov: float
    ground: Point
    roll: float
    declination: float

    @property
    def eye_distance(self) -> float:
        return (self.height / 2) / tan(radians(self.fov) / 2) if self.fov else inf

    @property
    def up(self) -> Place:
        r, theta = radians(self.roll), radians(self.declination)
        return (sin(r) * sin(theta), -cos(r) * sin(theta), cos(theta))

    def height_of(self, place: Place) -> float:
        x, y, z = place
        n = self.up
        return (x - self.ground[0]) * n[0] + (y - self.ground[1]) * n[1] + z * n[2]

    def along_view(self, point: Point, z: float) -> Place:
        """Return the place seen at a canvas point at depth z."""
        away = z / self.eye_distance
        return (
            point[0] + (self.width / 2 - point[0]) * away,
            point[1] + (self.height / 2 - point[1]) * away,
            z,
        )

    def on_ground(self, point: Point) -> Place | None:
        """Return the place of the ground seen at a canvas point, in front of the eye."""
        at_canvas = self.height_of(self.along_view(point, 0.0))
        per_z = self.height_of(self.along_view(point, 1.0)) - at_canvas
        if abs(per_z) < 1e-12:
            return None
        z = -at_canvas / per_z
        return self.along_view(point, z) if z < self.eye_distance else None

    def seen_at(self, place: Place) -> Point | None:
        """Return the canvas point at which a place is seen, in front of the eye."""
        x, y, z = place
        nearness = 1 - z / self.eye_distance
        if nearness <= 0:
            return None
        middle = (self.width / 2, self.height / 2)
        return (middle[0] + (x - middle[0]) / nearness, middle[1] + (y - middle[1]) / nearness)


@dataclass(frozen=True)
class Wall:
    """A piece of the card: z = z0 + slope (x − x0) for left <= x < right, world px."""

    x0: float
    z0: float
    slope: float
    left: float = -inf
    right: float = inf


def walls_through(places: list[Place]) -> list[Wall]:
    """Return the card through places from left to right; the outer pieces go on outward."""
    walls = []
    for index in range(len(places) - 1):
        (ax, _, az), (bx, _, bz) = places[index], places[index + 1]
        left = -inf if index == 0 else ax
        right = inf if index == len(places) - 2 else bx
        walls.append(Wall(ax, az, (bz - az) / (bx - ax), left, right))
    return walls


def shading_points(world: World, walls: list[Wall], light: tuple[float, float, float, float], at: Point) -> list[Point]:
    """Return the canvas points of the drawing whose alpha shades a canvas point, one for each wall that is met."""
    start = world.on_ground(at)
    if start is None:
        return []
    ahead = tuple(part - light[3] * begin for part, begin in zip(light[:3], start, strict=True))
    end = 1.0 if light[3] else inf
    met = []
    for wall in walls:
        before = start[2] - wall.z0 - wall.slope * (start[0] - wall.x0)
        rate = ahead[2] - wall.slope * ahead[0]
        if rate == 0:
            continue
        t = -before / rate
        place = (start[0] + t * ahead[0], start[1] + t * ahead[1], start[2] + t * ahead[2])
        if 0 < t < end and wall.left <= place[0] < wall.right:
            seen = world.seen_at(place)
            if seen is not None:
                met.append(seen)
    return met
