"""What the tests of the interface share."""

from pathlib import Path

import pytest

import kagezou
from kagezou.export.after.hooks import COMMAND_VARIABLE
from tests.cli.projects import make_drawings


@pytest.fixture(autouse=True)
def _nothing_after(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(COMMAND_VARIABLE, "")


@pytest.fixture
def drawings(tmp_path: Path) -> Path:
    """Three drawings of 64 × 48 px."""
    return make_drawings(tmp_path / "hero")


@pytest.fixture
def cut(drawings: Path, tmp_path: Path) -> kagezou.Cut:
    """A saved cut of one character, Hero."""
    return kagezou.new({"Hero": drawings}).save(tmp_path / "walk.kage")
