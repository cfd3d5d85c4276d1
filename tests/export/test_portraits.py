"""Portraits: the figure and its shadow are whole, wherever on the canvas they stand, and as large as they can be."""

from collections.abc import Iterator
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from kagezou.document.edits import set_canvas
from kagezou.document.model import Document
from kagezou.document.roomier import roomier
from kagezou.export.portraits import Portraits, square_of
from kagezou.geometry.box import Box
from kagezou.io.images.reading import Steps
from kagezou.render.gpu.context import open_headless_context
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from tests.export.small_cuts import cut, with_values

SKIN = (200, 120, 40)


@pytest.fixture(autouse=True, scope="module")
def _context() -> Iterator[None]:
    with open_headless_context():
        yield


@pytest.fixture
def walk(tmp_path: Path) -> Document:
    """A block of 8 × 20 px on a canvas of 64 × 48 whose shadow leaves the canvas at the right."""
    return with_values(cut(tmp_path), light__kind="sun", light__azimuth=-80.0, light__elevation=20.0)


def portrait(document: Document, frame: int = 1, side_px: int = 100) -> Steps:
    with closing(Portraits(document, "layer-1", frame, side_px)) as portraits:
        return portraits.draw(document, portraits.box(document), Backdrop.WHITE)


def skin_px(picture: Steps) -> int:
    return int((np.abs(picture[..., :3].astype(int) - SKIN).max(axis=2) < 8).sum())


def is_empty_around(picture: Steps) -> bool:
    """Whether the outermost pixels are white on every side: nothing is cut off."""
    edges = (picture[0], picture[-1], picture[:, 0], picture[:, -1])
    return all(int(edge[..., :3].min()) >= 250 for edge in edges)


def test_a_shadow_that_leaves_the_canvas_is_whole(renderer: Renderer, walk: Document) -> None:
    renderer.draw_picture(evaluate(walk, 1), Backdrop.WHITE)
    assert not is_empty_around(renderer.read_picture())
    seen = portrait(walk)
    assert is_empty_around(seen)
    assert skin_px(seen) == 8 * 20


@pytest.mark.parametrize("place", [[0, 24], [64, 24], [32, 0], [32, 60]])
def test_a_figure_at_the_edge_is_whole(walk: Document, place: list[int]) -> None:
    seen = portrait(with_values(walk, layers__A__position=place))
    assert is_empty_around(seen)
    assert skin_px(seen) == 8 * 20


def test_a_reflection_that_leaves_the_canvas_is_whole(renderer: Renderer, walk: Document) -> None:
    mirrored = with_values(walk, layers__A__reflection__opacity=1.0)
    renderer.draw_picture(evaluate(mirrored, 1), Backdrop.WHITE)
    assert not is_empty_around(renderer.read_picture())
    seen = portrait(mirrored)
    assert is_empty_around(seen)
    assert skin_px(seen) == 2 * 8 * 20


def test_it_is_as_large_as_it_can_be(walk: Document) -> None:
    """What is longest of figure and shadow nearly fills the square."""
    seen = portrait(walk)
    inked = seen[..., :3].min(axis=2) < 250
    columns, rows = inked.any(axis=0), inked.any(axis=1)
    assert max(columns.sum(), rows.sum()) > 0.85 * seen.shape[0]


def test_large_drawings_are_made_smaller_first(walk: Document) -> None:
    large, small = portrait(walk), portrait(walk, side_px=10)
    assert abs(small.shape[0] - large.shape[0] / 2) <= 4
    assert is_empty_around(small)
    assert abs(skin_px(small) - 4 * 10) <= 6


def test_a_canvas_that_cannot_be_divided_is_drawn_as_it_is(walk: Document) -> None:
    odd = set_canvas(walk, replace(walk.canvas, width_px=63))
    assert is_empty_around(portrait(odd, side_px=10))


def test_where_nothing_is_seen_it_is_the_canvas(walk: Document) -> None:
    hidden = with_values(walk, layers__A__visible=False)
    assert int(portrait(hidden).min()) == 255


@pytest.mark.parametrize("fov", [0.0, 50.0])
@pytest.mark.parametrize("waves", [0.0, 3.0])
def test_margins_change_nothing_within_the_canvas(renderer: Renderer, walk: Document, fov: float, waves: float) -> None:
    document = with_values(walk, camera__fov=fov, layers__A__shadow__wave1__amplitude=waves, light__elevation=50.0)
    renderer.draw_picture(evaluate(document, 1), Backdrop.WHITE)
    before = renderer.read_picture().astype(int)
    renderer.draw_picture(evaluate(roomier(document, 21, 30), 1), Backdrop.WHITE)
    after = renderer.read_picture()[30:-30, 21:-21].astype(int)
    assert np.abs(after - before).max() <= 8


def test_beyond_the_picture_it_is_white() -> None:
    picture = np.zeros((10, 20, 4), np.uint8)
    square = square_of(picture, Box(-4, 2, 6, 8))
    assert square.shape == (12, 12, 4)
    assert (square == 0).all(axis=2).sum() == 7 * 10
    assert (square == 255).all(axis=2).sum() == 144 - 70
    assert (square_of(picture, Box(50, 50, 60, 60)) == 255).all()
