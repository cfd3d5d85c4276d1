"""Several shadows as one layer: laid on any picture it does what they do one after the other."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.geometry.box import Box
from kagezou.io.images.writing import ShadowImage
from kagezou.render.prepare.mixing import mixed

SIDE = 12
EMPTY = Box(0, 0, 0, 0)


def image(seed: int, box: Box, color: tuple[int, int, int], kind: type = np.uint16) -> ShadowImage:
    steps = np.iinfo(kind).max
    alpha = np.random.default_rng(seed).choice([0, steps // 3, steps // 2, steps], (box.height, box.width))
    return ShadowImage(SIDE, SIDE, color, alpha.astype(kind), box)


def laid_on(picture: np.ndarray, layer: ShadowImage, *, multiply: bool) -> np.ndarray:
    rgba = layer.rgba() / np.iinfo(layer.alpha.dtype).max
    color, alpha = rgba[..., :3], rgba[..., 3:]
    result = picture * (1 - alpha + alpha * color) if multiply else picture * (1 - alpha) + alpha * color
    return np.asarray(result)


EDGES = st.tuples(st.integers(0, SIDE), st.integers(0, SIDE)).map(sorted)
BOXES = st.builds(lambda across, down: Box(across[0], down[0], across[1], down[1]), EDGES, EDGES)
COLORS = st.tuples(*[st.integers(0, 255)] * 3)
IMAGES = st.lists(st.builds(image, st.integers(0, 99), BOXES, COLORS), min_size=1, max_size=4)


@given(images=IMAGES, multiply=st.booleans())
def test_one_layer_does_what_all_do_one_after_the_other(images: list[ShadowImage], *, multiply: bool) -> None:
    together = mixed(images, multiply=multiply)
    for picture in (np.ones((SIDE, SIDE, 3)), np.full((SIDE, SIDE, 3), (0.2, 0.7, 0.45))):
        wanted = picture
        for each in images:
            wanted = laid_on(wanted, each, multiply=multiply)
        got = laid_on(picture, together, multiply=multiply)
        assert np.abs(got - wanted).max() < 4 / 65535
    assert (together.width_px, together.height_px) == (SIDE, SIDE)


def test_one_shadow_alone_stays_as_it_is() -> None:
    nothing, one = image(1, EMPTY, (1, 2, 3)), image(2, Box(2, 3, 8, 9), (40, 50, 60))
    assert mixed([nothing, one, nothing], multiply=True) is one
    assert mixed([nothing, nothing], multiply=False) is nothing


@pytest.mark.parametrize("kind", [np.uint8, np.uint16])
def test_the_layer_is_as_deep_as_its_shadows_and_no_larger_than_they(kind: type) -> None:
    layer = mixed(
        [image(1, Box(1, 2, 5, 6), (9, 9, 9), kind), image(2, Box(4, 5, 9, 7), (90, 0, 0), kind)], multiply=True
    )
    assert layer.box == Box(1, 2, 9, 7)
    assert layer.colors is not None
    assert layer.alpha.dtype == layer.colors.dtype == kind
    assert layer.colors.shape == (*layer.alpha.shape, 3)


def test_where_nothing_lies_the_color_is_that_of_the_lowest() -> None:
    layer = mixed([image(1, Box(0, 0, 2, 2), (10, 20, 30)), image(2, Box(6, 6, 8, 8), (200, 0, 0))], multiply=False)
    assert layer.colors is not None
    assert layer.alpha[0, 7] == 0
    assert (layer.colors[0, 7] // 257).tolist() == [10, 20, 30]
