"""Files that were cut are told apart from whole ones without decoding, and nothing that reads is refused."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from kagezou.errors import InputProblem
from kagezou.importing.staging import CharacterSource, new_document
from kagezou.io.images.oiio_guard import DecodedPicture
from kagezou.io.images.reading import probe, read_cel
from tests.io.images import picture_files as files
from tests.io.images import raw_files as raw

PIXELS = np.random.default_rng(0).integers(0, 256, (80, 90, 4)).astype(np.uint8)
LIGHT = (PIXELS / 255).astype(np.float16)
RGB = Image.fromarray(PIXELS[..., :3])


def exr(path: Path, **settings: Any) -> None:
    files.save(path, LIGHT, straight=False, **settings)


KINDS: dict[str, Callable[[Path], object]] = {
    "a.png": lambda path: files.save(path, PIXELS),
    "small chunks.png": lambda path: Image.fromarray(PIXELS).save(path),
    "raw.tga": lambda path: files.save(path, PIXELS, compression="none"),
    "a.tif": lambda path: path.write_bytes(raw.tiff(PIXELS, 2, 8, extras=(2,), packing=8, rows=7)),
    "tiles.tif": lambda path: path.write_bytes(raw.tiff(PIXELS, 2, 8, extras=(2,), packing=8, tile=16)),
    "a.webp": lambda path: files.save(path, PIXELS),
    "lossy.webp": lambda path: Image.fromarray(PIXELS).save(path),
    "a.jpg": RGB.save,
    "progressive.jpg": lambda path: RGB.save(path, progressive=True),
    "preview.jpg": lambda path: path.write_bytes(with_preview(path)),
    "a.bmp": RGB.save,
    "a.gif": lambda path: RGB.quantize(200).save(path),
    "zip.exr": lambda path: exr(path, compression="zip"),
    "plain.exr": lambda path: exr(path, compression="none"),
    "piz.exr": lambda path: exr(path, compression="piz"),
}


def with_preview(path: Path) -> bytes:
    """A JPEG that has another, whole one in its head."""
    RGB.save(path)
    whole = path.read_bytes()
    RGB.resize((20, 20)).save(path)
    inner = path.read_bytes()
    return whole[:2] + b"\xff\xe5" + (len(inner) + 2).to_bytes(2) + inner + whole[2:]


@pytest.mark.parametrize("name", KINDS)
@pytest.mark.parametrize("part", [0.1, 0.3, 0.6, 0.9, 0.95])
def test_a_cut_file_is_known_without_its_pixels(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, part: float
) -> None:
    path = tmp_path / name
    KINDS[name](path)
    whole = path.read_bytes()
    probe(path)
    path.write_bytes(whole[: int(len(whole) * part)])
    monkeypatch.setattr(DecodedPicture, "read", lambda *_: pytest.fail("it was decoded"))
    with pytest.raises(InputProblem) as caught:
        probe(path)
    assert str(caught.value).startswith(f"{path}: ")


@pytest.mark.parametrize("name", KINDS)
def test_what_lies_behind_a_picture_does_not_make_it_short(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    KINDS[name](path)
    wanted = read_cel(path).rgba
    with path.open("ab") as stream:
        stream.write(bytes(5000))
    assert np.array_equal(read_cel(path).rgba, wanted)
    probe(path)


@pytest.mark.parametrize("name", KINDS)
def test_what_reads_is_not_refused_by_its_header(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    KINDS[name](path)
    whole = path.read_bytes()
    for cut in (1, 2, 3, 7, 12, 20):
        path.write_bytes(whole[:-cut])
        try:
            read_cel(path)
        except InputProblem:
            continue
        probe(path)


def test_parts_and_tiles_of_an_exr(tmp_path: Path) -> None:
    files.save(tmp_path / "tiles.exr", LIGHT, straight=False, tile_width=16, tile_height=16)
    probe(tmp_path / "tiles.exr")


def test_work_goes_on_with_the_other_drawings(tmp_path: Path) -> None:
    folder = tmp_path / "A"
    folder.mkdir()
    for number in (1, 2, 3):
        files.save(folder / f"A_{number}.png", np.dstack([PIXELS[..., :3], np.eye(80, 90, dtype=np.uint8) * 255]))
    whole = (folder / "A_2.png").read_bytes()
    (folder / "A_2.png").write_bytes(whole[: len(whole) // 2])
    found = new_document([CharacterSource("A", folder)])
    assert len(found.document.layers[0].cels.drawings) == 3
    assert f"{folder / 'A_2.png'}: the file is cut short" in map(str, found.notes)
