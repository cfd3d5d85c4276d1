"""Timesheets on the command line."""

from pathlib import Path

from kagezou.io.sheets.reading import read_timesheet
from tests.cli.projects import Shell, make_drawings


def test_a_sheet_is_written_once_and_replaced_only_when_told(shell: Shell, tmp_path: Path) -> None:
    project, sheet = tmp_path / "cut 12.kage", tmp_path / "cut 12.xdts"
    assert shell("new", project, "--character", f"A={make_drawings(tmp_path / 'A', 3)}") == 0
    assert shell.ok("timesheet", project, "-o", sheet) == f"{sheet}\n"
    assert read_timesheet(sheet).tracks[0].entries == ((0, "1"), (1, "2"), (2, "3"))
    before = sheet.read_bytes()
    said = shell.fails(4, "timesheet", project, "-o", sheet)
    assert said == f"{sheet}: it is there already; --force replaces it"
    assert sheet.read_bytes() == before
    sheet.write_bytes(b"something else")
    shell.ok("timesheet", project, "-o", sheet, "--force")
    assert sheet.read_bytes() == before


def test_other_formats_are_refused(shell: Shell, tmp_path: Path) -> None:
    project = tmp_path / "cut.kage"
    assert shell("new", project, "--character", f"A={make_drawings(tmp_path / 'A', 1)}") == 0
    assert "a timesheet is written as .xdts" in shell.fails(2, "timesheet", project, "-o", tmp_path / "cut.sts")
    assert not (tmp_path / "cut.sts").exists()
