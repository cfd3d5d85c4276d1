"""The fast decoder of PNG gives what OpenImageIO gives, and refuses what it refuses."""

import struct
import threading
import zlib
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from kagezou.errors import InputProblem
from kagezou.io.images import fast_png, oiio_guard
from kagezou.io.images.header import Header
from kagezou.io.images.oiio_guard import DecodedPicture, Pixels
from tests.io.images import picture_files as files

GRAY, RGB, PALETTE, GRAY_ALPHA, RGBA = 0, 2, 3, 4, 6
SAMPLES = {GRAY: 1, RGB: 3, PALETTE: 1, GRAY_ALPHA: 2, RGBA: 4}
DEPTHS = {GRAY: (1, 2, 4, 8, 16), RGB: (8, 16), PALETTE: (1, 2, 4, 8), GRAY_ALPHA: (8, 16), RGBA: (8, 16)}
COLOURS = files.chunk(b"PLTE", bytes(range(256)) * 3)
SIZE = (37, 23)
PASSES = ((0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2), (0, 1, 1, 2))
"""First column and row, and the steps, of the passes of an interlaced PNG."""


def rows_of(kind: int, bits: int = 8, filters: str = "mixed", size: tuple[int, int] = SIZE) -> bytes:
    chance = np.random.default_rng([kind, bits])
    stride = (size[0] * SAMPLES[kind] * bits + 7) // 8
    rows = chance.integers(0, 256, (size[1], 1 + stride), np.uint8)
    rows[:, 0] = np.arange(size[1]) % 5 if filters == "mixed" else int(filters)
    return rows.tobytes()


def interlaced(kind: int, size: tuple[int, int]) -> bytes:
    chance = np.random.default_rng(kind)
    pixels = chance.integers(0, 256, (size[1], size[0], SAMPLES[kind]), np.uint8)
    parts = [pixels[top::down, left::right] for left, top, right, down in PASSES]
    rows = b"".join(b"\0" + row.tobytes() for part in parts if part.size for row in part)
    head = struct.pack(">IIBBBBB", *size, 8, kind, 0, 0, 1)
    chunks = files.chunk(b"IHDR", head), files.chunk(b"IDAT", zlib.compress(rows)), files.chunk(b"IEND", b"")
    return b"\x89PNG\r\n\x1a\n" + b"".join(chunks)


def packed(stream: bytes, kind: int = RGBA, piece: int = 1 << 20) -> bytes:
    head = struct.pack(">IIBBBBB", *SIZE, 8, kind, 0, 0, 0)
    parts = [files.chunk(b"IDAT", stream[at : at + piece]) for at in range(0, len(stream), piece)]
    return b"\x89PNG\r\n\x1a\n" + files.chunk(b"IHDR", head) + b"".join(parts) + files.chunk(b"IEND", b"")


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "a.png"


@pytest.fixture
def fast(monkeypatch: pytest.MonkeyPatch) -> list[bool]:
    """Of each reading, whether the fast decoder delivered."""
    answers: list[bool] = []

    def asked(path: Path, header: Header) -> Pixels | None:
        found = fast_png.fast_pixels(path, header)
        answers.append(found is not None)
        return found

    monkeypatch.setattr(oiio_guard, "fast_pixels", asked)
    return answers


def check_same(path: Path) -> None:
    """What is read by whichever decoder is what OpenImageIO reads."""
    with DecodedPicture(path) as picture:
        found = picture.read()
    wanted = files.read_back(path)
    assert found.dtype == wanted.dtype
    assert np.array_equal(found, wanted.reshape(found.shape))


@pytest.mark.parametrize("kind", DEPTHS)
def test_every_kind_and_depth(path: Path, fast: list[bool], kind: int) -> None:
    for bits in DEPTHS[kind]:
        path.write_bytes(files.png(SIZE, bits, kind, rows_of(kind, bits), COLOURS if kind == PALETTE else b""))
        check_same(path)
        assert fast.pop() is (bits == 8 and kind in (RGB, RGBA))


@pytest.mark.parametrize("kind", [RGB, RGBA])
def test_filters_sizes_and_packing(path: Path, fast: list[bool], kind: int) -> None:
    for size in ((1, 1), (2, 5), (300, 3)):
        path.write_bytes(files.png(size, 8, kind, rows_of(kind, size=size)))
        check_same(path)
        path.write_bytes(interlaced(kind, size))
        check_same(path)
    for filters in "01234":
        path.write_bytes(files.png(SIZE, 8, kind, rows_of(kind, filters=filters)))
        check_same(path)
    for level in (0, 1, 9):
        path.write_bytes(packed(zlib.compress(rows_of(kind), level), kind, piece=100))
        check_same(path)
    assert all(fast)


