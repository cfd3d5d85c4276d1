"""The float64 reference: every ray followed in the world, sharing no formula with the renderer's homographies."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, partial
from math import radians, sin

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.light import GRAZING_DARK_DEG, GRAZING_FULL_DEG
from kagezou.geometry.vectors import Vector4
from kagezou.scene.scene import Received, ShadowCast
from tests.render.reference.rims import span_around

Array = NDArray[np.float64]

SETTLED = 0.005
"""Where few rays and what is judged differ by no more, it is left at that: so much is the noise of the rays."""


@dataclass(frozen=True)
class Art:
    """A drawing's alpha (H, W), 0 to 1, and where its first texel lies on the canvas."""

    alpha: Array
    left: int = 0
    top: int = 0

    @cached_property
    def rim(self) -> Array:
        """The alpha with a clear texel around it, (H + 2, W + 2); made once for all rays."""
        return np.pad(self.alpha, 1)

    def at(self, x: Array, y: Array) -> Array:
        """Bilinear alpha at canvas points; nothing lies beyond the drawing."""
        rim = self.rim
        px = np.clip(x - self.left + 0.5, 0.0, rim.shape[1] - 1.000001)
        py = np.clip(y - self.top + 0.5, 0.0, rim.shape[0] - 1.000001)
        i, j = px.astype(np.intp), py.astype(np.intp)
        fx, fy = px - i, py - j
        upper = rim[j, i] * (1 - fx) + rim[j, i + 1] * fx
        lower = rim[j + 1, i] * (1 - fx) + rim[j + 1, i + 1] * fx
        return np.asarray(upper * (1 - fy) + lower * fy)


def shade(cast: ShadowCast, art: Art, x: Array, y: Array) -> Array:
    """Return how much light each canvas point of the first receiver loses, 0 to 1."""
    ground = cast.receivers[0]
    eye = np.array(cast.camera.eye)
    picture = np.stack([x, y, np.zeros_like(x)], axis=-1)
    along = np.broadcast_to(-eye[:3], picture.shape) if eye[3] == 0 else picture - eye[:3]
    normal = np.array(ground.normal)
    falling = along @ normal
    height = (picture - np.array(ground.origin)) @ normal
    with np.errstate(divide="ignore", invalid="ignore"):
        s = -height / falling
        seen = np.isfinite(s) & ((s > -1) | (eye[3] == 0))
        point = picture + np.where(seen, s, 0.0)[..., np.newaxis] * along
    return np.where(seen, shade_of(cast, art, point), 0.0)


def shade_of(cast: ShadowCast, art: Art, point: Array) -> Array:
    """Return how much light world points (..., 3) of the first receiver lose, 0 to 1."""
    total = np.zeros(point.shape[:-1])
    for light in cast.lights:
        total = np.maximum(total, shade_from(cast, art, light, point) * _grazing(light, point, cast))
    return total


def shade_from(cast: ShadowCast, art: Art, light: Vector4, point: Array) -> Array:
    lamp = np.array(light)
    toward = np.broadcast_to(lamp[:3], point.shape) if lamp[3] == 0 else lamp[:3] - point
    total = np.zeros(point.shape[:-1])
    for piece in cast.card.pieces:
        # the height over the piece's plane along the ray, zero where it meets it
        start = (point - np.array(piece.place)) @ np.array(piece.normal)
        rate = toward @ np.array(piece.normal)
        with np.errstate(divide="ignore", invalid="ignore"):
            t = -start / rate
        hits = np.isfinite(t) & (t > 0) & ((t < 1) | (lamp[3] == 0))
        hit = point + np.where(hits, t, 0.0)[..., np.newaxis] * toward
        ex, ey, ez, ew = cast.camera.eye
        k = 1.0 if ew == 0 else 1 / (1 - hit[..., 2] / ez)
        hits &= np.broadcast_to(np.asarray(k) > 0, hits.shape)
        u = hit[..., 0] if ew == 0 else ex + (hit[..., 0] - ex) * k
        v = hit[..., 1] if ew == 0 else ey + (hit[..., 1] - ey) * k
        for a, b, c in piece.limits:
            hits &= a * u + b * v + c >= 0
        alpha = art.at(u[hits], v[hits])
        total[hits] = np.maximum(total[hits], alpha if cast.translucent else alpha >= 0.5)
    return total


def _grazing(light: Vector4, point: Array, cast: ShadowCast) -> Array:
    lamp = np.array(light)
    normal = np.array(cast.receivers[0].normal)
    toward = np.broadcast_to(lamp[:3], point.shape) if lamp[3] == 0 else lamp[:3] - point
    sine = (toward @ normal) / np.linalg.norm(toward, axis=-1)
    low, high = sin(radians(GRAZING_DARK_DEG)), sin(radians(GRAZING_FULL_DEG))
    t = np.clip((sine - low) / (high - low), 0, 1)
    return np.asarray(t * t * (3 - 2 * t))


