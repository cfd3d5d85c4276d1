"""Unsaved work put aside: it comes back as it was, and a damaged file is one sentence."""

import json
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.document.model import Canvas, Document
from kagezou.errors import OutputProblem, ProjectProblem
from kagezou.io.project.file import fingerprint, next_version
from kagezou.io.project.recovery_file import RecoveredWork, forget, keep, read_recovery_file, recovery_files_in
from tests.documents import documents

WORK = RecoveredWork(Document(Canvas(64, 48)), "walk", Path("/cuts/c012/walk.kage"), 1_790_000_000, 7)


@given(documents(), st.one_of(st.none(), st.just(Path("/cuts/影/歩き.kage"))))
def test_what_is_kept_comes_back(tmp_path_factory: pytest.TempPathFactory, document: Document, path: Path) -> None:
    file = tmp_path_factory.mktemp("kept") / "folder" / "a.keepsake"
    work = RecoveredWork(document, "無題", path, 5, 1)
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


def test_a_fingerprint_tells_contents_apart(tmp_path: Path) -> None:
    file = tmp_path / "a"
    assert fingerprint(file) == ""
    file.write_text("one")
    first = fingerprint(file)
    file.write_text("two")
    assert fingerprint(file) not in ("", first)
    file.write_text("one")
    assert fingerprint(file) == first
