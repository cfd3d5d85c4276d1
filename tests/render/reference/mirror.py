"""The float64 reference of reflections: every ray from the eye is mirrored by the ground and followed to the card."""

import numpy as np
from numpy.typing import NDArray

from kagezou.scene.filters import Water
from kagezou.scene.scene import Reflection
from tests.render.reference.raycast import Art

Array = NDArray[np.float64]


def coverage(reflection: Reflection, art: Art, hint: Array, rays: int = 3) -> Array:
    """Return the mean alpha that each pixel mirrors, of the shape of ``hint`` (H, W), which is what is to be judged.

    ``rays`` times ``rays`` of them, in even rows: their middle must be that of the pixel, as edges are soft.
    One ray in every few px beyond the box that the hint covers makes sure that nothing is mirrored there.
    """
    height, width = hint.shape
    rows, columns = np.nonzero(hint.any(axis=1))[0], np.nonzero(hint.any(axis=0))[0]
    top, bottom = max(rows[0] - 4, 0), min(rows[-1] + 5, height)
    left, right = max(columns[0] - 4, 0), min(columns[-1] + 5, width)
    y, x = np.mgrid[3:height:9, 3:width:9] + 0.5
    beyond = (y < top) | (y > bottom) | (x < left) | (x > right)
    assert not mirrored(reflection, art, x[beyond], y[beyond]).any(), "more is mirrored far from where it was drawn"

    result = np.zeros_like(hint)
    y, x = np.mgrid[top:bottom, left:right].astype(np.float64)
    steps = (np.arange(rays) + 0.5) / rays
    found = sum(mirrored(reflection, art, x + dx, y + dy) for dx in steps for dy in steps)
    result[top:bottom, left:right] = found / rays**2
    return result


def mirrored(reflection: Reflection, art: Art, x: Array, y: Array) -> Array:
    """Return the alpha that canvas points mirror."""
    ground, eye = reflection.ground, np.array(reflection.camera.eye)
    normal, origin = np.array(ground.normal), np.array(ground.origin)
    picture = np.stack([x, y, np.zeros_like(x)], axis=-1)
    along = np.broadcast_to(-eye[:3], picture.shape) if eye[3] == 0 else picture - eye[:3]
    start = picture if eye[3] == 0 else np.broadcast_to(eye[:3], picture.shape)
    falling = along @ normal
    with np.errstate(divide="ignore", invalid="ignore"):
        way = -((start - origin) @ normal) / falling
    seen = np.isfinite(way) & (falling < 0)
    place = start + np.where(seen, way, 0.0)[..., np.newaxis] * along
    if reflection.water is not None:
        place = place + _heaved(reflection, reflection.water, place)
        # What is read is what the eye would see mirrored at the place that was moved.
        along = np.broadcast_to(-eye[:3], place.shape) if eye[3] == 0 else place - eye[:3]
    back = along - 2 * (along @ normal)[..., np.newaxis] * normal
    return np.where(seen, _met(reflection, art, place, back), 0.0)


def _met(reflection: Reflection, art: Art, place: Array, back: Array) -> Array:
    """Return the alpha of the card where rays from places of the ground meet it."""
    ex, ey, ez, ew = reflection.camera.eye
    found = np.zeros(place.shape[:-1])
    for piece in reflection.card.pieces:
        normal = np.array(piece.normal)
        with np.errstate(divide="ignore", invalid="ignore"):
            way = -((place - np.array(piece.place)) @ normal) / (back @ normal)
        hits = np.isfinite(way) & (way > 0)
        hit = place + np.where(hits, way, 0.0)[..., np.newaxis] * back
        k = np.ones(hits.shape) if ew == 0 else 1 / (1 - hit[..., 2] / ez)
        hits &= k > 0
        u, v = (hit[..., 0], hit[..., 1]) if ew == 0 else (ex + (hit[..., 0] - ex) * k, ey + (hit[..., 1] - ey) * k)
        for a, b, c in piece.limits:
            hits &= a * u + b * v + c >= 0
        found[hits] = np.maximum(found[hits], art.at(u[hits], v[hits]))
    return found


def _heaved(reflection: Reflection, water: Water, place: Array) -> Array:
    """Return how far waves move places of the ground, world px (..., 3)."""
    ground = reflection.ground
    u, v = np.array(ground.u), np.array(ground.v)
    away = place - np.array(ground.origin)
    sums = np.zeros((*place.shape[:-1], 2))
    for ripple in water.ripples:
        ku, kv = ripple.k
        psi = ku * (away @ u) + kv * (away @ v) + ripple.phase
        a00, a01, a10, a11 = ripple.wave.matrix
        along, across = np.cos(psi), np.sin(psi)
        heaved = np.stack([a00 * along + a10 * across, a01 * along + a11 * across], axis=-1)
        sums += ripple.wave.amplitude_px * heaved
    strength = np.ones(place.shape[:-1])
    if water.anchor_px > 0:
        strength = np.minimum(_from_contact(reflection, place) / water.anchor_px, 1.0)
    moved = strength[..., np.newaxis] * sums
    return np.asarray(moved[..., :1] * u + moved[..., 1:] * v)


def _from_contact(reflection: Reflection, place: Array) -> Array:
    """Return how far places of the ground are from the line along which the card stands on it."""
    card, ground = reflection.card, reflection.ground
    own = (ground.origin, np.cross(ground.normal, card.pieces[0].normal))
    start, way = own if card.contact_line is None else map(np.array, card.contact_line)
    along = way / np.linalg.norm(way)
    return np.asarray(np.abs((place - np.array(start)) @ np.cross(ground.normal, along)))
