"""Photoshop documents, read back by psd-tools and OpenImageIO: the numbers, the names and the places."""

import struct
from pathlib import Path
from typing import Any

import hypothesis.strategies as st
import numpy as np
import OpenImageIO as oiio  # noqa: N813  # the name its own manual uses
import pytest
from hypothesis import HealthCheck, given, settings
from numpy.typing import NDArray
from psd_tools import PSDImage
from psd_tools.constants import BlendMode, ChannelID

from kagezou.geometry.box import Box
from kagezou.io.images.layered import write_layered
from kagezou.io.images.reading import probe, read_cel
from kagezou.io.pixels.layers import LayeredImage, LayerPart
from kagezou.io.psd.file import psd_tree
from kagezou.io.psd.writing import packed_psd
from kagezou.picture_source import PicturePart
from tests.effort import tries

DTYPES = {8: np.uint8, 16: np.uint16}


def noise(seed: int, *shape: int, dtype: Any = np.uint16) -> NDArray[Any]:
    return np.random.default_rng(seed).integers(0, np.iinfo(dtype).max + 1, shape).astype(dtype)


def in_depth(pixels: NDArray[Any], depth: int) -> NDArray[Any]:
    """Return pixels in another depth by the nearest number, in float64."""
    full = np.iinfo(pixels.dtype).max
    return np.rint(pixels / full * ((1 << depth) - 1)).astype(DTYPES[depth])


def stored(layer: Any, depth: int) -> NDArray[Any]:
    """Return a layer's very numbers (h, w, 4)."""
    order = [ChannelID.CHANNEL_0, ChannelID.CHANNEL_1, ChannelID.CHANNEL_2, ChannelID.TRANSPARENCY_MASK]
    found = {
        info.id: np.frombuffer(data.get_data(layer.width, layer.height, depth, 1), f">u{depth // 8}")
        for info, data in zip(layer._record.channel_info, layer._channels, strict=True)
    }
    return np.stack([found[each].reshape(layer.height, layer.width) for each in order], axis=-1)


@st.composite
def parts(draw: st.DrawFn, width: int, height: int, number: int) -> LayerPart:
    """A layer anywhere on the canvas, also along its edges, or nowhere; its name begins with its number."""
    left, right = sorted(draw(st.tuples(st.integers(0, width), st.integers(0, width))))
    top, bottom = sorted(draw(st.tuples(st.integers(0, height), st.integers(0, height))))
    box = Box(left, top, right, bottom)
    dtype = draw(st.sampled_from([np.uint8, np.uint16]))
    shape = (0, 0, 4) if box.is_empty else (box.height, box.width, 4)
    pixels = noise(draw(st.integers(0, 99)), *shape, dtype=dtype)
    letters = st.sampled_from("aZ 影主役Ａé🦊_/#%")
    name = f"{number}{draw(st.text(letters, max_size=9))}" * draw(st.sampled_from([1, 1, 40]))
    return LayerPart(name, pixels, box, draw(st.sampled_from([0.0, 0.5, 1.0])), multiply=draw(st.booleans()))


@st.composite
def images(draw: st.DrawFn) -> LayeredImage:
    width, height = draw(st.integers(1, 12)), draw(st.integers(1, 12))
    layers = tuple(draw(parts(width, height, number)) for number in range(draw(st.integers(1, 4))))
    depth = draw(st.sampled_from([8, 16]))
    merged = draw(st.sampled_from([None, noise(7, height, width, 4, dtype=DTYPES[depth])]))
    return LayeredImage(width, height, layers, merged, depth)


