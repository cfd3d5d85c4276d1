"""The null that drives all shadows: at first it changes nothing, and what the user sets on it stays."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from kagezou.document.edits import add_layer, set_background
from kagezou.document.model import Cels, Document, Exposure
from kagezou.geometry.box import Box
from kagezou.io.images.writing import write_rgba
from tests.export.after_effects.compositing import composed
from tests.export.after_effects.extendscript import CHANGED, DELETED, LEFT, NEW, Run, property_of, run_edited
from tests.export.after_effects.hand_offs import built, furthest, handed_off, names, script_of
from tests.export.small_cuts import HEIGHT, WIDTH, cut, drawings, with_key, with_values

TOP = (
    "var main = comp('cut'); var at = (name) => layerOf('cut', name);"
    "var effectsOf = (name) => at(name)._groups['ADBE Effect Parade'].children;"
    "var set = (name, value) => {"
    " Object.values(effectsOf('Kagezou')[name].children)[0].setValue(value); };"
)
OPACITY = ("ADBE Transform Group", "ADBE Opacity")
LAST = 4


@pytest.fixture
def document(tmp_path: Path) -> Document:
    """Two figures whose shadows unite and one of another look, which has contact patches, over a ramp."""
    ramp = np.full((HEIGHT, WIDTH, 4), 255, np.uint8)
    ramp[..., 0], ramp[..., 1] = np.linspace(40, 250, WIDTH), np.linspace(90, 220, HEIGHT)[:, np.newaxis]
    write_rgba(tmp_path / "ramp.png", ramp)
    made = set_background(cut(tmp_path / "a", count=LAST), tmp_path / "ramp.png")
    for name in "BC":
        cels = Cels(drawings(tmp_path / name, 2, name), (Exposure(1, 0), Exposure(3, 1)))
        made = add_layer(made, name, cels, Box(12, 20, 20, 40))
    made = with_values(made, layers__C__shadow__color="#203060", layers__C__shadow__opacity=0.7)
    made = with_values(made, layers__C__contact__strength=0.5, layers__B__receives=True)
    return with_key(with_key(made, "light.position", 1, (5.0, -20.0, 40.0)), "light.position", 4, (30.0, -20.0, 40.0))


@pytest.fixture
def one(tmp_path: Path) -> Document:
    """One figure under a sun, over white, whose shadow keeps its size in a jump."""
    write_rgba(tmp_path / "white.png", np.full((HEIGHT, WIDTH, 4), 255, np.uint8))
    made = set_background(cut(tmp_path / "a", count=LAST), tmp_path / "white.png")
    made = with_values(made, light__kind="sun", light__elevation=50.0, light__azimuth=-45.0)
    return with_values(made, layers__A__shadow__lift_shrink=0.0, layers__A__stance="line")


def set_to(document: Document, tmp_path: Path, edit: str) -> Run:
    """Build with controls and set them; the script runs again, which must not matter."""
    script = script_of(handed_off(document, tmp_path / "ae", controls=True))
    return run_edited(script, tmp_path / "ae.json", (TOP + edit, script))


def all_frames(run: Run) -> list[np.ndarray]:
    return [composed(run, "cut", frame) for frame in range(1, LAST + 1)]


def middle(run: Run, frame: int = 1) -> tuple[float, float]:
    """Return the middle of what is dark at the upper half, where no figure stands, or of the shadow's own alpha."""
    dark = 255.0 - composed(run, "cut", frame)[..., 0]
    rows, columns = np.indices(dark.shape) + 0.5
    return float((rows * dark).sum() / dark.sum()), float((columns * dark).sum() / dark.sum())


def test_at_first_not_one_pixel_changes(document: Document, tmp_path: Path) -> None:
    run = built(handed_off(document, tmp_path / "ae", controls=True), tmp_path)
    plain = built(handed_off(document, tmp_path / "plain"), tmp_path)
    for frame in range(1, LAST + 1):
        assert np.array_equal(composed(run, "cut", frame), composed(plain, "cut", frame))
    assert furthest(run, document, tmp_path) <= 1
    assert names(run, "cut")[-1] == "Kagezou"
    assert "Kagezou" not in names(plain, "cut")
    driven = [layer["name"] for layer in run.item("cut", "CompItem")["layers"] if "expression" in str(layer)]
    assert sorted(driven) == ["A, B shadows", "B received", "C contact", "C shadow"]