def coverage(cast: ShadowCast, art: Art, hint: Array, rays: int = 160, before: Array | None = None) -> Array:
    """Return the covered part of every pixel, of the shape of ``hint`` (H, W), which is what is to be judged.

    One ray a pixel in the box that the hint covers, and one in every few beyond it, find where there is shadow;
    pixels near an edge, and those where the hint says otherwise, get ``rays`` each. Of a reference of fewer rays,
    ``before``, only what is in doubt is cast anew.
    """
    if before is not None:
        return refined(partial(shade, cast, art), hint, rays, before)
    height, width = hint.shape
    result = np.zeros_like(hint)
    rows, columns = np.nonzero(hint.any(axis=1))[0], np.nonzero(hint.any(axis=0))[0]
    top, bottom = max(rows[0] - 8, 0), min(rows[-1] + 9, height)
    left, right = max(columns[0] - 8, 0), min(columns[-1] + 9, width)
    y, x = np.mgrid[3:height:7, 3:width:7] + 0.5
    beyond = (y < top) | (y > bottom) | (x < left) | (x > right)
    assert not shade(cast, art, x[beyond], y[beyond]).any(), "there is shadow far from where it was drawn"

    y, x = np.mgrid[top:bottom, left:right].astype(np.float64)
    coarse = shade(cast, art, x + 0.5, y + 0.5)
    fine = (span_around(coarse, 1) > 1e-6) | (np.abs(coarse - hint[top:bottom, left:right]) > 1e-3)
    px, py = x[fine], y[fine]
    coarse[fine] = sum(shade(cast, art, px + dx, py + dy) for dx, dy in spread(rays)) / rays
    result[top:bottom, left:right] = coarse
    return result


def refined(shading: Callable[[Array, Array], Array], hint: Array, rays: int, before: Array) -> Array:
    """Return a reference (H, W) with ``rays`` a pixel where it is in doubt whether it or ``hint`` is right."""
    doubted = np.abs(before - hint) > SETTLED
    y, x = np.nonzero(doubted)
    result = before.copy()
    result[doubted] = sum(shading(x + dx, y + dy) for dx, dy in spread(rays)) / rays
    return result


def spread(count: int) -> Array:
    """Return points (count, 2) of the unit square spread by the plastic number: no rows for a thin edge to hide in."""
    plastic = 1.32471795724474602596
    index = np.arange(1, count + 1)[:, np.newaxis]
    return np.asarray((0.5 + index * np.array([1 / plastic, 1 / plastic**2])) % 1)


def received_at(received: Received, caster: ShadowCast, arts: tuple[Art, Art], x: Array, y: Array) -> Array:
    """Return how much light canvas points of a character's card lose to another, 0 to 1, before the card is cut.

    ``arts`` are the drawings of the character and of the other; the other's is enough here.
    """
    ex, ey, ez, ew = caster.camera.eye
    total = np.zeros_like(x)
    for piece in received.card.pieces:
        seen = np.logical_and.reduce([a * x + b * y + c >= 0 for a, b, c in piece.limits] or [x == x])
        # X(z) = p + z·r along the view ray through the canvas point p, with r = (p - e) / -ez or nothing
        rx, ry = (np.zeros_like(x), np.zeros_like(y)) if ew == 0 else ((ex - x) / ez, (ey - y) / ez)
        nx, ny, nz = piece.normal
        z = -((x - piece.place[0]) * nx + (y - piece.place[1]) * ny - piece.place[2] * nz) / (rx * nx + ry * ny + nz)
        point = np.stack([x + z * rx, y + z * ry, z], axis=-1)
        normal = np.array(piece.normal) / np.linalg.norm(piece.normal)
        toward_eye = np.array([ex, ey, ez]) - (0 if ew == 0 else point)
        normal = np.where((toward_eye @ normal)[..., np.newaxis] < 0, -normal, normal)
        for light in caster.lights:
            lamp = np.array(light)
            toward = np.broadcast_to(lamp[:3], point.shape) if lamp[3] == 0 else lamp[:3] - point
            sine = (toward * normal).sum(axis=-1) / np.linalg.norm(toward, axis=-1)
            low, high = sin(radians(GRAZING_DARK_DEG)), sin(radians(GRAZING_FULL_DEG))
            t = np.clip((sine - low) / (high - low), 0, 1)
            dark = shade_from(caster, arts[1], light, point) * (t * t * (3 - 2 * t))
            total = np.maximum(total, np.where(seen, dark, 0.0))
    return total


def received(
    found: Received,
    caster: ShadowCast,
    arts: tuple[Art, Art],
    hint: Array,
    rays: int = 160,
    before: Array | None = None,
) -> Array:
    """Return the part of every pixel of a character (H, W) that another shades, cut to the character's alpha.

    As in :func:`coverage`, pixels near an edge and those where ``hint``, what is to be judged, says otherwise get
    ``rays`` each, all others one. Of a reference of fewer rays, ``before``, only what is in doubt is cast anew.
    """
    alpha = arts[0].alpha
    if before is not None:
        shading = partial(received_at, found, caster, arts)
        return refined(lambda x, y: shading(x, y) * alpha[np.int64(y), np.int64(x)], hint, rays, before)
    height, width = alpha.shape
    y, x = np.mgrid[0:height, 0:width].astype(np.float64)
    part = received_at(found, caster, arts, x + 0.5, y + 0.5)
    fine = ((span_around(part, 1) > 1e-6) | (np.abs(part * alpha - hint) > 1e-3)) & (alpha > 0)
    px, py = x[fine], y[fine]
    part[fine] = sum(received_at(found, caster, arts, px + dx, py + dy) for dx, dy in spread(rays)) / rays
    return part * alpha
