"""The meadow in the morning: a painted background whose ground has room for a shadow to lie on."""

from functools import reduce

import numpy as np
from numpy.typing import NDArray

from kagezou.cli.demo.shapes import Color, DrawnShape, Grid, PaperSheet, circle, cone, ellipse

HORIZON = 0.50
"""Where the meadow begins, as a part of the picture's height."""

_SKY_TOP: Color = (150, 203, 226)
_SKY_LOW: Color = (250, 236, 212)
_CLOUD: Color = (255, 252, 244)
_FAR_HILL: Color = (176, 205, 196)
_NEAR_HILL: Color = (150, 192, 158)
_MEADOW_FAR: Color = (188, 208, 140)
_MEADOW_NEAR: Color = (150, 186, 108)
_PATH: Color = (238, 222, 184)
_BLADE: Color = (122, 164, 92)
_PETALS: tuple[Color, ...] = ((255, 250, 240), (250, 214, 120), (240, 170, 170))
_SEED = 20


def painted(width_px: int, height_px: int) -> NDArray[np.uint8]:
    """Return the background, opaque (H, W, 4); the same for the same size."""
    x = np.linspace(0.0, 1.0, width_px, dtype=np.float32)[None, :]
    y = np.linspace(0.0, 1.0, height_px, dtype=np.float32)[:, None]
    pixel = np.float32(1.0 / height_px)
    picture = _mixed(_SKY_TOP, _SKY_LOW, np.clip(y / HORIZON, 0, 1) ** 1.3 + 0 * x)
    glow = np.exp(-(((x - 0.80) / 0.26) ** 2 + ((y - 0.20) / 0.22) ** 2)).astype(np.float32)
    picture = _laid(picture, (255, 244, 214), np.float32(0.75) * glow)
    picture = _laid(picture, _FAR_HILL, _below(y, HORIZON - 0.085 + _hills(x, 2.3, 0.6, 0.035), pixel))
    picture = _laid(picture, _NEAR_HILL, _below(y, HORIZON - 0.03 + _hills(x, 3.1, 2.0, 0.022), pixel))
    edge = HORIZON + _hills(x, 1.7, 0.2, 0.006)
    depth = np.clip((y - HORIZON) / (1 - HORIZON), 0, 1)
    mottle = 0.10 * _mottle(x, y)
    meadow = _mixed(_MEADOW_FAR, _MEADOW_NEAR, np.clip(depth**0.8 + mottle, 0, 1))
    inside = _below(y, edge, pixel)[..., None]
    picture = picture * (1 - inside) + meadow * inside
    picture = _laid(picture, _PATH, _path(x, y) * (0.9 + 0.5 * mottle))
    return _with_details(picture)


def _mixed(first: Color, second: Color, part: Grid) -> Grid:
    """Return colours between two, (H, W, 3), 0 to 255."""
    a, b = np.asarray(first, np.float32), np.asarray(second, np.float32)
    return np.asarray(a + (b - a) * part[..., None], np.float32)


def _laid(under: Grid, color: Color, cover: Grid) -> Grid:
    return np.asarray(under + (np.asarray(color, np.float32) - under) * cover[..., None], np.float32)


def _below(y: Grid, edge: Grid, pixel: np.float32) -> Grid:
    """Return how far each pixel lies under an edge over x, anti-aliased."""
    return np.asarray(np.clip((y - edge) / pixel + 0.5, 0.0, 1.0), np.float32)


def _hills(x: Grid, waves: float, phase: float, height: float) -> Grid:
    round_ = np.sin(x * np.float32(waves * np.pi) + phase) + 0.4 * np.sin(x * np.float32(waves * 7.1) + 2.3 * phase)
    return np.asarray(-height * round_, np.float32)


def _mottle(x: Grid, y: Grid) -> Grid:
    """Return soft patches, about −1 to 1, flattened as if lying on the ground."""
    patches = np.sin(9 * x + 31 * y) * np.sin(17 * x - 23 * y + 1.0) + 0.6 * np.sin(29 * x + 67 * y + 2.0)
    return np.asarray(patches / 1.6, np.float32)


def _path(x: Grid, y: Grid) -> Grid:
    """Return the strip the child walks on, soft at its borders."""
    middle = 0.845 + 0.012 * np.sin(x * 5.0 + 0.6)
    return np.asarray(np.clip((0.075 - np.abs(y - middle)) / 0.005, 0.0, 1.0), np.float32)


def _with_details(picture: Grid) -> NDArray[np.uint8]:
    """Return the picture with clouds, grass and flowers, opaque (H, W, 4)."""
    height, width = picture.shape[:2]
    sheet = PaperSheet(width, height)
    unit = height / 1000
    for left, top, size in ((150, 120, 1.0), (560, 66, 0.7), (760, 330, 0.55)):
        puffs = [
            ellipse(
                ((left + dx * size) * width / 1000, (top + dy * size) * unit),
                radius * size * unit * 1.2,
                radius * size * unit * 0.8,
            )
            for dx, dy, radius in ((0, 0, 36), (44, -18, 46), (96, -4, 38), (138, 8, 26))
        ]
        sheet.paint(reduce(DrawnShape.__or__, puffs), _CLOUD, 0.9)
    random = np.random.default_rng(_SEED)
    for _ in range(260):
        across, deep = random.random(), random.random() ** 0.7
        root = (across * width, (HORIZON + 0.02 + 0.48 * deep) * height)
        tall = (5 + 13 * deep) * unit
        if 0.755 < root[1] / height < 0.935:
            continue
        for bend in (-0.5, 0.05, 0.6):
            sheet.paint(cone(root, (root[0] + bend * tall, root[1] - tall), 1.5 * unit, 0.5 * unit), _BLADE, 0.75)
        if random.random() < 0.22:
            petal = _PETALS[int(random.integers(len(_PETALS)))]
            sheet.paint(circle((root[0], root[1] - tall), (1.6 + 2.4 * deep) * unit), petal)
    details = sheet.pixels()
    cover = details[..., 3:].astype(np.float32) / 255
    colors = picture * (1 - cover) + details[..., :3] * cover
    opaque = np.full((height, width, 4), 255, np.uint8)
    opaque[..., :3] = np.clip(colors + 0.5, 0, 255)
    return opaque
