"""Farm jobs: a bundle that the specification's own runner takes, and frames that do not depend on who made them."""

import json
import os
import signal
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import pytest

from kagezou.document.edits import rename_layer, set_background_cels
from kagezou.document.model import Cels, Document, Drawing, Exposure
from kagezou.document.set_pieces import add_piece
from kagezou.errors import InputProblem, UsageProblem
from kagezou.export.farm import ASSETS, PARAMETERS, TEMPLATE, FarmRequest, template, write_bundle
from kagezou.export.farm_program import program_here
from kagezou.export.file_names import FileNames
from kagezou.export.frames import export_frames
from kagezou.export.ledger import LEDGER_NAME
from kagezou.export.request import ExportRequest, Missing
from kagezou.geometry.sets.measures import PieceKind
from kagezou.io.project.file import save
from kagezou.io.project.path_mapping import Rule, mapped, read_rules, with_mapped_paths
from kagezou.render.gpu.context import open_headless_context
from tests.export.small_cuts import bytes_below, cut, export, with_key

posix = pytest.mark.skipif(os.name != "posix", reason="the worker is called through a shell script")


@pytest.fixture
def document(tmp_path: Path) -> Document:
    """24 frames with a moving light, so that every frame is another picture."""
    made = cut(tmp_path, count=6, length=24)
    made = with_key(made, "light.position", 1, [5, -20, 40])
    return with_key(made, "light.position", 24, [60, -25, 45])


@pytest.fixture
def worker(tmp_path: Path) -> Path:
    """The program as a worker calls it."""
    script = tmp_path / "kagezou worker"
    script.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m kagezou "$@"\n')
    script.chmod(0o755)
    return script


def bundle(
    document: Document,
    folder: Path,
    worker: Path | str = "kagezou",
    chunk: int = 6,
    asked: ExportRequest | None = None,
) -> tuple[Path, Path]:
    project = folder / "cut 12.kage"
    save(document, project)
    request = FarmRequest(project, asked or ExportRequest(folder / "out"), chunk, str(worker))
    write_bundle(document, request, folder / "job")
    return folder / "job" / TEMPLATE, project


def _unwatched(_done: int, _all: int) -> None:
    pass


def openjd(*words: str) -> subprocess.CompletedProcess[str]:
    command = [str(Path(sys.executable).with_name("openjd")), *words]
    return subprocess.run(command, capture_output=True, text=True, check=False, timeout=120)


def run_words(job: Path, project: Path, out: Path) -> list[str]:
    return ["run", str(job), "--step", "Render", "-p", f"ProjectFile={project}", "-p", f"OutputDir={out}"]


def test_the_bundle_passes_the_specifications_own_checks(document: Document, tmp_path: Path) -> None:
    job, _ = bundle(document, tmp_path)
    done = openjd("check", str(job))
    assert done.returncode == 0, done.stdout
    assert "passes validation" in done.stdout


def test_the_bundle_names_what_a_worker_needs(document: Document, tmp_path: Path) -> None:
    street = tuple(Drawing(name, tmp_path / name) for name in ("bg_1.png", "bg_2.png"))
    document = set_background_cels(document, Cels(street, (Exposure(1, 0), Exposure(3, 1))))
    job, project = bundle(document, tmp_path)
    assets = json.loads((job.parent / ASSETS).read_text())["assetReferences"]
    assert str(project) in assets["inputs"]["filenames"]
    assert {str(drawing.path) for drawing in street} < set(assets["inputs"]["filenames"])
    assert len(assets["inputs"]["filenames"]) == 9
    assert assets["outputs"]["directories"] == [str(tmp_path / "out")]
    values = json.loads((job.parent / PARAMETERS).read_text())["parameterValues"]
    assert {"name": "Frames", "value": "1-24"} in values


