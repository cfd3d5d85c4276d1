"""Masks of a layer made one: the painted one and the path, each with its density and its soft edge.

psd-tools leaves out soft edges and paths on layers with pixels, and puts a path's density on both. Here such masks
become one plain mask of the layer in memory, which psd-tools then reads like any other.
"""

# ruff: noqa: SLF001 - psd-tools gives away stored masks by its inner records only

from collections.abc import Callable, Iterable
from math import ceil
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

Box = tuple[int, int, int, int]
_PAINTED: Final = -2
_PAINTED_BESIDE_PATH: Final = -3
"""Where a layer has both masks, the channel of the painted one; the other is then both together."""

_MOST_REACH_PX: Final = 1000
_REACHES: Final = 3.0
"""Of a soft edge, in its own width; beyond it nothing is seen of it."""

_FORMS: Final[dict[int, np.dtype[Any]]] = {8: np.dtype(np.uint8), 16: np.dtype(">u2"), 32: np.dtype(">f4")}
"""By depth: how a file stores numbers."""


def unite_masks(layers: Iterable[Any]) -> None:
    """Give layers of psd-tools, in memory, one plain mask instead of masks that it draws otherwise than the file says.

    It may be done again; a united mask is plain.
    """
    for layer in layers:
        if layer._psd.depth in _FORMS and _is_drawn_otherwise(layer):
            _unite(layer)


def has_soft_path(layer: Any) -> bool:
    """Whether a drawn shape has a path with a density or a soft edge, which is not done: its fill is stored without."""
    mask = layer.mask
    if mask is None or mask.parameters is None or not _has_own_fill(layer):
        return False
    return _less(mask.parameters.vector_mask_density) or bool(mask.parameters.vector_mask_feather)


def _is_drawn_otherwise(layer: Any) -> bool:
    mask, path = layer.mask, _path_of(layer)
    has_path = path is not None and not _has_own_fill(layer)
    if mask is None:
        return has_path and layer.has_pixels()
    parts = mask.parameters
    if parts is None or mask.disabled:
        return has_path and (mask.has_real() or mask.disabled)
    is_soft = bool(parts.user_mask_feather) or (has_path and bool(parts.vector_mask_feather))
    return is_soft or (has_path and _less(parts.vector_mask_density))


def _path_of(layer: Any) -> Any:
    path = layer.vector_mask
    return None if path is None or path.disabled else path


def _has_own_fill(layer: Any) -> bool:
    """Whether a layer is a path filled with something, whose stored pixels are cut already."""
    from psd_tools.composite.utils import has_fill

    return bool(has_fill(layer))


def _less(density: int | None) -> bool:
    return density is not None and density < 255


def _unite(layer: Any) -> None:
    image = layer._psd
    box = (0, 0, image.width, image.height)
    if not layer.has_effects() and not layer.is_group():  # within a group, adjustments have no extent
        left, top, right, bottom = layer.bbox
        box = (max(left, 0), max(top, 0), min(right, image.width), min(bottom, image.height))
    if box[0] >= box[2] or box[1] >= box[3]:
        return
    parts = layer.mask.parameters if layer.mask is not None else None
    cover = np.ones((box[3] - box[1], box[2] - box[0]), np.float32)
    painted = _painted(layer)
    if painted is not None:
        width = 0.0 if parts is None else parts.user_mask_feather or 0.0
        soft = _soft(lambda wider: laid(*painted, wider), box, width)
        cover *= _thinned(soft, None if parts is None else parts.user_mask_density)
    if _path_of(layer) is not None and not _has_own_fill(layer):
        width = 0.0 if parts is None else parts.vector_mask_feather or 0.0
        soft = _soft(lambda wider: _path_cover(layer, wider), box, width)
        cover *= _thinned(soft, None if parts is None else parts.vector_mask_density)
    _put_mask(layer, box, cover)


def plain_mask(layer: Any) -> tuple[NDArray[np.float32], Box, float] | None:
    """Return the mask of a layer whose masks are united: unit (h, w), its box and what it is around it; None for none.

    It is thinned by its density.
    """
    painted = _painted(layer)
    if painted is None:
        return None
    unit, box, around = painted
    parts = layer.mask.parameters
    share = 1.0 if parts is None or parts.user_mask_density is None else parts.user_mask_density / 255
    return _thinned(unit, parts.user_mask_density if parts else None), box, share * around + 1 - share


def _painted(layer: Any) -> tuple[NDArray[np.float32], Box, float] | None:
    """Return the mask that a person painted, unit (h, w), its box and what it is around it; None for none."""
    record = layer._record.mask_data
    kinds = {info.id for info in layer._record.channel_info}
    if layer.mask is None or record.flags.mask_disabled:
        return None
    if _PAINTED_BESIDE_PATH in kinds and record.real_top is not None:
        box = (record.real_left, record.real_top, record.real_right, record.real_bottom)
        around, kind = record.real_background_color, _PAINTED_BESIDE_PATH
    else:
        if record.flags.user_mask_from_render and _path_of(layer) is not None:
            return None  # the path again, as pixels
        box, around, kind = (
            (record.left, record.top, record.right, record.bottom),
            record.background_color,
            _PAINTED,
        )
    for info, stored in zip(layer._record.channel_info, layer._channels, strict=True):
        if info.id == kind and stored.data:
            return _unit(stored, box, layer._psd), box, around / 255
    return None


