"""What every tier of tests shares."""

import gc
import os
import shutil
import sys
from collections import defaultdict
from collections.abc import Generator, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING

import hypothesis
import numpy as np
import pytest
from xdist.remote import Producer
from xdist.scheduler import LoadScopeScheduling

from dev_display import private_display
from tests.effort import tries

if TYPE_CHECKING:
    from kagezou.render.renderer import Renderer

TESTS = Path(__file__).resolve().parent
SAMPLES = TESTS.parents[1] / "shared" / "samples"

# A busy machine is slow now and then; that says nothing about the program.
hypothesis.settings.register_profile("kagezou", deadline=None, max_examples=tries(30, 100))
hypothesis.settings.load_profile("kagezou")


# Where there is a virtual screen, each process has one of its own: two windows never fight for the keyboard.
HAS_SCREENS = sys.platform == "linux" and shutil.which("Xvfb") is not None


class ByFile(LoadScopeScheduling):
    """Where tests run side by side, those of one file stay together, and all that share the one screen.

    What a file sets up, such as the renderer, is then set up once.
    """

    def _split_scope(self, nodeid: str) -> str:
        file = nodeid.split("::", 1)[0]
        return "screen" if file.startswith("tests/ui/") and not HAS_SCREENS else file


def _nothing_to_wait_for(descriptor: int) -> None:
    """Check a descriptor as ``os.fsync`` does, without the disk: a machine that loses power tests nothing any more.

    Whether and when it is called is seen by the tests that put something else in its place.
    """
    os.fstat(descriptor)


def pytest_configure(config: pytest.Config) -> None:
    """Give a process that runs beside others its own screen, before anything is shown; let none wait for the disk."""
    patch = pytest.MonkeyPatch()
    patch.setattr(os, "fsync", _nothing_to_wait_for)
    config.add_cleanup(patch.undo)
    if HAS_SCREENS and hasattr(config, "workerinput"):
        stack = ExitStack()
        os.environ.update(stack.enter_context(private_display()))
        config.add_cleanup(stack.close)


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Producer) -> LoadScopeScheduling:
    """Hand tests out by file, whatever is asked for: marks of groups are lost with some releases of pytest."""
    config.option.loadscopereorder = False  # it takes a file of many small tests for a large one
    return ByFile(config, log)


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Generator[None, object, object]:
    """Collect no garbage while tests are collected, nor go through them again for every garbage of a test."""
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.enable()


def pytest_unconfigure() -> None:
    """Let Python take apart at its end what was kept from it, or libraries say that they leak."""
    gc.unfreeze()


_SHARES_S = {"window": 1.0, "renderer": 0.5, "qtbot": 0.3, "tmp_path": 0.05}
"""About how long a test takes that asks for one of these; others take next to no time."""


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Where tests run side by side, begin with the files that take longest: none of them is left for the end."""
    if not hasattr(config, "workerinput"):
        return
    shares: dict[Path, float] = defaultdict(float)
    for item in items:
        asked = getattr(item, "fixturenames", ())
        shares[item.path] += max((share for name, share in _SHARES_S.items() if name in asked), default=0.01)
    # Files stay whole, and the tests of a file in their order.
    items.sort(key=lambda item: (-shares[item.path], item.path))


@pytest.fixture(autouse=True)
def _numeric_errors_raise() -> Iterator[None]:
    """A division by zero or an overflow in numpy is a defect, not a warning to scroll past."""
    with np.errstate(all="raise", under="ignore"):
        yield


@pytest.fixture(scope="session")
def samples() -> Path:
    """The folder of real character animation that lies beside the project on some machines."""
    if not SAMPLES.is_dir():
        pytest.skip(f"no real sample animation beside the project ({SAMPLES.name} folder is absent)")
    return SAMPLES


@pytest.fixture(scope="session")
def figure(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A file with an anti-aliased figure, 1000×1000."""
    from tests.render.reference.figures import figure_alpha, write_figure

    return write_figure(tmp_path_factory.mktemp("figure") / "figure.png", figure_alpha())


@pytest.fixture(scope="module")
def renderer() -> "Iterator[Renderer]":
    """The real renderer on a context without a display; it lives for one module of tests."""
    # The pure tiers must not need OpenGL, so it is asked for only here.
    from kagezou.io.images.cel_cache import CelCache
    from kagezou.render.gpu.context import open_headless_context
    from kagezou.render.renderer import Renderer

    with open_headless_context():
        renderer = Renderer(CelCache())
        yield renderer
        renderer.close()
