"""Several shadows as one layer: laid on any picture it does what they do one after the other."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.geometry.box import Box
from kagezou.io.images.writing import ShadowImage
from kagezou.render.prepare.mixing import Laid, mixed

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
SHADOWS = st.lists(
    st.builds(Laid, st.builds(image, st.integers(0, 99), BOXES, COLORS), st.booleans()), min_size=1, max_size=4
)


@given(shadows=SHADOWS)
def test_two_layers_do_what_all_do_one_after_the_other(shadows: list[Laid]) -> None:
    under, over = (mixed(shadows, multiply=multiply, depth=16) for multiply in (True, False))
    for picture in (np.ones((SIDE, SIDE, 3)), np.full((SIDE, SIDE, 3), (0.2, 0.7, 0.45))):
        wanted = picture
        for each, multiply in shadows:
            wanted = laid_on(wanted, each, multiply=multiply)
        got = laid_on(laid_on(picture, under, multiply=True), over, multiply=False)
        assert np.abs(got - wanted).max() < 6 / 65535
    for layer, multiply in ((under, True), (over, False)):
        assert (layer.width_px, layer.height_px) == (SIDE, SIDE)
        assert layer.box.is_empty or any(each.multiply == multiply for each in shadows)


def test_one_shadow_alone_stays_as_it_is() -> None:
    nothing, one = (
        Laid(image(1, EMPTY, (1, 2, 3)), multiply=True),
        Laid(image(2, Box(2, 3, 8, 9), (40, 50, 60)), multiply=True),
    )
    assert mixed([nothing, one, nothing], multiply=True, depth=16) is one.image
    empty = mixed([nothing, one], multiply=False, depth=16)
    assert (empty.box.is_empty, empty.color) == (True, (1, 2, 3))
    coarse = mixed([nothing, one], multiply=True, depth=8)
    assert np.abs(coarse.rgba() / 255 - one.image.rgba() / 65535).max() <= 0.5 / 255


def test_what_has_colours_of_its_own_keeps_them() -> None:
    colors = np.random.default_rng(4).integers(0, 65536, (6, 6, 3)).astype(np.uint16)
    tipped = replace(image(3, Box(2, 3, 8, 9), (9, 9, 9)), colors=colors)
    both = [Laid(tipped, multiply=True), Laid(image(5, Box(0, 0, 7, 7), (200, 40, 90)), multiply=True)]
    wanted = np.ones((SIDE, SIDE, 3))
    for each, _ in both:
        wanted = laid_on(wanted, each, multiply=True)
    got = laid_on(np.ones((SIDE, SIDE, 3)), mixed(both, multiply=True, depth=16), multiply=True)
    assert np.abs(got - wanted).max() < 4 / 65535


@pytest.mark.parametrize(("depth", "kind"), [(8, np.uint8), (16, np.uint16)])
def test_the_layer_is_as_deep_as_is_wanted_and_no_larger_than_its_shadows(depth: int, kind: type) -> None:
    first, second = image(1, Box(1, 2, 5, 6), (9, 9, 9)), image(2, Box(4, 5, 9, 7), (90, 0, 0))
    layer = mixed([Laid(first, multiply=True), Laid(second, multiply=True)], multiply=True, depth=depth)
    assert layer.box == Box(1, 2, 9, 7)
    assert layer.colors is not None
    assert layer.alpha.dtype == layer.colors.dtype == kind
    assert layer.colors.shape == (*layer.alpha.shape, 3)


def test_where_nothing_lies_the_color_is_that_of_the_lowest() -> None:
    first, second = image(1, Box(0, 0, 2, 2), (10, 20, 30)), image(2, Box(6, 6, 8, 8), (200, 0, 0))
    layer = mixed([Laid(first, multiply=False), Laid(second, multiply=False)], multiply=False, depth=16)
    assert layer.colors is not None
    assert layer.alpha[0, 7] == 0
    assert (layer.colors[0, 7] // 257).tolist() == [10, 20, 30]
