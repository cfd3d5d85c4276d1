"""Scenes for OpenToonz: what its columns and effects make is the composite, written as its streams are read."""

from fractions import Fraction
from pathlib import Path

import pytest

from kagezou.export.exchange.export import SceneMade
from kagezou.export.exchange.opentoonz import OPENTOONZ
from kagezou.export.exchange.stack import Stack, StackLayer
from tests.export.exchange.cuts import LENGTH, composites, levels_apart, made, rich_cut, united_cut
from tests.export.exchange.toonz_scene import Scene, scene_in


def opened(done: SceneMade) -> Scene:
    assert done.scene is not None
    return Scene(scene_in(done.scene.read_text(encoding="utf-8")), done.scene.parent)


@pytest.mark.parametrize("kind", ["rich", "united"])
def test_its_effects_make_the_composite(kind: str, tmp_path: Path) -> None:
    document = united_cut(tmp_path / "in") if kind == "united" else rich_cut(tmp_path / "in")
    scene = opened(made(document, tmp_path / "新しい 場所", OPENTOONZ))
    for row, picture in enumerate(composites(document, tmp_path / "ref")):
        assert levels_apart(scene.shown(row), picture) <= 1


def test_what_it_mixes_otherwise_is_said(tmp_path: Path) -> None:
    clear = made(united_cut(tmp_path / "in"), tmp_path / "filled", OPENTOONZ)
    assert not any("in its own way" in str(note) for note in clear.notes)
    layers = [StackLayer(name, name, multiply=True, pictures=(1,), opacities=(0.5,)) for name in ("a", "b")]
    for count, told in ((1, False), (2, True)):
        stack = Stack("c", 8, 8, Fraction(24), 1, 1, tuple(layers[:count]), is_filled=False)
        assert any("in its own way" in str(note) for note in OPENTOONZ.write(stack).notes) == told


def test_columns_camera_and_time_are_those_of_the_cut(tmp_path: Path) -> None:
    done = made(rich_cut(tmp_path / "in"), tmp_path / "out", OPENTOONZ)
    scene = opened(done)
    root = scene.root
    assert root.attributes == {"version": "71.1", "framecount": str(LENGTH)}
    assert root.find("properties/cameras/camera/cameraRes").words == ["64", "48"]
    width = float(root.find("xsheet/pegbars/pegbar/camera/cameraSize").words[0])
    assert width * float(root.find("levelSet/levels/level/info").attributes["dpix"]) == pytest.approx(64)
    assert float(root.find("properties/outputs/output/fps").words[0]) == pytest.approx(24000 / 1001, abs=1e-6)
    pegs = {peg.attributes["id"]: peg for peg in root.find("xsheet/pegbars").tags}
    assert list(pegs) == ["Camera1", "Table", *(f"Col{each}" for each in range(1, 6))]
    names = [pegs[f"Col{each}"].find("name").words for each in range(1, 6)]
    assert names == [["background"], ["主役 #1_shadow"], ["相棒_shadow"], ["主役 #1"], ["相棒"]]
    cells = [cell.words for cell in scene.columns[4].find("cells").tags]
    assert cells == [["0", "4", "0001", "0"], ["4", "2", "0002", "0"]]
    assert any("its frame 1 is frame 101 here" in str(note) for note in done.notes)


def test_what_people_wrote_stays_within_its_quotes() -> None:
    layer = StackLayer('a" <b> & \\', "a", multiply=False, pictures=(1,), opacities=(0.5,))
    text = OPENTOONZ.write(Stack("c", 8, 8, Fraction(24), 1, 1, (layer,))).text
    assert scene_in(text).find("xsheet/fxnodes/internal/fxnode/STD_inoOverFx/name").words == ['a" _b_ _ \\']
