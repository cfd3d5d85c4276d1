"""Photoshop documents packed in memory: RGB layers and groups, their blend mode and opacity, and the merged picture.

A document of 16 bit is laid out as Photoshop lays it out: the place where layers of 8 bit stand is empty, and they
stand in a block of their own behind it, before any other.
"""

import io
from collections.abc import Iterator
from itertools import groupby
from typing import Any, Final, TypeAlias

import numpy as np
from numpy.typing import NDArray
from psd_tools.constants import BlendMode, ChannelID, ColorMode, Compression, Resource, SectionDivider, Tag
from psd_tools.psd import PSD
from psd_tools.psd.header import FileHeader
from psd_tools.psd.image_data import ImageData
from psd_tools.psd.image_resources import ImageResource
from psd_tools.psd.layer_and_mask import (
    ChannelData,
    ChannelDataList,
    ChannelImageData,
    ChannelInfo,
    GlobalLayerMaskInfo,
    LayerAndMaskInformation,
    LayerInfo,
    LayerRecord,
    LayerRecords,
    MaskData,
)
from psd_tools.psd.tagged_blocks import TaggedBlocks

from kagezou.geometry.box import Box
from kagezou.io.pixels.layers import LayeredImage, LayerPart, PartGroup, Pixels
from kagezou.io.psd.srgb_profile import srgb_profile

LARGEST_SIDE_PX: Final = 30000
_Layer: TypeAlias = tuple[LayerRecord, ChannelDataList]
"""What a document says of a layer, and its planes."""
_CHANNELS: Final = (ChannelID.CHANNEL_0, ChannelID.CHANNEL_1, ChannelID.CHANNEL_2, ChannelID.TRANSPARENCY_MASK)


def packed_psd(image: LayeredImage) -> bytes:
    """Return the Photoshop document of ``image``.

    Raises
    ------
    ValueError
        The canvas is larger than the format allows.
    """
    if max(image.width_px, image.height_px) > LARGEST_SIDE_PX:
        raise ValueError(f"a Photoshop document has at most {LARGEST_SIDE_PX} px a side")
    header = FileHeader(
        version=1,
        channels=4,
        height=image.height_px,
        width=image.width_px,
        depth=image.depth,
        color_mode=ColorMode.RGB,
    )
    # In 16 bit, too, the merged picture has run lengths at most: readers of nothing but that picture know no others.
    merged = ImageData(compression=Compression.RLE)
    merged.set_data([_stored(plane) for plane in np.moveaxis(_on_white(image), 2, 0)], header)
    document = PSD(header=header, layer_and_mask_information=_layers(image), image_data=merged)
    if image.depth == 16:
        # Krita takes 16 bit without a profile for linear light.
        profile = ImageResource(key=Resource.ICC_PROFILE, data=srgb_profile())
        document.image_resources[Resource.ICC_PROFILE] = profile
    stream = io.BytesIO()
    document.write(stream)
    return stream.getvalue()


