"""Shadow layers and composites as files: PNG, TGA, TIFF and OpenEXR.

The same picture gives the same bytes: no file holds a time or a name. PNG and TIFF are packed in memory and written by
a writer that notices a full disk; TGA and OpenEXR are read back and compared before they take their place.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from kagezou.errors import UsageProblem
from kagezou.geometry.box import Box
from kagezou.io.files.atomic import replace_by, write_bytes
from kagezou.io.files.faults import shown
from kagezou.io.pixels.colour import light_from_rgba
from kagezou.io.pixels.png import pack_layer, pack_rgba
from kagezou.io.pixels.tiff import pack_rgba as pack_tiff
from kagezou.message import Message

Pixels = NDArray[Any]
_STRAIGHT: Final = "oiio:UnassociatedAlpha"
_SETTINGS: Final[Mapping[str, Mapping[str, Any]]] = {
    ".tga": {_STRAIGHT: 1, "compression": "rle"},
    # Without a given DateTime the writer puts in the present one.
    ".exr": {"compression": "zip", "DateTime": ""},
}
_SAME: Final = {".tiff": ".tif"}
FORMATS: Final = (".png", ".tga", ".tif", ".tiff", ".exr")
"""The suffixes that can be written."""


@dataclass(frozen=True, eq=False)
class ShadowImage:
    """A full canvas whose alpha is clear outside a box, of one colour but for what ``colors`` says.

    Attributes
    ----------
    width_px, height_px
        The canvas.
    color
        Red, green and blue of every pixel, also the clear ones; sRGB 8 bit.
    alpha
        (box.height, box.width) ``uint8`` or ``uint16``, straight; it chooses the depth of the file.
    box
        Its place on the canvas, px, y down; it may be empty, and lies inside the canvas.
    colors
        (box.height, box.width, 3), sRGB in the depth of ``alpha``, where the shadow is not of one colour.
    """

    width_px: int
    height_px: int
    color: tuple[int, int, int]
    alpha: Pixels
    box: Box
    colors: Pixels | None = None

    def __post_init__(self) -> None:
        box = self.box
        if self.alpha.shape != (max(box.height, 0), max(box.width, 0)) or self.alpha.dtype not in (np.uint8, np.uint16):
            raise ValueError(f"alpha {self.alpha.shape} {self.alpha.dtype} does not fill {box}")
        outside = min(box.left, box.top) < 0 or box.right > self.width_px or box.bottom > self.height_px
        if outside and not box.is_empty:
            raise ValueError(f"{box} leaves the canvas of {self.width_px} × {self.height_px} px")

    def rgba(self) -> Pixels:
        """Return the whole canvas as straight (H, W, 4) in the depth of ``alpha``."""
        clear = np.array([*self.color, 0]) * (np.iinfo(self.alpha.dtype).max // 255)
        one: Pixels = clear.astype(self.alpha.dtype).view(f"u{4 * self.alpha.itemsize}")  # filled as one number
        pixels = np.full((self.height_px, self.width_px, 1), one).view(self.alpha.dtype)
        if not self.box.is_empty:
            part = pixels[self.box.top : self.box.bottom, self.box.left : self.box.right]
            part[..., 3] = self.alpha
            if self.colors is not None:
                part[..., :3] = self.colors
        return pixels


def encode_png(image: ShadowImage) -> bytes:
    """Return the PNG of ``image``; held frames may write the same bytes again."""
    if image.colors is not None:
        return pack_rgba(image.rgba())
    box = Box(0, 0, 0, 0) if image.box.is_empty else image.box
    alpha = np.zeros((0, 0), image.alpha.dtype) if image.box.is_empty else image.alpha
    return pack_layer((image.width_px, image.height_px), image.color, alpha, box)


def encode_rgba_png(rgba: Pixels) -> bytes:
    """Return the PNG of straight sRGB (H, W, 4) ``uint8`` or ``uint16``."""
    return pack_rgba(rgba)


def write_shadow(path: Path, image: ShadowImage) -> None:
    """Write ``image`` in the format of the suffix: PNG and TIFF in its depth, TGA 8 bit, OpenEXR premultiplied halves.

    Raises
    ------
    UsageProblem
        The suffix is none of `FORMATS`.
    DiskFullProblem, OutputProblem
        It cannot be written; what was at ``path`` is still there.
    """
    kind = _format(path)
    if kind == ".png":
        write_bytes(path, encode_png(image))
    elif kind == ".exr":
        _write_by_oiio(path, _light_of(image))
    else:
        write_rgba(path, image.rgba())


def write_rgba(path: Path, rgba: Pixels) -> None:
    """Write straight sRGB (H, W, 4) ``uint8`` or ``uint16`` in the format of the suffix, as `write_shadow` does.

    Raises
    ------
    UsageProblem, DiskFullProblem, OutputProblem
        As for `write_shadow`.
    """
    kind = _format(path)
    if kind == ".png":
        write_bytes(path, encode_rgba_png(rgba))
    elif kind == ".exr":
        _write_by_oiio(path, light_from_rgba(rgba))
    elif kind == ".tga":
        _write_by_oiio(path, _eight_bit(rgba))
    else:
        write_bytes(path, pack_tiff(rgba))


def _format(path: Path) -> str:
    suffix = path.suffix.lower()
    if suffix not in FORMATS:
        raise UsageProblem(
            Message(
                "{path}: '{path_suffix}' cannot be written, only {formats}",
                path=shown(path),
                path_suffix=path.suffix,
                formats=", ".join(FORMATS),
            )
        )
    return _SAME.get(suffix, suffix)


def _light_of(image: ShadowImage) -> NDArray[np.float16]:
    """Return the canvas as linear light multiplied by alpha, which is 0 outside the box."""
    light = np.zeros((image.height_px, image.width_px, 4), np.float16)
    if not image.box.is_empty:
        box = image.box.moved(-image.box.left, -image.box.top)
        part = replace(image, width_px=image.box.width, height_px=image.box.height, box=box)
        light[image.box.top : image.box.bottom, image.box.left : image.box.right] = light_from_rgba(part.rgba())
    return light


def _eight_bit(pixels: Pixels) -> Pixels:
    """Return ``pixels`` in the only depth that TGA has, rounded."""
    if pixels.dtype == np.uint8:
        return pixels
    return ((pixels.astype(np.uint32) + 128) // 257).astype(np.uint8)


def _write_by_oiio(path: Path, pixels: Pixels) -> None:
    from kagezou.io.images.oiio_guard import write_verified

    whole = np.ascontiguousarray(pixels)
    settings = _SETTINGS[_format(path)]
    replace_by(path, lambda temp: write_verified(temp, whole, settings, path))
