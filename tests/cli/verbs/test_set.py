"""``kagezou set`` where a value means more than itself: a figure that is made to travel leaves its lamp."""

import subprocess
import sys
from pathlib import Path

import pytest

from tests.cli.projects import Shell, make_drawings


def test_a_figure_that_is_sent_across_the_picture_is_lit_by_the_sun(shell: Shell, tmp_path: Path) -> None:
    project = tmp_path / "p.kage"
    assert shell("new", project, "--character", f"A={make_drawings(tmp_path / 'walk', 4, (640, 360))}") == 0
    assert shell.json("get", project, "light.kind") == "point"
    shell.ok("set", project, "layers.A.position=[0,180]", "--frame", 1)
    assert shell.json("get", project, "light.kind") == "point"
    assert shell("set", project, "layers.A.position=[600,180]", "--frame", 4) == 0
    assert "the light is the sun now" in shell.said
    assert shell.json("get", project, "light.kind") == "sun"


def test_a_lamp_that_was_set_stays(shell: Shell, tmp_path: Path) -> None:
    project = tmp_path / "p.kage"
    assert shell("new", project, "--character", f"A={make_drawings(tmp_path / 'walk', 4, (640, 360))}") == 0
    shell.ok("set", project, "light.position=[320,-100,300]")
    shell.ok("set", project, "layers.A.position=[0,180]", "--frame", 1)
    assert shell("set", project, "layers.A.position=[600,180]", "--frame", 4) == 0
    assert "turns round while the figure travels" in shell.said
    assert shell.json("get", project, "light.kind") == "point"


class TestLoopingWaves:
    def project(self, shell: Shell, tmp_path: Path) -> Path:
        project = tmp_path / "p.kage"
        drawings = make_drawings(tmp_path / "walk", 48, (64, 36))
        assert shell("new", project, "--no-feet", "--character", f"A={drawings}", "--character", f"B={drawings}") == 0
        return project

    def test_both_speeds_are_set_and_said(self, shell: Shell, tmp_path: Path) -> None:
        project = self.project(shell, tmp_path)
        shell.ok("set", project, "layers.A.shadow.wave1.velocity=1", "--frame", 1)
        shell.ok("set", project, "layers.A.shadow.wave1.velocity=5", "--frame", 9)
        assert shell("set", project, "layers.A.shadow.wave1.amplitude=5", "--loop-waves") == 0
        # The first frame's 1 px a frame are 48 of a length of 60; 2 px of the other are 96 of 37.
        assert "A: wave 1 goes 1.25 px a frame; crests that pass in the cut: 1" in shell.said
        assert "A: wave 2 goes 2.3125 px a frame; crests that pass in the cut: 3" in shell.said
        assert "B: " not in shell.said
        for layer, first, second in (("A", 1.25, 37 * 3 / 48), ("B", 3.0, 2.0)):
            assert shell.json("get", project, f"layers.{layer}.shadow.wave1.velocity") == first
            assert shell.json("get", project, f"layers.{layer}.shadow.wave2.velocity") == second

    def test_gaps_go_with_waves_of_no_height(self, shell: Shell, tmp_path: Path) -> None:
        project = self.project(shell, tmp_path)
        assert shell("set", project, "layers.B.shadow.slits=0.5", "--loop-waves") == 0
        assert "B: wave 1 goes 2.5 px a frame" in shell.said

    def test_what_keeps_waves_from_looping_is_said(self, shell: Shell, tmp_path: Path) -> None:
        project = self.project(shell, tmp_path)
        shell.ok("set", project, "layers.A.shadow.wave1.wavelength=50", "--frame", 1)
        assert shell("set", project, "layers.A.shadow.wave1.amplitude=5", "--loop-waves") == 0
        assert "the length of wave 1 is keyed" in shell.said
        assert "the length of wave 2 is keyed" not in shell.said

    def test_without_waves_nothing_is_written(self, shell: Shell, tmp_path: Path) -> None:
        project = self.project(shell, tmp_path)
        before = project.read_bytes()
        assert shell("set", project, "--loop-waves") == 0
        assert "no shadow lies on waves" in shell.said
        assert project.read_bytes() == before

    def test_what_cannot_be_meant_is_refused(self, shell: Shell, tmp_path: Path) -> None:
        project = self.project(shell, tmp_path)
        assert shell("set", project) == 2
        assert "there is nothing to set" in shell.said
        assert shell("set", project, "--loop-waves", "--frame", 3) == 2
        assert "goes without --frame" in shell.said


