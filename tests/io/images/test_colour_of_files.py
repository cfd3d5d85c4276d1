"""Colours that files call something else than sRGB come out as sRGB; those that call it that are not touched."""

import io
import struct
from pathlib import Path
from typing import Any

import numpy as np
import OpenImageIO as oiio  # noqa: N813  # the name its own manual uses
import pytest
from numpy.typing import NDArray
from PIL import Image, ImageCms

from kagezou.io.images.reading import probe, read_cel, read_matte
from kagezou.io.pixels.colour_change import REC709, light_change, power_curves, xyz_of
from kagezou.io.pixels.icc import change_by_profile
from tests.io.images import picture_files as files
from tests.io.images import raw_files as raw

Pixels = NDArray[Any]
AP1 = (0.713, 0.293, 0.165, 0.830, 0.128, 0.044, 0.32168, 0.33767)
P3 = (0.680, 0.320, 0.265, 0.690, 0.150, 0.060, 0.3127, 0.3290)
ADOBE = (0.64, 0.33, 0.21, 0.71, 0.15, 0.06, 0.3127, 0.3290)
COLOURS = np.random.default_rng(3).integers(0, 256, (13, 17, 3)).astype(np.uint8)
COLOURS[0, 0] = 255


def fixed(*numbers: float) -> bytes:
    return struct.pack(f">{len(numbers)}i", *(round(each * 65536) for each in numbers))


