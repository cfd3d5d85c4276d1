"""OpenEXR files of several layers and parts: one of them is the picture, the others are told."""

from pathlib import Path
from typing import Any

import numpy as np
import OpenImageIO as oiio  # noqa: N813  # the name its own manual uses
import pytest
from numpy.typing import NDArray

from kagezou.errors import InputProblem
from kagezou.io.images.exr_layers import chosen_layer, layers_in
from kagezou.io.images.parts import exr_layer_names, has_part
from kagezou.io.images.reading import probe, read_cel, read_matte
from kagezou.picture_source import PicturePart
from tests.io.images import picture_files as files

Pixels = NDArray[Any]


def save(path: Path, channels: dict[str, float], **settings: Any) -> Path:
    """Write a file of one part, each channel of one value."""
    pixels = np.zeros((3, 4, len(channels)), np.float32) + np.array([*channels.values()], np.float32)
    spec = oiio.ImageSpec(4, 3, len(channels), oiio.FLOAT)
    spec.channelnames = tuple(channels)
    for name, value in settings.items():
        spec.attribute(name, value)
    write(path, [(spec, pixels)])
    return path


def save_parts(path: Path, parts: dict[str, dict[str, float]]) -> Path:
    """Write a file of named parts."""
    made = []
    for name, channels in parts.items():
        spec = oiio.ImageSpec(4, 3, len(channels), oiio.FLOAT)
        spec.channelnames = tuple(channels)
        spec.attribute("oiio:subimagename", name)
        made.append((spec, np.zeros((3, 4, len(channels)), np.float32) + np.array([*channels.values()], np.float32)))
    write(path, made)
    return path


def write(path: Path, parts: list[tuple[oiio.ImageSpec, Pixels]]) -> None:
    out = oiio.ImageOutput.create(str(path))
    assert out is not None
    assert out.open(str(path), tuple(spec for spec, _ in parts)), out.geterror()
    for index, (spec, pixels) in enumerate(parts):
        assert index == 0 or out.open(str(path), spec, "AppendSubimage"), out.geterror()
        assert out.write_image(pixels), out.geterror()
    assert out.close()


def rgb(prefix: str, light: float, alpha: float | None = None) -> dict[str, float]:
    return {f"{prefix}{name}": light for name in "RGB"} | ({} if alpha is None else {f"{prefix}A": alpha})


def first_pixel(source: Path | PicturePart) -> list[float]:
    """Red and alpha of a picture, in linear light of 0 to 1."""
    red, _, _, alpha = (read_cel(source, white_is_clear=False).rgba[0, 0] / 65535).tolist()
    return [round(((red + 0.055) / 1.055) ** 2.4, 2), round(alpha, 2)]


def said(source: Path | PicturePart) -> list[str]:
    return list(map(str, probe(source).notes))


def test_the_unnamed_layer_comes_first(tmp_path: Path) -> None:
    path = save(tmp_path / "a.exr", rgb("diffuse.", 0.1, 1.0) | rgb("", 0.2, 0.5) | {"Z": 9.0})
    assert first_pixel(path) == [0.4, 0.5]
    assert said(path) == ["not used of it: Z, diffuse"]
    assert exr_layer_names(path) == ("", "diffuse")


@pytest.mark.parametrize("name", ["beauty", "rgba", "Combined", "ViewLayer.Combined", "color", "main"])
def test_a_layer_called_like_the_picture_comes_before_others(tmp_path: Path, name: str) -> None:
    path = save(tmp_path / "a.exr", rgb("albedo.", 0.1, 1.0) | rgb(f"{name}.", 0.4, 0.8) | rgb("zz.", 0.9, 1.0))
    assert first_pixel(path) == [0.5, 0.8]
    assert read_matte(path).whole()[0, 0] == round(0.8 * 65535)
    assert said(path) == ["not used of it: albedo, zz"]


def test_else_the_first_in_colour(tmp_path: Path) -> None:
    path = save(tmp_path / "a.exr", {"depth.Z": 4.0} | rgb("key.", 0.3, 1.0) | rgb("rim.", 0.9, 1.0))
    assert first_pixel(path) == [0.3, 1.0]
    assert said(path) == ["not used of it: depth.Z, rim"]


def test_the_alpha_is_never_that_of_another_layer(tmp_path: Path) -> None:
    path = save(tmp_path / "a.exr", rgb("beauty.", 0.3) | rgb("mask.", 0.9, 0.25))
    assert first_pixel(path) == [0.3, 1.0]
    assert not probe(path).has_alpha
    assert "the layer beauty is used, which has no alpha" in said(path)


def test_an_unnamed_alpha_belongs_to_a_named_layer_without_one(tmp_path: Path) -> None:
    path = save(tmp_path / "a.exr", rgb("beauty.", 0.25) | {"A": 0.5})
    assert first_pixel(path) == [0.5, 0.5]
    assert said(path) == ["the layer beauty has no alpha of its own; that of the file is used"]


