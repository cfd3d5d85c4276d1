"""PSD files on the command line."""

import json
from pathlib import Path

import pytest

from kagezou import __main__ as front
from kagezou.io.sheets.timesheet import SheetTrack, Timesheet
from kagezou.io.sheets.xdts_writing import write_xdts
from tests.cli.projects import Shell
from tests.psd_files import SIZE, Folder, Leaf, block, write_psd


@pytest.fixture
def psd(tmp_path: Path) -> Path:
    cels = [Leaf(str(number), block(12, 24), (18 + number, 10), is_visible=number == 1) for number in (1, 2, 3)]
    return write_psd(tmp_path / "影.psd", [Leaf("BG", block(*SIZE)), Folder("A", cels)])


def test_a_character_is_the_cels_of_a_file(shell: Shell, tmp_path: Path, psd: Path) -> None:
    shell.ok("new", "--no-feet", tmp_path / "p.kage", "--character", f"Hero={psd}")
    layers = json.loads((tmp_path / "p.kage").read_text(encoding="utf-8"))["layers"]
    assert [(layer["name"], len(layer["drawings"])) for layer in layers] == [("Hero", 3)]
    assert shell.json("render", tmp_path / "p.kage", "-o", tmp_path / "out", "--json")["written"] == 3
    assert shell.json("info", tmp_path / "p.kage", "--json")["background"] == str(psd)


def test_layers_that_are_gone_are_told(shell: Shell, tmp_path: Path, psd: Path) -> None:
    shell.ok("new", "--no-feet", tmp_path / "p.kage", "--psd", psd)
    assert shell.json("info", tmp_path / "p.kage", "--json")["missing"] == []
    write_psd(psd, [Leaf("BG", block(*SIZE)), Folder("A", [Leaf("1", block(12, 24))])])
    assert shell("info", tmp_path / "p.kage", "--json") == 3, "a script need not read the list to stop"
    assert json.loads(shell.out)["missing"] == [f"{psd} (A/2)", f"{psd} (A/3)"]
    assert shell("info", tmp_path / "p.kage") == 3
    assert "missing     " in shell.out
    assert "2 drawings are missing" in shell.fails(3, "render", tmp_path / "p.kage", "-o", tmp_path / "out")
    psd.unlink()
    assert shell("info", tmp_path / "p.kage", "--json") == 3
    assert json.loads(shell.out)["missing"] == [str(psd)]


def test_a_whole_file_is_timed_by_the_sheet_of_its_name(shell: Shell, tmp_path: Path, psd: Path) -> None:
    write_xdts(psd.with_suffix(".xdts"), Timesheet("", 20, (SheetTrack("A", ((0, "1"), (9, "3"))),)))
    assert shell("new", tmp_path / "p.kage", "--psd", psd) == 0
    assert "timed by" in shell.said
    made = json.loads((tmp_path / "p.kage").read_text(encoding="utf-8"))
    assert made["canvas"]["length_frames"] == 20
    assert made["layers"][0]["exposures"] == [[1, 0], [10, 2]]


def test_a_file_alone_opens_the_window(monkeypatch: pytest.MonkeyPatch, psd: Path) -> None:
    opened: list[Path | None] = []
    monkeypatch.setattr(front, "open_window", opened.append)
    front.main([str(psd)])
    assert opened == [psd]


def test_a_broken_file_is_one_line(shell: Shell, tmp_path: Path, psd: Path) -> None:
    psd.write_bytes(psd.read_bytes()[:600])
    assert "影.psd: the file is damaged" in shell.fails(3, "new", tmp_path / "p.kage", "--psd", psd)
    assert not (tmp_path / "p.kage").exists()
