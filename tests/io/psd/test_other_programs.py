"""Photoshop documents opened by programs that share no code with what wrote them, nor with each other."""

import os
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from kagezou.geometry.box import Box
from kagezou.io.images.layered import write_layered
from kagezou.io.images.reading import read_cel
from kagezou.io.pixels.layers import LayeredImage, LayerPart, PartGroup

GIMP = shutil.which("gimp-console-2.10") or shutil.which("gimp-console")
MAGICK = shutil.which("convert-im6.q16") or shutil.which("magick")
FULL = {8: 255, 16: 65535}

TELL = """
(let* ((image (car (gimp-file-load RUN-NONINTERACTIVE "{path}" "{path}"))))
  (define (tell prefix item)
    (let* ((place (gimp-drawable-offsets item)))
      (gimp-message (string-append "told|" prefix (car (gimp-item-get-name item))
        "|" (number->string (car place)) "|" (number->string (cadr place))
        "|" (number->string (car (gimp-drawable-width item))) "|" (number->string (car (gimp-drawable-height item)))
        "|" (number->string (round (* 2.55 (car (gimp-layer-get-opacity item)))))
        "|" (number->string (car (gimp-layer-get-mode item)))))
      (if (= (car (gimp-item-is-group item)) 1)
        (for-each (lambda (each) (tell "-" each)) (vector->list (cadr (gimp-item-get-children item))))
        (let* ((file (string-append "{folder}/" (car (gimp-item-get-name item)) ".png")))
          (gimp-file-save RUN-NONINTERACTIVE image item file file)))))
  (for-each (lambda (each) (tell "" each)) (vector->list (cadr (gimp-image-get-layers image)))))
"""


def noise(seed: int, height: int, width: int, depth: int) -> NDArray[Any]:
    return np.random.default_rng(seed).integers(1, FULL[depth] + 1, (height, width, 4)).astype(f"u{depth // 8}")


@pytest.fixture(params=[8, 16])
def image(request: pytest.FixtureRequest) -> LayeredImage:
    """A plain layer, two in a group with a mask, an empty one, and one on top."""
    depth = request.param
    mask = noise(1, 6, 7, depth)[..., 0]
    group = PartGroup("shadows", 128 / 255, multiply=True, mask=mask, mask_box=Box(4, 5, 11, 11))
    parts = (
        LayerPart("paper", noise(2, 20, 30, depth), Box(0, 0, 30, 20)),
        LayerPart("A_shadow", noise(3, 9, 8, depth), Box(3, 4, 11, 13), group=group),
        LayerPart("B_shadow", noise(4, 5, 6, depth), Box(8, 8, 14, 13), group=group),
        LayerPart("nothing", noise(5, 0, 0, depth), Box(0, 0, 0, 0)),
        LayerPart("A", noise(6, 10, 10, depth), Box(10, 5, 20, 15), 51 / 255),
    )
    return LayeredImage(30, 20, parts, noise(7, 20, 30, depth), depth)


@pytest.mark.skipif(GIMP is None, reason="GIMP 2.10 is not installed")
def test_gimp_opens_every_layer(image: LayeredImage, tmp_path: Path) -> None:
    assert GIMP is not None
    write_layered(tmp_path / "a.psd", image)
    script = TELL.format(path=tmp_path / "a.psd", folder=tmp_path)
    command = [
        GIMP,
        "-i",
        "-d",
        "-f",
        "--batch-interpreter",
        "plug-in-script-fu-eval",
        "-b",
        script,
        "-b",
        "(gimp-quit 0)",
    ]
    home = {**os.environ, "HOME": str(tmp_path), "XDG_CONFIG_HOME": str(tmp_path), "XDG_CACHE_HOME": str(tmp_path)}
    done = subprocess.run(command, capture_output=True, text=True, env=home, check=False, timeout=180)
    told = [
        line.partition("told|")[2].split("|") for line in (done.stdout + done.stderr).splitlines() if "told|" in line
    ]
    names = [line[0] for line in told]
    assert names == ["A", "nothing", "shadows", "-B_shadow", "-A_shadow", "paper"], done.stderr
    of_name = {line[0].removeprefix("-"): [int(float(word)) for word in line[1:]] for line in told}
    normal, multiply = of_name["paper"][5], of_name["shadows"][5]
    assert normal != multiply
    assert of_name["shadows"][4] == 128
    for part in image.parts:
        left, top, width, height, opacity, mode = of_name[part.name]
        assert (opacity, mode) == (round(255 * part.opacity), normal), part.name
        if not part.box.is_empty:
            assert Box(left, top, left + width, top + height) == part.box
            assert np.array_equal(read_cel(tmp_path / f"{part.name}.png").rgba, part.pixels), part.name


@pytest.mark.skipif(MAGICK is None, reason="ImageMagick is not installed")
def test_imagemagick_opens_every_layer(image: LayeredImage, tmp_path: Path) -> None:
    assert MAGICK is not None
    write_layered(tmp_path / "a.psd", image)
    for number, part in enumerate((each for each in image.parts if not each.box.is_empty), start=1):
        command = [MAGICK, f"{tmp_path / 'a.psd'}[{number}]", "-depth", str(image.depth), "-endian", "LSB"]
        about = [*command, "-format", "%l|%w|%h|%X|%Y", "info:"]
        said = subprocess.run(about, capture_output=True, check=True, timeout=60)
        label, *place = said.stdout.decode().split("|")
        assert label == part.name
        assert [int(word) for word in place] == [part.box.width, part.box.height, part.box.left, part.box.top]
        pixels = subprocess.run([*command, "rgba:-"], capture_output=True, check=True, timeout=60).stdout
        found = np.frombuffer(pixels, f"<u{image.depth // 8}").reshape(part.pixels.shape)
        assert np.array_equal(found[..., :3], part.pixels[..., :3]), part.name
        assert np.abs(found[..., 3] - part.pixels[..., 3] * part.opacity).max() <= 1, part.name
