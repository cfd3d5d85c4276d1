"""From psd-tools' layers to straight pixels on the canvas of their file.

A layer without masks, clipping layers, effects and opacity is taken as it is stored, digit for digit; everything else
is put together by psd-tools.
"""

# ruff: noqa: SLF001 - psd-tools gives away stored pixels, and the file of a layer, by its inner names only

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from kagezou.io.pixels.colour import coded_from_light, steps_from_unit
from kagezou.io.psd.undrawn import without_undrawn

_GRAY: Final = 1
_RGB: Final = 3
_PLACES: Final = {
    _GRAY: {0: slice(0, 3), -1: slice(3, 4)},
    _RGB: {0: slice(0, 1), 1: slice(1, 2), 2: slice(2, 3), -1: slice(3, 4)},
}
"""By colour space: number of a stored channel → where it goes in RGBA."""

_MOST_STORED_PX: Final = 1 << 28
_MOST_PIXELS: Final = 2_000_000_000
"""So many pixels may the layers of a group have together."""

Box = tuple[int, int, int, int]


@dataclass(frozen=True, slots=True, eq=False)
class PsdPixels:
    """Straight sRGB pixels, (H, W, 4) ``uint8`` or ``uint16``, and whether their alpha was in the file."""

    rgba: NDArray[Any]
    has_alpha: bool


def merged_pixels(image: Any) -> PsdPixels:
    """Return what a whole file shows: the picture saved with it, or where there is none its layers put together."""
    from psd_tools.api.utils import has_transparency

    whole: Box = (0, 0, image.width, image.height)
    if len(image) and not image.has_preview():
        with without_undrawn(list(image.descendants())):
            return PsdPixels(_composed(image, whole, whole), has_alpha=True)
    is_coded_alike = image.color_mode.value in {_GRAY, _RGB}
    if not is_coded_alike or image.depth <= 8:
        return _by_pillow(image.topil(apply_icc=not is_coded_alike), whole, whole)
    alpha = image.numpy("shape") if has_transparency(image) else None
    return PsdPixels(_placed(image.depth, image.numpy("color"), alpha, whole, whole), alpha is not None)


def part_pixels(layer: Any) -> PsdPixels:
    """Return a layer or a group alone on the canvas of its file, as if it and all around it were switched on."""
    image = layer._psd
    whole: Box = (0, 0, image.width, image.height)
    if _is_plain(layer):
        return PsdPixels(_as_stored(layer, whole), has_alpha=True)
    with _switched_on(layer):
        parts = [layer, *layer.clip_layers, *(layer.descendants() if layer.is_group() else ())]
        if sum(max(each.width, 0) * max(each.height, 0) for each in parts if not each.is_group()) > _MOST_PIXELS:
            raise ValueError("its layers are larger than can be read")
        reach = whole if any(each.has_effects() for each in parts) else _common(layer.bbox, whole)
        # Were the layer itself hidden, nothing would be left to be told about.
        with without_undrawn(parts):
            layer.visible = True
            return PsdPixels(_composed(layer, reach, whole), has_alpha=True)


def _as_stored(layer: Any, whole: Box) -> NDArray[Any]:
    """Return a plain layer by its stored channels, one at a time; floats of all of them would take eight times as much.

    psd-tools gives them away only as floats, so its inner records are read.
    """
    image, box = layer._psd, layer.bbox
    width, height, depth = layer.width, layer.height, image.depth
    if width * height > _MOST_STORED_PX:
        raise ValueError("its pixels are more than can be read")
    made = np.zeros((whole[3], whole[2], 4), np.uint8 if depth == 8 else np.uint16)
    left, top, right, bottom = _common(box, whole)
    if left >= right or top >= bottom:
        return made
    target = made[top:bottom, left:right]
    target[..., 3] = _full(made)
    places = _PLACES[image.color_mode.value]
    for info, stored in zip(layer._record.channel_info, layer._channels, strict=True):
        if info.id in places and stored.data:
            data = stored.get_data(width, height, depth, image.version)
            plane = np.frombuffer(data, np.uint8 if depth == 8 else ">u2").reshape(height, width, 1)
            target[..., places[info.id]] = plane[top - box[1] : bottom - box[1], left - box[0] : right - box[0]]
    return made


