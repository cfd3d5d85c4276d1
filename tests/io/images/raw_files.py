"""TGA and TIFF files of every kind, written in few lines, so that no decoder is believed about its own writing."""

import struct
import zlib
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

Pixels = NDArray[Any]
SHORT, LONG, BYTES = 3, 4, 7
PALETTE, COLOUR, GRAY = 1, 2, 3
_LETTERS = {SHORT: "H", LONG: "I"}
Tag = tuple[int, int, list[int] | bytes]


@dataclass(frozen=True)
class TgaWays:
    """How a TGA is stored; ``origin`` is 0 to 3 as in the header."""

    bits: int
    attributes: int = 0
    origin: int = 0
    rle: bool = False
    palette: bytes = b""
    palette_bits: int = 0
    first: int = 0


def tga(stored: Pixels, kind: int, **ways: Any) -> bytes:
    """Return a TGA of ``stored``, (H, W, bytes of a pixel) from the top left, stored by `TgaWays`."""
    way = TgaWays(**ways)
    height, width = stored.shape[:2]
    rows = stored if way.origin & 2 else stored[::-1]
    rows = rows[:, ::-1] if way.origin & 1 else rows
    body = b"".join(_packets(row) for row in rows) if way.rle else rows.tobytes()
    count = len(way.palette) // ((way.palette_bits + 7) // 8) if way.palette else 0
    head = struct.pack(
        "<BBBHHBHHHHBB",
        3, bool(way.palette), kind + 8 * way.rle, way.first, count, way.palette_bits, 0, 0, width, height, way.bits,
        way.attributes | way.origin << 4,
    )  # fmt: skip
    return head + b"id!" + way.palette + body


def _packets(row: Pixels) -> bytes:
    """Return a row of TGA as packets, some of runs and some of single pixels."""
    out, at, width = b"", 0, len(row)
    while at < width:
        run = 1
        while at + run < width and run < 128 and (row[at + run] == row[at]).all():
            run += 1
        out += bytes([127 + run if run > 1 else 0]) + row[at].tobytes()
        at += run
    return out


def bytes_of(numbers: Pixels) -> Pixels:
    """Return 16-bit numbers (H, W) as their bytes (H, W, 2), the lower first."""
    return numbers.astype("<u2")[..., None].view(np.uint8)


@dataclass(frozen=True)
class TiffWays:
    """How a TIFF is stored; ``kind`` is 1 for unsigned, 2 for signed, 3 for floating numbers."""

    extras: tuple[int, ...] = ()
    big: bool = False
    separate: bool = False
    packing: int = 1
    kind: int = 1
    rows: int | None = None
    tile: int | None = None
    more: tuple[Tag, ...] = ()


def tiff(pages: Pixels | Sequence[Pixels], photometric: int, bits: int, **ways: Any) -> bytes:
    """Return a TIFF of pages (H, W, S), stored by `TiffWays`."""
    way = TiffWays(**ways)
    order: Literal["<", ">"] = ">" if way.big else "<"
    data = (b"MM" if way.big else b"II") + struct.pack(f"{order}HI", 42, 0)
    link = 4
    for page in [pages] if isinstance(pages, np.ndarray) else pages:
        height, width, count = page.shape
        offsets, sizes = [], []
        for part in _parts(page, way.tile, way.rows or height, separate=way.separate):
            body = _packed(_stored(part, bits, way.kind, order), way.packing)
            offsets.append(len(data))
            sizes.append(len(body))
            data += body + b"\0" * (len(body) % 2)
        tags: list[Tag] = [
            (256, LONG, [width]), (257, LONG, [height]), (258, SHORT, [bits] * count), (259, SHORT, [way.packing]),
            (262, SHORT, [photometric]), (277, SHORT, [count]), (284, SHORT, [1 + way.separate]),
            (339, SHORT, [way.kind] * count), *way.more,
        ]  # fmt: skip
        if way.extras:
            tags.append((338, SHORT, list(way.extras)))
        if way.tile:
            tags += [(322, LONG, [way.tile]), (323, LONG, [way.tile]), (324, LONG, offsets), (325, LONG, sizes)]
        else:
            tags += [(278, LONG, [way.rows or height]), (273, LONG, offsets), (279, LONG, sizes)]
        data = data[:link] + struct.pack(f"{order}I", len(data)) + data[link + 4 :]
        directory, link = _directory(sorted(tags, key=lambda tag: tag[0]), len(data), order)
        data += directory
    return data


def _parts(page: Pixels, tile: int | None, rows: int, *, separate: bool) -> list[Pixels]:
    planes = [page[..., each : each + 1] for each in range(page.shape[2])] if separate else [page]
    found = []
    for plane in planes:
        if tile is None:
            found += [plane[top : top + rows] for top in range(0, plane.shape[0], rows)]
            continue
        for top in range(0, plane.shape[0], tile):
            for left in range(0, plane.shape[1], tile):
                part = plane[top : top + tile, left : left + tile]
                found.append(np.pad(part, [(0, tile - part.shape[0]), (0, tile - part.shape[1]), (0, 0)]))
    return found


def _stored(part: Pixels, bits: int, kind: int, order: Literal["<", ">"]) -> bytes:
    if bits >= 8 and bits % 8 == 0:
        dtype = np.dtype(f"{'?uif'[kind]}{bits // 8}").newbyteorder(order)
        return part.astype(dtype).tobytes()
    places = np.arange(bits - 1, -1, -1)
    rows = ((part.reshape(len(part), -1, 1).astype(np.int64) >> places) & 1).astype(np.uint8).reshape(len(part), -1)
    return np.packbits(rows, axis=1).tobytes()


def _packed(body: bytes, packing: int) -> bytes:
    if packing == 8:
        return zlib.compress(body)
    if packing == 32773:
        return b"".join(
            bytes([len(part) - 1]) + part for part in (body[at : at + 128] for at in range(0, len(body), 128))
        )
    return body


def _directory(tags: list[Tag], at: int, order: str) -> tuple[bytes, int]:
    """Return a directory that lies at ``at``, and where in the file its link to the next one is."""
    entries, behind = struct.pack(f"{order}H", len(tags)), b""
    link = at + 2 + 12 * len(tags)
    for number, kind, values in tags:
        body = values if isinstance(values, bytes) else struct.pack(f"{order}{len(values)}{_LETTERS[kind]}", *values)
        field = body.ljust(4, b"\0")
        if len(body) > 4:
            field = struct.pack(f"{order}I", link + 4 + len(behind))
            behind += body + b"\0" * (len(body) % 2)
        entries += struct.pack(f"{order}HHI", number, kind, len(values)) + field
    return entries + bytes(4) + behind, link
