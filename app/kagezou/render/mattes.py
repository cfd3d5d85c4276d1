"""The drawings on the graphics card: each one's alpha cropped to its figure, with a rim of empty texels."""

from dataclasses import dataclass
from functools import partial
from math import ceil

import numpy as np

from kagezou.geometry.box import Box, centred_offset
from kagezou.io.images import Matte
from kagezou.render.polygons import Polygons
from kagezou.render.program import Program
from kagezou.render.shelf import TextureShelf
from kagezou.render.targets import Format, Target, Texture

HARD_EDGE_SIGMA_PX = 1.0
"""Paint data without anti-aliasing is smoothed by this Gaussian before its 0.5 level is taken as the edge."""

_RIM_PX = 1
_SMOOTHING_REACH_PX = ceil(3 * HARD_EDGE_SIGMA_PX)


@dataclass(frozen=True, slots=True)
class PlacedMatte:
    """A matte texture and the canvas box its texels cover, one texel a canvas px; the outermost are empty."""

    texture: Texture
    box: Box


class MatteTextures:
    """The mattes last used, within a budget of memory."""

    def __init__(self, polygons: Polygons, budget_bytes: int) -> None:
        self._polygons = polygons
        self._smooth = Program("polygon.vert", "smooth.frag")
        self._shelf = TextureShelf(budget_bytes)

    def placed(self, matte: Matte, canvas: Box) -> PlacedMatte | None:
        """Return the matte as it lies on the canvas, or None for an empty cel."""
        if matte.box is None:
            return None
        texture = self._shelf.texture_of(matte, partial(self._made, matte, matte.box))
        height, width = matte.alpha.shape
        left, top = centred_offset(canvas, width, height)
        return PlacedMatte(texture, matte.box.moved(left, top).grown(_margin(matte)))

    def close(self) -> None:
        """Give the memory back."""
        self._shelf.close()
        self._smooth.close()

    def _made(self, matte: Matte, box: Box) -> Texture:
        return self._smoothed(matte, box) if matte.hard_edged else _uploaded(matte, box, _RIM_PX)

    def _smoothed(self, matte: Matte, box: Box) -> Texture:
        """Return the matte smoothed in x, then in y."""
        source = _uploaded(matte, box, _margin(matte))
        size = (source.width_px, source.height_px)
        across, result = Target(*size, Format.ALPHA16), Target(*size, Format.ALPHA16)
        for texture, target, axis in ((source, across, (1.0, 0.0)), (across.texture, result, (0.0, 1.0))):
            target.bind()
            texture.bind(0)
            self._smooth.use(
                {
                    "u_target_size_px": (float(size[0]), float(size[1])),
                    "u_source": 0,
                    "u_axis": axis,
                    "u_sigma_px": HARD_EDGE_SIGMA_PX,
                }
            )
            self._polygons.draw_box(target.box)
        across.close()
        source.close()
        return result.texture_alone()


def _margin(matte: Matte) -> int:
    return _RIM_PX + (_SMOOTHING_REACH_PX if matte.hard_edged else 0)


def _uploaded(matte: Matte, box: Box, margin: int) -> Texture:
    form = Format.ALPHA8 if matte.alpha.dtype.itemsize == 1 else Format.ALPHA16
    padded = np.zeros((box.height + 2 * margin, box.width + 2 * margin), dtype=form.dtype)
    padded[margin:-margin, margin:-margin] = matte.alpha[box.top : box.bottom, box.left : box.right]
    texture = Texture(padded.shape[1], padded.shape[0], form)
    texture.upload(padded)
    return texture
