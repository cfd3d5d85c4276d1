"""Unsaved work put aside: it comes back as it was, and a damaged file is one sentence."""

import errno
import json
import os
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.document.model import Canvas, Document
from kagezou.errors import OutputProblem, ProjectProblem
from kagezou.io.files import atomic
from kagezou.io.project import file as project_file
from kagezou.io.project import recovery_file
from kagezou.io.project.file import next_version, save
from kagezou.io.project.file_state import NEVER_SEEN, FileState, state_of
from kagezou.io.project.recovery_file import (
    RecoveredWork,
    forget,
    keep,
    make_folder,
    read_recovery_file,
    recovery_files_in,
)
from tests.documents import documents

WORK = RecoveredWork(Document(Canvas(64, 48)), "walk", Path("/cuts/c012/walk.kage"), 1_790_000_000, 7)


@given(documents(), st.one_of(st.none(), st.just(Path("/cuts/影/歩き.kage"))))
def test_what_is_kept_comes_back(tmp_path_factory: pytest.TempPathFactory, document: Document, path: Path) -> None:
    file = tmp_path_factory.mktemp("kept") / "folder" / "a.keepsake"
    work = RecoveredWork(document, "無題", path, 5, 1, FileState(7, "abc", 1_790_000_000))
    keep(file, work)
    assert read_recovery_file(file) == work


