"""A frame at a part of its resolution looks as it does at full resolution, only coarser (spec 1)."""

import threading
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from kagezou.document.scaling import scaled
from kagezou.geometry.box import Box
from kagezou.io.images.cel_cache import CelCache
from kagezou.io.images.reading import Cel, matte_of, read_cel
from kagezou.io.images.smaller_cels import SmallerCels, reduced
from kagezou.io.images.writing import write_rgba
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from tests.render.reference.figures import standing, with_values

LOOKS: dict[str, dict[str, object]] = {
    "plain": {},
    "perspective": {"camera.fov": 40, "ground.roll": 6, "layers.A.tilt": 20},
    "grounding": {"layers.A.grounding": [[440, 890], [565, 888]], "light.overhead_radius": 500},
    "simplified": {"layers.A.shadow.simplify": 40, "layers.A.shadow.distance": 200},
    "soft": {"layers.A.shadow.softness": 24, "layers.A.shadow.grow": 6, "layers.A.shadow.penumbra": 0.1},
    "faded": {"layers.A.shadow.fade": 700, "layers.A.shadow.tip_distance": 400, "layers.A.shadow.tip_color": "#FF4020"},
    "waves": {
        "layers.A.shadow.wave1.amplitude": 8,
        "layers.A.shadow.wave2.amplitude": 4,
        "layers.A.shadow.wave_seed": 7,
    },
    "slits": {"layers.A.shadow.slits": 0.8, "layers.A.shadow.slit_spacing": 70, "layers.A.shadow.slit_growth": 0.1},
}


def means(pixels: NDArray[Any], divisor: int) -> NDArray[Any]:
    height, width = pixels.shape[:2]
    cells = pixels.reshape(height // divisor, divisor, width // divisor, divisor, -1)
    return np.asarray(cells.mean(axis=(1, 3)))


@pytest.mark.parametrize("divisor", [2, 4])
@pytest.mark.parametrize("look", LOOKS)
def test_the_look_is_the_same_at_a_part_of_the_resolution(
    renderer: Renderer, figure: Path, look: str, divisor: int
) -> None:
    document = with_values(standing(figure), LOOKS[look])
    renderer.draw_picture(evaluate(document, 3), Backdrop.WHITE)
    full = renderer.read_picture()

    small = Renderer(SmallerCels(CelCache(), document.canvas.box, divisor), divisor=divisor)
    small.draw_picture(evaluate(scaled(document, divisor), 3), Backdrop.WHITE)
    drawn = small.read_picture()
    small.close()

    assert drawn.shape == (1000 // divisor, 1000 // divisor, 4)
    wrong = np.abs(means(full, divisor)[..., :3] - drawn[..., :3]).max(axis=2)
    # Thin hair is thinner than a coarse pixel; nothing of any size is elsewhere, wider or of another tone.
    assert float(wrong.mean()) < 0.6
    assert float((wrong > 48).mean()) < 0.004


@pytest.mark.usefixtures("renderer")
def test_the_checkered_backdrop_keeps_its_squares(figure: Path) -> None:
    document = standing(figure)
    small = Renderer(SmallerCels(CelCache(), document.canvas.box, 4), divisor=4)
    small.draw_picture(evaluate(scaled(document, 4), 1), Backdrop.CHECKER)
    row = small.read_picture()[0, :12, 0]
    small.close()
    assert row[:4].tolist() == [row[0]] * 4
    assert row[4] != row[0]
    assert row[8] == row[0]


@pytest.mark.parametrize("size", [(1000, 1000), (1004, 996), (640, 720), (1001, 903)])
def test_a_drawing_lies_where_it_lay(tmp_path: Path, size: tuple[int, int]) -> None:
    """Whatever its size, larger than the canvas or not, within half a coarse pixel."""
    width, height = size
    rgba = np.zeros((height, width, 4), np.uint8)
    rgba[200:400, 300:500] = (90, 120, 30, 255)
    write_rgba(tmp_path / "a.png", rgba)
    cel = read_cel(tmp_path / "a.png")
    canvas = Box(0, 0, 1000, 1000)
    small = reduced(cel, canvas, 4)

    weight = small.matte.whole().astype(np.float64)
    y, x = np.mgrid[0 : weight.shape[0], 0 : weight.shape[1]] + 0.5
    place = np.array([(x * weight).sum(), (y * weight).sum()]) / weight.sum()
    corner = np.array([(250 - weight.shape[1]) // 2, (250 - weight.shape[0]) // 2])
    expected = np.array([400 + (1000 - width) // 2, 300 + (1000 - height) // 2])
    np.testing.assert_allclose((place + corner) * 4, expected, atol=0.1)
    np.testing.assert_array_equal(small.rgba[small.matte.whole() > 0][:, :3], [(90, 120, 30)] * int((weight > 0).sum()))


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16])
def test_colours_are_means_by_alpha_and_never_wrap(dtype: type[np.unsignedinteger[Any]]) -> None:
    full = int(np.iinfo(dtype).max)
    rgba = np.zeros((8, 8, 4), dtype)
    rgba[..., :3] = full
    rgba[..., 3] = full
    rgba[0, 0] = (0, 0, 0, 0)
    small = reduced(Cel(rgba, matte_of(rgba[..., 3]), ()), Box(0, 0, 8, 8), 4)
    assert small.rgba[..., :3].min() == full
    assert small.rgba[1, 1, 3] == full
    assert small.rgba[0, 0, 3] == round(full * 15 / 16)


def test_smaller_drawings_are_made_beside_and_then_ready(figure: Path) -> None:
    cels = SmallerCels(CelCache(), Box(0, 0, 1000, 1000), 2)
    assert not cels.is_ready([figure], None)
    cels.is_ready([figure], figure)
    for thread in threading.enumerate():
        if thread.name == "smaller":
            thread.join(60)
    assert cels.is_ready([figure], figure)
    assert cels.cel(figure) is cels.cel(figure)
