"""Many cuts at once, from the command line."""

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from kagezou.batch.record import CutRecord, State, read_record
from kagezou.io.project.file import load
from tests.batch.cut_folders import drawings, picture
from tests.cli.projects import Shell
from tests.export.small_cuts import bytes_below


@pytest.fixture
def episode(tmp_path: Path) -> Path:
    """One cut that can be made, and one whose drawing is cut short."""
    folder = tmp_path / "ep"
    drawings(folder / "c001" / "A")
    broken = picture(folder / "c002" / "A" / "A1.png")
    broken.write_bytes(broken.read_bytes()[:60])
    return folder


def record_of(folder: Path) -> CutRecord:
    found = read_record(folder)
    assert found is not None
    return found


def one(shell: Shell, cut: Path, out: Path, *words: object) -> Any:
    """Make one cut in this process."""
    assert shell("auto", cut, "-o", out, "--as", cut.name, "--json", *words) == 0, shell.said
    return json.loads(shell.out)


def test_cuts_are_made_and_one_that_fails_leaves_the_others_alone(shell: Shell, episode: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    assert shell("auto", episode, "-o", out, "--style", "Simple", "--jobs", 2) == 8
    assert sorted(shell.out.splitlines()) == [str(out / "c001" / "c001.kage"), str(out / "report.html")]
    assert "c002: " in shell.said
    assert "the file is cut short" in shell.said
    assert shell.said.splitlines()[-1] == "kagezou: 1 of 2 cuts failed"
    assert len(list((out / "c001" / "A_shadow").iterdir())) == 3
    assert load(out / "c001" / "c001.kage").layers[0].name == "A"
    page = (out / "report.html").read_text(encoding="utf-8")
    assert page.index(">c002<") < page.index(">c001<"), "failed ones come first"
    assert 'href="./c001/c001.kage"' in page
    assert page.count("data:image/jpeg") == 3


def test_a_cut_that_would_come_out_the_same_is_left_alone(shell: Shell, tmp_path: Path) -> None:
    cut, out = tmp_path / "c1", tmp_path / "out"
    drawings(cut)
    assert one(shell, cut, out, "--skip-existing")["state"] == "done"
    before = bytes_below(out / "c1" / "c1_shadow")
    assert one(shell, cut, out, "--skip-existing")["state"] == "kept"
    assert one(shell, cut, out, "--skip-existing", "--style", "water")["state"] == "done", "another look"
    assert one(shell, cut, out, "--skip-existing")["state"] == "done"
    assert bytes_below(out / "c1" / "c1_shadow") == before
    picture(cut / "walk_0004.png")
    assert one(shell, cut, out, "--skip-existing")["frames"] == 4, "a drawing more"
    (out / "c1" / "c1_shadow" / "c1_shadow_0002.png").unlink()
    again = one(shell, cut, out, "--skip-existing")
    assert again["state"] == "done", "a frame that is gone is made"
    assert again["files"] == [{"kind": "shadow frames", "there": 4, "files": 4}]
    assert one(shell, cut, out)["state"] == "done", "only where that is asked for"


def test_a_project_that_was_changed_by_hand_stays(shell: Shell, tmp_path: Path) -> None:
    cut, out = tmp_path / "c1", tmp_path / "out"
    drawings(cut)
    one(shell, cut, out)
    project = out / "c1" / "c1.kage"
    shell.ok("set", project, "light.azimuth=33")
    kept = project.read_bytes()
    told = one(shell, cut, out, "--skip-existing")
    assert (told["state"], project.read_bytes()) == ("done", kept)
    assert "changed by hand" in told["notes"][0]
    assert one(shell, cut, out, "--skip-existing")["state"] == "kept"
    one(shell, cut, out, "--renew")
    assert shell.json("get", project, "light.azimuth") != 33


def test_light_and_ground_are_taken_of_a_template_and_the_look_of_a_style(shell: Shell, tmp_path: Path) -> None:
    cut, out = tmp_path / "c1", tmp_path / "out"
    drawings(cut / "A")
    template = tmp_path / "t.kage"
    assert shell("new", template, "--character", f"X={cut / 'A'}", "--no-feet") == 0
    shell.ok("set", template, "light.kind=sun", "light.azimuth=33", "layers.X.shadow.simplify=7")
    one(shell, cut, out, "--template", template)
    project = out / "c1" / "c1.kage"
    assert shell.json("get", project, "light.azimuth") == 33
    assert shell.json("get", project, "layers.A.shadow.simplify") == pytest.approx(7)
    one(shell, cut, out, "--template", template, "--ground", "--style", "Natural")
    assert shell.json("get", project, "light.azimuth") != 33
    assert shell.json("get", project, "layers.A.shadow.simplify") != pytest.approx(7)
    assert "--style or --look" in shell.fails(
        2, "auto", cut, "-o", out, "--template", template, "--look", "--style", "Natural"
    )


@pytest.mark.parametrize(
    ("kind", "files"),
    [("ae", "c1.jsx"), ("layered", "layered/layered_0001.psd"), ("frames", "A_shadow/A_shadow_0001.png")],
)
def test_each_kind_of_output(shell: Shell, tmp_path: Path, kind: str, files: str) -> None:
    drawings(tmp_path / "c1" / "A", count=1)
    told = one(shell, tmp_path / "c1", tmp_path / "out", "--export", kind)
    assert (tmp_path / "out" / "c1" / files).is_file()
    assert all(each["there"] == each["files"] for each in told["files"])


def test_what_cannot_be_is_one_sentence(shell: Shell, tmp_path: Path) -> None:
    out = tmp_path / "out"
    (tmp_path / "ep").mkdir()
    assert "there is no cut in it" in shell.fails(3, "auto", tmp_path / "ep", "-o", out)
    assert "which cuts" in shell.fails(2, "auto", "-o", out)
    drawings(tmp_path / "ep" / "c01")
    assert "did you mean" in shell.fails(2, "auto", tmp_path / "ep", "-o", out, "--style", "Simpel")
    assert "gone.kage" in shell.fails(7, "auto", tmp_path / "ep", "-o", out, "--template", tmp_path / "gone.kage")
    assert "--template" in shell.fails(2, "auto", tmp_path / "ep", "-o", out, "--light")
    out.write_text("in the way", encoding="utf-8")
    assert "a file is in the way" in shell.fails(4, "auto", tmp_path / "ep", "-o", out)
    assert "one cut" in shell.fails(2, "auto", tmp_path / "ep", tmp_path, "-o", tmp_path / "o", "--as", "x")


def test_a_file_in_the_way_of_one_cut_fails_that_cut(shell: Shell, episode: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    out.mkdir()
    (out / "c001").write_text("in the way", encoding="utf-8")
    assert shell("auto", episode / "c001", "-o", out, "--json") == 8
    (cut,) = json.loads(shell.out)["cuts"]
    assert cut["state"] == "failed"
    assert "c001" in cut["problem"]
    assert (out / "c001").read_text(encoding="utf-8") == "in the way"


def test_a_report_alone_tells_what_is_there_and_what_should_be(shell: Shell, tmp_path: Path) -> None:
    cut, out = drawings(tmp_path / "c1"), tmp_path / "out"
    one(shell, cut, out)
    assert shell("auto", "--report", "-o", out, "--language", "ja") == 0
    page = (out / "report.html").read_text(encoding="utf-8")
    assert '<html lang="ja">' in page
    assert shell("auto", "--report", "-o", out, "--expect", "c1", "--expect", "c9", "--json") == 8
    told = json.loads(shell.out)
    assert [(each["name"], each["state"]) for each in told["cuts"]] == [("c1", "done"), ("c9", "failed")]


def test_a_stop_file_stops_it_gently(tmp_path: Path) -> None:
    episode, out, progress = tmp_path / "ep", tmp_path / "out", tmp_path / "progress"
    # So many that they are not all made before it is asked, even by one who gets his turn late.
    for number in range(1, 61):
        drawings(episode / f"c{number:03}")
    words = ["auto", episode, "-o", out, "--jobs", 1, "--progress-file", progress, "--json"]
    process = subprocess.Popen(
        [sys.executable, "-m", "kagezou", *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    while not (out / "c001").is_dir():
        assert process.poll() is None
    (tmp_path / "progress.stop").touch()
    given, said = process.communicate(timeout=60)
    assert process.returncode == 130, said
    told = json.loads(given)
    assert told["code"] == 130
    states = [each["state"] for each in told["cuts"]]
    assert states[-1] == "stopped", states
    assert set(states) <= {"done", "stopped"}
    assert "--skip-existing goes on from there" in said
    assert all(
        record_of(out / f"c{place:03}").state is State.DONE for place, state in enumerate(states, 1) if state == "done"
    )
    assert (out / "report.html").is_file()


def test_each_output_is_handed_on_and_one_that_is_refused_has_failed(shell: Shell, tmp_path: Path) -> None:
    for name in ("c001", "c002"):
        drawings(tmp_path / "ep" / name)
    hook, out = tmp_path / "publish.py", tmp_path / "out"
    hook.write_text(
        "import json, pathlib, sys\n"
        "found = json.loads(pathlib.Path(sys.argv[-1]).read_text('utf-8'))\n"
        "name = pathlib.Path(found['project']['file']).stem\n"
        "sys.exit('no such shot') if name == 'c002' else print(len(found['files']), 'files of', name)\n"
    )
    words = ("auto", tmp_path / "ep", "-o", out, "--skip-existing", "--after", f"'{hook}'")
    assert shell(*words) == 8
    assert [str(note) for note in record_of(out / "c001").notes][-1] == "handed on to publish.py: 3 files of c001"
    failed = record_of(out / "c002")
    assert failed.state is State.FAILED
    assert str(failed.problem) == "the export is whole, but publish.py failed with code 1: no such shot"
    hook.write_text("import sys; print(sys.argv[-1])")
    assert shell(*words) == 0, "what was refused is handed on again, and only that"
    assert "c001" in str(record_of(out / "c001").notes[-1])
    assert record_of(out / "c002").state is State.DONE
    assert "has no end" in shell.fails(2, *words[:4], "--after", "publish 'x")
