"""A picture of layers, as values: what every format of layered files is written from."""

from dataclasses import dataclass
from typing import Any

from numpy.typing import NDArray

from kagezou.geometry.box import Box

Pixels = NDArray[Any]


@dataclass(frozen=True, eq=False)
class LayerPart:
    """One layer.

    Attributes
    ----------
    name
        What it is called, in any script.
    pixels
        (box.height, box.width, 4) ``uint8`` or ``uint16``, straight sRGB.
    box
        Its place on the canvas, px, y down, inside the canvas; it may be empty.
    opacity
        0 to 1, beside the alpha of its pixels; kept by Photoshop documents alone.
    multiply
        Whether it multiplies what is under it; else it lies over it.
    """

    name: str
    pixels: Pixels
    box: Box
    opacity: float = 1.0
    multiply: bool = False


@dataclass(frozen=True, eq=False)
class LayeredImage:
    """A canvas of layers.

    Attributes
    ----------
    width_px, height_px
        The canvas.
    parts
        The layers from the bottom; no two have one name.
    merged
        (height_px, width_px, 4) ``uint8`` or ``uint16``, straight sRGB: all of them on each other, which a Photoshop
        document holds for programs that know no layers.
    depth
        Bits a channel of a Photoshop document, 8 or 16; OpenEXR has halves.
    """

    width_px: int
    height_px: int
    parts: tuple[LayerPart, ...]
    merged: Pixels | None = None
    depth: int = 8
