"""Which shadows unite over a whole cut, and the shadows of a look as frames of their own."""

from pathlib import Path

import numpy as np
import pytest

from kagezou.document.edits import add_layer, remove_layer
from kagezou.document.model import Cels, Document, Exposure
from kagezou.errors import UsageProblem
from kagezou.export.request import ExportRequest
from kagezou.export.sequences import sequences_of
from kagezou.export.uniting import cut_groups
from kagezou.geometry.box import Box
from kagezou.io.images.reading import read_cel
from tests.export.small_cuts import bytes_below, cut, drawings, export, with_key, with_values


@pytest.fixture
def three(tmp_path: Path) -> Document:
    """A, B and C with soft shadows of one look; B is seen on the first two frames alone."""
    document = cut(tmp_path / "a", 3)
    for name, exposures in (("B", (Exposure(1, 2), Exposure(3, None))), ("C", (Exposure(1, 1),))):
        document = add_layer(document, name, Cels(drawings(tmp_path / name, 3, name), exposures), Box(12, 20, 20, 40))
        document = with_values(document, **{f"layers__{name}__shadow__softness": 12.0})
    return document


def grouped(document: Document, *, of_one_color: bool = True) -> tuple[list[list[str]], list[list[str]]]:
    found = cut_groups(document, of_one_color=of_one_color)
    names = {layer.id: layer.name for layer in document.layers}
    together = [[names[each] for each in group.ids] for group in found.together()]
    return [[names[each] for each in group.ids] for group in found.groups], together


def test_equal_looks_are_one_group(three: Document) -> None:
    assert grouped(three) == ([["A", "B", "C"]], [])
    assert grouped(with_values(three, layers__A__shadow__opacity=0.2)) == ([["A"], ["B", "C"]], [])
    assert grouped(with_values(three, scene__shadows_unite=False)) == ([["A"], ["B"], ["C"]], [])


def test_only_frames_on_which_both_are_there_count(three: Document) -> None:
    """B differs on frame 3 alone, where its cel is empty."""
    document = with_key(with_key(three, "layers.B.shadow.blend", 1, "multiply"), "layers.B.shadow.blend", 3, "normal")
    assert grouped(document) == ([["A", "B", "C"]], [])
    document = with_key(with_key(three, "layers.C.shadow.blend", 1, "multiply"), "layers.C.shadow.blend", 3, "normal")
    assert grouped(document) == ([["A", "B", "C"]], [["A", "B", "C"]])
    assert [group.laid for group in cut_groups(document, of_one_color=True).groups] == [(True, False)]
    document = with_key(with_key(three, "scene.shadows_unite", 1, value=True), "scene.shadows_unite", 3, value=False)
    assert grouped(document) == ([["A", "B", "C"]], [["A", "B", "C"]])
    assert [group.laid for group in cut_groups(document, of_one_color=True).groups] == [(True,)]


def test_second_colours_are_one_group_where_they_may_be(three: Document) -> None:
    document = with_values(three, layers__B__shadow__tip_distance=20.0, layers__C__shadow__tip_distance=20.0)
    assert grouped(document) == ([["A"], ["B", "C"]], [["B", "C"]])
    assert grouped(document, of_one_color=False) == ([["A"], ["B", "C"]], [])


def test_shadows_that_change_places_are_handed_over_together(three: Document) -> None:
    """A and C unite, and B lies between them; while A is hidden B lies under C."""
    document = with_values(three, layers__B__shadow__color="#803010")
    for frame, seen in ((1, False), (2, True)):
        document = with_key(document, "layers.A.visible", frame, seen)
    assert grouped(document) == ([["A", "C"], ["B"]], []), "which of two that multiply is lower cannot be seen"
    document = with_values(document, layers__B__shadow__blend="normal")
    assert grouped(document) == ([["A", "B", "C"]], [["A", "B", "C"]])
    document = with_key(document, "layers.A.visible", 1, value=True)
    assert grouped(document) == ([["A", "C"], ["B"]], [])


def test_layers_that_never_meet_are_not_grouped(three: Document) -> None:
    document = with_key(with_key(three, "layers.A.visible", 1, value=False), "layers.A.visible", 3, value=True)
    document = remove_layer(document, document.layers[2].id)
    assert grouped(document) == ([["A"], ["B"]], [])


def test_the_shadows_of_a_look_as_one_beside_those_of_the_layers(three: Document, tmp_path: Path) -> None:
    export(three, tmp_path / "out", united=True)
    folders = sorted(path.name for path in (tmp_path / "out").iterdir() if path.is_dir())
    assert folders == ["A_shadow", "B_shadow", "C_shadow", "shadows"]
    for frame in (1, 3):
        alone = [read_cel(tmp_path / f"out/{each}_shadow/{each}_shadow_000{frame}.png").rgba for each in "ABC"]
        united = read_cel(tmp_path / f"out/shadows/shadows_000{frame}.png").rgba
        assert np.array_equal(united[..., 3], np.max(alone, 0)[..., 3])
        assert np.array_equal(united[..., :3], alone[0][..., :3])


def test_one_that_is_there_alone_is_drawn_once_for_both(three: Document, tmp_path: Path) -> None:
    document = with_values(three, layers__B__visible=False, layers__C__visible=False)
    summary = export(document, tmp_path / "out", united=True)
    assert (summary.files, summary.drawn) == (6, 3)
    found = bytes_below(tmp_path / "out")
    assert found["shadows/shadows_0002.png"] == found["A_shadow/A_shadow_0002.png"]


def test_several_looks_are_called_by_their_lowest_layers(three: Document, tmp_path: Path) -> None:
    document = with_values(three, layers__B__shadow__color="#204020")
    request = ExportRequest(tmp_path, united=True)
    assert [each.label for each in sequences_of(document, request)][3:] == ["A_shadows", "B_shadows"]
    chosen = ExportRequest(tmp_path, united=True, layers=("C",))
    assert [each.label for each in sequences_of(document, chosen)] == ["C_shadow", "shadows"]


def test_two_colours_as_one(three: Document, tmp_path: Path) -> None:
    tips = {f"layers__{name}__shadow__tip_distance": 25.0 for name in "ABC"}
    colors = {f"layers__{name}__shadow__tip_color": "#D05010" for name in "ABC"}
    export(with_values(three, **tips, **colors), tmp_path / "out", united=True, frames=(1,))
    alone = [read_cel(tmp_path / f"out/{each}_shadow/{each}_shadow_0001.png").rgba / 255 for each in "ABC"]
    united = read_cel(tmp_path / "out/shadows/shadows_0001.png").rgba / 255
    taken = [each[..., 3:] * (1 - each[..., :3]) for each in (*alone, united)]
    assert np.abs(taken[3] - np.max(taken[:3], 0)).max() < 0.012


def test_what_goes_together_is_said_once_and_is_the_picture(three: Document, tmp_path: Path) -> None:
    document = with_key(with_key(three, "layers.C.shadow.blend", 1, "multiply"), "layers.C.shadow.blend", 3, "normal")
    summary = export(document, tmp_path / "out", united=True, frames=(1,))
    (note,) = map(str, summary.notes)
    assert note.startswith("the shadows of 'A', 'B', 'C' are handed over as one")
    assert [folder.name for folder in summary.folders][3:] == ["shadows", "shadows_normal"]
    assert export(document, tmp_path / "more", frames=(1,)).notes == ()


def test_layered_frames_hold_it_already(three: Document, tmp_path: Path) -> None:
    with pytest.raises(UsageProblem, match="ask for one of the two"):
        export(three, tmp_path / "out", united=True, layered=True, format="psd")
