"""Drawings as straight sRGB pixels, and the matte of them that casts the shadow.

Whatever the file holds (palette, gray, 1 to 32 bits, multiplied or straight, linear) comes out in one form: integer
files keep their numbers, floating point files become sRGB coded 16 bit.
"""

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.box import Box
from kagezou.io.images.oiio_guard import DecodedPicture, Header
from kagezou.io.pixels.colour import coded_from_light, steps_from_unit, straight_from_associated
from kagezou.io.pixels.signatures import is_psd
from kagezou.io.psd.file import psd_pixels, psd_tree
from kagezou.io.psd.tree import psd_header
from kagezou.message import Message
from kagezou.picture_source import PicturePart, PictureSource, file_of

Steps = NDArray[np.uint8] | NDArray[np.uint16]
_NO_ALPHA: Final = Message("no alpha channel: pure white was taken as clear")
_NO_ALPHA_NO_WHITE: Final = Message("no alpha channel and no white: the whole frame would cast a shadow")
_ALL_FULL: Final = Message("alpha is full everywhere: the whole frame would cast a shadow")
_TURNED: Final = 5


@dataclass(frozen=True, eq=False, slots=True, weakref_slot=True)
class Matte:
    """The alpha of a drawing. Most of a drawing is clear, so only the part with its figure is kept.

    Attributes
    ----------
    width_px, height_px
        The whole drawing.
    box
        The smallest box that holds every pixel of any alpha, px of the drawing, y down; None where there is none.
    alpha
        (box.height, box.width) ``uint8`` or ``uint16``, C-contiguous, read-only; the largest number is opaque.
    hard_edged
        Whether alpha is only 0 or full and both occur: paint data without anti-aliasing.
    """

    width_px: int
    height_px: int
    box: Box | None
    alpha: Steps
    hard_edged: bool

    @property
    def is_full(self) -> bool:
        """Whether every pixel is opaque; so it is for a drawing of no pixels."""
        covers = self.alpha.size == self.width_px * self.height_px
        return covers and bool((self.alpha == _full(self.alpha)).all())

    def whole(self) -> Steps:
        """Return the alpha of the whole drawing, (height_px, width_px)."""
        whole: Steps = np.zeros((self.height_px, self.width_px), self.alpha.dtype)
        if self.box is not None:
            whole[self.box.top : self.box.bottom, self.box.left : self.box.right] = self.alpha
        return whole

    @property
    def nbytes(self) -> int:
        """The memory it takes."""
        return self.alpha.nbytes


@dataclass(frozen=True, eq=False, slots=True, weakref_slot=True)
class Cel:
    """A whole drawing.

    Attributes
    ----------
    rgba
        (H, W, 4) ``uint8`` or ``uint16``, sRGB coded, straight, read-only; of an integer file the very numbers,
        also under alpha 0.
    matte
        Its alpha.
    notes
        What the reader had to assume, one sentence each.
    """

    rgba: Steps
    matte: Matte
    notes: tuple[Message, ...]

    @property
    def nbytes(self) -> int:
        """The memory it takes."""
        return self.rgba.nbytes + self.matte.nbytes


@dataclass(frozen=True, slots=True)
class ImageInfo:
    """What the header of a picture says; the size is that of the upright canvas."""

    width_px: int
    height_px: int
    channels: int
    has_alpha: bool
    bit_depth: int


def probe(source: PictureSource) -> ImageInfo:
    """Return the header of the picture from ``source`` without reading pixels.

    Raises
    ------
    InputProblem
        It cannot be opened.
    """
    path = file_of(source)
    if is_psd(path):
        return _probe_psd(source)
    with DecodedPicture(path, whole=False) as picture:
        header = picture.header
    width, height = header.display[2:]
    if header.orientation >= _TURNED:
        width, height = height, width
    return ImageInfo(width, height, len(header.channels), header.alpha is not None, header.bit_depth)


def _probe_psd(source: PictureSource) -> ImageInfo:
    header = psd_header(file_of(source))
    if isinstance(source, PicturePart):
        psd_tree(source.path)
    has_alpha = isinstance(source, PicturePart) or header.has_spare_channel
    return ImageInfo(header.width_px, header.height_px, header.channels, has_alpha, header.bit_depth)


