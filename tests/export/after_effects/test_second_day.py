"""What a user does in After Effects between two runs of the script: each thing, what comes of it, and what is said."""

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import pytest

from kagezou.document import review
from kagezou.document.edits import add_layer, set_background
from kagezou.document.model import Document, Marker
from tests.export.after_effects.extendscript import (
    CHANGED,
    DELETED,
    FOREIGN,
    LEFT,
    NEW,
    NOTES,
    Run,
    property_of,
    run_edited,
)
from tests.export.after_effects.hand_offs import handed_off, script_of
from tests.export.small_cuts import cut, drawings, with_values

OPACITY = ("ADBE Transform Group", "ADBE Opacity")
FOLLOWED = ["A shadow: opacity"]
"""What Kagezou changed meanwhile: the shadow became darker."""
COPIES = "Copies of the composition were brought up to date as well: {}"
TOP = (
    "var shadow = layerOf('cut', 'A shadow'), main = comp('cut');"
    "var item = (name) => app.project.all.find((each) => each.name === name);"
)


@dataclass(frozen=True)
class Day:
    """One row.

    Parameters
    ----------
    edit
        What the user does: JavaScript over ``main``, ``shadow`` and ``item(name)``.
    shadows
        Where the shadow lies afterwards, and its opacity there.
    said
        The parts of the summary.
    sees
        What else is to be so.
    """

    edit: str
    shadows: list[tuple[str, float]] = field(default_factory=lambda: [("cut", 90)])
    said: dict[str, list[str]] = field(default_factory=lambda: {CHANGED: FOLLOWED})
    sees: Callable[[Run], bool] = lambda _run: True


def left(*lines: str, changed: list[str] | None = None) -> dict[str, list[str]]:
    followed = FOLLOWED if changed is None else changed
    return ({CHANGED: followed} if followed else {}) | {LEFT: list(lines)}


