import contextlib
import errno
import hashlib
import os
import random
import stat
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from kagezou.errors import DiskFullProblem, OutputProblem
from kagezou.io.files.atomic import check_writable, let_go_of_link, replace_by, sweep_stale, write_bytes

OLD, NEW = b"old " * 50, b"new" * 70_000
FAULTS = (errno.ENOSPC, errno.EIO, errno.EACCES)
posix_only = pytest.mark.skipif(os.name == "nt", reason="POSIX calls and limits")


class Injector:
    """Fails the ``k``-th of all calls of the patched functions; ``calls`` counts them."""

    def __init__(self, patch: pytest.MonkeyPatch, k: int, code: int, names: tuple[str, ...]) -> None:
        self.calls = 0
        self.failed = ""
        self._k, self._code = k, code
        for name in names:
            patch.setattr(os, name, self._wrapped(name, getattr(os, name)))

    def _wrapped(self, name: str, real: Callable[..., Any]) -> Callable[..., Any]:
        def call(*args: object, **kwargs: object) -> object:
            self.calls += 1
            if self.calls == self._k:
                self.failed = name
                raise OSError(self._code, os.strerror(self._code))
            if name == "write":  # a short count now and then
                descriptor, data = args
                assert isinstance(data, memoryview)
                return real(descriptor, data[: max(len(data) // 2, 1)])
            return real(*args, **kwargs)

        return call


def save_keeping(path: Path) -> None:
    write_bytes(path, NEW, keep_previous=True)


def save_plainly(path: Path) -> None:
    write_bytes(path, NEW)


def save_by_path(path: Path) -> None:
    replace_by(path, lambda temp: write_to(temp, NEW))


def write_to(temp: Path, data: bytes) -> None:
    assert temp.read_bytes() == b""
    temp.write_bytes(data)


@pytest.mark.parametrize("code", FAULTS)
@pytest.mark.parametrize("save", [save_plainly, save_keeping, save_by_path])
@pytest.mark.parametrize("existed", [True, False])
def test_every_call_failed_once_leaves_old_or_new(
    tmp_path: Path, save: Callable[[Path], None], code: int, *, existed: bool
) -> None:
    seen = set()
    for k in range(1, 200):
        path = tmp_path / f"{k}" / "p.kage"
        path.parent.mkdir()
        if existed:
            path.write_bytes(OLD)
        raised = None
        with pytest.MonkeyPatch.context() as patch:
            injector = Injector(patch, k, code, ("open", "write", "fsync", "replace", "link"))
            try:
                save(path)
            except OutputProblem as problem:
                raised = problem
        if not injector.failed:
            assert path.read_bytes() == NEW
            break
        seen.add(injector.failed)
        content = path.read_bytes() if path.exists() else None
        assert content in (NEW, OLD if existed else None)
        assert raised is not None or content == NEW
        if raised is not None:
            assert str(path) in str(raised)
            assert "\n" not in str(raised)
            assert isinstance(raised, DiskFullProblem) == (code == errno.ENOSPC)
        assert {entry.name for entry in path.parent.iterdir()} <= {"p.kage", "p.kage~"}
        save(path)
        assert path.read_bytes() == NEW
        assert {entry.name for entry in path.parent.iterdir()} <= {"p.kage", "p.kage~"}
    else:
        pytest.fail("never got through")
    assert seen >= {"open", "fsync", "replace"}


@pytest.mark.parametrize("save", [save_plainly, save_keeping, save_by_path])
def test_the_content_is_on_the_disk_before_it_takes_the_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, save: Callable[[Path], None]
) -> None:
    """A system that fails between the two would leave an empty file of the right name."""
    path = tmp_path / "p.kage"
    path.write_bytes(OLD)
    on_disk: dict[int, int] = {}
    named: list[tuple[bool, bool]] = []
    real_sync, real_replace = os.fsync, os.replace

    def sync(descriptor: int) -> None:
        real_sync(descriptor)
        state = os.fstat(descriptor)
        on_disk[state.st_ino] = state.st_size

    def replace(source: Path, target: Path) -> None:
        state = Path(source).stat()
        is_new = Path(target) == path
        named.append((is_new, on_disk.get(state.st_ino) == state.st_size == len(NEW)))
        real_replace(source, target)

    monkeypatch.setattr(os, "fsync", sync)
    monkeypatch.setattr(os, "replace", replace)
    save(path)
    assert path.read_bytes() == NEW
    assert [is_safe for is_new, is_safe in named if is_new] == [True]
    if os.name != "nt":
        assert tmp_path.stat().st_ino in on_disk


def test_keeps_the_previous_file(tmp_path: Path) -> None:
    path = tmp_path / "p.kage"
    write_bytes(path, b"1", keep_previous=True)
    assert [entry.name for entry in tmp_path.iterdir()] == ["p.kage"]
    write_bytes(path, b"2", keep_previous=True)
    write_bytes(path, b"3", keep_previous=True)
    assert (path.read_bytes(), (tmp_path / "p.kage~").read_bytes()) == (b"3", b"2")
    assert len(list(tmp_path.iterdir())) == 2


def test_keeps_the_previous_file_where_links_are_not_to_be_had(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object, **__: object) -> None:
        raise OSError(errno.EPERM, "no links here")

    monkeypatch.setattr(os, "link", refuse)
    path = tmp_path / "p.kage"
    path.write_bytes(b"1")
    write_bytes(path, b"2", keep_previous=True)
    assert (path.read_bytes(), (tmp_path / "p.kage~").read_bytes()) == (b"2", b"1")


@pytest.mark.parametrize(
    "data",
    [b"", b"abc", memoryview(b"abc"), np.arange(12, dtype=np.uint16).reshape(3, 4).data],
    ids=["empty", "bytes", "view", "array"],
)
def test_writes_any_bytes(tmp_path: Path, data: bytes | memoryview) -> None:
    path = tmp_path / "影 é.png"
    write_bytes(path, data)
    assert path.read_bytes() == bytes(data)


@posix_only
def test_keeps_the_mode_and_follows_links(tmp_path: Path) -> None:
    real = tmp_path / "real"
    real.write_bytes(OLD)
    real.chmod(0o640)
    link = tmp_path / "link"
    link.symlink_to(real)
    write_bytes(link, NEW)
    assert link.is_symlink()
    assert real.read_bytes() == NEW
    assert stat.S_IMODE(real.stat().st_mode) == 0o640


def test_a_locked_file_stays(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "p.kage"
    path.write_bytes(OLD)
    monkeypatch.setattr(os, "access", lambda *_: False)
    with pytest.raises(OutputProblem, match="permission denied"):
        write_bytes(path, NEW)
    assert path.read_bytes() == OLD


def test_says_what_is_wrong_with_the_place(tmp_path: Path) -> None:
    with pytest.raises(OutputProblem, match="its folder does not exist"):
        write_bytes(tmp_path / "none" / "p.kage", NEW)
    (tmp_path / "folder").mkdir()
    with pytest.raises(OutputProblem, match="folder: cannot be written: it is a folder"):
        write_bytes(tmp_path / "folder", NEW)
    (tmp_path / "file").write_bytes(b"")
    with pytest.raises(OutputProblem, match="a part of its path is not a folder"):
        write_bytes(tmp_path / "file" / "p.kage", NEW)
    assert sorted(entry.name for entry in tmp_path.iterdir()) == ["file", "folder"]


def test_the_longest_name_fits(tmp_path: Path) -> None:
    path = tmp_path / ("影" * 80 + ".png")
    write_bytes(path, NEW)
    replace_by(path, lambda temp: write_to(temp, NEW))
    assert path.read_bytes() == NEW


def test_the_writer_gets_the_right_suffix_and_may_fail(tmp_path: Path) -> None:
    path = tmp_path / "a.exr"
    path.write_bytes(OLD)
    suffixes = []

    def write(temp: Path) -> None:
        suffixes.append(temp.suffix)
        temp.write_bytes(NEW)
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        replace_by(path, write)
    assert suffixes == [".exr"]
    assert [(entry.name, entry.read_bytes()) for entry in tmp_path.iterdir()] == [("a.exr", OLD)]


class SharingViolation(PermissionError):
    winerror = 32


@pytest.mark.parametrize("times", [0, 3, 99])
def test_a_busy_windows_file_is_tried_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, times: int) -> None:
    real, pauses, calls = os.replace, list[float](), 0

    def replace(source: str, target: str) -> None:
        nonlocal calls
        calls += 1
        if calls <= times:
            raise SharingViolation(errno.EACCES, "in use")
        real(source, target)

    monkeypatch.setattr(os, "replace", replace)
    monkeypatch.setattr(time, "sleep", pauses.append)
    path = tmp_path / "p.kage"
    path.write_bytes(OLD)
    with pytest.raises(OutputProblem) if times > 10 else contextlib.nullcontext():
        write_bytes(path, NEW)
    assert path.read_bytes() == (OLD if times > 10 else NEW)
    assert len(pauses) == min(times, 7)
    assert all(0.01 <= pause <= 1.0 for pause in pauses)
    assert len(list(tmp_path.iterdir())) == 1


def test_sweeps_only_its_own_old_parts(tmp_path: Path) -> None:
    old_s = time.time() - 7200
    stale = [".a.png.123-0123abcd.part", ".a.exr.123-0123abcd.part.exr"]
    kept = ["a.png", ".hidden", ".a.part", ".a.png.x-0123abcd.part", "a.png.123-0123abcd.part"]
    for name in stale + kept:
        (tmp_path / name).write_bytes(b"")
        os.utime(tmp_path / name, (old_s, old_s))
    fresh = tmp_path / ".b.png.123-0123abcd.part"
    fresh.write_bytes(b"")
    folder = tmp_path / ".c.png.123-0123abcd.part"
    folder.mkdir()
    os.utime(folder, (old_s, old_s))
    assert sweep_stale(tmp_path) == 2
    assert {entry.name for entry in tmp_path.iterdir()} == {*kept, fresh.name, folder.name}
    assert sweep_stale(tmp_path / "none") == 0


LIMITED = """
import resource, sys
from pathlib import Path
from kagezou.errors import DiskFullProblem
from kagezou.io.files.atomic import write_bytes
resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))
try:
    write_bytes(Path(sys.argv[1]), bytes(200_000))
except DiskFullProblem as problem:
    print(problem)
"""


@posix_only
def test_a_real_size_limit_keeps_the_old_file(tmp_path: Path) -> None:
    path = tmp_path / "p.kage"
    path.write_bytes(OLD)
    done = subprocess.run([sys.executable, "-c", LIMITED, str(path)], capture_output=True, text=True, check=True)
    assert done.stdout == f"{path}: cannot be written: it would exceed the file size limit\n"
    assert [(entry.name, entry.read_bytes()) for entry in tmp_path.iterdir()] == [("p.kage", OLD)]


SAVING = """
import hashlib, sys
from pathlib import Path
from kagezou.io.files.atomic import write_bytes
path = Path(sys.argv[1])
for turn in range(1_000_000):
    body = str(turn).encode() * 40_000
    write_bytes(path, hashlib.sha256(body).digest() + body, keep_previous=turn % 2 == 0)
    if turn == 1:
        print("saving", flush=True)
"""


@contextlib.contextmanager
def saving(path: Path) -> Iterator["subprocess.Popen[str]"]:
    process = subprocess.Popen([sys.executable, "-c", SAVING, str(path)], stdout=subprocess.PIPE, text=True)
    try:
        yield process
    finally:
        process.kill()
        process.communicate()


@posix_only
def test_killed_at_any_moment_the_file_is_whole(tmp_path: Path) -> None:
    path = tmp_path / "p.kage"
    moments = random.Random(6)
    for _ in range(20):
        with saving(path) as process:
            assert process.stdout is not None
            assert process.stdout.readline() == "saving\n"
            time.sleep(moments.uniform(0, 0.02))
        for name in ("p.kage", "p.kage~"):
            content = (tmp_path / name).read_bytes()
            assert hashlib.sha256(content[32:]).digest() == content[:32]


@posix_only
def test_a_folder_is_tried_without_following_any_link(tmp_path: Path) -> None:
    precious = tmp_path / "precious"
    precious.write_bytes(OLD)
    folder = tmp_path / "out"
    folder.mkdir()
    for name in (".kagezou-write-test-out", "write-test", ".write-test"):
        (folder / name).symlink_to(precious)
    before = sorted(folder.iterdir())
    check_writable(folder)
    assert sorted(folder.iterdir()) == before
    assert precious.read_bytes() == OLD
    with pytest.raises(OutputProblem):
        check_writable(tmp_path / "nowhere")


@posix_only
def test_a_link_is_let_go_and_a_file_is_not(tmp_path: Path) -> None:
    kept, link, gone = tmp_path / "kept", tmp_path / "link", tmp_path / "gone"
    kept.write_bytes(OLD)
    link.symlink_to(kept)
    gone.symlink_to(tmp_path / "nowhere")
    for path in (kept, link, gone, tmp_path / "nothing"):
        let_go_of_link(path)
    assert [path.name for path in tmp_path.iterdir()] == ["kept"]
    assert kept.read_bytes() == OLD
