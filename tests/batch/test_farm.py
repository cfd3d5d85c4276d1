"""A batch as a job: the specification's own runner takes it, and makes the bytes of a local batch."""

import json
import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from kagezou.batch.cut import Cut
from kagezou.batch.farm import BatchJob, batch_template, write_batch_job
from kagezou.errors import UsageProblem
from kagezou.export.farm import TEMPLATE
from tests.batch.cut_folders import drawings
from tests.cli.projects import Shell

posix = pytest.mark.skipif(os.name != "posix", reason="the worker is called through a shell script")


@pytest.fixture
def worker(tmp_path: Path) -> Path:
    """The program as a worker calls it."""
    script = tmp_path / "kagezou worker"
    script.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m kagezou "$@"\n')
    script.chmod(0o755)
    return script


@pytest.fixture
def episode(tmp_path: Path) -> Path:
    for name in ("c001", "歩き 2"):
        drawings(tmp_path / "ep" / name, count=2)
    return tmp_path / "ep"


def openjd(*words: object) -> list[str]:
    return [str(Path(sys.executable).with_name("openjd")), *map(str, words)]


def pictures_below(folder: Path) -> dict[str, bytes]:
    """Return projects and frames; records and the report tell how long it took."""
    found = (path for path in sorted(folder.rglob("*")) if path.suffix in (".kage", ".png"))
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in found}


@posix
def test_two_sessions_make_the_bytes_of_a_local_batch_and_the_report(
    shell: Shell, episode: Path, worker: Path, tmp_path: Path
) -> None:
    words = ["auto", episode, "--style", "Natural"]
    job, farm = tmp_path / "job" / "template.json", tmp_path / "farm"
    assert shell(*words, "-o", farm, "--farm", tmp_path / "job", "--program", worker) == 0
    assert shell.out.strip() == str(job)
    step = json.loads(job.read_text(encoding="utf-8"))["steps"][0]
    names, places = step["parameterSpace"]["taskParameterDefinitions"]
    pairs = [{"Name": name, "Source": place} for name, place in zip(names["range"], places["range"], strict=True)]
    run = ["run", job, "-p", f"OutputDir={farm}"]
    sessions = [
        subprocess.Popen(
            openjd(*run, "--step", "Cuts", "--tasks", json.dumps([pair], ensure_ascii=False)),
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        for pair in pairs
    ]
    said = [session.communicate(timeout=120)[0] for session in sessions]
    assert [session.returncode for session in sessions] == [0, 0], said
    local = tmp_path / "near"
    for name in ("c001", "歩き 2"):
        assert shell("auto", episode / name, *words[2:], "-o", local, "--as", name) == 0
    assert pictures_below(farm) == pictures_below(local)
    assert len(pictures_below(farm)) == 2 + 2 * 2 * 2, "projects, shadows and contacts"
    last = subprocess.run(openjd(*run, "--step", "Report"), capture_output=True, text=True, check=False)
    assert last.returncode == 0, last.stdout
    page = (farm / "report.html").read_text(encoding="utf-8")
    assert all(f"<h2>{name}</h2>" in page for name in ("c001", "歩き 2"))


def test_a_task_whose_cut_fails_tells_so_and_does_not_keep_the_report_from_being_made(
    shell: Shell, tmp_path: Path
) -> None:
    (tmp_path / "c004").mkdir()
    assert shell("auto", tmp_path / "c004", "-o", tmp_path / "out", "--as", "c004", "--openjd") == 0
    assert "openjd_status: failed: " in shell.out
    assert shell("auto", "--report", "-o", tmp_path / "out", "--expect", "c004") == 8


def job_of(tmp_path: Path) -> BatchJob:
    return BatchJob((Cut("c1", tmp_path / "c1"),), tmp_path / "out", tmp_path / "t.kage", ("--export=ae",))


def test_the_bundle_passes_the_specifications_own_checks(tmp_path: Path) -> None:
    write_batch_job(job_of(tmp_path), tmp_path / "job")
    checked = subprocess.run(openjd("check", tmp_path / "job" / TEMPLATE), capture_output=True, text=True, check=False)
    assert "passes validation" in checked.stdout, checked.stdout


def test_the_template_of_the_cuts_is_a_file_of_the_job(tmp_path: Path) -> None:
    tree = batch_template(job_of(tmp_path))
    assert "--template={{Param.TemplateFile}}" in tree["steps"][0]["script"]["actions"]["onRun"]["args"]
    write_batch_job(job_of(tmp_path), tmp_path / "job")
    assets = json.loads((tmp_path / "job" / "asset_references.json").read_text(encoding="utf-8"))["assetReferences"]
    assert str(tmp_path / "t.kage") in assets["inputs"]["filenames"]


def test_what_a_job_cannot_say_is_refused(tmp_path: Path) -> None:
    job = job_of(tmp_path)
    for wrong in (
        replace(job, cuts=(Cut("c{{1}}", tmp_path),)),
        replace(job, words=("--style={{x}}",)),
        replace(job, cuts=tuple(Cut(f"c{number}", tmp_path) for number in range(1025))),
    ):
        with pytest.raises(UsageProblem):
            write_batch_job(wrong, tmp_path / "job")
    with pytest.raises(UsageProblem, match="among the cuts"):
        write_batch_job(job, job.output / "job")
    assert not (tmp_path / "job").exists()
