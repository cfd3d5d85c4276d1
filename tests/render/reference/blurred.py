"""The float64 reference of a simplified shadow: rays on the ground, an exact row-varying Gaussian, one exact level.

Everything happens on the receiver's own plane, in squares whose rows run along the contact line, so that the standard
deviation is one number a row and the Gaussian is exactly one product of matrices and one convolution a row.
"""

from dataclasses import dataclass
from functools import lru_cache
from math import ceil, hypot

import numpy as np

from kagezou.geometry.ground import canvas_from_plane
from kagezou.geometry.hold import Patches, slide_to_feet
from kagezou.scene.scene import ShadowCast
from tests.render.reference import raycast
from tests.render.reference.raycast import Array, Art
from tests.render.reference.rims import span_around

SQUARES_A_CHUNK = 1 << 16
MIN_SIGMA_SQUARES = 0.4
"""A sampled Gaussian narrower than this is no longer one; the contact line itself is blurred by this much."""


@dataclass(frozen=True)
class ContactLine:
    """The line where the card meets the ground: a point of it and its direction, ground (u, v) px."""

    point: tuple[float, float]
    along: tuple[float, float]

    @staticmethod
    def of(cast: ShadowCast) -> "ContactLine":
        ground = cast.receivers[0]
        origin, u, v = np.array(ground.origin), np.array(ground.u), np.array(ground.v)
        if cast.card.contact_line is not None:
            place, ahead = (np.array(each) for each in cast.card.contact_line)
            start = ((place - origin) @ u, (place - origin) @ v)
            return ContactLine.through(start, (start[0] + ahead @ u, start[1] + ahead @ v))
        if len(cast.card.pieces) > 1:
            first, last = (np.array(cast.card.contacts[end]) - origin for end in (0, -1))
            return ContactLine.through((first @ u, first @ v), (last @ u, last @ v))
        normal, offset = np.array(cast.card.pieces[0].plane[:3]), cast.card.pieces[0].plane[3]
        # n·(origin + a u + b v) + d = 0 is the line (n·u) a + (n·v) b + (n·origin + d) = 0.
        a, b, c = normal @ u, normal @ v, normal @ origin + offset
        nearest = (-a * c / (a * a + b * b), -b * c / (a * a + b * b))
        return ContactLine.through(nearest, (nearest[0] - b, nearest[1] + a))

    @staticmethod
    def through(a: tuple[float, float], b: tuple[float, float]) -> "ContactLine":
        length = hypot(b[0] - a[0], b[1] - a[1])
        return ContactLine((float(a[0]), float(a[1])), (float((b[0] - a[0]) / length), float((b[1] - a[1]) / length)))

    def from_ground(self, u: Array, v: Array) -> tuple[Array, Array]:
        """Return where ground points lie along the line and (signed) away from it, px."""
        (x, y), (c, s) = self.point, self.along
        return (u - x) * c + (v - y) * s, (v - y) * c - (u - x) * s

    def to_ground(self, along: Array, away: Array) -> tuple[Array, Array]:
        """Return (u, v) of points given along the line and away from it."""
        (x, y), (c, s) = self.point, self.along
        return x + along * c - away * s, y + along * s + away * c


