"""render, demo, bench and doctor as a person or a farm calls them."""

import io
import json
import subprocess
import sys
from itertools import pairwise
from pathlib import Path

import pytest
from PIL import Image

from kagezou import __main__
from kagezou.cli import examination
from kagezou.cli.bench import operations, throughput
from kagezou.cli.bench.hills import write_hills
from kagezou.cli.demo import pose, stage
from kagezou.cli.demo.figure import drawn
from kagezou.cli.demo.scenery import painted
from kagezou.cli.terminal import Json
from kagezou.cli.verbs import demo, doctor
from kagezou.errors import GraphicsProblem
from kagezou.io.images.reading import read_cel
from kagezou.message import Message
from kagezou.render.gpu.context import GraphicsContext
from tests.batch.cut_folders import timesheet
from tests.cli.projects import Shell, make_drawings


def test_render_prints_its_folders(shell: Shell, project: Path) -> None:
    out = project.parent / "out"
    assert shell.ok("render", project, "-o", out, "--composite") == f"{out / 'Hero_shadow'}\n{out / 'composite'}\n"
    assert len(list((out / "composite").glob("composite_000?.png"))) == 3


def test_render_as_one_object(shell: Shell, project: Path) -> None:
    out = project.parent / "out"
    words = ["render", project, "-o", out, "--frames", "2-3", "--layer", "Hero", "--format", "exr", "--json"]
    report = shell.json(*words)
    assert (report["files"], report["written"], report["trusted"], report["whole"]) == (2, 2, 0, True)
    assert report["folders"] == [str(out / "Hero_shadow")]
    assert report["names"] == {"Hero": "Hero"}
    assert shell.json(*words, "--skip-existing")["trusted"] == 2


def test_render_draws_guides_into_composites(shell: Shell, project: Path) -> None:
    assert shell("piece", project, "add", "back", "wall") == 0
    words = ["render", project, "--composite", "--frames", "1", "-o"]
    shell.ok(*words, project.parent / "plain")
    shell.ok(*words, project.parent / "guided", "--guides")
    plain, guided = (project.parent / each / "composite" / "composite_0001.png" for each in ("plain", "guided"))
    assert plain.read_bytes() != guided.read_bytes()
    assert "composites" in shell.fails(2, "render", project, "-o", project.parent / "no", "--guides")


def test_render_names_every_missing_drawing(shell: Shell, project: Path) -> None:
    for number in (1, 3):
        (project.parent / "hero" / f"walk_000{number}.png").unlink()
    said = shell.fails(3, "render", project, "-o", project.parent / "out")
    assert said.startswith("2 drawings are missing: ")


@pytest.mark.parametrize(("way", "words"), [("empty", "left empty"), ("hold", "the nearest drawing is held")])
def test_what_stands_in_for_a_missing_drawing_is_said(shell: Shell, project: Path, way: str, words: str) -> None:
    (project.parent / "hero" / "walk_0002.png").unlink()
    call = ["render", project, "-o", project.parent / "out", "--missing", way]
    told = f"Hero: missing, so {words} on frames 2: walk_0002.png"
    assert shell(*call) == 0
    assert shell.said == f"kagezou: note: {told}\n"
    assert shell(*call, "--json") == 0
    assert json.loads(shell.out)["notes"] == [told]
    assert shell(*call, "--openjd") == 0
    assert f"openjd_status: {told}\n" in shell.out


def test_what_of_the_drawings_is_not_used_is_said_again_when_they_are_rendered(shell: Shell, project: Path) -> None:
    """The matrix of kinds of files: whoever renders was not there when the drawings were brought in."""
    for number in (2, 3):
        path = project.parent / "hero" / f"walk_000{number}.png"
        with Image.open(path) as picture:
            film = [picture.copy(), picture.transpose(Image.Transpose.FLIP_LEFT_RIGHT)]
        film[0].save(path, save_all=True, append_images=film[1:])
    out = project.parent / "out"
    told = "Hero: of its 2 pictures the first alone is used, in 2 of 3 files, first in "
    assert shell("render", project, "-o", out) == 0
    assert shell.said.count(told) == 1
    assert shell("render", project, "-o", out, "--json", "--frames", "1-2") == 0
    assert "of its 2 pictures the first alone is used" in json.loads(shell.out)["notes"][0]
    assert shell.json("render", project, "-o", out, "--json", "--frames", "1")["notes"] == []
    assert shell.json("render", project, "-o", out, "--json", "--skip-existing")["notes"] == []


