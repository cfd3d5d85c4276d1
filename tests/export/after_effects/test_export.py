"""What After Effects would hold after the script: the same layers, times, values and eases as the document."""

import json
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from PIL import Image

from kagezou.animation.ease import Ease
from kagezou.animation.track import Interpolation, Key, Track, components_of
from kagezou.document import review
from kagezou.document.address import Address, value_of
from kagezou.document.ease_edits import set_ease
from kagezou.document.edits import add_layer, rename_layer, set_background, set_canvas, set_key
from kagezou.document.key_edits import all_keys
from kagezou.document.model import Cels, Document, Exposure, Marker
from kagezou.document.paper import set_paper
from kagezou.document.properties import GROUNDING, LIGHT_POSITION, OPACITY
from kagezou.document.set_pieces import add_piece
from kagezou.errors import OutputProblem, UsageProblem
from kagezou.export.after_effects.building import RenderedFootage, Written, hand_off
from kagezou.export.after_effects.channels import channel_of, seconds
from kagezou.export.after_effects.drawings import referenced
from kagezou.export.after_effects.export import HandedOff, HandOffRequest, export_to_after_effects
from kagezou.export.after_effects.renderings import SHADOWS
from kagezou.export.after_effects.script import built_of, script_of
from kagezou.geometry.box import Box
from kagezou.geometry.camera import project
from kagezou.io.images.reading import read_cel
from kagezou.io.images.writing import write_rgba
from kagezou.locations import resource_folder
from kagezou.picture_source import Paper
from kagezou.render.gpu.context import open_headless_context
from kagezou.scene.evaluate import camera_at
from tests.documents import names as layer_names
from tests.export.after_effects.extendscript import checkers, complaints, property_of, run_script, value_at
from tests.export.small_cuts import HEIGHT, WIDTH, cut, drawings, with_key, with_values

TRANSFORM = "ADBE Transform Group"
NASTY = ['A"; alert("x', "line\nbreak", "back\\slash\\", "\u2028\u2029", "日本語 カゲ", "../../up", "🎈", "*/ }()", "'"]


def handed_off(document: Document, folder: Path, **options: object) -> HandedOff:
    request = HandOffRequest(folder=folder, name=str(options.pop("name", "cut 12")), **options)  # type: ignore[arg-type]
    return export_to_after_effects(document, request, open_headless_context, lambda _done, _all: None, lambda: False)


@pytest.fixture
def document(tmp_path: Path) -> Document:
    """Two layers over a background; opacity and lamp eased, an empty cel, a marker, a note, a work area."""
    made = cut(tmp_path, length=24)
    shown = drawings(tmp_path / "more", 3, "b")
    made = add_layer(made, "B", Cels(shown, (Exposure(2, 0), Exposure(3, None), Exposure(5, 2))), Box(1, 1, 2, 2))
    write_rgba(tmp_path / "bg.png", np.full((HEIGHT, WIDTH, 4), 255, np.uint8))
    made = set_background(made, tmp_path / "bg.png")
    opacity, lamp = Address(OPACITY, "layer-1"), Address(LIGHT_POSITION)
    for frame, value in ((1, 0.2), (9, 0.8), (17, 0.5), (24, 1.0)):
        made = set_key(made, opacity, frame, value, Interpolation.BEZIER)
    made = set_key(made, opacity, 17, 0.5, Interpolation.HOLD)
    made = set_ease(made, frozenset(ref for ref in all_keys(made, opacity) if ref.frame == 9), (Ease(0.02, 0.7),), None)
    for frame, place in ((3, (10.0, -20.0, 40.0)), (12, (50.0, -30.0, 60.0)), (20, (20.0, -25.0, 30.0))):
        made = set_key(made, lamp, frame, place, Interpolation.LINEAR)
    made = set_ease(
        made, frozenset(ref for ref in all_keys(made, lamp) if ref.frame == 12), (Ease(),), (Ease(1.5, 0.2),)
    )
    made = review.set_marker(made, Marker(7, "turn", 3))
    made = review.add_note(made, opacity, 9, "Lighter", "Sato")
    return review.set_work_area(made, 3, 20)


