"""Files that are dropped on the window. No widgets."""

from pathlib import Path

from kagezou.ui.project.dropped_files import dropped_files_of, whole_sequence


def test_dropped_files_are_sorted_out(tmp_path: Path) -> None:
    folder = tmp_path / "A"
    folder.mkdir()
    numbered = [tmp_path / f"walk_{n:03d}.png" for n in (1, 2, 3)]
    assert dropped_files_of([folder]).characters[0].path == folder
    assert [source.path for source in dropped_files_of(numbered).characters] == [tmp_path / "walk_#.png"]
    assert [source.path for source in dropped_files_of(numbered[:1]).characters] == numbered[:1]
    assert dropped_files_of([tmp_path / "cut.kage", folder]).project == tmp_path / "cut.kage"
    assert dropped_files_of([tmp_path / "room.jpg"]).background == tmp_path / "room.jpg"
    assert dropped_files_of([tmp_path / "notes.txt"]).is_empty


def test_a_numbered_picture_stands_for_its_sequence() -> None:
    assert whole_sequence(Path("/c/A0001.png")) == Path("/c/A#.png")
    assert whole_sequence(Path("/c/A_12a.tga")) == Path("/c/A_#a.tga")
    assert whole_sequence(Path("/c/hero.png")) == Path("/c/hero.png")
