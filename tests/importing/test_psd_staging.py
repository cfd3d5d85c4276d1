"""PSD files on the stage: characters, background, timing and notes, in documents and in project files."""

from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from psd_tools import PSDImage

from kagezou.document.model import Drawing, Exposure
from kagezou.errors import InputProblem, ProjectProblem
from kagezou.extras import PSD
from kagezou.importing.sheet_project import document_of_sheet, timed_from_beside
from kagezou.importing.staging import CharacterSource, new_document, with_characters
from kagezou.io.project import file as project_file
from kagezou.io.project.path_mapping import Rule, with_mapped_paths
from kagezou.io.sheets.timesheet import SheetTrack, Timesheet
from kagezou.io.sheets.xdts_writing import write_xdts
from kagezou.picture_source import PicturePart
from tests.psd_files import SIZE, Folder, Leaf, block, figure, write_flat, write_psd

BODY = block(12, 24)


def cels(*names: str) -> list[Leaf]:
    return [Leaf(name, BODY, (20 + index, 10), is_visible=index == 0) for index, name in enumerate(names)]


@pytest.fixture
def cut(tmp_path: Path) -> Path:
    """A cut as a studio's PSD: a background, two characters and a hidden rough."""
    return write_psd(
        tmp_path / "c012.psd",
        [
            Leaf("BG", block(*SIZE, (90, 140, 200, 255))),
            Folder("A", cels("1", "2", "3")),
            Folder("B", cels("2", "1")),
            Leaf("rough", BODY, is_visible=False),
        ],
    )


def test_what_lies_among_cels_and_is_none_is_told(tmp_path: Path) -> None:
    file = write_psd(
        tmp_path / "c.psd",
        [
            Folder("A", [*cels("1", "2"), Leaf("memo", BODY), Leaf("old", BODY, is_visible=False)]),
            Folder("B", cels("1")),
        ],
    )
    imported = new_document([CharacterSource(None, file)])
    assert [(layer.name, len(layer.cels.drawings)) for layer in imported.document.layers] == [("A", 2), ("B", 1)]
    assert tuple(map(str, imported.notes)) == (f"{file}: left out, as they have no number: memo",)


def test_a_cut_comes_with_characters_background_and_length(cut: Path) -> None:
    imported = new_document([CharacterSource(None, cut)])
    document = imported.document
    assert (document.canvas.width_px, document.canvas.height_px, document.canvas.length_frames) == (*SIZE, 3)
    assert document.background == PicturePart(cut, "BG")
    a, b = document.layers
    assert (a.name, b.name) == ("A", "B")
    assert a.cels.drawings == tuple(Drawing(name, cut, f"A/{name}", SIZE) for name in "123")
    assert a.cels.exposures == (Exposure(1, 0), Exposure(2, 1), Exposure(3, 2))
    assert [drawing.part for drawing in b.cels.drawings] == ["B/1", "B/2"]
    assert tuple(map(str, imported.notes)) == (f"{cut}: left out, as they are hidden: rough",)


def test_a_name_is_that_of_the_one_character_and_the_head_of_several(tmp_path: Path, cut: Path) -> None:
    one = write_psd(tmp_path / "hero.psd", [Folder("A", cels("1", "2"))])
    imported = new_document([CharacterSource("Hero", one), CharacterSource("Duo", cut)])
    assert [layer.name for layer in imported.document.layers] == ["Hero", "Duo A", "Duo B"]


def test_a_second_background_is_left_out_and_told(tmp_path: Path, cut: Path) -> None:
    Image.new("RGB", SIZE).save(tmp_path / "sky.png")
    imported = new_document([CharacterSource(None, cut)], background=tmp_path / "sky.png")
    assert imported.document.background == tmp_path / "sky.png"
    assert f"{cut}: the layer 'BG' was left out, as there is a background already" in map(str, imported.notes)
    again = with_characters(new_document([CharacterSource(None, cut)]).document, [CharacterSource(None, cut)])
    assert again.document.background == PicturePart(cut, "BG")
    assert [layer.name for layer in again.document.layers] == ["A", "B", "A 2", "B 2"]


def test_what_is_named_like_a_background_and_is_not_opaque_is_a_drawing(tmp_path: Path) -> None:
    path = write_psd(tmp_path / "a.psd", [Leaf("LO", figure(1)), Leaf("Hero", BODY)])
    document = new_document([CharacterSource(None, path)]).document
    assert document.background is None
    assert [layer.name for layer in document.layers] == ["LO", "Hero"]


def test_a_psd_as_background_is_its_composite(tmp_path: Path, cut: Path) -> None:
    document = new_document([], background=cut).document
    assert document.background == cut
    assert not document.layers
    only = write_psd(tmp_path / "bg.psd", [Leaf("背景", block(*SIZE))])
    assert new_document([CharacterSource(None, only)]).document.background == PicturePart(only, "背景")


def test_a_flattened_file_is_one_drawing(tmp_path: Path) -> None:
    picture = Image.new("RGB", SIZE, (255, 255, 255))
    picture.paste((10, 20, 30), (20, 10, 40, 40))
    document = new_document([CharacterSource(None, write_flat(tmp_path / "hero.psd", picture))]).document
    assert document.layers[0].cels.drawings == (Drawing("hero", tmp_path / "hero.psd", size_px=SIZE),)
    assert document.layers[0].figure.width == 20


