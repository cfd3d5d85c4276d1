import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from kagezou.document.model import Document
from kagezou.export import ledger as ledger_module
from kagezou.export.ledger import LEDGER_NAME, Ledger, content_hash, fingerprint
from kagezou.export.planning import FrameJob, planned
from kagezou.export.request import ExportRequest
from kagezou.io.project.file import load, save
from tests.export.small_cuts import cut, with_values
from tests.io.files.file_times import wait_for_another_time


@pytest.fixture
def target(tmp_path: Path) -> Path:
    path = tmp_path / "A_shadow" / "A_shadow_0001.png"
    path.parent.mkdir()
    path.write_bytes(b"the frame")
    return path


def noted(folder: Path, target: Path) -> Ledger:
    Ledger(folder).add(target, "made of this", content_hash(b"the frame"))
    return Ledger(folder)


def test_a_whole_frame_of_the_same_making_is_trusted(tmp_path: Path, target: Path) -> None:
    assert noted(tmp_path, target).holds(target, "made of this")


def test_a_frame_of_another_making_is_not(tmp_path: Path, target: Path) -> None:
    assert not noted(tmp_path, target).holds(target, "made of that")


@pytest.mark.parametrize("content", [b"", b"the fram", b"the framE"])
def test_a_frame_that_is_not_whole_is_not(tmp_path: Path, target: Path, content: bytes) -> None:
    known = noted(tmp_path, target)
    target.write_bytes(content)
    assert not known.holds(target, "made of this")


def test_a_frame_that_is_gone_or_unknown_is_not(tmp_path: Path, target: Path) -> None:
    assert not Ledger(tmp_path).holds(target, "made of this")
    known = noted(tmp_path, target)
    target.unlink()
    assert not known.holds(target, "made of this")


def test_torn_and_foreign_lines_count_for_nothing(tmp_path: Path, target: Path) -> None:
    Ledger(tmp_path).add(target, "old", "x")
    with (tmp_path / LEDGER_NAME).open("ab") as stream:
        stream.write(b'\n["A_shadow/A_shadow_0001.png", "made\xff' + b"[" * 5000 + b'\n[1, 2]\n{}\n["A_sha')
    assert noted(tmp_path, target).holds(target, "made of this")


def test_a_ledger_full_of_old_lines_is_tidied(tmp_path: Path, target: Path) -> None:
    known = Ledger(tmp_path)
    for number in range(1500):
        known.add(target, f"making {number}", content_hash(b"the frame"))
    size = (tmp_path / LEDGER_NAME).stat().st_size
    assert Ledger(tmp_path).holds(target, "making 1499")
    assert (tmp_path / LEDGER_NAME).stat().st_size < size / 100


