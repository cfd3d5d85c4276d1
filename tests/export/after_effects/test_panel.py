"""The panel within After Effects: from layers of a composition to a project, and its shadows back into the same one."""

import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from kagezou.document.model import Document
from kagezou.io.project.file import load
from kagezou.locations import resource_folder
from tests.export.after_effects.extendscript import Run, run_script
from tests.export.small_cuts import drawings

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="the model of After Effects speaks to a POSIX shell")

Panel = Callable[[str], Run]


@pytest.fixture
def saved(tmp_path: Path) -> Path:
    return tmp_path / "walk cycle.kage"


@pytest.fixture
def panel(tmp_path: Path, saved: Path) -> Panel:
    """Run the panel and then what a user does, in JavaScript; the drawings lie in a folder with an awkward name."""
    folder = tmp_path / 'it\'s a "cut" 50%41'
    drawings(folder, 4, "a_")
    drawings(folder, 2, "other")
    program = tmp_path / "kage zou"
    program.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m kagezou "$@"\n')
    program.chmod(0o755)
    script = resource_folder() / "after_effects" / "Kagezou.jsx"
    sequence = str(folder / "a__0001.png").replace("%", "%25")
    head = f"var file = {sequence!r}; var make = 0, open = 1, bring = 2;"

    def run(words: str) -> Run:
        return run_script(script, tmp_path / "ae.json", mode=("panel", str(saved), str(program), head + words))

    return run


def shown(document: Document, layer: int = 0) -> list[tuple[int, str | None]]:
    cels = document.layers[layer].cels
    return [(each.frame, None if each.drawing is None else cels.drawings[each.drawing].name) for each in cels.exposures]


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
        system.callSystem("'" + app.settings.kept.program + "' set '" + settings.saveTo + "' layers.A.receives=true");
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


def test_a_project_is_never_replaced_unasked_and_moved_layers_are_told(panel: Panel, saved: Path) -> None:
    saved.write_text("mine")
    run = panel(f"""
        settings.saveTo = {str(saved.with_suffix(""))!r};
        var cut = newComp('cut', 4); var layer = cut.put(file, 'A'); layer.selected = true;
        layer._groups['ADBE Transform Group'].children['ADBE Scale'].value = [120, 120];
        answer = false; press(make);
    """)
    assert saved.read_text() == "mine"
    assert len(run.tree["asked"]) == 1
    saved.unlink()
    run = panel("""
        var cut = newComp('cut', 4); var layer = cut.put(file, 'A'); layer.selected = true;
        layer._groups['ADBE Transform Group'].children['ADBE Scale'].value = [120, 120]; press(make);
    """)
    assert len(run.tree["alerts"]) == 1
    assert "A" in run.tree["alerts"][0].splitlines()
