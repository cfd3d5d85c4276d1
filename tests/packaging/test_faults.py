"""The script that fails system calls of whole processes, on a few of them; the long run is made by hand."""

import shutil
import sys
from pathlib import Path

import pytest

import dev_faults

can_watch = pytest.mark.skipif(
    sys.platform != "linux" or shutil.which("strace") is None, reason="strace is not installed"
)
LOG = """\
7 openat(AT_FDCWD</w>, "/usr/a", O_RDONLY) = 3</usr/a>
7 openat(AT_FDCWD</w>, "/w/a", O_RDONLY) = 3</w/a>
8 close(3</w/a>) = 0
8 close(4</w/b>) = -1 EIO (Input/output error) (INJECTED)
"""
OLD, NEW = {"a": b"old"}, {"a": b"new", "b": b"new"}


def test_calls_on_a_folder_are_counted_for_each_thread() -> None:
    assert list(dev_faults.calls_on(LOG, Path("/w"))) == [("openat", 2), ("close", 1), ("close", 2)]


@pytest.mark.parametrize(
    ("code", "said", "there", "came"),
    [
        (0, "", NEW, "made"),
        (0, "", OLD, "FALSE SUCCESS"),
        (5, "kagezou: a: cannot be written\n", OLD, "refused"),
        (5, "kagezou: note: b\nkagezou: a: cannot be written\n", {"a": b"new"}, "refused"),
        (5, "kagezou: a: cannot be written\n", {"a": b"ne"}, "TORN"),
        (5, "kagezou: a: cannot be written\n", {}, "TORN"),
        (5, "kagezou: a: cannot be written\n", {**OLD, ".a.part": b""}, "LEFT OVER"),
        (5, "no\nkagezou: a\n", OLD, "NOT ONE SENTENCE"),
        (1, "Traceback (most recent call last):", OLD, "CRASH"),
        (-11, "", OLD, "CRASH"),
        (None, "", OLD, "HANG"),
    ],
)
def test_how_a_run_ended(code: int | None, said: str, there: dict[str, bytes], came: str) -> None:
    assert dev_faults.ending(code, said, there, OLD, NEW) == came


@can_watch
def test_a_process_that_saves_leaves_old_or_new_whatever_fails() -> None:
    found = dev_faults.swept("save", every=9, calls=("write", "fsync", "rename"))
    assert set(found) <= dev_faults.SOUND
    assert found["refused"] > 1


@can_watch
def test_threads_that_write_frames_are_reached_as_well() -> None:
    found = dev_faults.swept("png", every=3, calls=("fsync", "rename"))
    assert set(found) <= dev_faults.SOUND
    assert found["refused"] > 1
