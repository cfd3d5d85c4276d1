"""Every kind of TGA, TIFF, WebP, GIF and BMP against numbers worked out here, and where it can read them Pillow."""

import itertools
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image

from kagezou.errors import InputProblem
from kagezou.io.images.reading import has_alpha, probe, read_cel, read_matte
from tests.io.images import raw_files as raw

Pixels = NDArray[Any]
CHANCE = np.random.default_rng(5)
H, W = 21, 19
RGBA = CHANCE.integers(1, 255, (H, W, 4)).astype(np.uint8)
RGBA[:, :4] = RGBA[:, :1]
FIVES = CHANCE.integers(0, 65536, (H, W)).astype(np.uint16)
FIVES[:, :4] = FIVES[:, :1]
PLACES = CHANCE.integers(0, 6, (H, W, 1)).astype(np.uint8)
PALETTE = CHANCE.integers(1, 255, (6, 4)).astype(np.uint8)
BGRA = [2, 1, 0, 3]


def said(path: Path) -> list[str]:
    return list(map(str, probe(path).notes))


def opaque(rgb: Pixels) -> Pixels:
    return np.dstack([rgb, np.full(rgb.shape[:2], np.iinfo(rgb.dtype).max, rgb.dtype)])


def of_fives(numbers: Pixels, *, has_alpha: bool) -> Pixels:
    fives = np.stack([numbers >> 10, numbers >> 5, numbers], axis=-1) & 31
    rgb = np.floor(fives * 255 / 31 + 0.5)
    alpha = np.where(numbers >> 15, 255, 0) if has_alpha else np.full(numbers.shape, 255)
    return np.concatenate([rgb, alpha[..., None]], axis=-1)