def test_the_composition_has_the_documents_layers_from_the_bottom(document: Document, tmp_path: Path) -> None:
    done = handed_off(document, tmp_path / "ae")
    assert done.script == tmp_path / "ae" / "cut 12.jsx"
    run = run_script(done.script, tmp_path / "ae.json")
    assert run.tree["alerts"] == []
    comp = run.item("cut 12", "CompItem")
    assert (comp["width"], comp["height"], comp["duration"], comp["frameRate"]) == (WIDTH, HEIGHT, 1.0, 24.0)
    assert comp["workArea"] == pytest.approx([2 / 24, 18 / 24])
    names = [layer["name"] for layer in reversed(comp["layers"])]
    assert names == ["Background", "A shadow", "B shadow", "A", "B", "Ground line", "Light"]
    blends = [layer["blend"] for layer in reversed(comp["layers"])][:5]
    assert blends == ["NORMAL", "MULTIPLY", "MULTIPLY", "NORMAL", "NORMAL"]
    assert all((each["startTime"], each["inPoint"], each["outPoint"]) == (0, 0, 1.0) for each in comp["layers"])
    (marker,) = comp["markers"]
    assert (marker["time"], marker["value"]["comment"]) == (0.25, "turn")
    assert marker["value"]["duration"] == pytest.approx(3 / 24)
    (note,) = property_of(run.layer("cut 12", "A shadow"), "ADBE Marker")["keys"]
    assert note["value"]["comment"] == "Sato: Opacity: Lighter"
    assert run.tree["undo"] == {"open": 0, "groups": 1}


def test_footage_is_gap_free_with_its_rate_and_alpha(document: Document, tmp_path: Path) -> None:
    run = run_script(_script(handed_off(document, tmp_path / "ae")), tmp_path / "ae.json")
    shadow = run.item("A shadow", "FootageItem")
    assert (shadow["frames"], shadow["rate"], shadow["alpha"], shadow["folder"]) == (24, 24, "STRAIGHT", "Shadows")
    assert (run.item("B", "FootageItem")["frames"], run.item("B", "FootageItem")["folder"]) == (2, "Characters")
    background = run.item("background", "FootageItem")
    assert (background["alpha"], background["folder"]) == ("STRAIGHT", "Background"), "it may have holes"
    assert all(Path(each["file"]).is_relative_to(tmp_path / "ae") for each in run.tree["items"] if each["file"])


def test_shadows_are_written_at_full_opacity_which_is_keyed_in_after_effects(
    document: Document, tmp_path: Path
) -> None:
    run = run_script(_script(handed_off(document, tmp_path / "ae")), tmp_path / "ae.json")
    pixels = read_cel(tmp_path / "ae" / "shadows" / "A_shadow" / "A_shadow_0001.png").rgba
    assert pixels[..., 3].max() == 255
    opacity = property_of(run.layer("cut 12", "A shadow"), TRANSFORM, "ADBE Opacity")
    address = Address(OPACITY, "layer-1")
    for frame in range(1, 25):
        wanted = value_of(document, address, frame)
        assert isinstance(wanted, float)
        assert value_at(opacity, seconds(frame, document.canvas.frame_rate)) == pytest.approx(100 * wanted, abs=0.1)


@pytest.mark.parametrize("fov", [0.0, 40.0])
def test_the_light_follows_the_same_path(document: Document, tmp_path: Path, fov: float) -> None:
    document = with_values(document, camera__fov=fov)
    run = run_script(_script(handed_off(document, tmp_path / "ae")), tmp_path / "ae.json")
    light = run.layer("cut 12", "Light")
    assert not light["enabled"]
    for frame in range(1, 25):
        x, y, z = components_of(value_of(document, Address(LIGHT_POSITION), frame)) or ()
        seen = project(camera_at(document, frame).canvas_from_world(), (x, y, z, 1.0))
        time = seconds(frame, document.canvas.frame_rate)
        for part in (0, 1):
            channel = property_of(light, TRANSFORM, f"ADBE Position_{part}")
            assert value_at(channel, time) == pytest.approx(seen[part], abs=0.1)


