"""What went wrong on the second day: each a fault of its own, against the picture of the changed document."""

from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

from kagezou.animation.track import Interpolation
from kagezou.document.address import resolve
from kagezou.document.edits import add_layer, set_background, set_canvas, set_key
from kagezou.document.model import Cels, Document, Exposure
from kagezou.geometry.box import Box
from kagezou.io.images.writing import write_rgba
from tests.export.after_effects.compositing import composed
from tests.export.after_effects.extendscript import CHANGED, LEFT, NOTES, Run, property_of, run_edited
from tests.export.after_effects.hand_offs import furthest, handed_off, script_of
from tests.export.small_cuts import HEIGHT, WIDTH, cut, drawings, with_values

TOP = (
    "var main = comp('cut'); var at = (name) => layerOf('cut', name);"
    "var together = () => main.layers.precompose([at('A shadow').index, at('B shadow').index], 'pre', true);"
    "var alone = () => { main.layers.precompose([at('A shadow').index], 'pre', false);"
    " main.layers.precompose([at('A').index], 'drawn', false); };"
)
STATES = {
    "as it was": "",
    "locked": "main.all.forEach((each) => { each.locked = true; });",
    "precomposed with all attributes": "together();",
    "precomposed without": "alone();",
    "precomposed both ways": "alone(); together();",
    "all precomposed": "main.layers.precompose(main.all.map((each) => each.index), 'all', true);"
    "main.all[0].locked = true;",
}


@pytest.fixture
def document(tmp_path: Path) -> Document:
    """Two figures of drawings of odd sizes, one moved, their shadows of different looks, over a ramp."""
    ramp = np.full((HEIGHT, WIDTH, 4), 255, np.uint8)
    ramp[..., 0], ramp[..., 1] = np.linspace(40, 250, WIDTH), np.linspace(90, 220, HEIGHT)[:, np.newaxis]
    write_rgba(tmp_path / "ramp.png", ramp)
    made = set_background(cut(tmp_path / "a", count=3), tmp_path / "ramp.png")
    shown = drawings(tmp_path / "b", 2, "b")
    for each in shown:
        write_rgba(each.path, np.full((21, 13, 4), 200, np.uint8))
    made = add_layer(made, "B", Cels(shown, (Exposure(1, 0), Exposure(3, 1))), Box(12, 20, 20, 40))
    made = with_values(made, layers__B__shadow__opacity=0.4)
    for frame, place in ((1, (20.0, 30.0)), (6, (40.0, 30.0))):
        made = set_key(made, resolve(made, "layers.B.position"), frame, place, Interpolation.LINEAR)
    return made


def rerun(before: Document, after: Document, edit: str, tmp_path: Path) -> Run:
    first, second = (script_of(handed_off(each, tmp_path / name)) for each, name in ((before, "1"), (after, "2")))
    return run_edited(first, tmp_path / "ae.json", (TOP + edit, second))


def tags(run: Run) -> list[str]:
    layers = [layer for each in run.tree["items"] if each["layers"] for layer in each["layers"]]
    return sorted(layer["comment"].split(" #")[0] for layer in layers if layer["comment"])


@pytest.mark.parametrize("edit", STATES.values(), ids=STATES)
def test_no_shadow_is_doubled_after_a_precompose(document: Document, edit: str, tmp_path: Path) -> None:
    changed = with_values(document, layers__A__shadow__color="#402010", layers__B__shadow__softness=5.0)
    run = rerun(document, changed, edit, tmp_path)
    assert len(tags(run)) == len(set(tags(run))) == len(tags(rerun(document, changed, "", tmp_path)))
    # Shadows precomposed by themselves are multiplied with nothing; with their background they are the picture.
    if "together" not in edit:
        assert furthest(run, changed, tmp_path) <= 1
    assert run.left() == []


