"""PSD files as pictures: layers, groups and whole files, and files that are broken."""

import struct
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from PIL import Image, ImageChops
from psd_tools import PSDImage
from psd_tools.constants import BlendMode

from kagezou.errors import InputProblem
from kagezou.io.images.cel_cache import CelCache
from kagezou.io.images.reading import probe, read_cel, read_matte
from kagezou.io.images.writing import write_rgba
from kagezou.io.psd import file as psd_file
from kagezou.io.psd.file import psd_tree
from kagezou.io.psd.tree import addressed
from kagezou.picture_source import PicturePart, PictureSource
from tests.effort import tries
from tests.psd_files import SIZE, Folder, Leaf, block, figure, on_canvas, write_flat, write_psd

OFFSETS = [(4, 6), (-9, -11), (55, 30), (-100, 0), (0, 200)]


@pytest.mark.parametrize("offset", OFFSETS)
def test_a_layer_is_the_same_as_a_png_of_it(tmp_path: Path, offset: tuple[int, int]) -> None:
    leaf = Leaf("1", figure(1), offset)
    path = write_psd(tmp_path / "a.psd", [Folder("A", [leaf, Leaf("2", figure(2), is_visible=False)])])
    write_rgba(tmp_path / "a.png", on_canvas(leaf))
    ours, other = read_cel(PicturePart(path, "A/1")), read_cel(tmp_path / "a.png")
    assert np.array_equal(ours.rgba, other.rgba)
    assert ours.matte.box == other.matte.box
    assert np.array_equal(read_matte(PicturePart(path, "A/1")).whole(), other.matte.whole())


def test_hidden_layers_in_hidden_groups_are_drawn_when_they_are_asked_for(tmp_path: Path) -> None:
    low, high = Leaf("low", block(20, 20), (5, 5)), Leaf("high", block(10, 10, (9, 9, 9, 255)), (30, 30))
    inner = Folder("1", [low, high], is_visible=False)
    path = write_psd(tmp_path / "a.psd", [Folder("A", [inner], is_visible=False)])
    wanted = np.maximum(on_canvas(low), on_canvas(high))
    assert np.array_equal(read_cel(PicturePart(path, "A/1")).rgba[..., 3], wanted[..., 3])
    assert np.array_equal(read_cel(PicturePart(path, "A/1/high")).rgba, on_canvas(high))
    tree = psd_tree(path)
    assert not tree.layers[0].is_visible
    assert not (tree.layers[0].children or ())[0].is_visible


def test_opacity_and_clipping_and_blending_within_a_group_are_seen(tmp_path: Path) -> None:
    base = Leaf("base", block(20, 20, (200, 100, 50, 255)), (10, 10))
    shade = Leaf("shade", block(64, 48, (128, 128, 128, 255)), blend=BlendMode.MULTIPLY, is_clipped=True)
    path = write_psd(
        tmp_path / "a.psd", [Folder("A", [base, shade], opacity=128), Leaf("one", block(8, 8), opacity=51)]
    )
    group = read_cel(PicturePart(path, "A")).rgba
    assert set(np.unique(group[10:30, 10:30, 3])) == {128}
    assert group[..., 3].sum() == 128 * 400
    assert np.abs(group[20, 20, :3].astype(int) - [100, 50, 25]).max() <= 1
    assert read_cel(PicturePart(path, "one")).rgba[4, 4].tolist() == [200, 120, 40, 51]


def test_a_layer_mask_cuts(tmp_path: Path) -> None:
    image = PSDImage.new("RGBA", SIZE)
    layer = image.create_pixel_layer(Image.fromarray(block(40, 40), "RGBA"), name="1")
    mask = np.zeros((40, 40), np.uint8)
    mask[10:20, 10:20] = 255
    layer.create_mask(Image.fromarray(mask, "L"))
    image.save(tmp_path / "a.psd")
    box = read_cel(PicturePart(tmp_path / "a.psd", "1")).matte.box
    assert box is not None
    assert (box.left, box.top, box.right, box.bottom) == (10, 10, 20, 20)


