"""Photos with a gain map or other pictures behind them are seen as their first picture, and that is said."""

import io
import struct
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from kagezou.io.images.reading import probe, read_cel

GAIN_MAP = "its gain map for bright screens is not used: it is seen as on other screens"
XMP = (
    b'http://ns.adobe.com/xap/1.0/\0<x:xmpmeta xmlns:x="adobe:ns:meta/"><rdf:RDF '
    b'xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#"><rdf:Description '
    b'xmlns:hdrgm="http://ns.adobe.com/hdr-gain-map/1.0/" hdrgm:Version="1.0"/></rdf:RDF></x:xmpmeta>'
)


def jpeg(pixels: np.ndarray) -> bytes:
    out = io.BytesIO()
    Image.fromarray(pixels).save(out, "JPEG", quality=95)
    return out.getvalue()


BASE = jpeg(np.full((40, 60, 3), (90, 120, 30), np.uint8))
OTHER = jpeg(np.full((10, 15), 200, np.uint8))


def segment(kind: int, body: bytes) -> bytes:
    return bytes([0xFF, kind]) + struct.pack(">H", len(body) + 2) + body


def index_of_pictures(order: str, count: int) -> bytes:
    mark = b"MM\0*" if order == ">" else b"II*\0"
    version = struct.pack(f"{order}HHI4s", 0xB000, 7, 4, b"0100")
    number = struct.pack(f"{order}HHII", 0xB001, 4, 1, count)
    return b"MPF\0" + mark + struct.pack(f"{order}IH", 8, 2) + version + number + bytes(4)


@pytest.mark.parametrize(
    "segments",
    [
        segment(0xE1, XMP) + segment(0xE2, index_of_pictures(">", 2)),
        segment(0xE2, b"urn:iso:std:iso:ts:21496:-1\0\0\0\0\0"),
        segment(0xE1, b"http://ns.adobe.com/xap/1.0/\0<x HDRGainMap:HDRGainMapVersion='65536'/>"),
    ],
)
def test_a_gain_map_is_told_and_not_used(tmp_path: Path, segments: bytes) -> None:
    path = tmp_path / "a.jpg"
    path.write_bytes(BASE[:2] + segments + BASE[2:] + OTHER)
    info = probe(path)
    assert (info.width_px, info.height_px, info.bit_depth) == (60, 40, 8)
    assert [str(note) for note in info.notes] == [GAIN_MAP]
    assert np.abs(read_cel(path, white_is_clear=False).rgba[..., :3].astype(int) - [90, 120, 30]).max() <= 2


@pytest.mark.parametrize("order", ["<", ">"])
def test_other_pictures_are_told(tmp_path: Path, order: str) -> None:
    path = tmp_path / "a.jpg"
    path.write_bytes(BASE[:2] + segment(0xE2, index_of_pictures(order, 3)) + BASE[2:] + OTHER * 2)
    assert [str(note) for note in probe(path).notes] == ["of its 3 pictures the first alone is used"]


@pytest.mark.parametrize("body", [b"MPF\0", b"MPF\0MM\0*\xff\xff\xff\xff", index_of_pictures(">", 1), b"ICC"])
def test_what_says_nothing_is_not_told(tmp_path: Path, body: bytes) -> None:
    path = tmp_path / "a.jpg"
    path.write_bytes(BASE[:2] + segment(0xE2, body) + BASE[2:])
    assert probe(path).notes == ()
