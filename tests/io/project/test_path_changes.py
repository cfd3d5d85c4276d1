"""Files of a project that another system spelled otherwise."""

import unicodedata
from pathlib import Path

from kagezou.document.edits import still
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure, Layer, Piece
from kagezou.geometry.box import Box
from kagezou.io.project.file import load, save
from kagezou.io.project.path_changes import as_on_disk


def cut(folder: Path) -> Document:
    cels = Cels(
        (Drawing("1", folder / "0001.png"), Drawing("2", folder / "0002.png")), (Exposure(1, 0), Exposure(2, 1))
    )
    return Document(
        Canvas(64, 48),
        behind=still(folder / "背.png"),
        layers=(Layer("layer-1", "A", cels, Box(0, 0, 9, 9)),),
        pieces=(Piece("piece-1", "street", source=folder / "Straße_é.obj"),),
    )


def test_a_project_finds_its_files_in_the_other_spelling(tmp_path: Path) -> None:
    there, other = (tmp_path / unicodedata.normalize(form, "ガール") for form in ("NFD", "NFC"))
    there.mkdir()
    for name in ("0001.png", "0002.png", "背.png", unicodedata.normalize("NFD", "Straße_é.obj")):
        (there / name).touch()
    project = tmp_path / unicodedata.normalize("NFD", "カット_ガ.kage")
    save(cut(other), project)
    found = load(project.with_name(unicodedata.normalize("NFC", project.name)))
    paths = [drawing.path for cels in (found.layers[0].cels, found.behind) for drawing in cels.drawings]
    source = found.pieces[0].source
    assert source is not None
    assert [path.name for path in paths] == ["0001.png", "0002.png", "背.png"]
    assert all(path.exists() for path in (*paths, source))


def test_a_document_whose_files_are_there_stays_the_same(tmp_path: Path) -> None:
    document = cut(tmp_path / "ガ")
    assert as_on_disk(document) is document
