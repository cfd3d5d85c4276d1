"""The panel within After Effects: from layers of a composition to a project, and its shadows back into the same one."""

import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from kagezou.document.figure_properties import SCALE
from kagezou.document.model import Document, drawing_offset
from kagezou.document.properties import GROUND_POSITION
from kagezou.document.values import value_at
from kagezou.geometry.placement import Placement
from kagezou.io.project.file import load
from kagezou.locations import resource_folder
from kagezou.scene.placing import PLACING, figure_box, placement_at
from tests.export.after_effects.extendscript import Run, property_of, run_script
from tests.export.small_cuts import drawings

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="the model of After Effects speaks to a POSIX shell")

Panel = Callable[[str], Run]


@pytest.fixture
def saved(tmp_path: Path) -> Path:
    return tmp_path / "walk cycle.kage"


@pytest.fixture(params=["Macintosh OS", "Windows 11"])
def system(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> str:
    monkeypatch.setenv("FAKE_OS", request.param)
    return str(request.param)


@pytest.fixture
def panel(tmp_path: Path, saved: Path) -> Panel:
    """Run the panel and then what a user does, in JavaScript; the drawings lie in a folder with an awkward name."""
    return panel_at(tmp_path, saved, tmp_path / "kage zou")


def panel_at(tmp_path: Path, saved: Path, program: Path, before: str = "") -> Panel:
    """Return a panel whose program first does something else."""
    folder = tmp_path / 'it\'s a "cut" 50%41'
    drawings(folder, 4, "a_")
    drawings(folder, 2, "other")
    program.write_text(f'#!/bin/sh\n{before}\nexec "{sys.executable}" -m kagezou "$@"\n')
    program.chmod(0o755)
    script = resource_folder() / "after_effects" / "Kagezou.jsx"
    sequence = str(folder / "a__0001.png").replace("%", "%25")
    head = f"var file = {sequence!r}; var make = 0, open = 1, bring = 2, missing = 3, bar = 5, status = 6, cancel = 7;"

    def run(words: str) -> Run:
        return run_script(script, tmp_path / "ae.json", mode=("panel", str(saved), str(program), head + words))

    return run


def shown(document: Document, layer: int = 0) -> list[tuple[int, str | None]]:
    cels = document.layers[layer].cels
    return [(each.frame, None if each.drawing is None else cels.drawings[each.drawing].name) for each in cels.exposures]


@pytest.mark.usefixtures("system")
def test_the_panel_goes_the_whole_round(panel: Panel, saved: Path) -> None:
    run = panel("""
        var cut = newComp('cut', 24);
        cut.put(file, 'under'); cut.put(file, "Hero's = 1").selected = true; cut.put(file, 'over');
        press(make); press(bring);
        cut.selectedLayers[0].selected = false;
        press(bring);
    """)
    assert run.tree["alerts"] == []
    names = [layer["name"] for layer in run.item("cut", "CompItem")["layers"]]
    assert names == ["Light", "Ground line", "over", "Hero's = 1", "Hero's _ 1 shadow", "under"]
    shadow = run.item("Hero's _ 1 shadow", "FootageItem")
    assert (shadow["rate"], shadow["frames"]) == (24, 24), "as long as the composition"
    assert run.item("walk cycle", "FolderItem")["kind"] == "FolderItem"
    assert run.tree["undo"]["open"] == 0
    document = load(saved)
    assert document.canvas.length_frames == 24
    assert [drawing.path.name for drawing in document.layers[0].cels.drawings] == [
        f"a__{number:04d}.png" for number in range(1, 5)
    ], "its own files, not the others in the folder"


def test_the_project_has_the_timing_of_the_layers(panel: Panel, saved: Path) -> None:
    run = panel("""
        var cut = newComp('cut', 24);
        var late = cut.put(file, 'late'); late.selected = true;
        late.startTime = 6 / 24; late.inPoint = 7 / 24; late.outPoint = 9 / 24;
        var held = cut.put(file, 'held'); held.selected = true; held.timeRemapEnabled = true;
        held._groups['ADBE Time Remapping'].keys = [[0, 2.5], [8, 0.5], [16, 3.5]].map(
            (at) => ({ time: at[0] / 24, value: at[1] / 24 }));
        var opacity = held._groups['ADBE Transform Group'].children['ADBE Opacity'];
        opacity.setValuesAtTimes([0, 12 / 24, 14 / 24], [100, 0, 100]);
        opacity.keys.forEach((key) => { key.out = 'HOLD'; });
        press(make);
    """)
    assert run.tree["alerts"] == []
    document = load(saved)
    assert [layer.name for layer in document.layers] == ["late", "held"]
    assert shown(document) == [(1, None), (8, "2"), (9, "3"), (10, None)]
    assert shown(document, 1) == [(1, "3"), (9, "1"), (13, None), (15, "1"), (17, "4")]


def test_footage_of_another_rate_is_timed_as_it_is_seen(panel: Panel, saved: Path) -> None:
    run = panel("""
        var cut = newComp('cut', 24); var layer = cut.put(file, 'A'); layer.selected = true;
        layer.source._take(layer.source.mainSource.file, true);
        layer.source.mainSource.rate = 6; layer.source.duration = 4 / 6; layer.outPoint = 4 / 6;
        press(make);
    """)
    assert run.tree["alerts"] == []
    assert shown(load(saved)) == [(1, "1"), (5, "2"), (9, "3"), (13, "4"), (17, None)]


def test_what_characters_cast_on_each_other_comes_back_over_them(panel: Panel, saved: Path) -> None:
    run = panel("""
        var cut = newComp('cut', 4);
        ['under', 'A', 'B', 'over'].forEach((name) => { cut.put(file, name).selected = name.length < 2; });
        press(make); press(bring);
        callProgram('set', settings.saveTo, 'layers.A.receives=true');
        press(bring); press(bring);
    """)
    assert run.tree["alerts"] == []
    names = [layer["name"] for layer in run.item("cut", "CompItem")["layers"]]
    assert names == [
        "Light", "Ground line", "over", "B", "A received", "A", "A, B shadows", "under"
    ]  # fmt: skip
    within = [layer["name"] for layer in run.item("A, B shadows", "CompItem")["layers"]]
    assert within == ["B shadow", "A shadow"]
    assert run.item("A received", "FootageItem")["frames"] == 4
    assert saved.exists()


def test_each_composition_has_its_own_project(panel: Panel, tmp_path: Path, saved: Path) -> None:
    other = tmp_path / "b" / saved.name
    other.parent.mkdir()
    run = panel(f"""
        var one = newComp('one', 4); one.comment = 'my own words'; one.put(file, 'A').selected = true;
        press(make);
        settings.saveTo = {str(other)!r};
        var two = newComp('two', 4); two.put(file, 'A').selected = true;
        press(make); press(bring);
        app.project.activeItem = one; press(bring);
    """)
    assert run.tree["alerts"] == []
    assert run.item("one")["comment"] == f"my own words kagezou-project: {saved}"
    files = [Path(each["file"]).parents[2] for each in run.tree["items"] if each["name"] == "A shadow"]
    assert files == [other.with_name("walk cycle_ae"), saved.with_name("walk cycle_ae")]


def test_a_composition_without_a_project_asks_for_it(panel: Panel, saved: Path) -> None:
    run = panel("""
        var cut = newComp('cut', 4); cut.put(file, 'A').selected = true;
        press(make);
        cut.comment = ''; press(bring);
        settings.openFile = settings.saveTo; press(bring);
    """)
    assert run.tree["alerts"] == []
    assert run.item("cut", "CompItem")["comment"].endswith(str(saved))
    assert [each["name"] for each in run.tree["items"]].count("A shadow") == 1


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("app.project.activeItem = null; press(make);", "コンポジションを開いて"),
        ("newComp('cut', 4); press(make);", "選択してください"),
        ("newComp('cut', 4).put(file, 'A').selected = true; settings.mayWrite = false; press(make);", "許可して"),
        ("var cut = newComp('cut', 4); cut.put(file, 'A').selected = true; press(make);"
         "cut.selectedLayers[0].selected = false; press(bring);", "影を敷く"),
    ],
)  # fmt: skip
def test_what_cannot_be_done_is_one_readable_sentence(panel: Panel, words: str, said: str) -> None:
    run = panel(words)
    assert len(run.tree["alerts"]) == 1
    assert said in run.tree["alerts"][0]
    assert run.tree["undo"]["open"] == 0