def _unit(stored: Any, box: Box, image: Any) -> NDArray[np.float32]:
    width, height = box[2] - box[0], box[3] - box[1]
    form = _FORMS[image.depth]
    numbers = np.frombuffer(stored.get_data(width, height, image.depth, image.version), form)
    most = 1.0 if form.kind == "f" else float(np.iinfo(form).max)
    unit: NDArray[np.float32] = numbers.reshape(height, width).astype(np.float32) / np.float32(most)
    return unit


def laid(unit: NDArray[np.float32], own: Box, around: float, wanted: Box) -> NDArray[np.float32]:
    """Return a mask that lies at ``own`` within the box ``wanted``."""
    made = np.full((wanted[3] - wanted[1], wanted[2] - wanted[0]), around, np.float32)
    left, top, right, bottom = (
        max(own[0], wanted[0]),
        max(own[1], wanted[1]),
        min(own[2], wanted[2]),
        min(own[3], wanted[3]),
    )
    if left < right and top < bottom:
        made[top - wanted[1] : bottom - wanted[1], left - wanted[0] : right - wanted[0]] = unit[
            top - own[1] : bottom - own[1], left - own[0] : right - own[0]
        ]
    return made


def _path_cover(layer: Any, box: Box) -> NDArray[np.float32]:
    from psd_tools.composite.vector import draw_vector_mask

    cover: NDArray[np.float32] = draw_vector_mask(layer, box)[..., 0].astype(np.float32)
    return cover


def _soft(drawn: Callable[[Box], NDArray[np.float32]], box: Box, width_px: float) -> NDArray[np.float32]:
    """Return what ``drawn`` gives for ``box``, blurred by a Gaussian whose deviation is the width of the soft edge."""
    if width_px <= 0:
        return drawn(box)
    reach = min(ceil(_REACHES * width_px), _MOST_REACH_PX)
    wide = drawn((box[0] - reach, box[1] - reach, box[2] + reach, box[3] + reach))
    for axis in (0, 1):
        wide = _blurred(wide, width_px, reach, axis)
    return wide


def _blurred(unit: NDArray[np.float32], deviation: float, reach: int, axis: int) -> NDArray[np.float32]:
    """Return values blurred along an axis, without the ``reach`` at its ends, which only served the blur."""
    weights = np.exp(-0.5 * (np.arange(-reach, reach + 1) / deviation) ** 2)
    weights /= weights.sum()
    length = unit.shape[axis]
    shape = (-1, 1) if axis == 0 else (1, -1)
    spectrum = np.fft.rfft(unit, axis=axis) * np.fft.rfft(weights, length).reshape(shape)
    whole = np.fft.irfft(spectrum, length, axis=axis).astype(np.float32)
    # The first sums wrap around; from 2 × reach on they are whole.
    kept: NDArray[np.float32] = whole[2 * reach :] if axis == 0 else whole[:, 2 * reach :]
    return kept.clip(0.0, 1.0)


def _thinned(cover: NDArray[np.float32], density: int | None) -> NDArray[np.float32]:
    share = np.float32(1.0 if density is None else density / 255)
    return share * cover + (np.float32(1.0) - share)


def _put_mask(layer: Any, box: Box, cover: NDArray[np.float32]) -> None:
    """Give a layer this mask and no path."""
    from psd_tools.constants import Compression, Tag
    from psd_tools.psd.layer_and_mask import ChannelData, ChannelDataList, ChannelInfo, MaskData, MaskFlags

    image, record = layer._psd, layer._record
    form = _FORMS[image.depth]
    numbers = cover if form.kind == "f" else np.rint(cover * np.float32(np.iinfo(form).max))
    plane = ChannelData(Compression.RAW)
    plane.set_data(numbers.astype(form).tobytes(), box[2] - box[0], box[3] - box[1], image.depth, image.version)
    kept = [
        (info, stored)
        for info, stored in zip(record.channel_info, layer._channels, strict=True)
        if info.id not in {_PAINTED, _PAINTED_BESIDE_PATH}
    ]
    record.channel_info = [*(info for info, _ in kept), ChannelInfo(_PAINTED, 2 + len(plane.data))]
    planes: Any = [*(stored for _, stored in kept), plane]
    layer._channels = ChannelDataList(planes)
    record.mask_data = MaskData(
        top=box[1], left=box[0], bottom=box[3], right=box[2], background_color=0, flags=MaskFlags()
    )
    for tag in (Tag.VECTOR_MASK_SETTING1, Tag.VECTOR_MASK_SETTING2):
        layer.tagged_blocks.pop(tag, None)
    for known in ("_mask", "_vector_mask"):
        if hasattr(layer, known):
            delattr(layer, known)
