"""Picture files of every kind, written without the code under test."""

import struct
import zlib
from pathlib import Path
from typing import Any

import numpy as np
import OpenImageIO as oiio  # noqa: N813  # the name its own manual uses
from numpy.typing import NDArray

Pixels = NDArray[Any]
STRAIGHT = "oiio:UnassociatedAlpha"
_TYPES = {
    "uint8": oiio.UINT8,
    "uint16": oiio.UINT16,
    "uint32": oiio.UINT32,
    "float16": oiio.HALF,
    "float32": oiio.FLOAT,
}
_SETTINGS: dict[str, dict[str, Any]] = {
    ".tif": {"compression": "zip", "tiff:write_exif": 0},
    ".tiff": {"compression": "zip", "tiff:write_exif": 0},
    ".webp": {"compression": "lossless:100"},
    ".tga": {"compression": "rle"},
}


def save(path: Path, pixels: Pixels, *, straight: bool = True, names: tuple[str, ...] = (), **settings: Any) -> None:
    """Write (H, W, C) by OpenImageIO; ``settings`` use ``__`` for a colon."""
    height, width, channels = pixels.shape
    spec = oiio.ImageSpec(width, height, channels, _TYPES[pixels.dtype.name])
    if names:
        spec.channelnames = names
        spec.alpha_channel = names.index("A") if "A" in names else -1
    if straight:
        spec.attribute(STRAIGHT, 1)
    given: dict[str, Any] = {name.replace("__", ":"): value for name, value in settings.items()}
    for name, value in (_SETTINGS.get(path.suffix.lower(), {}) | given).items():
        spec.attribute(name, value)
    out = oiio.ImageOutput.create(str(path))
    assert out is not None, oiio.geterror()
    assert out.open(str(path), spec), out.geterror()
    assert out.write_image(np.ascontiguousarray(pixels)), out.geterror()
    assert out.close(), out.geterror()


def save_exr_window(path: Path, pixels: Pixels, place: tuple[int, int], display: tuple[int, int, int, int]) -> None:
    """Write half floats whose data window starts at ``place`` while the canvas is ``display``: left, top, w, h."""
    height, width, channels = pixels.shape
    spec = oiio.ImageSpec(width, height, channels, oiio.HALF)
    spec.x, spec.y = place
    spec.full_x, spec.full_y, spec.full_width, spec.full_height = display
    out = oiio.ImageOutput.create(str(path))
    assert out is not None
    assert out.open(str(path), spec)
    assert out.write_image(pixels)
    assert out.close()


def read_back(path: Path) -> Pixels:
    """Return the straight stored numbers, (H, W, C)."""
    config = oiio.ImageSpec()
    config.attribute(STRAIGHT, 1)
    source = oiio.ImageInput.open(str(path), config)
    assert source is not None, oiio.geterror()
    spec = source.spec()
    pixels = source.read_image(0, 0, 0, spec.nchannels, spec.format)
    assert pixels is not None, source.geterror()
    return pixels


def chunk(kind: bytes, body: bytes) -> bytes:
    """Return one PNG chunk."""
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))


def png(size: tuple[int, int], bits: int, kind: int, rows: bytes, extra: bytes = b"") -> bytes:
    """Return a PNG of given header and unpacked, already filtered ``rows``."""
    head = struct.pack(">IIBBBBB", *size, bits, kind, 0, 0, 0)
    parts = chunk(b"IHDR", head), extra, chunk(b"IDAT", zlib.compress(rows)), chunk(b"IEND", b"")
    return b"\x89PNG\r\n\x1a\n" + b"".join(parts)


def tga(size: tuple[int, int], bits: int, attributes: int, body: bytes, alpha_type: int | None = None) -> bytes:
    """Return an uncompressed TGA; ``alpha_type`` adds the footer of version 2."""
    head = bytes([0, 0, 2]) + bytes(9) + struct.pack("<HHBB", *size, bits, attributes)
    if alpha_type is None:
        return head + body
    area = struct.pack("<H", 495) + bytes(492) + bytes([alpha_type])
    return head + body + area + struct.pack("<II", 18 + len(body), 0) + b"TRUEVISION-XFILE.\0"


def bmp32(size: tuple[int, int], body: bytes) -> bytes:
    """Return a 32-bit BMP of the old header, in which the fourth byte has no meaning."""
    head = struct.pack("<IiiHHIIiiII", 40, *size, 1, 32, 0, len(body), 0, 0, 0, 0)
    return b"BM" + struct.pack("<IHHI", 54 + len(body), 0, 0, 54) + head + body