def _is_plain(layer: Any) -> bool:
    image = layer._psd
    return (
        layer.kind in {"pixel", "type", "smartobject"}
        and image.color_mode.value in {_GRAY, _RGB}
        and image.depth in {8, 16}
        and layer.has_pixels()
        and layer.opacity == 255
        and layer.fill_opacity == 255
        and not layer.has_mask()
        and not layer.has_vector_mask()
        and not layer.clip_layers
        and not layer.has_effects()
    )


@contextmanager
def _switched_on(layer: Any) -> Iterator[None]:
    """Show a layer and the groups around it for the block; hidden ones have no extent for psd-tools."""
    hidden = []
    each = layer
    while each.parent is not None:
        if not each.visible:
            hidden.append(each)
            each.visible = True
        each = each.parent
    try:
        yield
    finally:
        for each in hidden:
            each.visible = False


def _composed(group: Any, reach: Box, whole: Box) -> NDArray[Any]:
    """Return a group, a layer or a file put together within ``reach``, (H, W, 4) as large as ``whole``."""
    from psd_tools.composite import composite
    from psd_tools.composite.composite import composite_pil

    image = getattr(group, "_psd", group)
    is_part = image is not group
    if reach[0] >= reach[2] or reach[1] >= reach[3]:
        return _placed(image.depth, None, None, reach, whole)
    if image.color_mode.value not in {_GRAY, _RGB}:
        picture = composite_pil(group, 1.0, 0.0, reach, None, force=False, as_layer=is_part)
        return _by_pillow(picture, reach, whole).rgba
    colour, _, alpha = composite(group, viewport=reach, as_layer=is_part)
    return _placed(image.depth, colour, alpha, reach, whole)


def _common(box: Box, whole: Box) -> Box:
    return (max(box[0], whole[0]), max(box[1], whole[1]), min(box[2], whole[2]), min(box[3], whole[3]))


def _placed(depth: int, colour: Any, alpha: Any, box: Box, whole: Box) -> NDArray[Any]:
    """Return unit colours (h, w, 1 or 3) and alpha (h, w, 1) that lie at ``box`` as steps on the canvas ``whole``."""
    made = np.zeros((whole[3], whole[2], 4), np.uint8 if depth <= 8 else np.uint16)
    left, top, right, bottom = _common(box, whole)
    if colour is None or left >= right or top >= bottom:
        return made
    rows, columns = slice(top - box[1], bottom - box[1]), slice(left - box[0], right - box[0])
    target = made[top:bottom, left:right]
    target[..., :3] = _steps(colour[rows, columns, :3], depth, is_light=depth == 32)
    target[..., 3:] = _full(made) if alpha is None else _steps(alpha[rows, columns, :1], depth)
    return made


def _steps(unit: NDArray[np.float32], depth: int, *, is_light: bool = False) -> NDArray[Any]:
    if is_light:  # 32 bit files hold linear light
        return coded_from_light(unit, None)
    if depth > 8:
        return steps_from_unit(unit)
    return np.asarray(np.clip(np.nan_to_num(unit), 0.0, 1.0) * np.float32(255) + np.float32(0.5)).astype(np.uint8)


def _by_pillow(picture: Any, box: Box, whole: Box) -> PsdPixels:
    """Return a picture of another colour space, which Pillow turns into RGB, on the canvas."""
    if picture is None:
        raise ValueError("there are no pixels in it")
    has_alpha = "A" in picture.getbands() and picture.mode != "LAB"
    pixels = np.asarray((picture.convert("RGB") if picture.mode not in {"RGBA", "LA"} else picture).convert("RGBA"))
    made = np.zeros((whole[3], whole[2], 4), np.uint8)
    made[box[1] : box[3], box[0] : box[2]] = pixels
    return PsdPixels(made, has_alpha)


def _full(pixels: NDArray[Any]) -> int:
    return int(np.iinfo(pixels.dtype).max)
