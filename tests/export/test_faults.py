"""What a disk, a folder or a killed process may do to an export."""

import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest

from kagezou.document.model import Document
from kagezou.errors import DiskFullProblem, OutputProblem
from kagezou.io.project.file import load, save
from tests.export.small_cuts import bytes_below, cut, export, with_key

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="signals and limits of Unix")
KILLS = 6


class _Usage(NamedTuple):
    total: int
    used: int
    free: int


def test_a_place_that_is_a_file_is_told(tmp_path: Path) -> None:
    (tmp_path / "out").write_text("a file")
    with pytest.raises(OutputProblem, match="out"):
        export(cut(tmp_path), tmp_path / "out")


def test_a_folder_that_refuses_is_told_before_the_first_frame(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    opened = os.open

    def refusing(path: str, flags: int, mode: int = 0o777) -> int:
        if "write-test" in str(path):
            raise PermissionError(13, "Permission denied")
        return opened(path, flags, mode)

    monkeypatch.setattr(os, "open", refusing)
    with pytest.raises(OutputProblem, match=r"A_shadow.*permission denied"):
        export(cut(tmp_path), tmp_path / "out")


@pytest.fixture
def read_only(tmp_path: Path) -> Iterator[Path]:
    """A folder that holds a cut and takes nothing; for root, whom no right binds, a disk that is read-only."""
    folder = tmp_path / "read only"
    folder.mkdir()
    is_root = os.geteuid() == 0
    mount = ["mount", "-t", "tmpfs", "tmpfs", str(folder)]
    if is_root and subprocess.run(mount, capture_output=True, check=False).returncode:
        pytest.skip("a disk cannot be mounted here")
    try:
        save(cut(folder), folder / "cut.kage")
        folder.chmod(0o555)
        if is_root:
            subprocess.run(["mount", "-o", "remount,ro", str(folder)], check=True)
        yield folder
    finally:
        if is_root:
            subprocess.run(["umount", str(folder)], check=True)
        folder.chmod(0o755)


def test_a_place_that_really_takes_nothing_is_told(read_only: Path) -> None:
    project = read_only / "cut.kage"
    document, before = load(project), project.read_bytes()
    why = "(permission denied|the disk is read-only)"
    with pytest.raises(OutputProblem, match=rf"out.*{why}"):
        export(document, read_only / "out")
    with pytest.raises(OutputProblem, match=rf"cut\.kage: cannot be written: {why}"):
        save(document, project)
    assert project.read_bytes() == before
    assert sorted(path.name for path in read_only.iterdir()) == ["cut.kage", "drawings"]


def test_a_disk_that_cannot_hold_the_frames_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shutil, "disk_usage", lambda _path: _Usage(100, 90, 10))
    with pytest.raises(DiskFullProblem, match="6 files need at least"):
        export(cut(tmp_path), tmp_path / "out")


def moving(folder: Path) -> Document:
    """Return a cut of 40 different frames, saved as a project."""
    document = with_key(cut(folder, count=4, length=40), "light.position", 1, [10, -20, 40])
    document = with_key(document, "light.position", 40, [55, -25, 60])
    save(document, folder / "cut.kage")
    return document


def render(folder: Path, *more: str) -> list[str]:
    return [sys.executable, "-m", "kagezou", "render", str(folder / "cut.kage"), "-o", str(folder / "out"), *more]


def wait_for_frames(folder: Path, count: int, process: "subprocess.Popen[str] | subprocess.Popen[bytes]") -> None:
    """Wait until so many frames are there, or nobody is left who could make them."""
    while len(list((folder / "out").rglob("*_shadow_*.png"))) < count and process.poll() is None:
        time.sleep(0.001)


def test_killed_again_and_again_it_comes_to_the_same_bytes(tmp_path: Path) -> None:
    document = moving(tmp_path)
    export(document, tmp_path / "whole")
    whole = bytes_below(tmp_path / "whole")
    for round_ in range(KILLS):
        command = render(tmp_path, "--skip-existing", "--workers", "2")
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        wait_for_frames(tmp_path, 1 + round_ * 6, process)
        process.send_signal(signal.SIGKILL)
        process.wait()
        assert bytes_below(tmp_path / "out").items() <= whole.items()
    done = subprocess.run(render(tmp_path, "--skip-existing"), capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    assert bytes_below(tmp_path / "out") == whole


@pytest.mark.parametrize(("number", "code"), [(signal.SIGINT, 130), (signal.SIGTERM, 143)])
def test_ctrl_c_leaves_only_whole_frames_and_says_so(tmp_path: Path, number: signal.Signals, code: int) -> None:
    document = moving(tmp_path)
    export(document, tmp_path / "whole")
    process = subprocess.Popen(render(tmp_path), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    wait_for_frames(tmp_path, 3, process)
    process.send_signal(number)
    _, said = process.communicate(timeout=120)
    if process.returncode == 0:
        pytest.skip("it was faster than the signal")
    assert process.returncode == code
    assert said.startswith("kagezou: stopped after ")
    assert said.count("\n") == 1
    assert not [path for path in (tmp_path / "out").rglob("*") if ".part" in path.name]
    assert bytes_below(tmp_path / "out").items() <= bytes_below(tmp_path / "whole").items()


def test_two_programs_may_share_a_folder(tmp_path: Path) -> None:
    document = moving(tmp_path)
    export(document, tmp_path / "whole")
    both = [subprocess.Popen(render(tmp_path), stdout=subprocess.DEVNULL) for _ in range(2)]
    assert [process.wait(60) for process in both] == [0, 0]
    assert bytes_below(tmp_path / "out") == bytes_below(tmp_path / "whole")


def test_a_file_size_limit_is_a_full_disk(tmp_path: Path) -> None:
    moving(tmp_path)
    limited = "import resource, signal, sys; signal.signal(signal.SIGXFSZ, signal.SIG_IGN);"
    limited += "resource.setrlimit(resource.RLIMIT_FSIZE, (200, 200));"
    limited += "from kagezou.__main__ import main; sys.exit(main(sys.argv[1:]))"
    command = [sys.executable, "-c", limited, *render(tmp_path)[3:]]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 5
    assert done.stderr.startswith("kagezou: ")
    assert "size limit" in done.stderr
    assert bytes_below(tmp_path / "out") == {}


@pytest.fixture
def tiny_disk(tmp_path: Path) -> Iterator[Path]:
    """A disk of 64 kB; only root can make one."""
    place = tmp_path / "tiny"
    place.mkdir()
    mounted = subprocess.run(
        ["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", str(place)], capture_output=True, check=False
    )
    if mounted.returncode:
        pytest.skip("a small disk cannot be mounted here")
    yield place
    subprocess.run(["umount", str(place)], check=True)


def test_a_disk_that_fills_up_keeps_whole_frames(tmp_path: Path, tiny_disk: Path) -> None:
    document = moving(tmp_path)
    export(document, tmp_path / "whole", format="tga")
    (tiny_disk / "filler").write_bytes(b"x" * 40_000)
    with pytest.raises(DiskFullProblem):
        export(document, tiny_disk / "out", format="tga")
    some, whole = bytes_below(tiny_disk / "out"), bytes_below(tmp_path / "whole")
    assert some.items() <= whole.items()
    (tiny_disk / "filler").unlink()
    assert not [path for path in (tiny_disk / "out").rglob("*") if ".part" in path.name]
