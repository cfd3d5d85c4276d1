"""Every call of the system on a folder fails once while something is written there: one sentence, and whole files."""

import errno
import os
import shutil
import threading
from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import cycle
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from kagezou.document.model import Document
from kagezou.errors import Problem
from kagezou.export.after_effects.export import HandOffRequest, export_to_after_effects
from kagezou.export.farm import FarmRequest, write_bundle
from kagezou.export.ledger import LEDGER_NAME
from kagezou.export.request import ExportRequest
from kagezou.geometry.box import Box
from kagezou.io.images.writing import FORMATS, ShadowImage, write_shadow
from kagezou.io.project.file import save
from kagezou.io.project.recovery_file import RecoveredWork, keep
from kagezou.render.gpu.context import open_headless_context
from tests.effort import THOROUGH
from tests.export.small_cuts import cut, export, with_values

pytestmark = pytest.mark.skipif(os.name == "nt", reason="the calls of POSIX")

FAULTS = (errno.ENOSPC, errno.EIO, errno.EACCES, errno.EDQUOT)
Doing = Callable[[Path, Document], object]
"""Writes something of a document into a folder."""


class Failing:
    """Fails one of the calls that have to do with a folder.

    Parameters
    ----------
    folder
        The folder, whose files are told by their paths and descriptors.
    at
        The how manieth of them fails; 0 for none.
    code
        With which error.
    """

    def __init__(self, patch: pytest.MonkeyPatch, folder: Path, at: int = 0, code: int = 0) -> None:
        self.calls: list[str] = []
        self._folder, self._at, self._code = str(folder), at, code
        self._open: set[int] = set()
        self._lock = threading.Lock()
        for name in ("open", "write", "fsync", "close", "replace", "link", "mkdir", "unlink"):
            patch.setattr(os, name, self._wrapped(name, getattr(os, name)))

    def _wrapped(self, name: str, real: Callable[..., Any]) -> Callable[..., Any]:
        def call(first: Any, *args: Any, **kwargs: Any) -> Any:
            with self._lock:
                is_on = first in self._open if isinstance(first, int) else os.fspath(first).startswith(self._folder)
                if is_on and name != "unlink":
                    self.calls.append(name)
                fails = is_on and name != "unlink" and len(self.calls) == self._at
                if name == "close":
                    self._open.discard(first)
            if fails and name == "close":
                real(first)
            if fails:
                raise OSError(self._code, os.strerror(self._code))
            found = real(first, *args, **kwargs)
            if name == "open" and is_on:
                with self._lock:
                    self._open.add(found)
            return found

        return call


def layer(document: Document) -> ShadowImage:
    """Return a shadow of the colour of the document's."""
    alpha = np.arange(20 * 30, dtype=np.uint8).reshape(20, 30)
    red = 60 if document.layers[0].tracks else 0
    return ShadowImage(64, 48, (red, 20, 40), alpha, Box(10, 10, 40, 30))


def layered(folder: Path, document: Document) -> None:
    export(document, folder / "out", format="psd", layered=True, frames=(1,), workers=1)


def handed_off(folder: Path, document: Document) -> None:
    request = HandOffRequest(folder / "ae", "cut", workers=1)
    export_to_after_effects(document, request, open_headless_context, lambda _done, _all: None, lambda: False)


def job(folder: Path, document: Document) -> None:
    frames = document.canvas.length_frames
    write_bundle(document, FarmRequest(folder / "cut.kage", ExportRequest(folder / "out"), frames), folder / "job")


def kept(folder: Path, document: Document) -> None:
    keep(folder / "a.keepsake", RecoveredWork(document, "cut", None, 1, 1))


def shadow_as(suffix: str) -> Doing:
    return lambda folder, document: write_shadow(folder / f"a{suffix}", layer(document))


DOING: dict[str, Doing] = {
    "a project": lambda folder, document: save(document, folder / "cut.kage"),
    "what is kept of unsaved work": kept,
    "a job of a farm": job,
    **{f"a layer as {suffix}": shadow_as(suffix) for suffix in FORMATS},
    "a layered frame": layered,
    "a hand-off": handed_off,
}
FEW = ("a layered frame", "a hand-off")
"""Those that draw, and take so long that not every call is tried each time."""


def files_of(folder: Path) -> dict[str, bytes]:
    """Return the files of a folder; the ledger may know more or less of them."""
    found = (path for path in sorted(folder.rglob("*")) if path.is_file() and path.name != LEDGER_NAME)
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in found}


def tries(count: int, *, few: bool) -> Iterator[tuple[int, int]]:
    """Yield which call fails, and with what: every call with every error, or some with one."""
    if few and not THOROUGH:
        yield from zip(range(1, count + 1, max(count // 12, 1)), cycle(FAULTS), strict=False)
        return
    yield from ((at, code) for at in range(1, count + 1) for code in FAULTS)


@pytest.mark.parametrize("what", DOING)
def test_every_call_failed_once_leaves_whole_files(what: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    do = DOING[what]
    first = cut(tmp_path / "in", count=2)
    second = with_values(replace(first, canvas=replace(first.canvas, length_frames=3)), layers__A__shadow__opacity=0.5)
    work, before = tmp_path / "work", tmp_path / "before"
    work.mkdir(mode=0o700)
    do(work, first)
    shutil.copytree(work, before)
    old = files_of(work)
    with monkeypatch.context() as patch:
        failing = Failing(patch, work)
        do(work, second)
    new, count = files_of(work), len(failing.calls)
    assert count > 4
    assert new != old
    refused = 0
    for at, code in tries(count, few=what in FEW):
        shutil.rmtree(work)
        shutil.copytree(before, work)
        with monkeypatch.context() as patch:
            failing = Failing(patch, work, at, code)
            try:
                do(work, second)
                is_made = True
            except Problem as problem:
                is_made = False
                assert "\n" not in str(problem)  # noqa: PT017 - either ending is right, a third one is not
        told = f"{failing.calls[at - 1]} {at} of {count}, {errno.errorcode[code]}"
        there = files_of(work)
        refused += not is_made
        assert not [name for name in there if ".part" in name], told
        if is_made:
            assert there == new, told
        else:
            assert set(there) >= set(old), told
            assert all(data in (old.get(name), new.get(name)) for name, data in there.items()), told
    assert refused
