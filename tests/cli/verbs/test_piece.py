"""``kagezou piece``, and what the other commands know of a set."""

import json
from pathlib import Path

import pytest

from kagezou.io.images.reading import read_cel
from kagezou.scene import heavy_sets
from tests.cli.projects import Shell


def test_pieces_are_added_changed_listed_and_removed(shell: Shell, project: Path) -> None:
    assert shell("piece", project, "add", "back", "wall") == 0
    assert shell.said == "kagezou: note: Hero: standing upright now, as the set does\n"
    assert shell.json("get", project, "layers.Hero.upright") == 1
    shell.ok("piece", project, "add", "stairs", "steps", "position=[56,38]", "count=3", "casts=true")
    assert shell.ok("piece", project, "list") == "wall\tback\nsteps\tstairs\n"
    shell.ok("set", project, "set.back.angle=20")
    shell.ok("set", project, "set.back.angle=-20", "--frame", "3")
    assert shell.json("get", project, "set.stairs.count") == 3
    assert shell.json("get", project, "set.back.angle", "--frame", "3") == -20
    shell.ok("piece", project, "copy", "stairs")
    shell.ok("piece", project, "rename", "stairs 2", "dais")
    shell.ok("piece", project, "remove", "stairs")
    assert shell.json("info", project, "--json")["set"] == [
        {"name": "back", "kind": "wall"},
        {"name": "dais", "kind": "steps"},
    ]
    assert "set piece   dais: steps" in shell.ok("info", project)


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["add", "x", "wal"], "did you mean wall?"),
        (["add", "x"], "add what?"),
        (["add", "x", "box", "tall=3"], "no property 'tall'"),
        (["add", "x", "box", "width=["], "is not JSON"),
        (["add", "x", "box", "width"], "PROPERTY=JSON"),
        (["add", "shadow", "box"], "shadow of the whole set"),
        (["add"], "which piece is to add?"),
        (["remove", "x"], "no set piece 'x'"),
        (["rename", "back"], "old name and the new one"),
        (["remove", "back", "now"], "'now' is not expected here"),
    ],
)
def test_what_cannot_be_done_is_told(shell: Shell, project: Path, words: list[str], told: str) -> None:
    shell("piece", project, "add", "back", "wall")
    before = project.read_bytes()
    assert told in shell.fails(2, "piece", project, *words)
    assert project.read_bytes() == before


def test_a_set_that_casts_is_rendered_beside_the_characters(shell: Shell, project: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    shell("piece", project, "add", "crate", "box", "position=[20,44]", "width=12", "height=12", "depth=10")
    shell("render", project, "-o", out, "--frames", "1", "--composite")
    assert not (out / "set_shadow").exists()
    shell.ok("set", project, "set.crate.casts=true", "set.shadow.color=#102030")
    assert shell("render", project, "-o", out, "--frames", "1-2", "--composite") == 0
    first = read_cel(out / "set_shadow" / "set_shadow_0001.png").rgba
    assert (first[..., :3] == (0x10, 0x20, 0x30)).all()
    assert first[..., 3].max() == 153
    assert (out / "set_shadow" / "set_shadow_0002.png").is_file()
    shell.ok("set", project, "set.crate.casts=false", "--frame", "2")
    assert shell("render", project, "-o", out, "--frames", "2", "--layer", "Hero") == 0


def test_a_set_from_a_file_is_followed_and_missed(shell: Shell, project: Path, samples: Path, tmp_path: Path) -> None:
    kept = tmp_path / "set.glb"
    kept.write_bytes((samples / "bg3d_dungeon_stairs" / "scene.glb").read_bytes())
    words = ("add", "dungeon", "mesh", 'display="clay"', "--file", kept, "--camera", "shot_cam")
    assert shell("piece", project, *words) == 0
    assert "the height was kept, the sides differ" in shell.said
    assert shell.json("get", project, "camera.fov") == 42
    assert shell.json("get", project, "ground.receives") is False
    assert shell.json("get", project, "set.dungeon.display") == "clay"
    assert shell.ok("piece", project, "list") == f"mesh\tdungeon\t{kept}\n"
    assert f"mesh of {kept}\n  camera    shot_cam\n" in shell.ok("info", project)
    shell.ok("render", project, "-o", tmp_path / "out", "--frames", "1", "--composite")
    kept.unlink()
    said = shell.fails(3, "render", project, "-o", tmp_path / "again", "--frames", "1")
    assert said == f"{kept}: the set is missing"
    assert shell("info", project, "--json") == 3
    assert json.loads(shell.out)["missing"] == [str(kept)]


def test_a_set_without_a_camera_has_the_size_that_is_said(shell: Shell, project: Path, tmp_path: Path) -> None:
    kept = tmp_path / "set.obj"
    kept.write_text("v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n")
    assert shell("piece", project, "add", "floor", "mesh", "--file", kept, "--scale", "20", "--up", "z") == 0
    assert "standing upright now" in shell.said
    assert shell.json("get", project, "set.floor.scale") == 20
    assert shell.json("get", project, "set.floor.up") == "z"


@pytest.mark.parametrize(
    ("words", "cause"),
    [
        (("add", "x", "mesh"), "which file"),
        (("add", "x", "wall", "--camera", "a"), "belong to: add NAME mesh"),
        (("add", "x", "mesh", "--file", "x.glb", "--stand", "here"), "not a point"),
        (("add", "x", "mesh", "lean", "--file", "x.glb"), "not PROPERTY=JSON"),
        (("add", "x", "mesh", "--file", "x.glb", "--scale", "0"), "not a number over 0"),
        (("add", "x", "mesh", "--file", "x.glb", "--scale", "20", "--camera", "c"), "leave out --scale"),
    ],
)
def test_wrong_words_about_a_mesh_are_one_sentence(
    shell: Shell, project: Path, words: tuple[str, ...], cause: str
) -> None:
    assert cause in shell.fails(2, "piece", project, *words)


def test_a_set_whose_frames_take_minutes_is_said(
    shell: Shell, project: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert shell("piece", project, "add", "stairs", "steps", "count=3") == 0
    assert "minutes" not in shell.said
    monkeypatch.setattr(heavy_sets, "MAX_PAIRS", 50)
    assert shell("set", project, "set.stairs.count=8") == 0
    assert "minutes" not in shell.said, "so it was before"
    assert shell("render", project, "-o", tmp_path / "out", "--frames", "1") == 0
    assert "note: the set pieces have 48 flat faces: drawing a frame may take minutes" in shell.said
    monkeypatch.setattr(heavy_sets, "MAX_PAIRS", 400)
    assert shell("piece", project, "copy", "stairs") == 0
    assert "note: the set pieces have 96 flat faces" in shell.said
