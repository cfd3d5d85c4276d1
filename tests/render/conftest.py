"""The real renderer on an EGL context, and characters to cast shadows of."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from figures import figure_alpha, write_figure

from kagezou.io.cels import CelCache
from kagezou.render.context import open_headless_context
from kagezou.render.renderer import Renderer


@pytest.fixture(scope="session")
def figure(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An anti-aliased figure, 1000×1000."""
    return write_figure(tmp_path_factory.mktemp("figure") / "figure.png", figure_alpha())


@pytest.fixture(scope="module")
def renderer() -> Iterator[Renderer]:
    """A renderer that lives for one module of tests."""
    with open_headless_context():
        renderer = Renderer(CelCache())
        yield renderer
        renderer.close()
