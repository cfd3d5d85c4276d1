"""new, set, get and info."""

import json
from pathlib import Path

import pytest

from kagezou.document.address import Address
from kagezou.document.linking import link
from kagezou.document.properties import OPACITY
from kagezou.io.project.file import load, save
from tests.cli.projects import Shell, make_drawings


def test_a_new_project_has_what_was_said(shell: Shell, tmp_path: Path) -> None:
    a, b = make_drawings(tmp_path / "a", 5), make_drawings(tmp_path / "b", 2)
    path = tmp_path / "duo.kage"
    words = ["--character", f"A={a}", "--character", f"B={b}", "--size", "200x100", "--fps", "23.976"]
    shell.ok("new", "--no-feet", path, *words, "--background", a / "walk_0001.png")
    about = shell.json("info", path, "--json")
    assert (about["width_px"], about["height_px"], about["frame_rate"]) == (200, 100, "24000/1001")
    assert [layer["name"] for layer in about["layers"]] == ["A", "B"]
    assert (about["last_frame"], about["missing"], about["keyed"]) == (5, [], [])
    assert about["background"] == str(a / "walk_0001.png")


def test_a_project_that_is_there_is_not_replaced_unasked(shell: Shell, project: Path) -> None:
    before = project.read_bytes()
    assert "--force" in shell.fails(4, "new", project)
    assert project.read_bytes() == before
    assert "no character and no background" in shell.fails(2, "new", "--no-feet", project, "--force")
    assert project.read_bytes() == before
    drawing = make_drawings(project.parent / "b", 1)
    shell.ok("new", "--no-feet", project, "--force", "--character", f"B={drawing}")
    assert [layer["name"] for layer in shell.json("info", project, "--json")["layers"]] == ["B"]


@pytest.mark.parametrize(
    ("words", "code", "sentence"),
    [
        (["--character", "Hero"], 2, "NAME=FOLDER_OR_FILE"),
        (["--character", "Hero=nowhere"], 3, "nowhere: it does not exist"),
        (["--size", "10"], 2, "1920x1080"),
        (["--size", "0x10"], 2, "not within"),
        (["--fps", "0"], 2, "frames a second"),
        (["--fps", "1/0"], 2, "frames a second"),
        (["--background", "no.png"], 3, "no.png"),
        (["--timesheet", "no.xdts"], 3, "no.xdts"),
    ],
)
def test_what_a_new_project_cannot_be_made_of(
    shell: Shell, tmp_path: Path, words: list[str], code: int, sentence: str
) -> None:
    assert sentence in shell.fails(code, "new", tmp_path / "p.kage", *words)
    assert not (tmp_path / "p.kage").exists()


@pytest.mark.parametrize(
    ("assignment", "expected"),
    [
        ("light.position=[100,-20.5,30]", [100, -20.5, 30]),
        ("light.kind=sun", "sun"),
        ('light.kind="sun"', "sun"),
        ("layers.Hero.shadow.color=#a0B0c0", "#A0B0C0"),
        ("layers.Hero.visible=false", False),
        ("layers.Hero.shadow.opacity=0.25", 0.25),
        ("layers.Hero.grounding=[[1,2],[30,4]]", [[1, 2], [30, 4]]),
        (" ground.roll = 5 ", 5),
    ],
)
def test_what_is_set_is_got(shell: Shell, project: Path, assignment: str, expected: object) -> None:
    shell.ok("set", project, assignment)
    assert shell.json("get", project, assignment.split("=")[0].strip()) == expected


def test_keys(shell: Shell, project: Path) -> None:
    shell.ok("set", project, "ground.roll=0", "light.kind=sun", "--frame", 1)
    shell.ok("set", project, "ground.roll=10", "--frame", 3, "--interp", "bezier")
    assert shell.json("get", project, "ground.roll", "--frame", 2) == 5
    keys = shell.json("get", project, "ground.roll")
    assert [(key["frame"], key["value"], key["interp"]) for key in keys] == [(1, 0, "linear"), (3, 10, "bezier")]
    whole = shell.json("get", project, "ground.roll", "--json")
    assert (whole["path"], whole["unit"], whole["value"], whole["keys"]) == ("ground.roll", "°", None, keys)
    assert shell.json("get", project, "light.kind", "--json")["keys"][0]["interp"] == "hold"
    shell.ok("set", project, "ground.roll=7")
    assert shell.json("get", project, "ground.roll") == 7


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["light.positoin=1"], "did you mean light.position"),
        (["layers.Hera.tilt=1"], "did you mean layers.Hero.tilt"),
        (["light.position=[1,2]"], "[x, y, z]"),
        (["layers.Hero.shadow.opacity=2"], "0 to 1"),
        (["layers.Hero.shadow.opacity=NaN"], "NaN"),
        (["layers.Hero.shadow.opacity=1e999"], "0 to 1"),
        (["light.kind=moon"], "sun"),
        (["light.position=[1,2"], "is not JSON"),
        (["light.position=" + "[" * 9999], "is not JSON"),
        (["light.position"], "PATH=JSON"),
        (["=5"], "PATH=JSON"),
        (["ground.roll=5", "--frame", "0"], "1 or more"),
        (["ground.roll=5", "--interp", "hold"], "needs --frame"),
        (["light.kind=sun", "--frame", "2", "--interp", "linear"], "held"),
        (["ground.roll=5", "--interp", "smooth", "--frame", "2"], "hold"),
    ],
)
def test_what_cannot_be_set_changes_nothing(shell: Shell, project: Path, words: list[str], sentence: str) -> None:
    before = project.read_bytes()
    assert sentence in shell.fails(2, "set", project, "ground.declination=33", *words)
    assert project.read_bytes() == before