def read_cel(source: PictureSource, *, white_is_clear: bool = True) -> Cel:
    """Return the drawing that comes from ``source``.

    Parameters
    ----------
    source
        A picture file, or a part of one.
    white_is_clear
        In a file without alpha, whether pure white is clear; False for a background, which is opaque.

    Raises
    ------
    InputProblem
        It cannot be read as a whole; one sentence with name and cause.
    """
    rgba, has_alpha = _psd_rgba(source) if is_psd(file_of(source)) else _file_rgba(file_of(source))
    notes: tuple[Message, ...] = ()
    if not has_alpha and white_is_clear:
        notes = _clear_white(rgba)
    matte = matte_of(rgba[..., 3])
    if has_alpha and white_is_clear and rgba.size and matte.is_full:
        notes = (_ALL_FULL,)
    rgba.setflags(write=False)
    return Cel(rgba, matte, notes)


def _psd_rgba(source: PictureSource) -> tuple[Steps, bool]:
    found = psd_pixels(source)
    return found.rgba, found.has_alpha


def _file_rgba(path: Path) -> tuple[Steps, bool]:
    """Return a file's pixels, (H, W, 4) upright, and whether their alpha is in the file."""
    with DecodedPicture(path) as picture:
        header = picture.header
        stored = picture.read()
    alpha = _alpha_plane(header, stored, header.alpha)
    rgba = _assembled(header, stored, alpha)
    return _upright(_on_canvas(rgba, header), header.orientation), alpha is not None


def read_matte(source: PictureSource) -> Matte:
    """Return the matte of the drawing from ``source``, without touching its colours where that is faster.

    Of floating point files only the alpha channel is read. Of integer files all channels are: to pick one while
    decoding takes half as long again as to pick it out of the pixels.

    Raises
    ------
    InputProblem
        As for `read_cel`.
    """
    path = file_of(source)
    if is_psd(path):
        return read_cel(source).matte
    with DecodedPicture(path) as picture:
        header = picture.header
        if header.alpha is None or not header.alpha_declared:
            return read_cel(source).matte
        if header.dtype == "float32":
            alpha = _alpha_plane(header, picture.read(header.alpha, header.alpha + 1), 0)
        else:
            alpha = _alpha_plane(header, picture.read(), header.alpha)
    assert alpha is not None
    return matte_of(_upright(_on_canvas(alpha, header), header.orientation))


def matte_of(alpha: NDArray[Any]) -> Matte:
    """Return the matte of a drawing with ``alpha``, (H, W) ``uint8`` or ``uint16``, which is copied."""
    # One pass over pixels that lie apart; the rest is then done on those of the figure alone.
    plane = np.ascontiguousarray(alpha)
    height, width = plane.shape
    box = _box_of(plane)
    if box is None:
        none: Steps = np.zeros((0, 0), plane.dtype)
        none.setflags(write=False)
        return Matte(width, height, None, none, hard_edged=False)
    kept: Steps = plane[box.top : box.bottom, box.left : box.right].copy()
    kept.setflags(write=False)
    wrapped = kept + kept.dtype.type(1)  # full becomes 0 and 0 becomes 1: nothing else may occur
    has_clear = kept.size < plane.size or int(wrapped.max()) == 1
    hard = has_clear and int(wrapped.max()) <= 1 and int(wrapped.min()) == 0
    return Matte(width, height, box, kept, hard_edged=hard)


def _box_of(alpha: NDArray[Any]) -> Box | None:
    rows = np.flatnonzero(alpha.max(axis=1, initial=0))
    if rows.size == 0:
        return None
    top, bottom = int(rows[0]), int(rows[-1]) + 1
    columns = np.flatnonzero(alpha[top:bottom].max(axis=0))
    return Box(int(columns[0]), top, int(columns[-1]) + 1, bottom)


def _full(pixels: NDArray[Any]) -> int:
    return int(np.iinfo(pixels.dtype).max)