@dataclass(frozen=True)
class Squares:
    """A value for each square of the ground, (rows, columns); rows run along the contact line, away from row to row."""

    line: ContactLine
    low: tuple[float, float]
    step: float
    value: Array

    @property
    def area(self) -> float:
        """The integral of the value, ground px²."""
        return float(self.value.sum()) * self.step**2

    @property
    def away(self) -> Array:
        """The signed distance of each row's centre from the contact line."""
        return np.asarray(self.low[1] + (np.arange(len(self.value)) + 0.5) * self.step)

    def pooled(self, by: int) -> "Squares":
        """Return squares larger by a whole number."""
        rows, columns = (ceil(side / by) * by for side in self.value.shape)
        whole = np.zeros((rows, columns))
        whole[: self.value.shape[0], : self.value.shape[1]] = self.value
        mean = whole.reshape(rows // by, by, columns // by, by).mean(axis=(1, 3))
        return Squares(self.line, self.low, self.step * by, mean)

    def padded(self, margin_px: float) -> "Squares":
        """Return the same with empty squares around."""
        by = ceil(margin_px / self.step)
        low = (self.low[0] - by * self.step, self.low[1] - by * self.step)
        return Squares(self.line, low, self.step, np.pad(self.value, by))

    def at(self, u: Array, v: Array) -> Array:
        """Return the value at ground points, bilinear between the centres of squares, the outermost one's beyond."""
        along, away = self.line.from_ground(u, v)
        rows, width = self.value.shape
        x = np.clip((along - self.low[0]) / self.step - 0.5, 0.0, width - 1.000001)
        y = np.clip((away - self.low[1]) / self.step - 0.5, 0.0, rows - 1.000001)
        i, j = x.astype(np.intp), y.astype(np.intp)
        fx, fy = x - i, y - j
        flat, corner = self.value.ravel(), j * width + i
        upper = flat[corner] * (1 - fx) + flat[corner + 1] * fx
        lower = flat[corner + width] * (1 - fx) + flat[corner + width + 1] * fx
        return np.asarray(upper * (1 - fy) + lower * fy)


def fallen(cast: ShadowCast, art: Art, step: float = 0.5, rays_a_side: int = 5) -> Squares:
    """Return the shadow on the whole ground, seen or not, as the covered part of every square.

    Squares near an edge get ``rays_a_side``² rays each.
    """
    line = ContactLine.of(cast)
    low, high = _reach(cast, art, line)
    columns, rows = (ceil((b - a) / step) for a, b in zip(low, high, strict=True))
    j, i = np.mgrid[0:rows, 0:columns].reshape(2, -1)
    value = _shade(cast, art, line, low[0] + (i + 0.5) * step, low[1] + (j + 0.5) * step).reshape(rows, columns)
    assert not np.concatenate([*value[[0, -1]], *value.T[[0, -1]]]).any(), "the shadow goes on beyond the squares"
    fine = span_around(value, 2) > 1e-6
    j, i = np.nonzero(fine)
    part = np.zeros(len(i))
    for dy in (np.arange(rays_a_side) + 0.5) / rays_a_side:
        for dx in (np.arange(rays_a_side) + 0.5) / rays_a_side:
            part += _shade(cast, art, line, low[0] + (i + dx) * step, low[1] + (j + dy) * step)
    value[fine] = part / rays_a_side**2
    return Squares(line, low, step, value)


def _shade(cast: ShadowCast, art: Art, line: ContactLine, along: Array, away: Array) -> Array:
    to_world = cast.receivers[0].world_from_plane()
    result = np.empty(along.shape)
    for start in range(0, len(along), SQUARES_A_CHUNK):
        chunk = slice(start, start + SQUARES_A_CHUNK)
        u, v = line.to_ground(along[chunk], away[chunk])
        result[chunk] = raycast.shade_of(cast, art, np.stack([u, v, np.ones_like(u)], axis=-1) @ to_world[:3].T)
    return result


def _reach(cast: ShadowCast, art: Art, line: ContactLine) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return a rectangle (along, away) that holds the shadow: every texel followed from the light to the ground."""
    y, x = np.nonzero(art.alpha > 0)
    seen = np.stack([x + art.left + 0.5, y + art.top + 0.5, np.zeros(len(x)), np.ones(len(x))])
    eye, ground = np.array(cast.camera.eye), np.array(cast.receivers[0].equation)
    axes = np.array([cast.receivers[0].u, cast.receivers[0].v])
    origin = np.array(cast.receivers[0].origin)[:, np.newaxis]
    low, high = np.full(2, np.inf), np.full(2, -np.inf)
    for piece in cast.card.pieces:
        card = np.array(piece.plane)
        near = [a * seen[0] + b * seen[1] + c >= -np.hypot(a, b) for a, b, c in piece.limits]
        own = seen[:, np.logical_and.reduce(near)] if near else seen
        if not own.size:
            continue
        # The view ray through a texel meets the card at (π·E) X − (π·X) E.
        solid = (card @ eye) * own - np.outer(eye, card @ own)
        solid = solid[:, np.abs(solid[3]) > 1e-9]
        solid = solid / solid[3]
        for light in cast.lights:
            lamp = np.array(light)
            height, top = ground @ solid, float(ground @ lamp)
            casts = (height > -1) & ((height < top) | (lamp[3] == 0))
            spot = top * solid[:, casts] - np.outer(lamp, height[casts])
            u, v = axes @ (spot[:3] / spot[3] - origin)
            both = np.stack(line.from_ground(u, v))
            low, high = np.minimum(low, both.min(axis=1)), np.maximum(high, both.max(axis=1))
    margin = 6.0 + 0.02 * (high - low)
    # Whole px, so that the contact line lies between two rows.
    return tuple(np.floor(low - margin)), tuple(np.ceil(high + margin))


def blurred(shadow: Squares, amount_px: float, distance_px: float) -> Squares:
    """Return the shadow blurred by a normalised Gaussian of the standard deviation at each destination (spec 3).

    Down the columns first: the standard deviation belongs to the destination's row, so the other order is wrong.
    The squares are means already, which is a twelfth of a square's variance.
    """
    margin = min(3 * amount_px, max(0.6 * shadow.area**0.5, 40.0)) + 2
    source = shadow.padded(margin)
    sigma = np.full(len(source.value), amount_px)
    if distance_px > 0:
        sigma = amount_px * np.minimum(np.abs(source.away) / distance_px, 1.0)
    sigma = np.sqrt(np.maximum((sigma / shadow.step) ** 2 - 1 / 12, MIN_SIGMA_SQUARES**2))
    index = np.arange(len(sigma), dtype=np.float64)
    down = _gaussian(index[:, np.newaxis] - index, sigma)
    return Squares(source.line, source.low, shadow.step, _along_rows(down @ source.value, sigma))


def _gaussian(offset: Array, sigma: Array) -> Array:
    """Return normalised sampled Gaussians, one a row, at offsets in squares."""
    steps = np.arange(-12, 13)
    few = np.exp(-0.5 * (steps / np.minimum(sigma, 2.0)[:, np.newaxis]) ** 2).sum(axis=1)
    total = np.where(sigma < 2, few, np.sqrt(2 * np.pi) * sigma)
    return np.asarray(np.exp(-0.5 * (offset / sigma[:, np.newaxis]) ** 2) / total[:, np.newaxis])


def _along_rows(value: Array, sigma: Array) -> Array:
    """Return each row convolved with its own Gaussian; no offset that a row can have is cut off."""
    width = value.shape[1]
    size = 1 << (2 * width - 1).bit_length()
    offset = np.minimum(np.arange(size), size - np.arange(size)).astype(np.float64)
    result = np.empty_like(value)
    for start in range(0, len(value), 64):
        rows = slice(start, start + 64)
        kernel = np.fft.rfft(_gaussian(offset, sigma[rows]), axis=1)
        result[rows] = np.fft.irfft(np.fft.rfft(value[rows], size, axis=1) * kernel, size, axis=1)[:, :width]
    return result


def level_of(field: Squares, area: float) -> float:
    """Return the level t of which area{field > t} is ``area``, by sorting."""
    falling = np.sort(field.value, axis=None)[::-1]
    level = float(np.interp(area / field.step**2, np.arange(len(falling)) + 0.5, falling))
    rim = max(field.value[[0, -1]].max(), field.value[:, [0, -1]].max())
    assert rim < level, "the shape goes on beyond the squares"
    return level


def moments_of(shadow: Squares) -> tuple[Array, Array]:
    """Return the mean (2,) and the covariance (2, 2) of a shadow, along and away from the contact line, px."""
    along = shadow.low[0] + (np.arange(shadow.value.shape[1]) + 0.5) * shadow.step
    weights = shadow.value / shadow.value.sum()
    mean = np.array([weights.sum(axis=0) @ along, weights.sum(axis=1) @ shadow.away])
    x, y = along - mean[0], shadow.away - mean[1]
    mixed = y @ weights @ x
    return mean, np.array([[weights.sum(axis=0) @ x**2, mixed], [mixed, weights.sum(axis=1) @ y**2]])


@dataclass(frozen=True)
class Shape:
    """The region in which a field exceeds a level."""

    field: Squares
    level: float

    def ground_area(self) -> float:
        """The area of the region, ground px²."""
        return float((self.field.value > self.level).sum()) * self.field.step**2

    def coverage(self, cast: ShadowCast, width: int, height: int, samples_a_side: int = 12) -> Array:
        """Return the covered part of each canvas pixel, (H, W)."""
        y, x = np.mgrid[0:height, 0:width].astype(np.float64)
        value = self._excess(cast, x + 0.5, y + 0.5)
        result = (value > 0).astype(np.float64)
        # A pixel whose neighbours all lie on its side holds no edge.
        near = span_around(result, 1) > 0
        px, py = x[near], y[near]
        part = np.zeros(len(px))
        for dy in (np.arange(samples_a_side) + 0.5) / samples_a_side:
            for dx in (np.arange(samples_a_side) + 0.5) / samples_a_side:
                part += self._excess(cast, px + dx, py + dy) > 0
        result[near] = part / samples_a_side**2
        return result

    def _excess(self, cast: ShadowCast, x: Array, y: Array) -> Array:
        u, v, w = _plane_at(cast, x, y)
        return np.where(w < np.inf, self.field.at(u, v) - self.level, -1.0)


def ground_seen_at(cast: ShadowCast, x: Array, y: Array) -> tuple[Array, Array, Array]:
    """Return the ground (u, v) seen at canvas points, and the ground px² a canvas px² there shows; 0 for none."""
    u, v, w = _plane_at(cast, x, y)
    return u, v, abs(float(np.linalg.det(_plane_from_canvas(cast)))) / w**3


@lru_cache(maxsize=8)
def area_seen(cast: ShadowCast, height: int, width: int) -> Array:
    """Return the ground px² that each canvas pixel shows, (H, W): many filters are held against one cast."""
    y, x = np.mgrid[0:height, 0:width] + 0.5
    area = ground_seen_at(cast, x, y)[2]
    area.flags.writeable = False
    return area


def _plane_at(cast: ShadowCast, x: Array, y: Array) -> tuple[Array, Array, Array]:
    """Return the ground (u, v) seen at canvas points, and the third coordinate of both; infinite where none is."""
    a, b, c = _plane_from_canvas(cast)
    w = c[0] * x + c[1] * y + c[2]
    w = np.where(w > 1e-9, w, np.inf)
    return (a[0] * x + a[1] * y + a[2]) / w, (b[0] * x + b[1] * y + b[2]) / w, w


def _plane_from_canvas(cast: ShadowCast) -> Array:
    return np.asarray(np.linalg.inv(canvas_from_plane(cast.camera, cast.receivers[0])), np.float64)


def simplified(shadow: Squares, amount_px: float, distance_px: float) -> Shape:
    """Return the simplified shape of a shadow on the ground."""
    # Blurs this wide lose nothing on squares twice as large; near the contact line they soon are as wide.
    enough = 10.0 if distance_px == 0 else 40.0
    field = blurred(shadow.pooled(2) if amount_px >= enough else shadow, amount_px, distance_px)
    return Shape(field, level_of(field, shadow.area))


def held(shadow: Squares, shape: Shape, hold: float) -> tuple[Shape, tuple[float, float]]:
    """Return a shape slid to the feet, and from how much farther it is read, px along the contact line and away."""
    field = shape.field
    left = Squares(field.line, field.low, field.step, np.minimum(_laid_on(field, shadow), field.value > shape.level))
    whole = Squares(field.line, field.low, field.step, (field.value > shape.level).astype(np.float64))
    slide = slide_to_feet(_patches(shadow), _patches(whole), _patches(left), hold)
    low = (field.low[0] - slide[0], field.low[1] - slide[1])
    return Shape(Squares(field.line, low, field.step, field.value), shape.level), slide


def _laid_on(field: Squares, shadow: Squares) -> Array:
    """Return a shadow on the squares of a field, which are as large or twice as large and have the same corners."""
    shadow = shadow.pooled(round(field.step / shadow.step))
    column, row = (round((a - b) / field.step) for a, b in zip(shadow.low, field.low, strict=True))
    result = np.zeros_like(field.value)
    result[row : row + shadow.value.shape[0], column : column + shadow.value.shape[1]] = shadow.value
    return result


def _patches(squares: Squares) -> Patches:
    rows, columns = np.nonzero(squares.value > 0)
    along: Array = squares.low[0] + np.asarray(columns + 0.5, np.float64) * squares.step
    return Patches(along, squares.away[rows], squares.value[rows, columns] * squares.step**2)
