"""From psd-tools' layers to straight pixels on the canvas of their file.

A layer without masks, clipping layers, effects and opacity is taken as it is stored, digit for digit; everything else
is put together by psd-tools.
"""

# ruff: noqa: SLF001 - psd-tools gives away stored pixels, and the file of a layer, by its inner names only

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from kagezou.io.pixels.colour import coded_from_light, steps_from_unit
from kagezou.io.psd.bands import bands
from kagezou.io.psd.masks import Box, unite_masks
from kagezou.io.psd.stored import GRAY, RGB, as_stored, common, full, is_plain
from kagezou.io.psd.undrawn import without_undrawn

_MOST_PIXELS: Final = 2_000_000_000
"""So many pixels may the layers of a group have together."""


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
        unite_masks(image.descendants())
        with without_undrawn(list(image.descendants())):
            return PsdPixels(_composed(image, whole, whole), has_alpha=True)
    is_coded_alike = image.color_mode.value in {GRAY, RGB}
    if not is_coded_alike or image.depth <= 8:
        return _by_pillow(image.topil(apply_icc=not is_coded_alike))
    alpha = image.numpy("shape") if has_transparency(image) else None
    return PsdPixels(_steps_of(image.depth, image.numpy("color"), alpha), alpha is not None)


def part_pixels(layer: Any) -> PsdPixels:
    """Return a layer or a group alone on the canvas of its file, as if it and all around it were switched on.

    The groups around it still thin and cut it, and what is clipped to it or to them still colours it.
    """
    image = layer._psd
    whole: Box = (0, 0, image.width, image.height)
    around = _around(layer)
    unite_masks((*around, layer))
    if is_plain(layer, around):
        return PsdPixels(as_stored(layer, around, whole), has_alpha=True)
    with _switched_on(layer):
        parts = [layer, *(layer.descendants() if layer.is_group() else ())]
        clipped = [each for base in (*around, *parts) for each in base.clip_layers]
        parts += [below for each in clipped for below in (each, *(each.descendants() if each.is_group() else ()))]
        _check_size(parts)
        seen = [*around, *dict.fromkeys(parts)]
        unite_masks(parts)
        reach = whole if any(each.has_effects() for each in seen) else common(layer.bbox, whole)
        # Were the layer itself hidden, nothing would be left to be told about.
        with without_undrawn(seen):
            layer.visible = True
            top = around[0] if around else layer
            return PsdPixels(_composed(top, reach, whole, frozenset(map(id, seen))), has_alpha=True)


def _check_size(layers: Iterable[Any]) -> None:
    """See that layers are not larger together than can be worked with; a ValueError says that they are."""
    if sum(max(each.width, 0) * max(each.height, 0) for each in layers if not each.is_group()) > _MOST_PIXELS:
        raise ValueError("its layers are larger than can be read")


def _around(layer: Any) -> list[Any]:
    """Return the groups around a layer, the outermost first."""
    around: list[Any] = []
    each = layer.parent
    while each is not None and each.parent is not None:
        around.insert(0, each)
        each = each.parent
    return around


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


def _composed(group: Any, reach: Box, whole: Box, seen: frozenset[int] | None = None) -> NDArray[Any]:
    """Return a group, a layer or a file put together within ``reach``, (H, W, 4) as large as ``whole``.

    Of what lies in it, only layers that are visible count, and of these, where ``seen`` says so, only those. It is done
    in bands, which bounds the floats.
    """
    from psd_tools.composite import composite
    from psd_tools.composite.composite import composite_pil

    def is_seen(each: Any) -> bool:
        return bool(each.is_visible()) and (seen is None or id(each) in seen)

    image = getattr(group, "_psd", group)
    is_part = image is not group
    is_coded_alike = image.color_mode.value in {GRAY, RGB}
    made = np.zeros((whole[3], whole[2], 4), np.uint16 if is_coded_alike and image.depth > 8 else np.uint8)
    for band in bands(reach, [group] if is_part and not group.is_group() else group.descendants()):
        target = made[band[1] : band[3], band[0] : band[2]]
        if is_coded_alike:
            colour, _, alpha = composite(group, viewport=band, layer_filter=is_seen, as_layer=is_part)
            target[...] = _steps_of(image.depth, colour, alpha)
        else:
            picture = composite_pil(group, 1.0, 0.0, band, is_seen, force=False, as_layer=is_part)
            target[...] = _by_pillow(picture).rgba
    return made


def _steps_of(depth: int, colour: Any, alpha: Any) -> NDArray[Any]:
    """Return unit colours (h, w, 1 or 3) and alpha (h, w, 1), full where it is None, as straight steps (h, w, 4)."""
    made = np.empty((*colour.shape[:2], 4), np.uint8 if depth <= 8 else np.uint16)
    made[..., :3] = _steps(colour[..., :3], depth, is_light=depth == 32)
    made[..., 3:] = full(made) if alpha is None else _steps(alpha[..., :1], depth)
    return made


def _steps(unit: NDArray[np.float32], depth: int, *, is_light: bool = False) -> NDArray[Any]:
    if is_light:  # 32 bit files hold linear light
        return coded_from_light(unit, None)
    if depth > 8:
        return steps_from_unit(unit)
    return np.asarray(np.clip(np.nan_to_num(unit), 0.0, 1.0) * np.float32(255) + np.float32(0.5)).astype(np.uint8)


def _by_pillow(picture: Any) -> PsdPixels:
    """Return a picture of another colour space, which Pillow turns into RGB."""
    if picture is None:
        raise ValueError("there are no pixels in it")
    has_alpha = "A" in picture.getbands() and picture.mode != "LAB"
    pixels = np.array((picture.convert("RGB") if picture.mode not in {"RGBA", "LA"} else picture).convert("RGBA"))
    return PsdPixels(pixels, has_alpha)
