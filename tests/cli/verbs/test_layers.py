"""``kagezou new`` with OpenEXR files of several layers, and with files of several pictures."""

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from kagezou.io.images.reading import read_cel
from kagezou.io.project.file import load
from tests.cli.projects import Shell, make_drawings
from tests.io.images import picture_files as files


def make_layers(path: Path) -> Path:
    pixels = np.zeros((48, 64, 7), np.float32)
    pixels[10:40, 20:30, :4] = 0.2, 0.2, 0.2, 1.0
    pixels[..., 4:] = 0.7
    path.parent.mkdir(parents=True, exist_ok=True)
    files.save(path, pixels, straight=False, names=("R", "G", "B", "A", "diffuse.R", "diffuse.G", "diffuse.B"))
    return path


def test_a_layer_of_the_background(tmp_path: Path, shell: Shell) -> None:
    drawings, behind = make_drawings(tmp_path / "A"), make_layers(tmp_path / "bg.exr")
    project = tmp_path / "a.kage"
    assert shell("new", project, "--character", f"A={drawings}", "--background", behind, "--layer", "diffuse") == 0
    assert "bg.exr: not used of it: RGBA" in shell.said
    (drawing,) = load(project).behind.drawings
    assert drawing.part == "diffuse"
    assert read_cel(drawing.source, white_is_clear=False).rgba[0, 0, 0] > 50000
    assert shell("info", project) == 0
    assert "missing" not in shell.out


def test_a_layer_of_one_character(tmp_path: Path, shell: Shell) -> None:
    for number in (1, 2):
        make_layers(tmp_path / "A" / f"A_{number}.exr")
    behind = make_layers(tmp_path / "bg.exr")
    words = ["--character", f"A={tmp_path / 'A'}", "--background", behind]
    assert shell("new", tmp_path / "a.kage", *words, "--layer", "background=diffuse") == 0
    document = load(tmp_path / "a.kage")
    assert [each.part for each in document.layers[0].cels.drawings] == [None, None]
    assert "A: not used of it: diffuse, in all its 2 files" in shell.said
    assert shell("new", tmp_path / "b.kage", *words, "--layer", "A=diffuse") == 0
    document = load(tmp_path / "b.kage")
    assert [each.part for each in document.layers[0].cels.drawings] == ["diffuse", "diffuse"]
    assert document.behind.drawings[0].part is None


@pytest.mark.parametrize(
    ("layer", "said"),
    [
        ("B=diffuse", "--layer B=diffuse: there is no character 'B'"),
        ("diffuse", "--layer diffuse: none of the files is OpenEXR"),
    ],
)
def test_a_layer_of_nothing_is_refused(tmp_path: Path, shell: Shell, layer: str, said: str) -> None:
    drawings = make_drawings(tmp_path / "A")
    assert shell("new", tmp_path / "a.kage", "--character", f"A={drawings}", "--layer", layer) != 0
    assert said in shell.said
    assert not (tmp_path / "a.kage").exists()


def test_a_layer_that_is_not_there_is_refused_by_its_names(tmp_path: Path, shell: Shell) -> None:
    drawing = make_layers(tmp_path / "A.exr")
    assert shell("new", tmp_path / "a.kage", "--character", f"A={drawing}", "--layer", "spec") != 0
    assert "there is no layer 'spec' in it, but there are: '', diffuse" in shell.said


def test_a_film_is_rendered_picture_by_picture(tmp_path: Path, shell: Shell) -> None:
    pictures = []
    for number in range(3):
        rgba = np.zeros((48, 64, 4), np.uint8)
        rgba[10:40, 10 + 10 * number : 20 + 10 * number] = 200, 10, 10, 255
        pictures.append(Image.fromarray(rgba))
    path = tmp_path / "A.png"
    pictures[0].save(path, save_all=True, append_images=pictures[1:], duration=125)
    assert shell("new", tmp_path / "a.kage", "--character", f"A={path}", "--fps", "8") == 0
    assert "its 3 pictures are its drawings, as long as it says at 8 frames/s" in shell.said
    out = tmp_path / "out"
    assert shell("render", tmp_path / "a.kage", "-o", out, "--composite") == 0, shell.said
    found = [np.asarray(Image.open(each).convert("RGBA")) for each in sorted((out / "composite").glob("*.png"))]
    reds = [np.flatnonzero((each[20, :, 0] > 150) & (each[20, :, 1] < 60)).tolist() for each in found]
    assert reds == [list(range(10 + 10 * number, 20 + 10 * number)) for number in range(3)]
