"""Running the script again: what the document says is brought up to date, what the user did in After Effects stays."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from kagezou.document import review
from kagezou.document.edits import add_layer, remove_layer, rename_layer, set_exposures, still
from kagezou.document.model import Cels, Document, Exposure, Marker
from kagezou.export.after_effects.export import HandOffRequest, export_to_after_effects
from kagezou.geometry.box import Box
from kagezou.io.images.writing import write_rgba
from kagezou.render.gpu.context import open_headless_context
from tests.export.after_effects.extendscript import BACK, GONE, LEFT, property_of, run_edited, run_script
from tests.export.small_cuts import HEIGHT, WIDTH, cut, drawings, with_key, with_values

OPACITY = ("ADBE Transform Group", "ADBE Opacity")
REMAP = "ADBE Time Remapping"


def script_in(document: Document, folder: Path, name: str = "cut", **options: object) -> Path:
    request = HandOffRequest(folder=folder, name=name, **options)  # type: ignore[arg-type]
    done = export_to_after_effects(document, request, open_headless_context, lambda _done, _all: None, lambda: False)
    assert done.script is not None
    return done.script


def with_second(document: Document, folder: Path) -> Document:
    """Add B, whose shadow has another look."""
    cels = Cels(drawings(folder, 2, "b"), (Exposure(1, 0), Exposure(2, 1)))
    return with_values(add_layer(document, "B", cels, Box(1, 1, 2, 2)), layers__B__shadow__opacity=0.5)


def order(run_layers: list[dict[str, object]]) -> list[object]:
    return [layer["name"] for layer in reversed(run_layers)]


def test_opacity_follows_the_document_until_the_user_changes_it(tmp_path: Path) -> None:
    document = cut(tmp_path / "cut", count=2)
    first = script_in(document, tmp_path / "1")
    darker = with_values(document, layers__A__shadow__opacity=0.9)
    second = script_in(darker, tmp_path / "2")
    run = run_edited(first, tmp_path / "ae.json", ("", second))
    assert property_of(run.layer("cut", "A shadow"), *OPACITY)["value"] == pytest.approx(90)
    run = run_edited(first, tmp_path / "ae.json", ("opacityOf('cut', 'A shadow').value = 33;", second))
    assert property_of(run.layer("cut", "A shadow"), *OPACITY)["value"] == 33
    assert run.summary()[LEFT] == ["A shadow: opacity"]


def test_keys_of_opacity_are_kept_when_one_was_changed_and_else_follow(tmp_path: Path) -> None:
    document = with_key(cut(tmp_path / "cut", count=4), "layers.A.shadow.opacity", 1, 0.2)
    document = with_key(document, "layers.A.shadow.opacity", 4, 0.8)
    first = script_in(document, tmp_path / "1")
    second = script_in(with_key(document, "layers.A.shadow.opacity", 4, 0.6), tmp_path / "2")
    key = "opacityOf('cut', 'A shadow').keys[1]"
    for edit, wanted in (("", 60), (f"{key}.value = 71;", 71), (f"{key}.out = 'HOLD';", 80)):
        run = run_edited(first, tmp_path / "ae.json", (edit, second))
        keys = property_of(run.layer("cut", "A shadow"), *OPACITY)["keys"]
        assert keys[1]["value"] == pytest.approx(wanted)


def test_trimming_and_slipping_of_the_users_own_stay(tmp_path: Path) -> None:
    document = with_key(cut(tmp_path / "cut", count=4), "layers.A.shadow.opacity", 1, 0.2)
    first = script_in(document, tmp_path / "ae")
    edit = "var own = layerOf('cut', 'A shadow'); own.startTime = 1; own.inPoint = 1.0417; own.outPoint = 1.125;"
    run = run_edited(first, tmp_path / "ae.json", (edit, first))
    layer = run.layer("cut", "A shadow")
    assert (layer["startTime"], layer["inPoint"], layer["outPoint"]) == (1, 1.0417, 1.125)


def test_markers_of_the_user_stay_and_ours_do_not_double(tmp_path: Path) -> None:
    document = review.set_marker(
        review.set_marker(cut(tmp_path / "cut", count=6), Marker(2, "turn", 1)), Marker(5, "b")
    )
    first = script_in(document, tmp_path / "1")
    moved = review.set_marker(review.remove_marker(document, 2), Marker(3, "turn", 0))
    second = script_in(moved, tmp_path / "2")
    edit = (
        "comp('cut').markerProperty.setValueAtTime(3 / 24, new MarkerValue('mine'));"
        "comp('cut').markerProperty.setValueAtTime(2 / 24, new MarkerValue('hit'));"
    )
    run = run_edited(first, tmp_path / "ae.json", (edit, second), ("", second))
    said = [(round(key["time"] * 24), key["value"]["comment"]) for key in run.item("cut", "CompItem")["markers"]]
    assert said == [(2, "hit\nturn"), (3, "mine"), (4, "b")]


def test_a_layer_that_comes_later_lies_where_it_belongs(tmp_path: Path) -> None:
    document = cut(tmp_path / "cut", count=2)
    first = script_in(document, tmp_path / "1")
    write_rgba(tmp_path / "bg.png", np.full((HEIGHT, WIDTH, 4), 255, np.uint8))
    more = replace(with_second(document, tmp_path / "more"), behind=still(tmp_path / "bg.png"))
    run = run_edited(first, tmp_path / "ae.json", ("", script_in(more, tmp_path / "2")))
    names = order(run.item("cut", "CompItem")["layers"])
    assert names == ["Background", "A shadow", "B shadow", "A", "B", "Ground line", "Light"]


def test_a_layer_that_is_gone_is_switched_off_and_comes_back(tmp_path: Path) -> None:
    both = with_second(cut(tmp_path / "cut", count=2), tmp_path / "more")
    first = script_in(both, tmp_path / "1")
    alone = script_in(remove_layer(both, both.layers[1].id), tmp_path / "2")
    run = run_edited(first, tmp_path / "ae.json", ("", alone), ("", alone))
    assert [run.layer("cut", name)["enabled"] for name in ("A shadow", "A", "B shadow", "B")] == [
        True,
        True,
        False,
        False,
    ]
    assert run.summary(0)[GONE] == ["B shadow", "B"]
    assert GONE not in run.summary(), "said once, not on every run"
    run = run_edited(first, tmp_path / "ae.json", ("", alone), ("", first))
    assert [run.layer("cut", name)["enabled"] for name in ("B shadow", "B")] == [True, True]
    assert run.summary()[BACK] == ["B shadow", "B"]


def test_a_renamed_layer_takes_its_new_files_and_keeps_its_place(tmp_path: Path) -> None:
    document = cut(tmp_path / "cut", count=2)
    first = script_in(document, tmp_path / "ae")
    renamed = rename_layer(document, document.layers[0].id, "Hero 50%41 = 日本")
    # The first script is gone when the second is written into the same folder.
    kept = tmp_path / "ae" / "before.jsx"
    kept.write_bytes(first.read_bytes())
    run = run_edited(
        kept, tmp_path / "ae.json", ("layerOf('cut', 'A').name = 'mine';", script_in(renamed, tmp_path / "ae"))
    )
    assert run.left() == ["mine: name"]
    assert run.layer("cut", "mine")["source"] == "Hero 50%41 = 日本"
    assert run.layer("cut", "Hero 50%41 = 日本 shadow")["source"] == "Hero 50%41 = 日本 shadow"
    files = [Path(each["file"]).parent.name for each in run.tree["items"] if each["file"]]
    assert sorted(files) == ["Hero 50%41 = 日本", "Hero 50%41 = 日本_shadow"]


def test_held_shadows_become_frames_again(tmp_path: Path) -> None:
    document = cut(tmp_path / "cut", count=3, length=12)
    held = script_in(document, tmp_path / "1", per_drawing=True)
    frames = script_in(document, tmp_path / "2")
    run = run_edited(held, tmp_path / "ae.json", ("", frames))
    assert not run.layer("cut", "A shadow")["remap"]
    assert run.layer("cut", "A")["remap"], "the drawings are held as before"
    own = "layerOf('cut', 'A shadow').timeRemapEnabled = true;"
    assert run_edited(frames, tmp_path / "ae.json", (own, frames)).layer("cut", "A shadow")["remap"]


def test_empty_cels_that_are_filled_show_again(tmp_path: Path) -> None:
    document = cut(tmp_path / "cut", count=3, length=6)
    layer = document.layers[0].id
    empty = set_exposures(document, layer, (Exposure(1, 0), Exposure(3, None), Exposure(5, 1)))
    run = run_edited(script_in(empty, tmp_path / "1"), tmp_path / "ae.json", ("", script_in(document, tmp_path / "2")))
    opacity = property_of(run.layer("cut", "A"), *OPACITY)
    assert (opacity["keys"], opacity["value"]) == ([], 100)


def test_two_cuts_of_one_name_are_told_apart(tmp_path: Path) -> None:
    one = script_in(cut(tmp_path / "a" / "cels", count=2), tmp_path / "a" / "ae")
    other = script_in(cut(tmp_path / "b" / "cels", count=4), tmp_path / "b" / "ae")
    run = run_edited(one, tmp_path / "ae.json", ("answer = false;", other), ("", other), ("", one))
    assert len(run.tree["asked"]) == 1, "asked once, not on every run"
    assert str(tmp_path / "a" / "ae") in run.tree["asked"][0]
    shadows = [each["file"] for each in run.tree["items"] if each["name"] == "A shadow"]
    assert [Path(file).parents[2] for file in shadows] == [tmp_path / "a" / "ae", tmp_path / "b" / "ae"]
    assert [each["kind"] for each in run.tree["items"]].count("CompItem") == 2
    run = run_edited(one, tmp_path / "ae.json", ("answer = true;", other))
    (shadow,) = [each["file"] for each in run.tree["items"] if each["name"] == "A shadow"]
    assert Path(shadow).is_relative_to(tmp_path / "b")


def test_a_hand_off_that_was_moved_is_taken_without_a_question(tmp_path: Path) -> None:
    script = script_in(cut(tmp_path / "cut", count=2), tmp_path / "ae")
    (tmp_path / "moved").mkdir()
    move = f"disk.renameSync({str(tmp_path / 'ae')!r}, {str(tmp_path / 'moved' / 'ae')!r});"
    run = run_edited(script, tmp_path / "ae.json", (move, tmp_path / "moved" / "ae" / script.name))
    assert run.tree["asked"] == []
    assert [each["name"] for each in run.tree["items"]].count("A shadow") == 1


def test_drawings_that_were_left_are_found_after_a_move_of_everything_or_of_the_hand_off(tmp_path: Path) -> None:
    document = cut(tmp_path / "job" / "50%41", count=2)
    script = script_in(document, tmp_path / "job" / "out" / "ae", copies=False)
    (tmp_path / "elsewhere").mkdir()
    alone = (tmp_path / "job" / "out").rename(tmp_path / "elsewhere" / "out")
    run = run_script(alone / "ae" / script.name, tmp_path / "ae.json")
    assert run.tree["alerts"] == []
    assert run.item("A", "FootageItem")["file"] == str(tmp_path / "job" / "50%41" / "drawings" / "a_0001.png")
    (tmp_path / "job" / "50%41").rename(tmp_path / "elsewhere" / "50%41")
    run = run_script(alone / "ae" / script.name, tmp_path / "ae.json")
    assert run.tree["alerts"] == []
    assert run.item("A", "FootageItem")["file"] == str(tmp_path / "elsewhere" / "50%41" / "drawings" / "a_0001.png")


def test_many_layers_show_how_far_it_is_and_the_window_goes_whatever_happens(tmp_path: Path) -> None:
    document = cut(tmp_path / "cut", count=1)
    few = run_script(script_in(document, tmp_path / "few"), tmp_path / "ae.json")
    assert "show" not in few.tree["calls"]
    for number in range(2, 8):
        document = add_layer(document, f"L{number}", document.layers[0].cels, document.layers[0].figure)
    document = with_values(document, scene__shadows_unite=False)
    script = script_in(document, tmp_path / "ae")
    calls = [each for each in run_script(script, tmp_path / "ae.json").tree["calls"] if each != "importFile"]
    assert calls == ["show", *(f"at {done} of 28" for done in range(1, 29)), "close"]
    (tmp_path / "ae" / "characters" / "L4" / "L4_0001.png").unlink()
    run = run_script(script, tmp_path / "ae.json")
    assert len(run.tree["alerts"]) == 1
    assert run.tree["calls"][-1] == "close"


def test_drawings_lie_on_whole_pixels(tmp_path: Path) -> None:
    document = cut(tmp_path / "cut", count=1, length=2)
    write_rgba(document.layers[0].cels.drawings[0].path, np.full((HEIGHT + 3, WIDTH - 1, 4), 255, np.uint8))
    run = run_script(script_in(document, tmp_path / "ae"), tmp_path / "ae.json")
    x, y = property_of(run.layer("cut", "A"), "ADBE Transform Group", "ADBE Position")["value"]
    assert (x - (WIDTH - 1) / 2, y - (HEIGHT + 3) / 2) == (0, -2)