@posix
def test_two_workers_at_once_make_the_bytes_of_a_local_render(document: Document, worker: Path, tmp_path: Path) -> None:
    job, project = bundle(document, tmp_path, worker)
    export(document, tmp_path / "local")
    halves = ('[{"Frame":"1-6"},{"Frame":"7-12"}]', '[{"Frame":"13-18"},{"Frame":"19-24"}]')
    command = [str(Path(sys.executable).with_name("openjd")), *run_words(job, project, tmp_path / "farm")]
    sessions = [
        subprocess.Popen([*command, "--tasks", tasks], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        for tasks in halves
    ]
    said = [session.communicate(timeout=120)[0] for session in sessions]
    assert [session.returncode for session in sessions] == [0, 0], said
    assert "openjd_progress: 100.0" in said[0]
    assert "openjd_status: 6 of 6 files" in said[0]
    assert bytes_below(tmp_path / "farm") == bytes_below(tmp_path / "local")


@posix
@pytest.mark.parametrize(
    "asked",
    [
        ExportRequest(Path("out"), layered=True, format="psd"),
        ExportRequest(Path("out"), receivers=True, composite=True),
    ],
    ids=["layered", "with mattes and composite"],
)
def test_a_farm_makes_all_that_a_local_render_can(
    document: Document, worker: Path, tmp_path: Path, asked: ExportRequest
) -> None:
    frames = (1, 2, 3)
    here = replace(asked, folder=tmp_path / "local", frames=frames)
    export_frames(document, here, open_headless_context, lambda *_: None, lambda: False)
    job, project = bundle(document, tmp_path, worker, asked=replace(asked, folder=tmp_path / "farm", frames=frames))
    done = openjd(*run_words(job, project, tmp_path / "farm"))
    assert done.returncode == 0, done.stdout
    assert len(bytes_below(tmp_path / "local")) == 3 * (1 if asked.layered else 3)
    assert bytes_below(tmp_path / "farm") == bytes_below(tmp_path / "local")


@posix
def test_workers_hold_what_is_missing_as_the_job_says(document: Document, worker: Path, tmp_path: Path) -> None:
    document.layers[0].cels.drawings[1].path.unlink()
    asked = ExportRequest(tmp_path / "farm", frames=(1, 2, 3), missing=Missing.HOLD)
    export_frames(document, replace(asked, folder=tmp_path / "local"), open_headless_context, _unwatched, lambda: False)
    job, project = bundle(document, tmp_path, worker, asked=asked)
    done = openjd(*run_words(job, project, tmp_path / "farm"))
    assert done.returncode == 0, done.stdout
    assert "openjd_status: A: missing, so the nearest drawing is held on frames 2: a_0002.png" in done.stdout
    assert bytes_below(tmp_path / "farm") == bytes_below(tmp_path / "local")
    stopped = openjd(*run_words(job, project, tmp_path / "no"), "-p", "Missing=fail")
    assert stopped.returncode != 0
    assert "a_0002.png: the drawing is missing" in stopped.stdout


@posix
@pytest.mark.parametrize(
    ("form", "depth", "suffix"), [("exr", "auto", "exr"), ("tga", "16", "tga"), ("exr", "8", "exr")]
)
def test_the_depth_follows_the_format_that_a_job_is_sent_with(
    document: Document, worker: Path, tmp_path: Path, form: str, depth: str, suffix: str
) -> None:
    job, project = bundle(document, tmp_path, worker)
    words = [*run_words(job, project, tmp_path / "farm"), "-p", f"Format={form}", "-p", "Frames=1-2"]
    done = openjd(*words, *([] if depth == "auto" else ["-p", f"Depth={depth}"]))
    assert done.returncode == 0, done.stdout
    assert ("is written with" in done.stdout) == (depth != "auto"), "what is not used is said"
    assert sorted(bytes_below(tmp_path / "farm")) == [f"A_shadow/A_shadow_000{n}.{suffix}" for n in (1, 2)]
    refused = subprocess.run(
        [str(worker), "render", str(project), "-o", str(tmp_path / "here"), "--format", "tga", "--depth", "16"],
        capture_output=True, text=True, check=False, timeout=60,
    )  # fmt: skip
    assert refused.returncode == 2
    assert "tga frames have 8 bits a channel, not 16" in refused.stderr


def test_a_job_says_what_a_worker_must_have_and_how_long_a_task_may_take(document: Document, tmp_path: Path) -> None:
    request = FarmRequest(tmp_path / "a.kage", ExportRequest(tmp_path), 4, frame_minutes=3)
    (step,) = template(document, request)["steps"]
    action = step["script"]["actions"]["onRun"]
    assert action["timeout"] == 600 + 3 * 60 * 4
    assert action["cancelation"]["mode"] == "NOTIFY_THEN_TERMINATE"
    least = {each["name"]: each["min"] for each in step["hostRequirements"]["amounts"]}
    assert least == {"amount.worker.vcpu": 2, "amount.worker.memory": 1024}
    large = replace(document, canvas=replace(document.canvas, width_px=8000, height_px=4000))
    (step,) = template(large, request)["steps"]
    assert {each["name"]: each["min"] for each in step["hostRequirements"]["amounts"]}["amount.worker.memory"] == 2048
    shown = {
        each["name"]: each["userInterface"]["control"] for each in template(document, request)["parameterDefinitions"]
    }
    assert shown == {
        "ProjectFile": "CHOOSE_INPUT_FILE", "OutputDir": "CHOOSE_DIRECTORY", "Frames": "LINE_EDIT",
        "Format": "DROPDOWN_LIST", "Depth": "DROPDOWN_LIST", "Missing": "DROPDOWN_LIST", "Program": "LINE_EDIT",
    }  # fmt: skip
    with pytest.raises(UsageProblem, match="1 to 1440 minutes, not 0"):
        FarmRequest(tmp_path / "a.kage", ExportRequest(tmp_path), frame_minutes=0)


@posix
def test_a_depth_that_was_chosen_stays(document: Document, worker: Path, tmp_path: Path) -> None:
    asked = ExportRequest(tmp_path / "farm", depth=16, frames=(1,))
    job, project = bundle(document, tmp_path, worker, asked=asked)
    assert openjd(*run_words(job, project, tmp_path / "farm")).returncode == 0
    export(document, tmp_path / "local", depth=16, frames=(1,))
    assert bytes_below(tmp_path / "farm") == bytes_below(tmp_path / "local")


@posix
def test_a_killed_workers_task_is_taken_up_by_another(document: Document, worker: Path, tmp_path: Path) -> None:
    job, project = bundle(document, tmp_path, worker, chunk=24)
    farm = tmp_path / "farm"
    ledger = farm / LEDGER_NAME
    words = ["render", str(project), "-o", str(farm), "--frames", "1-24", "--skip-existing", "--openjd"]
    with subprocess.Popen([sys.executable, "-m", "kagezou", *words], stdout=subprocess.DEVNULL) as first:
        while first.poll() is None and (not ledger.is_file() or ledger.read_bytes().count(b"\n") < 3):
            time.sleep(0.005)
        first.send_signal(signal.SIGKILL)
    # Files whose line had not been added yet are made again; those that the ledger knows are not.
    known = [path for path in farm.glob("A_shadow/*.png") if path.name.encode() in ledger.read_bytes()]
    whole = {path: path.stat().st_mtime_ns for path in known}
    assert len(whole) >= 2
    done = openjd(*run_words(job, project, farm))
    assert done.returncode == 0, done.stdout
    export(document, tmp_path / "local")
    assert bytes_below(farm) == bytes_below(tmp_path / "local")
    assert {path: path.stat().st_mtime_ns for path in whole} == whole


@posix
def test_a_failing_frame_fails_the_task_with_its_reason(document: Document, worker: Path, tmp_path: Path) -> None:
    job, project = bundle(document, tmp_path, worker)
    document.layers[0].cels.drawings[2].path.unlink()
    done = openjd(*run_words(job, project, tmp_path / "farm"))
    assert done.returncode != 0
    assert "openjd_fail: " in done.stdout
    assert "a_0003.png" in done.stdout


@posix
def test_paths_of_another_machine_are_mapped(document: Document, worker: Path, tmp_path: Path) -> None:
    home = tmp_path / "elsewhere"
    home.mkdir()
    # From another folder the drawings are named absolutely once they lie on another root.
    job, project = bundle(document, tmp_path, worker, chunk=24)
    (tmp_path / "drawings").rename(home / "drawings")
    rules = {
        "version": "pathmapping-1.0",
        "path_mapping_rules": [
            {
                "source_path_format": "POSIX",
                "source_path": str(tmp_path / "drawings"),
                "destination_path": str(home / "drawings"),
            }
        ],
    }
    (tmp_path / "rules.json").write_text(json.dumps(rules))
    done = openjd(
        *run_words(job, project, tmp_path / "farm"), "--path-mapping-rules", f"file://{tmp_path / 'rules.json'}"
    )
    assert done.returncode == 0, done.stdout
    assert len(bytes_below(tmp_path / "farm")) == 24


def test_a_set_is_named_and_moved_with_all_its_files(document: Document, tmp_path: Path) -> None:
    street = tmp_path / "street.gltf"
    buffers = [{"byteLength": 0, "uri": "a%20b.bin"}, {"byteLength": 0, "uri": "data:,"}]
    street.write_text(json.dumps({"asset": {"version": "2.0"}, "buffers": buffers}))
    (tmp_path / "a b.bin").write_bytes(b"")
    (tmp_path / "broken.gltf").write_text("{")
    document = add_piece(document, "street", PieceKind.MESH, source=street)
    document = add_piece(document, "broken", PieceKind.MESH, source=tmp_path / "broken.gltf")
    job, _ = bundle(add_piece(document, "wall", "wall"), tmp_path)
    named = json.loads((job.parent / ASSETS).read_text())["assetReferences"]["inputs"]["filenames"]
    assert {str(street), str(tmp_path / "a b.bin"), str(tmp_path / "broken.gltf")} <= set(named)
    moved = with_mapped_paths(document, (read_source("POSIX", str(tmp_path), "/mnt/cuts"),))
    assert moved.pieces[0].source == Path("/mnt/cuts/street.gltf")


def test_rules_move_paths_of_either_system(document: Document) -> None:
    windows = read_source("WINDOWS", "Z:\\shows", "/mnt/shows")
    posix_rule = read_source("POSIX", "/home/a/cuts", "/mnt/cuts")
    assert mapped(Path("Z:\\shows\\c012\\A\\1.png"), (windows,)) == Path("/mnt/shows/c012/A/1.png")
    assert mapped(Path("z:/Shows/c012/1.png"), (windows,)) == Path("/mnt/shows/c012/1.png")
    assert mapped(Path("/home/a/cuts/1.png"), (windows, posix_rule)) == Path("/mnt/cuts/1.png")
    assert mapped(Path("/home/a/cutsB/1.png"), (posix_rule,)) == Path("/home/a/cutsB/1.png")
    assert with_mapped_paths(document, ()) is document


def read_source(kind: str, source: str, destination: str) -> Rule:
    from pathlib import PurePosixPath, PureWindowsPath

    return Rule({"WINDOWS": PureWindowsPath, "POSIX": PurePosixPath}[kind](source), Path(destination))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("{", "these are not rules of path mapping"),
        ("[]", "is not an object"),
        ('{"version": "2"}', "the key 'path_mapping_rules' is missing"),
        ('{"version": "2", "path_mapping_rules": []}', "is not one of pathmapping-1.0"),
        ('{"version": "pathmapping-1.0", "path_mapping_rules": [{}]}', "the key 'source_path_format' is missing"),
    ],
)
def test_rules_that_are_none_are_one_sentence(tmp_path: Path, text: str, said: str) -> None:
    file = tmp_path / "rules.json"
    file.write_text(text)
    with pytest.raises(InputProblem, match=r"rules\.json") as caught:
        read_rules(file)
    assert said in str(caught.value)
    file.write_text("{}")
    assert read_rules(file) == ()
    with pytest.raises(InputProblem, match="it does not exist"):
        read_rules(tmp_path / "nowhere.json")


