from pathlib import Path

import pytest

from kagezou.export import ledger as ledger_module
from kagezou.export.jobs import FrameJob, OutputFile, planned
from kagezou.export.ledger import LEDGER_NAME, Ledger, content_hash, fingerprint
from kagezou.export.request import ExportRequest
from tests.export.small_cuts import cut, drawings, with_values


@pytest.fixture
def target(tmp_path: Path) -> OutputFile:
    path = tmp_path / "A_shadow" / "A_shadow_0001.png"
    path.parent.mkdir()
    path.write_bytes(b"the frame")
    return OutputFile(1, path)


def noted(folder: Path, target: OutputFile) -> Ledger:
    Ledger(folder).add(target, "made of this", content_hash(b"the frame"))
    return Ledger(folder)


def test_a_whole_frame_of_the_same_making_is_trusted(tmp_path: Path, target: OutputFile) -> None:
    assert noted(tmp_path, target).holds(target, "made of this")


def test_a_frame_of_another_making_is_not(tmp_path: Path, target: OutputFile) -> None:
    assert not noted(tmp_path, target).holds(target, "made of that")


@pytest.mark.parametrize("content", [b"", b"the fram", b"the framE"])
def test_a_frame_that_is_not_whole_is_not(tmp_path: Path, target: OutputFile, content: bytes) -> None:
    known = noted(tmp_path, target)
    target.path.write_bytes(content)
    assert not known.holds(target, "made of this")


def test_a_frame_that_is_gone_or_unknown_is_not(tmp_path: Path, target: OutputFile) -> None:
    assert not Ledger(tmp_path).holds(target, "made of this")
    known = noted(tmp_path, target)
    target.path.unlink()
    assert not known.holds(target, "made of this")


def test_torn_and_foreign_lines_count_for_nothing(tmp_path: Path, target: OutputFile) -> None:
    Ledger(tmp_path).add(target, "old", "x")
    with (tmp_path / LEDGER_NAME).open("ab") as stream:
        stream.write(b'\n["A_shadow/A_shadow_0001.png", "made\xff' + b"[" * 5000 + b'\n[1, 2]\n{}\n["A_sha')
    assert noted(tmp_path, target).holds(target, "made of this")


def test_a_ledger_full_of_old_lines_is_tidied(tmp_path: Path, target: OutputFile) -> None:
    known = Ledger(tmp_path)
    for number in range(1500):
        known.add(target, f"making {number}", content_hash(b"the frame"))
    size = (tmp_path / LEDGER_NAME).stat().st_size
    assert Ledger(tmp_path).holds(target, "making 1499")
    assert (tmp_path / LEDGER_NAME).stat().st_size < size / 100


def test_an_absurdly_large_ledger_is_not_read(
    tmp_path: Path, target: OutputFile, monkeypatch: pytest.MonkeyPatch
) -> None:
    noted(tmp_path, target)
    monkeypatch.setattr(ledger_module, "_MAX_BYTES", 10)
    assert not Ledger(tmp_path).holds(target, "made of this")


def first_job(tmp_path: Path, **values: object) -> FrameJob:
    return planned(with_values(cut(tmp_path, count=1), **values), ExportRequest(tmp_path)).jobs[0]


def test_a_fingerprint_changes_with_all_that_decides_a_frame(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    request = ExportRequest(tmp_path)
    job = first_job(tmp_path)
    same = fingerprint(job, request)
    seen = {same}
    for values in ({"light__position": [10, -20, 41]}, {"layers__A__shadow__opacity": 0.61}):
        seen.add(fingerprint(first_job(tmp_path, **values), request))
    seen.add(fingerprint(job, ExportRequest(tmp_path, depth=16)))
    seen.add(fingerprint(job, ExportRequest(tmp_path, format="tiff")))
    drawings(tmp_path / "drawings", 1)  # the same content, but written anew
    seen.add(fingerprint(job, request))
    (tmp_path / "drawings" / "a_0001.png").unlink()
    seen.add(fingerprint(job, request))
    monkeypatch.setattr(ledger_module, "_engine", lambda: "another version")
    seen.add(fingerprint(job, request))
    assert len(seen) == 8


def test_a_fingerprint_does_not_mind_where_and_by_how_many_the_work_is_done(tmp_path: Path) -> None:
    job = first_job(tmp_path)
    assert fingerprint(job, ExportRequest(tmp_path)) == fingerprint(job, ExportRequest(tmp_path / "b", workers=9))