def test_ground_and_grounding_points_are_nulls_with_keys(document: Document, tmp_path: Path) -> None:
    points = Address(GROUNDING, "layer-1")
    document = set_key(document, points, 1, ((12.0, 40.0), (20.0, 41.0)))
    document = set_key(document, points, 24, ((30.0, 40.0), (38.0, 39.0)))
    document = with_key(document, "ground.declination", 5, 50.0)
    document = with_values(document, ground__roll=4.0)
    run = run_script(_script(handed_off(document, tmp_path / "ae")), tmp_path / "ae.json")
    ground = run.layer("cut 12", "Ground line")
    assert property_of(ground, TRANSFORM, "ADBE Position_1")["value"] == 40
    assert property_of(ground, TRANSFORM, "ADBE Rotate Z")["value"] == 4
    slider = property_of(ground, "ADBE Effect Parade", "Declination", "ADBE Slider Control-0001")
    assert slider["keys"][0]["value"] == 50
    second = run.layer("cut 12", "A grounding 2")
    for frame in (1, 9, 24):
        wanted = value_of(document, points, frame)[1]  # type: ignore[index]
        time = seconds(frame, document.canvas.frame_rate)
        found = [value_at(property_of(second, TRANSFORM, f"ADBE Position_{part}"), time) for part in (0, 1)]
        assert found == pytest.approx(list(wanted), abs=0.1)  # type: ignore[arg-type]


def test_drawings_are_held_by_time_remapping_and_empty_cels_have_no_opacity(document: Document, tmp_path: Path) -> None:
    run = run_script(_script(handed_off(document, tmp_path / "ae")), tmp_path / "ae.json")
    layer = run.layer("cut 12", "B")
    remap, opacity = property_of(layer, "ADBE Time Remapping"), property_of(layer, TRANSFORM, "ADBE Opacity")
    assert all(key["out"] == "HOLD" for key in remap["keys"] + opacity["keys"])
    shown = []
    for frame in (1, 2, 3, 4, 5, 24):
        time = seconds(frame, document.canvas.frame_rate)
        picture = int(value_at(remap, time) * 24)
        shown.append(picture if value_at(opacity, time) else None)
    assert shown == [None, 0, None, None, 1, 1]


def test_the_shadow_of_the_set_is_a_layer_below_the_characters(document: Document, tmp_path: Path) -> None:
    document = add_piece(document, "crate", "box", {"casts": True})
    document = with_key(with_key(document, "set.shadow.opacity", 1, 0.25), "set.shadow.opacity", 24, 0.75)
    run = run_script(_script(handed_off(document, tmp_path / "ae", mattes=("lit",))), tmp_path / "ae.json")
    names = [layer["name"] for layer in reversed(run.item("cut 12", "CompItem")["layers"])]
    assert names[:4] == ["Background", "Set shadow", "A shadow", "B shadow"]
    opacity = property_of(run.layer("cut 12", "Set shadow"), TRANSFORM, "ADBE Opacity")
    assert [key["value"] for key in opacity["keys"]] == [25, 75]
    assert run.item("Set shadow", "FootageItem")["frames"] == 24
    lit = [layer["source"] for layer in reversed(run.item("Lit area", "CompItem")["layers"])]
    assert sorted(lit) == ["A shadow matte", "B shadow matte", "Set shadow matte", "White"]


def test_notes_about_the_scene_are_markers_and_none_takes_the_place_of_another(
    document: Document, tmp_path: Path
) -> None:
    lamp, opacity = Address(LIGHT_POSITION), Address(OPACITY, "layer-1")
    for frame, text in ((7, "Too low"), (2, "From the left")):
        document = review.add_note(document, lamp, frame, text, "")
    document = review.add_note(document, opacity, 9, "Or darker?", "Abe")
    run = run_script(_script(handed_off(document, tmp_path / "ae")), tmp_path / "ae.json")
    comments = [marker["value"]["comment"] for marker in run.item("cut 12", "CompItem")["markers"]]
    assert comments == ["Light position: From the left", "turn\nLight position: Too low"]
    (note,) = property_of(run.layer("cut 12", "A shadow"), "ADBE Marker")["keys"]
    assert note["value"]["comment"] == "Sato: Opacity: Lighter\nAbe: Opacity: Or darker?"


def test_each_different_shadow_once_when_asked(tmp_path: Path) -> None:
    document = cut(tmp_path, count=3, length=12)
    done = handed_off(document, tmp_path / "ae", per_drawing=True)
    files = sorted(path.name for path in (tmp_path / "ae" / "shadows" / "A_shadow").iterdir())
    assert files == ["A_shadow_0001.png", "A_shadow_0002.png", "A_shadow_0003.png"]
    run = run_script(_script(done), tmp_path / "ae.json")
    remap = property_of(run.layer("cut 12", "A shadow"), "ADBE Time Remapping")
    assert [int(value_at(remap, (frame - 1) / 24) * 24) for frame in (1, 2, 3, 12)] == [0, 1, 2, 2]


