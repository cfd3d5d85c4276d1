"""Files of several pictures: films and pages become the drawings of one character, or of the background."""

import itertools
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from kagezou.document.model import Exposure, Layer
from kagezou.importing.background_pictures import background_of
from kagezou.importing.file_pages import exposed_frames
from kagezou.importing.staging import CharacterSource, new_document
from kagezou.io.images.cel_cache import CelCache
from kagezou.io.images.parts import has_part
from kagezou.io.images.reading import probe, read_cel, read_matte
from kagezou.io.project.file import dumps, loads
from kagezou.picture_source import PicturePart
from tests.io.images import raw_files as raw

SIZE = (40, 30)
"""Width and height, px."""


def figure(number: int, *, paper: bool = False) -> Image.Image:
    """A figure that stands farther to the right from picture to picture."""
    rgba = np.zeros((SIZE[1], SIZE[0], 4), np.uint8)
    if paper:
        rgba[:] = 255
    left = 4 + 6 * number
    rgba[8:26, left : left + 7] = 200, 40 * number, 30, 255
    return Image.fromarray(rgba)


def film(path: Path, durations: list[int], **settings: Any) -> Path:
    pictures = [figure(number) for number in range(len(durations))]
    pictures[0].save(path, save_all=True, append_images=pictures[1:], duration=durations, **settings)
    return path


def pages(path: Path, count: int) -> Path:
    shapes = [np.asarray(figure(number)).astype(np.int64) * 257 for number in range(count)]
    path.write_bytes(raw.tiff(shapes, 2, 16, extras=(2,), packing=8))
    return path


def character(path: Path, rate: Fraction = Fraction(24)) -> tuple[Layer, list[str]]:
    found = new_document([CharacterSource("A", path)], frame_rate=rate)
    return found.document.layers[0], [str(note) for note in found.notes]


FILMS: dict[str, dict[str, Any]] = {
    "a.png": {},
    "a.webp": {"lossless": True, "exact": True, "minimize_size": False},
    "a.gif": {"disposal": 2},
}


@pytest.mark.parametrize("name", FILMS)
def test_every_picture_of_a_film_is_a_drawing(tmp_path: Path, name: str) -> None:
    path = film(tmp_path / name, [250, 250, 250, 500], **FILMS[name])
    layer, said = character(path)
    assert [each.name for each in layer.cels.drawings] == ["1", "2", "3", "4"]
    assert layer.cels.exposures == (Exposure(1, 0), Exposure(7, 1), Exposure(13, 2), Exposure(19, 3))
    for number, drawing in enumerate(layer.cels.drawings):
        assert np.array_equal(read_matte(drawing.source).whole(), np.asarray(figure(number))[..., 3])
        cel = read_cel(drawing.source)
        near = 8 if name == "a.gif" else 0
        wanted = np.asarray(figure(number)).astype(np.int64)
        assert np.abs(cel.rgba.astype(np.int64) - wanted)[wanted[..., 3] > 0].max() <= near
        assert drawing.size_px == SIZE
    assert f"{path}: its 4 pictures are its drawings, as long as it says at 24 frames/s" in said


@pytest.mark.parametrize("name", FILMS)
def test_the_cut_is_as_long_as_the_film(tmp_path: Path, name: str) -> None:
    path = film(tmp_path / name, [250, 500], **FILMS[name])
    found = new_document([CharacterSource("A", path)], frame_rate=Fraction(12))
    assert found.document.canvas.length_frames == 9
    assert found.document.layers[0].cels.exposures == (Exposure(1, 0), Exposure(4, 1))


def test_times_are_rounded_and_no_picture_is_lost() -> None:
    assert exposed_frames([100, 100, 100], Fraction(24)) == (1, 3, 6, 8)
    assert exposed_frames([1, 1, 1, 1000], Fraction(24)) == (1, 2, 3, 4, 25)
    assert exposed_frames([1000], Fraction(30000, 1001)) == (1, 31)


def test_rounding_and_missing_times_are_said(tmp_path: Path) -> None:
    _, said = character(film(tmp_path / "a.png", [90, 110]))
    assert any("rounded to whole frames at 24 frames/s" in note for note in said)
    _, said = character(film(tmp_path / "b.gif", [0, 0, 0], disposal=2))
    assert any("3 of them do not say how long they are seen, which counts as 100 ms" in note for note in said)


def test_a_picture_before_the_film_is_none_of_it(tmp_path: Path) -> None:
    path = tmp_path / "a.png"
    figure(3).save(path, save_all=True, append_images=[figure(0), figure(1)], duration=125, default_image=True)
    layer, _ = character(path)
    assert len(layer.cels.drawings) == 2
    assert np.array_equal(read_matte(layer.cels.drawings[0].source).whole(), np.asarray(figure(0))[..., 3])


@pytest.mark.parametrize(("disposal", "blend"), [(0, 0), (0, 1), (1, 0), (1, 1), (2, 1)])
def test_pictures_of_a_film_are_laid_over_each_other_as_it_says(tmp_path: Path, disposal: int, blend: int) -> None:
    path = film(tmp_path / "a.png", [125, 125, 125], disposal=disposal, blend=blend)
    with Image.open(path) as image:
        for number in range(3):
            image.seek(number)
            wanted = np.asarray(image.convert("RGBA"))
            assert np.array_equal(read_cel(PicturePart(path, str(number + 1))).rgba[..., 3], wanted[..., 3])


