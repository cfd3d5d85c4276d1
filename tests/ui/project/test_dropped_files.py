"""Files that are dropped on the window. No widgets."""

from pathlib import Path

from kagezou.ui.project.dropped_files import dropped_files_of


def test_dropped_files_are_sorted_out(tmp_path: Path) -> None:
    folder = tmp_path / "A"
    folder.mkdir()
    numbered = [tmp_path / f"walk_{n:03d}.png" for n in (1, 2, 3)]
    assert dropped_files_of([folder]).characters[0].path == folder
    assert dropped_files_of(numbered).pictures == tuple(numbered)
    assert [source.path for source in dropped_files_of(numbered[:1]).characters] == numbered[:1]
    assert dropped_files_of([tmp_path / "cut.kage", folder]).project == tmp_path / "cut.kage"
    assert dropped_files_of([tmp_path / "room.jpg"]).background == tmp_path / "room.jpg"
    assert dropped_files_of([tmp_path / "notes.txt"]).is_empty
