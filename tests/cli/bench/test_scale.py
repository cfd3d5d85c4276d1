"""How an export grows is measured with whole processes, and told."""

import sys
from pathlib import Path

import pytest

from kagezou.cli.bench import scale
from kagezou.cli.bench.scale import Grown, Sizes, grown
from kagezou.cli.bench.whole_processes import Spent, taken
from kagezou.errors import OutputProblem
from tests.export.small_cuts import drawings

FEW = Sizes((2, 4), (1, 2), (64, 128), (1,), (1, 2), few=2, shared=4)


def test_every_kind_is_measured_at_every_size(tmp_path: Path) -> None:
    drawings(tmp_path / "drawings", 2)
    steps: list[tuple[int, int]] = []
    made = list(grown(tmp_path / "drawings", tmp_path, lambda done, of: steps.append((done, of)), FEW))
    assert [each.name for each in made] == ["frames", "layers", "px wide", "cuts", "workers"]
    assert [each.sizes for each in made] == [FEW.frames, FEW.layers, FEW.widths_px, FEW.cuts, FEW.workers]
    assert all(took.wall_s > 0 for each in made for took in each.took)
    assert steps[0] == (0, 9)
    assert steps[-1] == (9, 9)
    # No two pictures are equal, or there would be less to do than is counted; workers make all frames between them.
    assert len(list((tmp_path / "frames-4").rglob("*_shadow_*.png"))) == 4
    assert len({path.read_bytes() for path in (tmp_path / "frames-4").rglob("*_shadow_*.png")}) > 2
    assert len(list((tmp_path / "layers-2").rglob("*_shadow_*.png"))) == 4
    assert len(list((tmp_path / "workers-2").rglob("*_shadow_*.png"))) == 4


def test_growth_is_the_largest_over_the_smallest() -> None:
    one = Grown("frames", (1, 2, 4), (Spent(2.0, 1.0, 100), Spent(3.0, 2.0, 110), Spent(8.0, 4.0, 150)))
    assert one.times == 4.0
    assert one.memory == 1.5
    assert Grown("frames", (1, 2), (Spent(2.0, 0.0, 0), Spent(3.0, 0.0, 0))).memory == 1.0


@pytest.mark.skipif(sys.platform == "win32", reason="Windows does not tell of ended processes")
def test_a_program_is_timed_and_its_memory_told() -> None:
    small = taken("small", (sys.executable, "-S", "-c", "pass"))
    large = taken("large", (sys.executable, "-S", "-c", "x = bytearray(200 << 20); sum(range(10 ** 6))"))
    assert large.peak_bytes - small.peak_bytes > 150 << 20
    assert large.cpu_s > 0


def test_a_program_that_takes_too_long_is_ended() -> None:
    with pytest.raises(OutputProblem, match="cannot be timed"):
        taken("slow", (sys.executable, "-c", "import time; time.sleep(1000)"), limit_s=0.2)


def test_the_cuts_of_one_figure_stand_apart(tmp_path: Path) -> None:
    drawings(tmp_path / "drawings", 2)
    document = scale._cut(tmp_path / "drawings", 3, 2)
    assert document.canvas.length_frames == 3
    assert len(document.layers) == 2