def test_a_file_in_which_nothing_is_to_be_seen_is_a_sentence(tmp_path: Path) -> None:
    path = write_psd(tmp_path / "a.psd", [Leaf("Hero", BODY, is_visible=False)])
    with pytest.raises(InputProblem, match="every layer in it is hidden or empty"):
        new_document([CharacterSource(None, path)])


def test_a_layer_without_a_name_is_kept_by_the_project(tmp_path: Path) -> None:
    document = new_document([CharacterSource(None, write_psd(tmp_path / "a.psd", [Leaf("", BODY)]))]).document
    project_file.save(document, tmp_path / "p.kage")
    assert project_file.load(tmp_path / "p.kage").layers == document.layers


def test_effects_that_are_not_drawn_are_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from kagezou.io.psd import file as psd_file

    undrawn = {"1": ("DropShadow",), "2": ("Stroke", "DropShadow"), "5": ("Curves",)}
    monkeypatch.setattr(psd_file, "undrawn_in", lambda layer: undrawn.get(layer.name, ()))
    path = write_psd(
        tmp_path / "a.psd", [Folder(name, cels(*names)) for name, names in (("A", "12"), ("B", "34"), ("C", "56"))]
    )
    missing = f"these are not drawn without a part that is missing ({PSD.how})"
    assert tuple(map(str, new_document([CharacterSource(None, path)]).notes)) == (
        "A: these are not drawn: DropShadow",
        f"A: {missing}: Stroke",
        f"C: {missing}: Curves",
    )


def test_a_timesheet_beside_it_finds_the_groups(cut: Path) -> None:
    sheet = Timesheet("", 30, (SheetTrack("A", ((0, "1"), (9, "3"))), SheetTrack("B", ((0, None), (4, "2")))))
    write_xdts(cut.with_suffix(".xdts"), sheet)
    source = CharacterSource(None, cut)
    beside = timed_from_beside(new_document([source]), [source])
    for imported in (document_of_sheet(cut.with_suffix(".xdts")), beside):
        document = imported.document
        assert document.canvas.length_frames == 30
        assert document.layers[0].cels.exposures == (Exposure(1, 0), Exposure(10, 2))
        assert document.layers[1].cels.exposures == (Exposure(1, None), Exposure(5, 1))
    assert f"timed by {cut.with_suffix('.xdts')}" in map(str, beside.notes)


def test_a_broken_timesheet_beside_it_is_a_note(cut: Path) -> None:
    cut.with_suffix(".xdts").write_text("nonsense")
    source = CharacterSource(None, cut)
    imported = timed_from_beside(new_document([source]), [source])
    assert len(imported.document.layers) == 2
    assert any("c012.xdts" in note for note in map(str, imported.notes))


def test_a_project_keeps_the_parts_and_older_ones_load(cut: Path, tmp_path: Path) -> None:
    document = new_document([CharacterSource(None, cut)]).document
    project_file.save(document, tmp_path / "p.kage")
    text = (tmp_path / "p.kage").read_text()
    assert '["1", "c012.psd", "A/1"]' in text
    assert '"background": ["c012.psd", "BG"]' in text
    assert project_file.load(tmp_path / "p.kage") == document
    (tmp_path / "old.kage").write_text(text.replace(', "A/1"]', "]").replace('["c012.psd", "BG"]', '"c012.psd"'))
    old = project_file.load(tmp_path / "old.kage")
    assert old.layers[0].cels.drawings[0] == Drawing("1", cut, size_px=SIZE)
    assert old.background == cut
    (tmp_path / "bad.kage").write_text(text.replace('"A/1"]', "7]"))
    with pytest.raises(ProjectProblem, match=r"drawings\[0\]\[2\]"):
        project_file.load(tmp_path / "bad.kage")


def test_parts_follow_path_mapping(cut: Path) -> None:
    document = with_mapped_paths(
        new_document([CharacterSource(None, cut)]).document, (Rule(type(Path())(cut.parent), Path("/farm")),)
    )
    assert document.background == PicturePart(Path("/farm/c012.psd"), "BG")
    assert document.layers[0].cels.drawings[0] == Drawing("1", Path("/farm/c012.psd"), "A/1", SIZE)


def test_the_figure_and_the_light_are_those_of_a_png(tmp_path: Path) -> None:
    from kagezou.io.images.writing import write_rgba

    canvas = np.zeros((SIZE[1], SIZE[0], 4), np.uint8)
    canvas[10:34, 20:32] = BODY
    write_rgba(tmp_path / "1.png", canvas)
    layered = new_document([CharacterSource("A", write_psd(tmp_path / "a.psd", [Folder("A", cels("1"))]))]).document
    single = new_document([CharacterSource("A", tmp_path / "1.png")]).document
    assert layered.tracks == single.tracks
    assert layered.layers[0].figure == single.layers[0].figure


def test_real_photoshop_animation(samples: Path) -> None:
    path = samples / "psd" / "agpsd" / "animation-frame.psd"
    assert not PSDImage.open(path).has_preview()
    document = new_document([CharacterSource(None, path)]).document
    assert [drawing.name for drawing in document.layers[0].cels.drawings] == ["1", "2"]


def test_a_group_of_named_cels_comes_as_one_figure(tmp_path: Path) -> None:
    parts = [Folder(name, [Leaf(number, BODY) for number in "12"]) for name in ("body", "arm")]
    imported = new_document([CharacterSource(None, write_psd(tmp_path / "c.psd", [Folder("Hero", parts)]))])
    body, arm = imported.document.layers
    assert (body.name, body.joins, arm.name, arm.joins) == ("Hero body", None, "Hero arm", body.id)
    assert any("one figure" in str(note) for note in imported.notes)
