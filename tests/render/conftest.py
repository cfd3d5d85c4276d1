"""A renderer that takes meshes from memory, for the tests of several rooms."""

from collections.abc import Iterator

import pytest

from kagezou.io.images.cel_cache import CelCache
from kagezou.render.gpu.context import open_headless_context
from kagezou.render.renderer import Renderer
from tests.render.reference.mesh_scenes import Meshes


@pytest.fixture(scope="module")
def meshes() -> Meshes:
    return Meshes()


@pytest.fixture(scope="module")
def mesh_renderer(meshes: Meshes) -> Iterator[Renderer]:
    with open_headless_context():
        renderer = Renderer(CelCache(), meshes)
        yield renderer
        renderer.close()