@pytest.mark.parametrize(
    ("spoil", "said"),
    [
        (lambda raw: raw[: len(raw) // 2], "the kept work is damaged"),
        (lambda _raw: b"", "the kept work is damaged"),
        (lambda _raw: b"\xff\xfe", "the kept work is damaged"),
        (lambda raw: raw.replace(b'"edits": 7', b'"edits": -1'), "$.edits: -1 is not a whole number"),
        (lambda raw: raw.replace(b"kagezou-keepsake", b"something-else"), "$.format:"),
        (lambda raw: raw.replace(b'\\"width_px\\": 64', b'\\"width_px\\": 0'), "$.canvas.width_px: 0 is not"),
    ],
)
def test_a_damaged_keepsake_is_one_sentence(tmp_path: Path, spoil: object, said: str) -> None:
    file = tmp_path / "a.keepsake"
    keep(file, WORK)
    assert callable(spoil)
    changed = spoil(file.read_bytes())
    assert changed != file.read_bytes()
    file.write_bytes(changed)
    with pytest.raises(ProjectProblem, match=r"a\.keepsake") as caught:
        read_recovery_file(file)
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)


def test_keepsakes_are_found_and_forgotten(tmp_path: Path) -> None:
    assert recovery_files_in(tmp_path / "nowhere") == ()
    keep(tmp_path / "a.keepsake", WORK)
    (tmp_path / "a.lock").write_text("")
    assert recovery_files_in(tmp_path) == (tmp_path / "a.keepsake",)
    forget(tmp_path / "a.keepsake")
    forget(tmp_path / "a.keepsake")
    assert recovery_files_in(tmp_path) == ()
    with pytest.raises(ProjectProblem, match="it does not exist"):
        read_recovery_file(tmp_path / "a.keepsake")


def test_a_folder_that_cannot_be_made_is_said(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(OutputProblem):
        keep(tmp_path / "file" / "a.keepsake", WORK)


def test_the_text_of_a_keepsake_is_plain_json(tmp_path: Path) -> None:
    keep(tmp_path / "a.keepsake", WORK)
    tree = json.loads((tmp_path / "a.keepsake").read_text("ascii"))
    assert (tree["name"], tree["edits"], tree["kept_at"]) == ("walk", 7, 1_790_000_000)


@pytest.mark.parametrize(
    ("name", "there", "wanted"),
    [
        ("walk.kage", [], "walk_002.kage"),
        ("walk_002.kage", [], "walk_003.kage"),
        ("walk_09.kage", [], "walk_10.kage"),
        ("walk.kage", ["walk_002.kage", "walk_003.kage"], "walk_004.kage"),
        ("c012_099.kage", [], "c012_100.kage"),
    ],
)
def test_the_next_version_takes_no_name_that_is_there(tmp_path: Path, name: str, there: list[str], wanted: str) -> None:
    for each in there:
        (tmp_path / each).write_text("")
    assert next_version(tmp_path / name).name == wanted


def test_a_state_tells_contents_apart(tmp_path: Path) -> None:
    file = tmp_path / "a"
    assert state_of(file) is None
    assert state_of(Path("a\0b")) is None
    file.write_text("one")
    first = state_of(file)
    file.write_text("two")
    assert state_of(file) not in (None, first)
    file.write_text("one")
    os.utime(file, (5, 5))
    assert state_of(file) == first, "a clock alone is no change"


def test_saving_tells_what_the_file_is_like(tmp_path: Path) -> None:
    assert save(WORK.document, tmp_path / "walk.kage") == state_of(tmp_path / "walk.kage")


def test_a_keepsake_may_be_moved(tmp_path: Path) -> None:
    keep(tmp_path / "a.keepsake", WORK)
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "a.keepsake").rename(tmp_path / "elsewhere" / "a.keepsake")
    assert read_recovery_file(tmp_path / "elsewhere" / "a.keepsake") == WORK


class TestWhoWroteTheFileLast:
    def work(self, path: Path, kept_at_s: int = 0, file: FileState | None = None) -> RecoveredWork:
        return RecoveredWork(WORK.document, "walk", path, kept_at_s, 1, file)

    def test_one_that_lies_there_as_it_was_is_known(self, tmp_path: Path) -> None:
        path = tmp_path / "walk.kage"
        known = save(WORK.document, path)
        assert self.work(path, file=known).seen == known
        assert not self.work(path, file=known).is_behind

    def test_one_that_was_written_since_is_not(self, tmp_path: Path) -> None:
        path = tmp_path / "walk.kage"
        known = save(WORK.document, path)
        save(Document(Canvas(32, 32)), path)
        os.utime(path, (1, 1))
        assert self.work(path, kept_at_s=100, file=known).is_behind, "whatever its clock says"
        assert self.work(path, kept_at_s=100, file=NEVER_SEEN).is_behind

    def test_where_the_state_was_not_kept_the_clock_decides(self, tmp_path: Path) -> None:
        path = tmp_path / "walk.kage"
        known = save(WORK.document, path)
        os.utime(path, (1000, 1000))
        assert self.work(path, kept_at_s=999).is_behind
        assert self.work(path, kept_at_s=1000).seen == known

    def test_no_file_is_behind_nothing(self, tmp_path: Path) -> None:
        assert not self.work(tmp_path / "walk.kage", file=FileState(1, "a")).is_behind
        assert RecoveredWork(WORK.document, "walk", None, 0, 1).seen is None

    def test_keepsakes_of_earlier_programs_are_read(self, tmp_path: Path) -> None:
        keep(tmp_path / "a.keepsake", WORK)
        tree = json.loads((tmp_path / "a.keepsake").read_text("ascii"))
        del tree["file"], tree["folder"]
        (tmp_path / "a.keepsake").write_text(json.dumps(tree))
        assert read_recovery_file(tmp_path / "a.keepsake") == WORK


class TestReadBack:
    def test_what_reads_otherwise_is_not_kept(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        file = tmp_path / "a.keepsake"
        keep(file, WORK)
        before = file.read_bytes()
        write_bytes = Path.write_bytes
        monkeypatch.setattr(Path, "write_bytes", lambda path, data: write_bytes(path, data[:-1] + b" "))
        with pytest.raises(OutputProblem, match=r"a\.keepsake: what was written reads otherwise"):
            keep(file, replace(WORK, edits=8))
        assert file.read_bytes() == before
        assert [path.name for path in tmp_path.iterdir()] == ["a.keepsake"]

    def test_a_document_that_comes_back_as_another_is_not_kept(
        self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setattr(recovery_file, "loads", lambda _text, _folder: Document(Canvas(1, 1)))
        with pytest.raises(ProjectProblem, match="it would come back as something else"):
            keep(tmp_path / "a.keepsake", WORK)
        assert list(tmp_path.iterdir()) == []

    def test_what_no_project_can_hold_is_not_kept(self, tmp_path: Path) -> None:
        with pytest.raises(ProjectProblem, match=r"\$\.canvas\.length_frames"):
            keep(tmp_path / "a.keepsake", replace(WORK, document=Document(Canvas(64, 48, length_frames=1_000_001))))
        assert list(tmp_path.iterdir()) == []

    def test_what_is_larger_than_a_project_is_not_kept(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(project_file, "MAX_BYTES", 100)
        with pytest.raises(ProjectProblem, match="too large for a project"):
            keep(tmp_path / "a.keepsake", WORK)
        with pytest.raises(ProjectProblem, match="too large for a project"):
            save(WORK.document, tmp_path / "a.kage")

    def test_a_refused_rename_leaves_the_older_one(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        file = tmp_path / "a.keepsake"
        keep(file, WORK)

        def refuse(_temp: Path, _target: Path) -> None:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

        monkeypatch.setattr(atomic, "_replace", refuse)
        with pytest.raises(OutputProblem, match="no space left"):
            keep(file, replace(WORK, edits=8))
        assert read_recovery_file(file) == WORK


def test_what_was_half_written_is_no_keepsake(tmp_path: Path) -> None:
    (tmp_path / ".a.keepsake.1-abcd1234.part.keepsake").write_bytes(b"{")
    assert recovery_files_in(tmp_path) == ()


@pytest.mark.skipif(not hasattr(os, "getuid"), reason="Windows keeps temporary files of users apart")
def test_a_folder_of_somebody_else_among_temporary_files_is_not_used(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    open_to_all, mine = tmp_path / "tmp", os.getuid()
    open_to_all.mkdir()
    open_to_all.chmod(0o1777)
    folder = open_to_all / "kept"
    keep(folder / "a.keepsake", WORK)
    assert folder.stat().st_mode & 0o077 == 0
    monkeypatch.setattr(os, "getuid", lambda: mine + 1)
    assert recovery_files_in(folder) == ()
    with pytest.raises(OutputProblem, match="it belongs to somebody else"):
        make_folder(folder)
