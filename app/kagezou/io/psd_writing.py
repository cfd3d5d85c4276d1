"""Photoshop documents packed in memory: 8 bit RGB, layers with their blend mode and opacity, and the merged picture."""

import io
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray
from psd_tools.constants import BlendMode, ChannelID, ColorMode, Compression, Tag
from psd_tools.psd import PSD
from psd_tools.psd.header import FileHeader
from psd_tools.psd.image_data import ImageData
from psd_tools.psd.layer_and_mask import (
    ChannelData,
    ChannelDataList,
    ChannelImageData,
    ChannelInfo,
    LayerAndMaskInformation,
    LayerInfo,
    LayerRecord,
    LayerRecords,
)

from kagezou.io.layered import LayeredImage, Part

LARGEST_SIDE_PX: Final = 30000
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
        version=1, channels=4, height=image.height_px, width=image.width_px, depth=8, color_mode=ColorMode.RGB
    )
    layers = [_layer(part) for part in image.parts]
    records: Any = [record for record, _ in layers]
    planes: Any = [each for _, each in layers]
    info = LayerInfo(
        # A negative count says that the fourth channel of the merged picture is its alpha.
        layer_count=-len(layers),
        layer_records=LayerRecords(records),
        channel_image_data=ChannelImageData(planes),
    )
    merged = ImageData(compression=Compression.RLE)
    merged.set_data([plane.tobytes() for plane in np.moveaxis(_on_white(image), 2, 0)], header)
    document = PSD(
        header=header, layer_and_mask_information=LayerAndMaskInformation(layer_info=info), image_data=merged
    )
    stream = io.BytesIO()
    document.write(stream)
    return stream.getvalue()


def eight_bit(pixels: NDArray[Any]) -> NDArray[np.uint8]:
    """Return ``uint8`` or ``uint16`` pixels of any shape in 8 bit, rounded."""
    if pixels.dtype == np.uint8:
        return pixels
    return ((pixels.astype(np.uint32) + 128) // 257).astype(np.uint8)


def _on_white(image: LayeredImage) -> NDArray[np.uint8]:
    """Return the merged picture (H, W, 4) as such documents hold it: colours laid on white, and alpha beside them."""
    if image.merged is None:
        return np.full((image.height_px, image.width_px, 4), (255, 255, 255, 0), np.uint8)
    merged = eight_bit(image.merged).astype(np.uint16)
    alpha = merged[..., 3:]
    merged[..., :3] = (merged[..., :3] * alpha + 255 * (255 - alpha) + 127) // 255
    return merged.astype(np.uint8)


def _layer(part: Part) -> tuple[LayerRecord, ChannelDataList]:
    """Return what a document says of a layer, and its planes."""
    box = part.box
    planes: Any = [_plane(part, index) for index in range(4)]
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


def _plane(part: Part, index: int) -> ChannelData:
    if part.box.is_empty:
        return ChannelData(compression=Compression.RAW)
    plane = ChannelData(compression=Compression.RLE)
    plane.set_data(eight_bit(part.pixels)[..., index].tobytes(), part.box.width, part.box.height, 8)
    return plane
