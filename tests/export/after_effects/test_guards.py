"""What After Effects may have otherwise than Kagezou: set, read back, and said."""

from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

from kagezou.document.edits import add_layer, set_canvas
from kagezou.document.layer_marks import LABELS, LayerMarks
from kagezou.document.model import Cels, Document, Exposure
from kagezou.export.after_effects.labels import NUMBERS
from kagezou.geometry.box import Box
from kagezou.io.images.writing import write_rgba
from tests.export.after_effects.extendscript import NOTES, Run, run_edited, run_script
from tests.export.after_effects.hand_offs import handed_off, script_of
from tests.export.small_cuts import cut, drawings


@pytest.fixture
def document(tmp_path: Path) -> Document:
    return cut(tmp_path / "cut", count=4)


def built_with(document: Document, tmp_path: Path, settings: str, **options: object) -> Run:
    """Build the cut in After Effects with other settings; before it runs there is nothing of ours."""
    script = script_of(handed_off(document, tmp_path / "ae", **options))
    nothing = tmp_path / "nothing.jsx"
    nothing.write_text("")
    return run_edited(nothing, tmp_path / "ae.json", (settings, script))


def test_an_ordinary_project_is_built_without_a_word(document: Document, tmp_path: Path) -> None:
    assert built_with(document, tmp_path, "").tree["alerts"] == []
    run = built_with(document, tmp_path, "app.project.workingSpace = 'sRGB IEC61966-2.1';")
    assert run.tree["alerts"] == []


@pytest.mark.parametrize(
    ("settings", "said"),
    [
        ("app.project.linearBlending = true;", "The project blends colors using 1.0 gamma, so shadows look lighter"),
        (
            "app.project.workingSpace = 'sRGB IEC61966-2.1'; app.project.linearizeWorkingSpace = true;",
            "The project blends colors using 1.0 gamma",
        ),
        ("app.project.workingSpace = 'Rec.709 Gamma 2.4';", "The working space is Rec.709 Gamma 2.4, so colors"),
        (
            "$.global.ColorManagementSystem = { OCIO: 2 }; app.project.colorManagementSystem = 2;",
            "Colors are managed by OCIO",
        ),
        ("settings.refusesWorkArea = true;", "The work area of cut could not be set."),
    ],
)
def test_what_changes_the_picture_is_said(document: Document, tmp_path: Path, settings: str, said: str) -> None:
    run = built_with(document, tmp_path, settings)
    (note,) = run.summary()[NOTES]
    assert note.startswith(said)
    assert [each["name"] for each in run.tree["items"]].count("cut") == 2, "built all the same, and its folder"


def test_exr_needs_a_working_space(document: Document, tmp_path: Path) -> None:
    (note,) = built_with(document, tmp_path, "", format="exr").summary()[NOTES]
    assert note.startswith("EXR is linear light: choose sRGB as the working space and 32 bits per channel")
    managed = "app.project.workingSpace = 'sRGB IEC61966-2.1';"
    assert built_with(document, tmp_path, managed, format="exr").tree["alerts"] == []


def test_a_rate_that_is_kept_otherwise_is_said_where_it_would_be_seen(document: Document, tmp_path: Path) -> None:
    film = set_canvas(document, replace(document.canvas, frame_rate=Fraction(24000, 1001), length_frames=96))
    assert built_with(film, tmp_path, "").tree["alerts"] == []
    # As After Effects keeps it.
    kept = "Object.defineProperty(CompItem.prototype, 'frameDuration', { get() { return 1 / 23.976; } });"
    assert built_with(film, tmp_path, kept).tree["alerts"] == []
    (note,) = built_with(film, tmp_path, "settings.roundsRates = true;").summary()[NOTES]
    assert note == "cut has 24 frames a second instead of 23.976; shadows drift away until its last frame."


def test_pixels_are_square(tmp_path: Path) -> None:
    document = cut(tmp_path / "cut", count=1)
    write_rgba(document.layers[0].cels.drawings[0].path, np.full((48, 720, 4), 255, np.uint8))
    run = built_with(document, tmp_path, "")
    assert {each["aspect"] for each in run.tree["items"] if "aspect" in each} == {1}
    script = tmp_path / "ae" / "cut.jsx"
    again = run_edited(script, tmp_path / "ae.json", ("comp('cut').pixelAspect = 2;", script))
    assert again.left() == ["cut: pixel aspect ratio"]


def test_the_work_area_ends_with_the_composition(document: Document, tmp_path: Path) -> None:
    longer = replace(document, work_area=(2, 4))
    run = built_with(longer, tmp_path, "")
    assert run.item("cut", "CompItem")["workArea"] == pytest.approx([1 / 24, 3 / 24])


@pytest.mark.parametrize("first", [1, 101, 0])
def test_frames_bear_the_numbers_of_the_cut(document: Document, tmp_path: Path, first: int) -> None:
    numbered = set_canvas(document, replace(document.canvas, first_frame=first))
    run = built_with(numbered, tmp_path, "")
    assert run.item("cut", "CompItem")["first"] == first


def test_versions_without_a_first_frame_are_no_fault(document: Document, tmp_path: Path) -> None:
    older = "var made = app.project.items.addComp; var items = { addFolder: app.project.items.addFolder,"
    older += " addComp: (...words) => { var comp = made(...words); delete comp.displayStartFrame; return comp; } };"
    older += "Object.defineProperty(app.project, 'items', { get: () => items });"
    run = built_with(document, tmp_path, older)
    assert run.tree["alerts"] == []
    assert "first" not in run.item("cut", "CompItem")


def test_everything_lies_in_folders_of_its_own(document: Document, tmp_path: Path) -> None:
    run = built_with(document, tmp_path, "", mattes=("lit",))
    folders = {each["name"]: each["folder"] for each in run.tree["items"] if each["kind"] == "FolderItem"}
    assert folders == {
        "cut": "root",
        "Footage": "cut",
        "Characters": "Footage",
        "Shadows": "Footage",
        "Mattes": "Footage",
        "Guides": "cut",
    }
    solids = {each["name"]: each["folder"] for each in run.tree["items"] if each["kind"] == "SolidItem"}
    assert solids == {"White": "cut", "Ground line": "Guides", "Light": "Guides"}


def test_a_folder_of_solids_of_the_users_own_stays(document: Document, tmp_path: Path) -> None:
    own = "app.project.items.addComp('own', 64, 48, 1, 1, 24).layers.addSolid([1, 0, 0], 'mine', 8, 8, 1, 1);"
    run = built_with(document, tmp_path, own)
    assert run.item("mine")["folder"] == "Solids"
    assert run.item("Light", "SolidItem")["folder"] == "Guides"


def test_labels_are_those_of_the_list(document: Document, tmp_path: Path) -> None:
    assert NUMBERS.keys() == LABELS.keys()
    shown = drawings(tmp_path / "b", 1, "b")
    both = add_layer(document, "B", Cels(shown, (Exposure(1, 0),)), Box(12, 20, 20, 40))
    first, second = both.layers
    both = replace(both, layers=(replace(first, marks=LayerMarks(label="blue")), second))
    script = script_of(handed_off(both, tmp_path / "ae"))
    run = run_script(script, tmp_path / "ae.json")
    layers = [layer for each in run.tree["items"] if each["layers"] for layer in each["layers"]]
    labels = {layer["name"]: layer["label"] for layer in layers}
    assert [labels[name] for name in ("A", "A shadow", "A, B shadows", "B", "B shadow")] == [8, 8, 8, 5, 5]
    assert run.item("A shadow", "FootageItem")["label"] == 8
