import subprocess
import sys
import threading
import time
import zlib
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import OpenImageIO as oiio  # noqa: N813  # the name its own manual uses
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as numpy_st
from numpy.typing import NDArray

from kagezou.errors import DiskFullProblem, OutputProblem, UsageProblem
from kagezou.geometry.box import Box
from kagezou.io.images import oiio_guard
from kagezou.io.images.reading import read_cel
from kagezou.io.images.writing import (
    FORMATS,
    ShadowImage,
    encode_png,
    encode_rgba_png,
    write_rgba,
    write_shadow,
)
from kagezou.io.pixels import png
from kagezou.io.pixels.deflating import Packable, packed_fast, packed_small
from tests.io.images import picture_files as files

Pixels = NDArray[Any]
COLOR = (20, 30, 60)
DEPTHS = ("uint8", "uint16")


def layer(dtype: str = "uint8", box: Box | None = None, size: tuple[int, int] = (41, 29), seed: int = 1) -> ShadowImage:
    box = box or Box(5, 7, 30, 20)
    full = np.iinfo(dtype).max
    alpha = np.random.default_rng(seed).integers(0, full + 1, (box.height, box.width)).astype(dtype)
    return ShadowImage(*size, COLOR, alpha, box)


def expected(image: ShadowImage) -> Pixels:
    """The canvas, pixel by pixel as it is defined."""
    scale = 257 if image.alpha.dtype == np.uint16 else 1
    canvas = np.zeros((image.height_px, image.width_px, 4), image.alpha.dtype)
    canvas[..., :3] = np.array(image.color) * scale
    canvas[image.box.top : image.box.bottom, image.box.left : image.box.right, 3] = image.alpha
    return canvas


def decoded(path: Path, data: bytes) -> Pixels:
    path.write_bytes(data)
    return files.read_back(path)


@st.composite
def layers(draw: st.DrawFn) -> ShadowImage:
    width, height = draw(st.integers(1, 12)), draw(st.integers(1, 12))
    left, top = draw(st.integers(0, width)), draw(st.integers(0, height))
    box = Box(left, top, draw(st.integers(left, width)), draw(st.integers(top, height)))
    color = draw(st.tuples(*[st.integers(0, 255)] * 3))
    dtype = draw(st.sampled_from([np.uint8, np.uint16]))
    alpha: Pixels = draw(numpy_st.arrays(dtype, (box.height, box.width)))
    return ShadowImage(width, height, color, alpha, box)


@given(images=st.lists(layers(), min_size=1, max_size=3))
def test_png_of_a_layer_comes_back(tmp_path_factory: pytest.TempPathFactory, images: list[ShadowImage]) -> None:
    path = tmp_path_factory.getbasetemp() / "layer.png"
    for image in images:
        assert np.array_equal(decoded(path, encode_png(image)), expected(image))


@given(
    dtype=st.sampled_from([np.uint8, np.uint16]), size=st.tuples(st.integers(1, 9), st.integers(1, 9)), data=st.data()
)
def test_png_of_pixels_comes_back(
    tmp_path_factory: pytest.TempPathFactory,
    dtype: type[np.uint8 | np.uint16],
    size: tuple[int, int],
    data: st.DataObject,
) -> None:
    rgba: Pixels = data.draw(numpy_st.arrays(dtype, (*size, 4)))
    path = tmp_path_factory.getbasetemp() / "pixels.png"
    assert np.array_equal(decoded(path, encode_rgba_png(rgba)), rgba)


def test_a_smooth_picture_is_kept_as_differences(tmp_path: Path) -> None:
    across, down = np.meshgrid(np.arange(200), np.arange(150))
    rgba = np.stack([across, down, across + down, np.full_like(across, 255)], axis=2).astype(np.uint8)
    data = encode_rgba_png(rgba)
    assert len(data) < len(zlib.compress(rgba.tobytes(), 1)) / 2
    assert np.array_equal(decoded(tmp_path / "a.png", data), rgba)


@pytest.mark.parametrize("dtype", DEPTHS)
def test_png_holds_what_it_should_and_no_more(dtype: str) -> None:
    data = encode_png(layer(dtype))
    kinds, at = [], 8
    while at < len(data):
        length = int.from_bytes(data[at : at + 4])
        kinds.append(data[at + 4 : at + 8])
        assert files.chunk(kinds[-1], data[at + 8 : at + 8 + length]) == data[at : at + 12 + length]
        at += 12 + length
    assert kinds == [b"IHDR", b"sRGB", b"IDAT", b"IEND"]
    assert data[24:29] == bytes([np.dtype(dtype).itemsize * 8, 6, 0, 0, 0])


