"""Why a file was refused, in one sentence."""

import errno
import sys
from pathlib import Path

import pytest

from kagezou.io.files.faults import LONGEST_ON_WINDOWS, input_problem, output_problem, too_long_for_windows

MISSING = OSError(errno.ENOENT, "not there")


def path_of(length: int) -> Path:
    """Return an absolute path of so many characters."""
    start = Path("/").absolute()
    return start / ("a" * (length - len(str(start))))


def test_only_windows_takes_no_long_paths() -> None:
    assert too_long_for_windows(path_of(LONGEST_ON_WINDOWS), "win32") is None
    assert too_long_for_windows(path_of(LONGEST_ON_WINDOWS + 1), "linux") is None
    assert too_long_for_windows(path_of(LONGEST_ON_WINDOWS + 1), "darwin") is None
    found = too_long_for_windows(path_of(LONGEST_ON_WINDOWS + 1), "win32")
    assert str(found).startswith("its path has 260 characters, and Windows takes 259")


def test_a_short_name_in_a_long_folder_counts_whole(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    found = too_long_for_windows(Path("b" * (LONGEST_ON_WINDOWS - 3)), "win32")
    assert found is not None


@pytest.mark.skipif(sys.platform == "win32", reason="there it is said otherwise where the path is long")
def test_what_is_missing_is_said_as_ever() -> None:
    path = path_of(LONGEST_ON_WINDOWS + 9)
    assert str(input_problem(path, MISSING)).endswith(": it does not exist")
    assert str(output_problem(path, MISSING)).endswith(": cannot be written: its folder does not exist")


def test_on_windows_the_length_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    path = path_of(LONGEST_ON_WINDOWS + 1)
    monkeypatch.setattr(
        "kagezou.io.files.faults.too_long_for_windows", lambda each: too_long_for_windows(each, "win32")
    )
    assert "its path has 260 characters" in str(input_problem(path, MISSING))
    assert "its path has 260 characters" in str(output_problem(path, MISSING))
    other = OSError(errno.EACCES, "no")
    assert "permission denied" in str(output_problem(path, other))
