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
from kagezou.io.images.oiio_guard import DecodedPicture
from kagezou.io.images.stored_pixels import TURNED, alpha_plane, assembled, box_of, full, on_canvas, upright
from kagezou.io.pixels.paper import reaching_border
from kagezou.io.pixels.signatures import is_psd
from kagezou.io.psd.file import psd_pixels, psd_tree
from kagezou.io.psd.tree import psd_header
from kagezou.message import Message
from kagezou.picture_source import OutlinedPicture, PicturePart, PictureSource, file_of

Steps = NDArray[np.uint8] | NDArray[np.uint16]
_NO_ALPHA: Final = Message("no alpha channel: pure white was taken as clear")
_NO_ALPHA_BORDER: Final = Message("no alpha channel: white that reaches the border was taken as clear")
_NO_ALPHA_NO_WHITE: Final = Message("no alpha channel and no white: the whole frame would cast a shadow")
_FILLED: Final = 0.9
"""What takes more of a picture than this is not its figure."""
_ALL_FULL: Final = Message("alpha is full everywhere: the whole frame would cast a shadow")


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
        return covers and bool((self.alpha == full(self.alpha)).all())

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
    """What the header of a picture says; the size is that of the upright canvas.

    ``notes`` say what of the file is not used and what had to be assumed, without the file's name.
    """

    width_px: int
    height_px: int
    channels: int
    has_alpha: bool
    bit_depth: int
    notes: tuple[Message, ...] = ()


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
    if header.orientation >= TURNED:
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
        In a file without alpha, whether white is clear, all of it or what reaches the border, as the source says; False
        for a background, which is opaque.

    Raises
    ------
    InputProblem
        It cannot be read as a whole; one sentence with name and cause.
    """
    rgba, has_alpha = _psd_rgba(source) if is_psd(file_of(source)) else _file_rgba(file_of(source))
    notes: tuple[Message, ...] = ()
    if not has_alpha and white_is_clear:
        notes = _clear_white(rgba, is_outlined=isinstance(source, OutlinedPicture))
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
    alpha = alpha_plane(header, stored, header.alpha)
    rgba = assembled(header, stored, alpha)
    return upright(on_canvas(rgba, header), header.orientation), alpha is not None


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
            alpha = alpha_plane(header, picture.read(header.alpha, header.alpha + 1), 0)
        else:
            alpha = alpha_plane(header, picture.read(), header.alpha)
    assert alpha is not None
    return matte_of(upright(on_canvas(alpha, header), header.orientation))


def matte_of(alpha: NDArray[Any]) -> Matte:
    """Return the matte of a drawing with ``alpha``, (H, W) ``uint8`` or ``uint16``, which is copied."""
    # One pass over pixels that lie apart; the rest is then done on those of the figure alone.
    plane = np.ascontiguousarray(alpha)
    height, width = plane.shape
    box = box_of(plane)
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


def enclosed_part(path: Path) -> float:
    """Return how much of the figure of a picture without alpha is white inside an outline, 0 to 1; 0 with alpha.

    The figure is all that is not white or does not reach the border; one that fills the picture is a frame drawn around
    it, or no figure on paper at all, and nothing is inside of it.

    Raises
    ------
    InputProblem
        As for `read_cel`.
    """
    if probe(path).has_alpha:
        return 0.0
    rgba = read_cel(path, white_is_clear=False).rgba
    white = _white_of(rgba)
    figure = white.size - int(np.count_nonzero(reaching_border(white)))
    colored = white.size - int(np.count_nonzero(white))
    return (figure - colored) / figure if 0 < figure < _FILLED * white.size else 0.0


def _white_of(rgba: NDArray[Any]) -> NDArray[np.bool_]:
    most = full(rgba)
    white: NDArray[np.bool_] = (rgba[..., 0] & rgba[..., 1] & rgba[..., 2]) == most
    return white


def _clear_white(rgba: NDArray[Any], *, is_outlined: bool) -> tuple[Message, ...]:
    """Make pure white clear in place, in (H, W, 4), all or what reaches the border; return the note about it."""
    white = _white_of(rgba)
    if is_outlined:
        white = reaching_border(white)
    rgba[..., 3][white] = 0
    if not white.any():
        return (_NO_ALPHA_NO_WHITE,)
    return (_NO_ALPHA_BORDER if is_outlined else _NO_ALPHA,)
