"""Cuts as values: opened, made, changed, saved; by the same words as on the command line."""

import json
import os
import socket
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import kagezou
from kagezou.interface.cut import Cut
from kagezou.io.project.open_elsewhere import lock_of_window
from tests.cli.projects import Shell, make_drawings


@pytest.fixture
def shell(capsys: pytest.CaptureFixture[str]) -> Shell:
    return Shell(capsys)


def test_a_new_cut_is_what_the_command_line_makes(drawings: Path, tmp_path: Path, shell: Shell) -> None:
    made = kagezou.new({"Hero": drawings}).with_feet().save(tmp_path / "a.kage")
    assert made.notes[0] == "Hero: 3 drawings, 1-3, walk_0001.png … walk_0003.png"
    assert (made.size, made.length, made.characters) == ((64, 48), 3, ("Hero",))
    assert shell("new", tmp_path / "b.kage", "--character", f"Hero={drawings}") == 0
    assert (tmp_path / "a.kage").read_bytes() == (tmp_path / "b.kage").read_bytes()


def test_what_a_cut_can_be_made_of(drawings: Path, tmp_path: Path) -> None:
    arm = make_drawings(tmp_path / "arm")
    made = kagezou.new(
        {"Hero": drawings, "Hero=arm": arm}, background=drawings / "walk_0001.png", size=(80, 60), fps="23.976"
    )
    assert made.value("layers.arm.joins") == "Hero"
    assert (made.value("canvas.size"), made.value("canvas.fps")) == ("80x60", "24000/1001")
    assert kagezou.new(drawings, fps=Fraction(25)).value("canvas.fps") == "25"
    like = kagezou.new({"B": arm}).with_values({"light.kind": "sun", "canvas.first_frame": 1001})
    assert kagezou.new({"Hero": drawings}, template=like).value("canvas.first_frame") == 1001
    like.save(tmp_path / "like.kage")
    assert kagezou.new({"Hero": drawings}, template=tmp_path / "like.kage").value("light.kind") == "sun"
    with pytest.raises(kagezou.InputProblem) as found:
        kagezou.new({"Hero": tmp_path / "nowhere"})
    assert (found.value.file, found.value.code) == (str(tmp_path / "nowhere"), 3)


@pytest.mark.parametrize(
    ("path", "given", "found"),
    [
        ("light.position", (100, -20.5, 30), (100.0, -20.5, 30.0)),
        ("light.position", "100,-20.5,30", (100.0, -20.5, 30.0)),
        ("light.position", np.array([1.0, 2.0, 3.0]), (1.0, 2.0, 3.0)),
        ("light.kind", "sun", "sun"),
        ("layers.Hero.shadow.color", "#a0B0c0", "#A0B0C0"),
        ("layers.Hero.visible", False, False),
        ("layers.Hero.visible", "false", False),
        ("layers.Hero.shadow.opacity", np.float32(0.25), 0.25),
        ("layers.Hero.grounding", [(1, 2), (30, 4)], ((1.0, 2.0), (30.0, 4.0))),
        ("layers.Hero.locked", True, "true"),
        ("canvas.size", (128, 96), "128x96"),
        ("canvas.fps", Fraction(24000, 1001), "24000/1001"),
        ("canvas.length", 7, 7),
        ("canvas.name", "Episode 3", "Episode 3"),
    ],
)
def test_what_is_set_is_got_and_the_cut_before_stays(cut: Cut, path: str, given: object, found: object) -> None:
    before = cut.value(path)
    after = cut.with_value(path, given)
    assert after.value(path) == found
    assert cut.value(path) == before
    assert path in cut.paths


def test_keys(cut: Cut) -> None:
    path = "layers.Hero.shadow.opacity"
    keyed = cut.with_value(path, 0.2, 1).with_value(path, 0.8, 3, ease=True)
    assert keyed.keys(path) == (
        kagezou.PropertyKey(1, 0.2, "bezier"),
        kagezou.PropertyKey(3, 0.8, "linear"),
    )
    assert keyed.value(path, 2) == pytest.approx(0.5)
    assert cut.with_value(path, 0.2, 1, interpolation="hold").keys(path)[0].interpolation == "hold"
    with pytest.raises(kagezou.UsageProblem, match="has keys"):
        keyed.value(path)
    assert keyed.without_key(path, 3).without_key(path, 1).keys(path) == ()
    with pytest.raises(kagezou.UsageProblem, match="needs a frame"):
        cut.with_value(path, 1, ease=True)
    with pytest.raises(kagezou.UsageProblem, match="no interpolation"):
        cut.with_value(path, 1, 2, interpolation="smooth")
    with pytest.raises(kagezou.UsageProblem, match="no frame"):
        cut.with_value(path, 1, 2.5)  # type: ignore[arg-type]
    assert cut.with_value(path, 1, np.int64(2)).keys(path)[0].frame == 2  # type: ignore[arg-type]
    with pytest.raises(kagezou.UsageProblem, match="no keys"):
        cut.with_values({"canvas.length": 5}, 2)
    with pytest.raises(kagezou.UsageProblem, match=r"did you mean light\.position"):
        cut.with_value("light.positon", 1)


def test_the_same_steps_leave_the_same_project_as_the_command_line(cut: Cut, tmp_path: Path, shell: Shell) -> None:
    assert cut.path is not None
    shell("set", cut.path, "canvas.size=128x96", "light.position=1,-2,3", "layers.Hero.position=40,30")
    shell("set", cut.path, "ground.roll=0", "--frame", 1)
    shell("set", cut.path, "ground.roll=9", "--frame", 3, "--ease")
    shell("style", cut.path, "water")
    steps = cut.with_values({"light.position": (1, -2, 3), "layers.Hero.position": (40, 30), "canvas.size": (128, 96)})
    steps = steps.with_value("ground.roll", 0, 1).with_value("ground.roll", 9, 3, ease=True).with_style("Water")
    steps.save(tmp_path / "other.kage")
    assert json.loads((tmp_path / "other.kage").read_text()) == json.loads(cut.path.read_text())