@pytest.mark.parametrize("keeps", ["corner", "middle"])
@pytest.mark.parametrize("edit", STATES.values(), ids=STATES)
def test_nothing_drifts_after_a_resize(document: Document, edit: str, keeps: str, tmp_path: Path) -> None:
    canvas = replace(document.canvas, width_px=WIDTH + 22, height_px=HEIGHT + 9)
    changed = set_canvas(document, canvas)
    run = rerun(document, changed, edit + f"settings.resizeKeeps = '{keeps}';", tmp_path)
    sizes = {
        (each["width"], each["height"]) for each in run.tree["items"] if each["layers"] and each["name"] != "drawn"
    }
    assert sizes == {(WIDTH + 22, HEIGHT + 9)}
    assert run.left() == []
    if "together" not in edit:
        assert furthest(run, changed, tmp_path) <= 1
        return
    # The same shadows precomposed in the changed cut.
    fresh = rerun(changed, changed, edit, tmp_path / "fresh")
    for frame in (1, 4):
        assert np.array_equal(composed(run, "cut", frame), composed(fresh, "cut", frame))


@pytest.mark.parametrize("edit", STATES.values(), ids=STATES)
def test_another_rate_and_length_arrive(document: Document, edit: str, tmp_path: Path) -> None:
    for rate, length in ((Fraction(25), 9), (Fraction(12), 4), (Fraction(24000, 1001), 6)):
        changed = set_canvas(document, replace(document.canvas, frame_rate=rate, length_frames=length))
        run = rerun(document, changed, edit, tmp_path / f"{length}")
        for each in run.tree["items"]:
            if each["layers"] and each["name"] != "drawn":
                assert (each["frameRate"], each["duration"]) == pytest.approx((rate, length / rate))
                assert all(layer["outPoint"] == pytest.approx(float(length / rate)) for layer in each["layers"])
        assert run.left() == []
        if "together" not in edit:
            assert furthest(run, changed, tmp_path / f"{length}") <= 1


def test_a_blend_mode_arrives(document: Document, tmp_path: Path) -> None:
    changed = with_values(document, layers__A__shadow__blend="normal")
    run = rerun(document, changed, "", tmp_path)
    assert run.layer("cut", "A shadow")["blend"] == "NORMAL"
    assert run.summary()[CHANGED] == ["A shadow: blending mode"]
    assert furthest(run, changed, tmp_path) <= 1


def test_an_anchor_arrives(document: Document, tmp_path: Path) -> None:
    changed = with_values(document, layers__B__anchor=(3.0, 20.0))
    run = rerun(document, changed, "", tmp_path)
    assert "B: transform" in run.summary()[CHANGED]
    assert furthest(run, changed, tmp_path) <= 1


def test_a_copy_of_the_composition_is_never_stale(document: Document, tmp_path: Path) -> None:
    changed = with_values(document, layers__A__shadow__blend="normal", layers__B__shadow__opacity=0.8)
    run = rerun(document, changed, "main.duplicate();", tmp_path)
    assert run.summary()[NOTES] == ["Copies of the composition were brought up to date as well: cut 2"]
    assert np.array_equal(composed(run, "cut 2", 3), composed(run, "cut", 3))
    assert furthest(run, changed, tmp_path) <= 1


def test_a_deleted_layer_does_not_come_back_while_new_ones_come(document: Document, tmp_path: Path) -> None:
    shown = drawings(tmp_path / "c", 1, "c")
    changed = add_layer(document, "C", Cels(shown, (Exposure(1, 0),)), Box(12, 20, 20, 40))
    changed = with_values(changed, layers__C__shadow__opacity=0.2)
    edit = "at('A shadow').remove(); main.layers.precompose([at('B shadow').index], 'pre', true);"
    run = rerun(document, changed, edit, tmp_path)
    names = [layer["name"] for layer in reversed(run.item("cut", "CompItem")["layers"])]
    assert names == ["Background", "pre", "C shadow", "A", "B", "C", "Ground line", "Light"]


@pytest.mark.parametrize("across", [0, 0.5, 1])
def test_layers_follow_in_a_composition_that_was_made_larger(document: Document, across: float, tmp_path: Path) -> None:
    changed = with_values(document, layers__A__shadow__opacity=0.9)
    for frame, place in ((1, (10.0, 20.0)), (6, (44.0, 33.0))):
        changed = set_key(changed, resolve(changed, "layers.B.position"), frame, place, Interpolation.LINEAR)
    run = rerun(document, changed, f"main.setByHand(104, 88, {across}, {across});", tmp_path)
    assert run.summary()[LEFT] == ["cut: size"]
    left, top = int(40 * across), int(40 * across)
    alone = rerun(changed, changed, "", tmp_path / "alone")
    for frame in (1, 4):
        inner = composed(run, "cut", frame)[top : top + HEIGHT, left : left + WIDTH]
        assert np.array_equal(inner, composed(alone, "cut", frame))