def test_much_that_packs_well_and_what_does_not(path: Path, fast: list[bool]) -> None:
    size = (600, 400)
    for rows in (bytes((1 + 4 * size[0]) * size[1]), rows_of(RGBA, size=size)):
        path.write_bytes(files.png(size, 8, RGBA, rows))
        check_same(path)
    assert all(fast)


EXTRAS = {
    "colour key": (files.chunk(b"tRNS", bytes(6)), False),
    "gamma": (files.chunk(b"gAMA", struct.pack(">I", 100000)), True),
    "significant bits": (files.chunk(b"sBIT", b"\5\5\5"), True),
    "background": (files.chunk(b"bKGD", bytes(6)), True),
    "suggested palette": (files.chunk(b"PLTE", b"\1\2\3" * 4), True),
    "film": (files.chunk(b"acTL", struct.pack(">II", 2, 0)), True),
    "own": (files.chunk(b"abCd", b"?"), True),
}


@pytest.mark.parametrize("name", EXTRAS)
def test_other_chunks(path: Path, fast: list[bool], name: str) -> None:
    extra, is_fast = EXTRAS[name]
    path.write_bytes(files.png(SIZE, 8, RGB, rows_of(RGB), extra))
    check_same(path)
    assert fast == [is_fast]


def damaged() -> Iterator[tuple[str, bytes]]:
    rows = rows_of(RGBA)
    stream = zlib.compress(rows)
    yield "wrong checksum of what is packed", packed(stream[:-4] + b"abcd")
    yield "no checksum of what is packed", packed(stream[:-4])
    yield "cut short", packed(stream[:-400])
    yield "too few rows", packed(zlib.compress(rows[:-200]))
    yield "no such filter", packed(zlib.compress(b"\7" + rows[1:]))
    yield "no such packing", packed(b"\x79\x9c" + stream[2:])
    yield "nothing packed", packed(b"")
    for at in range(40, len(stream), 251):
        yield f"byte {at}", packed(stream[:at] + bytes([stream[at] ^ 0x55]) + stream[at + 1 :])


@pytest.mark.parametrize("data", [pytest.param(data, id=name) for name, data in damaged()])
def test_what_is_packed_wrongly_is_refused_though_its_chunks_are_right(path: Path, data: bytes) -> None:
    path.write_bytes(data)
    with pytest.raises(InputProblem), DecodedPicture(path) as picture:
        picture.read()


def test_more_than_the_picture_needs_is_left(path: Path, fast: list[bool]) -> None:
    stream = zlib.compress(rows_of(RGBA))
    for data in (packed(zlib.compress(rows_of(RGBA) * 2)), packed(stream + b"more")):
        path.write_bytes(data)
        check_same(path)
    assert all(fast)


@pytest.mark.parametrize(("name", "value"), [("_MOST_PIXELS", 100), ("_MOST_BYTES", 100)])
def test_what_is_large_holds_nobody_up(
    path: Path, fast: list[bool], monkeypatch: pytest.MonkeyPatch, name: str, value: int
) -> None:
    monkeypatch.setattr(fast_png, name, value)
    path.write_bytes(files.png(SIZE, 8, RGBA, rows_of(RGBA)))
    check_same(path)
    assert fast == [False]


def test_a_file_that_changes_between_header_and_pixels(path: Path) -> None:
    path.write_bytes(files.png(SIZE, 8, RGBA, rows_of(RGBA)))
    with DecodedPicture(path) as picture:
        path.write_bytes(files.png((5, 5), 8, RGBA, rows_of(RGBA, size=(5, 5))))
        assert fast_png.fast_pixels(path, picture.header) is None
        path.unlink()
        assert fast_png.fast_pixels(path, picture.header) is None


def test_threads_read_at_once(tmp_path: Path) -> None:
    paths = [tmp_path / f"{number}.png" for number in range(4)]
    for number, each in enumerate(paths):
        each.write_bytes(files.png((64, 64), 8, RGBA, rows_of(RGBA, filters=str(number), size=(64, 64))))
    wrong: list[Path] = []

    def read(each: Path) -> None:
        wanted = files.read_back(each)
        for _ in range(5):
            with DecodedPicture(each) as picture:
                if not np.array_equal(picture.read(), wanted):
                    wrong.append(each)

    threads = [threading.Thread(target=read, args=(each,)) for each in paths]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert wrong == []


def test_real_samples_come_fast(samples: Path, fast: list[bool]) -> None:
    found = sorted(samples.glob("*/A/frame_0001.png"))
    for each in found:
        check_same(each)
    assert len(fast) == len(found)
    assert all(fast)