def test_pages_are_a_frame_each_and_keep_their_depth(tmp_path: Path) -> None:
    path = pages(tmp_path / "a.tif", 3)
    layer, said = character(path)
    assert layer.cels.exposures == (Exposure(1, 0), Exposure(2, 1), Exposure(3, 2))
    assert f"{path}: its 3 pages are its drawings, a frame each" in said
    for number, drawing in enumerate(layer.cels.drawings):
        assert np.array_equal(read_cel(drawing.source).rgba, np.asarray(figure(number)).astype(np.int64) * 257)


def test_a_small_copy_in_a_tiff_is_no_page(tmp_path: Path) -> None:
    path = tmp_path / "a.tif"
    copy = raw.tiff(np.asarray(figure(0)), 2, 8, extras=(2,), more=((254, raw.LONG, [1]),))
    path.write_bytes(copy)
    assert probe(path).pictures == 0 or len(character(path)[0].cels.drawings) == 1


@pytest.mark.parametrize("name", FILMS)
def test_white_paper_of_a_film_is_clear(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    pictures = [figure(number, paper=True).convert("RGB") for number in range(3)]
    settings: dict[str, Any] = {"lossless": True} if name == "a.webp" else {}
    pictures[0].save(path, save_all=True, append_images=pictures[1:], duration=125, **settings)
    layer, said = character(path)
    assert any("its drawings have no alpha; pure white is taken as clear" in note for note in said)
    for number, drawing in enumerate(layer.cels.drawings):
        assert np.array_equal(read_matte(drawing.source).whole(), np.asarray(figure(number))[..., 3])


def test_a_folder_with_one_film_is_that_film(tmp_path: Path) -> None:
    (tmp_path / "A").mkdir()
    film(tmp_path / "A" / "a.png", [125, 125])
    layer, _ = character(tmp_path / "A")
    assert [each.part for each in layer.cels.drawings] == ["1", "2"]


def test_films_in_a_numbered_folder_are_drawings_whose_other_pictures_are_told(tmp_path: Path) -> None:
    (tmp_path / "A").mkdir()
    for number in (1, 2):
        film(tmp_path / "A" / f"A_{number}.png", [125, 125, 125])
    layer, said = character(tmp_path / "A")
    assert [each.part for each in layer.cels.drawings] == [None, None]
    assert "A: of its 3 pictures the first alone is used, in all its 2 files" in said


def test_pages_stay_in_a_project(tmp_path: Path) -> None:
    found = new_document([CharacterSource("A", pages(tmp_path / "a.tif", 2))]).document
    again = loads(dumps(found, tmp_path), tmp_path)
    assert [each.source for each in again.layers[0].cels.drawings] == [
        PicturePart(tmp_path / "a.tif", "1"),
        PicturePart(tmp_path / "a.tif", "2"),
    ]


def test_pages_of_a_background_are_its_pictures(tmp_path: Path) -> None:
    found = background_of(film(tmp_path / "a.webp", [250, 250], lossless=True), frame_rate=Fraction(24))
    assert [each.part for each in found.cels.drawings] == ["1", "2"]
    assert found.cels.exposures == (Exposure(1, 0), Exposure(7, 1))
    assert found.length_frames == 12
    assert any("its 2 pictures are its drawings" in str(note) for note in found.notes)


def test_what_is_no_part_is_known(tmp_path: Path) -> None:
    for path in (film(tmp_path / "a.gif", [125, 125], disposal=2), pages(tmp_path / "a.tif", 2)):
        assert [has_part(PicturePart(path, address)) for address in ("1", "2", "3", "0", "x", "")] == [
            True, True, False, False, False, False,
        ]  # fmt: skip


def test_a_film_is_not_decoded_anew_for_each_picture(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = film(tmp_path / "a.gif", [125] * 5, disposal=2)
    opened: list[object] = []
    usual = Image.open

    def counted(*given: Any, **named: Any) -> Image.Image:
        opened.append(given)
        return usual(*given, **named)

    monkeypatch.setattr(Image, "open", counted)
    cels = CelCache()
    for number in range(1, 6):
        cels.cel(PicturePart(path, str(number)))
    assert len(opened) == 1


@pytest.mark.parametrize("suffix", [".png", ".webp", ".gif", ".tif"])
def test_pictures_are_the_same_in_whatever_order_they_are_read(tmp_path: Path, suffix: str) -> None:
    pictures = []
    for number in range(3):
        rgba = np.zeros((12, 16, 4), np.uint8)
        rgba[3:9, 2 + 4 * number : 5 + 4 * number] = (200, 10, 10, 255)
        pictures.append(Image.fromarray(rgba))
    path = tmp_path / f"film{suffix}"
    pictures[0].save(path, save_all=True, append_images=pictures[1:])
    wanted = [read_matte(PicturePart(path, str(number))).whole() for number in (1, 2, 3)]
    assert len({each.tobytes() for each in wanted}) == 3
    for order in itertools.product((1, 2, 3), repeat=4):
        for number in order:
            assert np.array_equal(read_matte(PicturePart(path, str(number))).whole(), wanted[number - 1]), order
