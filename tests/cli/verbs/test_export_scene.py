"""export-scene as a person or another program calls it."""

from pathlib import Path

import pytest

from kagezou.cli.verbs.export_scene import PROGRAMS
from kagezou.export.exporters.table import SCENES
from tests.cli.projects import Shell


def test_every_scene_can_be_asked_for() -> None:
    assert tuple(each.program for each in SCENES) == PROGRAMS


@pytest.mark.parametrize("program", PROGRAMS)
def test_it_writes_a_scene_and_names_it(program: str, shell: Shell, project: Path, tmp_path: Path) -> None:
    assert shell("export-scene", project, "--for", program, "-o", tmp_path / program) == 0
    told = [line for line in shell.said.splitlines() if "nothing fills the canvas" in line]
    assert len(told) == (program in ("blender", "fusion")), "the project has no background"
    printed = Path(shell.out.strip())
    assert printed.is_file()
    assert printed.parent == tmp_path / program
    assert list((tmp_path / program / f"{program}_layers").rglob("*.png"))


def test_it_tells_programs_what_was_done(shell: Shell, project: Path, tmp_path: Path) -> None:
    words = ("export-scene", project, "--for", "oca", "-o", tmp_path / "out", "--name", "影", "--depth", 16, "--json")
    report = shell.json(*words)
    assert report["scene"] == str(tmp_path / "out" / "影.oca")
    assert report["files"] == report["written"] == len(list((tmp_path / "out").rglob("*.png"))) + 1


def test_it_refuses_in_one_sentence(shell: Shell, project: Path, tmp_path: Path) -> None:
    assert "maya" in shell.fails(2, "export-scene", project, "--for", "maya", "-o", tmp_path / "out")
    (tmp_path / "file").write_bytes(b"")
    shell.fails(4, "export-scene", project, "--for", "nuke", "-o", tmp_path / "file")
