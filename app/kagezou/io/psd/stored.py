"""Layers taken as they are stored, digit for digit, where nothing changes what is seen of them."""

# ruff: noqa: SLF001 - psd-tools gives away stored pixels, and the file of a layer, by its inner names only

from collections.abc import Sequence
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from kagezou.io.psd.masks import Box, laid, plain_mask

GRAY: Final = 1
RGB: Final = 3
_PLACES: Final = {
    GRAY: {0: slice(0, 3), -1: slice(3, 4)},
    RGB: {0: slice(0, 1), 1: slice(1, 2), 2: slice(2, 3), -1: slice(3, 4)},
}
"""By colour space: number of a stored channel → where it goes in RGBA."""

_MOST_STORED_PX: Final = 1 << 28
_ROWS: Final = 256
"""So many rows are thinned at a time, which bounds the floats."""


def as_stored(layer: Any, around: Sequence[Any], whole: Box) -> NDArray[Any]:
    """Return a layer by its stored channels, one at a time; floats of all of them would take eight times as much.

    Its alpha is thinned and cut by opacities and masks, its own and those of the groups ``around`` it. psd-tools gives
    channels away only as floats, so its inner records are read.
    """
    image, box = layer._psd, layer.bbox
    width, height, depth = layer.width, layer.height, image.depth
    if width * height > _MOST_STORED_PX:
        raise ValueError("its pixels are more than can be read")
    made = np.zeros((whole[3], whole[2], 4), np.uint8 if depth == 8 else np.uint16)
    left, top, right, bottom = inner = common(box, whole)
    if left >= right or top >= bottom:
        return made
    target = made[top:bottom, left:right]
    target[..., 3] = full(made)
    places = _PLACES[image.color_mode.value]
    for info, stored in zip(layer._record.channel_info, layer._channels, strict=True):
        if info.id in places and stored.data:
            data = stored.get_data(width, height, depth, image.version)
            plane = np.frombuffer(data, np.uint8 if depth == 8 else ">u2").reshape(height, width, 1)
            target[..., places[info.id]] = plane[top - box[1] : bottom - box[1], left - box[0] : right - box[0]]
    for each in (layer, *around):
        _thin(target[..., 3], each, inner)
    return made


def _thin(alpha: NDArray[Any], layer: Any, box: Box) -> None:
    """Thin alpha that lies at ``box`` by the opacity and the mask of a layer, in place."""
    opacity = layer.opacity / 255 * layer.fill_opacity / 255
    painted = plain_mask(layer)
    if painted is None and opacity == 1:
        return
    for top in range(box[1], box[3], _ROWS):
        rows = alpha[top - box[1] : top - box[1] + _ROWS]
        cover = np.full(rows.shape, opacity, np.float32)
        if painted is not None:
            cover *= laid(*painted, (box[0], top, box[2], top + rows.shape[0]))
        rows[...] = np.floor(rows * cover + np.float32(0.5))


def is_plain(layer: Any, around: Sequence[Any]) -> bool:
    """Whether a layer within the groups ``around`` it has the colours that are stored, whatever becomes of its alpha.

    Its masks, and those of the groups, are united first; see `masks.unite_masks`.
    """
    image = layer._psd
    return (
        layer.kind in {"pixel", "type", "smartobject"}
        and image.color_mode.value in {GRAY, RGB}
        and image.depth in {8, 16}
        and layer.has_pixels()
        and all(map(_keeps_colours, (layer, *around)))
    )


def _keeps_colours(layer: Any) -> bool:
    return not layer.has_vector_mask() and not layer.clip_layers and not layer.has_effects()


def common(box: Box, whole: Box) -> Box:
    """Return what two boxes have in common; with its ends the wrong way round where that is nothing."""
    return (max(box[0], whole[0]), max(box[1], whole[1]), min(box[2], whole[2]), min(box[3], whole[3]))


def full(pixels: NDArray[Any]) -> int:
    """Return the value of integer pixels that stands for 1."""
    return int(np.iinfo(pixels.dtype).max)