def test_a_second_run_updates_and_doubles_nothing(document: Document, tmp_path: Path) -> None:
    once = run_script(_script(handed_off(document, tmp_path / "ae")), tmp_path / "1.json")
    twice = run_script(tmp_path / "ae" / "cut 12.jsx", tmp_path / "2.json", times=2)
    assert twice.tree["items"] == once.tree["items"]
    assert twice.tree["calls"].count("importFile") == once.tree["calls"].count("importFile")


def test_a_shorter_cut_leaves_no_frames_behind(tmp_path: Path) -> None:
    document = cut(tmp_path, count=6)
    handed_off(document, tmp_path / "ae")
    canvas = document.canvas
    short = set_canvas(document, type(canvas)(WIDTH, HEIGHT, canvas.frame_rate, 4))
    run = run_script(_script(handed_off(short, tmp_path / "ae")), tmp_path / "ae.json")
    assert run.item("A shadow", "FootageItem")["frames"] == 4
    assert run.item("A", "FootageItem")["frames"] == 4


def test_mattes_and_the_lit_area(document: Document, tmp_path: Path) -> None:
    run = run_script(
        _script(handed_off(document, tmp_path / "ae", mattes=("core", "distance", "lit"))), tmp_path / "ae.json"
    )
    lit = run.item("Lit area", "CompItem")
    assert [layer["source"] for layer in reversed(lit["layers"])] == ["White", "A shadow matte", "B shadow matte"]
    assert "ADBE Invert" in lit["layers"][0]["groups"]["ADBE Effect Parade"]["children"]
    whole, core, distance = (
        read_cel(tmp_path / "ae" / f"matte_{kind}" / "A_shadow" / "A_shadow_0003.png").rgba.astype(int)
        for kind in ("shadow", "core", "distance")
    )
    covered = whole[..., 3] > 250
    assert (whole[covered][:, :3] == 255).all()
    assert 0 < core[..., 3].sum() < 0.5 * whole[..., 3].sum()
    assert (distance[..., 3] == whole[..., 3]).all()
    # The ramp falls from the feet, at the bottom, upward.
    rows = [distance[y][covered[y]][:, 0].mean() for y in range(HEIGHT) if covered[y].any()]
    assert rows[-1] > 200
    assert all(upper <= lower + 1 for upper, lower in pairwise(rows))


def test_drawings_can_stay_where_they_are(document: Document, tmp_path: Path) -> None:
    done = handed_off(document, tmp_path / "ae", copies=False)
    assert not (tmp_path / "ae" / "characters").exists()
    assert tuple(map(str, done.notes)) == ()
    run = run_script(_script(done), tmp_path / "ae.json")
    item = run.item("B", "FootageItem")
    assert item["file"] == str(tmp_path / "more" / "b_0001.png")
    remap = property_of(run.layer("cut 12", "B"), "ADBE Time Remapping")
    assert int(value_at(remap, 4 / 24) * 24) == 2, "the third file, though the second is never seen"


def test_exr_drawings_that_stay_where_they_are_are_premultiplied(tmp_path: Path) -> None:
    document = cut(tmp_path, count=2)
    shown = tuple(replace(each, path=each.path.with_suffix(".exr")) for each in document.layers[0].cels.drawings)
    for old, new in zip(document.layers[0].cels.drawings, shown, strict=True):
        write_rgba(new.path, read_cel(old.path).rgba)
    document = replace_cels(document, replace(document.layers[0].cels, drawings=shown))
    run = run_script(_script(handed_off(document, tmp_path / "ae", copies=False)), tmp_path / "ae.json")
    assert Path(run.item("A", "FootageItem")["file"]).suffix == ".exr"
    assert run.item("A", "FootageItem")["alpha"] == "PREMULTIPLIED"
    assert run.item("A shadow", "FootageItem")["alpha"] == "STRAIGHT"


