"""Frames as one file of layers: read back by psd-tools and OpenImageIO, not by ourselves."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import OpenImageIO as oiio  # noqa: N813  # the name its own manual uses
import pytest
from numpy.typing import NDArray
from psd_tools import PSDImage
from psd_tools.composite import composite
from psd_tools.constants import BlendMode

from kagezou.document.edits import add_layer, set_background
from kagezou.document.model import Cels, Document, Exposure
from kagezou.errors import OutputProblem, UsageProblem
from kagezou.geometry.box import Box
from kagezou.io.images import oiio_parts
from kagezou.io.images.layered import write_layered
from kagezou.io.images.reading import read_cel
from kagezou.io.images.writing import write_rgba
from kagezou.io.pixels.layers import LayeredImage, LayerPart
from kagezou.picture_source import PicturePart
from tests.export.small_cuts import HEIGHT, WIDTH, bytes_below, cut, drawings, export, with_key, with_values


@pytest.fixture
def pair(tmp_path: Path) -> Document:
    """Two characters over a background, the second hidden from frame 3; the first has a half-clear shadow."""
    document = cut(tmp_path, 4, name="主役")
    cels = Cels(drawings(tmp_path / "b", 2, "b"), (Exposure(1, 0), Exposure(2, 1)))
    document = add_layer(document, "相棒", cels, Box(12, 20, 20, 40))
    meadow = np.full((HEIGHT, WIDTH, 4), (120, 180, 90, 255), np.uint8)
    write_rgba(tmp_path / "meadow.png", meadow)
    document = set_background(document, tmp_path / "meadow.png")
    document = with_values(document, layers__主役__shadow__opacity=0.5, layers__主役__shadow__color="#203040")
    document = with_key(document, "layers.相棒.visible", 1, value=True)
    return with_key(document, "layers.相棒.visible", 3, value=False)


def opened(path: Path) -> Any:
    return oiio.ImageInput.open(str(path))


def laid(parts: list[tuple[NDArray[Any], tuple[int, int], float, bool]]) -> NDArray[np.float64]:
    """Lay straight parts (h, w, 4) on an opaque canvas, in float64."""
    canvas = np.zeros((HEIGHT, WIDTH, 3))
    for pixels, (left, top), opacity, multiply in parts:
        height, width = pixels.shape[:2]
        under = canvas[top : top + height, left : left + width]
        unit = pixels / 255.0
        over = unit[..., :3] * under if multiply else unit[..., :3]
        alpha = unit[..., 3:] * opacity
        under[...] = under * (1 - alpha) + over * alpha
    return canvas * 255


def test_a_photoshop_document_holds_every_layer_in_order(pair: Document, tmp_path: Path) -> None:
    export(pair, tmp_path / "out", layered=True, format="psd")
    assert sorted(bytes_below(tmp_path / "out")) == [f"layered/layered_{frame:04d}.psd" for frame in range(1, 5)]
    document = PSDImage.open(tmp_path / "out/layered/layered_0001.psd")
    assert document.size == (WIDTH, HEIGHT)
    assert [layer.name for layer in document] == ["background", "主役_shadow", "相棒_shadow", "主役", "相棒"]
    normal, multiply = BlendMode.NORMAL, BlendMode.MULTIPLY
    assert [layer.blend_mode for layer in document] == [normal, multiply, multiply, normal, normal]
    assert document[1].opacity == 128
    shadow = np.asarray(document[1].topil())
    assert tuple(shadow[shadow[..., 3] == 255][0][:3]) == (0x20, 0x30, 0x40)
    assert document[3].bbox == (11, 20, 20, 40)


def test_the_layers_of_a_document_make_the_merged_picture(pair: Document, tmp_path: Path) -> None:
    export(pair, tmp_path / "out", layered=True, format="psd")
    export(pair, tmp_path / "out", composite=True)
    document = PSDImage.open(tmp_path / "out/layered/layered_0002.psd")
    parts = [
        (np.asarray(each.topil()), each.offset, each.opacity / 255, each.blend_mode == BlendMode.MULTIPLY)
        for each in document
    ]
    merged = np.asarray(document.topil())
    assert np.abs(laid(parts) - merged[..., :3]).max() <= 1.5
    source = opened(tmp_path / "out/composite/composite_0002.png")
    assert np.array_equal(source.read_image(oiio.UINT8)[..., :3], merged[..., :3])
    source.close()


def test_a_document_of_16_bit_holds_what_single_pictures_of_16_bit_hold(pair: Document, tmp_path: Path) -> None:
    document = with_values(pair, layers__主役__shadow__softness=6.0)
    export(document, tmp_path / "out", layered=True, format="psd", depth=16, frames=(1, 3))
    export(document, tmp_path / "alone", composite=True, depth=16, frames=(1, 3))
    for frame in (1, 3):
        path = tmp_path / f"out/layered/layered_{frame:04d}.psd"
        stored: Any = PSDImage.open(path)
        assert stored.depth == 16
        assert [each.name for each in stored] == ["background", "主役_shadow", "相棒_shadow", "主役", "相棒"]
        assert stored[1].opacity == 128
        picture = read_cel(tmp_path / f"alone/composite/composite_{frame:04d}.png").rgba
        assert len(np.unique(picture % 257)) > 9, "there is something to lose in 8 bit"
        assert np.array_equal(read_cel(path).rgba, picture)
        meadow = read_cel(PicturePart(path, "background")).rgba
        assert np.array_equal(meadow[0, 0], np.array([120, 180, 90, 255]) * 257)
        cel = read_cel(PicturePart(path, "主役")).rgba
        assert np.array_equal(cel, read_cel(tmp_path / f"drawings/a_{frame:04d}.png").rgba.astype(np.uint16) * 257)
        alpha = stored[1].numpy("shape")[..., 0] * 0.5 * 65535
        left, top = stored[1].offset
        alone = read_cel(tmp_path / f"alone/主役_shadow/主役_shadow_{frame:04d}.png").rgba[..., 3]
        assert np.abs(alone[top : top + alpha.shape[0], left : left + alpha.shape[1]] - alpha).max() <= 1.01
    assert stored[4].bbox == (0, 0, 0, 0), "a hidden layer is there and empty"


def test_an_exr_has_a_part_for_every_layer(pair: Document, tmp_path: Path) -> None:
    export(pair, tmp_path / "out", layered=True, format="exr", depth=16)
    export(pair, tmp_path / "alone", format="exr", depth=16)
    source = opened(tmp_path / "out/layered/layered_0001.exr")
    names, blends, index = [], [], 0
    while source.seek_subimage(index, 0):
        spec = source.spec()
        names.append(spec.get_string_attribute("oiio:subimagename"))
        blends.append(spec.get_string_attribute("kagezou:blend"))
        assert (spec.full_width, spec.full_height) == (WIDTH, HEIGHT)
        if index == 1:
            shadow = np.zeros((HEIGHT, WIDTH, 4), np.float32)
            box = (slice(spec.y, spec.y + spec.height), slice(spec.x, spec.x + spec.width))
            shadow[box] = source.read_image(index, 0, 0, 4, oiio.FLOAT)
        index += 1
    assert names == ["background", "主役_shadow", "相棒_shadow", "主役", "相棒"]
    assert blends == ["normal", "multiply", "multiply", "normal", "normal"]
    source.close()
    alone = opened(tmp_path / "alone/主役_shadow/主役_shadow_0001.exr")
    assert np.array_equal(alone.read_image(oiio.FLOAT), shadow)
    alone.close()


def test_a_hidden_layer_is_there_and_empty(pair: Document, tmp_path: Path) -> None:
    for form, depth in (("psd", 8), ("exr", 16)):
        export(pair, tmp_path / "out", layered=True, format=form, depth=depth, frames=(3,))
    document = PSDImage.open(tmp_path / "out/layered/layered_0003.psd")
    assert [layer.name for layer in document] == ["background", "主役_shadow", "相棒_shadow", "主役", "相棒"]
    assert document[4].bbox == (0, 0, 0, 0)
    source = opened(tmp_path / "out/layered/layered_0003.exr")
    assert not source.read_image(4, 0, 0, 4, oiio.FLOAT).any()
    assert not source.seek_subimage(5, 0)
    source.close()


def test_chosen_layers_stand_alone(pair: Document, tmp_path: Path) -> None:
    export(pair, tmp_path / "out", layered=True, format="psd", layers=("相棒",), frames=(1,))
    document = PSDImage.open(tmp_path / "out/layered/layered_0001.psd")
    assert [layer.name for layer in document] == ["相棒_shadow", "相棒"]
    merged = np.asarray(document.topil())
    assert merged[0, 0, 3] == 0


def test_bytes_do_not_depend_on_workers_and_held_frames_are_alike(tmp_path: Path) -> None:
    document = cut(tmp_path, 3, length=5)
    for workers in (1, 3):
        for form, depth in (("psd", 8), ("exr", 16)):
            export(document, tmp_path / str(workers), layered=True, format=form, depth=depth, workers=workers)
        export(document, tmp_path / str(workers) / "deep", layered=True, format="psd", depth=16, workers=workers)
    made, others = bytes_below(tmp_path / "1"), bytes_below(tmp_path / "3")
    assert made.keys() == others.keys()
    assert [name for name in made if made[name] != others[name]] == []
    assert made["layered/layered_0003.psd"] == made["layered/layered_0005.psd"]
    again = export(document, tmp_path / "1", layered=True, format="exr", depth=16, skip_existing=True)
    assert (again.written, again.trusted) == (0, 5)


def test_layers_called_like_a_shadow_are_told_apart(tmp_path: Path) -> None:
    document = cut(tmp_path, 1)
    document = add_layer(document, "A_shadow", document.layers[0].cels, Box(12, 20, 20, 40))
    export(document, tmp_path / "out", layered=True, format="psd")
    layers: Any = list(PSDImage.open(tmp_path / "out/layered/layered_0001.psd"))
    shadows, *characters = layers
    assert [layer.name for layer in shadows] == ["A_shadow", "A_shadow_shadow"]
    assert [layer.name for layer in characters] == ["A", "A_shadow_"]


@pytest.mark.parametrize(
    ("wishes", "words"),
    [
        ({"layered": True, "format": "png"}, "layered frames cannot be written as 'png', only as psd or exr"),
        ({"layered": True, "format": "psd", "composite": True}, "ask for one of the two"),
        ({"format": "psd"}, "which needs layered frames"),
        ({"layered": True, "format": "psd", "depth": 32}, "psd frames have 8 or 16 bits"),
    ],
)
def test_what_does_not_go_together_is_refused(tmp_path: Path, wishes: dict[str, Any], words: str) -> None:
    with pytest.raises(UsageProblem, match=words):
        export(cut(tmp_path, 1), tmp_path / "out", **wishes)


def test_a_writer_that_lies_leaves_the_old_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "a.exr"
    path.write_bytes(b"old")
    image = LayeredImage(4, 3, (LayerPart("a", np.full((3, 4, 4), 99, np.uint8), Box(0, 0, 4, 3)),))
    real = oiio_parts._written

    def lying(temp: Path, specs: Any, parts: Any) -> str:
        dark = [replace(part, light=part.light * np.float16(0.5)) for part in parts]
        return real(temp, specs, dark)

    monkeypatch.setattr(oiio_parts, "_written", lying)
    with pytest.raises(OutputProblem, match="reads back differently"):
        write_layered(path, image)
    assert [each.name for each in tmp_path.iterdir()] == ["a.exr"]
    assert path.read_bytes() == b"old"


def test_a_document_has_its_largest_size(tmp_path: Path) -> None:
    with pytest.raises(OutputProblem, match="at most 30000 px"):
        write_layered(tmp_path / "a.psd", LayeredImage(30001, 1, ()))
    with pytest.raises(UsageProblem, match=r"\.exr or \.psd"):
        write_layered(tmp_path / "a.png", LayeredImage(4, 3, ()))


@pytest.fixture
def alike(pair: Document) -> Document:
    """The pair with soft shadows of one look, which lie on each other."""
    document = with_values(pair, layers__相棒__shadow__opacity=0.5, layers__相棒__shadow__color="#203040")
    return with_values(document, layers__主役__shadow__softness=9.0, layers__相棒__shadow__softness=14.0)


def test_the_parts_of_a_group_are_laid_alike_where_one_is_empty(alike: Document, tmp_path: Path) -> None:
    export(alike, tmp_path / "out", layered=True, format="exr", depth=16, frames=(3,))
    source = opened(tmp_path / "out/layered/layered_0003.exr")
    blends = []
    for index in (1, 2):
        assert source.seek_subimage(index, 0)
        blends.append(source.spec().get_string_attribute("kagezou:blend"))
    assert not source.read_image(2, 0, 0, 4, oiio.FLOAT).any(), "the second is hidden"
    source.close()
    assert blends == ["multiply", "multiply"]


@pytest.mark.parametrize("depth", [8, 16])
def test_shadows_of_one_look_are_a_group_that_is_laid_once(alike: Document, tmp_path: Path, depth: int) -> None:
    export(alike, tmp_path / "out", layered=True, format="psd", depth=depth)
    for frame in (1, 2, 3):
        stored: Any = PSDImage.open(tmp_path / f"out/layered/layered_{frame:04d}.psd")
        assert [each.name for each in stored] == ["background", "shadows", "主役", "相棒"]
        group = stored[1]
        assert group.is_group()
        assert [each.name for each in group] == ["主役_shadow", "相棒_shadow"]
        assert (group.blend_mode, group.opacity) == (BlendMode.MULTIPLY, 128)
        assert {(each.blend_mode, each.opacity) for each in group} == {(BlendMode.NORMAL, 255)}
        merged = stored.numpy()[..., :3] * 255
        color, _, _ = composite(stored, force=True)
        assert np.abs(color * 255 - merged).max() <= 1
        if frame < 3:
            shapes = [each.numpy("shape").max() for each in group]
            assert min(shapes) > 0.5, "each layer is whole"
    apart = with_values(alike, scene__shadows_unite=False)
    export(apart, tmp_path / "apart", composite=True)
    export(alike, tmp_path / "apart", layered=True, format="psd", skip_existing=False)
    once = read_cel(tmp_path / "apart/layered/layered_0002.psd").rgba.astype(int)
    twice = read_cel(tmp_path / "apart/composite/composite_0002.png").rgba.astype(int)
    assert (once - twice)[..., :3].max() > 10


def test_the_parts_of_an_exr_name_their_group(alike: Document, tmp_path: Path) -> None:
    export(alike, tmp_path / "out", layered=True, format="exr", depth=16)
    export(alike, tmp_path / "alone", united=True, format="exr", depth=16)
    source = opened(tmp_path / "out/layered/layered_0002.exr")
    names, groups, most = [], [], np.zeros((HEIGHT, WIDTH), np.float32)
    for index in range(5):
        assert source.seek_subimage(index, 0)
        spec = source.spec()
        names.append(spec.get_string_attribute("oiio:subimagename"))
        groups.append(spec.get_string_attribute("kagezou:united"))
        if groups[-1]:
            place = (slice(spec.y, spec.y + spec.height), slice(spec.x, spec.x + spec.width))
            most[place] = np.maximum(most[place], source.read_image(index, 0, 3, 4, oiio.FLOAT)[..., 0])
    source.close()
    assert names == ["background", "shadows.主役_shadow", "shadows.相棒_shadow", "主役", "相棒"]
    assert groups == ["", "shadows", "shadows", "", ""]
    alone = opened(tmp_path / "alone/shadows/shadows_0002.exr")
    assert np.array_equal(alone.read_image(oiio.FLOAT)[..., 3], most), "the maximum of the parts is the united shadow"
    alone.close()


def test_what_unites_on_some_frames_only_is_one_layer_and_that_is_said(alike: Document, tmp_path: Path) -> None:
    document = with_key(with_key(alike, "layers.相棒.shadow.opacity", 1, 0.5), "layers.相棒.shadow.opacity", 2, 0.2)
    summary = export(document, tmp_path / "out", layered=True, format="psd", frames=(1,))
    assert [each.name for each in PSDImage.open(tmp_path / "out/layered/layered_0001.psd")] == [
        "background", "shadows", "主役", "相棒",
    ]  # fmt: skip
    (note,) = map(str, summary.notes)
    assert note.startswith("the shadows of '主役', '相棒' are handed over as one, with their opacity in it")
    assert export(alike, tmp_path / "more", layered=True, format="psd", frames=(1,)).notes == ()
