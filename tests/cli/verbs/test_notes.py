"""Notes on the command line."""

from pathlib import Path

import pytest

from kagezou.document import review
from kagezou.document.address import Address
from kagezou.document.properties import OPACITY
from kagezou.io.project.file import load, save
from tests.cli.projects import Shell
from tests.export.small_cuts import cut


@pytest.fixture
def project(tmp_path: Path) -> Path:
    made = cut(tmp_path, count=2, length=48)
    address = Address(OPACITY, made.layers[0].id)
    made = review.add_note(review.add_note(made, address, 7, "Lighter", "Sato"), address, 9, "長く")
    made = review.answer_note(made, made.notes[0], "0.6?", "Kim")
    made = review.tick_note(made, made.notes[0], done=True)
    save(made, tmp_path / "a.kage")
    assert load(tmp_path / "a.kage").notes == made.notes, "a project keeps all of it"
    return tmp_path / "a.kage"


def test_they_are_listed(shell: Shell, project: Path) -> None:
    assert shell.ok("notes", project) == (
        "[x] 7 (0+07)  A · Opacity (Sato)\n    Lighter\n    > Kim: 0.6?\n\n[ ] 9 (0+09)  A · Opacity\n    長く\n"
    )
    assert shell.ok("notes", project, "--open") == "[ ] 9 (0+09)  A · Opacity\n    長く\n"


def test_what_is_in_a_project_names_them(shell: Shell, project: Path) -> None:
    assert "remarks     2, 1 of them open (kagezou notes)\n" in shell.ok("info", project)
    assert shell.json("info", project, "--json")["remarks"] == {"all": 2, "open": 1}


def test_they_become_a_table(shell: Shell, project: Path, tmp_path: Path) -> None:
    printed = shell.ok("notes", project, "--csv")
    assert printed.splitlines()[0] == "Frame,Time,Layer,Property,Note,Author,Answers,Done"
    assert printed.splitlines()[1] == "7,0+07,A,Opacity,Lighter,Sato,Kim: 0.6?,1"
    table = tmp_path / "notes.csv"
    assert shell.ok("notes", project, "--csv", "-o", table) == f"{table}\n"
    assert table.read_bytes().startswith(b"\xef\xbb\xbfFrame,Time,")
    assert shell.fails(4, "notes", project, "-o", tmp_path / "gone" / "notes.txt")


def test_programs_get_one_object(shell: Shell, project: Path) -> None:
    first, second = shell.json("notes", project, "--json")["notes"]
    assert first == {
        "frame": 7,
        "layer": "A",
        "property": "shadow.opacity",
        "text": "Lighter",
        "author": "Sato",
        "answers": [{"author": "Kim", "text": "0.6?"}],
        "done": True,
    }
    assert (second["text"], second["answers"], second["done"]) == ("長く", [], False)
    assert shell("notes", project, "--json", "--csv") == 2


def test_a_cut_without_notes_prints_nothing(shell: Shell, tmp_path: Path) -> None:
    save(cut(tmp_path, count=1, length=2), tmp_path / "b.kage")
    assert shell.ok("notes", tmp_path / "b.kage") == ""
