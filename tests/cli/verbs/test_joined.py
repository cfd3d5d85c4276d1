"""Several cels of one figure, from the command line."""

from pathlib import Path

from tests.cli.projects import Shell, make_drawings


def duo(shell: Shell, folder: Path) -> Path:
    body, arm = make_drawings(folder / "body"), make_drawings(folder / "arm", 2)
    path = folder / "duo.kage"
    shell("new", path, "--character", f"Hero={body}", "--cel", f"Hero=arm={arm}")
    return path


def test_a_cel_joins_its_character(shell: Shell, tmp_path: Path) -> None:
    path = duo(shell, tmp_path)
    assert [(each["name"], each["joins"]) for each in shell.json("info", path, "--json")["layers"]] == [
        ("Hero", ""),
        ("arm", "Hero"),
    ]
    assert "arm: 2 drawings" in shell.out or ", joins Hero" in shell.ok("info", path)
    assert shell.json("get", path, "layers.arm.joins") == "Hero"


def test_only_the_figure_has_a_shadow(shell: Shell, tmp_path: Path) -> None:
    path = duo(shell, tmp_path)
    shell.ok("render", path, "-o", tmp_path / "out")
    assert [each.name for each in (tmp_path / "out").iterdir() if each.is_dir()] == ["Hero_shadow"]
    assert "part of Hero" in shell.fails(2, "render", path, "-o", tmp_path / "none", "--layer", "arm")


def test_joining_is_set_and_undone_by_name(shell: Shell, tmp_path: Path) -> None:
    path = duo(shell, tmp_path)
    shell.ok("set", path, 'layers.arm.joins=""')
    assert shell.json("get", path, "layers.arm.joins", "--json")["value"] == ""
    shell.ok("set", path, "layers.Hero.joins=arm")
    assert shell.json("get", path, "layers.Hero.joins") == "arm"


def test_what_cannot_be_joined_is_one_line(shell: Shell, tmp_path: Path) -> None:
    path = duo(shell, tmp_path)
    assert "Nobody" in shell.fails(2, "set", path, "layers.arm.joins=Nobody")
    assert "own figure" in shell.fails(2, "set", path, "layers.Hero.joins=Hero")
    assert "no keys" in shell.fails(2, "set", path, "layers.arm.joins=Hero", "--frame", 3)
    drawings = tmp_path / "body"
    words = ("new", tmp_path / "x.kage", "--cel", f"Nobody=arm={drawings}")
    assert "Nobody" in shell.fails(2, *words)
    assert "NAME=FOLDER" in shell.fails(2, "new", tmp_path / "y.kage", "--cel", f"arm={drawings}")
