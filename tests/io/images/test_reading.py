import contextlib
import itertools
import os
import random
import shutil
import subprocess
import sys
import tracemalloc
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from kagezou.errors import InputProblem
from kagezou.geometry.box import Box
from kagezou.io.images.enclosed import enclosed_part
from kagezou.io.images.oiio_guard import DecodedPicture
from kagezou.io.images.reading import ImageInfo, matte_of, probe, read_cel, read_matte
from kagezou.picture_source import OutlinedPicture
from tests.io.images import picture_files as files

Pixels = NDArray[Any]
CLEAR_NOTE = "no alpha channel: pure white was taken as clear"
FRAME_NOTE = "no alpha channel and no white: the whole frame would cast a shadow"


@pytest.fixture(autouse=True)
def _silent(capfd: pytest.CaptureFixture[str]) -> Iterator[None]:
    """No decoder may print: a broken file is told once, by us."""
    yield
    assert capfd.readouterr() == ("", "")


def noise(dtype: str, size: tuple[int, int] = (13, 17), channels: int = 4, seed: int = 1) -> Pixels:
    """Random pixels whose first row is clear and whose second is opaque."""
    full = np.iinfo(dtype).max
    pixels = np.random.default_rng(seed).integers(0, full + 1, (*size, channels)).astype(dtype)
    pixels[0, :, -1] = 0
    pixels[1, :, -1] = full
    return pixels


def times_alpha(pixels: Pixels) -> Pixels:
    full = np.iinfo(pixels.dtype).max
    done = pixels.copy()
    done[..., :3] = np.rint(pixels[..., :3] * (pixels[..., 3:] / full))
    return done


# Straight integer files come out number by number.


@pytest.mark.parametrize("dtype", ["uint8", "uint16"])
@pytest.mark.parametrize("name", ["a.png", "a.PNG", "a.tif", "a.Tiff"])
def test_straight_alpha_is_exact_also_where_clear(tmp_path: Path, name: str, dtype: str) -> None:
    pixels = noise(dtype)
    files.save(tmp_path / name, pixels)
    cel = read_cel(tmp_path / name)
    assert cel.rgba.dtype == dtype
    assert np.array_equal(cel.rgba, pixels)
    assert np.array_equal(cel.matte.whole(), pixels[..., 3])
    assert tuple(map(str, cel.notes)) == ()
    assert not cel.rgba.flags.writeable
    assert cel.nbytes == cel.rgba.nbytes + cel.matte.alpha.nbytes


@pytest.mark.parametrize("compression", ["none", "rle"])
def test_tga(tmp_path: Path, compression: str) -> None:
    pixels = noise("uint8")
    files.save(tmp_path / "a.tga", pixels, compression=compression)
    assert np.array_equal(read_cel(tmp_path / "a.tga").rgba, pixels)


def test_webp_is_exact_where_it_is_seen(tmp_path: Path) -> None:
    pixels = noise("uint8")
    files.save(tmp_path / "a.webp", pixels)
    rgba = read_cel(tmp_path / "a.webp").rgba
    seen = pixels[..., 3] > 0
    assert np.array_equal(rgba[..., 3], pixels[..., 3])
    assert np.array_equal(rgba[seen], pixels[seen])


# PNG in all its depths.

GRAY, RGB, PALETTE, GRAY_ALPHA, RGBA = 0, 2, 3, 4, 6
COLOURS = files.chunk(b"PLTE", bytes(range(12)))
CLEARS = files.chunk(b"tRNS", bytes([0, 128, 255]))


def test_palette_with_transparency(tmp_path: Path) -> None:
    expected = [[0, 1, 2, 0], [3, 4, 5, 128], [6, 7, 8, 255], [9, 10, 11, 255]]
    for bits, row in ((8, bytes([0, 1, 2, 3])), (4, bytes([0x01, 0x23])), (2, bytes([0b00011011]))):
        path = tmp_path / f"{bits}.png"
        path.write_bytes(files.png((4, 1), bits, PALETTE, b"\0" + row, COLOURS + CLEARS))
        assert read_cel(path).rgba.tolist() == [expected]
        assert read_matte(path).whole().tolist() == [[0, 128, 255, 255]]