@pytest.mark.parametrize("dtype", DEPTHS)
def test_no_frame_leaves_a_trace_in_the_next(tmp_path: Path, dtype: str) -> None:
    boxes = [
        Box(0, 0, 41, 29),
        Box(3, 0, 10, 29),
        Box(10, 28, 12, 29),
        Box(0, 5, 41, 6),
        Box(0, 0, 0, 0),
        Box(9, 9, 8, 8),
    ]
    for seed, box in enumerate(boxes):
        if box.is_empty:
            image = ShadowImage(41, 29, COLOR, np.zeros((0, 0), dtype), box)
            wanted = expected(ShadowImage(41, 29, COLOR, np.zeros((0, 0), dtype), Box(0, 0, 0, 0)))
        else:
            image = layer(dtype, box, seed=seed)
            wanted = expected(image)
        assert np.array_equal(decoded(tmp_path / "a.png", encode_png(image)), wanted)
        assert np.array_equal(image.rgba(), wanted)


@pytest.mark.parametrize("dtype", DEPTHS)
def test_layers_of_different_colours_take_turns(tmp_path: Path, dtype: str) -> None:
    for color in ((255, 0, 9), (0, 0, 0), (3, 200, 255)):
        image = replace(layer(dtype, Box(3, 0, 10, 29), seed=1), color=color)
        assert np.array_equal(decoded(tmp_path / "a.png", encode_png(image)), expected(image))


def test_an_alpha_that_is_a_view_is_written_as_seen(tmp_path: Path) -> None:
    wide = np.random.default_rng(3).integers(0, 65536, (40, 60)).astype(np.uint16)
    image = ShadowImage(41, 29, COLOR, wide[::2, ::3][:10, :12], Box(2, 3, 14, 13))
    assert np.array_equal(decoded(tmp_path / "a.png", encode_png(image)), expected(image))


def test_threads_do_not_share_rows() -> None:
    images = [layer(dtype, Box(0, 0, 1 + n, 2 + n), seed=n) for n in range(20) for dtype in DEPTHS]
    alone = [encode_png(image) for image in images]
    with ThreadPoolExecutor(4) as pool:
        assert list(pool.map(encode_png, images * 5)) == alone * 5