def test_what_both_sides_changed_is_asked_once(document: Document, tmp_path: Path) -> None:
    changed = set_canvas(document, replace(document.canvas, width_px=80, length_frames=8))
    first = script_of(handed_off(document, tmp_path / "ae"))
    first = first.rename(first.with_name("before.jsx"))
    second = script_of(handed_off(changed, tmp_path / "ae"))
    edit = TOP + "main.setByHand(100, 60, 0, 0); main.frameRate = 30;"
    for answer, width in (("true", 80), ("false", 100)):
        run = run_edited(
            first, tmp_path / "ae.json", (f"{edit} answer = {answer};", second), ("answer = true;", second)
        )
        (asked,) = run.tree["asked"]
        assert "cut: size" in asked
        assert "frame rate" not in asked, "Kagezou's is what it was"
        item = run.item("cut", "CompItem")
        assert (item["width"], item["frameRate"], item["duration"]) == (width, 30, 8 / 24)


def test_without_a_comment_a_layer_is_the_users(document: Document, tmp_path: Path) -> None:
    changed = with_values(document, layers__A__shadow__opacity=0.9)
    run = rerun(document, changed, "at('A shadow').comment = 'my own words';", tmp_path)
    layer = run.layer("cut", "A shadow")
    assert property_of(layer, "ADBE Transform Group", "ADBE Opacity")["value"] == 60
    assert layer["comment"] == "my own words"


def test_a_new_layer_never_comes_between_a_layer_and_its_matte(document: Document, tmp_path: Path) -> None:
    shown = drawings(tmp_path / "c", 1, "c")
    changed = add_layer(document, "C", Cels(shown, (Exposure(1, 0),)), Box(12, 20, 20, 40))
    changed = with_values(changed, layers__C__shadow__opacity=0.2)
    matte = "var matte = main.layers.addSolid([1, 1, 1], 'matte', 64, 48, 1, 1); matte.moveBefore(at('B shadow'));"
    newer = "Object.defineProperty(Object.getPrototypeOf(matte), 'trackMatteLayer', { get: () => null });"
    for edit, order in (("", ["B shadow", "matte", "C shadow"]), (newer, ["B shadow", "C shadow", "matte"])):
        run = rerun(document, changed, matte + "at('B shadow').hasTrackMatte = true;" + edit, tmp_path)
        names = [layer["name"] for layer in reversed(run.item("cut", "CompItem")["layers"])]
        assert names[2:5] == order


def test_shadows_that_come_to_unite_and_part_again_are_the_picture(document: Document, tmp_path: Path) -> None:
    united = with_values(document, layers__B__shadow__opacity=0.6)
    scripts = [script_of(handed_off(each, tmp_path / name)) for each, name in ((document, "1"), (united, "2"))]
    for order in ((0, 1), (0, 1, 0), (1, 0), (1, 0, 1)):
        first, *rest = (scripts[number] for number in order)
        run = run_edited(first, tmp_path / "ae.json", *(("", each) for each in rest))
        assert furthest(run, (document, united)[order[-1]], tmp_path) <= 1
        assert run.left() == []
        assert len(tags(run)) == len(set(tags(run)))


def test_layers_of_the_users_own_are_not_moved_by_a_resize_and_that_is_said(document: Document, tmp_path: Path) -> None:
    changed = set_canvas(document, replace(document.canvas, width_px=WIDTH + 22))
    own = "var own = main.layers.addSolid([1, 0, 0], 'own', 8, 8, 1, 1); own.moveToEnd();"
    run = rerun(document, changed, own + "together();", tmp_path)
    assert run.summary()[NOTES] == ["The size of cut changed, and your own layers in it were not moved."]
    assert NOTES not in rerun(document, changed, "together();", tmp_path).summary()