def _alpha_plane(header: Header, stored: NDArray[Any], index: int | None) -> NDArray[Any] | None:
    """Return channel ``index`` of (H, W, C) as integer (H, W), or None where it means nothing."""
    if index is None:
        return None
    plane: NDArray[Any] = stored[..., index]
    if plane.dtype.kind == "f":
        return steps_from_unit(plane)
    if not header.alpha_declared and not plane.any() and stored.any():
        return None  # a 32-bit file whose writer left the fourth byte unused
    return plane


def _assembled(header: Header, stored: NDArray[Any], alpha: NDArray[Any] | None) -> NDArray[Any]:
    """Return the stored pixels as straight (H, W, 4); where ``alpha`` is None it is full."""
    chosen = _colour_channels(header)
    floating = stored.dtype.kind == "f"
    if not floating and header.straight and alpha is not None and (*chosen, header.alpha) == (0, 1, 2, 3):
        return np.ascontiguousarray(stored[..., :4])
    dtype = np.uint16 if floating else stored.dtype
    rgba = np.empty((*stored.shape[:2], 4), dtype)
    colour = rgba[..., :3]
    if floating:
        _put_light(header, stored, alpha, colour)
    else:
        colour[...] = stored[..., chosen] if chosen else 0
        if alpha is not None and not header.straight:
            straight_from_associated(colour, alpha)
    rgba[..., 3] = _full(rgba) if alpha is None else alpha
    return rgba


def _put_light(header: Header, stored: NDArray[Any], alpha: NDArray[Any] | None, colour: NDArray[Any]) -> None:
    """Put the linear light of ``stored`` into ``colour`` as sRGB; what was multiplied by an alpha of 0 is black."""
    chosen = _colour_channels(header)
    divided = not header.straight and header.alpha is not None and alpha is not None
    box = _box_of(alpha) if divided and alpha is not None else Box(0, 0, colour.shape[1], colour.shape[0])
    colour[...] = 0
    if box is None or not chosen:
        return
    part = stored[box.top : box.bottom, box.left : box.right]
    whole = part[..., header.alpha] if divided else None
    colour[box.top : box.bottom, box.left : box.right] = coded_from_light(part[..., chosen], whole)


def _colour_channels(header: Header) -> list[int]:
    """Return the indices of red, green and blue, one gray index, or none."""
    names = [name.rpartition(".")[2].lower() for name in header.channels]
    if {"r", "g", "b"} <= set(names):
        return [names.index("r"), names.index("g"), names.index("b")]
    others = [index for index in range(len(names)) if index != header.alpha]
    return others[:3] if len(others) >= 3 else others[:1]


def _on_canvas(pixels: NDArray[Any], header: Header) -> NDArray[Any]:
    """Return the stored pixels cut or padded with clear to the display window."""
    if header.data == header.display:
        return pixels
    left, top, width, height = header.display
    x, y = header.data[0] - left, header.data[1] - top
    canvas = np.zeros((height, width, *pixels.shape[2:]), pixels.dtype)
    x0, y0 = max(x, 0), max(y, 0)
    x1, y1 = min(x + pixels.shape[1], width), min(y + pixels.shape[0], height)
    if x0 < x1 and y0 < y1:
        canvas[y0:y1, x0:x1] = pixels[y0 - y : y1 - y, x0 - x : x1 - x]
    return canvas


def _upright(pixels: NDArray[Any], orientation: int) -> NDArray[Any]:
    """Return the pixels turned as the Exif number 1..8 tells a viewer to."""
    if orientation in {2, 3}:
        pixels = pixels[:, ::-1]
    if orientation in {3, 4}:
        pixels = pixels[::-1]
    if orientation >= _TURNED:
        pixels = pixels.swapaxes(0, 1)
        pixels = pixels[:, ::-1] if orientation in {6, 7} else pixels
        pixels = pixels[::-1] if orientation in {7, 8} else pixels
    return np.ascontiguousarray(pixels)


def _clear_white(rgba: NDArray[Any]) -> tuple[Message, ...]:
    """Make pure white clear in place, in (H, W, 4), and return the note about it."""
    full = _full(rgba)
    white = (rgba[..., 0] & rgba[..., 1] & rgba[..., 2]) == full
    rgba[..., 3][white] = 0
    return (_NO_ALPHA,) if white.any() else (_NO_ALPHA_NO_WHITE,)