def test_drawings_of_other_sizes_are_said_again_when_they_are_rendered(shell: Shell, project: Path) -> None:
    path = project.parent / "hero" / "walk_0003.png"
    with Image.open(path) as picture:
        picture.crop((0, 0, picture.width + 8, picture.height)).save(path)
    out = project.parent / "out"
    assert shell("render", project, "-o", out) == 0
    assert shell.said.count("Hero: drawings differ in size, first ") == 1
    assert "walk_0003.png" in shell.said
    assert shell.json("render", project, "-o", out, "--json", "--frames", "1-2")["notes"] == []


def test_parts_that_are_placed_each_by_itself_may_differ_in_size(shell: Shell, project: Path) -> None:
    path = project.parent / "hero" / "walk_0003.png"
    with Image.open(path) as picture:
        picture.crop((0, 0, picture.width + 8, picture.height)).save(path)
    for frame, place in ((1, "10,10"), (3, "14,10")):
        assert shell("set", project, f"layers.Hero.position={place}", "--frame", frame) == 0
    assert shell.json("render", project, "-o", project.parent / "out", "--json")["notes"] == []


def test_render_that_keeps_going_says_what_failed(shell: Shell, project: Path) -> None:
    (project.parent / "hero" / "walk_0002.png").write_bytes(b"no picture")
    assert shell("render", project, "-o", project.parent / "out", "--keep-going", "--json") == 8
    report = json.loads(shell.out)
    assert [each["frames"] for each in report["failed"]] == [[2]]
    first, last = shell.said.splitlines()
    assert first.startswith("kagezou: frame 2: ")
    assert last == "kagezou: 1 of 3 frames failed"


def test_render_tells_the_names_that_files_carry(shell: Shell, tmp_path: Path) -> None:
    drawings = make_drawings(tmp_path / "d", 1)
    assert shell("new", tmp_path / "p.kage", "--character", f"a/b={drawings}", "--fps", "12") == 0
    assert shell("render", tmp_path / "p.kage", "-o", tmp_path / "out", "--frames", "1") == 0
    assert shell.said == "kagezou: note: layer 'a/b' is written as 'a_b', which every system accepts\n"


WATCHED = """
import importlib.machinery, threading
from kagezou.render.gpu import context

is_loading = threading.Event()
create, load = importlib.machinery.ExtensionFileLoader.create_module, context.loading_driver

def watched_create(loader, spec):
    if is_loading.is_set() and threading.current_thread() is threading.main_thread():
        print("waits:", spec.name, flush=True)
    return create(loader, spec)

def watched_load():
    is_loading.set()
    print("the driver begins", flush=True)
    return load()

importlib.machinery.ExtensionFileLoader.create_module = watched_create
context.loading_driver = watched_load
from kagezou.__main__ import program
program()
"""


@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere the driver is the window system's")
def test_nobody_waits_while_the_driver_loads_its_libraries(project: Path, tmp_path: Path) -> None:
    """A system loads one library at a time: what is wanted for a frame is there before the driver begins."""
    words = ["render", str(project), "-o", str(tmp_path / "out"), "--frames", "1"]
    done = subprocess.run([sys.executable, "-c", WATCHED, *words], capture_output=True, text=True, check=True)
    assert done.stdout.splitlines() == ["the driver begins", str(tmp_path / "out" / "Hero_shadow")]


def test_render_into_a_file_is_refused(shell: Shell, project: Path) -> None:
    assert "walk.kage" in shell.fails(4, "render", project, "-o", project)


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def no_opengl() -> GraphicsContext:
    raise GraphicsProblem(Message("OpenGL 3.3 is not available"))


