"""What is left of a crash: one file each, of the newest few, without the name of anybody's home."""

import faulthandler
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from kagezou.io.files import crash_reports
from kagezou.io.files.crash_reports import (
    KEPT,
    LOG_NAME,
    left_by_dead,
    reports_in,
    watching_for_fatal_ends,
    write_report,
)
from kagezou.version import __version__

ENDED = """
import os, signal, sys
from pathlib import Path
from kagezou.io.files.crash_reports import watching_for_fatal_ends
def deep_inside():
    print("there", flush=True)
    sys.stdin.readline()
    os.kill(os.getpid(), int(sys.argv[2])) if sys.argv[2] != "0" else None
with watching_for_fatal_ends(["render", "walk.kage"], Path(sys.argv[1])):
    deep_inside()
"""

on_posix = pytest.mark.skipif(os.name != "posix", reason="these signals are POSIX's")


@pytest.fixture
def log(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A log with more lines than anybody wants."""
    monkeypatch.setattr(crash_reports, "log_folder", lambda: tmp_path / "log")
    path = tmp_path / "log" / LOG_NAME
    path.parent.mkdir()
    path.write_text("".join(f"line {number}\n" for number in range(1000)), encoding="utf-8")
    return path


def started(folder: Path, number: int) -> subprocess.Popen[str]:
    other = subprocess.Popen(
        [sys.executable, "-c", ENDED, str(folder), str(number)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )
    assert other.stdout is not None
    assert other.stdout.readline() == "there\n"
    return other


def test_a_report_holds_versions_what_is_known_and_the_end_of_the_log(log: Path) -> None:
    path = write_report("Traceback\nValueError: a defect", ["graphics: llvmpipe"])
    text = path.read_text(encoding="utf-8")
    assert path.parent == log.parent / "crashes"
    assert text.startswith(f"Kagezou {__version__}, Python ")
    assert "is sent nowhere" in text
    assert "graphics: llvmpipe\n\nTraceback\nValueError: a defect\n" in text
    assert text.endswith("line 999\n")
    assert "line 900\n" not in text


@pytest.mark.usefixtures("log")
def test_home_is_left_out(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Path, "home", lambda: tmp_path)
    text = write_report(f"OSError: {tmp_path}/cuts/a.png \udcff", []).read_text(encoding="utf-8")
    assert "OSError: ~/cuts/a.png" in text
    assert str(tmp_path) not in text


@pytest.mark.usefixtures("log")
def test_old_ones_go(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    clock = iter(range(1_700_000_000, 1_700_001_000, 7))
    real = time.localtime
    monkeypatch.setattr(time, "localtime", lambda _at=None: real(next(clock)))
    (tmp_path / "mine.txt").write_text("mine", encoding="utf-8")
    made = [write_report(f"number {number}", [], tmp_path) for number in range(KEPT + 3)]
    assert list(reports_in(tmp_path)) == made[::-1][:KEPT]
    assert (tmp_path / "mine.txt").exists()


def test_where_there_are_none_there_are_none(tmp_path: Path) -> None:
    assert reports_in(tmp_path / "none") == ()
    assert left_by_dead(tmp_path / "none") == ()


@on_posix
def test_a_fatal_signal_leaves_a_report_for_the_next_start(tmp_path: Path) -> None:
    with started(tmp_path, signal.SIGSEGV) as other:
        assert left_by_dead(tmp_path) == (), "it lives"
        other.communicate("\n")
    assert other.returncode == -signal.SIGSEGV
    (report,) = left_by_dead(tmp_path)
    text = report.read_text(encoding="utf-8")
    assert "called with: ['render', 'walk.kage']" in text
    assert "Segmentation fault" in text
    assert "in deep_inside" in text
    assert left_by_dead(tmp_path) == (), "it is told once"
    assert reports_in(tmp_path) == (report,)


@on_posix
@pytest.mark.parametrize("number", [0, signal.SIGKILL])
def test_what_ends_well_or_without_a_word_leaves_nothing(tmp_path: Path, number: int) -> None:
    with started(tmp_path, number) as other:
        other.communicate("\n")
    assert left_by_dead(tmp_path) == ()
    assert list(tmp_path.iterdir()) == []


def listening(*, to_all: bool) -> None:
    """Listen again as the tests themselves do, or not."""
    if to_all:
        faulthandler.enable(sys.__stderr__ or 2)


def test_who_listens_already_goes_on_listening(tmp_path: Path) -> None:
    was_enabled = faulthandler.is_enabled()
    with (tmp_path / "own").open("w") as own:
        faulthandler.enable(own)
        try:
            with watching_for_fatal_ends([], tmp_path / "crashes"):
                assert not (tmp_path / "crashes").exists()
            assert faulthandler.is_enabled()
        finally:
            faulthandler.disable()
            listening(to_all=was_enabled)


def test_a_folder_that_takes_nothing_keeps_nobody_from_work(tmp_path: Path) -> None:
    (tmp_path / "crashes").write_text("in the way", encoding="utf-8")
    was_enabled = faulthandler.is_enabled()
    faulthandler.disable()
    try:
        with watching_for_fatal_ends([], tmp_path / "crashes"):
            assert not faulthandler.is_enabled()
    finally:
        listening(to_all=was_enabled)
