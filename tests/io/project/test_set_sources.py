"""The file of an imported set in a project: named as drawings are, and nothing of it where there is none."""

import json
from dataclasses import replace
from pathlib import Path

import pytest

from kagezou.document.model import Canvas, Document
from kagezou.document.set_pieces import add_piece, copy_piece
from kagezou.errors import ProjectProblem
from kagezou.geometry.sets.measures import PieceKind
from kagezou.io.project.file import load, save


def with_street(folder: Path) -> Document:
    return add_piece(
        Document(Canvas(320, 200)), "street", PieceKind.MESH, {"scale": 12.5, "up": "z"}, folder / "sets" / "a.glb"
    )


def test_a_set_is_named_relative_to_its_project_and_moves_with_it(tmp_path: Path) -> None:
    (tmp_path / "old").mkdir()
    document = with_street(tmp_path / "old")
    save(document, tmp_path / "old" / "cut.kage")
    (piece,) = json.loads((tmp_path / "old" / "cut.kage").read_text())["set"]
    assert piece["source"] == "sets/a.glb"
    (tmp_path / "old").rename(tmp_path / "new")
    assert load(tmp_path / "new" / "cut.kage") == with_street(tmp_path / "new")


def test_a_piece_without_a_file_says_nothing_of_one(tmp_path: Path) -> None:
    document = add_piece(Document(Canvas(320, 200)), "back", "wall")
    save(document, tmp_path / "cut.kage")
    (piece,) = json.loads((tmp_path / "cut.kage").read_text())["set"]
    assert "source" not in piece
    assert load(tmp_path / "cut.kage") == document


@pytest.mark.parametrize("source", ["//server/share/a.glb", "", "a\0.glb"])
def test_a_set_on_the_network_or_nowhere_is_refused(tmp_path: Path, source: str) -> None:
    save(with_street(tmp_path), tmp_path / "cut.kage")
    tree = json.loads((tmp_path / "cut.kage").read_text())
    tree["set"][0]["source"] = source
    (tmp_path / "cut.kage").write_text(json.dumps(tree))
    with pytest.raises(ProjectProblem, match=r"set.*source"):
        load(tmp_path / "cut.kage")


def test_a_copy_is_of_the_same_file(tmp_path: Path) -> None:
    document = with_street(tmp_path)
    first, second = copy_piece(document, document.pieces[0].id).pieces
    assert second == replace(first, id=second.id, name="street 2")