def _in_depth(pixels: NDArray[Any], depth: int) -> NDArray[Any]:
    """Return ``uint8`` or ``uint16`` pixels of any shape in 8 or 16 bit; 16 become 8 rounded."""
    if pixels.dtype.itemsize * 8 == depth:
        return pixels
    if depth == 8:
        return ((pixels.astype(np.uint32) + 128) // 257).astype(np.uint8)
    return pixels.astype(np.uint16) * np.uint16(257)


def _stored(plane: NDArray[Any]) -> bytes:
    """Return a plane (h, w) as documents hold its numbers, the high byte first."""
    return plane.astype(plane.dtype.newbyteorder(">")).tobytes()


def _on_white(image: LayeredImage) -> NDArray[Any]:
    """Return the merged picture (H, W, 4) as such documents hold it: colours laid on white, and alpha beside them."""
    form, wide = (np.uint8, np.uint16) if image.depth == 8 else (np.uint16, np.uint32)
    full = int(np.iinfo(form).max)
    if image.merged is None:
        return np.full((image.height_px, image.width_px, 4), (full, full, full, 0), form)
    merged: NDArray[Any] = _in_depth(image.merged, image.depth).astype(wide)
    alpha = merged[..., 3:]
    merged[..., :3] = (merged[..., :3] * alpha + full * (full - alpha) + full // 2) // full
    return merged.astype(form)


def _layers(image: LayeredImage) -> LayerAndMaskInformation:
    """Return the layers where a document of the depth has them."""
    layers = list(_records(image))
    records: Any = [record for record, _ in layers]
    planes: Any = [each for _, each in layers]
    content: Any = {
        # A negative count says that the fourth channel of the merged picture is its alpha.
        "layer_count": -len(layers),
        "layer_records": LayerRecords(records),
        "channel_image_data": ChannelImageData(planes),
    }
    if image.depth == 8:
        return LayerAndMaskInformation(LayerInfo(**content))
    blocks = TaggedBlocks()
    # GIMP 2.10 looks for the layers in the very first block.
    blocks.set_data(Tag.LAYER_16, **content)
    blocks.set_data(Tag.SAVING_MERGED_TRANSPARENCY16)
    return LayerAndMaskInformation(LayerInfo(), GlobalLayerMaskInfo(), blocks)


def _records(image: LayeredImage) -> Iterator[_Layer]:
    """Yield the layers from the bottom; those of a group lie between its lower end and the group itself."""
    for group, parts in groupby(image.parts, key=lambda part: part.group):
        if group is not None:
            yield _end_of_group()
        yield from (_layer(part, image.depth) for part in parts)
        if group is not None:
            yield _group(group, image.depth)


def _end_of_group() -> _Layer:
    """Return the hidden layer at the lower end of a group, which all readers know by its kind alone."""
    planes: Any = [ChannelData() for _ in _CHANNELS]
    kinds = [ChannelInfo(kind, 2) for kind in _CHANNELS]
    record = LayerRecord(channel_info=kinds, name="</Layer group>")
    record.tagged_blocks.set_data(Tag.UNICODE_LAYER_NAME, "</Layer group>")
    record.tagged_blocks.set_data(Tag.SECTION_DIVIDER_SETTING, SectionDivider.BOUNDING_SECTION_DIVIDER)
    return record, ChannelDataList(planes)


def _group(group: PartGroup, depth: int) -> _Layer:
    """Return a group, with its mask where it has one; its layers are laid on each other before it is laid."""
    nothing: Pixels = np.zeros((0, 0, 4), np.uint8)
    part = LayerPart(group.name, nothing, Box(0, 0, 0, 0), group.opacity, group.multiply)
    record, planes = _layer(part, depth)
    record.tagged_blocks.set_data(Tag.SECTION_DIVIDER_SETTING, SectionDivider.OPEN_FOLDER, blend_mode=record.blend_mode)
    if group.mask is not None and group.mask_box is not None:
        plane, box = _plane(_in_depth(group.mask, depth)), group.mask_box
        planes.append(plane)
        record.channel_info.append(ChannelInfo(ChannelID.USER_LAYER_MASK, 2 + len(plane.data)))
        record.mask_data = MaskData(
            top=box.top, left=box.left, bottom=box.bottom, right=box.right, background_color=255
        )
    return record, planes


def _layer(part: LayerPart, depth: int) -> _Layer:
    """Return what a document says of a layer, and its planes."""
    box = part.box
    pixels = _in_depth(part.pixels, depth)
    planes: Any = [ChannelData() if box.is_empty else _plane(pixels[..., index]) for index in range(4)]
    record = LayerRecord(
        top=0 if box.is_empty else box.top,
        left=0 if box.is_empty else box.left,
        bottom=0 if box.is_empty else box.bottom,
        right=0 if box.is_empty else box.right,
        channel_info=[ChannelInfo(kind, 2 + len(plane.data)) for kind, plane in zip(_CHANNELS, planes, strict=True)],
        blend_mode=BlendMode.MULTIPLY if part.multiply else BlendMode.NORMAL,
        opacity=round(255 * min(max(part.opacity, 0.0), 1.0)),
        # Old readers know this name alone, which has at most 255 bytes of an encoding without Japanese.
        name=part.name.encode("ascii", "replace").decode()[:250],
    )
    record.tagged_blocks.set_data(Tag.UNICODE_LAYER_NAME, part.name)
    return record, ChannelDataList(planes)


def _plane(pixels: NDArray[Any]) -> ChannelData:
    """Return one channel (h, w) of a layer.

    In run lengths, which every reader unpacks: differences, as Photoshop writes them for 16 bit, Krita misreads, and
    OpenImageIO what is deflated plainly.
    """
    height, width = pixels.shape
    plane = ChannelData(compression=Compression.RLE)
    plane.set_data(_stored(pixels), width, height, pixels.dtype.itemsize * 8)
    return plane