def test_what_a_farm_cannot_have_is_refused(document: Document, tmp_path: Path) -> None:
    with pytest.raises(UsageProblem, match="1 to 10000 frames, not 0"):
        FarmRequest(tmp_path / "a.kage", ExportRequest(tmp_path), 0)
    named = rename_layer(document, "layer-1", "{{Param.X}}")
    request = FarmRequest(tmp_path / "a.kage", ExportRequest(tmp_path, layers=("{{Param.X}}",)))
    with pytest.raises(UsageProblem, match="has braces"):
        template(named, request)
    strange = FarmRequest(tmp_path / "{{x}}\n.kage", ExportRequest(tmp_path))
    assert template(document, strange)["name"] == "Kagezou __x___"


def test_a_bundle_is_never_written_among_frames(document: Document, tmp_path: Path) -> None:
    frames = tmp_path / "out"
    export(document, frames, frames=(1,))
    request = FarmRequest(tmp_path / "cut.kage", ExportRequest(tmp_path / "elsewhere"))
    before = bytes_below(frames)
    with pytest.raises(UsageProblem, match="it holds A_shadow, which is no part of a bundle"):
        write_bundle(document, request, frames)
    with pytest.raises(UsageProblem, match="the job renders there"):
        write_bundle(document, replace(request, export=ExportRequest(frames)), frames)
    assert bytes_below(frames) == before


