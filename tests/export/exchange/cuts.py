"""A cut with everything that a scene has to say, and pictures laid on each other as its writers mean them."""

from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kagezou.document.edits import add_layer, set_background, set_canvas
from kagezou.document.model import Cels, Document, Exposure
from kagezou.export.exchange.export import SceneMade, SceneRequest, export_scene
from kagezou.export.exchange.stack import SceneTarget
from kagezou.geometry.box import Box
from kagezou.io.images.reading import read_cel
from kagezou.io.images.writing import write_rgba
from kagezou.render.gpu.context import open_headless_context
from tests.export.small_cuts import HEIGHT, WIDTH, cut, drawings, export, with_key, with_values

NAME = "カット 12"
LENGTH = 8


def rich_cut(folder: Path, *, background: bool = True) -> Document:
    """Two figures with held drawings, shadows of two looks, keys, one hidden from frame 7; frame 101 is the first."""
    folder.mkdir(parents=True, exist_ok=True)
    document = cut(folder, 4, LENGTH, name="主役 #1")
    cels = Cels(drawings(folder / "b", 2, "b"), (Exposure(1, 0), Exposure(5, 1)))
    document = add_layer(document, "相棒", cels, Box(12, 20, 20, 40))
    if background:
        pixels = np.full((HEIGHT, WIDTH, 4), 255, np.uint8)
        pixels[..., :3] = np.random.default_rng(1).integers(0, 255, (HEIGHT, WIDTH, 3))
        write_rgba(folder / "meadow.png", pixels)
        document = set_background(document, folder / "meadow.png")
    looks = {"shadow.color": "#203040", "receives": True}
    document = with_values(document, **{f"layers.主役 #1.{name}": value for name, value in looks.items()})
    looks = {"shadow.softness": 3.0, "shadow.color": "#803010", "shadow.blend": "normal"}
    document = with_values(document, **{f"layers.相棒.{name}": value for name, value in looks.items()})
    for frame, opacity in ((1, 0.2), (6, 0.9)):
        document = with_key(document, "layers.主役 #1.shadow.opacity", frame, opacity)
    for frame, visible in ((1, True), (7, False)):
        document = with_key(document, "layers.相棒.visible", frame, visible)
    return set_canvas(document, replace(document.canvas, first_frame=101, frame_rate=Fraction(24000, 1001)))


def united_cut(folder: Path) -> Document:
    """Two figures whose shadows unite, half clear and soft, over a background."""
    document = rich_cut(folder)
    for name in ("主役 #1", "相棒"):
        looks = {"shadow.color": "#203040", "shadow.blend": "multiply", "shadow.softness": 4.0, "receives": False}
        document = with_values(document, **{f"layers.{name}.{key}": value for key, value in looks.items()})
    opacity = document.layer(document.layers[0].id).tracks["shadow.opacity"]
    layers = tuple(replace(each, tracks={**each.tracks, "shadow.opacity": opacity}) for each in document.layers)
    return replace(document, layers=layers)


def made(document: Document, folder: Path, target: SceneTarget, **wishes: Any) -> SceneMade:
    """Write a scene into ``folder``."""
    request = SceneRequest(folder, NAME, f"{NAME}{target.suffix}", target, **wishes)
    return export_scene(document, request, open_headless_context, lambda _done, _all: None, lambda: False)


def composites(document: Document, folder: Path) -> list[NDArray[np.float64]]:
    """Return every frame as the program itself composes it: straight (H, W, 4), 0 to 1."""
    export(document, folder, composite=True)
    return [pixels_of(path) for path in sorted((folder / "composite").glob("*.png"))]


def pixels_of(path: Path) -> NDArray[np.float64]:
    """Return a picture as straight (H, W, 4), 0 to 1."""
    rgba = read_cel(path, white_is_clear=False).rgba
    return np.asarray(rgba, np.float64) / np.iinfo(rgba.dtype).max


def on_white(straight: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return a straight picture over white, (H, W, 3)."""
    alpha = straight[..., 3:]
    return straight[..., :3] * alpha + 1 - alpha


def levels_apart(one: NDArray[np.float64], other: NDArray[np.float64]) -> float:
    """Return how many levels two pictures are apart at most, each rounded to 8 bit."""
    return float(np.abs(np.rint(one * 255) - np.rint(other * 255)).max())