def test_render_without_opengl_is_told(shell: Shell, project: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(__main__, "open_context", no_opengl)
    assert "OpenGL 3.3 is not available" in shell.fails(6, "render", project, "-o", project.parent / "out")


def test_every_sample_becomes_a_project_and_renders(shell: Shell, samples: Path, tmp_path: Path) -> None:
    """Whatever lies in the samples' folders; only notes may be said."""
    pictures = {path.parent for suffix in ("png", "webp", "tga") for path in samples.rglob(f"*.{suffix}")}
    characters = sorted(folder for folder in pictures if "bg" not in folder.relative_to(samples).parts[0])
    assert len(characters) >= 6
    for number, folder in enumerate(characters):
        path = tmp_path / f"{number}.kage"
        assert shell("new", path, "--character", f"A={folder}") == 0, shell.said
        assert all(line.startswith("kagezou: note: ") for line in shell.said.splitlines()), shell.said
        shell.ok("render", path, "-o", tmp_path / str(number), "--frames", "1", "--composite")
        shadows = list((tmp_path / str(number)).glob("*_shadow/*_0001.png"))
        assert shadows
        if "shadow" not in folder.name:  # an artist's own shadow layer is too thin to cast one
            assert any(read_cel(shadow).matte.box is not None for shadow in shadows), folder


@pytest.fixture
def short_demo(monkeypatch: pytest.MonkeyPatch) -> None:
    """Two small drawings instead of all of them, but the real project and the real rendering."""
    monkeypatch.setattr(stage, "FRAMES", 2)
    monkeypatch.setattr(stage, "SIZE_PX", 1000)
    monkeypatch.setattr(stage.make_drawings, "__defaults__", (2,))


@pytest.mark.usefixtures("short_demo")
def test_the_demo_makes_a_project_and_renders_it(shell: Shell, tmp_path: Path) -> None:
    assert shell("demo", tmp_path / "demo") == 0
    assert shell.said == f"kagezou: to open it in the window: kagezou {tmp_path / 'demo' / 'demo.kage'}\n"
    assert shell.out.splitlines()[0] == f"project    {tmp_path / 'demo' / 'demo.kage'}"
    first = read_cel(tmp_path / "demo" / "render" / "Child_shadow" / "Child_shadow_0001.png")
    assert first.matte.box is not None
    assert shell.json("info", tmp_path / "demo" / "demo.kage", "--json")["keyed"][0]["path"] == "light.azimuth"


@pytest.mark.usefixtures("short_demo")
def test_the_demo_opens_the_window_when_told_to(shell: Shell, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    opened: list[Path | None] = []

    def open_window(project: Path | None) -> int:
        opened.append(project)
        return 0

    monkeypatch.setattr(__main__, "open_window", open_window)
    assert shell("demo", tmp_path, "--window") == 0
    assert opened == [tmp_path / "demo.kage"]


def test_the_demo_never_opens_a_window_where_no_one_is_watching(monkeypatch: pytest.MonkeyPatch) -> None:
    from kagezou.cli.entry_points import EntryPoints

    with_display = EntryPoints(no_opengl, lambda _project: 0, has_display=True)
    assert not demo._window_is_wanted(None, with_display)
    assert demo._window_is_wanted(wish=True, entry_points=with_display)
    assert not demo._window_is_wanted(wish=False, entry_points=with_display)
    monkeypatch.setattr("sys.stdout", Terminal())
    assert demo._window_is_wanted(None, with_display)
    assert not demo._window_is_wanted(None, EntryPoints(no_opengl, lambda _project: 0, has_display=False))


def test_the_demo_drawings_are_clean_cels() -> None:
    drawing = drawn(pose.pose_at(36), 1000, 1000)
    alpha = drawing[..., 3]
    assert 0.05 < (alpha == 255).mean() < 0.4
    soft = (alpha > 0) & (alpha < 255)
    assert 0 < soft.mean() < 0.02
    assert not alpha[[0, -1]].any()
    assert not alpha[:, [0, -1]].any()
    assert (drawn(pose.pose_at(36), 1000, 1000) == drawing).all()
    # Straight alpha: the soft rim has the colour of the ink, not a blend with black.
    assert abs(drawing[soft][:, :3].astype(int).mean(axis=0) - (58, 38, 48)).max() < 12


def test_the_child_stands_on_the_ground_and_leaves_it() -> None:
    feet = [max(pose.pose_at(frame).near.ankle[1], pose.pose_at(frame).far.ankle[1]) for frame in range(1, 49)]
    assert all(abs(y - (pose.GROUND_Y - 27)) < 20 for y in feet[:28])
    assert min(feet) < pose.GROUND_Y - 100
    places = [pose.body_at(frame)[0] for frame in range(48)]
    assert all(0 <= after - before < 20 for before, after in pairwise(places))


def test_the_background_is_opaque_at_any_size() -> None:
    picture = painted(320, 180)
    assert picture.shape == (180, 320, 4)
    assert (picture[..., 3] == 255).all()


def test_bench_reports_what_was_measured(shell: Shell, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(operations.measured, "__defaults__", (3,))
    monkeypatch.setattr(throughput.measured, "__defaults__", (1,))
    drawings = make_drawings(tmp_path / "d", 8)
    report = shell.json("bench", "--json", "--input", drawings, "--size", "80x60", "--workers", "2")
    assert report["size"] == [80, 60]
    assert report["copy_ms"] > 0
    names = [each["name"] for each in report["operations"]]
    places = ["ground position", "declination", "roll", "tilt", "grounding point"]
    waves = ["light, simplified, waves", "wave", "light, simplified, slits"]
    simplifying = ["simplify", "distance", "light, simplified", *waves, "softness", "fade"]
    assert names == [
        "light",
        "relief",
        "moved cel",
        "joined cels",
        *places,
        "reflection",
        "contact",
        "opacity",
        *simplifying,
        "light on a set",
        "light on a wall, simplified",
        "light on a set, simplified",
        "light on a mesh set",
        "frame step",
    ]
    for each in report["operations"]:
        assert each["fps"] == pytest.approx(1000 / each["median_ms"], rel=0.02)
        assert each["ratio"] == pytest.approx(each["median_ms"] / report["copy_ms"], rel=0.05, abs=0.06)
    for export in (report["export"], report["export_two_layers"]):
        # Told in thousandths; where other work takes the machine they are few.
        assert export["of_floor"] == pytest.approx(export["fps"] / export["floor_fps"], rel=0.02, abs=1e-3)
    assert report["export_two_layers"]["size"] == [80, 60]
    assert shell("bench", "--input", drawings) == 0
    assert "frame step" in shell.out


def test_no_round_of_an_operation_shows_what_another_has(project: Path, tmp_path: Path) -> None:
    from kagezou.io.project.file import load
    from kagezou.scene.evaluate import evaluate

    document = load(project)
    for name, change in operations._changes(document, write_hills(tmp_path / "hills.ply")):
        rounds = 3 if name == "frame step" else operations.ROUNDS + 4
        scenes = [evaluate(*change(document, number)) for number in range(rounds)]
        assert len(set(scenes)) == rounds, name


def test_doctor_says_that_all_is_well(shell: Shell) -> None:
    report = shell.json("doctor", "--json")
    assert report["can_render"]
    assert report["graphics"]["max_texture_px"] >= 4096
    assert report["formats"] == {"png": True, "tga": True, "tif": True, "exr": True}
    text = shell.ok("doctor")
    assert "renderer" in text
    assert text.endswith("this machine can render\n")


@pytest.mark.parametrize(
    ("program", "problem"),
    [
        ("import time; time.sleep(600)", "did not answer"),
        ("import os; os.abort()", "crashed (signal 6)"),
        ("import sys; sys.exit('kagezou: no OpenGL at all')", "no OpenGL at all"),
        ("import sys; sys.exit(9)", "ended with code 9"),
    ],
)
def test_doctor_survives_what_a_driver_does(
    shell: Shell, monkeypatch: pytest.MonkeyPatch, program: str, problem: str
) -> None:
    really = subprocess.run

    def run(command: list[str], **options: object) -> object:
        return really([command[0], "-c", program], **options)  # type: ignore[call-overload]

    monkeypatch.setattr(subprocess, "run", run)
    monkeypatch.setattr(doctor, "PROBE_LIMIT_S", 0.5 if "sleep" in program else 60.0)
    monkeypatch.setattr(examination, "_is_debian", lambda: True)
    assert shell("doctor") == 6
    assert shell.said == ""
    assert problem in shell.out
    assert "sudo apt-get install --no-install-recommends libgl1-mesa-dri" in shell.out
    assert shell.out.endswith("this machine cannot render\n")


def test_doctor_names_the_packages_of_missing_libraries(monkeypatch: pytest.MonkeyPatch) -> None:
    release = {"ID": "ubuntu", "ID_LIKE": "debian", "VERSION_ID": "24.04"}
    monkeypatch.setattr("platform.freedesktop_os_release", lambda: release)
    report: dict[str, Json] = {
        "graphics": {"renderer": "x"},
        "window": {"qt_platforms": [], "missing_libraries": ["libglib-2.0.so.0", "libxcb-cursor.so.0"]},
        "formats": {"png": "it cannot be used: no"},
        "folders": {"state": "/x cannot be written to: no"},
        "studio": {},
    }
    said = list(examination.advice(report, can_render=True))
    assert any(line.endswith("libglib2.0-0t64 libxcb-cursor0") for line in said)
    assert any("PySide6-Essentials is not installed" in line for line in said)
    assert any(line.startswith("png: ") for line in said)
    assert any(line.startswith("state: ") for line in said)
    release["VERSION_ID"] = "22.04"
    assert any("libglib2.0-0 " in line for line in examination.advice(report, can_render=True))


@pytest.mark.parametrize(
    ("library", "mac", "said"),
    [
        (("glibc", "2.28"), "", "with glibc 2.28 its newest version is 6.9.3"),
        (("glibc", "2.9"), "", "with glibc 2.9 its newest version is 6.9.3"),
        (("glibc", "2.34"), "", None),
        (("", ""), "13.6.1", "on macOS 13.6.1 its newest version is 6.11.3"),
        (("", ""), "14.0", None),
        (("", ""), "", None),
    ],
)
def test_doctor_names_the_qt_that_an_older_system_can_have(
    monkeypatch: pytest.MonkeyPatch, library: tuple[str, str], mac: str, said: str | None
) -> None:
    monkeypatch.setattr("platform.libc_ver", lambda: library)
    monkeypatch.setattr("platform.mac_ver", lambda: (mac, ("", "", ""), ""))
    found = list(examination._fitting_qt())
    assert [each.split(":")[0] for each in found] == ([] if said is None else [said])


def test_watching_goes_on_until_it_is_stopped(project: Path, tmp_path: Path) -> None:
    progress, out = tmp_path / "progress", tmp_path / "out"
    words = ["render", project, "-o", out, "--watch", "--json", "--progress-file", progress]
    process = subprocess.Popen(
        [sys.executable, "-m", "kagezou", *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    assert process.stdout is not None
    first = json.loads(process.stdout.readline())
    assert (first["changed"], first["written"]) == ([], 3)
    make_drawings(tmp_path / "hero", count=1, size=(64, 47))
    second = json.loads(process.stdout.readline())
    assert (second["changed"], second["written"]) == ([str(tmp_path / "hero" / "walk_0001.png")], 1)
    (tmp_path / "progress.stop").touch()
    _, said = process.communicate(timeout=60)
    assert process.returncode == 130
    assert said.splitlines()[-1] == "kagezou: stopped watching; every file that is there is whole"
    assert "a drawing changed; its feet are those in the project" in said


def test_a_sheet_exposes_what_is_rendered_and_the_project_stays(shell: Shell, project: Path, tmp_path: Path) -> None:
    sheet = timesheet(tmp_path / "s.xdts", {"Hero": [(1, 2), (3, 1)]}, length=4)
    kept = project.read_bytes()
    assert shell("render", project, "-o", tmp_path / "out", "--timesheet", sheet, "--json") == 0
    told = json.loads(shell.out)
    assert (told["files"], told["drawn"]) == (4, 2)
    assert project.read_bytes() == kept


def test_a_watch_is_no_task_of_a_farm(shell: Shell, project: Path, tmp_path: Path) -> None:
    assert "do not go together" in shell.fails(2, "render", project, "-o", tmp_path / "o", "--watch", "--openjd")


def test_files_are_called_by_a_pattern(shell: Shell, project: Path) -> None:
    out = project.parent / "out"
    words = ["render", project, "-o", out, "--composite", "--names", "{layer}_{kind}.{frame:04d}"]
    assert shell.ok(*words, "--frames", "1-2", "--start-frame", "1001") == f"{out}\n"
    shell.ok(*words, "--frames", "1", "--start-frame", "0", "--skip-existing")
    assert sorted(path.name for path in out.glob("*.png")) == [
        "Hero_shadow.0000.png",
        "Hero_shadow.1001.png",
        "Hero_shadow.1002.png",
        "composite.0000.png",
        "composite.1001.png",
        "composite.1002.png",
    ]


def test_files_bear_the_numbers_of_the_cut(shell: Shell, project: Path) -> None:
    out = project.parent / "out"
    assert shell("set", project, "canvas.first_frame=101") == 0
    shell.ok("render", project, "-o", out, "--frames", "2", "--padding", "3")
    assert [path.name for path in out.glob("*/*.png")] == ["Hero_shadow_102.png"]


def test_drawings_are_never_written_over(shell: Shell, project: Path) -> None:
    drawings = project.parent / "hero"
    before = {path: path.read_bytes() for path in drawings.iterdir()}
    said = shell.fails(2, "render", project, "-o", drawings, "--names", "WALK_{frame}")
    assert "is a drawing of the project and is not written over" in said
    assert {path: path.read_bytes() for path in drawings.iterdir()} == before


def test_a_bundle_lies_beside_the_project_unless_it_is_told_where(shell: Shell, project: Path) -> None:
    drawings = project.parent / "hero"
    job = project.with_name(f"{project.stem}_job") / "template.json"
    assert shell.ok("farm", project, "--program", "kz") == f"{job}\n"
    assert project.with_name(f"{project.stem}_shadows").as_posix() in job.with_name("parameter_values.json").read_text()
    other = project.parent / "other"
    words = ["--bundle", other, "-o", project.parent / "frames", "--start-frame", "1001", "--program", "kagezou"]
    shell.ok("farm", project, *words)
    assert '"1001"' in (other / "template.json").read_text()
    assert "no part of a bundle" in shell.fails(2, "farm", project, "--program", "kz", "--bundle", drawings)
