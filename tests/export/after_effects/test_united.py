"""Shadows that unite, in After Effects: each figure's own layer in one composition of the look, multiplied once."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from kagezou.animation.track import Interpolation
from kagezou.document.address import resolve
from kagezou.document.edits import add_layer, set_background, set_key
from kagezou.document.model import Cels, Document, Exposure
from kagezou.geometry.box import Box
from kagezou.io.images.reading import read_cel
from kagezou.io.images.writing import write_rgba
from tests.export.after_effects.compositing import composed
from tests.export.after_effects.extendscript import property_of, run_edited
from tests.export.after_effects.hand_offs import built, furthest, handed_off, names
from tests.export.small_cuts import HEIGHT, WIDTH, cut, drawings, export, with_key, with_values

TRANSFORM = "ADBE Transform Group"
FRAMES = 4


@pytest.fixture
def pair(tmp_path: Path) -> Document:
    """Two figures whose soft shadows overlap, over a background that is not plain."""
    document = cut(tmp_path / "a", FRAMES)
    shown = drawings(tmp_path / "b", FRAMES, "b")
    later = tuple(Exposure(n + 1, (n + 2) % FRAMES) for n in range(FRAMES))
    document = add_layer(document, "B", Cels(shown, later), Box(12, 20, 20, 40))
    ramp = np.full((HEIGHT, WIDTH, 4), 255, np.uint8)
    ramp[..., 0], ramp[..., 1] = np.linspace(40, 250, WIDTH), np.linspace(90, 220, HEIGHT)[:, np.newaxis]
    write_rgba(tmp_path / "ramp.png", ramp)
    document = set_background(document, tmp_path / "ramp.png")
    return with_values(document, layers__A__shadow__softness=9.0, layers__B__shadow__softness=14.0)


def both(
    document: Document, name: str, *keys: tuple[int, object], how: Interpolation = Interpolation.LINEAR
) -> Document:
    for layer in "AB":
        for frame, value in keys:
            document = set_key(document, resolve(document, f"layers.{layer}.shadow.{name}"), frame, value, how)
    return document


def test_each_figure_has_its_layer_within_the_composition_of_the_look(pair: Document, tmp_path: Path) -> None:
    run = built(handed_off(pair, tmp_path / "ae"), tmp_path)
    assert names(run, "cut") == ["Background", "A, B shadows", "A", "B", "Ground line", "Light"]
    assert names(run, "A, B shadows") == ["A shadow", "B shadow"]
    united = run.layer("cut", "A, B shadows")
    assert (united["blend"], united["source"]) == ("MULTIPLY", "A, B shadows")
    assert property_of(united, TRANSFORM, "ADBE Opacity")["value"] == 60
    within = [run.layer("A, B shadows", f"{name} shadow") for name in "AB"]
    assert [layer["blend"] for layer in within] == ["LIGHTEN", "LIGHTEN"]
    assert [property_of(layer, TRANSFORM, "ADBE Opacity")["value"] for layer in within] == [100, 100]


@pytest.mark.parametrize("per_drawing", [False, True])
def test_the_composition_is_the_picture_within_one_level(pair: Document, tmp_path: Path, *, per_drawing: bool) -> None:
    run = built(handed_off(pair, tmp_path / "ae", per_drawing=per_drawing), tmp_path)
    assert furthest(run, pair, tmp_path) <= 1
    export(with_values(pair, scene__shadows_unite=False), tmp_path / "apart", composite=True)
    apart = read_cel(tmp_path / "apart/composite/composite_0002.png").rgba.astype(int)
    assert (composed(run, "cut", 2)[..., :3] - apart[..., :3]).max() > 10, "the picture differs where shadows meet"


def test_keyed_looks_unite_and_keep_their_keys(pair: Document, tmp_path: Path) -> None:
    document = both(pair, "opacity", (1, 0.9), (4, 0.3))
    document = both(document, "color", (1, "#102060"), (3, "#A02010"))
    run = built(handed_off(document, tmp_path / "ae"), tmp_path)
    united = run.layer("cut", "A, B shadows")
    opacity = property_of(united, TRANSFORM, "ADBE Opacity")["keys"]
    assert [(key["time"], key["value"]) for key in opacity] == [(0.0, 90), (0.125, 30)]
    assert furthest(run, document, tmp_path) <= 1


def test_a_fading_look_unites_too(pair: Document, tmp_path: Path) -> None:
    document = both(pair, "fade", (1, 30.0), (4, 18.0))
    run = built(handed_off(document, tmp_path / "ae"), tmp_path)
    assert names(run, "A, B shadows") == ["A shadow", "B shadow"]
    assert furthest(run, document, tmp_path) <= 1


def test_a_normal_blend_unites_too(pair: Document, tmp_path: Path) -> None:
    document = with_values(pair, layers__A__shadow__blend="normal", layers__B__shadow__blend="normal")
    run = built(handed_off(document, tmp_path / "ae"), tmp_path)
    assert run.layer("cut", "A, B shadows")["blend"] == "NORMAL"
    assert furthest(run, document, tmp_path) <= 1


def test_an_opacity_that_waits_for_the_next_drawing_is_that_of_every_frame(pair: Document, tmp_path: Path) -> None:
    document = both(pair, "opacity", (1, 0.9), (4, 0.3))
    document = both(document, "timing", (1, "exposures"), how=Interpolation.HOLD)
    held = (Exposure(1, 0), Exposure(3, 1))
    layers = (replace(each, cels=replace(each.cels, exposures=held)) for each in document.layers)
    document = replace(document, layers=tuple(layers))
    run = built(handed_off(document, tmp_path / "ae"), tmp_path)
    assert furthest(run, document, tmp_path) <= 1


def test_a_hidden_figure_is_no_difference_of_look(pair: Document, tmp_path: Path) -> None:
    document = with_key(with_key(pair, "layers.A.visible", 1, value=True), "layers.A.visible", 3, value=False)
    opacity = resolve(document, "layers.A.shadow.opacity")
    for frame, value in ((1, 0.6), (3, 0.1)):
        document = set_key(document, opacity, frame, value, Interpolation.HOLD)
    done = handed_off(document, tmp_path / "ae")
    assert done.notes == ()
    assert furthest(built(done, tmp_path), document, tmp_path) <= 1


def test_looks_that_differ_on_some_frames_are_one_layer_and_that_is_said_once(pair: Document, tmp_path: Path) -> None:
    document = with_key(with_key(pair, "layers.B.shadow.opacity", 1, 0.6), "layers.B.shadow.opacity", 3, 0.2)
    done = handed_off(document, tmp_path / "ae")
    (note,) = map(str, done.notes)
    assert note.startswith("the shadows of 'A', 'B' are handed over as one, with their opacity in it")
    run = built(done, tmp_path)
    assert names(run, "cut")[:4] == ["Background", "A, B shadows", "A", "B"]
    assert not any(each["kind"] == "CompItem" and each["name"] != "cut" for each in run.tree["items"])
    footage = [each["name"] for each in run.tree["items"] if each["folder"] == "Shadows"]
    assert footage == ["A shadow", "B shadow", "A, B united shadows"], "each alone is there, too"
    assert furthest(run, document, tmp_path) <= 1


def test_two_colours_are_one_layer(pair: Document, tmp_path: Path) -> None:
    document = with_values(pair, layers__A__shadow__tip_distance=20.0, layers__B__shadow__tip_distance=20.0)
    done = handed_off(document, tmp_path / "ae")
    assert len(done.notes) == 1
    run = built(done, tmp_path)
    assert names(run, "cut")[1] == "A, B shadows"
    assert furthest(run, document, tmp_path) <= 1


@pytest.mark.parametrize("values", [{"layers__B__shadow__opacity": 0.3}, {"scene__shadows_unite": False}])
def test_other_looks_are_layers_as_before(pair: Document, tmp_path: Path, values: dict[str, object]) -> None:
    document = with_values(pair, **values)
    done = handed_off(document, tmp_path / "ae")
    assert done.notes == ()
    run = built(done, tmp_path)
    assert {"A shadow", "B shadow"} <= set(names(run, "cut"))
    assert furthest(run, document, tmp_path) <= 2, "two layers, each rounded"


def test_a_colour_changed_in_after_effects_stays(pair: Document, tmp_path: Path) -> None:
    first = handed_off(pair, tmp_path / "1").script
    red = with_values(pair, layers__A__shadow__color="#FF0000", layers__B__shadow__color="#FF0000")
    second = handed_off(red, tmp_path / "2").script
    assert first is not None
    assert second is not None
    fill = (
        "layerOf('cut', 'A, B shadows')._groups['ADBE Effect Parade'].children['ADBE Fill'].children['ADBE Fill-0002']"
    )

    def color_after(edit: str) -> list[float]:
        run = run_edited(first, tmp_path / "ae.json", (edit, second))
        effects = run.layer("cut", "A, B shadows")["groups"]["ADBE Effect Parade"]["children"]
        assert list(effects) == ["ADBE Shift Channels", "ADBE Fill"], "none is added a second time"
        return list(effects["ADBE Fill"]["children"]["ADBE Fill-0002"]["value"])

    assert color_after("") == [1, 0, 0, 1]
    assert color_after(f"{fill}.setValue([0, 1, 0, 1]);") == [0, 1, 0, 1]