def test_what_is_said_is_kept_once(cut: Cut) -> None:
    smaller = cut.with_value("canvas.size", (32, 24)).with_value("canvas.length", 2)
    assert "what lies beyond the smaller picture is kept and not seen" in smaller.notes
    assert len(smaller.notes) == len(set(smaller.notes))
    assert smaller.with_value("light.kind", "sun").notes[: len(smaller.notes)] == smaller.notes


def test_feet_can_be_watched_and_stopped(cut: Cut) -> None:
    told: list[tuple[int, int]] = []
    found = cut.with_feet("Hero", progress=lambda done, whole: told.append((done, whole)))
    assert told == [(1, 3), (2, 3), (3, 3)]
    assert found != cut
    with pytest.raises(kagezou.Stopped):
        cut.with_feet(stop=lambda: True)
    with pytest.raises(kagezou.UsageProblem, match="no layer"):
        cut.with_feet("Nobody")


def test_styles(cut: Cut) -> None:
    assert "Water" in kagezou.styles()
    assert cut.with_style("水面") == cut.with_style("Water", "Hero")
    assert any("with_light=True" in note for note in cut.with_style("Long evening").notes)
    assert cut.with_style("Long evening", with_light=True).value("light.kind") == "sun"
    assert any("no light of its own" in note for note in cut.with_style("Simple", with_light=True).notes)
    with pytest.raises(kagezou.UsageProblem, match="did you mean Water"):
        cut.with_style("Wate")


def test_a_style_of_the_studio_and_one_that_cannot_be_read(
    cut: Cut, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "styles").mkdir()
    (tmp_path / "styles" / "broken.json").write_text("{")
    monkeypatch.setenv("KAGEZOU_STYLES", str(tmp_path / "styles"))
    with pytest.warns(UserWarning, match=r"broken\.json"):
        assert "Water" in kagezou.styles()
    assert any("broken.json" in note for note in cut.with_style("Water").notes)


def test_parts_of_another_cut(cut: Cut) -> None:
    lit = cut.with_values({"light.kind": "sun", "ground.roll": 5})
    assert cut.with_parts_of(lit, "light").value("light.kind") == "sun"
    assert cut.with_parts_of(lit, "light").value("ground.roll") == 0
    assert cut.with_parts_of(lit).value("ground.roll") == 5
    with pytest.raises(kagezou.UsageProblem, match="no part"):
        cut.with_parts_of(lit, "mood")  # type: ignore[arg-type]


def test_nobodys_work_is_replaced_unasked(cut: Cut, tmp_path: Path) -> None:
    assert cut.path is not None
    mine, theirs = kagezou.open(cut.path), kagezou.open(cut.path)
    theirs.with_value("ground.roll", 5).save()
    with pytest.raises(kagezou.OutputProblem, match="somebody else has changed it"):
        mine.with_value("ground.roll", 7).save()
    saved = mine.with_value("ground.roll", 7).save(force=True)
    saved.with_value("ground.roll", 8).save()
    assert kagezou.open(cut.path).value("ground.roll") == 8
    with pytest.raises(kagezou.OutputProblem, match="force=True"):
        kagezou.new({"A": tmp_path / "hero"}).save(cut.path)
    with pytest.raises(kagezou.UsageProblem, match="never saved"):
        kagezou.new({"A": tmp_path / "hero"}).save()
    with pytest.raises(kagezou.ProjectProblem):
        kagezou.open(tmp_path / "no.kage")


def test_editing_at_once_loses_nothing(cut: Cut) -> None:
    assert cut.path is not None
    path = cut.path

    def add(_number: int) -> None:
        kagezou.edit(path, lambda now: now.with_value("canvas.length", int(str(now.value("canvas.length"))) + 1))

    with ThreadPoolExecutor(4) as pool:
        list(pool.map(add, range(12)))
    assert kagezou.open(path).value("canvas.length") == 3 + 12
    stamp = path.stat().st_mtime_ns
    assert kagezou.edit(path, lambda now: now) == kagezou.open(path)
    assert path.stat().st_mtime_ns == stamp


def test_a_window_that_has_it_open_is_told_of(cut: Cut) -> None:
    assert cut.path is not None
    lock_of_window(cut.path).write_text(f"{os.getpid()}\nkagezou\n{socket.gethostname()}\n")
    said = f"walk.kage: it is open in a window on {socket.gethostname()}, which will ask before it saves over this"
    assert said in cut.with_value("ground.roll", 1).save().notes
    assert said in kagezou.edit(cut.path, lambda now: now.with_value("ground.roll", 2)).notes


def test_what_is_missing_is_told(cut: Cut, drawings: Path) -> None:
    assert cut.check() == ()
    (drawings / "walk_0002.png").unlink()
    assert cut.check() == (f"missing: {drawings / 'walk_0002.png'}",)


def test_cuts_are_values(cut: Cut) -> None:
    assert cut.path is not None
    assert kagezou.open(cut.path) == cut
    assert repr(cut) == f"<Cut {cut.path}: 64 x 48 px, 3 frames>"
    assert "unsaved" in repr(kagezou.new(cut.path.parent / "hero"))
    with pytest.raises(AttributeError):
        cut.path = None  # type: ignore[misc]
