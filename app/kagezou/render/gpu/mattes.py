"""The drawings on the graphics card: each one's alpha cropped to its figure, with a rim of empty texels.

A texel holds its own alpha and those to its right, below and below right: what is between four texels is then fetched
at once, which is most of what an edge costs.
"""

import sys
from dataclasses import dataclass
from functools import partial
from math import ceil
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.box import Box, centred_offset
from kagezou.io.images.reading import Matte, Steps
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.made_of_cache import MadeOfCache
from kagezou.render.gpu.program import Program
from kagezou.render.gpu.targets import Format, Target, Texture
from kagezou.render.prepare.occupancy import Occupancy
from kagezou.render.prepare.uniforms import LAST_LEVEL, Uniform

HARD_EDGE_SIGMA_PX = 1.0
"""Paint data without anti-aliasing is smoothed by this Gaussian before its 0.5 level is taken as the edge."""

# Two, so that the texels of a place beyond the rim, which is looked for in the outermost four, are all empty.
_RIM_PX = 2
_STRIP_BYTES = 1 << 15
_SMOOTHING_REACH_PX = ceil(3 * HARD_EDGE_SIGMA_PX)


class MatteTexture:
    """A matte as a texture of texels and their neighbours with an empty rim, and where it is empty or full."""

    def __init__(self, texture: Texture, occupancy: Occupancy) -> None:
        self.texture = texture
        self.occupancy = occupancy
        self._solid: Texture | None = None

    @property
    def nbytes(self) -> int:
        """Memory on the graphics card, with what may yet be made of the texture."""
        return 2 * self.texture.nbytes

    def means(self, boxes: Boxes, threshold: Program, *, translucent: bool) -> Texture:
        """Return a texture whose mipmaps hold the mean part that casts: of alpha as it is, or of what is solid."""
        if translucent:
            self.texture.make_mipmaps()
            return self.texture
        if self._solid is None:
            self._solid = drawn_from(self.texture, Format.ALPHA8, boxes, threshold, {})
            self._solid.make_mipmaps()
        return self._solid

    def close(self) -> None:
        """Give the memory back."""
        self.texture.close()
        if self._solid is not None:
            self._solid.close()


@dataclass(frozen=True, slots=True)
class PlacedMatte:
    """A matte and the canvas box its texels cover, one texel a canvas px."""

    on_gpu: MatteTexture
    box: Box

    @property
    def texture(self) -> Texture:
        """Its texels."""
        return self.on_gpu.texture

    @property
    def occupancy(self) -> Occupancy:
        """Where it is empty or full."""
        return self.on_gpu.occupancy


class Mattes:
    """The mattes last used, within a budget of memory."""

    def __init__(self, boxes: Boxes, budget_bytes: int) -> None:
        self._boxes = boxes
        self._smooth = Program("common/box.vert", "common/smooth.frag")
        self._neighbours = Program("common/box.vert", "common/neighbours.frag")
        self._shelf: MadeOfCache[MatteTexture] = MadeOfCache(budget_bytes)

    def placed(self, matte: Matte, canvas: Box) -> PlacedMatte | None:
        """Return the matte as it lies on the canvas, or None for an empty cel."""
        if matte.box is None:
            return None
        on_gpu = self._shelf.made_of(matte, partial(self._put_on_gpu, matte, matte.box))
        left, top = centred_offset(canvas, matte.width_px, matte.height_px)
        corner = matte.box.moved(left, top).grown(_margin(matte))
        box = Box(corner.left, corner.top, corner.left + on_gpu.texture.width_px, corner.top + on_gpu.texture.height_px)
        return PlacedMatte(on_gpu, box)

    def close(self) -> None:
        """Give the memory back."""
        self._shelf.close()
        self._smooth.close()
        self._neighbours.close()

    def _put_on_gpu(self, matte: Matte, box: Box) -> MatteTexture:
        margin = _margin(matte)
        height, width = (_whole_squares(side + 2 * margin) for side in (box.height, box.width))
        # With one row more, so that each row has one below it.
        padded = _empty_like(matte.alpha, (height + 1, width))
        padded[margin : margin + box.height, margin : margin + box.width] = matte.alpha
        texels = padded[:height]
        if matte.hard_edged:
            return MatteTexture(self._smoothed(texels), Occupancy(texels, _SMOOTHING_REACH_PX))
        texture = Texture(width, height, Format.RGBA8 if padded.dtype == np.uint8 else Format.RGBA16)
        # In strips, so that what is joined and handed over stays in the processor's cache.
        step = max(_STRIP_BYTES // padded[0].nbytes, 1)
        for top in range(0, height, step):
            texture.upload(_with_neighbours(padded[top : top + step + 1]), top)
        return MatteTexture(texture, Occupancy(texels, 0))

    def _smoothed(self, alpha: Steps) -> Texture:
        """Return the matte smoothed in x, then in y."""
        form = Format.ALPHA8 if alpha.dtype == np.uint8 else Format.ALPHA16
        source = Texture(alpha.shape[1], alpha.shape[0], form)
        source.upload(alpha)
        for axis in ((1.0, 0.0), (0.0, 1.0)):
            uniforms: dict[str, Uniform] = {"u_axis": axis, "u_sigma_px": HARD_EDGE_SIGMA_PX}
            smoothed = drawn_from(source, Format.ALPHA16, self._boxes, self._smooth, uniforms)
            source.close()
            source = smoothed
        texture = drawn_from(source, Format.RGBA16, self._boxes, self._neighbours, {})
        source.close()
        return texture


def drawn_from(source: Texture, form: Format, boxes: Boxes, program: Program, uniforms: dict[str, Uniform]) -> Texture:
    """Return what a program makes of a texture of the same size."""
    target = Target(source.width_px, source.height_px, form)
    target.bind()
    source.bind(0)
    program.use({"u_target_size_px": target.size_px, "u_source": 0, **uniforms})
    boxes.draw_one(target.box)
    return target.texture_alone()


def _with_neighbours(alpha: Steps) -> Steps:
    """Return for each texel of (H + 1, W) but the last row what ``common/neighbours.frag`` does, (H, W, 4)."""
    # Texels beside one another are joined to a number, then numbers below one another, so that no byte is moved alone.
    bits = alpha.dtype.itemsize * 8
    first, second = (0, bits) if sys.byteorder == "little" else (bits, 0)
    pairs = _shifted(alpha, first)
    pairs[:, :-1] += _shifted(alpha[:, 1:], second)
    quads = _shifted(pairs[:-1], 2 * first)
    quads += _shifted(pairs[1:], 2 * second)
    return np.asarray(quads.view(alpha.dtype).reshape(*quads.shape, 4))


def _shifted(numbers: NDArray[Any], bits: int) -> NDArray[Any]:
    """Return unsigned numbers in twice their size, so many bits higher."""
    wide = np.dtype(f"u{2 * numbers.dtype.itemsize}")
    return np.asarray(np.left_shift(numbers, wide.type(bits), dtype=wide))


def _margin(matte: Matte) -> int:
    return _RIM_PX + (_SMOOTHING_REACH_PX if matte.hard_edged else 0)


def _whole_squares(side_px: int) -> int:
    square = 1 << LAST_LEVEL
    return -(-side_px // square) * square


def _empty_like(alpha: Steps, shape: tuple[int, ...]) -> Steps:
    return np.zeros(shape, np.uint8) if alpha.dtype == np.uint8 else np.zeros(shape, np.uint16)