def test_a_bundle_replaces_an_earlier_one(document: Document, tmp_path: Path) -> None:
    job, _ = bundle(document, tmp_path, chunk=6)
    job.with_name(".DS_Store").write_bytes(b"")
    bundle(document, tmp_path, chunk=3)
    assert json.loads(job.read_text())["steps"][0]["parameterSpace"]["taskParameterDefinitions"][0]["chunks"] == {
        "defaultTaskCount": 3,
        "rangeConstraint": "CONTIGUOUS",
    }


def test_files_of_a_farm_are_called_as_those_of_a_local_render(
    document: Document, worker: Path, tmp_path: Path
) -> None:
    names = FileNames("{layer}_{kind}.{frame}", 1001, 6)
    asked = ExportRequest(tmp_path / "farm", frames=(1, 2), names=names)
    job, project = bundle(document, tmp_path, worker, asked=asked)
    done = openjd(*run_words(job, project, tmp_path / "farm"))
    assert done.returncode == 0, done.stdout + done.stderr
    assert sorted(bytes_below(tmp_path / "farm")) == ["A_shadow.001001.png", "A_shadow.001002.png"]


def test_the_program_is_called_as_this_machine_finds_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    own = Path(sys.executable).with_name(f"kagezou{Path(sys.executable).suffix}")
    monkeypatch.setenv("PATH", str(tmp_path))
    assert program_here() == (str(own) if own.is_file() else "kagezou")
    name = tmp_path / own.name
    name.write_text("#!/bin/sh\n")
    name.chmod(0o755)
    assert program_here() == "kagezou"
    monkeypatch.setenv("PATH", "")
    monkeypatch.setattr(sys, "executable", str(tmp_path / "python"))
    assert program_here() == (str(name) if not own.suffix else "kagezou")