def test_a_project_is_never_replaced_unasked(panel: Panel, saved: Path) -> None:
    saved.write_text("mine")
    run = panel(f"""
        settings.saveTo = {str(saved.with_suffix(""))!r};
        var cut = newComp('cut', 4); cut.put(file, 'A').selected = true;
        answer = false; press(make);
    """)
    assert saved.read_text() == "mine"
    assert len(run.tree["asked"]) == 1


HELD = """
    var cut = newComp('cut', 5);
    var transformOf = (layer) => layer._groups['ADBE Transform Group'].children;
    var put = (name) => { var layer = cut.put(file, name); layer.selected = true; return layer; };
"""


def test_moved_layers_are_handed_over(panel: Panel, saved: Path) -> None:
    run = panel(f"""
        {HELD}
        var moved = transformOf(put('moved')), mirrored = transformOf(put('mirrored'));
        put('still');
        moved['ADBE Anchor Point'].value = [14, 40];
        moved['ADBE Position'].setValuesAtTimes([0, 4 / 24], [[100, 200], [180, 220]]);
        moved['ADBE Rotate Z'].value = 400;
        mirrored['ADBE Scale'].value = [-50, 120.5];
        mirrored['ADBE Position'].dimensionsSeparated = true;
        mirrored['ADBE Position_0'].value = 70;
        press(make);
    """)
    assert run.tree["alerts"] == []
    document = load(saved)
    moved, mirrored, still = document.layers
    assert [key.value for key in moved.tracks["position"].keys] == [
        (100, 200), (120, 205), (140, 210), (160, 215), (180, 220)
    ]  # fmt: skip
    assert [moved.tracks[name].constant for name in ("anchor", "rotation")] == [(14, 40), 400]
    assert value_at(moved.tracks, SCALE, 1) == (100, 100)
    assert [mirrored.tracks[name].constant for name in ("position", "scale")] == [(70, 120), (-50, 120.5)]
    assert still.tracks.keys().isdisjoint(PLACING)
    lowest = max(figure_box(document, layer.id, 1).bottom for layer in document.layers)
    assert value_at(document.tracks, GROUND_POSITION, 1)[1] == pytest.approx(lowest, abs=1), "where they stand now"


