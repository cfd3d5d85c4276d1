import os
import sys
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest

from kagezou.errors import InputProblem
from kagezou.io.images import cel_cache
from kagezou.io.images.cel_cache import CelCache
from kagezou.io.images.reading import Cel, Matte, read_cel, read_matte
from tests.io.files.file_times import wait_for_another_time
from tests.io.images import picture_files as files


class Reads:
    """Counts and slows the readers that the cache calls."""

    def __init__(self, patch: pytest.MonkeyPatch) -> None:
        self.paths: list[tuple[str, str]] = []
        self.gate = threading.Event()
        self.gate.set()
        self.begun = threading.Event()
        patch.setattr(cel_cache, "read_cel", self._cel)
        patch.setattr(cel_cache, "read_matte", self._matte)

    def _cel(self, path: Path) -> Cel:
        self.paths.append(("cel", path.name))
        self.begun.set()
        assert self.gate.wait(60)
        return read_cel(path)

    def _matte(self, path: Path) -> Matte:
        self.paths.append(("matte", path.name))
        self.begun.set()
        assert self.gate.wait(60)
        return read_matte(path)


@pytest.fixture
def reads(monkeypatch: pytest.MonkeyPatch) -> Reads:
    return Reads(monkeypatch)


def draw(path: Path, value: int = 100, side: int = 10) -> Path:
    files.save(path, np.full((side, side, 4), value, np.uint8))
    return path


def test_reads_once(tmp_path: Path, reads: Reads) -> None:
    cache, path = CelCache(), draw(tmp_path / "a.png")
    cel = cache.cel(path)
    assert cache.cel(path) is cel
    assert cache.matte(path) is cel.matte
    assert reads.paths == [("cel", "a.png")]
    assert cache.nbytes == cel.nbytes == 500
    cache.clear()
    assert cache.nbytes == 0
    assert cache.cel(path) is not cel


def test_a_matte_gives_way_to_its_cel(tmp_path: Path, reads: Reads) -> None:
    cache, path = CelCache(), draw(tmp_path / "a.png")
    matte = cache.matte(path)
    assert cache.matte(path) is matte
    assert cache.nbytes == 100
    cel = cache.cel(path)
    assert cache.matte(path) is cel.matte
    assert cache.nbytes == 500
    assert reads.paths == [("matte", "a.png"), ("cel", "a.png")]


def test_an_edited_file_is_read_again(tmp_path: Path, reads: Reads) -> None:
    cache, path = CelCache(), draw(tmp_path / "a.png", 100)
    assert cache.cel(path).rgba[0, 0, 0] == 100
    draw(path, 101)
    os.utime(path, ns=(1, 1))
    assert cache.cel(path).rgba[0, 0, 0] == 101
    assert cache.nbytes == 500
    assert len(reads.paths) == 2


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no time of the system's own for a change")
@pytest.mark.parametrize("is_replaced", [False, True])
def test_other_content_of_the_same_size_and_time_is_read_again(tmp_path: Path, *, is_replaced: bool) -> None:
    """Size and time of a file say what they said, and the content is another one: a copy that keeps times."""
    cache, path = CelCache(), draw(tmp_path / "a.png", 100)
    before = path.stat()
    assert cache.cel(path).rgba[0, 0, 0] == 100
    other = draw(tmp_path / "b.png", 101)
    data = other.read_bytes()
    assert len(data) == before.st_size, "otherwise this tests nothing"
    wait_for_another_time(path)
    if is_replaced:
        os.utime(other, ns=(before.st_atime_ns, before.st_mtime_ns))
        other.replace(path)
    else:
        path.write_bytes(data)
        os.utime(path, ns=(before.st_atime_ns, before.st_mtime_ns))
    assert path.stat().st_mtime_ns == before.st_mtime_ns
    assert cache.cel(path).rgba[0, 0, 0] == 101


def test_the_least_lately_used_goes_first(tmp_path: Path, reads: Reads) -> None:
    cache = CelCache(limit_bytes=1500)
    paths = [draw(tmp_path / f"{n}.png") for n in range(4)]
    for path in paths[:3]:
        cache.cel(path)
    cache.cel(paths[0])
    cache.cel(paths[3])
    assert cache.nbytes == 1500
    for n in (0, 2, 3):
        cache.cel(paths[n])
    assert len(reads.paths) == 4
    cache.cel(paths[1])
    assert len(reads.paths) == 5


def test_what_is_too_large_is_delivered_but_not_kept(tmp_path: Path, reads: Reads) -> None:
    cache = CelCache(limit_bytes=600)
    small, large = draw(tmp_path / "s.png"), draw(tmp_path / "l.png", side=20)
    cache.cel(small)
    assert cache.cel(large).rgba.shape == (20, 20, 4)
    assert cache.nbytes == 500
    cache.cel(small)
    assert len(reads.paths) == 2


def test_failures_are_forgotten(tmp_path: Path) -> None:
    cache, path = CelCache(), tmp_path / "a.png"
    for ask in (cache.cel, cache.matte):
        with pytest.raises(InputProblem, match="it does not exist"):
            ask(path)
    path.write_bytes(b"junk")
    for ask in (cache.cel, cache.matte):
        with pytest.raises(InputProblem, match="it is not PNG"):
            ask(path)
    draw(path)
    assert cache.cel(path).rgba.shape == (10, 10, 4)
    with pytest.raises(InputProblem, match="it cannot be a file name"):
        cache.cel(tmp_path / "a\0.png")


@pytest.mark.parametrize("good", [True, False])
def test_threads_wait_for_one_reading(tmp_path: Path, reads: Reads, *, good: bool) -> None:
    cache, path = CelCache(), tmp_path / "a.png"
    if good:
        draw(path)
    else:
        path.write_bytes(b"junk")
    reads.gate.clear()
    together = threading.Barrier(8, timeout=60)

    def cel() -> Cel:
        together.wait()
        return cache.cel(path)

    def matte() -> Matte:
        together.wait()
        return cache.matte(path)

    with ThreadPoolExecutor(8) as pool:
        first = pool.submit(cache.cel, path)
        assert reads.begun.wait(60)
        wholes = [pool.submit(cel) for _ in range(4)]
        mattes = [pool.submit(matte) for _ in range(3)]
        together.wait()
        reads.gate.set()
        if good:
            found = first.result()
            assert all(whole.result() is found for whole in wholes)
            assert all(each.result() is found.matte for each in mattes)
        else:
            for whole in (first, *wholes):
                with pytest.raises(InputProblem):
                    whole.result()
            for each in mattes:
                with pytest.raises(InputProblem):
                    each.result()
    if good:
        assert reads.paths == [("cel", "a.png")]


def test_many_threads_keep_the_bound(tmp_path: Path) -> None:
    cache = CelCache(limit_bytes=1700)
    paths = [draw(tmp_path / f"{n}.png", n) for n in range(8)]
    with ThreadPoolExecutor(8) as pool:
        for n, cel in enumerate(pool.map(lambda n: cache.cel(paths[n % 8]), range(400))):
            assert cel.rgba[0, 0, 0] == n % 8
        for n, matte in enumerate(pool.map(lambda n: cache.matte(paths[n % 8]), range(400))):
            assert matte.whole()[0, 0] == n % 8
    assert cache.nbytes <= 1700
