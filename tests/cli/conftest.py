"""What the tests of the command line share."""

from pathlib import Path

import pytest

from tests.cli.projects import Shell, make_drawings


@pytest.fixture
def shell(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> Shell:
    """The command line within this process, with no display."""
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "KAGEZOU_DEBUG"):
        monkeypatch.delenv(name, raising=False)
    return Shell(capsys)


@pytest.fixture
def project(shell: Shell, tmp_path: Path) -> Path:
    """A project of one layer, Hero, with three drawings of 64 × 48 px."""
    drawings = make_drawings(tmp_path / "hero")
    path = tmp_path / "walk.kage"
    assert shell("new", path, "--character", f"Hero={drawings}") == 0
    return path
