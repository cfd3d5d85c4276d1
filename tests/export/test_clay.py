"""Imported sets drawn as clay: a layer of their own wherever the picture goes."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from kagezou.document.edits import set_background
from kagezou.document.model import Document
from kagezou.document.set_pieces import add_piece
from kagezou.export.choices import ExportChoices, Place
from kagezou.export.exporters.hand_off import HAND_OFF
from kagezou.export.request import CLAY
from kagezou.io.images.reading import read_cel
from kagezou.io.images.writing import write_rgba
from kagezou.io.psd.file import psd_tree
from tests.export.after_effects.extendscript import run_edited
from tests.export.after_effects.hand_offs import built, furthest, handed_off, names, script_of
from tests.export.small_cuts import HEIGHT, WIDTH, cut, export, with_key, with_values

CRATE = "".join(f"v {x} {y} {z}\n" for x in (-8, 8) for y in (0, 16) for z in (-8, 8)) + "".join(
    f"f {each}\n" for each in ("1 2 4 3", "5 7 8 6", "1 5 6 2", "3 4 8 7", "1 3 7 5", "2 6 8 4")
)


@pytest.fixture
def sets(tmp_path: Path) -> Document:
    """A block, and a crate beside it that turns, over a plain picture that does not fill the canvas."""
    (tmp_path / "crate.obj").write_text(CRATE)
    document = cut(tmp_path / "in", 3)
    paper = np.full((HEIGHT, WIDTH, 4), (120, 180, 90, 255), np.uint8)
    paper[:, 44:, 3] = 0
    write_rgba(tmp_path / "paper.png", paper)
    document = set_background(document, tmp_path / "paper.png")
    values = {"scale": 1.0, "position": (44.0, 38.0), "display": "clay"}
    document = add_piece(document, "crate", "mesh", values, tmp_path / "crate.obj")
    return with_key(with_key(document, "set.crate.angle", 1, 10.0), "set.crate.angle", 3, 50.0)


def alpha(folder: Path, frame: int, name: str = "set_clay") -> np.ndarray:
    return np.asarray(read_cel(folder / f"{name}/{name}_{frame:04d}.png", white_is_clear=False).rgba[..., 3])


def test_it_has_a_folder_of_its_own(sets: Document, tmp_path: Path) -> None:
    summary = export(sets, tmp_path / "out", composite=True)
    assert [folder.name for folder in summary.folders] == ["A_shadow", "set_clay", "composite"]
    assert alpha(tmp_path / "out", 1).max() == 255
    assert (alpha(tmp_path / "out", 1) != alpha(tmp_path / "out", 3)).any(), "it turns"
    under = with_values(sets, set__crate__under=True)
    assert [folder.name for folder in export(under, tmp_path / "under").folders] == ["A_shadow", "set_clay_under"]
    assert [folder.name for folder in export(sets, tmp_path / "only", only=CLAY).folders] == ["set_clay"]


@pytest.mark.parametrize("display", ["none", "wireframe"])
def test_wireframes_are_for_the_window(sets: Document, tmp_path: Path, display: str) -> None:
    document = with_values(sets, set__crate__display=display)
    assert [folder.name for folder in export(document, tmp_path / "out").folders] == ["A_shadow"]
    run = built(handed_off(document, tmp_path / "ae"), tmp_path)
    assert names(run, "cut")[:3] == ["Background", "A shadow", "A"]


def test_frames_without_it_are_empty_and_the_sequence_has_no_gap(sets: Document, tmp_path: Path) -> None:
    document = with_key(with_key(sets, "set.crate.display", 1, "clay"), "set.crate.display", 2, "wireframe")
    document = with_key(document, "set.crate.display", 3, "clay")
    export(document, tmp_path / "out")
    assert [bool(alpha(tmp_path / "out", frame).any()) for frame in (1, 2, 3)] == [True, False, True]
    both = with_key(with_key(sets, "set.crate.under", 1, value=False), "set.crate.under", 3, value=True)
    export(both, tmp_path / "both")
    seen = [
        (bool(alpha(tmp_path / "both", frame).any()), bool(alpha(tmp_path / "both", frame, "set_clay_under").any()))
        for frame in (1, 2, 3)
    ]
    assert seen == [(True, False), (True, False), (False, True)]


def test_one_that_stays_is_drawn_once_and_one_that_hides_it_draws_it_anew(sets: Document, tmp_path: Path) -> None:
    still = with_values(sets, set__crate__angle=10.0)
    assert export(still, tmp_path / "out", only=CLAY).drawn == 1
    assert export(still, tmp_path / "out", only=CLAY, skip_existing=True).drawn == 0
    values = {"scale": 0.7, "position": (44.0, 42.0), "display": "none"}
    hidden = add_piece(still, "in front", "mesh", values, tmp_path / "crate.obj")
    before = alpha(tmp_path / "out", 1)
    assert export(hidden, tmp_path / "out", only=CLAY, skip_existing=True).drawn == 1
    assert (alpha(tmp_path / "out", 1) != before).any()
    export(still, tmp_path / "c", composite=True)
    assert export(hidden, tmp_path / "c", composite=True, skip_existing=True).drawn > 1


def test_layers_that_are_chosen_stand_without_it(sets: Document, tmp_path: Path) -> None:
    export(sets, tmp_path / "out", layered=True, format="psd", layers=("A",), frames=(1,))
    path = tmp_path / "out/layered/layered_0001.psd"
    assert [node.name for node in psd_tree(path).layers] == ["A_shadow", "A"]
    merged = read_cel(path).rgba
    assert not merged[20:36, 50:, 3].any(), "nor does the merged picture have it"
    assert [folder.name for folder in export(sets, tmp_path / "more", layers=("A",)).folders] == ["A_shadow"]


def test_layered_frames_have_it_where_it_is_drawn(sets: Document, tmp_path: Path) -> None:
    document = with_key(with_key(sets, "set.crate.under", 1, value=False), "set.crate.under", 3, value=True)
    export(document, tmp_path / "out", layered=True, format="psd")
    for frame, (under, over) in ((1, (True, False)), (3, (False, True))):
        found = psd_tree(tmp_path / f"out/layered/layered_{frame:04d}.psd").layers
        assert [node.name for node in found] == ["set_clay_under", "background", "set_clay", "A_shadow", "A"]
        assert [found[0].is_empty, found[2].is_empty] == [under, over]


@pytest.mark.parametrize("per_drawing", [False, True])
def test_after_effects_lays_it_below_or_over_the_background(
    sets: Document, tmp_path: Path, *, per_drawing: bool
) -> None:
    document = with_key(with_key(sets, "set.crate.under", 1, value=False), "set.crate.under", 3, value=True)
    run = built(handed_off(document, tmp_path / "ae", per_drawing=per_drawing), tmp_path)
    wanted = ["Set clay under background", "Background", "Set clay", "A shadow", "A"]
    assert names(run, "cut")[:5] == wanted
    assert {run.item(name, "FootageItem")["folder"] for name in (wanted[0], wanted[2])} == {"Set"}
    assert furthest(run, document, tmp_path) <= 1


def test_one_that_no_longer_is_drawn_is_switched_off(sets: Document, tmp_path: Path) -> None:
    first, second = (
        script_of(handed_off(each, tmp_path / name))
        for each, name in ((sets, "1"), (with_values(sets, set__crate__display="none"), "2"))
    )
    run = run_edited(first, tmp_path / "ae.json", ("", second))
    assert run.layer("cut", "Set clay")["enabled"] is False
    assert run.layer("cut", "Background")["enabled"] is True


def test_the_preview_of_a_hand_off_names_its_folder(sets: Document, tmp_path: Path) -> None:
    place = Place(tmp_path, tmp_path / "cut.kage", "cut")
    lines = HAND_OFF.preview(sets, ExportChoices(format="png"), place)
    assert "set/set_clay/  3 × .png" in lines
    bare = replace(sets, pieces=())
    assert not any("set_clay" in line for line in HAND_OFF.preview(bare, ExportChoices(format="png"), place))
