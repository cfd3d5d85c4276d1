"""What lies in a folder that the system does not open is one sentence."""

import errno
from collections.abc import Iterator
from pathlib import Path

import pytest

from kagezou.errors import InputProblem, OutputProblem
from kagezou.io.files.folders import entries_to_read, entries_to_write


def refusing(_self: Path) -> Iterator[Path]:
    raise PermissionError(errno.EACCES, "Permission denied")


def test_what_lies_in_a_folder(tmp_path: Path) -> None:
    (tmp_path / "a").write_bytes(b"")
    assert entries_to_read(tmp_path) == entries_to_write(tmp_path) == [tmp_path / "a"]
    assert entries_to_write(tmp_path / "none yet") == []
    with pytest.raises(InputProblem, match="none yet: it does not exist"):
        entries_to_read(tmp_path / "none yet")


def test_one_that_is_not_opened_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Path, "iterdir", refusing)
    with pytest.raises(InputProblem, match="permission denied"):
        entries_to_read(tmp_path)
    with pytest.raises(OutputProblem, match="cannot be written: permission denied"):
        entries_to_write(tmp_path)
