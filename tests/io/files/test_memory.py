"""Memory that is free, and free memory that is given back."""

import sys
from pathlib import Path

import pytest

from kagezou.io.files import memory


def resident_bytes() -> int:
    return int(Path("/proc/self/statm").read_text("ascii").split()[1]) << 12


def test_what_is_free_is_part_of_what_there_is() -> None:
    free, whole = memory.free_memory(), memory.whole_memory()
    if free is not None and whole is not None:
        assert 0 < free <= whole


@pytest.mark.skipif(sys.platform != "linux", reason="the C library of other systems keeps nothing back")
def test_what_lies_free_between_blocks_in_use_is_given_back() -> None:
    blocks = [bytearray(20_000) for _ in range(5_000)]
    # Every tenth stays, so that the heap cannot shrink from its end.
    kept = blocks[::10]
    del blocks
    before = resident_bytes()
    memory.give_back()
    assert before - resident_bytes() > 50 << 20
    assert len(kept) == 500


def test_elsewhere_nothing_is_asked_for(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "platform", "win32")
    memory.give_back()
