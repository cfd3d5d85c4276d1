"""What files are understood to be, on the command line."""

from pathlib import Path
from typing import Any

import numpy as np

from kagezou.io.images.writing import write_rgba
from kagezou.io.sheets.timesheet import SheetTrack, Timesheet
from kagezou.io.sheets.xdts_writing import write_xdts
from tests.cli.projects import Shell, make_drawings
from tests.psd_files import Folder, Leaf, figure, write_psd

CUBE = "v 0 0 0\nv 2 0 0\nv 0 3 0\nv 0 0 4\nf 1 2 3\nf 1 2 4\n"


def only(shell: Shell, path: Path) -> Any:
    (found,) = shell.json("inspect", path, "--json")
    return found


def test_a_folder_is_its_characters_with_their_drawings_in_order(shell: Shell, tmp_path: Path) -> None:
    make_drawings(tmp_path / "A", 3)
    found = only(shell, tmp_path / "A")
    assert found["kind"] == "drawings"
    (character,) = found["characters"]
    assert (character["name"], character["width_px"], character["height_px"]) == ("A", 64, 48)
    assert [drawing["name"] for drawing in character["drawings"]] == ["1", "2", "3"]
    assert character["exposures"] == [[1, 0], [2, 1], [3, 2]]
    assert (character["channels"], character["bit_depth"], character["has_alpha"]) == (4, 8, True)
    words = shell.ok("inspect", tmp_path / "A")
    assert "character A: 3 drawings of 64 × 48 px, seen to frame 3: 1, 2, 3" in words


def test_what_only_pixels_tell_is_said(shell: Shell, tmp_path: Path) -> None:
    write_rgba(tmp_path / "1.png", np.full((8, 8, 4), 255, np.uint8))
    assert "alpha is full everywhere" in shell.ok("inspect", tmp_path / "1.png")


def test_a_psd_file_is_its_groups(shell: Shell, tmp_path: Path) -> None:
    path = write_psd(tmp_path / "a.psd", [Folder("B", [Leaf("1", figure(1)), Leaf("2", figure(2), is_visible=False)])])
    (character,) = only(shell, path)["characters"]
    assert [drawing["part"] for drawing in character["drawings"]] == ["B/1", "B/2"]


def test_a_timesheet_is_its_columns_and_where_their_drawings_lie(shell: Shell, tmp_path: Path) -> None:
    make_drawings(tmp_path / "A", 2)
    write_xdts(tmp_path / "c.xdts", Timesheet("cut", 12, (SheetTrack("A", ((0, "1"), (6, "2"), (9, None))),)))
    found = only(shell, tmp_path / "c.xdts")
    assert (found["kind"], found["name"], found["length_frames"]) == ("timesheet", "cut", 12)
    assert found["columns"] == [{"name": "A", "entries": [[0, "1"], [6, "2"], [9, None]]}]
    assert [each["column"] for each in found["drawings"]] == ["A"]


def test_a_set_is_its_triangles_and_cameras(shell: Shell, tmp_path: Path) -> None:
    (tmp_path / "set.obj").write_text(CUBE)
    found = only(shell, tmp_path / "set.obj")
    assert (found["kind"], found["triangles"], found["high"], found["cameras"]) == ("set", 2, [2.0, 3.0, 4.0], [])
    assert "set of 2 triangles, 2 × 3 × 4 units, y points up" in shell.ok("inspect", tmp_path / "set.obj")


def test_a_project_says_what_is_in_it(shell: Shell, project: Path) -> None:
    found = only(shell, project)
    assert (found["kind"], found["layers"], found["last_frame"]) == ("project", ["Hero"], 3)
    assert "layer Hero: 3 drawings" in shell.ok("inspect", project)


def test_the_others_are_inspected_when_one_cannot_be_read(shell: Shell, project: Path, tmp_path: Path) -> None:
    (tmp_path / "bad.png").write_bytes(b"\x89PNG\r\n\x1a\nnothing")
    assert shell("inspect", tmp_path / "bad.png", project, tmp_path / "not there") == 3
    bad, missing = shell.said.splitlines()
    assert bad.startswith(f"kagezou: {tmp_path / 'bad.png'}: ")
    assert missing == f"kagezou: {tmp_path / 'not there'}: it does not exist"
    assert "layer Hero" in shell.out


def test_a_file_of_no_known_kind_is_refused(shell: Shell, tmp_path: Path) -> None:
    (tmp_path / "a.txt").write_text("x")
    assert "'.txt' is not a picture format that can be read" in shell.fails(3, "inspect", tmp_path / "a.txt")