DAYS = {
    "nothing": Day(""),
    "rename layer": Day("shadow.name = 'mine';", said=left("mine: name", changed=["mine: opacity"])),
    "rename compositions and folders": Day(
        "app.project.all.filter((each) => !each.mainSource).forEach((each) => { each.name = 'my ' + each.name; });",
        [("my cut", 90)],
        sees=lambda run: [each["kind"] for each in run.tree["items"]].count("FootageItem") == 3,
    ),
    "words of one's own in comments": Day(
        "var all = app.project.all.concat(main.all);"
        "all.forEach((each) => { each.comment = 'mine ' + each.comment + ' too, #1=2'; });",
        sees=lambda run: run.layer("cut", "A shadow")["comment"].endswith(" too, #1=2"),
    ),
    "reorder": Day(
        "shadow.moveToEnd();", sees=lambda run: run.item("cut", "CompItem")["layers"][-1]["name"] == "A shadow"
    ),
    "move": Day("shadow.transform['ADBE Position'].value = [3, 4];", said=left("A shadow: transform")),
    "scale and turn": Day(
        "shadow.transform['ADBE Scale'].value = [50, 50]; shadow.transform['ADBE Rotate Z'].value = 9;",
        said=left("A shadow: transform"),
    ),
    "parent": Day(
        "var own = main.layers.addNull(1); own.name = 'own';"
        "own.transform['ADBE Position'].value = [5, 6]; shadow.parent = own;",
        said=left("A shadow: transform"),
        sees=lambda run: run.layer("cut", "A shadow")["parent"] == "own",
    ),
    "opacity": Day(
        "shadow.transform['ADBE Opacity'].value = 33;", [("cut", 33)], left("A shadow: opacity", changed=[])
    ),
    "blending mode": Day(
        "shadow.blendingMode = BlendingMode.SCREEN;",
        said=left("A shadow: blending mode"),
        sees=lambda run: run.layer("cut", "A shadow")["blend"] == "SCREEN",
    ),
    "time remapping": Day(
        "layerOf('cut', 'A')._groups['ADBE Time Remapping'].keys[1].value = 0;", said=left("A: time remapping")
    ),
    "label": Day("shadow.label = 9;", sees=lambda run: run.layer("cut", "A shadow")["label"] == 9),
    "trim": Day(
        "shadow.inPoint = 1 / 24; shadow.outPoint = 3 / 24;",
        said=left("A shadow: in point, out point"),
        sees=lambda run: run.layer("cut", "A shadow")["inPoint"] == 1 / 24,
    ),
    "switch off": Day("shadow.enabled = false;", sees=lambda run: not run.layer("cut", "A shadow")["enabled"]),
    "add effects and masks": Day(
        "shadow._groups['ADBE Effect Parade'].addProperty('ADBE Tint'); var name = 'one';"
        "shadow._groups['ADBE Mask Parade'].put(shadow._groups['ADBE Marker']);",
        sees=lambda run: (
            list(run.layer("cut", "A shadow")["groups"]["ADBE Effect Parade"]["children"]) == ["ADBE Tint"]
        ),
    ),
    "move items to other folders": Day(
        "app.project.all.forEach((each) => { each.parentFolder = app.project.rootFolder; });",
        sees=lambda run: {each["folder"] for each in run.tree["items"]} == {"root"},
    ),
    "copy and paste into another composition": Day(
        "var own = app.project.items.addComp('own', 64, 48, 1, 1, 24); shadow.duplicate().moveToComp(own);",
        [("cut", 90), ("own", 90)],
        {CHANGED: [*FOLLOWED, "own / A shadow: opacity"]},
    ),
    "lock": Day("shadow.locked = true; layerOf('cut', 'Light').locked = true; layerOf('cut', 'A').locked = true;"),
    "lay into space": Day("shadow.threeDLayer = true;", said=left("A shadow: transform")),
    "track matte": Day(
        "var matte = main.layers.addSolid([1, 1, 1], 'matte', 64, 48, 1, 1); matte.moveBefore(shadow);"
        "shadow.hasTrackMatte = true;",
    ),
    "slip": Day("shadow.startTime = 1 / 24;", said=left("A shadow: start time")),
    "split": Day("shadow.split(2 / 24);", [("cut", 90), ("cut", 90)], left("A shadow: out point, in point")),
    "duplicate layer": Day("shadow.duplicate();", [("cut", 90), ("cut", 90)]),
    "delete layer": Day("shadow.remove();", [], {DELETED: ["A shadow"]}),
    "delete layer and hold Shift": Day(
        "shadow.remove(); keyboard.shiftKey = true;", [("cut", 90)], {NEW: ["A shadow"]}
    ),
    "delete footage": Day(
        "item('A shadow').remove();",
        [],
        {DELETED: ["A shadow"]},
        sees=lambda run: "A shadow" not in [each["name"] for each in run.tree["items"]],
    ),
    "delete a folder and hold Shift": Day(
        "item('Shadows').remove(); keyboard.shiftKey = true;", [("cut", 90)], {NEW: ["A shadow"]}
    ),
    "delete guide": Day("layerOf('cut', 'Light').remove();", said={CHANGED: FOLLOWED, DELETED: ["Light"]}),
    "delete marker": Day(
        "main.markerProperty.keys = [];",
        said=left("cut: markers"),
        sees=lambda run: not run.item("cut", "CompItem")["markers"],
    ),
    "delete composition": Day(
        "main.remove();",
        [("cut", 90)],
        {NOTES: ["Nothing was left of the composition cut, so it was built anew."]},
        sees=lambda run: len(run.item("cut", "CompItem")["layers"]) == 5,
    ),
    "take the comment away": Day("shadow.comment = '';", [("cut", 60)], {DELETED: ["A shadow"]}),
    "precompose, moving all attributes": Day(
        "main.layers.precompose([shadow.index, layerOf('cut', 'A').index], 'pre', true);",
        [("pre", 90)],
        {CHANGED: ["pre / A shadow: opacity"]},
    ),
    "precompose, leaving all attributes": Day(
        "main.layers.precompose([shadow.index], 'pre', false);",
        sees=lambda run: (
            [run.layer("cut", "A shadow")["source"], run.layer("pre", "A shadow")["source"]] == ["pre", "A shadow"]
        ),
    ),
    "precompose what was precomposed": Day(
        "main.layers.precompose([shadow.index], 'pre', false);"
        "main.layers.precompose([shadow.index], 'all', true);"
        "main.layers.precompose([layerOf('cut', 'all').index], 'deep', true);",
        [("all", 90)],
        {CHANGED: ["all / A shadow: opacity"]},
    ),
    "precompose everything": Day(
        "main.layers.precompose(main.all.map((each) => each.index), 'pre', true);",
        [("pre", 90)],
        {CHANGED: ["pre / A shadow: opacity"]},
    ),
    "precompose and delete the composition": Day(
        "main.layers.precompose([shadow.index], 'pre', true); main.remove();",
        [("pre", 90)],
        {
            CHANGED: ["pre / A shadow: opacity"],
            DELETED: ["Background", "A", "Ground line", "Light"],
            NOTES: [
                "The composition cut was deleted, so it was not built again; "
                "its layers elsewhere were brought up to date."
            ],
        },
    ),
    "cut and paste into another composition": Day(
        "var own = app.project.items.addComp('own', 64, 48, 1, 1, 24); shadow.moveToComp(own);",
        [("own", 90)],
        {CHANGED: ["own / A shadow: opacity"]},
    ),
    "duplicate composition": Day(
        "main.duplicate();",
        [("cut", 90), ("cut 2", 90)],
        {CHANGED: [*FOLLOWED, "cut 2 / A shadow: opacity"], NOTES: [COPIES.format("cut 2")]},
    ),
    "duplicate composition and delete in the copy": Day(
        "main.duplicate().all.find((each) => each.name === 'A shadow').remove();",
        said={CHANGED: FOLLOWED, NOTES: [COPIES.format("cut 2")]},
    ),
    "duplicate composition and delete the first": Day(
        "main.duplicate(); main.remove();", [("cut 2", 90)], {CHANGED: FOLLOWED}
    ),
    "replace the layer's footage": Day("shadow.replaceSource(item('A'));", [("cut", 60)], {FOREIGN: ["A shadow"]}),
    "replace footage": Day(
        "var graded = new File(item('A').mainSource.file.fsName); item('A shadow').replaceWithSequence(graded, false);",
        said=left("A shadow: file"),
        sees=lambda run: Path(run.item("A shadow", "FootageItem")["file"]).name == "A_0001.png",
    ),
    "interpret footage": Day(
        "item('A shadow').mainSource.alphaMode = AlphaMode.IGNORE;",
        said=left("A shadow: interpretation"),
        sees=lambda run: run.item("A shadow", "FootageItem")["alpha"] == "IGNORE",
    ),
    "composition settings: size": Day(
        "main.setByHand(128, 96, 0.5, 0.5);",
        said=left("cut: size"),
        sees=lambda run: (
            property_of(run.layer("cut", "A shadow"), "ADBE Transform Group", "ADBE Position")["value"] == [64, 48]
        ),
    ),
    "composition settings: rate": Day(
        "main.frameRate = 30;",
        said=left("cut: frame rate"),
        sees=lambda run: run.item("cut", "CompItem")["frameRate"] == 30,
    ),
    "composition settings: duration": Day(
        "main.duration = 2;", said=left("cut: duration"), sees=lambda run: run.item("cut", "CompItem")["duration"] == 2
    ),
    "work area": Day("main.workAreaStart = 1 / 24;", said=left("cut: work area")),
    "another project": Day("app.newProject();", [("cut", 90)], {}),
    "the project brought into one that has the cut": Day(
        "bringIn(app.project);",
        [("cut", 90), ("cut", 90)],
        {CHANGED: [*FOLLOWED], NOTES: [COPIES.format("cut")]},
        sees=lambda run: [each["kind"] for each in run.tree["items"]].count("FootageItem") == 6,
    ),
    "undo": Day(
        "app.beginUndoGroup(''); shadow.remove(); main.layers.precompose([1], 'pre', true); app.endUndoGroup(); undo();"
    ),
}


