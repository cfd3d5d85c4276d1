"""Precompositions in the panel: what lies in them goes over as cels of one figure, timed and moved as it is seen."""

import sys
from pathlib import Path

import numpy as np
import pytest

from kagezou.document.model import drawing_offset
from kagezou.geometry.placement import Placement
from kagezou.io.project.file import load
from kagezou.scene.placing import placement_at
from tests.export.after_effects.test_panel import Panel, panel, saved, shown

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="the model of After Effects speaks to a POSIX shell")
__all__ = ["panel", "saved"]

NESTED = """
    var cut = newComp('cut', 6);
    var room = (name, width, height) => new CompItem(name, width || 320, height || 240, 1, 1, 24);
    var into = (comp, name) => {
        var layer = comp.layers.add(new FootageItem(new File(file), true));
        layer.name = name; layer.source.mainSource.conformFrameRate = 24; layer.startTime = 0;
        return layer;
    };
    var lay = (comp, item, name) => {
        var layer = comp.layers.add(item); layer.name = name; layer.startTime = 0; return layer;
    };
    var transformOf = (layer) => layer._groups['ADBE Transform Group'].children;
"""


def test_the_layers_of_a_precomposition_are_one_figure(panel: Panel, saved: Path) -> None:
    run = panel(f"""
        {NESTED}
        var hero = room('hero');
        into(hero, 'body'); into(hero, 'arm'); into(hero, 'off').enabled = false;
        hero.layers.addNull(1);
        lay(cut, hero, 'Hero').selected = true;
        cut.put(file, 'B').selected = true;
        press(make); press(bring);
    """)
    assert run.tree["alerts"] == []
    document = load(saved)
    assert [layer.name for layer in document.layers] == ["Hero", "Hero arm", "B"]
    hero, arm, other = document.layers
    assert (hero.joins, arm.joins, other.joins) == (None, hero.id, None)
    names = [layer["name"] for layer in run.item("cut", "CompItem")["layers"]]
    assert names == ["Light", "Ground line", "B", "Hero", "Hero, B shadows"]


def test_time_goes_through_every_composition(panel: Panel, saved: Path) -> None:
    run = panel(f"""
        {NESTED}
        var inner = room('inner'), middle = room('middle');
        var cel = into(inner, 'cel'); cel.startTime = 1 / 24; cel.inPoint = 1 / 24; cel.outPoint = 5 / 24;
        var one = lay(middle, inner, 'one'); one.startTime = -1 / 24; one.inPoint = -1 / 24;
        var two = lay(cut, middle, 'two'); two.startTime = 1 / 24; two.inPoint = 2 / 24; two.outPoint = 1;
        two.selected = true;
        var held = lay(cut, middle, 'held'); held.selected = true; held.timeRemapEnabled = true;
        held._groups['ADBE Time Remapping'].keys = [[0, 2], [3, 0]].map(
            (at) => ({{ time: at[0] / 24, value: (at[1] + 0.5) / 24, out: 'HOLD' }}));
        press(make);
    """)
    assert run.tree["alerts"] == []
    document = load(saved)
    assert [layer.name for layer in document.layers] == ["two", "held"]
    assert shown(document) == [(1, None), (3, "2"), (4, "3"), (5, "4"), (6, None)]
    assert shown(document, 1) == [(1, "3"), (4, "1")]