def test_drawings_whose_white_is_clear_are_copied_with_alpha(tmp_path: Path) -> None:
    document = cut(tmp_path, count=2)
    for drawing in document.layers[0].cels.drawings:
        rgba = read_cel(drawing.path).rgba
        paper = np.where(rgba[..., 3:] > 0, rgba[..., :3], 255).astype(np.uint8)
        Image.fromarray(paper).save(drawing.path)
    done = handed_off(document, tmp_path / "ae", copies=False)
    assert tuple(map(str, done.notes)) == ("the drawings of 'A' have no alpha, so they were copied with it",)
    copy = Image.open(tmp_path / "ae" / "characters" / "A" / "A_0001.png")
    assert copy.mode == "RGBA"
    assert np.asarray(copy)[0, 0, 3] == 0


def test_white_inside_outlines_is_in_the_copies(tmp_path: Path) -> None:
    document = cut(tmp_path, count=2)
    for drawing in document.layers[0].cels.drawings:
        paper = np.full((HEIGHT, WIDTH, 3), 255, np.uint8)
        paper[20:40, 20:30] = (200, 120, 40)
        paper[25:30, 23:27] = 255
        Image.fromarray(paper).save(drawing.path)
    handed_off(set_paper(document, "layer-1", Paper.BORDER), tmp_path / "ae", copies=False)
    copy = np.asarray(Image.open(tmp_path / "ae" / "characters" / "A" / "A_0001.png"))
    assert (copy[0, 0, 3], copy[27, 25, 3]) == (0, 255)


def test_drawings_with_gaps_are_copied_and_that_is_said(document: Document, tmp_path: Path) -> None:
    (tmp_path / "more" / "b_0002.png").unlink()
    layer = document.layers[1]
    assert referenced(layer.cels, 24) is None
    done = handed_off(document, tmp_path / "ae", copies=False)
    assert tuple(map(str, done.notes)) == ("the drawings of 'B' are not a sequence without gaps, so they were copied",)
    assert len(list((tmp_path / "ae" / "characters" / "B").iterdir())) == 2


def test_a_hand_off_never_replaces_the_drawings_it_is_made_of(tmp_path: Path) -> None:
    shown = drawings(tmp_path / "ae" / "characters" / "A", 3, "A")
    document = replace_cels(cut(tmp_path / "cut"), Cels(shown, (Exposure(1, 2), Exposure(2, 0), Exposure(3, 1))))
    before = [drawing.path.read_bytes() for drawing in shown]
    run = run_script(_script(handed_off(document, tmp_path / "ae")), tmp_path / "ae.json")
    assert [drawing.path.read_bytes() for drawing in shown] == before
    remap = property_of(run.layer("cut 12", "A"), "ADBE Time Remapping")
    assert [int(value_at(remap, frame / 24) * 24) for frame in (0, 1, 2)] == [2, 0, 1]
    shown[1].path.unlink()
    document = replace_cels(document, Cels((shown[2], shown[0]), (Exposure(1, 0), Exposure(2, 1))))
    with pytest.raises(OutputProblem, match="the drawings of 'A' lie there themselves"):
        handed_off(document, tmp_path / "ae")
    assert [shown[0].path.read_bytes(), shown[2].path.read_bytes()] == [before[0], before[2]]


def test_drawings_of_different_sizes_become_as_large_as_the_canvas(tmp_path: Path) -> None:
    document = cut(tmp_path, count=2)
    small = np.zeros((20, 80, 4), np.uint8)
    small[8:12, 38:42] = 255
    write_rgba(document.layers[0].cels.drawings[1].path, small)
    handed_off(document, tmp_path / "ae")
    copy = read_cel(tmp_path / "ae" / "characters" / "A" / "A_0002.png").rgba
    assert copy.shape == (HEIGHT, WIDTH, 4)
    assert np.argwhere(copy[..., 3]).min(0).tolist() == [22, 30]


