"""Files of ours, opened by programs that one paints and animates with: what these show is what we wrote."""

from pathlib import Path

import pytest

from tests.export.exchange.cuts import composites, levels_apart, pixels_of, rich_cut
from tests.export.small_cuts import HEIGHT, WIDTH, export
from tests.programs.programs import needs, ran

_FLATTENED = """\
(let* ((image (car (gimp-file-load RUN-NONINTERACTIVE "{source}" "a"))))
  (gimp-message (string-append "layers: " (number->string (car (gimp-image-get-layers image)))))
  (gimp-image-flatten image)
  (if (= {eight} (car (gimp-image-get-precision image))) 0 (gimp-image-convert-precision image {eight}))
  (file-png-save RUN-NONINTERACTIVE image (car (gimp-image-get-active-drawable image)) "{target}" "a" 0 6 0 0 0 0 0))
"""
_EIGHT_BIT = 150
"""What GIMP 2.10 calls 8 bit of sRGB."""


@needs("gimp")
@pytest.mark.parametrize("depth", [8, 16])
def test_gimp_shows_a_layered_document(depth: int, tmp_path: Path) -> None:
    document = rich_cut(tmp_path / "in")
    export(document, tmp_path / "out", layered=True, format="psd", depth=depth)
    source, target = tmp_path / "out" / "layered" / "layered_0006.psd", tmp_path / "seen.png"
    script = _FLATTENED.format(source=source, target=target, eight=_EIGHT_BIT)
    said = ran(tmp_path / "home", "gimp", "-i", "-d", "-f", "-b", script, "-b", "(gimp-quit 0)")
    assert "layers: 6" in said, said
    assert levels_apart(pixels_of(target)[..., :3], composites(document, tmp_path / "ref")[5][..., :3]) <= 1


@needs("krita")
@pytest.mark.parametrize(("depth", "levels"), [(8, 2), (16, 1)])
def test_krita_shows_a_layered_document(depth: int, levels: int, tmp_path: Path) -> None:
    document = rich_cut(tmp_path / "in")
    export(document, tmp_path / "out", layered=True, format="psd", depth=depth)
    source, target = tmp_path / "out" / "layered" / "layered_0006.psd", tmp_path / "seen.png"
    said = ran(tmp_path / "home", "krita", "--nosplash", "--export", "--export-filename", str(target), str(source))
    assert target.is_file(), said
    # Of 8 bit it rounds after each of six layers.
    assert levels_apart(pixels_of(target)[..., :3], composites(document, tmp_path / "ref")[5][..., :3]) <= levels


_SYNFIG = """\
<?xml version="1.0" encoding="UTF-8"?>
<canvas version="1.2" width="{width}" height="{height}" gamma-r="1.0" gamma-g="1.0" gamma-b="1.0"
 view-box="-4 3 4 -3" antialias="1" fps="24" begin-time="0f" end-time="1f" bgcolor="1 1 1 1">
<name>cut</name>{layers}</canvas>
"""
_SYNFIG_LAYER = """
<layer type="import" active="true" version="0.1" desc="{path}">
<param name="amount"><real value="{opacity}"/></param><param name="blend_method"><integer value="{blend}"/></param>
<param name="tl"><vector><x>-4.0</x><y>3.0</y></vector></param>
<param name="br"><vector><x>4.0</x><y>-3.0</y></vector></param>
<param name="c"><integer value="0"/></param><param name="filename"><string>{path}</string></param></layer>
"""


@needs("synfig")
def test_synfig_multiplies_shadow_frames(tmp_path: Path) -> None:
    document = rich_cut(tmp_path / "in")
    export(document, tmp_path / "out")
    shadow = tmp_path / "out" / "主役 #1_shadow" / "主役 #1_shadow_0006.png"
    layers = [
        _SYNFIG_LAYER.format(path=path, opacity=1.0, blend=blend)
        for path, blend in ((tmp_path / "in" / "meadow.png", 0), (shadow, 6))
    ]
    scene, target = tmp_path / "cut.sif", tmp_path / "seen.png"
    scene.write_text(_SYNFIG.format(width=WIDTH, height=HEIGHT, layers="".join(layers)), encoding="utf-8")
    said = ran(tmp_path / "home", "synfig", str(scene), "-t", "png", "--time", "0f", "-o", str(target))
    assert target.is_file(), said
    over, under = pixels_of(shadow), pixels_of(tmp_path / "in" / "meadow.png")[..., :3]
    wanted = under * (1 - over[..., 3:]) + under * over[..., :3] * over[..., 3:]
    assert levels_apart(pixels_of(target)[..., :3], wanted) <= 1


_PENCIL = """\
<!DOCTYPE PencilDocument>
<document><object formatVersion="3">
<layer id="1" name="Camera Layer" visibility="1" type="5" width="{width}" height="{height}">
<camera frame="1" r="0" s="1" dx="0" dy="0"/></layer>
<layer id="2" name="background" visibility="1" type="1">
<image frame="1" src="002.001.png" topLeftX="{left}" topLeftY="{top}" opacity="1"/></layer>
<layer id="3" name="shadow" visibility="1" type="1">
<image frame="1" src="003.001.png" topLeftX="{left}" topLeftY="{top}" opacity="1"/></layer>
</object></document>
"""


@needs("pencil2d")
def test_pencil2d_lays_shadow_frames(tmp_path: Path) -> None:
    document = rich_cut(tmp_path / "in")
    export(document, tmp_path / "out")
    shadow, meadow = tmp_path / "out" / "相棒_shadow" / "相棒_shadow_0001.png", tmp_path / "in" / "meadow.png"
    data = tmp_path / "cut.pcl.data"
    data.mkdir()
    for path, name in ((meadow, "002.001.png"), (shadow, "003.001.png")):
        (data / name).write_bytes(path.read_bytes())
    text = _PENCIL.format(width=WIDTH, height=HEIGHT, left=-WIDTH // 2, top=-HEIGHT // 2)
    (tmp_path / "cut.pcl").write_text(text, encoding="utf-8")
    size = ("--width", str(WIDTH), "--height", str(HEIGHT))
    said = ran(tmp_path / "home", "pencil2d", str(tmp_path / "cut.pcl"), "-o", str(tmp_path / "seen.png"), *size)
    (target,) = tmp_path.glob("seen*.png")
    assert target.is_file(), said
    over, under = pixels_of(shadow), pixels_of(meadow)[..., :3]
    assert levels_apart(pixels_of(target)[..., :3], under * (1 - over[..., 3:]) + over[..., :3] * over[..., 3:]) <= 2
