"""What hours of work are judged by."""

import importlib
import sys
from dataclasses import replace
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def endurance(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    monkeypatch.syspath_prepend(str(ROOT / "packaging"))
    return importlib.import_module("dev_endurance")


def test_what_climbs_in_the_second_half_is_growth(endurance: ModuleType) -> None:
    assert endurance.growth([900, 100, 1, 2, 3, 4]) == pytest.approx(2.0)
    assert endurance.growth([100, 300, 500, 500, 500, 500]) == pytest.approx(0.0)
    assert endurance.growth([5]) == 0.0


@pytest.mark.parametrize("name", ["memory_mb", "descriptors", "threads", "widgets"])
def test_each_column_is_judged_by_itself(endurance: ModuleType, name: str) -> None:
    flat = [endurance.Taken(900 + minute % 3, 18, 12, 1000) for minute in range(60)]
    assert endurance.grown(flat) == {}
    climbing = [replace(row, **{name: getattr(row, name) + 40 * minute}) for minute, row in enumerate(flat)]
    assert list(endurance.grown(climbing)) == [name]
    noisy = [replace(row, **{name: getattr(row, name) + minute % 2 * 3}) for minute, row in enumerate(flat)]
    assert endurance.grown(noisy) == {}


@pytest.mark.skipif(sys.platform != "linux", reason="counted by /proc")
def test_what_a_process_has_is_counted(endurance: ModuleType) -> None:
    before = endurance.Taken.now()
    with Path(__file__).open(encoding="utf-8"):
        assert endurance.Taken.now().descriptors == before.descriptors + 1
    assert before.memory_mb > 10
    assert before.threads >= 1
