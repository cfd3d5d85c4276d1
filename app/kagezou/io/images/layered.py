"""One frame as one file of layers: a Photoshop document or an OpenEXR file of several parts.

The same frame gives the same bytes. Both are read back before they take their place.
"""

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from kagezou.errors import UsageProblem
from kagezou.geometry.box import Box
from kagezou.io.files.atomic import replace_by, write_bytes
from kagezou.io.files.faults import output_problem, shown
from kagezou.io.images.oiio_parts import ExrPart, write_parts_verified
from kagezou.io.pixels.colour import light_from_rgba

Pixels = NDArray[Any]
LAYERED_FORMATS: Final = (".exr", ".psd")
"""The suffixes of files of layers."""


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


def write_layered(path: Path, image: LayeredImage) -> None:
    """Write ``image`` in the format of the suffix: PSD in its depth, OpenEXR as premultiplied halves.

    Raises
    ------
    UsageProblem
        The suffix is none of `LAYERED_FORMATS`.
    DiskFullProblem, OutputProblem
        It cannot be written; what was at ``path`` is still there.
    """
    match path.suffix.lower():
        case ".exr":
            size_px = (image.width_px, image.height_px)
            parts = [_exr_part(part) for part in image.parts]
            replace_by(path, lambda temp: write_parts_verified(temp, size_px, parts, path))
        case ".psd":
            from kagezou.io.psd.writing import packed_psd

            try:
                data = packed_psd(image)
            except ValueError as error:
                raise output_problem(path, str(error)) from error
            write_bytes(path, data)
        case _:
            raise UsageProblem(f"{shown(path)}: layers are written as {' or '.join(LAYERED_FORMATS)}")


def _exr_part(part: LayerPart) -> ExrPart:
    """Return a part as linear light; OpenEXR has no empty part, so that one clear pixel stands for it."""
    blend = "multiply" if part.multiply else "normal"
    if part.box.is_empty:
        return ExrPart(part.name, (0, 0), np.zeros((1, 1, 4), np.float16), blend)
    return ExrPart(part.name, (part.box.left, part.box.top), light_from_rgba(part.pixels), blend)
