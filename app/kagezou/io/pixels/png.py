"""PNG packed in memory: rows filtered simply and deflated fast, the same bytes for the same picture.

A shadow layer is one colour under an alpha that is clear outside a box. As differences to the row above it is zero
everywhere but in its first row and in the box, so a row buffer per thread is prepared once; a frame then writes its
colour and its box alone and wipes the box of the frame before.
"""

import struct
import threading
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from kagezou.geometry.box import Box
from kagezou.io.pixels.deflating import crc32, packed_fast, packed_small

Pixels = NDArray[Any]
Color = tuple[int, int, int]
_SIGNATURE: Final = b"\x89PNG\r\n\x1a\n"
_RGBA: Final = 6
_PERCEPTUAL: Final = b"\0"
_SAMPLE_STEP: Final = 16
_NO_FILTER: Final = 0
_LEFT_FILTER: Final = 1
_UP_FILTER: Final = 2


class _Buffers(threading.local):
    """The rows that this thread wrote last, their pixels' bytes (H, W, 4, depth), and where alpha is not blank."""

    key: tuple[int, int, str] | None = None
    rows: NDArray[np.uint8]
    pixels: NDArray[np.uint8]
    written: tuple[slice, slice] = (slice(0, 0), slice(0, 0))


_buffers = _Buffers()


def pack_layer(size_px: tuple[int, int], color: Color, alpha: Pixels, box: Box) -> bytes:
    """Return a PNG of one colour everywhere, with ``alpha`` in ``box`` and clear outside.

    Parameters
    ----------
    size_px
        Width and height.
    color
        Red, green and blue, sRGB 8 bit.
    alpha
        (box.height, box.width) ``uint8`` or ``uint16``; it chooses the depth.
    box
        Its place, canvas px, y down, inside the canvas.
    """
    width, height = size_px
    buffers = _buffers
    key = (width, height, alpha.dtype.name)
    if buffers.key != key:
        buffers.key = None
        buffers.rows, buffers.pixels = _blank_rows(width, height, alpha.dtype)
        buffers.key = key
    else:
        buffers.pixels[*buffers.written, 3] = 0
    buffers.pixels[0, :, :3] = np.asarray(color, np.uint8)[:, None]
    buffers.written = slice(box.top, box.bottom + 1), slice(box.left, box.right)
    _difference(alpha, buffers.pixels[*buffers.written, 3])
    return _packed(size_px, alpha.dtype.itemsize * 8, packed_small(buffers.rows))


def pack_rgba(rgba: Pixels) -> bytes:
    """Return a PNG of straight sRGB (H, W, 4) ``uint8`` or ``uint16``.

    Rows are kept as they are or, where a sample of them says that it is smaller, as differences to the left.
    """
    height, width = rgba.shape[:2]
    bits = rgba.dtype.itemsize * 8
    step = rgba.dtype.itemsize * 4
    plain = np.ascontiguousarray(rgba, rgba.dtype.newbyteorder(">")).view(np.uint8).reshape(height, width * step)
    sample = plain[::_SAMPLE_STEP]
    kept, differences = _rows(sample, _NO_FILTER, step), _rows(sample, _LEFT_FILTER, step)
    smaller = len(packed_fast(differences)) < len(packed_fast(kept))
    rows = _rows(plain, _LEFT_FILTER if smaller else _NO_FILTER, step)
    return _packed((width, height), bits, packed_fast(rows))


def _blank_rows(width: int, height: int, dtype: np.dtype[Any]) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:
    """Return the differences of clear black rows, and a view (H, W, 4, depth) on their pixels."""
    rows = np.zeros((height, 1 + width * 4 * dtype.itemsize), np.uint8)
    rows[:, 0] = _UP_FILTER
    return rows, rows[:, 1:].reshape(height, width, 4, dtype.itemsize)


def _difference(alpha: Pixels, out: NDArray[np.uint8]) -> None:
    """Put the bytewise differences of ``alpha`` (h, w) to the row above into ``out`` (h or h + 1, w, depth).

    The row after the last, where the canvas has one, leads back to clear.
    """
    height, width = alpha.shape
    if alpha.size == 0:
        return
    big_endian = np.ascontiguousarray(alpha, alpha.dtype.newbyteorder(">"))
    plain = big_endian.view(np.uint8).reshape(height, width, alpha.dtype.itemsize)
    out[0] = plain[0]
    np.subtract(plain[1:], plain[:-1], out=out[1:height])
    if len(out) > height:
        np.negative(plain[-1], out=out[height])


def _rows(plain: NDArray[np.uint8], kind: int, step: int) -> NDArray[np.uint8]:
    """Return (H, W·step) bytes as rows led by their filter: none, or the difference to ``step`` bytes before."""
    rows = np.empty((plain.shape[0], 1 + plain.shape[1]), np.uint8)
    rows[:, 0] = kind
    if kind == _NO_FILTER:
        rows[:, 1:] = plain
    else:
        rows[:, 1 : 1 + step] = plain[:, :step]
        np.subtract(plain[:, step:], plain[:, :-step], out=rows[:, 1 + step :])
    return rows


def _packed(size_px: tuple[int, int], bits: int, rows: bytes) -> bytes:
    return b"".join(
        (
            _SIGNATURE,
            *_chunk(b"IHDR", struct.pack(">IIBBBBB", *size_px, bits, _RGBA, 0, 0, 0)),
            *_chunk(b"sRGB", _PERCEPTUAL),
            *_chunk(b"IDAT", rows),
            *_chunk(b"IEND", b""),
        )
    )


def _chunk(kind: bytes, body: bytes) -> tuple[bytes, ...]:
    check = crc32(body, crc32(kind))
    return struct.pack(">I", len(body)), kind, body, struct.pack(">I", check)