def test_opacity_color_and_softness_drive_all_shadows(document: Document, tmp_path: Path) -> None:
    before = all_frames(built(handed_off(document, tmp_path / "ae", controls=True), tmp_path))
    gone = all_frames(set_to(document, tmp_path, "set('Opacity', 0);"))
    bare = with_values(
        document,
        **{f"layers__{name}__shadow__opacity": 0.0 for name in "ABC"},
        layers__C__contact__strength=0.0,
    )
    wanted = all_frames(built(handed_off(bare, tmp_path / "bare"), tmp_path))
    for one, other in zip(gone, wanted, strict=True):
        assert np.array_equal(one, other)
    red = all_frames(set_to(document, tmp_path, "set('Color', [1, 0, 0, 1]); set('Color Amount', 100);"))
    soft = all_frames(set_to(document, tmp_path, "set('Softness', 6);"))
    for was, now, blurred, without in zip(before, red, soft, gone, strict=True):
        shaded = (was != without).any(-1)
        assert shaded.any()
        assert (now[shaded][:, 0] >= was[shaded][:, 0]).all()
        assert (now[..., 0] == without[..., 0]).all(), "red light is let through"
        assert ((blurred != was).any(-1) & ~shaded).any(), "the edge goes outward"


def test_a_tenth_of_the_opacity_is_a_tenth_of_the_keys(document: Document, tmp_path: Path) -> None:
    keyed = with_key(with_key(document, "layers.C.shadow.opacity", 1, 0.9), "layers.C.shadow.opacity", 4, 0.3)
    run = set_to(keyed, tmp_path, "set('Opacity', 10);")
    opacity = property_of(run.layer("cut", "C shadow"), *OPACITY)
    assert opacity["driven"]["values"] == pytest.approx([9, 7, 5, 3])
    assert [key["value"] for key in opacity["keys"]] == [90, 30], "the keys are the document's"


@pytest.mark.parametrize("height", [3.5, 7.0])
def test_height_slides_the_shadow_as_that_of_a_figure_held_higher(one: Document, height: float, tmp_path: Path) -> None:
    run = set_to(one, tmp_path, f"set('Height', {height}); at('A').enabled = false;")
    higher = with_values(one, layers__A__position=(WIDTH / 2, HEIGHT / 2 - height))
    wanted = set_to(higher, tmp_path / "higher", "at('A').enabled = false;")
    for frame in (1, LAST):
        found, right = composed(run, "cut", frame).astype(int), composed(wanted, "cut", frame).astype(int)
        assert abs(found[..., 0].sum() - right[..., 0].sum()) < 0.03 * (255 - right[..., 0]).sum()
        assert middle(run, frame) == pytest.approx(middle(wanted, frame), abs=0.1)


def test_height_shrinks_about_the_contact_and_takes_patches_away(document: Document, tmp_path: Path) -> None:
    document = with_values(document, layers__C__shadow__lift_shrink=0.5)
    run = set_to(document, tmp_path, "set('Height', 10);")
    parts = property_of(run.layer("cut", "C shadow"), "ADBE Effect Parade", "Kagezou Height")["children"]
    assert parts["ADBE Geometry2-0003"]["driven"]["values"] == pytest.approx([75] * LAST), "half of the figure's height"
    assert parts["ADBE Geometry2-0001"]["value"] == pytest.approx([32, 40])
    assert property_of(run.layer("cut", "C contact"), *OPACITY)["driven"]["values"] == [0] * LAST
    within = [run.layer("A, B shadows", f"{name} shadow") for name in "AB"]
    for layer in within:
        place = property_of(layer, "ADBE Effect Parade", "Kagezou Height", "ADBE Geometry2-0002")
        assert place["driven"]["values"][0] != place["value"], (
            "each figure's own shadow moves, from another composition"
        )


def test_a_round_shadow_stays_under_its_figure(one: Document, tmp_path: Path) -> None:
    run = set_to(with_values(one, layers__A__shadow__shape="disc"), tmp_path, "set('Height', 10);")
    place = property_of(run.layer("cut", "A shadow"), "ADBE Effect Parade", "Kagezou Height", "ADBE Geometry2-0002")
    assert place["driven"]["values"][0] == pytest.approx(place["value"])


def test_what_is_set_stays_and_the_rest_follows(document: Document, tmp_path: Path) -> None:
    changed = with_values(document, layers__C__shadow__opacity=0.4)
    first, second = (
        script_of(handed_off(each, tmp_path / name, controls=True)) for each, name in ((document, "1"), (changed, "2"))
    )
    run = run_edited(first, tmp_path / "ae.json", (TOP + "set('Opacity', 50);", second))
    assert run.summary()[CHANGED] == ["C shadow: opacity"]
    assert run.left() == []
    opacity = property_of(run.layer("cut", "C shadow"), *OPACITY)
    assert (opacity["value"], opacity["driven"]["values"][0]) == (40, 20)