def test_what_a_layer_is_parented_to_is_in_its_own_keys(panel: Panel, saved: Path) -> None:
    run = panel(f"""
        {HELD}
        var child = put('child'), parent = cut.put(file, 'parent'), root = cut.put(file, 'root');
        child.parent = parent; parent.parent = root;
        transformOf(child)['ADBE Position'].value = [10, 4];
        transformOf(child)['ADBE Anchor Point'].value = [16, 40];
        transformOf(child)['ADBE Rotate Z'].value = 20;
        transformOf(child)['ADBE Scale'].value = [150, 80];
        transformOf(parent)['ADBE Anchor Point'].value = [2, 3];
        transformOf(parent)['ADBE Position'].value = [30, 20];
        transformOf(parent)['ADBE Scale'].value = [-200, 200];
        transformOf(root)['ADBE Anchor Point'].value = [0, 0];
        transformOf(root)['ADBE Position'].setValuesAtTimes([0, 4 / 24], [[160, 100], [200, 100]]);
        transformOf(root)['ADBE Rotate Z'].setValuesAtTimes([0, 4 / 24], [0, 720]);
        press(make);
    """)
    assert run.tree["alerts"] == []
    document = load(saved)
    (layer,) = document.layers
    for frame in range(1, 6):
        along = (frame - 1) / 4
        root = Placement((160 + 40 * along, 100.0), (0.0, 0.0), (1.0, 1.0), 720 * along)
        parent = Placement((30.0, 20.0), (2.0, 3.0), (-2.0, 2.0))
        child = Placement((10.0, 4.0), (16.0, 40.0), (1.5, 0.8), 20.0)
        wanted = root.canvas_from_centred() @ parent.canvas_from_centred() @ child.canvas_from_centred()
        found = placement_at(document, layer, frame)
        assert found is not None
        shift = np.eye(3)
        shift[:2, 2] = drawing_offset(document.canvas, layer)
        assert found.canvas_from_centred() @ shift == pytest.approx(wanted, abs=1e-3)
    turns = [key.value for key in layer.tracks["rotation"].keys]
    assert np.diff(np.array(turns, float)) == pytest.approx([180] * 4, abs=1e-3), "turns go on, never back"