TGA: dict[str, tuple[dict[str, Any], Pixels, Pixels]] = {
    "32": ({"kind": raw.COLOUR, "bits": 32, "attributes": 8}, RGBA[..., BGRA], RGBA),
    "24": ({"kind": raw.COLOUR, "bits": 24}, RGBA[..., BGRA[:3]], opaque(RGBA[..., :3])),
    "gray": ({"kind": raw.GRAY, "bits": 8}, RGBA[..., :1], opaque(RGBA[..., [0, 0, 0]])),
    "gray and alpha": ({"kind": raw.GRAY, "bits": 16, "attributes": 8}, RGBA[..., [0, 3]], RGBA[..., [0, 0, 0, 3]]),
    "1555": ({"kind": raw.COLOUR, "bits": 16, "attributes": 1}, raw.bytes_of(FIVES), of_fives(FIVES, has_alpha=True)),
    "555": ({"kind": raw.COLOUR, "bits": 16}, raw.bytes_of(FIVES), of_fives(FIVES, has_alpha=False)),
    "palette of 24": (
        {"kind": raw.PALETTE, "bits": 8, "palette": PALETTE[:, BGRA[:3]].tobytes(), "palette_bits": 24},
        PLACES,
        opaque(PALETTE[PLACES[..., 0], :3]),
    ),
    "palette of 32": (
        {"kind": raw.PALETTE, "bits": 8, "palette": PALETTE[:, BGRA].tobytes(), "palette_bits": 32},
        PLACES,
        PALETTE[PLACES[..., 0]],
    ),
    "palette of 32 from 3": (
        {"kind": raw.PALETTE, "bits": 8, "palette": PALETTE[:, BGRA].tobytes(), "palette_bits": 32, "first": 3},
        PLACES + 3,
        PALETTE[PLACES[..., 0]],
    ),
    "long palette of 32": (
        {"kind": raw.PALETTE, "bits": 16, "palette": PALETTE[:, BGRA].tobytes(), "palette_bits": 32},
        raw.bytes_of(PLACES[..., 0]),
        PALETTE[PLACES[..., 0]],
    ),
    "palette of 16": (
        {
            "kind": raw.PALETTE, "bits": 8, "palette": FIVES[0, 2:8].astype("<u2").tobytes(), "palette_bits": 16,
            "attributes": 1,
        },
        PLACES,
        of_fives(FIVES[0, 2:8][PLACES[..., 0]], has_alpha=True),
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", TGA)
@pytest.mark.parametrize(("origin", "rle"), [*itertools.product(range(4), (False, True))])
def test_tga(tmp_path: Path, name: str, origin: int, rle: bool) -> None:  # noqa: FBT001 - a parameter of a table
    settings, stored, wanted = TGA[name]
    path = tmp_path / "a.tga"
    path.write_bytes(raw.tga(stored, **settings, origin=origin, rle=rle))
    found = read_cel(path, white_is_clear=False).rgba
    near = 1 if name in {"1555", "555", "palette of 16"} else 0
    assert np.abs(found.astype(np.int64) - wanted).max() <= near
    assert np.array_equal(read_matte(path).whole(), wanted[..., 3]) or not probe(path).has_alpha
    assert probe(path).has_alpha == (wanted[..., 3].min() < 255)
    info = probe(path)
    assert (info.width_px, info.height_px, info.notes) == (W, H, ())


def test_a_tga_whose_alpha_is_all_zero_is_opaque_and_that_is_said(tmp_path: Path) -> None:
    clear = RGBA[..., BGRA].copy()
    clear[..., 3] = 0
    (tmp_path / "32.tga").write_bytes(raw.tga(clear, raw.COLOUR, bits=32, attributes=8))
    (tmp_path / "16.tga").write_bytes(raw.tga(raw.bytes_of(FIVES & 0x7FFF), raw.COLOUR, bits=16, attributes=1))
    palette = PALETTE[:, BGRA].copy()
    palette[:, 3] = 0
    data = raw.tga(PLACES, raw.PALETTE, bits=8, palette=palette.tobytes(), palette_bits=32)
    (tmp_path / "palette.tga").write_bytes(data)
    for path in sorted(tmp_path.glob("*.tga")):
        cel = read_cel(path, white_is_clear=False)
        assert cel.matte.is_full
        assert tuple(map(str, cel.notes)) == ("what could be its alpha is 0 everywhere and was taken as unused",)
        assert not has_alpha(path)
        assert read_matte(path).is_full


def test_a_tga_place_without_a_colour_is_a_sentence(tmp_path: Path) -> None:
    path = tmp_path / "a.tga"
    path.write_bytes(raw.tga(PLACES + 1, raw.PALETTE, bits=8, palette=PALETTE.tobytes(), palette_bits=32))
    with pytest.raises(InputProblem, match="a colour is not in its palette"):
        read_cel(path)
    path.write_bytes(path.read_bytes()[:60])
    with pytest.raises(InputProblem):
        read_cel(path)


# TIFF.

BLACK_IS_ZERO, WHITE_IS_ZERO, RGB, INDEXED, INKS = 1, 0, 2, 3, 5
STRAIGHT, UNSAID = 2, 0


def as_steps(numbers: Pixels, bits: int) -> Pixels:
    """The numbers of a file as 8 bit, or 16 where it has more."""
    full = 255 if bits <= 8 else 65535
    return np.asarray(np.round(numbers / (2**bits - 1) * full))


@pytest.mark.parametrize("bits", [1, 2, 4, 8, 12, 16, 32])
@pytest.mark.parametrize(
    ("photometric", "count", "extras", "alpha"),
    [
        (BLACK_IS_ZERO, 1, (), None),
        (WHITE_IS_ZERO, 1, (), None),
        (BLACK_IS_ZERO, 2, (STRAIGHT,), 1),
        (BLACK_IS_ZERO, 2, (UNSAID,), 1),
        (RGB, 3, (), None),
        (RGB, 4, (STRAIGHT,), 3),
        (RGB, 4, (UNSAID,), 3),
        (RGB, 5, (UNSAID, UNSAID), 3),
        (RGB, 5, (UNSAID, STRAIGHT), 4),
    ],
)
def test_numbers_of_a_tiff(
    tmp_path: Path, bits: int, photometric: int, count: int, extras: tuple[int, ...], alpha: int | None
) -> None:
    numbers = np.random.default_rng(bits).integers(0, 2**bits, (H, W, count), dtype=np.int64)
    path = tmp_path / "a.tif"
    path.write_bytes(raw.tiff(numbers, photometric, bits, extras=extras, packing=8))
    steps = as_steps(numbers, bits)
    colour = steps[..., :3] if photometric == RGB else steps[..., [0, 0, 0]]
    full = 255 if bits <= 8 else 65535
    colour = full - colour if photometric == WHITE_IS_ZERO else colour
    wanted = np.dstack([colour, np.full((H, W), full) if alpha is None else steps[..., alpha]])
    found = read_cel(path, white_is_clear=False).rgba.astype(np.int64)
    assert np.abs(found - wanted).max() <= (bits > 8)
    notes = said(path)
    first = "fourth" if photometric == RGB else "second"
    is_unsaid = bool(extras) and STRAIGHT not in extras
    assert is_unsaid == any(f"its {first} channel, of which it does not say" in note for note in notes)
    assert (count == 5) == any(note.startswith("not used of it: ") for note in notes)


WAYS = [
    {"big": big, "separate": separate, "tile": tile, "rows": rows, "packing": packing}
    for big, separate, (tile, rows), packing in itertools.product(
        (False, True), (False, True), ((None, None), (16, None), (None, 5)), (1, 8, 32773)
    )
]


@pytest.mark.parametrize("bits", [8, 16])
@pytest.mark.parametrize("ways", WAYS, ids=str)
def test_the_ways_of_a_tiff(tmp_path: Path, ways: dict[str, Any], bits: int) -> None:
    numbers = np.random.default_rng(7).integers(0, 2**bits, (H, W, 4))
    path = tmp_path / "a.tif"
    path.write_bytes(raw.tiff(numbers, RGB, bits, extras=(STRAIGHT,), **ways))
    assert np.array_equal(read_cel(path).rgba, numbers)
    assert said(path) == []


@pytest.mark.parametrize("bits", [1, 2, 4, 8])
def test_the_palette_of_a_tiff(tmp_path: Path, bits: int) -> None:
    colours = np.random.default_rng(8).integers(0, 256, (3, 2**bits))
    numbers = np.random.default_rng(9).integers(0, 2**bits, (H, W, 1))
    path = tmp_path / "a.tif"
    path.write_bytes(raw.tiff(numbers, INDEXED, bits, more=((320, raw.SHORT, (colours * 257).ravel().tolist()),)))
    wanted = opaque(colours[:, numbers[..., 0]].transpose(1, 2, 0).astype(np.uint8))
    assert np.array_equal(read_cel(path, white_is_clear=False).rgba, wanted)


def test_a_palette_of_a_tiff_with_alpha(tmp_path: Path) -> None:
    colours = np.random.default_rng(8).integers(0, 256, (3, 256))
    numbers = np.random.default_rng(9).integers(0, 256, (H, W, 2))
    path = tmp_path / "a.tif"
    more: tuple[raw.Tag, ...] = ((320, raw.SHORT, (colours * 257).ravel().tolist()),)
    path.write_bytes(raw.tiff(numbers, INDEXED, 8, extras=(STRAIGHT,), more=more))
    rgba = read_cel(path).rgba
    assert np.array_equal(rgba[..., 3], numbers[..., 1])
    assert np.array_equal(rgba[..., :3], colours[:, numbers[..., 0]].transpose(1, 2, 0))


@pytest.mark.parametrize(("kind", "bits"), [(3, 16), (3, 32), (3, 64), (2, 8), (2, 16), (2, 32)])
def test_floating_and_signed_numbers_of_a_tiff(tmp_path: Path, kind: int, bits: int) -> None:
    alpha = np.random.default_rng(10).random((H, W, 1))
    numbers = np.concatenate([np.zeros((H, W, 3)), alpha if kind == 3 else alpha * (2 ** (bits - 1) - 1)], axis=-1)
    path = tmp_path / "a.tif"
    path.write_bytes(raw.tiff(numbers, RGB, bits, kind=kind, extras=(STRAIGHT,)))
    near = 520 if kind == 2 and bits == 8 else 32
    found = read_matte(path).whole().astype(np.int64)
    assert np.abs(found - alpha[..., 0] * 65535).max() <= near


def test_inks(tmp_path: Path) -> None:
    numbers = np.random.default_rng(11).integers(0, 256, (H, W, 4)).astype(np.uint8)
    (tmp_path / "a.tif").write_bytes(raw.tiff(numbers, INKS, 8))
    Image.fromarray(numbers, "CMYK").save(tmp_path / "a.jpg", quality=100)
    wanted = (255 - numbers[..., :3].astype(np.float64)) * (255 - numbers[..., 3:]) / 255
    for name, near in (("a.tif", 1), ("a.jpg", 40)):
        found = read_cel(tmp_path / name, white_is_clear=False).rgba[..., :3]
        assert np.abs(found - wanted).max() <= near
        assert said(tmp_path / name) == ["its inks (CMYK) have no colour profile: its colours are an approximation"]
    more = np.concatenate([numbers, numbers[..., :1]], axis=-1)
    (tmp_path / "b.tif").write_bytes(raw.tiff(more, INKS, 8, extras=(STRAIGHT,)))
    with pytest.raises(InputProblem, match="inks with further channels"):
        read_cel(tmp_path / "b.tif")


# What Pillow writes.

GRADED = np.dstack([*np.meshgrid(np.arange(W) * 13, np.arange(H) * 12), np.full((H, W), 90), RGBA[..., 3]]).astype(
    np.uint8
)
WRITTEN: dict[str, tuple[Callable[[], Image.Image], str, dict[str, Any]]] = {
    "webp": (lambda: Image.fromarray(GRADED[..., :3]), "webp", {"lossless": True}),
    "webp with alpha": (lambda: Image.fromarray(GRADED), "webp", {"lossless": True, "exact": True}),
    "lossy webp": (lambda: Image.fromarray(GRADED[..., :3]), "webp", {"quality": 80}),
    "lossy webp with alpha": (lambda: Image.fromarray(GRADED), "webp", {"quality": 80}),
    "gif": (lambda: Image.fromarray(GRADED[..., :3]).quantize(40), "gif", {}),
    "gray gif": (lambda: Image.fromarray(GRADED[..., 0]), "gif", {}),
    "gif with a clear colour": (lambda: Image.fromarray(GRADED[..., :3]).quantize(40), "gif", {"transparency": 3}),
    "bmp": (lambda: Image.fromarray(GRADED[..., :3]), "bmp", {}),
    "gray bmp": (lambda: Image.fromarray(GRADED[..., 0]), "bmp", {}),
    "bmp of bits": (lambda: Image.fromarray(GRADED[..., 0] > 99), "bmp", {}),
    "bmp with a palette": (lambda: Image.fromarray(GRADED[..., :3]).quantize(40), "bmp", {}),
    "png with a palette": (lambda: Image.fromarray(GRADED).quantize(40), "png", {}),
    "png with gray and alpha": (lambda: Image.fromarray(GRADED[..., [0, 3]], "LA"), "png", {}),
    "jpeg": (lambda: Image.fromarray(GRADED[..., :3]), "jpg", {"quality": 90}),
    "gray jpeg": (lambda: Image.fromarray(GRADED[..., 0]), "jpg", {"quality": 90}),
    "progressive jpeg": (lambda: Image.fromarray(GRADED[..., :3]), "jpg", {"quality": 90, "progressive": True}),
    "tiff by lzw": (lambda: Image.fromarray(GRADED), "tif", {"compression": "tiff_lzw"}),
    "tiff by jpeg": (lambda: Image.fromarray(GRADED[..., :3]), "tif", {"compression": "jpeg"}),
    "fax": (lambda: Image.fromarray(GRADED[..., 0] > 99), "tif", {"compression": "group4"}),
}


@pytest.mark.parametrize("name", WRITTEN)
def test_what_pillow_writes_is_what_it_reads(tmp_path: Path, name: str) -> None:
    make, suffix, settings = WRITTEN[name]
    path = tmp_path / f"a.{suffix}"
    make().save(path, **settings)
    with Image.open(path) as image:
        wanted = np.asarray(image.convert("RGBA")).astype(np.int64)
    cel = read_cel(path, white_is_clear=False)
    seen = wanted[..., 3] > 0
    assert np.array_equal(cel.rgba[..., 3], wanted[..., 3])
    assert np.abs(cel.rgba.astype(np.int64) - wanted)[seen].max() <= ("jpeg" in name)
    assert probe(path).has_alpha == bool(wanted[..., 3].min() < 255)
    assert said(path) == []