def test_what_was_deleted_stays_so_without_the_folders(document: Document, tmp_path: Path) -> None:
    edit = "at('A shadow').remove(); var gone = (name) => app.project.all.find((each) => each.name === name);"
    edit += "app.project.all.forEach((each) => { each.parentFolder = app.project.rootFolder; });"
    edit += "gone('A shadow').remove(); ['Shadows', 'Footage', 'Characters', 'Background', 'Guides'].forEach("
    edit += "(each) => gone(each).remove()); app.project.all.find((each) => !each.all && each.name === 'cut').remove();"
    run = rerun(document, document, edit, tmp_path)
    assert run.left() == ["A shadow"]
    assert "A shadow" not in [layer["name"] for layer in run.item("cut", "CompItem")["layers"]]


UNITED = {
    "as it was": "",
    "precomposed with all attributes": "main.layers.precompose(["
    "at('A').index, at('A, B shadows').index, at('Background').index], 'pre', true);",
    "precomposed without": "main.layers.precompose([at('A, B shadows').index], 'pre', false);",
    "copied deep": "var deep = comp('A, B shadows').duplicate(); main.duplicate().all.forEach((each) => {"
    " if (each.source.name === 'A, B shadows') each.replaceSource(deep); });",
}


@pytest.mark.parametrize("keeps", ["corner", "middle"])
@pytest.mark.parametrize("edit", UNITED.values(), ids=UNITED)
def test_united_shadows_follow_too(document: Document, edit: str, keeps: str, tmp_path: Path) -> None:
    united = with_values(document, layers__B__shadow__opacity=0.6)
    canvas = replace(united.canvas, width_px=WIDTH + 22, height_px=HEIGHT + 9)
    canvas = replace(canvas, frame_rate=Fraction(25), length_frames=5)
    red = {f"layers__{name}__shadow__color": "#801010" for name in "AB"}
    changed = with_values(set_canvas(united, canvas), **red)
    run = rerun(united, changed, edit + f"settings.resizeKeeps = '{keeps}';", tmp_path)
    assert run.left() == []
    names = {each["name"] for each in run.tree["items"] if each["layers"]}
    assert furthest(run, changed, tmp_path) <= 1
    if "cut 2" in names:
        for frame in (1, 5):
            assert np.array_equal(composed(run, "cut 2", frame), composed(run, "cut", frame))


def test_a_missing_file_changes_nothing(document: Document, tmp_path: Path) -> None:
    first, second = (script_of(handed_off(document, tmp_path / name)) for name in "12")
    (tmp_path / "2" / "characters" / "B" / "B_0001.png").unlink()
    once = run_edited(first, tmp_path / "1.json", ("", first))
    run = run_edited(first, tmp_path / "2.json", ("", first), ("", second))
    assert "B_0001.png" in run.tree["alerts"][-1]
    assert run.tree["items"] == once.tree["items"]
    fresh = run_edited(second, tmp_path / "3.json", ("", second))
    assert fresh.tree["items"] == []


def test_another_order_arrives_unless_the_user_has_one(document: Document, tmp_path: Path) -> None:
    turned = replace(document, layers=document.layers[::-1])
    own = "main.layers.addSolid([1, 0, 0], 'own', 8, 8, 1, 1).moveBefore(at('A shadow')); at('own').enabled = false;"
    run = rerun(document, turned, own + "at('B').locked = true; at('A').locked = true;", tmp_path)
    names = [layer["name"] for layer in reversed(run.item("cut", "CompItem")["layers"])]
    assert names[:6] == ["Background", "own", "B shadow", "A shadow", "B", "A"]
    assert run.summary()[CHANGED] == ["cut: stacking order"]
    assert furthest(run, turned, tmp_path) <= 1
    run = rerun(document, turned, "at('A').moveToEnd();", tmp_path)
    assert run.left() == ["cut: stacking order"]
    assert run.item("cut", "CompItem")["layers"][-1]["name"] == "A"


def test_a_layer_that_was_off_is_off_when_it_comes_back(document: Document, tmp_path: Path) -> None:
    alone = replace(document, layers=document.layers[:1])
    first, second = (script_of(handed_off(each, tmp_path / name)) for each, name in ((document, "1"), (alone, "2")))
    run = run_edited(first, tmp_path / "ae.json", (TOP + "at('B').enabled = false;", second), ("", first))
    assert [run.layer("cut", name)["enabled"] for name in ("B", "B shadow")] == [False, True]