def test_names_are_told_apart_and_found_again(tmp_path: Path) -> None:
    names = ["影/1", "影/1", "50%#2", "🦊"]
    leaves = [Leaf(name, figure(index), (index, 0)) for index, name in enumerate(names)]
    path = write_psd(tmp_path / "名前.psd", [Folder("キャラＡ", leaves)])
    found = psd_tree(path).layers[0].children or ()
    assert [node.name for node in found] == names
    assert len({node.address for node in found}) == len(names)
    for node, leaf in zip(found, leaves, strict=True):
        assert np.array_equal(read_cel(PicturePart(path, node.address)).rgba, on_canvas(leaf))


def test_an_old_japanese_name_without_unicode_is_read(tmp_path: Path) -> None:
    image = PSDImage.new("RGBA", SIZE)
    layer = image.create_pixel_layer(Image.fromarray(figure(1), "RGBA"), name="x")
    layer._record.name = "背景"
    for key in [key for key in layer.tagged_blocks if key.value == b"luni"]:
        del layer.tagged_blocks[key]
    image.save(tmp_path / "a.psd", encoding="shift_jis")
    assert psd_tree(tmp_path / "a.psd").layers[0].name == "背景"


@given(st.lists(st.text(max_size=4), max_size=8), st.sampled_from(["", "A", "A/B#2"]))
def test_addresses_are_never_alike(names: list[str], parent: str) -> None:
    assert len({*addressed(names), *addressed(names, parent)}) == 2 * len(names)


def test_a_group_without_a_name_is_a_group(tmp_path: Path) -> None:
    inner, outer = Leaf("1", figure(1)), Leaf("1", figure(2), (9, 3))
    path = write_psd(tmp_path / "a.psd", [Folder("", [inner]), outer])
    group, single = psd_tree(path).layers
    (child,) = group.children or ()
    for node, leaf in ((child, inner), (single, outer)):
        assert np.array_equal(read_cel(PicturePart(path, node.address)).rgba, on_canvas(leaf))


@pytest.mark.parametrize("mode", ["L", "LA", "RGB", "RGBA", "P", "CMYK", "1"])
def test_a_flattened_file_is_one_drawing_in_every_colour_space(tmp_path: Path, mode: str) -> None:
    picture = Image.new("RGBA", SIZE, (255, 255, 255, 255))
    picture.paste((40, 40, 40, 255), (10, 10, 30, 40))
    if mode == "P":
        path = tmp_path / "a.psd"
        head = struct.pack(">4sH6xHIIHH", b"8BPS", 1, 1, SIZE[1], SIZE[0], 8, 2)
        palette = bytes([40, 255] + [0] * 254) * 3
        indices = np.ones((SIZE[1], SIZE[0]), np.uint8)
        indices[10:40, 10:30] = 0
        path.write_bytes(head + struct.pack(">I", 768) + palette + bytes(8) + b"\0\0" + indices.tobytes())
    else:
        colours = picture.convert(mode)
        # Inks are stored as the paper that they leave, which psd-tools knows only when it reads.
        path = write_flat(tmp_path / "a.psd", ImageChops.invert(colours) if mode == "CMYK" else colours)
    cel = read_cel(path)
    assert cel.rgba.shape == (SIZE[1], SIZE[0], 4)
    if mode in {"LA", "RGBA"}:
        assert cel.rgba[0, 0, 3] == 255
    else:  # no alpha: white is clear
        box = cel.matte.box
        assert box is not None
        assert (box.left, box.top, box.right, box.bottom) == (10, 10, 30, 40)
    assert np.abs(cel.rgba[20, 20, :3].astype(int) - (0 if mode == "1" else 40)).max() <= 2
    assert read_cel(path, white_is_clear=False).rgba[0, 0].tolist() == [255, 255, 255, 255]
    assert (probe(path).width_px, probe(path).height_px) == SIZE