@pytest.fixture(scope="module")
def scripts(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """Hand a cut off, and again with a darker shadow."""
    folder = tmp_path_factory.mktemp("days")
    made = second_day(folder)
    darker = with_values(made, layers__A__shadow__opacity=0.9)
    first, second = (script_of(handed_off(each, folder / name)) for each, name in ((made, "1"), (darker, "2")))
    return first, second


def second_day(folder: Path) -> Document:
    made = cut(folder / "cut", count=4)
    street = drawings(folder / "street", 1, "street")[0].path
    return review.set_marker(set_background(made, street), Marker(2, "turn"))


@pytest.mark.parametrize("day", DAYS.values(), ids=DAYS)
def test_what_the_user_did_stays_and_the_rest_follows(day: Day, scripts: tuple[Path, Path], tmp_path: Path) -> None:
    first, second = scripts
    run = run_edited(first, tmp_path / "ae.json", (TOP + day.edit, second))
    assert where(run) == sorted(day.shadows)
    said = run.summary()
    assert {head: lines for head, lines in said.items() if lines} == day.said
    assert day.sees(run)
    assert run.tree["undo"]["open"] == 0


@pytest.mark.parametrize("day", DAYS.values(), ids=DAYS)
def test_a_third_run_changes_nothing(day: Day, scripts: tuple[Path, Path], tmp_path: Path) -> None:
    first, second = scripts
    twice = run_edited(first, tmp_path / "2.json", (TOP + day.edit, second))
    thrice = run_edited(first, tmp_path / "3.json", (TOP + day.edit, second), ("keyboard.shiftKey = false;", second))
    assert thrice.tree["items"] == twice.tree["items"]
    assert not {CHANGED, NEW} & thrice.summary().keys()


def test_a_run_that_was_undone_is_as_if_it_never_was(scripts: tuple[Path, Path], tmp_path: Path) -> None:
    first, second = scripts
    once = run_edited(first, tmp_path / "1.json", ("", second))
    again = run_edited(first, tmp_path / "2.json", ("", second), ("undo();", second))
    assert again.tree["items"] == once.tree["items"]
    assert again.summary()[CHANGED] == FOLLOWED
    anew = run_edited(first, tmp_path / "3.json", ("undo();", second))
    assert where(anew) == [("cut", 90)]
    assert anew.tree["alerts"] == [], "built for the first time"


def test_another_cut_in_the_project_is_left_alone(scripts: tuple[Path, Path], tmp_path: Path) -> None:
    first, second = scripts
    other = script_of(handed_off(second_day(tmp_path), tmp_path / "other", name="other"))
    run = run_edited(first, tmp_path / "ae.json", ("", other), ("", second))
    assert where(run) == [("cut", 90), ("other", 60)]
    assert run.summary()[CHANGED] == FOLLOWED


def test_many_changes_are_not_all_named(tmp_path: Path) -> None:
    document = second_day(tmp_path)
    shown = document.layers[0].cels
    for number in range(2, 16):
        document = add_layer(document, f"L{number}", shown, document.layers[0].figure)
    apart = with_values(document, scene__shadows_unite=False)
    fainter = apart
    for layer in apart.layers:
        fainter = with_values(fainter, **{f"layers__{layer.name}__shadow__opacity": 0.2})
    first, second = (script_of(handed_off(each, tmp_path / name)) for each, name in ((apart, "1"), (fainter, "2")))
    run = run_edited(first, tmp_path / "ae.json", ("", second))
    assert len(run.summary()[CHANGED]) == 15
    lost = "comp('cut').all.slice(0, -8).forEach((each) => each.remove());"
    both = run_edited(first, tmp_path / "ae.json", (lost, second))
    assert [len(lines) for lines in both.summary().values()] == [0, 7, 16]
    assert both.summary()[DELETED][-1] == "... and 10 more"


def where(run: Run) -> list[tuple[str, float]]:
    """Return in which compositions the layer of the shadow lies, and its opacity."""
    found = [(each["name"], layer) for each in run.tree["items"] if each["layers"] for layer in each["layers"]]
    return sorted(
        (name, property_of(layer, *OPACITY)["value"])
        for name, layer in found
        if ":shadow:layer-1" in layer["comment"]
        or (not layer["comment"] and property_of(layer, *OPACITY)["value"] == 60)
    )
