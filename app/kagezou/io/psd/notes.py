"""What of a PSD file is not used, and what had to be assumed, beside what cannot be drawn of single layers."""

# ruff: noqa: SLF001 - some of it is told by psd-tools' inner records only

import struct
from collections.abc import Iterable, Iterator
from io import BytesIO
from typing import Any, Final

from kagezou.io.psd.comparing import LEAST_LEVELS, Hindrance, difference, hindrance
from kagezou.io.psd.masks import has_soft_path
from kagezou.io.psd.stored import GRAY, RGB
from kagezou.message import Message, first_names

_WHOLE_RANGE: Final = (0, 65535)
_FRAMES: Final = b"FrInVlLs"
"""Before the number of the frames of an animation."""

_UNCOMPARED: Final = {
    Hindrance.NO_PICTURE: Message("no picture was saved with its layers, so they could not be compared with one"),
    Hindrance.EMPTY: Message("the picture saved with its layers is empty, so they could not be compared with it"),
    Hindrance.OTHER: Message("its layers were not compared with the picture in it: it is too large or not in RGB"),
}

_USUAL: Final = "srgb"
"""In the name of a profile by which colours are taken anyway."""


def notes_on(image: Any) -> tuple[Message, ...]:
    """Return what is to be said about a file of psd-tools; to compare it with its picture takes as long as drawing it.

    Layers left out and effects that cannot be drawn are told with the layers.
    """
    layers = list(image.descendants())
    found = [*_of_file(image), *_of_layers(layers)]
    if layers:
        found += _of_picture(image)
    return tuple(found)


def _of_file(image: Any) -> Iterator[Message]:
    from psd_tools.api.utils import has_transparency
    from psd_tools.constants import Resource

    resources = image.image_resources
    profile = _profile_name(resources.get_data(Resource.ICC_PROFILE))
    if profile and _USUAL not in profile.lower() and image.color_mode.value in {GRAY, RGB}:
        yield Message("its colour profile {profile!r} is not used: colours are taken as sRGB", profile=profile)
    names = resources.get_data(Resource.ALPHA_NAMES_UNICODE) or resources.get_data(Resource.ALPHA_NAMES_PASCAL) or []
    # The first is the transparency of the whole picture, by its name in the language of the program.
    extra = [str(name).strip("\0") for name in list(names)[has_transparency(image) :]]
    if extra and len(image):
        yield Message("extra channels are not used: {names}", names=first_names(extra))
    count = _animation_frames(resources)
    if count > 1:
        yield Message("its animation of {count} frames is not used: layers count as they are visible now", count=count)
    if _has_comps(resources.get_data(Resource.LAYER_COMPS)):
        yield Message("its layer comps are not used: layers count as they are visible now")


def _has_comps(comps: Any) -> bool:
    try:
        return len(comps[b"list"]) > 0
    except (KeyError, TypeError):
        return False


def _animation_frames(resources: Any) -> int:
    """Return how many frames the animation of a file has; 0 where there is none."""
    for number, resource in resources.items():
        data = getattr(resource, "data", b"")
        if 4000 <= number < 5000 and isinstance(data, bytes) and (at := data.find(_FRAMES)) >= 0:
            return int(struct.unpack(">I", data[at + 8 : at + 12].ljust(4, b"\0"))[0])
    return 0


def _profile_name(data: Any) -> str:
    if not isinstance(data, bytes):
        return ""
    from PIL import ImageCms

    try:
        return str(ImageCms.getProfileDescription(ImageCms.ImageCmsProfile(BytesIO(data)))).strip()
    except (ImageCms.PyCMSError, OSError, ValueError):
        return "?"


def _of_layers(layers: Iterable[Any]) -> Iterator[Message]:
    seen = [layer for layer in layers if layer.visible]
    soft = [str(layer.name) for layer in seen if has_soft_path(layer)]
    if soft:
        yield Message("the soft edges of drawn shapes are not done: {names}", names=first_names(soft))
    ranges = [str(layer.name) for layer in seen if _blends_by_brightness(layer)]
    if ranges:
        yield Message("blending by brightness is not done: {names}", names=first_names(ranges))
    names = [str(layer.name) for layer in seen if layer.is_group() and layer.clipping]
    if names:
        yield Message(
            "groups are clipped to the layer below them, as Clip Studio Paint does: {names}", names=first_names(names)
        )


def _blends_by_brightness(layer: Any) -> bool:
    ranges = layer._record.blending_ranges
    every = [*(ranges.composite_ranges or ()), *(each for pair in ranges.channel_ranges or () for each in pair)]
    return any(tuple(each) not in {_WHOLE_RANGE, (0, 0)} for each in every)


def _of_picture(image: Any) -> Iterator[Message]:
    why = hindrance(image)
    if why in {Hindrance.NO_PICTURE, Hindrance.OTHER}:
        yield _UNCOMPARED[why]
        return
    found = difference(image)
    if found.is_seen and why is Hindrance.EMPTY:
        yield _UNCOMPARED[why]
    elif found.is_seen:
        yield Message(
            "its layers, put together here, differ from the picture saved with them by up to {levels:.0f} of 255 "
            "levels; by more than {least} in {share:.1%} of the picture",
            levels=found.levels,
            least=LEAST_LEVELS,
            share=found.share,
        )
