"""What info says of the files of a project."""

import json
from pathlib import Path

from PIL import Image

from tests.cli.projects import Shell, make_drawings


def test_files_that_cannot_be_read_and_what_is_not_used_are_said(shell: Shell, tmp_path: Path) -> None:
    folder = make_drawings(tmp_path / "A", 3)
    assert shell("new", tmp_path / "a.kage", "--character", f"A={folder}") == 0
    assert shell.json("info", tmp_path / "a.kage", "--json")["notes"] == []
    first, second, third = sorted(folder.iterdir())
    second.write_bytes(second.read_bytes()[:60])
    third.unlink()
    with Image.open(first) as picture:
        film = [picture.copy(), picture.transpose(Image.Transpose.FLIP_LEFT_RIGHT)]
    film[0].save(first, save_all=True, append_images=film[1:])
    about = json.loads(shell.missing("info", tmp_path / "a.kage", "--json"))
    assert about["missing"] == [str(third)]
    assert about["notes"] == [
        f"{first}: of its 2 pictures the first alone is used",
        f"{second}: the file is cut short",
    ]
    assert f"note        {second}: the file is cut short" in shell.missing("info", tmp_path / "a.kage")


def test_files_outside_the_projects_folder_are_said_once_and_those_inside_are_not(shell: Shell, tmp_path: Path) -> None:
    """A path that leaves the project's folder, as a stranger's project may have it."""
    outside, inside = make_drawings(tmp_path / "elsewhere", 2), make_drawings(tmp_path / "cut" / "A", 2)
    project = tmp_path / "cut" / "a.kage"
    assert shell("new", project, "--character", f"A={inside}", "--character", f"B={outside}") == 0
    before = {path: path.read_bytes() for path in outside.iterdir()}
    words = f"2 files lie outside the project's folder and are only read, never written: {outside}"
    assert shell.json("info", project, "--json")["notes"] == [words]
    assert shell.ok("info", project).count("outside the project's folder") == 1
    assert shell.fails(2, "render", project, "-o", tmp_path, "--names", "elsewhere/walk_{frame:04d}", "--layer", "B")
    assert {path: path.read_bytes() for path in outside.iterdir()} == before


def test_a_folder_of_a_longer_name_is_outside(shell: Shell, tmp_path: Path) -> None:
    beside = make_drawings(tmp_path / "cut-evil", 1)
    project = tmp_path / "cut" / "a.kage"
    project.parent.mkdir()
    assert shell("new", project, "--character", f"A={beside}") == 0
    said = f"{beside / 'walk_0001.png'}: it lies outside the project's folder and is only read, never written"
    assert shell.json("info", project, "--json")["notes"] == [said]
