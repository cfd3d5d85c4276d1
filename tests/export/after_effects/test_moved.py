"""Layers that move, in After Effects: their footage lies on every frame where the picture has it."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from kagezou.animation.ease import Ease
from kagezou.animation.track import Interpolation
from kagezou.document import review
from kagezou.document.address import Address, resolve, value_of
from kagezou.document.ease_edits import set_ease
from kagezou.document.edits import add_layer, join_layer, set_background, set_key
from kagezou.document.figure_properties import POSITION
from kagezou.document.key_edits import all_keys
from kagezou.document.model import Cels, Document, Drawing, Exposure
from kagezou.geometry.box import Box
from kagezou.io.images.writing import write_rgba
from tests.export.after_effects.extendscript import (
    CHANGED,
    LEFT,
    pair_at,
    place_at,
    property_of,
    run_edited,
    run_script,
    value_at,
)
from tests.export.after_effects.hand_offs import built, furthest, handed_off, names, script_of
from tests.export.small_cuts import HEIGHT, WIDTH, cut, drawings, with_values

TRANSFORM = "ADBE Transform Group"
FRAMES = 6
BEZIER = Interpolation.BEZIER


@pytest.fixture
def still(tmp_path: Path) -> Document:
    """A block that walks, over a background that is not plain."""
    ramp = np.full((HEIGHT, WIDTH, 4), 255, np.uint8)
    ramp[..., 0], ramp[..., 1] = np.linspace(40, 250, WIDTH), np.linspace(90, 220, HEIGHT)[:, np.newaxis]
    write_rgba(tmp_path / "ramp.png", ramp)
    return set_background(cut(tmp_path / "a", FRAMES), tmp_path / "ramp.png")


@pytest.fixture
def moved(still: Document) -> Document:
    """The same, moved and scaled by eases that differ in x and y, and turned about its feet."""
    document = with_values(still, layers__A__anchor=(16.0, 40.0))
    document = keyed(document, "position", {1: (16.0, 40.0), 4: (40.0, 44.0), 6: (30.0, 42.0)}, BEZIER)
    document = keyed(document, "scale", {1: (-100.0, 100.0), 6: (-140.0, 120.0)}, BEZIER)
    document = keyed(document, "rotation", {2: 0.0, 6: 25.0}, Interpolation.LINEAR)
    place = Address(POSITION, "layer-1")
    middle = frozenset(ref for ref in all_keys(document, place) if ref.frame == 4)
    return set_ease(document, middle, (Ease(2.0, 0.8), Ease()), (Ease(-1.0, 0.2), Ease(0.5, 0.6)))


def keyed(document: Document, name: str, values: dict[int, object], how: Interpolation) -> Document:
    for frame, value in values.items():
        document = set_key(document, resolve(document, f"layers.A.{name}"), frame, value, how)
    return document


def test_the_composition_is_the_picture(moved: Document, tmp_path: Path) -> None:
    run = built(handed_off(moved, tmp_path / "ae"), tmp_path)
    assert furthest(run, moved, tmp_path) <= 1
    layer = run.layer("cut", "A")
    assert len(property_of(layer, TRANSFORM, "ADBE Position_0")["keys"]) == 3, "the keys of the document, none a frame"
    assert place_at(layer, 3 / 24) == (40.0, 44.0)
    assert pair_at(property_of(layer, TRANSFORM, "ADBE Scale"), 5 / 24) == (-140.0, 120.0)


def test_each_number_has_its_own_curve(moved: Document, tmp_path: Path) -> None:
    document = keyed(moved, "scale", {1: (100.0, 100.0), 6: (-140.0, 30.0)}, BEZIER)
    layer = built(handed_off(document, tmp_path / "ae"), tmp_path).layer("cut", "A")
    scale, turn = (property_of(layer, TRANSFORM, name) for name in ("ADBE Scale", "ADBE Rotate Z"))
    for frame in range(1, FRAMES + 1):
        time = (frame - 1) / 24
        found = {"position": place_at(layer, time), "scale": pair_at(scale, time), "rotation": value_at(turn, time)}
        for name, value in found.items():
            assert value == pytest.approx(value_of(document, resolve(document, f"layers.A.{name}"), frame), abs=1e-6)


def test_whole_px_are_the_picture_to_the_last_level_but_one(still: Document, tmp_path: Path) -> None:
    document = keyed(still, "position", {1: (32.0, 24.0), 3: (41.0, 27.0)}, Interpolation.HOLD)
    run = built(handed_off(document, tmp_path / "ae"), tmp_path)
    assert furthest(run, document, tmp_path) <= 1


def test_a_layer_that_is_not_moved_has_no_transform_in_the_script(still: Document, tmp_path: Path) -> None:
    for document in (still, with_values(still, layers__A__position=(32.0, 24.0), layers__A__rotation=0.0)):
        script = script_of(handed_off(document, tmp_path / "ae")).read_text(encoding="ascii")
        literal = script.partition("var HAND_OFF = ")[2].partition(";\n\n    /* What is said")[0]
        assert "transform" not in literal


@pytest.mark.parametrize("copies", [True, False])
@pytest.mark.parametrize("size", [(25, 31), (91, 70)])
def test_drawings_of_another_size_than_the_canvas_lie_where_they_are_seen(
    still: Document, tmp_path: Path, size: tuple[int, int], *, copies: bool
) -> None:
    shown = odd_drawings(tmp_path / "odd", [size, size])
    document = with_cels(still, shown)
    document = keyed(document, "rotation", {1: 10.0, 6: -30.0}, Interpolation.LINEAR)
    document = with_values(document, layers__A__position=(30.5, 20.25), layers__A__anchor=(10.0, 12.0))
    run = built(handed_off(document, tmp_path / "ae", copies=copies), tmp_path)
    assert run.item("A", "FootageItem")["width"] == size[0]
    assert furthest(run, document, tmp_path) <= 2, "rounded twice, and colours of little alpha are coarse"


def test_drawings_of_different_sizes_keep_what_only_the_move_brings_into_the_picture(
    still: Document, tmp_path: Path
) -> None:
    shown = odd_drawings(tmp_path / "odd", [(25, 31), (91, 20), (40, 71)])
    document = keyed(with_cels(still, shown), "position", {1: (32.0, 24.0), 6: (50.0, 10.0)}, Interpolation.LINEAR)
    run = built(handed_off(document, tmp_path / "ae"), tmp_path)
    assert (run.item("A", "FootageItem")["width"], run.item("A", "FootageItem")["height"]) == (91, 71)
    assert furthest(run, document, tmp_path) <= 1


def test_an_eased_anchor_is_baked_and_that_is_said(still: Document, tmp_path: Path) -> None:
    document = keyed(still, "anchor", {1: (32.0, 24.0), 6: (44.0, 20.0)}, BEZIER)
    done = handed_off(document, tmp_path / "ae")
    assert [str(note) for note in done.notes] == [
        "the anchor of 'A' moves by eases for x and for y, which After Effects has not for anchors; it has keys on its "
        "frames instead"
    ]
    run = built(done, tmp_path)
    assert furthest(run, document, tmp_path) <= 1
    linear = keyed(still, "anchor", {1: (32.0, 24.0), 6: (44.0, 20.0)}, Interpolation.LINEAR)
    done = handed_off(linear, tmp_path / "straight")
    assert done.notes == ()
    run = built(done, tmp_path)
    assert len(property_of(run.layer("cut", "A"), TRANSFORM, "ADBE Anchor Point")["keys"]) == 2
    assert furthest(run, linear, tmp_path / "straight") <= 1


def test_a_second_run_follows_the_document_until_the_user_moves_the_layer(moved: Document, tmp_path: Path) -> None:
    first = script_of(handed_off(moved, tmp_path / "1"))
    later = keyed(moved, "position", {4: (20.0, 30.0)}, BEZIER)
    second = script_of(handed_off(later, tmp_path / "2"))
    run = run_edited(first, tmp_path / "ae.json", ("", second), ("", second))
    assert [run.summary(number).get(CHANGED) for number in (0, 1)] == [["A: transform"], None]
    assert run.left() == []
    assert place_at(run.layer("cut", "A"), 3 / 24) == (20.0, 30.0)
    for edit in (
        "transformOf('cut', 'A')['ADBE Position_1'].keys[1].value = 33;",
        "transformOf('cut', 'A')['ADBE Scale'].keys[1].value = [90, 120];",
        "transformOf('cut', 'A')['ADBE Rotate Z'].removeKey(1);",
    ):
        run = run_edited(first, tmp_path / "ae.json", (edit, second))
        assert place_at(run.layer("cut", "A"), 3 / 24)[0] == 40.0
        assert run.summary()[LEFT] == ["A: transform"]


def test_a_layer_that_comes_to_be_moved_or_no_longer_is(still: Document, moved: Document, tmp_path: Path) -> None:
    plain, other = script_of(handed_off(still, tmp_path / "1")), script_of(handed_off(moved, tmp_path / "2"))
    run = run_edited(plain, tmp_path / "ae.json", ("", other))
    assert run.left() == []
    assert place_at(run.layer("cut", "A"), 0) == (16.0, 40.0)
    run = run_edited(other, tmp_path / "ae.json", ("", plain), ("", plain))
    assert run.left() == []
    fresh = run_script(plain, tmp_path / "fresh.json").layer("cut", "A")
    assert without_memory(run.layer("cut", "A")) == without_memory(fresh)
    own = "transformOf('cut', 'A')['ADBE Position'].value = [3, 4];"
    run = run_edited(plain, tmp_path / "ae.json", (own, plain), ("", other))
    assert place_at(run.layer("cut", "A"), 0) == (3, 4), "moved by hand"
    assert run.left() == ["A: transform"]


def test_footage_that_comes_to_have_another_size_still_lies_as_in_the_picture(still: Document, tmp_path: Path) -> None:
    plain = with_cels(still, odd_drawings(tmp_path / "odd", [(25, 31), (91, 20), (40, 71)]))
    document = keyed(plain, "position", {1: (32.0, 24.0), 6: (50.0, 10.0)}, Interpolation.LINEAR)
    small = with_cels(still, odd_drawings(tmp_path / "small", [(25, 31)]))
    for number, (one, other) in enumerate(((plain, document), (document, plain), (small, plain), (plain, small))):
        scripts = [script_of(handed_off(each, tmp_path / f"{number}{n}")) for n, each in enumerate((one, other))]
        run = run_edited(scripts[0], tmp_path / "ae.json", ("", scripts[1]))
        assert run.left() == []
        assert furthest(run, other, tmp_path / f"{number}") <= 1


def test_a_joined_cel_is_a_layer_and_the_figure_has_the_shadow(moved: Document, tmp_path: Path) -> None:
    shown = drawings(tmp_path / "arm", 2, "arm")
    document = add_layer(moved, "arm", Cels(shown, (Exposure(1, 0), Exposure(3, 1))), Box(12, 20, 20, 40))
    document = join_layer(document, "layer-2", "layer-1")
    document = with_values(
        document, layers__arm__position=(44.0, 20.0), layers__arm__rotation=90.0, layers__arm__grounding=((20.0, 40.0),)
    )
    document = review.add_note(document, Address(POSITION, "layer-2"), 2, "Higher", "Sato")
    for mattes in ((), ("lit", "core", "shadow")):
        run = built(handed_off(document, tmp_path / f"ae{len(mattes)}", mattes=mattes), tmp_path)
        assert names(run, "cut") == ["Background", "A shadow", "A", "arm", "Ground line", "Light"]
        assert furthest(run, document, tmp_path) <= 1
    assert names(run, "Lit area") == ["White", "A"]
    (note,) = property_of(run.layer("cut", "arm"), "ADBE Marker")["keys"]
    assert note["value"]["comment"] == "Sato: Position: Higher"


def test_what_a_part_receives_is_laid_as_those_who_cast_lay_it(still: Document, tmp_path: Path) -> None:
    document = add_layer(still, "arm", Cels(drawings(tmp_path / "arm", 1), (Exposure(1, 0),)), Box(12, 20, 20, 40))
    document = join_layer(document, "layer-2", "layer-1")
    document = add_layer(document, "B", Cels(drawings(tmp_path / "b", 1), (Exposure(1, 0),)), Box(12, 20, 20, 40))
    document = with_values(document, layers__B__shadow__blend="normal", layers__arm__receives=True)
    document = with_values(document, layers__B__position=(40.0, 26.0))
    run = built(handed_off(document, tmp_path / "ae"), tmp_path)
    assert run.layer("cut", "arm received")["blend"] == "NORMAL"


def odd_drawings(folder: Path, sizes: list[tuple[int, int]]) -> tuple[Drawing, ...]:
    """Draw a frame that reaches all borders, of another colour in each corner."""
    folder.mkdir()
    made = []
    for number, (width, height) in enumerate(sizes, start=1):
        pixels = np.zeros((height, width, 4), np.uint8)
        pixels[..., 0], pixels[..., 1] = np.linspace(0, 255, width), np.linspace(255, 0, height)[:, np.newaxis]
        pixels[..., 3] = 255
        pixels[4 : height - 4, 4 : width - 4, 3] = 90
        path = folder / f"odd_{number:04d}.png"
        write_rgba(path, pixels)
        made.append(Drawing(str(number), path, size_px=(width, height)))
    return tuple(made)


def with_cels(document: Document, shown: tuple[Drawing, ...]) -> Document:
    cels = Cels(shown, tuple(Exposure(2 * index + 1, index) for index in range(len(shown))))
    return replace(document, layers=(replace(document.layers[0], cels=cels),))


def without_memory(layer: dict[str, object]) -> dict[str, object]:
    """Return a layer without the numbers of dimensions that are hidden."""
    groups = layer["groups"]
    assert isinstance(groups, dict)
    for name in ("ADBE Position_0", "ADBE Position_1"):
        del groups[TRANSFORM]["children"][name]
    return layer