def test_an_absurdly_large_ledger_is_not_read(tmp_path: Path, target: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    noted(tmp_path, target)
    monkeypatch.setattr(ledger_module, "_MAX_BYTES", 10)
    assert not Ledger(tmp_path).holds(target, "made of this")


def first_job(document: Document, folder: Path, **wishes: object) -> FrameJob:
    return planned(document, ExportRequest(folder, **wishes)).jobs[0]  # type: ignore[arg-type]


@pytest.fixture
def document(tmp_path: Path) -> Document:
    """A cut whose drawings are written once, so that their times tell nothing apart."""
    return cut(tmp_path, count=1)


@pytest.mark.parametrize("values", [{"light__position": [10, -20, 41]}, {"layers__A__shadow__opacity": 0.61}])
def test_a_fingerprint_changes_with_what_is_shown(
    tmp_path: Path, document: Document, values: dict[str, object]
) -> None:
    request = ExportRequest(tmp_path)
    other = first_job(with_values(document, **values), tmp_path)
    assert fingerprint(other, request) != fingerprint(first_job(document, tmp_path), request)


@pytest.mark.parametrize("wishes", [{"depth": 16}, {"format": "tiff"}])
def test_a_fingerprint_changes_with_how_it_is_written(
    tmp_path: Path, document: Document, wishes: dict[str, object]
) -> None:
    job = first_job(document, tmp_path)
    other = ExportRequest(tmp_path, **wishes)  # type: ignore[arg-type]
    assert fingerprint(job, other) != fingerprint(job, ExportRequest(tmp_path))


def test_a_fingerprint_changes_with_the_files_it_is_made_of(tmp_path: Path, document: Document) -> None:
    job, request = first_job(document, tmp_path), ExportRequest(tmp_path)
    seen = {fingerprint(job, request)}
    path = tmp_path / "drawings" / "a_0001.png"
    os.utime(path, ns=(1, 1))  # the same content, but written anew
    seen.add(fingerprint(job, request))
    path.unlink()
    seen.add(fingerprint(job, request))
    assert len(seen) == 3


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no time of the system's own for a change")
def test_a_fingerprint_changes_with_content_of_the_same_size_and_time(tmp_path: Path, document: Document) -> None:
    job, request = first_job(document, tmp_path), ExportRequest(tmp_path)
    path = tmp_path / "drawings" / "a_0001.png"
    seen, before, data = fingerprint(job, request), path.stat(), bytearray(path.read_bytes())
    data[-1] ^= 1
    wait_for_another_time(path)
    path.write_bytes(data)
    os.utime(path, ns=(before.st_atime_ns, before.st_mtime_ns))
    assert (path.stat().st_size, path.stat().st_mtime_ns) == (before.st_size, before.st_mtime_ns)
    assert fingerprint(job, request) != seen


def test_a_fingerprint_changes_with_the_program(
    tmp_path: Path, document: Document, monkeypatch: pytest.MonkeyPatch
) -> None:
    job, request = first_job(document, tmp_path), ExportRequest(tmp_path)
    before = fingerprint(job, request)
    monkeypatch.setattr(ledger_module, "engine", lambda: "another version")
    assert fingerprint(job, request) != before


def test_a_fingerprint_does_not_mind_where_and_by_how_many_the_work_is_done(tmp_path: Path, document: Document) -> None:
    job = first_job(document, tmp_path)
    assert fingerprint(job, ExportRequest(tmp_path)) == fingerprint(job, ExportRequest(tmp_path / "b", workers=9))


@pytest.mark.parametrize("wishes", [{}, {"composite": True}, {"layered": True, "format": "psd"}])
def test_equal_contents_have_one_fingerprint_wherever_they_come_from(
    tmp_path: Path, document: Document, wishes: dict[str, object]
) -> None:
    """Also on a longer cut, of which the same picture is another frame."""
    request = ExportRequest(tmp_path, **wishes)  # type: ignore[arg-type]
    jobs = planned(document, request).jobs
    longer = cut_again(document, 9, tmp_path)
    again = planned(longer, request).jobs
    assert [job.content for job in jobs] == [job.content for job in again]
    assert [len(job.targets) for job in again] == [9] * len(jobs)
    assert [fingerprint(job, request) for job in jobs] == [fingerprint(job, request) for job in again]


def cut_again(document: Document, length: int, folder: Path) -> Document:
    """Return the same cut, longer, of which nothing is the same object."""
    path = folder / "again.kage"
    save(replace(document, canvas=replace(document.canvas, length_frames=length)), path)
    return load(path)


def test_a_fingerprint_is_the_same_in_every_process() -> None:
    """Python orders sets by hashes that differ from process to process."""
    code = (
        "from pathlib import Path;"
        "from kagezou.document.edits import add_layer; from kagezou.export.ledger import fingerprint;"
        "from kagezou.export.planning import planned; from kagezou.export.request import ExportRequest;"
        "from kagezou.document.model import Canvas, Cels, Document; from kagezou.geometry.box import Box;"
        "from tests.export.small_cuts import with_values;"
        "document = Document(Canvas(8, 8));\n"
        "for name in 'ABCDEFGH': document = with_values(add_layer(document, name, Cels(), Box(0, 0, 1, 1)), "
        "**{f'layers__{name}__receives': True})\n"
        "request = ExportRequest(Path('out'), format='psd', layered=True)\n"
        "print(fingerprint(planned(document, request).jobs[0], request))"
    )
    found = {
        subprocess.run(
            [sys.executable, "-c", code],
            capture_output=True,
            text=True,
            check=True,
            cwd=Path(__file__).parents[2],
            env={**os.environ, "PYTHONHASHSEED": seed},
        ).stdout
        for seed in "123"
    }
    assert len(found) == 1