@pytest.mark.parametrize(("depth", "mode"), [(16, "RGBA"), (32, "RGBA"), (8, "L"), (8, "CMYK"), (16, "L")])
def test_layers_of_other_depths_and_colour_spaces(tmp_path: Path, depth: int, mode: str) -> None:
    image = PSDImage.new(mode, SIZE, depth=depth)  # type: ignore[arg-type]
    layer = image.create_pixel_layer(
        Image.fromarray(block(20, 20, (120, 120, 120, 255)), "RGBA"), name="1", top=5, left=7
    )
    layer.visible = True
    image.save(tmp_path / "a.psd")
    cel = read_cel(PicturePart(tmp_path / "a.psd", "1"))
    assert cel.rgba.dtype == (np.uint8 if depth == 8 else np.uint16)
    box = cel.matte.box
    assert box is not None
    assert (box.left, box.top, box.right, box.bottom) == (7, 5, 27, 25)
    seen = cel.rgba[10, 10, :3].astype(float) / np.iinfo(cel.rgba.dtype).max
    wanted = 1.055 * (120 / 255) ** (1 / 2.4) - 0.055 if depth == 32 else 120 / 255
    assert np.abs(seen - wanted).max() < 0.02


def test_many_cels_open_their_file_once_and_an_edited_file_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    leaves = [Leaf(str(number), figure(number)) for number in range(1, 7)]
    path = write_psd(tmp_path / "a.psd", leaves)
    opened: list[Path] = []
    parsed = psd_file._parsed

    def counted(path: Path, size: int) -> Any:
        opened.append(path)
        return parsed(path, size)

    monkeypatch.setattr(psd_file, "_parsed", counted)
    cache = CelCache()
    with ThreadPoolExecutor(4) as pool:
        cels = list(pool.map(lambda leaf: cache.cel(PicturePart(path, leaf.name)), leaves))
    assert [np.array_equal(cel.rgba, on_canvas(leaf)) for cel, leaf in zip(cels, leaves, strict=True)] == [True] * 6
    assert opened == [path]
    write_psd(path, [Leaf("1", figure(9))])
    assert np.array_equal(cache.cel(PicturePart(path, "1")).rgba, on_canvas(Leaf("1", figure(9))))
    assert opened == [path, path]
    with pytest.raises(InputProblem, match="there is no layer '2' in it"):
        cache.cel(PicturePart(path, "2"))


