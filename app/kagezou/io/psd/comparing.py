"""The layers of a file put together, held against the picture that was saved with them."""

# ruff: noqa: SLF001 - whether a group is clipped is told by its inner record only

from dataclasses import dataclass
from enum import Enum
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from kagezou.io.pixels.colour import coded_from_light
from kagezou.io.psd.bands import bands
from kagezou.io.psd.masks import unite_masks
from kagezou.io.psd.stored import GRAY, RGB
from kagezou.io.psd.undrawn import without_undrawn

LEAST_LEVELS: Final = 2
"""So many of 255 levels come of rounding in several steps."""

_ROUNDED: Final = LEAST_LEVELS + 0.5
_MOST_PX: Final = 32 << 20
_MOST_LAYERS_PX: Final = 400 << 20
"""Larger files are not compared: it would take longer than reading them."""


@dataclass(frozen=True, slots=True)
class Difference:
    """How far layers that were put together are from the saved picture.

    Parameters
    ----------
    levels
        The largest difference of a colour on white paper, of 255.
    share
        The part of the pixels that differ by more than `LEAST_LEVELS`, 0 to 1.
    """

    levels: float
    share: float

    @property
    def is_seen(self) -> bool:
        """Whether it is more than rounding."""
        return self.levels > _ROUNDED


class Hindrance(Enum):
    """Why layers cannot be held against a picture."""

    NO_PICTURE = "no picture"
    EMPTY = "empty"
    OTHER = "other"


def hindrance(image: Any) -> Hindrance | None:
    """Return why the layers of a file cannot be held against a picture; None where they can."""
    if not image.has_preview():
        return Hindrance.NO_PICTURE
    layers = (max(each.width, 0) * max(each.height, 0) for each in image.descendants() if not each.is_group())
    is_large = image.width * image.height > _MOST_PX or sum(layers) > _MOST_LAYERS_PX
    if is_large or image.color_mode.value not in {GRAY, RGB}:
        return Hindrance.OTHER
    return Hindrance.EMPTY if _is_empty(image) else None


def _is_empty(image: Any) -> bool:
    """Whether nothing is seen of the saved picture: some programs save colours under an alpha of 0."""
    from psd_tools.api.utils import has_transparency
    from psd_tools.constants import Resource

    header = image._record.header
    is_named = any(key in image.image_resources for key in (Resource.ALPHA_NAMES_PASCAL, Resource.ALPHA_NAMES_UNICODE))
    colours = 1 if image.color_mode.value == GRAY else 3
    has_alpha = has_transparency(image) or (header.channels == colours + 1 and not is_named)
    return has_alpha and not any(image._record.image_data.get_data(header)[colours])


def difference(image: Any) -> Difference:
    """Return how far the visible layers of a file are from its picture; see `hindrance` first."""
    from psd_tools.composite import composite

    layers = list(image.descendants())
    unite_masks(layers)
    levels, count = 0.0, 0
    saved = _Saved(image)
    with without_undrawn(layers):
        for band in bands((0, 0, image.width, image.height), layers):
            colour, _, alpha = composite(image, viewport=band)
            ours = _on_paper(colour, alpha, image.depth)
            apart = np.abs(ours - saved.rows(band[1], band[3], ours.shape[2])).max(axis=2) * 255
            levels = max(levels, float(apart.max()))
            count += int((apart > _ROUNDED).sum())
    return Difference(levels, count / (image.width * image.height))


class _Saved:
    """The picture that was saved with layers, on white paper."""

    def __init__(self, image: Any) -> None:
        from psd_tools.api.utils import has_transparency

        self._depth = image.depth
        self._has_alpha = has_transparency(image)
        # Eight bits stay as they are: floats of the whole would be four times as large.
        self._pixels = np.asarray(image.topil(apply_icc=False)) if image.depth <= 8 else image.numpy()

    def rows(self, top: int, bottom: int, channels: int) -> NDArray[np.float32]:
        """Return rows (h, W, channels) of it, unit."""
        rows = self._pixels[top:bottom].reshape(bottom - top, self._pixels.shape[1], -1)
        unit = rows.astype(np.float32) / np.float32(255) if rows.dtype == np.uint8 else rows
        alpha = unit[..., channels : channels + 1] if self._has_alpha else np.float32(1)
        return _on_paper(unit[..., :channels], alpha, self._depth)


def _on_paper(colour: NDArray[Any], alpha: Any, depth: int) -> NDArray[np.float32]:
    if depth == 32:  # linear light
        colour = coded_from_light(colour, None) / np.float32(65535)
    made: NDArray[np.float32] = np.nan_to_num(colour * alpha + (1 - alpha))
    return made


def follow_clipped_groups(image: Any) -> None:
    """Take groups as clipped to what lies below them where a file says so and its picture does not speak against it.

    Photoshop writes the sign and does nothing by it; Clip Studio Paint and others clip.
    """
    from psd_tools.constants import Clipping, CompatibilityMode

    if not any(each.is_group() and each._record.clipping == Clipping.NON_BASE for each in image.descendants()):
        return
    as_photoshop = difference(image) if hindrance(image) is None else None
    image.compatibility_mode = CompatibilityMode.CLIP_STUDIO_PAINT
    if as_photoshop is not None and difference(image).share > as_photoshop.share:
        image.compatibility_mode = CompatibilityMode.PHOTOSHOP
