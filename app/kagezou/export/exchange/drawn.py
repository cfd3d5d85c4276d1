"""One frame of layers as pictures of the whole canvas, packed: what workers make of what was drawn."""

import hashlib
import threading
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from itertools import groupby
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kagezou.export.layered import LayeredContent
from kagezou.export.pictures import LayeredPicture, Picture
from kagezou.export.planning import FrameJob
from kagezou.geometry.box import around
from kagezou.io.images.writing import encode_rgba_png
from kagezou.io.pixels.layers import LayeredImage, LayerPart

Pixels = NDArray[Any]


@dataclass(frozen=True, slots=True)
class Who:
    """A layer over the cut: a part of layered frames by its name, or a group of them by the group's."""

    name: str
    is_group: bool = False


def layers_of(content: LayeredContent) -> tuple[Who, ...]:
    """Return the layers of a frame from the bottom; those of a group are one."""
    named = zip(content.group_names, content.part_names, strict=True)
    return tuple(dict.fromkeys(Who(group, is_group=True) if group else Who(part) for group, part in named))


@dataclass(frozen=True, slots=True)
class DrawnLayer:
    """A layer on one frame.

    Parameters
    ----------
    who
        Which layer it is.
    opacity, multiply
        As of `LayerPart`.
    key
        Tells its picture from others; empty where nothing is seen.
    png
        The file, None where it was packed for another frame.
    is_filled
        Whether it is opaque on the whole canvas.
    """

    who: Who
    opacity: float
    multiply: bool
    key: str = ""
    png: bytes | None = None
    is_filled: bool = False


@dataclass(slots=True)
class Packer:
    """Packs each different picture of a layer once; used by several threads at a time."""

    _packed: set[tuple[Who, str]] = field(default_factory=set)
    _lock: threading.Lock = field(default_factory=threading.Lock)

    def pack(self, _job: FrameJob, picture: Picture) -> tuple[DrawnLayer, ...]:
        """Return the layers of a frame from the bottom."""
        assert isinstance(picture, LayeredPicture), "what was drawn has layers"
        image = picture.image
        return tuple(self._layer(image, who, part) for who, part in flat_parts(image))

    def _layer(self, image: LayeredImage, who: Who, part: LayerPart) -> DrawnLayer:
        """Return one layer; clear pixels at the edge of its box do not make another picture of it."""
        if part.box.is_empty or not part.pixels[..., 3].any():
            return DrawnLayer(who, part.opacity, part.multiply)
        canvas = np.zeros((image.height_px, image.width_px, 4), part.pixels.dtype)
        canvas[part.box.top : part.box.bottom, part.box.left : part.box.right] = part.pixels
        # What is clear has no colour that anyone sees, and would tell equal pictures apart.
        canvas[canvas[..., 3] == 0] = 0
        key = hashlib.blake2b(canvas.tobytes(), digest_size=16).hexdigest()
        is_filled = bool((canvas[..., 3] == np.iinfo(canvas.dtype).max).all())
        png = encode_rgba_png(canvas) if self._is_new(who, key) else None
        return DrawnLayer(who, part.opacity, part.multiply, key, png, is_filled)

    def _is_new(self, who: Who, key: str) -> bool:
        with self._lock:
            is_new = (who, key) not in self._packed
            self._packed.add((who, key))
            return is_new


def flat_parts(image: LayeredImage) -> Iterator[tuple[Who, LayerPart]]:
    """Yield the layers of a picture from the bottom; those of a group are one, their alphas united by maximum."""
    for group, members in groupby(image.parts, key=lambda part: part.group):
        if group is None:
            yield from ((Who(part.name), part) for part in members)
        else:
            yield Who(group.name, is_group=True), _united(tuple(members), group.opacity, multiply=group.multiply)


def _united(parts: tuple[LayerPart, ...], opacity: float, *, multiply: bool) -> LayerPart:
    """Return shadows of one colour as one layer."""
    seen = [part for part in parts if not part.box.is_empty]
    box = around(*[part.box for part in seen])
    if box is None:
        return replace(parts[0], opacity=opacity, multiply=multiply)
    pixels = np.zeros((box.height, box.width, 4), parts[0].pixels.dtype)
    for part in seen:
        own = part.box.moved(-box.left, -box.top)
        place = pixels[own.top : own.bottom, own.left : own.right]
        place[...] = np.where(part.pixels[..., 3:] > place[..., 3:], part.pixels, place)
    return LayerPart(parts[0].name, pixels, box, opacity, multiply)