def test_parallel_writers_never_lose_an_edit(shell: Shell, project: Path) -> None:
    """Each in a process of its own, all at once."""
    names = [f"shadow.{name}" for name in ("simplify", "distance", "grow", "softness", "fade", "tip_distance")]
    writers = [
        subprocess.Popen([sys.executable, "-m", "kagezou", "set", str(project), f"layers.Hero.{name}={number}"])
        for number, name in enumerate(names, start=11)
    ]
    assert [writer.wait() for writer in writers] == [0] * len(names)
    for number, name in enumerate(names, start=11):
        assert shell.ok("get", project, f"layers.Hero.{name}").strip() == str(number)


def test_a_project_that_a_window_has_open_is_changed_and_that_is_said(shell: Shell, project: Path) -> None:
    project.with_name(f".{project.name}.lock").write_text("1\nkagezou\nstudio-7\n", encoding="utf-8")
    assert shell("set", project, "layers.Hero.shadow.opacity=0.5") == 0
    assert "open in a window on studio-7" in shell.said
    assert shell.ok("get", project, "layers.Hero.shadow.opacity").strip() == "0.5"


@pytest.mark.parametrize(
    ("verb", "words"),
    [
        ("piece", ["add", "back", "wall"]),
        ("style", ["natural"]),
        ("new", ["--character", "Hero=hero", "--force", "--no-feet"]),
        ("retake", ["Hero=hero"]),
        ("apply", ["--light"]),
    ],
)
def test_every_verb_that_writes_a_project_says_that_a_window_has_it_open(
    shell: Shell, project: Path, monkeypatch: pytest.MonkeyPatch, verb: str, words: list[str]
) -> None:
    """Two instances on one project: the command line looks at the window's lock, whatever it writes."""
    monkeypatch.chdir(project.parent)
    project.with_name(f".{project.name}.lock").write_text("1\nkagezou\nstudio-7\n", encoding="utf-8")
    before = [project] if verb != "apply" else [project, project]
    assert shell(verb, *before, *words) == 0, shell.said
    assert "open in a window on studio-7" in shell.said
    assert not list(project.parent.glob(".*.edit"))


def test_places_need_no_brackets(shell: Shell, project: Path) -> None:
    shell.ok("set", project, "light.position=10,-20.5,+30", "ground.position=1, 2")
    assert shell.json("get", project, "light.position") == [10, -20.5, 30]
    assert shell.json("get", project, "ground.position") == [1, 2]
    assert "is not a point [x, y, z]" in shell.fails(2, "set", project, "light.position=1,2")


def test_an_ease_is_the_whole_way_to_a_key(shell: Shell, project: Path) -> None:
    path = "layers.Hero.shadow.opacity"
    assert "no key before frame 1" in shell.fails(2, "set", project, f"{path}=0.1", "--frame", 1, "--ease")
    shell.ok("set", project, f"{path}=0.0", "--frame", 1)
    shell.ok("set", project, f"{path}=1.0", "--frame", 5, "--ease")
    early, late = (shell.json("get", project, path, "--frame", frame) for frame in (2, 4))
    assert early < 0.25, "slowly off"
    assert late > 0.75, "slowly on"
    assert early == pytest.approx(1 - late)
    assert "goes without --interp" in shell.fails(
        2, "set", project, f"{path}=1", "--frame", 5, "--ease", "--interp", "hold"
    )
    shell.ok("set", project, "layers.Hero.visible=true", "--frame", 1)
    assert "are held" in shell.fails(2, "set", project, "layers.Hero.visible=false", "--frame", 3, "--ease")


def test_a_property_that_does_nothing_for_a_piece_is_refused(shell: Shell, project: Path) -> None:
    assert shell("piece", project, "add", "back", "wall") == 0
    before = project.read_bytes()
    assert "it means nothing for the kind wall" in shell.fails(2, "set", project, "set.back.display=clay")
    assert project.read_bytes() == before
    shell.ok("set", project, "set.back.lean=10")
