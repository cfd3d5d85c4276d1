"""A canvas against the limits of the graphics card and of memory: a sentence, and no half export."""

from pathlib import Path

import pytest

from kagezou.errors import GraphicsProblem, UsageProblem
from kagezou.export import planning
from kagezou.render.gpu import gl, targets
from tests.export.small_cuts import bytes_below, cut, export


def test_a_canvas_over_the_largest_texture_is_told_with_both_sizes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked, largest = gl.integer, gl.GL.GL_MAX_TEXTURE_SIZE
    monkeypatch.setattr(targets, "integer", lambda what: 40 if what == largest else asked(what))
    with pytest.raises(GraphicsProblem, match=r"64x48 px is over this graphics driver's 40 px"):
        export(cut(tmp_path), tmp_path / "out", composite=True)
    assert bytes_below(tmp_path / "out") == {}


def test_a_graphics_card_that_runs_out_of_memory_is_told_and_writes_no_frame(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    noted = [0x0505]
    monkeypatch.setattr(gl.GL, "glGetError", lambda: noted.pop() if noted else 0)
    with pytest.raises(GraphicsProblem, match="out of memory"):
        export(cut(tmp_path), tmp_path / "out")
    assert bytes_below(tmp_path / "out") == {}


def test_a_canvas_over_the_memory_that_is_free_is_told_before_anything_is_made(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(planning, "free_memory", lambda: 64 * 48 * planning.PIXEL_BYTES - 1)
    with pytest.raises(UsageProblem, match="a canvas of 64 × 48 px needs about"):
        export(cut(tmp_path), tmp_path / "out", composite=True)
    assert not (tmp_path / "out").exists()