def test_files_held_open_are_bounded(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(psd_file, "_KEPT_BYTES", 1)
    for number in range(3):
        psd_tree(write_psd(tmp_path / f"{number}.psd", [Leaf("1", figure(number))]))
    assert [state[0].name for state in psd_file._SHELF._kept] == ["2.psd"]


def _damaged(path: Path, data: bytes) -> None:
    """Read everything in a file of some bytes: there is a result or one sentence."""
    path.write_bytes(data)
    tree = _tried(lambda: psd_tree(path))
    if tree is None:
        return
    nodes = [node for top in tree.layers for node in (top, *top.below())]
    sources: list[PictureSource] = [path, *(PicturePart(path, node.address) for node in nodes)]
    for source in sources:
        cel = _tried(partial(read_cel, source))
        assert cel is None or cel.rgba.shape == (tree.height_px, tree.width_px, 4)


T = TypeVar("T")


def _tried(read: Callable[[], T]) -> T | None:
    try:
        return read()
    except InputProblem as problem:
        sentence = str(problem)
    assert "a.psd: " in sentence
    assert "\n" not in sentence
    return None


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    cels = [Leaf("1", figure(1), (3, 4)), Leaf("2", figure(2), is_visible=False)]
    parts = [Leaf("a", figure(3)), Leaf("b", figure(4), is_clipped=True)]
    path = write_psd(tmp_path_factory.mktemp("psd") / "a.psd", [Folder("A", cels), Folder("B", parts, opacity=99)])
    return path.read_bytes()


def test_a_truncated_file_is_a_sentence_or_a_result(tmp_path: Path, whole: bytes) -> None:
    for length in range(0, len(whole), 97):
        _damaged(tmp_path / "a.psd", whole[:length])


@settings(max_examples=tries(35, 120), suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.data())
def test_fuzzed_bytes_are_a_sentence_or_a_result(tmp_path: Path, whole: bytes, data: st.DataObject) -> None:
    changed = bytearray(whole)
    places = data.draw(
        st.lists(st.tuples(st.integers(0, len(whole) - 4), st.binary(min_size=1, max_size=4)), max_size=6)
    )
    for place, value in places:
        changed[place : place + len(value)] = value
    # The canvas stays small enough to be drawn in a test; claimed sizes have a test of their own.
    changed[14:22] = whole[14:22]
    _damaged(tmp_path / "a.psd", bytes(changed))


@given(st.binary(max_size=400))
@settings(max_examples=tries(20, 60), suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_garbage_is_a_sentence(tmp_path: Path, garbage: bytes) -> None:
    _damaged(tmp_path / "a.psd", garbage)
    _damaged(tmp_path / "a.psd", b"8BPS\0\1" + garbage)


@pytest.mark.parametrize(
    ("width", "height", "said"),
    [
        (30000, 30000, "30000 × 30000 px is larger than can be read"),
        (9000, 9000, "9000 × 9000 px is larger than can be read"),
        (40000, 10, "40000 × 10 px is larger than can be read"),
        (0, 10, "it has no pixels"),
    ],
)
def test_claimed_sizes_are_refused_before_anything_is_read(
    tmp_path: Path, whole: bytes, width: int, height: int, said: str
) -> None:
    (tmp_path / "a.psd").write_bytes(whole[:14] + struct.pack(">II", height, width) + whole[22:])
    for read in (psd_tree, probe, read_cel):
        with pytest.raises(InputProblem, match=said):
            read(tmp_path / "a.psd")


def test_a_layer_that_claims_too_much_is_a_sentence(tmp_path: Path) -> None:
    image = PSDImage.new("RGBA", SIZE)
    layer = image.create_pixel_layer(Image.fromarray(figure(1), "RGBA"), name="1")
    layer._record.right = layer._record.left + 200_000
    layer._record.bottom = layer._record.top + 200_000
    with (tmp_path / "a.psd").open("wb") as stream:
        image._record.write(stream)
    with pytest.raises(InputProblem, match=r"damaged at the layer '1'|larger than can be read"):
        read_cel(PicturePart(tmp_path / "a.psd", "1"))


def test_groups_nested_too_deep_are_a_sentence(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    # Writing would put so deep a picture together, for which a test under coverage has no stack left.
    monkeypatch.setattr("psd_tools.PSDImage._update_preview", lambda _image: None)
    nested: Leaf | Folder = Leaf("1", figure(1))
    for _ in range(80):
        nested = Folder("A", [nested])
    path = write_psd(tmp_path / "a.psd", [nested], is_pictured=False)
    with pytest.raises(InputProblem, match="nested too deep"):
        psd_tree(path)


@pytest.mark.parametrize(
    ("name", "content", "said"),
    [
        ("a.psd", b"", "the file is empty"),
        ("a.psd", b"<!DOCTYPE html>", "it is not PSD, whatever its name says"),
        ("a.png", b"8BPS\0\1" + bytes(40), "it is not PNG but PSD, whatever its name says"),
        ("a.psd", b"8BPS\0\1", "the file is cut short"),
        ("a.psd", b"8BPS\0\1" + bytes(40), "an impossible header"),
    ],
)
def test_what_is_no_psd_file_is_told(tmp_path: Path, name: str, content: bytes, said: str) -> None:
    (tmp_path / name).write_bytes(content)
    with pytest.raises(InputProblem, match=said):
        read_cel(tmp_path / name)


def test_the_real_cels(samples: Path) -> None:
    path = samples / "psd" / "kid_cels.psd"
    cels = psd_tree(path).layers[0].children or ()
    assert [(node.name, node.is_visible) for node in cels] == [(f"A{n}", n == 1) for n in range(1, 7)]
    # They are every tenth frame of the animation they were made of.
    for number, node in zip(range(1, 61, 10), cels, strict=True):
        drawn = read_cel(samples / "synfig_prologue_kid" / "A" / f"frame_{number:04d}.png").rgba
        layer = read_cel(PicturePart(path, node.address)).rgba
        assert np.array_equal(layer[..., 3], drawn[..., 3])
        assert np.array_equal(layer[drawn[..., 3] > 0], drawn[drawn[..., 3] > 0])
