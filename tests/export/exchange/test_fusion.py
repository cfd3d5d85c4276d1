"""Scenes for Fusion: what its tools make of them is the composite."""

from fractions import Fraction
from pathlib import Path

import pytest

from kagezou.export.exchange.export import SceneMade
from kagezou.export.exchange.fusion import FUSION
from kagezou.export.exchange.stack import Stack, StackLayer
from tests.export.exchange.cuts import composites, levels_apart, made, on_white, rich_cut, united_cut
from tests.export.exchange.fusion_comp import Composition, table_in


def opened(done: SceneMade) -> Composition:
    assert done.scene is not None
    return Composition(table_in(done.scene.read_text(encoding="utf-8")), done.scene.parent)


@pytest.mark.parametrize("kind", ["rich", "clear", "united"])
def test_its_tools_make_the_composite(kind: str, tmp_path: Path) -> None:
    folder = tmp_path / "in"
    document = united_cut(folder) if kind == "united" else rich_cut(folder, background=kind == "rich")
    done = made(document, tmp_path / "新しい 場所", FUSION)
    comp = opened(done)
    for place, picture in enumerate(composites(document, tmp_path / "ref")):
        got = comp.shown(comp.table["ActiveTool"], 101 + place)
        assert levels_apart(got[..., :3], on_white(picture)) <= 1
    assert any("Fusion has white there" in str(note) for note in done.notes) == (kind == "clear")


def test_size_and_time_are_those_of_the_cut(tmp_path: Path) -> None:
    comp = opened(made(rich_cut(tmp_path / "in"), tmp_path / "out", FUSION))
    form = comp.table["Prefs"]["Comp"]["FrameFormat"]
    assert (form["Width"], form["Height"], form["Rate"]) == (64, 48, pytest.approx(24000 / 1001, abs=1e-6))
    assert [comp.table[name][1] for name in ("GlobalRange", "RenderRange")] == [101, 101]
    assert [comp.table[name][2] for name in ("GlobalRange", "RenderRange")] == [108, 108]
    said = [tool["Inputs"]["Comments"]["Value"] for tool in comp.tools.values() if tool["kind"] == "Loader"]
    assert said == ["background", "主役 #1_shadow", "相棒_shadow", "主役 #1", "相棒"]


def test_what_people_wrote_stays_within_its_string() -> None:
    name = 'a" }, os.exit() -- \\'
    layer = StackLayer(name, "a", multiply=False, pictures=(1,), opacities=(0.5,))
    text = FUSION.write(Stack("b", 8, 8, Fraction(24), 1, 1, (layer,), every_frame=True)).text
    loader = Composition(table_in(text), Path()).tools["Loader1"]
    assert loader["Inputs"]["Comments"]["Value"] == name
