"""What a manifest says of exports of every kind, held against the files."""

import hashlib
import json
from pathlib import Path
from typing import Any

import pytest

from kagezou.document.model import Document
from kagezou.errors import OutputProblem
from kagezou.export.after.manifest import Handover, manifest_of
from kagezou.export.choices import ExportChoices, Place
from kagezou.export.exporters.table import EXPORTERS, exporter_of, sound
from kagezou.export.made_files import MadeFile, numbered_from
from kagezou.io.images.video import is_there
from kagezou.io.project.file import load, save
from kagezou.render.gpu.context import open_headless_context
from kagezou.version import __version__
from tests.export.small_cuts import cut


def manifest(document: Document, project: Path, folder: Path, **wishes: object) -> dict[str, Any]:
    """Export, and return the manifest as a program reads it."""
    choices = sound(ExportChoices(**wishes))  # type: ignore[arg-type]
    exporter, place = exporter_of(choices), Place(folder, project, project.stem)
    came = exporter.work(document, choices, place)(open_headless_context, lambda _done, _all: None, lambda: False)
    over = Handover(exporter.key, document, project, came.made, came.is_whole, came.notes)
    found: dict[str, Any] = json.loads(json.dumps(manifest_of(over)))
    assert len(found["files"]) == came.files
    return found


@pytest.fixture
def project(tmp_path: Path) -> Path:
    path = tmp_path / "walk.kage"
    save(cut(tmp_path, 3, length=4), path)
    return path


@pytest.mark.parametrize("kind", [each.key for each in EXPORTERS])
def test_every_file_of_every_kind_is_listed_with_its_hash(kind: str, project: Path, tmp_path: Path) -> None:
    if kind == "video" and not is_there():
        pytest.skip("PyAV is not installed")
    folder = tmp_path / "out"
    found = manifest(load(project), project, folder, kind=kind, mattes=("core",))
    listed = {Path(each["path"]): each for each in found["files"]}
    assert len(listed) == len(found["files"])
    there = {path for path in folder.rglob("*") if path.is_file() and not path.name.startswith(".")}
    assert set(listed) == there
    for path, each in listed.items():
        assert each["sha256"] == hashlib.sha256(path.read_bytes()).hexdigest()
        assert each["bytes"] == path.stat().st_size


def test_what_files_show_and_of_whom(project: Path, tmp_path: Path) -> None:
    found = manifest(load(project), project, tmp_path / "out", composite=True)
    first, *_ = (each for each in found["files"] if each["kind"] == "shadow")
    assert (first["sequence"], first["layer"], first["frame"], first["new"]) == ("A_shadow", "A", 1, True)
    assert {(each["kind"], each["layer"]) for each in found["files"]} == {("shadow", "A"), ("composite", None)}
    assert sorted(each["frame"] for each in found["files"] if each["kind"] == "composite") == [1, 2, 3, 4]


def test_hashes_of_files_that_were_there_come_from_the_ledger(project: Path, tmp_path: Path) -> None:
    first = manifest(load(project), project, tmp_path / "out")
    again = manifest(load(project), project, tmp_path / "out")
    assert {each["new"] for each in again["files"]} == {False}
    assert [each["sha256"] for each in again["files"]] == [each["sha256"] for each in first["files"]]


def test_what_it_was_made_from(project: Path, tmp_path: Path) -> None:
    found = manifest(load(project), project, tmp_path / "out")
    assert found["kagezou_manifest"] == 1
    assert found["program"]["version"] == __version__
    assert found["project"]["file"] == str(project)
    assert found["project"]["sha256"] == hashlib.sha256(project.read_bytes()).hexdigest()
    assert (found["project"]["frames"], found["project"]["frame_rate"]) == (4, "24")
    drawing = found["drawings"][0]
    assert (drawing["kind"], drawing["layer"], drawing["name"], drawing["part"]) == ("drawing", "A", "1", None)
    assert drawing["bytes"] == Path(drawing["path"]).stat().st_size


def test_a_project_that_was_never_saved_and_a_file_that_went(tmp_path: Path) -> None:
    document = cut(tmp_path, 1)
    over = Handover("layers", document, None, (MadeFile(tmp_path / "gone.png", "shadow"),), is_whole=True)
    with pytest.raises(OutputProblem, match=r"gone\.png"):
        manifest_of(over)
    document.layers[0].cels.drawings[0].path.unlink()
    found: Any = manifest_of(Handover("layers", document, None, (), is_whole=True))
    assert (found["project"]["file"], found["project"]["sha256"]) == (None, None)
    assert found["drawings"][0]["bytes"] is None


def test_numbered_files() -> None:
    first = Path("/a/A_0009.png")
    assert [each.name for each in numbered_from(first, 2)] == ["A_0009.png", "A_0010.png"]
    assert list(numbered_from(Path("/a/back.png"), 1)) == [Path("/a/back.png")]