def test_what_cannot_be_handed_over_is_said_by_layer(panel: Panel, saved: Path) -> None:
    run = panel(f"""
        {HELD}
        var deep = put('deep'), masked = put('masked'), warped = put('warped');
        var skewed = put('skewed'), late = put('late');
        put('plain')._groups['ADBE Effect Parade'].addProperty('ADBE Tint');
        deep.threeDLayer = true; transformOf(deep)['ADBE Rotate Z'].value = 30;
        masked._groups['ADBE Mask Parade'].children.one = masked._groups['ADBE Marker']; masked.hasTrackMatte = true;
        warped._groups['ADBE Effect Parade'].addProperty('ADBE Geometry2'); warped.autoOrient = 'PATH';
        var parent = cut.put(file, 'parent'); skewed.parent = parent;
        transformOf(parent)['ADBE Scale'].value = [100, 50];
        transformOf(skewed)['ADBE Rotate Z'].value = 30;
        late.timeRemapEnabled = true;
        late._groups['ADBE Time Remapping'].keys = [{{ time: 0, value: 0 }}, {{ time: 2 / 24, value: 9 }}];
        press(make);
    """)
    (said,) = run.tree["alerts"]
    assert said.splitlines()[1:] == [
        "deep: 3D レイヤー",
        "masked: マスク, トラックマット",
        "warped: 自動方向, ADBE Geometry2",
        "skewed: 親レイヤーによる歪み",
        "late: 素材の範囲外のタイムリマップ",
    ]
    assert load(saved).layers[0].tracks.keys().isdisjoint(PLACING)


def test_shadows_of_moved_layers_come_back_where_they_are(panel: Panel, saved: Path) -> None:
    run = panel(f"""
        {HELD}
        var moved = transformOf(put('moved'));
        moved['ADBE Position'].setValuesAtTimes([0, 4 / 24], [[60, 200], [200, 200]]);
        press(make); press(bring); press(bring);
    """)
    assert run.tree["alerts"] == []
    shadow = run.layer("cut", "moved shadow")
    position = property_of(shadow, "ADBE Transform Group", "ADBE Position")
    assert (position["value"], position["keys"]) == ([160, 120], []), "rendered where it is, so never moved"
    assert saved.exists()


def test_all_that_is_seen_comes_back(panel: Panel, saved: Path, tmp_path: Path) -> None:
    """Sets drawn as clay, patches, reflections, and what falls on characters in both blend modes."""
    corners = [(x, y, z) for x in (-40, 40) for y in (0, 80) for z in (-40, 40)]
    faces = ("1 2 4 3", "5 7 8 6", "1 5 6 2", "3 4 8 7", "1 3 7 5", "2 6 8 4")
    text = "".join(f"v {x} {y} {z}\\n" for x, y, z in corners) + "".join(f"f {each}\\n" for each in faces)
    crate = f"'--file', {str(tmp_path / 'crate.obj')!r}"
    run = panel(f"""
        var cut = newComp('cut', 2);
        ['street', 'A', 'B', 'C'].forEach((name) => {{ cut.put(file, name).selected = name.length < 2; }});
        press(make);
        disk.writeFileSync({str(tmp_path / "crate.obj")!r}, '{text}');
        callProgram('piece', settings.saveTo, 'add', 'crate', 'mesh', 'display="clay"', 'position=[200,200]', {crate});
        callProgram('piece', settings.saveTo, 'add', 'far', 'mesh', 'display="clay"', 'under=true', {crate});
        callProgram('set', settings.saveTo, 'layers.A.receives=true', 'layers.C.shadow.blend="normal"',
            'layers.A.contact.strength=0.8', 'layers.A.reflection.opacity=0.5');
        press(bring);
    """)
    assert run.tree["alerts"] == []
    names = [layer["name"] for layer in run.item("cut", "CompItem")["layers"]]
    assert names[2:] == [
        "C", "B", "A received normal", "A received", "A", "A reflection", "A contact", "C shadow", "A, B shadows",
        "Set clay", "street", "Set clay under background",
    ]  # fmt: skip
    assert saved.exists()