def test_parts(tmp_path: Path) -> None:
    path = save_parts(
        tmp_path / "a.exr",
        {"depth": {"Z": 4.0}, "diffuse": rgb("", 0.1, 1.0), "rgba": rgb("", 0.2, 0.5), "spec": rgb("spec.", 0.7, 1.0)},
    )
    assert first_pixel(path) == [0.4, 0.5]
    assert said(path) == ["not used of it: depth.Z, diffuse, spec"]
    assert exr_layer_names(path) == ("rgba", "diffuse", "spec")
    assert first_pixel(PicturePart(path, "diffuse")) == [0.1, 1.0]
    assert first_pixel(PicturePart(path, "spec")) == [0.7, 1.0]
    assert read_matte(PicturePart(path, "rgba")).whole()[0, 0] == 32768


def test_a_chosen_layer(tmp_path: Path) -> None:
    path = save(
        tmp_path / "a.exr", rgb("", 0.2, 1.0) | rgb("diffuse.left.", 0.6, 1.0) | {f"c{n}.x": 1.0 for n in range(9)}
    )
    part = PicturePart(path, "diffuse.left")
    assert first_pixel(part) == [0.6, 1.0]
    assert has_part(part)
    assert not has_part(PicturePart(path, "diffuse"))
    assert said(part) == ["not used of it: RGBA, c0.x, c1.x, c2.x, c3.x and 5 more"]
    with pytest.raises(InputProblem, match=r"there is no layer 'x' in it, but there are: '', diffuse.left"):
        read_cel(PicturePart(path, "x"))


def test_other_spellings(tmp_path: Path) -> None:
    path = save(tmp_path / "a.exr", {"Beauty.red": 0.3, "Beauty.green": 0.3, "Beauty.blue": 0.3, "Beauty.alpha": 1.0})
    assert first_pixel(path) == [0.3, 1.0]
    path = save(tmp_path / "b.exr", {"Y": 0.3, "A": 1.0, "Z": 3.0})
    assert first_pixel(path) == [0.3, 1.0]
    assert said(path) == ["not used of it: Z"]


def test_many_channels(tmp_path: Path) -> None:
    many = {f"crypto{n:02}.{each}": 0.7 for n in range(40) for each in "RGBA"}
    path = save(tmp_path / "a.exr", many | {"b.R": 0.3, "b.G": 0.3, "b.B": 0.3, "A": 1.0})
    assert len(exr_layer_names(path)) == 42
    assert first_pixel(PicturePart(path, "b")) == [0.3, 1.0]


def test_layers_by_names() -> None:
    found = layers_in([(0, "", ("A.R", "A.G", "A.B", "A.A", "R", "G", "B", "N.x", "N.y"))])
    assert [(each.name, each.colour, each.alpha) for each in found] == [
        ("A", (0, 1, 2), 3), ("", (4, 5, 6), None), ("N", (), None),
    ]  # fmt: skip
    chosen = chosen_layer(found)
    assert chosen is not None
    assert chosen.name == ""
    assert chosen_layer(()) is None


# Backgrounds and cels whose light has no cover.


def test_a_background_of_alpha_zero_is_seen(tmp_path: Path) -> None:
    for name, number in (("a.exr", 0.5), ("a.png", 90), ("a.tif", 90)):
        path = tmp_path / name
        pixels = np.full((3, 4, 4), number, np.float32 if name == "a.exr" else np.uint8)
        pixels[..., 3] = 0
        files.save(path, pixels, straight=name == "a.png")
        cel = read_cel(path, white_is_clear=False)
        assert cel.matte.is_full
        assert cel.rgba[..., 0].min() > 0
        assert [str(note) for note in cel.notes] == [
            "its alpha is 0 everywhere; its colours are seen as if there were none"
        ]


def test_a_clear_background_stays_clear(tmp_path: Path) -> None:
    files.save(tmp_path / "a.exr", np.zeros((3, 4, 4), np.float32), straight=False)
    cel = read_cel(tmp_path / "a.exr", white_is_clear=False)
    assert (cel.matte.box, cel.notes) == (None, ())


@pytest.mark.parametrize("name", ["a.exr", "a.tif"])
def test_a_glow_is_seen_over_black_and_left_out_of_a_cel(tmp_path: Path, name: str) -> None:
    full = 1.0 if name == "a.exr" else 255
    pixels = np.zeros((3, 4, 4), np.float32 if name == "a.exr" else np.uint8)
    pixels[0] = full
    pixels[1] = np.array([full * 0.5, full * 0.25, 0, 0])
    files.save(tmp_path / name, pixels, straight=False)
    cel = read_cel(tmp_path / name)
    assert [str(note) for note in cel.notes] == ["it has light where its alpha is 0, as a glow has; that is not used"]
    assert cel.matte.whole()[1].max() == 0
    assert np.array_equal(read_matte(tmp_path / name).whole(), cel.matte.whole())
    seen = read_cel(tmp_path / name, white_is_clear=False)
    assert [str(note) for note in seen.notes] == [
        "it has light where its alpha is 0; that is seen as a glow over what is behind it"
    ]
    most = 65535 if name == "a.exr" else 255
    unit = seen.rgba[1, 0] / most
    assert abs(unit[3] - 0.5) < 0.01
    light = ((unit[:3] + 0.055) / 1.055) ** 2.4 if name == "a.exr" else unit[:3]
    assert np.abs(light * unit[3] - [0.5, 0.25, 0]).max() < 0.01
    assert seen.rgba[2, 0].tolist() == [0, 0, 0, 0]