def profile(primaries: tuple[float, ...], curve: bytes, space: bytes = b"RGB ") -> bytes:
    """A profile of a matrix and one curve, or of gray."""
    tags: list[tuple[bytes, bytes]] = [(b"wtpt", b"XYZ \0\0\0\0" + fixed(0.9642, 1.0, 0.8249))]
    if space == b"GRAY":
        tags.append((b"kTRC", curve))
    else:
        columns = xyz_of(primaries).T  # type: ignore[arg-type]
        tags += [
            (name + b"XYZ", b"XYZ \0\0\0\0" + fixed(*column))
            for name, column in zip((b"r", b"g", b"b"), columns, strict=True)
        ]
        tags += [(name + b"TRC", curve) for name in (b"r", b"g", b"b")]
    table, body = struct.pack(">I", len(tags)), b""
    at = 132 + 12 * len(tags)
    for name, data in tags:
        table += struct.pack(">4sII", name, at + len(body), len(data))
        body += data.ljust((len(data) + 3) // 4 * 4, b"\0")
    head = bytearray(128)
    struct.pack_into(
        ">I4sI4s4s4s", head, 0, 128 + len(table) + len(body), b"\0\0\0\0", 0x02400000, b"mntr", space, b"XYZ "
    )
    head[36:40] = b"acsp"
    head[68:80] = fixed(0.9642, 1.0, 0.8249)
    return bytes(head) + table + body


def gamma(exponent: float) -> bytes:
    return b"curv\0\0\0\0" + struct.pack(">IH", 1, round(exponent * 256))


SRGB_PARAMETERS = b"para\0\0\0\0" + struct.pack(">HH", 3, 0) + fixed(2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045)
TABLE = np.linspace(0, 1, 1024) ** 1.8 * 65535
PROFILES = {
    "Adobe RGB": profile(ADOBE, gamma(563 / 256)),
    "Display P3": profile(P3, SRGB_PARAMETERS),
    "wide and linear": profile(AP1, b"curv\0\0\0\0" + struct.pack(">I", 0)),
    "a table": profile(P3, b"curv\0\0\0\0" + struct.pack(">I", 1024) + TABLE.astype(">u2").tobytes()),
    "kind 1": profile(P3, b"para\0\0\0\0" + struct.pack(">HH", 1, 0) + fixed(2.2, 0.9, 0.1)),
    "kind 4": profile(P3, b"para\0\0\0\0" + struct.pack(">HH", 4, 0) + fixed(2.4, 0.9, 0.1, 0.05, 0.1, 0.0, 0.0)),
}  # fmt: skip


def by_lcms(pixels: Pixels, given: bytes) -> Pixels:
    """What another program makes of it."""
    made = ImageCms.profileToProfile(
        Image.fromarray(pixels), ImageCms.ImageCmsProfile(io.BytesIO(given)), ImageCms.createProfile("sRGB"),
        renderingIntent=ImageCms.Intent.RELATIVE_COLORIMETRIC,
    )  # fmt: skip
    assert made is not None
    return np.asarray(made).astype(np.int64)


@pytest.mark.parametrize("name", PROFILES)
@pytest.mark.parametrize("suffix", ["png", "tif", "webp", "jpg"])
def test_a_profile_is_followed(tmp_path: Path, name: str, suffix: str) -> None:
    path = tmp_path / f"a.{suffix}"
    every: dict[str, dict[str, Any]] = {"webp": {"lossless": True}, "jpg": {"quality": 95, "subsampling": 0}}
    settings = every.get(suffix, {})
    smooth = np.repeat(np.repeat(COLOURS[:4, :4], 8, axis=0), 8, axis=1)
    Image.fromarray(smooth).save(path, icc_profile=PROFILES[name], **settings)
    with Image.open(path) as image:
        stored = np.asarray(image.convert("RGB"))
    found = read_cel(path, white_is_clear=False).rgba[..., :3].astype(np.int64)
    assert np.abs(found - by_lcms(stored, PROFILES[name])).max() <= 2 + (suffix == "jpg")
    assert np.abs(found - stored).max() > 4
    assert found[0, 0].tolist() == [255, 255, 255]
    assert probe(path).notes == ()


def test_pure_white_stays_so_at_16_bit(tmp_path: Path) -> None:
    pixels = np.full((3, 4, 3), 65535)
    pixels[1] = 30000, 20000, 10000
    for name, given in PROFILES.items():
        path = tmp_path / f"{name}.tif"
        path.write_bytes(raw.tiff(pixels, 2, 16, more=((34675, raw.BYTES, given),)))
        cel = read_cel(path)
        assert cel.rgba[0, 0].tolist() == [65535, 65535, 65535, 0]
        assert cel.rgba[1, 0, :3].tolist() != [30000, 20000, 10000]


@pytest.mark.parametrize(
    "given",
    [ImageCms.ImageCmsProfile(ImageCms.createProfile("sRGB")).tobytes(), profile(REC709, SRGB_PARAMETERS)],
)
@pytest.mark.parametrize("suffix", ["png", "tif", "webp"])
def test_a_profile_of_srgb_changes_no_number(tmp_path: Path, given: bytes, suffix: str) -> None:
    settings: dict[str, Any] = {"lossless": True} if suffix == "webp" else {}
    path = tmp_path / f"a.{suffix}"
    save: Any = Image.fromarray(COLOURS).save
    save(path, icc_profile=given, **settings)
    assert np.array_equal(read_cel(path, white_is_clear=False).rgba[..., :3], COLOURS)
    assert probe(path).notes == ()


def test_gray(tmp_path: Path) -> None:
    ramp = np.arange(256, dtype=np.uint8).reshape(16, 16)
    Image.fromarray(ramp).save(tmp_path / "a.tif", icc_profile=profile((), gamma(1.0), b"GRAY"))
    found = read_cel(tmp_path / "a.tif", white_is_clear=False).rgba[..., 0]
    light = ramp / 255
    wanted = np.where(light <= 0.0031308, light * 12.92, 1.055 * light ** (1 / 2.4) - 0.055) * 255
    assert np.abs(found - wanted).max() <= 1


@pytest.mark.parametrize(
    ("given", "note"),
    [
        (b"no profile", "its colour profile is damaged and not used"),
        (PROFILES["Display P3"][:200], "its colour profile is damaged and not used"),
        (profile(P3, b"text\0\0\0\0none"), "its colour profile is damaged and not used"),
        (profile(P3, b"para\0\0\0\0" + struct.pack(">HH", 9, 0)), "its colour profile is damaged and not used"),
        (profile((), gamma(1.0), b"GRAY"), "its colour profile is not used"),
        (PROFILES["Display P3"].replace(b"rXYZ", b"xXYZ"), "its colour profile is not used"),
        (PROFILES["Display P3"].replace(b"RGB XYZ ", b"RGB Lab "), "its colour profile is not used"),
    ],
)
def test_a_profile_that_cannot_be_followed_is_told(tmp_path: Path, given: bytes, note: str) -> None:
    assert str(change_by_profile(given, is_gray=False)) == note
    (tmp_path / "a.tif").write_bytes(raw.tiff(COLOURS, 2, 8, more=((34675, raw.BYTES, given),)))
    assert np.array_equal(read_cel(tmp_path / "a.tif", white_is_clear=False).rgba[..., :3], COLOURS)
    assert note in map(str, probe(tmp_path / "a.tif").notes)


def test_the_matte_does_not_ask_for_colours(tmp_path: Path) -> None:
    pixels = np.dstack([COLOURS, COLOURS[..., 0]])
    Image.fromarray(pixels).save(tmp_path / "a.png", icc_profile=PROFILES["Display P3"])
    assert np.array_equal(read_matte(tmp_path / "a.png").whole(), pixels[..., 3])


# PNG's own chunks.


def save_png(path: Path, *chunks: tuple[bytes, bytes]) -> Path:
    rows = np.zeros((13, 1 + 17 * 3), np.uint8)
    rows[:, 1:] = COLOURS.reshape(13, -1)
    path.write_bytes(files.png((17, 13), 8, 2, rows.tobytes(), b"".join(files.chunk(*each) for each in chunks)))
    return path


def primaries(numbers: tuple[float, ...]) -> bytes:
    *rgb, wx, wy = numbers
    return struct.pack(">8I", *(round(each * 100000) for each in (wx, wy, *rgb)))


LINEAR = b"gAMA", struct.pack(">I", 100000)
USUAL = b"gAMA", struct.pack(">I", 45455)


@pytest.mark.parametrize(
    "chunks",
    [
        (USUAL,),
        (USUAL, (b"cHRM", primaries(REC709))),
        ((b"sRGB", b"\0"), LINEAR),
        ((b"cICP", bytes([1, 13, 0, 1])), LINEAR),
        ((b"gAMA", bytes(4)),),
        ((b"gAMA", b"x"), (b"cHRM", b"x")),
        ((b"cHRM", bytes(32)),),
    ],
)
def test_png_that_is_srgb_is_not_touched(tmp_path: Path, chunks: tuple[tuple[bytes, bytes], ...]) -> None:
    path = save_png(tmp_path / "a.png", *chunks)
    assert np.array_equal(read_cel(path, white_is_clear=False).rgba[..., :3], COLOURS)
    assert probe(path).notes == ()


@pytest.mark.parametrize(
    ("chunks", "given"),
    [
        ((LINEAR,), profile(REC709, gamma(1.0))),
        ((USUAL, (b"cHRM", primaries(ADOBE))), profile(ADOBE, SRGB_PARAMETERS)),
        (((b"gAMA", struct.pack(">I", 55556)),), profile(REC709, gamma(1.8))),
        (((b"cICP", bytes([12, 13, 0, 1])),), profile(P3, SRGB_PARAMETERS)),
        (((b"cICP", bytes([12, 8, 0, 1])), (b"sRGB", b"\0")), profile(P3, gamma(1.0))),
    ],
)
def test_png_that_says_other_colours(tmp_path: Path, chunks: tuple[tuple[bytes, bytes], ...], given: bytes) -> None:
    found = read_cel(save_png(tmp_path / "a.png", *chunks), white_is_clear=False).rgba[..., :3].astype(np.int64)
    assert np.abs(found - by_lcms(COLOURS, given)).max() <= 2
    assert np.abs(found - COLOURS).max() > 8


def test_png_of_a_bright_screen_is_told(tmp_path: Path) -> None:
    path = save_png(tmp_path / "a.png", (b"cICP", bytes([9, 16, 0, 1])))
    assert [str(note) for note in probe(path).notes] == ["its colours are taken as sRGB, though it calls them 9/16"]


# OpenEXR.


def save_exr(path: Path, light: Pixels, **settings: Any) -> Path:
    spec = oiio.ImageSpec(light.shape[1], light.shape[0], light.shape[2], oiio.FLOAT)
    for name, value in settings.items():
        spec.attribute(name, *value if isinstance(value, tuple) else (value,))
    out = oiio.ImageOutput.create(str(path))
    assert out is not None
    assert out.open(str(path), spec), out.geterror()
    assert out.write_image(light.astype(np.float32))
    assert out.close()
    return path


def chromaticities(numbers: tuple[float, ...]) -> Any:
    return oiio.TypeDesc("float[8]"), numbers


@pytest.mark.parametrize(("given", "alpha"), [(AP1, False), (P3, False), (ADOBE, False), (AP1, True)])
def test_one_picture_in_two_spaces_looks_the_same(tmp_path: Path, given: tuple[float, ...], alpha: bool) -> None:  # noqa: FBT001
    light = np.random.default_rng(4).uniform(0.05, 0.9, (9, 8, 3))
    xyz_of_given: Any = xyz_of(given)  # type: ignore[arg-type]
    change = np.linalg.inv(xyz_of_given) @ xyz_of(REC709)
    cover = np.full((9, 8, 1), 0.5) if alpha else np.ones((9, 8, 0))
    scale = 0.5 if alpha else 1.0
    plain = save_exr(tmp_path / "a.exr", np.concatenate([light * scale, cover], axis=-1))
    other = save_exr(
        tmp_path / "b.exr",
        np.concatenate([light @ change.T * scale, cover], axis=-1),
        chromaticities=chromaticities(given),
    )
    one, two = (read_cel(path, white_is_clear=False).rgba.astype(np.int64) for path in (plain, other))
    assert np.abs(one - two).max() <= 257
    assert probe(other).notes == ()


@pytest.mark.parametrize("name", ["acescg", "ACEScg", "lin_ap1_scene", "ACES - ACEScg"])
def test_a_space_by_its_name(tmp_path: Path, name: str) -> None:
    light = np.full((3, 4, 3), [0.5, 0.1, 0.1])
    named = save_exr(tmp_path / "a.exr", light, colorInteropID=name)
    said = save_exr(tmp_path / "b.exr", light, chromaticities=chromaticities(AP1))
    assert np.array_equal(read_cel(named, white_is_clear=False).rgba, read_cel(said, white_is_clear=False).rgba)


def test_a_space_that_is_not_known_is_told(tmp_path: Path) -> None:
    path = save_exr(tmp_path / "a.exr", np.full((3, 4, 3), 0.5), colorInteropID="arri_wide_gamut")
    assert [str(note) for note in probe(path).notes] == [
        "its colours are taken as linear light of Rec. 709, though it calls them arri_wide_gamut"
    ]


def test_primaries_that_span_nothing_change_nothing() -> None:
    assert light_change((0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3)) is None
    assert light_change((0.0,) * 8) is None
    assert light_change((float("nan"),) * 8) is None
    assert light_change(REC709) is None
    assert light_change(REC709, power_curves(1.0)) is not None