def test_setting_what_is_so_writes_nothing(shell: Shell, project: Path) -> None:
    shell.ok("set", project, "ground.roll=0")
    assert not project.with_name("walk.kage~").exists()


def test_a_layer_name_with_an_equals_sign_and_dots(shell: Shell, tmp_path: Path) -> None:
    drawings = make_drawings(tmp_path / "d", 1)
    shell.ok("new", "--no-feet", tmp_path / "p.kage", "--character", f"a.b={drawings}")
    shell.ok("set", tmp_path / "p.kage", "layers.a.b.tilt=3")
    assert shell.json("get", tmp_path / "p.kage", "layers.a.b.tilt") == 3


def test_info_says_what_is_missing_and_keyed(shell: Shell, project: Path) -> None:
    shell.ok("set", project, "ground.roll=0", "--frame", 2)
    gone = project.parent / "hero" / "walk_0002.png"
    gone.unlink()
    about = json.loads(shell.missing("info", project, "--json"))
    assert about["missing"] == [str(gone)]
    assert about["keyed"] == [{"path": "ground.roll", "frames": [2]}]
    text = shell.missing("info", project)
    assert f"missing     {gone}" in text
    assert "keys        ground.roll on 2" in text
    assert "Hero: 3 drawings" in text


def test_info_lists_every_property(shell: Shell, project: Path) -> None:
    from kagezou.document.cut_words import CUT_WORDS
    from kagezou.document.properties import OF_DOCUMENT, OF_LAYER, OF_PIECE

    table = [*OF_DOCUMENT.values(), *OF_LAYER.values(), *OF_PIECE.values()]
    shell("piece", project, "add", "back", "wall")
    text = shell.ok("info", project, "--properties")
    rows = shell.json("info", project, "--properties", "--json")["properties"]
    said = ("joins", "paper", "locked", "solo", "label")
    others = [*(f"layers.Hero.{name}" for name in said), *(word.path for word in CUT_WORDS)]
    assert [row["path"] for row in rows[len(table) :]] == others
    assert 'layers.Hero.joins = ""  (""; no keys)' in text
    assert 'layers.Hero.paper = "white"  (white | border; no keys)' in text
    assert all(row["help_ja"] != row["help"] for row in rows)
    for line, row in zip(table, rows[: len(table)], strict=True):
        assert row["path"].endswith(line.name)
        assert row["path"] + " = " in text
        assert row["help_ja"]
        assert str(line.help) in text


@pytest.mark.parametrize("verb", ["info", "get", "set", "render"])
def test_a_project_that_cannot_be_read_is_told(shell: Shell, tmp_path: Path, verb: str) -> None:
    words: dict[str, list[object]] = {"get": ["ground.roll"], "set": ["ground.roll=1"], "render": ["-o", tmp_path]}
    more = words.get(verb, [])
    assert "nowhere.kage" in shell.fails(7, verb, tmp_path / "nowhere.kage", *more)
    broken = tmp_path / "broken.kage"
    broken.write_text(json.dumps({"format": "something else"}))
    assert "broken.kage" in shell.fails(7, verb, broken, *more)


def test_set_obeys_a_link(shell: Shell, tmp_path: Path) -> None:
    drawings, path = make_drawings(tmp_path / "a", 1), tmp_path / "duo.kage"
    shell.ok("new", "--no-feet", path, "--character", f"A={drawings}", "--character", f"B={drawings}")
    document = load(path)
    save(link(document, Address(OPACITY, document.layers[0].id)), path)
    shell.ok("set", path, "layers.B.shadow.opacity=0.25", "--frame", "3")
    assert json.loads(shell.ok("get", path, "layers.A.shadow.opacity", "--frame", "3")) == 0.25
    assert load(path).linked == {OPACITY.name}
    assert shell.json("info", path, "--json")["linked"] == [OPACITY.name]
    assert "linked      layers.*.shadow.opacity" in shell.ok("info", path)