@given(images())
@settings(max_examples=tries(25, 80), deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_what_is_written_is_read_back(tmp_path: Path, image: LayeredImage) -> None:
    path = tmp_path / "a.psd"
    write_layered(path, image)
    assert path.read_bytes() == packed_psd(image)
    document = PSDImage.open(path)
    assert (document.width, document.height, document.depth) == (image.width_px, image.height_px, image.depth)
    assert [each.name for each in document] == [part.name for part in image.parts]
    for layer, part in zip(document, image.parts, strict=True):
        box = Box(0, 0, 0, 0) if part.box.is_empty else part.box
        assert layer.bbox == (box.left, box.top, box.right, box.bottom)
        assert layer.opacity == round(255 * part.opacity)
        assert layer.blend_mode == (BlendMode.MULTIPLY if part.multiply else BlendMode.NORMAL)
        assert box.is_empty or np.array_equal(stored(layer, image.depth), in_depth(part.pixels, image.depth))
    plain: Any = document._record.image_data.get_data(document._record.header)
    merged = np.stack([np.frombuffer(plane, f">u{image.depth // 8}") for plane in plain], axis=-1)
    assert np.array_equal(merged.reshape(image.height_px, image.width_px, 4), on_white(image))


def on_white(image: LayeredImage) -> NDArray[Any]:
    """Return the merged picture as a document holds it, in float64."""
    full = (1 << image.depth) - 1
    if image.merged is None:
        return np.full((image.height_px, image.width_px, 4), (full, full, full, 0))
    alpha = image.merged[..., 3:] / full
    laid = np.rint(image.merged[..., :3] * alpha + full * (1 - alpha))
    return np.concatenate([laid, image.merged[..., 3:]], axis=-1)


def test_our_own_reader_gives_the_very_numbers(tmp_path: Path) -> None:
    pixels, merged = noise(1, 5, 7, 4), noise(2, 11, 13, 4)
    merged[..., 3] = 65535
    image = LayeredImage(
        13,
        11,
        (LayerPart("主役/1", pixels, Box(6, 6, 13, 11)), LayerPart("空", pixels[:0], Box(0, 0, 0, 0))),
        merged,
        16,
    )
    write_layered(tmp_path / "a.psd", image)
    nodes = psd_tree(tmp_path / "a.psd").layers
    assert [(node.name, node.is_empty) for node in nodes] == [("主役/1", False), ("空", True)]
    cel = read_cel(PicturePart(tmp_path / "a.psd", nodes[0].address)).rgba
    assert cel.dtype == np.uint16
    assert np.array_equal(cel[6:11, 6:13], pixels)
    assert not cel[:6].any()
    assert np.array_equal(read_cel(tmp_path / "a.psd").rgba, merged)
    assert probe(tmp_path / "a.psd").bit_depth == 16


def test_other_readers_see_16_bit_and_the_merged_alpha(tmp_path: Path) -> None:
    merged = noise(3, 11, 13, 4)
    merged[..., 3] |= 0x8000
    pixels = noise(4, 4, 6, 4)
    write_layered(tmp_path / "a.psd", LayeredImage(13, 11, (LayerPart("a", pixels, Box(2, 3, 8, 7)),), merged, 16))
    source: Any = oiio.ImageInput.open(str(tmp_path / "a.psd"))
    spec = source.spec()
    assert (spec.format, spec.width, spec.height, spec.nchannels, spec.alpha_channel) == (oiio.UINT16, 13, 11, 4, 3)
    picture = source.read_image(0, 0, 0, 4, oiio.UINT16)
    assert np.array_equal(picture[..., 3], merged[..., 3])
    # It gives colours multiplied by alpha, out of colours on white.
    assert np.abs(picture[..., :3] - merged[..., :3] * (merged[..., 3:] / 65535)).max() <= 2
    assert source.seek_subimage(1, 0)
    spec = source.spec()
    assert (spec.format, spec.x, spec.y, spec.width, spec.height) == (oiio.UINT16, 2, 3, 6, 4)
    assert np.array_equal(source.read_image(1, 0, 0, 4, oiio.UINT16)[..., 3], pixels[..., 3])
    source.close()


@pytest.mark.parametrize("depth", [8, 16])
def test_a_document_is_laid_out_as_photoshop_lays_out_its_depth(depth: int) -> None:
    image = LayeredImage(13, 11, (LayerPart("a", noise(4, 4, 6, 4), Box(2, 3, 8, 7)),), None, depth)
    data = packed_psd(image)
    channels, height, width, bits = struct.unpack(">HIIH", data[12:24])
    assert (channels, height, width, bits) == (4, 11, 13, depth)
    (resources,) = struct.unpack(">I", data[30:34])  # behind the header and no colour table
    assert (b"acsp" in data[34 : 34 + resources]) == (depth == 16), "a profile, without which 16 bit count as linear"
    section = data[34 + resources :]
    length, layers = struct.unpack(">II", section[:8])
    assert length % 2 == 0
    if depth == 8:
        assert layers
        assert struct.unpack(">h", section[8:10]) == (-1,)
    else:
        # Neither layers nor a mask for all of them, but two blocks.
        assert section[4:12] == bytes(8)
        assert section[12:20] == b"8BIMLr16"
        assert struct.unpack(">I", section[20:24])[0] <= length - 32 < struct.unpack(">I", section[20:24])[0] + 4
        assert struct.unpack(">h", section[24:26]) == (-1,)
        assert section[length - 8 : length + 4] == b"8BIMMt16" + bytes(4)