@pytest.mark.parametrize(
    ("bits", "row", "grays"),
    [
        (1, bytes([0b10110001]), [255, 0, 255, 255, 0, 0, 0, 255]),
        (2, bytes([0b00011011]), [0, 85, 170, 255]),
        (4, bytes([0x3C]), [51, 204]),
        (8, bytes([7, 255]), [7, 255]),
        (16, bytes([1, 2, 255, 255]), [258, 65535]),
    ],
)
def test_gray_depths(tmp_path: Path, bits: int, row: bytes, grays: list[int]) -> None:
    path = tmp_path / "g.png"
    path.write_bytes(files.png((len(grays), 1), bits, GRAY, b"\0" + row))
    cel = read_cel(path, white_is_clear=False)
    full = 65535 if bits == 16 else 255
    assert cel.rgba.tolist() == [[[gray, gray, gray, full] for gray in grays]]
    assert tuple(map(str, cel.notes)) == ()
    key = row[:2] if bits == 16 else bytes([0, grays[0] * (2**bits - 1) // 255])
    path.write_bytes(files.png((len(grays), 1), bits, GRAY, b"\0" + row, files.chunk(b"tRNS", key)))
    assert read_matte(path).whole().tolist() == [[0 if gray == grays[0] else full for gray in grays]]


def test_gray_alpha_and_colour_key(tmp_path: Path) -> None:
    path = tmp_path / "a.png"
    path.write_bytes(files.png((2, 1), 8, GRAY_ALPHA, bytes([0, 10, 20, 30, 40])))
    assert read_cel(path).rgba.tolist() == [[[10, 10, 10, 20], [30, 30, 30, 40]]]
    key = files.chunk(b"tRNS", bytes([0, 1, 0, 2, 0, 3]))
    path.write_bytes(files.png((2, 1), 8, RGB, bytes([0, 1, 2, 3, 4, 5, 6]), key))
    assert read_cel(path).rgba.tolist() == [[[1, 2, 3, 0], [4, 5, 6, 255]]]


# Files without an alpha channel.


@pytest.mark.parametrize("dtype", ["uint8", "uint16"])
def test_pure_white_is_clear(tmp_path: Path, dtype: str) -> None:
    full = int(np.iinfo(dtype).max)
    pixels = noise(dtype, channels=3)
    pixels[3, 4] = full
    pixels[3, 5] = full, full, full - 1
    files.save(tmp_path / "a.png", pixels)
    cel = read_cel(tmp_path / "a.png")
    assert tuple(map(str, cel.notes)) == (CLEAR_NOTE,)
    assert np.array_equal(cel.rgba[..., :3], pixels)
    assert np.argwhere(cel.matte.whole() != full).tolist() == [[3, 4]]
    assert cel.matte.whole()[3, 4] == 0
    assert cel.matte.hard_edged
    assert np.array_equal(read_matte(tmp_path / "a.png").whole(), cel.matte.whole())
    paper = read_cel(tmp_path / "a.png", white_is_clear=False)
    assert tuple(map(str, paper.notes)) == ()
    assert (paper.matte.whole() == full).all()


@pytest.mark.parametrize("dtype", ["uint8", "uint16"])
def test_white_inside_an_outline_stays_where_the_source_says_so(tmp_path: Path, dtype: str) -> None:
    full = int(np.iinfo(dtype).max)
    pixels = np.full((12, 14, 3), full, dtype)
    pixels[3:9, 3:10] = 50
    pixels[5:7, 5:8] = full
    pixels[9, 4] = full - 1
    files.save(tmp_path / "a.png", pixels)
    cel = read_cel(OutlinedPicture(tmp_path / "a.png"))
    assert tuple(map(str, cel.notes)) == ("no alpha channel: white that reaches the border was taken as clear",)
    wanted = np.zeros((12, 14), dtype)
    wanted[3:9, 3:10] = wanted[9, 4] = full
    assert np.array_equal(cel.matte.whole(), wanted)
    assert np.array_equal(read_matte(OutlinedPicture(tmp_path / "a.png")).whole(), wanted)
    assert enclosed_part(tmp_path / "a.png") == 6 / 43
    (tmp_path / "b.png").write_bytes((tmp_path / "a.png").read_bytes())
    assert read_cel(tmp_path / "b.png").matte.whole()[5:7, 5:8].max() == 0


def test_paper_changes_nothing_in_a_picture_with_alpha(tmp_path: Path) -> None:
    pixels = np.full((8, 9, 4), 255, np.uint8)
    pixels[:2, :, 3] = 0
    files.save(tmp_path / "a.png", pixels)
    found = read_cel(OutlinedPicture(tmp_path / "a.png"))
    assert np.array_equal(found.rgba, read_cel(tmp_path / "a.png").rgba)
    assert enclosed_part(tmp_path / "a.png") == 0.0


@pytest.mark.parametrize("name", ["a.jpg", "a.JPEG", "a.bmp", "a.tga", "a.png", "a.tif"])
def test_nothing_clear_is_told(tmp_path: Path, name: str) -> None:
    files.save(tmp_path / name, np.full((8, 9, 3), 100, np.uint8))
    cel = read_cel(tmp_path / name)
    assert tuple(map(str, cel.notes)) == (FRAME_NOTE,)
    assert cel.matte.box == Box(0, 0, 9, 8)
    assert not cel.matte.hard_edged
    assert not probe(tmp_path / name).has_alpha


def test_an_alpha_that_is_full_everywhere_is_told(tmp_path: Path) -> None:
    files.save(tmp_path / "a.png", np.full((8, 9, 4), 255, np.uint8))
    assert tuple(map(str, read_cel(tmp_path / "a.png").notes)) == (
        "alpha is full everywhere: the whole frame would cast a shadow",
    )
    assert tuple(map(str, read_cel(tmp_path / "a.png", white_is_clear=False).notes)) == ()


BGRA = bytes([1, 2, 3, 128, 4, 5, 6, 0, 7, 8, 9, 255, 10, 11, 12, 64])
UNUSED = bytes([1, 2, 3, 0, 4, 5, 6, 0, 255, 255, 255, 0, 10, 11, 12, 0])


@pytest.mark.parametrize(
    ("attributes", "alpha_type", "body", "alpha"),
    [
        (8, None, BGRA, [[255, 64], [128, 0]]),
        (0, None, BGRA, [[255, 64], [128, 0]]),
        (8, 3, BGRA, [[255, 64], [128, 0]]),
        (8, 0, BGRA, [[255, 64], [128, 0]]),
        (0, None, UNUSED, [[0, 255], [255, 255]]),
        (8, 0, UNUSED, [[0, 255], [255, 255]]),
        (8, 3, UNUSED, [[0, 0], [0, 0]]),
        (0, None, bytes(16), [[0, 0], [0, 0]]),
        (8, 4, UNUSED, [[0, 0], [0, 0]]),
    ],
)
def test_fourth_byte_of_tga(
    tmp_path: Path, attributes: int, alpha_type: int | None, body: bytes, alpha: list[list[int]]
) -> None:
    path = tmp_path / "a.tga"
    path.write_bytes(files.tga((2, 2), 32, attributes, body, alpha_type))
    assert read_matte(path).whole().tolist() == alpha
    cel = read_cel(path)
    assert cel.matte.whole().tolist() == alpha
    if body is BGRA:
        assert cel.rgba[1, 0].tolist() == [3, 2, 1, 128]


def test_premultiplied_tga(tmp_path: Path) -> None:
    path = tmp_path / "a.tga"
    path.write_bytes(files.tga((2, 1), 32, 8, bytes([10, 20, 64, 128, 0, 0, 0, 0]), 4))
    assert read_cel(path).rgba.tolist() == [[[128, 40, 20, 128], [0, 0, 0, 0]]]


@pytest.mark.parametrize(("body", "alpha"), [(BGRA, [[255, 64], [128, 0]]), (UNUSED, [[0, 255], [255, 255]])])
def test_fourth_byte_of_bmp(tmp_path: Path, body: bytes, alpha: list[list[int]]) -> None:
    path = tmp_path / "a.bmp"
    path.write_bytes(files.bmp32((2, 2), body))
    assert read_matte(path).whole().tolist() == alpha


# Premultiplied, linear and wide numbers.


@pytest.mark.parametrize(("dtype", "tolerance"), [("uint8", 1), ("uint16", 1)])
def test_associated_tiff_is_divided(tmp_path: Path, dtype: str, tolerance: int) -> None:
    full = int(np.iinfo(dtype).max)
    pixels = noise(dtype)
    pixels[..., 3] = np.where(pixels[..., 3] > 0, np.maximum(pixels[..., 3], full // 2), 0)
    files.save(tmp_path / "a.tif", times_alpha(pixels), straight=False)
    rgba = read_cel(tmp_path / "a.tif").rgba
    assert rgba.dtype == dtype
    seen = pixels[..., 3] > 0
    assert np.array_equal(rgba[..., 3], pixels[..., 3])
    assert np.abs(rgba[seen].astype(np.int64) - pixels[seen]).max() <= tolerance
    assert not rgba[~seen].any()


def coded(light: Pixels) -> Pixels:
    """The reference: sRGB coding of 0..1 in float64, as 0..65535."""
    return (
        np.where(light <= 0.0031308, light * 12.92, 1.055 * np.maximum(light, 0.0031308) ** (1 / 2.4) - 0.055) * 65535
    )


@pytest.mark.parametrize(("dtype", "tolerance"), [("float16", 130), ("float32", 1)])
@pytest.mark.parametrize("size", [(13, 17), (300, 5)])
def test_exr_becomes_straight_and_coded(tmp_path: Path, dtype: str, tolerance: int, size: tuple[int, int]) -> None:
    random_ = np.random.default_rng(2)
    light = random_.random((*size, 3))
    alpha = random_.uniform(0.2, 1, (*size, 1))
    alpha[0], alpha[1] = 0, 1
    stored = np.concatenate([light * alpha, alpha], axis=2).astype(dtype)
    files.save(tmp_path / "a.exr", stored)
    cel = read_cel(tmp_path / "a.exr")
    assert cel.rgba.dtype == np.uint16
    assert np.abs(cel.rgba[..., 3] - alpha[..., 0] * 65535).max() <= (33 if dtype == "float16" else 1)
    assert np.abs(cel.rgba[1:, :, :3] - coded(light[1:])).max() <= tolerance
    assert not cel.rgba[0].any()
    assert (cel.rgba[1, :, 3] == 65535).all()
    assert np.array_equal(read_matte(tmp_path / "a.exr").whole(), cel.matte.whole())


def test_exr_that_is_no_number_or_too_much(tmp_path: Path) -> None:
    odd = [np.nan, np.inf, -np.inf, -1.0, 2.0, 1e-6, 0.5]
    stored = np.array(list(itertools.product(odd, repeat=2)), np.float32).reshape(1, -1, 2)
    files.save(tmp_path / "a.exr", stored[..., [0, 0, 0, 1]], compression="none")
    rgba = read_cel(tmp_path / "a.exr").rgba
    by_pair = dict(zip(map(tuple, stored[0].tolist()), rgba[0].tolist(), strict=True))
    assert by_pair[0.5, 0.5] == [65535, 65535, 65535, 32768]
    assert by_pair[2.0, 2.0][:] == [65535] * 4
    assert by_pair[np.inf, -1.0][3] == 0
    assert by_pair[0.5, -np.inf][3] == 0
    assert by_pair[-1.0, 0.5][:3] == [0, 0, 0]
    assert [
        value[3] for pair, value in zip(stored[0].tolist(), rgba[0].tolist(), strict=True) if np.isnan(pair[1])
    ] == [0] * len(odd)


@pytest.mark.parametrize(
    ("names", "expected"),
    [
        (("Y", "A"), [[65535, 65535, 65535, 32768]]),
        (("A",), [[0, 0, 0, 32768]]),
        (("R", "G", "B", "A", "Z", "id"), [[65535, 65535, 65535, 32768]]),
        (("Z",), [[48192, 48192, 48192, 65535]]),
    ],
)
def test_exr_channels(tmp_path: Path, names: tuple[str, ...], expected: list[list[int]]) -> None:
    files.save(tmp_path / "a.exr", np.full((1, 1, len(names)), 0.5, np.float32), names=names)
    assert read_cel(tmp_path / "a.exr").rgba.tolist() == [expected]


@pytest.mark.parametrize(
    ("place", "display", "box"),
    [
        ((2, 1), (0, 0, 8, 6), Box(2, 1, 6, 4)),
        ((-2, -1), (0, 0, 8, 6), Box(0, 0, 2, 2)),
        ((6, 5), (0, 0, 8, 6), Box(6, 5, 8, 6)),
        ((12, 11), (10, 10, 8, 6), Box(2, 1, 6, 4)),
        ((20, 20), (0, 0, 8, 6), None),
        ((0, 0), (1, 1, 2, 1), Box(0, 0, 2, 1)),
    ],
)
def test_exr_windows(
    tmp_path: Path, place: tuple[int, int], display: tuple[int, int, int, int], box: Box | None
) -> None:
    files.save_exr_window(tmp_path / "a.exr", np.ones((3, 4, 4), np.float16), place, display)
    info = probe(tmp_path / "a.exr")
    assert (info.width_px, info.height_px) == display[2:]
    for matte in (read_cel(tmp_path / "a.exr").matte, read_matte(tmp_path / "a.exr")):
        assert matte.whole().shape == (display[3], display[2])
        assert matte.box == box


def test_wide_integer_and_float_tiff(tmp_path: Path) -> None:
    files.save(tmp_path / "i.tif", np.array([[[0, 2**31, 2**32 - 1, 2**32 - 1]]], np.uint32))
    assert read_cel(tmp_path / "i.tif").rgba.tolist() == [[[0, 32768, 65535, 65535]]]
    files.save(tmp_path / "s.tif", np.array([[[0, 0.25, 0.5, 0.5]]], np.float32), straight=True)
    rgba = read_cel(tmp_path / "s.tif").rgba[0, 0]
    assert np.abs(rgba - np.append(coded(np.array([0, 0.25, 0.5])), 32768)).max() <= 1
    files.save(tmp_path / "f.tif", np.array([[[0, 0.25, 0.5, 0.5]]], np.float32), straight=False)
    rgba = read_cel(tmp_path / "f.tif").rgba[0, 0]
    assert np.abs(rgba - np.append(coded(np.array([0, 0.5, 1])), 32768)).max() <= 1


@pytest.mark.parametrize("orientation", range(1, 9))
def test_orientation(tmp_path: Path, orientation: int) -> None:
    upright = noise("uint8", (4, 6))
    stored = {
        1: upright,
        2: upright[:, ::-1],
        3: upright[::-1, ::-1],
        4: upright[::-1],
        5: upright.swapaxes(0, 1),
        6: np.rot90(upright, 1),
        7: np.rot90(upright, 1)[:, ::-1],
        8: np.rot90(upright, -1),
    }[orientation]
    if orientation == 7:
        stored = upright[::-1, ::-1].swapaxes(0, 1)
    files.save(tmp_path / "a.tif", stored, Orientation=orientation)
    assert np.array_equal(read_cel(tmp_path / "a.tif").rgba, upright)
    assert np.array_equal(read_matte(tmp_path / "a.tif").whole(), upright[..., 3])
    info = probe(tmp_path / "a.tif")
    assert (info.width_px, info.height_px) == (6, 4)


# Mattes.


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16])
def test_box_and_hard_edges(dtype: type[np.uint8 | np.uint16]) -> None:
    full = np.iinfo(dtype).max
    alpha = np.zeros((9, 12), dtype)
    assert (matte_of(alpha).box, matte_of(alpha).hard_edged) == (None, False)
    alpha = alpha.copy()
    alpha[2:5, 3:7] = full
    alpha[6, 10] = full
    matte = matte_of(alpha)
    assert (matte.box, matte.hard_edged) == (Box(3, 2, 11, 7), True)
    assert matte.alpha.flags.c_contiguous
    assert not matte.alpha.flags.writeable
    assert (matte.alpha == alpha[2:7, 3:11]).all()
    assert (matte.whole() == alpha).all()
    for value in (1, full - 1, full // 2):
        soft = alpha.copy()
        soft[8, 0] = value
        assert (matte_of(soft).box, matte_of(soft).hard_edged) == (Box(0, 2, 11, 9), False)
    square = np.zeros((9, 12), dtype)
    square[3:5, 4:8] = full
    assert (matte_of(square).box, matte_of(square).hard_edged) == (Box(4, 3, 8, 5), True)
    assert not matte_of(np.full((2, 2), full, dtype)).hard_edged
    assert matte_of(np.full((2, 2), full, dtype)).box == Box(0, 0, 2, 2)


def test_a_kept_matte_takes_the_memory_of_its_figure_alone() -> None:
    alpha = np.zeros((1080, 1920), np.uint8)
    alpha[500:520, 900:930] = 255
    matte = matte_of(alpha)
    assert matte.nbytes == 600
    assert matte.alpha.base is None, "a view would keep the whole drawing in memory"


def test_a_matte_is_full_when_every_pixel_is() -> None:
    full = np.full((3, 4), 255, np.uint8)
    assert matte_of(full).is_full
    for number in (0, 254):
        other = full.copy()
        other[0, 0] = number
        assert not matte_of(other).is_full
    assert not matte_of(np.zeros((3, 4), np.uint8)).is_full


def test_probe(tmp_path: Path) -> None:
    files.save(tmp_path / "a.png", noise("uint16", (5, 7)))
    assert probe(tmp_path / "a.png") == ImageInfo(7, 5, 4, has_alpha=True, bit_depth=16)
    files.save(tmp_path / "a.exr", np.ones((5, 7, 3), np.float16))
    assert probe(tmp_path / "a.exr") == ImageInfo(7, 5, 3, has_alpha=False, bit_depth=16)


# Faults: one sentence, no picture, no print.


def sentence_of(path: Path, read: Callable[[Path], object] = read_cel) -> str:
    with pytest.raises(InputProblem) as caught:
        read(path)
    text = str(caught.value)
    assert "\n" not in text
    return text


@pytest.mark.parametrize("read", [read_cel, read_matte, probe])
def test_plain_faults(tmp_path: Path, read: Callable[[Path], object]) -> None:
    (tmp_path / "folder.png").mkdir()
    (tmp_path / "zero.png").write_bytes(b"")
    (tmp_path / "a.tiff2").write_bytes(b"II")
    (tmp_path / "html.png").write_bytes(b"<html></html>")
    (tmp_path / "html.tga").write_bytes(b"<html></html>")
    files.save(tmp_path / "a.exr", np.ones((4, 4, 4), np.float16))
    shutil.copy(tmp_path / "a.exr", tmp_path / "exr.png")
    for name, cause in {
        "none.png": "it does not exist",
        "folder.png": "it is not a file",
        "zero.png": "the file is empty",
        "a.tiff2": "'.tiff2' is not a picture format that can be read",
        "a": "'' is not a picture format that can be read",
        "html.png": "it is not PNG, whatever its name says",
        "exr.png": "it is not PNG but OpenEXR, whatever its name says",
        "a\0.png": "it cannot be a file name",
    }.items():
        assert sentence_of(tmp_path / name, read) == f"{tmp_path / name}: {cause}"
    assert sentence_of(tmp_path / "html.tga", read).startswith(f"{tmp_path / 'html.tga'}: ")


@pytest.mark.skipif(os.name == "nt", reason="Windows names are text")
def test_a_name_that_is_no_text(tmp_path: Path) -> None:
    path = tmp_path / os.fsdecode(b"a\xff.png")
    try:
        path.write_bytes(files.png((1, 1), 8, GRAY, bytes([0, 0])))
    except OSError:
        pytest.skip("this file system takes text alone")
    assert sentence_of(path) == f"{tmp_path}/a\\xff.png: its name is not valid text: please rename it"


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="an administrator may read everything")
def test_no_right_to_read(tmp_path: Path) -> None:
    path = tmp_path / "a.png"
    path.write_bytes(b"x")
    path.chmod(0)
    assert sentence_of(path) == f"{path}: permission denied"


@pytest.mark.parametrize("name", ["a.png", "a.tga", "raw.tga", "a.tif", "a.exr", "a.webp", "a.jpg", "a.bmp"])
@pytest.mark.parametrize("part", [0.05, 0.3, 0.6, 0.9, 0.99])
def test_truncated(tmp_path: Path, name: str, part: float) -> None:
    pixels = noise("uint8", (40, 50))
    path = tmp_path / name
    stored = pixels[..., :3] if path.suffix in {".jpg", ".bmp"} else pixels
    stored = (stored / 255).astype(np.float16) if path.suffix == ".exr" else stored
    settings: dict[str, Any] = {"compression": "none"} if name == "raw.tga" else {}
    files.save(path, stored, **settings)
    complete = read_cel(path).rgba
    whole = path.read_bytes()
    path.write_bytes(whole[: int(len(whole) * part)])
    if part < 0.99:
        assert sentence_of(path).startswith(f"{path}: ")
        assert sentence_of(path, read_matte).startswith(f"{path}: ")
    else:  # a cut through what follows the pixels may leave the picture whole
        with contextlib.suppress(InputProblem):
            assert np.array_equal(read_cel(path).rgba, complete)


def test_a_damaged_png_is_told(tmp_path: Path) -> None:
    whole = bytearray(files.png((2, 1), 8, RGB, bytes([0, 1, 2, 3, 4, 5, 6])))
    whole[-20] ^= 1
    (tmp_path / "a.png").write_bytes(whole)
    assert sentence_of(tmp_path / "a.png") == f"{tmp_path / 'a.png'}: the file is damaged (a checksum is wrong)"


@pytest.mark.parametrize("read", [read_cel, read_matte, probe])
@pytest.mark.parametrize("size", [(100_000, 100_000), (32_768, 32_768), (2**31 - 1, 1)])
def test_a_lying_header_is_refused_before_anything_is_decoded(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, size: tuple[int, int], read: Callable[[Path], object]
) -> None:
    path = tmp_path / "huge.png"
    path.write_bytes(files.png(size, 8, RGBA, b""))
    monkeypatch.setattr(DecodedPicture, "read", lambda *_: pytest.fail("it was decoded"))
    tracemalloc.start()
    try:
        sentence = sentence_of(path, read)
        _, most_bytes = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert sentence.startswith(f"{path}: ")
    assert most_bytes < 1 << 20


def test_a_lying_display_window_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "a.exr"
    files.save_exr_window(path, np.ones((3, 4, 4), np.float16), (0, 0), (0, 0, 30_000, 30_000))
    assert sentence_of(path) == f"{path}: 30000 × 30000 px is larger than can be read"


def mutants(whole: bytes, count: int) -> Iterator[bytes]:
    chance = random.Random(len(whole))
    for _ in range(count):
        data = bytearray(whole)
        for _ in range(chance.randint(1, 6)):
            data[chance.randrange(len(data))] = chance.choice([0, 1, 127, 128, 255, chance.randrange(256)])
        yield bytes(data[: chance.randrange(len(data))] if chance.random() < 0.2 else data)


@pytest.mark.parametrize("name", ["a.png", "a.tga", "a.tif", "a.exr", "a.webp", "a.jpg", "a.bmp"])
def test_mutants_end_in_a_picture_or_a_sentence(tmp_path: Path, name: str) -> None:
    pixels = noise("uint8")
    path = tmp_path / name
    stored = pixels[..., :3] if path.suffix in {".jpg", ".bmp"} else pixels
    files.save(path, (stored / 255).astype(np.float16) if path.suffix == ".exr" else stored)
    sentences = set()
    for data in mutants(path.read_bytes(), 120):
        path.write_bytes(data)
        try:
            cel = read_cel(path)
        except InputProblem as problem:
            sentences.add(str(problem))
        else:
            assert cel.rgba.shape[:2] == cel.matte.whole().shape
    assert sentences
    assert all(sentence.startswith(f"{path}: ") and "\n" not in sentence for sentence in sentences)


def test_nothing_is_printed_when_the_program_ends(tmp_path: Path) -> None:
    files.save(tmp_path / "a.png", noise("uint8"))
    (tmp_path / "bad.jpg").write_bytes(b"\xff\xd8\xff\xe0 no picture")
    script = """
import sys
from pathlib import Path
from kagezou.errors import InputProblem
from kagezou.io.images.reading import read_cel
read_cel(Path(sys.argv[1]))
try:
    read_cel(Path(sys.argv[2]))
except InputProblem:
    pass
"""
    arguments = [sys.executable, "-c", script, str(tmp_path / "a.png"), str(tmp_path / "bad.jpg")]
    done = subprocess.run(arguments, capture_output=True, text=True, check=True)
    assert (done.stdout, done.stderr) == ("", "")


def test_real_samples(samples: Path) -> None:
    for path in sorted(samples.glob("*/A/frame_0001.png")):
        cel, matte = read_cel(path), read_matte(path)
        assert tuple(map(str, cel.notes)) == ()
        assert cel.matte.box == matte.box is not None
        assert np.array_equal(cel.matte.whole(), matte.whole())
        assert np.array_equal(cel.rgba, files.read_back(path))
        assert not matte.hard_edged