def test_controls_come_later_and_stay_when_they_are_not_asked_for(document: Document, tmp_path: Path) -> None:
    plain = script_of(handed_off(document, tmp_path / "1"))
    driven = script_of(handed_off(document, tmp_path / "2", controls=True))
    run = run_edited(plain, tmp_path / "ae.json", ("", driven))
    assert run.summary()[NEW] == ["Kagezou"]
    assert "driven" in property_of(run.layer("cut", "C shadow"), *OPACITY)
    run = run_edited(driven, tmp_path / "ae.json", (TOP + "set('Opacity', 50);", plain))
    assert run.left() == []
    assert property_of(run.layer("cut", "C shadow"), *OPACITY)["driven"]["values"][0] == 35


def test_without_the_null_all_is_as_without_controls(document: Document, tmp_path: Path) -> None:
    script = script_of(handed_off(document, tmp_path / "ae", controls=True))
    run = run_edited(script, tmp_path / "ae.json", (TOP + "set('Opacity', 5); at('Kagezou').remove();", script))
    assert run.summary()[DELETED] == ["Kagezou"]
    assert furthest(run, document, tmp_path) <= 1
    back = ("keyboard.shiftKey = true;", script)
    run = run_edited(script, tmp_path / "ae.json", (TOP + "at('Kagezou').remove();", script), back)
    assert "driven" in property_of(run.layer("cut", "C shadow"), *OPACITY)
    assert list(run.layer("cut", "C shadow")["groups"]["ADBE Effect Parade"]["children"]).count("Kagezou Color") == 1


@pytest.mark.parametrize(
    ("edit", "left"),
    [
        ("main.layers.precompose([at('C shadow').index], 'pre', true);", []),
        ("main.layers.precompose([at('C shadow').index, at('Kagezou').index], 'pre', true);", []),
        ("delete effectsOf('C shadow')['Kagezou Softness'];", ["C shadow: expressions"]),
        ("at('C shadow').transform['ADBE Opacity'].expression = '12';", ["C shadow: expressions"]),
        ("at('C shadow').duplicate().name = 'mine';", ["mine: name"]),
    ],
)
def test_driven_layers_are_the_users_too(document: Document, tmp_path: Path, edit: str, left: list[str]) -> None:
    run = set_to(document, tmp_path, edit)
    assert run.left() == left
    changed = run.summary().get(CHANGED, [])
    assert bool(changed) == ("Kagezou').index" in edit), "expressions find a null that went elsewhere"
    opacity = property_of(run.layer("pre" if "'pre'" in edit else "cut", "C shadow"), *OPACITY)
    assert opacity["driven"]["values"][0] in (70, 12)


def test_a_copy_of_the_composition_has_its_own_null(document: Document, tmp_path: Path) -> None:
    edit = "main.duplicate(); set('Opacity', 50);"
    run = set_to(document, tmp_path, edit)
    both = [property_of(run.layer(name, "C shadow"), *OPACITY)["driven"]["values"][0] for name in ("cut", "cut 2")]
    assert both == pytest.approx([35, 70])


def test_an_expression_of_the_users_own_is_not_replaced(document: Document, tmp_path: Path) -> None:
    plain = script_of(handed_off(document, tmp_path / "1"))
    driven = script_of(handed_off(document, tmp_path / "2", controls=True))
    own = "layerOf('cut', 'C shadow').transform['ADBE Opacity'].expression = 'value / 2';"
    run = run_edited(plain, tmp_path / "ae.json", (own, driven))
    assert run.summary()[LEFT] == ["C shadow: expressions"]
    assert property_of(run.layer("cut", "C shadow"), *OPACITY)["expression"] == "value / 2"


def test_the_controls_are_offered_to_essential_graphics_where_there_is_such(document: Document, tmp_path: Path) -> None:
    script = script_of(handed_off(document, tmp_path / "ae", controls=True))
    run = run_edited(script, tmp_path / "ae.json", ("", script))
    assert run.item("cut", "CompItem")["graphics"] == [
        "影の不透明度", "影のカラー", "影のカラーの適用量", "影のぼかし", "影の高さ"
    ]  # fmt: skip
    nothing = tmp_path / "nothing.jsx"
    nothing.write_text("")
    older = (
        "var made = layerOf; var property = app.project.items.addComp('x', 8, 8, 1, 1, 24).markerProperty;"
        "delete Object.getPrototypeOf(property).canAddToMotionGraphicsTemplate;"
    )
    run = run_edited(nothing, tmp_path / "ae.json", (older, script))
    assert run.tree["alerts"] == []
    assert run.item("cut", "CompItem")["graphics"] == []


def test_names_that_are_taken_or_awkward(document: Document, tmp_path: Path) -> None:
    awkward = 'cut "1" \\ 影'
    script = script_of(
        handed_off(replace(document, layers=document.layers[:1]), tmp_path / "ae", name=awkward, controls=True)
    )
    run = run_edited(script, tmp_path / "ae.json", ("", script))
    within = property_of(run.layer(awkward, "A shadow"), *OPACITY)
    assert within["driven"]["values"][0] == within["value"]