@pytest.mark.parametrize("suffix", [*FORMATS, ".PNG", ".Exr"])
@pytest.mark.parametrize("dtype", DEPTHS)
def test_every_format_comes_back(tmp_path: Path, suffix: str, dtype: str) -> None:
    image = layer(dtype)
    path = tmp_path / f"影 0001{suffix}"
    write_shadow(path, image)
    stored, wanted = files.read_back(path), expected(image)
    if suffix.lower() == ".exr":
        full = np.iinfo(dtype).max
        alpha = wanted[..., 3:] / full
        light = ((np.array(COLOR) / 255 + 0.055) / 1.055) ** 2.4
        assert stored.dtype == np.float16
        assert np.allclose(stored, np.concatenate([light * alpha, alpha], axis=2), rtol=1e-3, atol=1e-6)
        assert not stored[0].any()
        seen = (wanted[..., 3] > full // 8) & (read_cel(path).rgba[..., 3] > 0)
        codes = np.array(COLOR) * 257
        assert np.abs(read_cel(path).rgba[seen][:, :3].astype(np.int64) - codes).max() <= 64
    elif suffix == ".tga" and dtype == "uint16":
        assert np.array_equal(stored, np.rint(wanted / 257).astype(np.uint8))
    else:
        assert np.array_equal(stored, wanted)
    write_rgba(tmp_path / f"b{suffix}", wanted)
    assert np.array_equal(files.read_back(tmp_path / f"b{suffix}"), stored)
    assert len(list(tmp_path.iterdir())) == 2


@pytest.mark.parametrize("dtype", DEPTHS)
@pytest.mark.parametrize("size", [(1, 1), (3, 64), (5, 65), (2, 200)])
def test_tiff_strips(tmp_path: Path, dtype: str, size: tuple[int, int]) -> None:
    rgba = np.random.default_rng(4).integers(0, np.iinfo(dtype).max + 1, (size[1], size[0], 4)).astype(dtype)
    write_rgba(tmp_path / "a.tif", rgba)
    assert np.array_equal(files.read_back(tmp_path / "a.tif"), rgba)
    assert np.array_equal(read_cel(tmp_path / "a.tif").rgba, rgba)


@pytest.mark.parametrize("suffix", [".tif", ".exr", ".tga"])
def test_no_format_holds_a_time(tmp_path: Path, suffix: str) -> None:
    write_shadow(tmp_path / f"a{suffix}", layer())
    start_s = int(time.time())
    while int(time.time()) == start_s:
        time.sleep(0.02)
    write_shadow(tmp_path / f"b{suffix}", layer())
    first = (tmp_path / f"a{suffix}").read_bytes()
    assert first == (tmp_path / f"b{suffix}").read_bytes()
    assert time.strftime("%Y").encode() not in first


@pytest.mark.parametrize("suffix", [".tif", ".tiff", ".tga"])
def test_written_alpha_is_marked_straight(tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"a{suffix}"
    write_shadow(path, layer())
    source = oiio.ImageInput.open(str(path))
    assert source is not None
    if suffix == ".tga":
        assert source.spec().get_int_attribute("targa:alpha_type") == 3
    else:
        assert source.spec().get_int_attribute("tiff:UnassociatedAlpha") == 1


@pytest.mark.parametrize("name", ["a.jpg", "a", "a.psd"])
def test_other_formats_are_refused(tmp_path: Path, name: str) -> None:
    for write in (lambda: write_shadow(tmp_path / name, layer()), lambda: write_rgba(tmp_path / name, layer().rgba())):
        with pytest.raises(UsageProblem, match=r"cannot be written, only \.png, \.tga"):
            write()
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("shape", "dtype", "box"),
    [
        ((3, 4), "uint8", Box(0, 0, 3, 4)),
        ((3, 4), "float32", Box(0, 0, 4, 3)),
        ((3, 4), "uint8", Box(-1, 0, 3, 3)),
        ((3, 4), "uint8", Box(7, 0, 11, 3)),
        ((3, 4), "uint8", Box(0, 8, 4, 11)),
    ],
)
def test_an_impossible_layer_is_a_defect(shape: tuple[int, int], dtype: str, box: Box) -> None:
    with pytest.raises(ValueError, match="Box"):
        ShadowImage(10, 10, COLOR, np.zeros(shape, dtype), box)


@pytest.mark.parametrize("suffix", [".tga", ".exr"])
@pytest.mark.parametrize("lie", ["nothing", "zeros", "other", "fails"])
def test_a_writer_that_lies_is_found_out(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, suffix: str, lie: str
) -> None:
    path = tmp_path / f"a{suffix}"
    path.write_bytes(b"old")
    real = oiio_guard._written

    def written(temp: Path, pixels: Pixels, settings: dict[str, Any]) -> str:
        if lie == "fails":
            return "it failed"
        if lie == "other":
            return real(temp, pixels + pixels.dtype.type(1), settings)
        told = real(temp, pixels, settings)
        size = temp.stat().st_size
        with temp.open("r+b") as stream:
            stream.truncate(size // 2)
            stream.truncate(size if lie == "zeros" else size // 2)
        return told

    monkeypatch.setattr(oiio_guard, "_written", written)
    with pytest.raises(OutputProblem, match="cannot be written") as caught:
        write_shadow(path, layer())
    assert str(caught.value).startswith(f"{path}: ")
    assert [(entry.name, entry.read_bytes()) for entry in tmp_path.iterdir()] == [(path.name, b"old")]
    monkeypatch.setattr("shutil.disk_usage", lambda _: type("Usage", (), {"free": 0}))
    with pytest.raises(DiskFullProblem, match="no space left on the disk"):
        write_shadow(path, layer())


LIMITED = """
import resource, sys
from pathlib import Path
import numpy as np
from kagezou.errors import OutputProblem
from kagezou.geometry.box import Box
from kagezou.io.images.writing import ShadowImage, write_shadow
alpha = np.random.default_rng(1).integers(0, 256, (200, 200)).astype(np.uint8)
resource.setrlimit(resource.RLIMIT_FSIZE, (int(sys.argv[2]), int(sys.argv[2])))
try:
    write_shadow(Path(sys.argv[1]), ShadowImage(200, 200, (1, 2, 3), alpha, Box(0, 0, 200, 200)))
except OutputProblem as problem:
    print(problem)
else:
    print("written")
"""


@pytest.mark.skipif(sys.platform == "win32", reason="there are no such limits")
@pytest.mark.parametrize("suffix", [".png", ".tga", ".tif", ".exr"])
def test_a_real_size_limit_keeps_the_old_frame(tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"a{suffix}"
    path.write_bytes(b"old")
    for limit in (4096, 20_000):
        command = [sys.executable, "-c", LIMITED, str(path), str(limit)]
        done = subprocess.run(command, capture_output=True, text=True, check=True)
        assert done.stdout.startswith(f"{path}: cannot be written: ")
        assert done.stdout.count("\n") == 1
        assert [(entry.name, entry.read_bytes()) for entry in tmp_path.iterdir()] == [(path.name, b"old")]


def test_a_missing_folder_is_told(tmp_path: Path) -> None:
    for suffix in FORMATS:
        path = tmp_path / "none" / f"a{suffix}"
        with pytest.raises(OutputProblem) as caught:
            write_shadow(path, layer())
        assert str(caught.value) == f"{path}: cannot be written: its folder does not exist"


def test_the_same_layer_gives_the_same_bytes() -> None:
    """Whichever thread packs it and whatever it packed before."""
    image, other = layer(), layer(seed=2, box=Box(0, 0, 41, 29))
    first = encode_png(image)
    encode_png(other)
    again: list[bytes] = []
    thread = threading.Thread(target=lambda: again.append(encode_png(image)))
    thread.start()
    thread.join()
    assert [encode_png(image), *again] == [first, first]


def test_a_layer_is_deflated_once_in_rows_that_are_prepared_once(monkeypatch: pytest.MonkeyPatch) -> None:
    down, across = np.mgrid[:500, :700]
    inside = 1 - np.hypot((across - 350) / 340, (down - 250) / 240)
    alpha = (np.clip(inside * 40, 0, 1) * 153).astype(np.uint8)
    image = ShadowImage(1001, 1000, COLOR, alpha, Box(200, 400, 900, 900))
    places: list[int] = []

    def packed(rows: Pixels) -> bytes:
        places.append(rows.ctypes.data)
        return packed_small(rows)

    monkeypatch.setattr(png, "packed_small", packed)
    sizes = [len(encode_png(image)) for _ in range(3)]
    assert len(places) == 3
    assert len(set(places)) == 1
    assert max(sizes) < 25_000


@pytest.mark.parametrize("pack", [packed_small, packed_fast])
def test_what_is_packed_beside_other_things_has_the_same_bytes(pack: Callable[[Packable], bytes]) -> None:
    """Steps and runs of zeros on several threads: where a packer has a choice between matches that are as long."""
    rng = np.random.default_rng(4)
    pictures = []
    for _ in range(6):
        rows = np.zeros((400, 1601), np.uint8)
        for row in rng.integers(0, 400, 200):
            at = int(rng.integers(0, 1500))
            rows[row, at : at + 40 : 4] = rng.integers(0, 255, 10)
        pictures.append(rows)
    first = [pack(each) for each in pictures]
    with ThreadPoolExecutor(3) as pool:
        again = list(pool.map(lambda number: pack(pictures[number % 6]), range(600)))
    assert all(made == first[number % 6] for number, made in enumerate(again))
    assert [zlib.decompress(each) for each in first] == [each.tobytes() for each in pictures]


_EVERY_LIMIT = """
import resource, signal, sys
from pathlib import Path
import numpy as np
from kagezou.errors import Problem
from kagezou.io.images.writing import write_rgba

signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
path, most = Path(sys.argv[1]), resource.RLIM_INFINITY
pixels = np.random.default_rng(0).integers(0, 255, (24, 32, 4), dtype=np.uint8)
write_rgba(path, pixels)
size = path.stat().st_size
for limit in sorted({*range(0, size, max(size // 40, 1)), *range(size - 64, size)}):
    path.unlink(missing_ok=True)
    resource.setrlimit(resource.RLIMIT_FSIZE, (limit, most))
    try:
        write_rgba(path, pixels)
        print(limit, "of", size)
    except Problem:
        pass
    resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))
    assert not list(path.parent.iterdir())
"""


@pytest.mark.skipif(sys.platform == "win32", reason="no limit of a file's size")
@pytest.mark.parametrize("suffix", [".png", ".tga", ".tif", ".exr"])
def test_no_byte_of_the_end_may_be_missing(tmp_path: Path, suffix: str) -> None:
    words = [sys.executable, "-c", _EVERY_LIMIT, str(tmp_path / f"a{suffix}")]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (0, ""), done.stderr