@settings(max_examples=25, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(name=st.one_of(st.sampled_from(NASTY), layer_names))
def test_no_name_escapes_its_string(name: str, tmp_path: Path) -> None:
    document = cut(tmp_path / "cut", length=6)
    written = Written(tmp_path, {(SHADOWS, "layer-1"): RenderedFootage(tmp_path / "a_1.png", 6)}, {}, None)
    made = hand_off(document, name, name, written)
    text = script_of(made)
    assert text.isascii()
    literal = text.partition("var HAND_OFF = ")[2].partition(";\n\n    /* What is said")[0]
    assert json.loads(literal)["name"] == name
    assert "\u2028" not in text


@pytest.mark.parametrize("name", [each for each in NASTY if each.isprintable()])
def test_a_nasty_layer_stays_in_its_folder_and_keeps_its_name(tmp_path: Path, name: str) -> None:
    document = rename_layer(cut(tmp_path / "cut", count=2), "layer-1", name)
    done = handed_off(document, tmp_path / "ae", name=name)
    assert done.script is not None
    assert done.script.parent == tmp_path / "ae"
    assert {path.name for path in tmp_path.iterdir()} == {"cut", "ae"}
    run = run_script(done.script, tmp_path / "ae" / "run.json")
    assert run.tree["alerts"] == []
    assert run.layer(name, f"{name} shadow")["source"] == f"{name} shadow"


def test_a_missing_file_is_one_readable_sentence(document: Document, tmp_path: Path) -> None:
    script = _script(handed_off(document, tmp_path / "ae"))
    (tmp_path / "ae" / "background" / "background.png").unlink()
    run = run_script(script, tmp_path / "ae.json")
    (said,) = run.tree["alerts"]
    assert "ファイルが見つかりません" in said
    assert "background.png" in said
    assert run.tree["undo"]["open"] == 0


def test_scripts_are_ecmascript_3_and_use_after_effects_as_it_is() -> None:
    panel = (resource_folder() / "after_effects" / "Kagezou.jsx").read_text(encoding="ascii")
    for text in (panel, built_of("/** @type {any} */ (null)")):
        assert complaints(text, checkers()) == ""


def test_the_checkers_do_complain() -> None:
    text = built_of("/** @type {any} */ (null)")
    assert complaints(text.replace("var carriers = [];", "const carriers = [];"), checkers())
    for words, said in (
        ("sizes = isLeft ? 1 : isRight ? 2 : 3;", "a condition in a condition"),
        ("sizes = isLeft && isRight || isFirstTime;", "&& beside ||"),
        ("sizes = known.class;", "a reserved word"),
    ):
        assert said in complaints(text.replace("sizes = {};", words), checkers())
    assert "conformFramerate" in complaints(
        text.replace("source.conformFrameRate", "source.conformFramerate"), checkers()
    )


def test_every_part_of_the_builder_is_in_the_script() -> None:
    text = built_of("null")
    for part in (resource_folder() / "after_effects" / "builder").iterdir():
        assert part.read_text(encoding="ascii") in text
        assert len(part.read_text(encoding="ascii").splitlines()) <= 400


def test_a_script_with_everything_in_it_passes_the_checkers(document: Document, tmp_path: Path) -> None:
    script = _script(handed_off(document, tmp_path / "ae", mattes=("lit",), per_drawing=True))
    assert complaints(script.read_text(encoding="ascii"), checkers()) == ""


def test_what_after_effects_cannot_have_is_refused(tmp_path: Path) -> None:
    document = cut(tmp_path, count=2)
    canvas = document.canvas
    with pytest.raises(UsageProblem, match="no composition of 2x48 px"):
        handed_off(set_canvas(document, type(canvas)(2, 48)), tmp_path / "ae")
    with pytest.raises(UsageProblem, match="there is no matte 'glow'"):
        handed_off(document, tmp_path / "ae", mattes=("glow",))
    with pytest.raises(UsageProblem, match="png or exr, not 'tga'"):
        handed_off(document, tmp_path / "ae", format="tga")


def test_a_key_is_reached_as_the_one_before_it_is_left() -> None:
    kinds = (Interpolation.HOLD, Interpolation.BEZIER, Interpolation.LINEAR, Interpolation.HOLD)
    track = Track(0.0, tuple(Key(frame, float(frame), kind) for frame, kind in enumerate(kinds, start=1)))
    keys = channel_of(track, 0, Fraction(24)).keys
    assert [(key.time, key.value) for key in keys] == [(n / 24, n + 1.0) for n in range(4)]
    # As After Effects makes keys itself, which gives one behind a hold an incoming hold.
    assert [key.into for key in keys] == ["LINEAR", "HOLD", "BEZIER", "LINEAR"]
    assert [key.out for key in keys] == ["HOLD", "BEZIER", "LINEAR", "HOLD"]


def replace_cels(document: Document, cels: Cels) -> Document:
    return replace(document, layers=(replace(document.layers[0], cels=cels),))


def _script(done: HandedOff) -> Path:
    assert done.script is not None
    return done.script
