"""PSD files as drawing programs save them, made with psd-tools."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image
from psd_tools import PSDImage
from psd_tools.constants import BlendMode

SIZE = (64, 48)


@dataclass(frozen=True)
class Leaf:
    """A layer: its pixels (h, w, 4) ``uint8`` and where they lie."""

    name: str
    pixels: NDArray[np.uint8]
    offset: tuple[int, int] = (0, 0)
    is_visible: bool = True
    opacity: int = 255
    blend: BlendMode = BlendMode.NORMAL
    is_clipped: bool = False


@dataclass(frozen=True)
class Folder:
    """A group, from its lowest layer up."""

    name: str
    children: Sequence["Leaf | Folder"]
    is_visible: bool = True
    opacity: int = 255


def block(width: int, height: int, color: tuple[int, int, int, int] = (200, 120, 40, 255)) -> NDArray[np.uint8]:
    """A plain rectangle."""
    return np.full((height, width, 4), color, np.uint8)


def figure(seed: int) -> NDArray[np.uint8]:
    """A soft-edged blot, 20 × 30 px, another one for every seed."""
    random = np.random.default_rng(seed)
    pixels = random.integers(0, 256, (30, 20, 4)).astype(np.uint8)
    pixels[8:24, 5:15, 3] = 255
    return pixels


def on_canvas(leaf: Leaf, size: tuple[int, int] = SIZE) -> NDArray[np.uint8]:
    """Return the layer's pixels as a drawing as large as the file, clear around."""
    canvas = np.zeros((size[1], size[0], 4), np.uint8)
    height, width = leaf.pixels.shape[:2]
    x, y = leaf.offset
    left, top, right, bottom = max(x, 0), max(y, 0), min(x + width, size[0]), min(y + height, size[1])
    if left < right and top < bottom:
        canvas[top:bottom, left:right] = leaf.pixels[top - y : bottom - y, left - x : right - x]
    return canvas


def write_psd(path: Path, layers: Sequence[Leaf | Folder], size: tuple[int, int] = SIZE, mode: str = "RGBA") -> Path:
    """Write a file of layers, from the lowest up."""
    image = PSDImage.new(mode, size)
    _fill(image, layers)
    path.parent.mkdir(parents=True, exist_ok=True)
    image.save(path)
    return path


def write_flat(path: Path, picture: Image.Image) -> Path:
    """Write a file without layers."""
    PSDImage.frompil(picture).save(path)
    return path


def _fill(group: Any, layers: Sequence[Leaf | Folder]) -> None:
    for each in layers:
        if isinstance(each, Folder):
            made = group.create_group(opacity=each.opacity, blend_mode=BlendMode.NORMAL)
            _fill(made, each.children)
        else:
            x, y = each.offset
            picture = Image.fromarray(each.pixels, "RGBA")
            made = group.create_pixel_layer(
                picture, name="x", top=y, left=x, opacity=each.opacity, blend_mode=each.blend
            )
            made.clipping = each.is_clipped
        # Named afterwards: only so the name is kept as Unicode.
        made.name = each.name
        made.visible = each.is_visible
