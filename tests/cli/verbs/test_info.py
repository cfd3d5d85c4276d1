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