def test_place_goes_through_every_composition(panel: Panel, saved: Path) -> None:
    run = panel(f"""
        {NESTED}
        var inner = room('inner', 200, 100), cel = into(inner, 'cel'), guide = into(inner, 'guide');
        guide.enabled = false; cel._parent = guide;
        transformOf(guide)['ADBE Anchor Point'].value = [3, 4];
        transformOf(guide)['ADBE Position'].value = [90, 40];
        transformOf(guide)['ADBE Rotate Z'].value = 30;
        transformOf(cel)['ADBE Anchor Point'].value = [20, 30];
        transformOf(cel)['ADBE Position'].value = [12, 9];
        transformOf(cel)['ADBE Scale'].value = [150, 80];
        var outer = lay(cut, inner, 'outer'); outer.selected = true;
        outer.startTime = 1 / 24; outer.inPoint = 0;
        transformOf(outer)['ADBE Anchor Point'].value = [100, 50];
        transformOf(outer)['ADBE Position'].setValuesAtTimes([0, 5 / 24], [[100, 120], [200, 120]]);
        transformOf(outer)['ADBE Scale'].value = [-200, 200];
        transformOf(guide)['ADBE Position'].setValuesAtTimes([0, 4 / 24], [[90, 40], [130, 40]]);
        press(make);
    """)
    (said,) = run.tree["alerts"]
    assert said.splitlines()[1:] == ["outer: プリコンポーズの端で切れる部分"]
    document = load(saved)
    (layer,) = document.layers
    for frame in range(1, 7):
        outside, inside = (frame - 1) / 5, max(frame - 2, 0) / 4
        outer = Placement((100 + 100 * outside, 120.0), (100.0, 50.0), (-2.0, 2.0))
        guide = Placement((90 + 40 * inside, 40.0), (3.0, 4.0), (1.0, 1.0), 30.0)
        cel = Placement((12.0, 9.0), (20.0, 30.0), (1.5, 0.8))
        wanted = outer.canvas_from_centred() @ guide.canvas_from_centred() @ cel.canvas_from_centred()
        found = placement_at(document, layer, frame)
        assert found is not None
        shift = np.eye(3)
        shift[:2, 2] = drawing_offset(document.canvas, layer)
        assert found.canvas_from_centred() @ shift == pytest.approx(wanted, abs=1e-3)


def test_one_that_only_lies_there_is_not_moved(panel: Panel, saved: Path) -> None:
    run = panel(f"""
        {NESTED}
        var inner = room('inner'); into(inner, 'cel');
        lay(cut, inner, 'Hero').selected = true;
        press(make);
    """)
    assert run.tree["alerts"] == []
    assert "position" not in load(saved).layers[0].tracks


def test_what_of_a_precomposition_is_not_handed_over_is_said(panel: Panel, saved: Path) -> None:
    run = panel(f"""
        {NESTED}
        var hero = room('hero'), cropped = room('cropped', 60, 60);
        into(hero, 'body').hasTrackMatte = true;
        hero.layers.addSolid([1, 0, 0], 'red', 20, 20, 1, 1);
        into(cropped, 'wide');
        lay(cut, hero, 'Hero').selected = true; lay(cut, cropped, 'Prop').selected = true;
        press(make);
    """)
    (said,) = run.tree["alerts"]
    assert said.splitlines()[1:] == [
        "Hero: ファイルのないもの: red",
        "Hero: トラックマット",
        "Prop: プリコンポーズの端で切れる部分",
    ]
    assert [layer.name for layer in load(saved).layers] == ["Hero", "Prop"]


def test_one_without_any_file_is_refused_by_name(panel: Panel, saved: Path) -> None:
    run = panel(f"""
        {NESTED}
        var empty = room('empty'); empty.layers.addSolid([1, 0, 0], 'red', 20, 20, 1, 1);
        lay(cut, empty, 'Nobody').selected = true;
        press(make);
    """)
    assert run.tree["alerts"] == ["ファイルのないレイヤーです: Nobody"]
    assert not saved.exists()


def test_layers_of_a_photoshop_document_are_refused_by_name(panel: Panel, saved: Path, tmp_path: Path) -> None:
    (tmp_path / "cut.psd").write_bytes(b"")
    run = panel(f"""
        {NESTED}
        var imported = room('cut.psd'), item = new FootageItem(new File({str(tmp_path / "cut.psd")!r}), false);
        item.name = 'A_0001/cut.psd'; lay(imported, item, 'A_0001');
        lay(cut, imported, 'A').selected = true;
        press(make);
    """)
    (said,) = run.tree["alerts"]
    assert said.splitlines()[1:] == ["A > A_0001"]
    assert not saved.exists()


def test_one_that_runs_backward_and_one_that_only_sounds(panel: Panel, saved: Path) -> None:
    run = panel(f"""
        {NESTED}
        var hero = room('hero'), cel = into(hero, 'cel'); into(hero, 'sound').hasVideo = false;
        cel.stretch = -100; cel.startTime = 4 / 24; cel.inPoint = 4 / 24; cel.outPoint = 0;
        lay(cut, hero, 'Hero').selected = true;
        press(make);
    """)
    assert run.tree["alerts"] == []
    document = load(saved)
    assert [layer.name for layer in document.layers] == ["Hero"]
    assert [cel for _, cel in shown(document)] == ["4", "3", "2", "1", None]
