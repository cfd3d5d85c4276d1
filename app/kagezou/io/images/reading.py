"""Drawings as straight sRGB pixels, and the matte of them that casts the shadow.

Whatever the file holds (palette, gray, 1 to 32 bits, multiplied or straight, linear) comes out in one form: integer
files keep their numbers, floating point files become sRGB coded 16 bit.
"""

from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.box import Box
from kagezou.io.images.opening import opened
from kagezou.io.images.stored_pixels import (
    TURNED,
    alpha_of,
    assembled,
    box_of,
    full,
    glowing,
    on_canvas,
    put_glow,
    upright,
)
from kagezou.io.images.white_paper import clear_white
from kagezou.io.pixels.colour import steps_from_unit
from kagezou.io.pixels.completeness import check_end
from kagezou.io.pixels.jpeg_segments import notes_on_jpeg
from kagezou.io.pixels.signatures import is_psd
from kagezou.message import Message
from kagezou.picture_source import OutlinedPicture, Paper, PicturePart, PictureSource, file_of

Steps = NDArray[np.uint8] | NDArray[np.uint16]
ALPHA_IS_ZERO: Final = Message("its alpha is 0 everywhere; its colours are seen as if there were none")
FOURTH_IS_ZERO: Final = Message("what could be its alpha is 0 everywhere and was taken as unused")
GLOW_IS_SEEN: Final = Message("it has light where its alpha is 0; that is seen as a glow over what is behind it")
GLOW_IS_NOT_USED: Final = Message("it has light where its alpha is 0, as a glow has; that is not used")
_ROWS: Final = 256
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

    ``pictures`` is how many the file has, each of which may be a drawing. ``is_doubtful`` says that only the pixels
    tell whether there is an alpha, or light where it is 0. ``notes`` say what of the file is not used and what had to
    be assumed, without the file's name.
    """

    width_px: int
    height_px: int
    channels: int
    has_alpha: bool
    bit_depth: int
    notes: tuple[Message, ...] = ()
    pictures: int = 1
    is_doubtful: bool = False


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
    with opened(source, whole=False) as picture:
        header, pictures = picture.header, picture.pictures()
    check_end(path)
    width, height = header.display[2:]
    if header.orientation >= TURNED:
        width, height = height, width
    notes = (*header.notes, *notes_on_jpeg(path))
    if pictures > 1 and not isinstance(source, PicturePart):
        notes = (*notes, Message("of its {count} pictures the first alone is used", count=pictures))
    return ImageInfo(
        width,
        height,
        header.channels,
        header.alpha is not None,
        header.bit_depth,
        notes,
        pictures,
        is_doubtful=header.alpha is not None and not (header.straight and header.alpha_declared),
    )


def _probe_psd(source: PictureSource) -> ImageInfo:
    from kagezou.io.psd.file import psd_tree
    from kagezou.io.psd.tree import psd_header

    header = psd_header(file_of(source))
    if isinstance(source, PicturePart):
        psd_tree(source.path)
    with_alpha = isinstance(source, PicturePart) or header.has_spare_channel
    return ImageInfo(header.width_px, header.height_px, header.channels, with_alpha, header.bit_depth)


def has_alpha(source: PictureSource) -> bool:
    """Return whether a picture has an alpha that means something, for which its pixels are read where need be.

    Raises
    ------
    InputProblem
        As for `read_cel`.
    """
    info = probe(source)
    if info.has_alpha and info.is_doubtful:
        return FOURTH_IS_ZERO not in read_cel(source, white_is_clear=False).notes
    return info.has_alpha


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
    notes: tuple[Message, ...] = ()
    if is_psd(file_of(source)):
        from kagezou.io.psd.file import psd_pixels

        found = psd_pixels(source)
        rgba, with_alpha = found.rgba, found.has_alpha
    else:
        rgba, with_alpha, notes = _file_rgba(source, is_background=not white_is_clear)
    if not with_alpha and white_is_clear:
        notes = (*notes, *clear_white(rgba, is_outlined=_is_outlined(source)))
    matte = matte_of(rgba[..., 3])
    if with_alpha and white_is_clear and rgba.size and matte.is_full:
        notes = (*notes, _ALL_FULL)
    rgba.setflags(write=False)
    return Cel(rgba, matte, notes)


def _is_outlined(source: PictureSource) -> bool:
    return isinstance(source, OutlinedPicture) or (isinstance(source, PicturePart) and source.paper is Paper.BORDER)


def _file_rgba(source: PictureSource, *, is_background: bool) -> tuple[Steps, bool, tuple[Message, ...]]:
    """Return a picture's pixels, (H, W, 4) upright, whether their alpha is in the file, and what is said of them."""
    with opened(source) as picture:
        header = picture.header
        used = picture.used()
    count = len(header.colour)
    colour = used[..., :count]
    alpha = None if header.alpha is None else alpha_of(header, used[..., count], colour)
    notes: tuple[Message, ...] = ()
    if alpha is None and header.alpha is not None:
        notes = (FOURTH_IS_ZERO,)
    if is_background and alpha is not None and not alpha.any() and colour.any():
        alpha, notes = None, (ALPHA_IS_ZERO,)
    glow = None if alpha is None else glowing(header, used)
    rgba = assembled(header, used, alpha)
    if glow is not None:
        notes = (
            *notes,
            GLOW_IS_SEEN if is_background else GLOW_IS_NOT_USED,
        )
        if is_background:
            put_glow(header, used, glow, rgba)
    del used, colour
    return upright(on_canvas(rgba, header), header.orientation), alpha is not None, notes


def read_matte(source: PictureSource) -> Matte:
    """Return the matte of the drawing from ``source``, without touching its colours where that is faster.

    Of floating point files only the alpha channel is read. Of integer files all channels are: to pick one while
    decoding takes half as long again as to pick it out of the pixels.

    Raises
    ------
    InputProblem
        As for `read_cel`.
    """
    if is_psd(file_of(source)):
        return read_cel(source).matte
    with opened(source) as picture:
        header = picture.header
        if header.alpha is None or not header.alpha_declared:
            alpha = None
        else:
            stored = picture.alpha()
            alpha = steps_from_unit(stored) if stored.dtype.kind == "f" else stored
    if alpha is None:
        return read_cel(source).matte
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
    kept: Steps = plane[box.top : box.bottom, box.left : box.right]
    if plane is alpha or kept.size < plane.size:
        kept = kept.copy()
    kept.setflags(write=False)
    has_clear = kept.size < plane.size or not kept.all()
    return Matte(width, height, box, kept, hard_edged=has_clear and _is_hard(kept))


def _is_hard(alpha: Steps) -> bool:
    """Whether every alpha is 0 or full; some rows at a time, as a large drawing takes enough memory by itself."""
    one = alpha.dtype.type(1)
    # Full becomes 0 and 0 becomes 1: nothing else may occur.
    return all(int((alpha[top : top + _ROWS] + one).max()) <= 1 for top in range(0, len(alpha), _ROWS))
