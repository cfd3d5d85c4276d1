"""A picture of layers, as values: what every format of layered files is written from."""

from dataclasses import dataclass
from typing import Any

from numpy.typing import NDArray

from kagezou.geometry.box import Box

Pixels = NDArray[Any]


@dataclass(frozen=True, eq=False)
class PartGroup:
    """Layers, one after the other, that are laid as one: their alphas unite by maximum.

    Attributes
    ----------
    name
        What it is called, in any script.
    opacity, multiply
        As of `LayerPart`, for all of them together.
    mask
        (mask_box.height, mask_box.width) ``uint8`` or ``uint16``: which part of its layers, laid over each other in
        full, is seen, the largest number for all; where a mask is not, all is.
    mask_box
        Its place on the canvas, px, y down; None for no mask.
    """

    name: str
    opacity: float = 1.0
    multiply: bool = False
    mask: Pixels | None = None
    mask_box: Box | None = None


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
    group
        The very group that it is in, None for none.
    """

    name: str
    pixels: Pixels
    box: Box
    opacity: float = 1.0
    multiply: bool = False
    group: PartGroup | None = None


@dataclass(frozen=True, eq=False)
class LayeredImage:
    """A canvas of layers.

    Attributes
    ----------
    width_px, height_px
        The canvas.
    parts
        The layers from the bottom, those of a group together; no two have one name.
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
