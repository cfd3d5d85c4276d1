"""Scenes for Nuke: what its nodes make of them is the composite, and what people wrote is never run."""

from pathlib import Path

import numpy as np
import pytest

from kagezou.document.model import Document
from kagezou.export.exchange.nuke import NUKE
from kagezou.export.exchange.stack import Stack, StackLayer
from tests.export.exchange.cuts import LENGTH, NAME, composites, levels_apart, made, rich_cut, united_cut
from tests.export.exchange.nuke_script import Node, nodes_of, shown


def of_kind(nodes: list[Node], kind: str) -> list[Node]:
    return [node for node in nodes if node.kind == kind]


def encoded(linear: object) -> object:
    light = np.asarray(linear)
    return np.where(light <= 0.0031308, light * 12.92, 1.055 * np.maximum(light, 0) ** (1 / 2.4) - 0.055)


@pytest.mark.parametrize("kind", ["rich", "clear", "united"])
def test_its_nodes_make_the_composite(kind: str, tmp_path: Path) -> None:
    document: Document = (
        united_cut(tmp_path / "in") if kind == "united" else rich_cut(tmp_path / "in", background=kind == "rich")
    )
    wanted = composites(document, tmp_path / "ref")
    done = made(document, tmp_path / "新しい 場所", NUKE)
    assert done.scene is not None
    nodes = nodes_of(done.scene.read_text(encoding="utf-8"))
    assert (nodes[-1].kind, len(wanted)) == ("Premult", LENGTH)
    (colours,) = of_kind(nodes, "Colorspace")
    for place, picture in enumerate(wanted):
        last = shown(colours, done.scene.parent, 101 + place)
        seen = picture[..., 3] > 0
        got = np.concatenate([np.asarray(encoded(last[..., :3])), last[..., 3:]], -1)
        assert levels_apart(got[..., 3], picture[..., 3]) <= 1
        light = got[..., :3] * got[..., 3:]
        assert levels_apart(light[seen], (picture[..., :3] * picture[..., 3:])[seen]) <= 1


def test_time_size_and_order_are_those_of_the_cut(tmp_path: Path) -> None:
    done = made(rich_cut(tmp_path / "in"), tmp_path / "out", NUKE)
    assert done.scene is not None
    nodes = nodes_of(done.scene.read_text(encoding="utf-8"))
    root = nodes[0]
    assert (root.kind, root.knob("first_frame"), root.knob("last_frame")) == ("Root", "101", "108")
    assert (root.knob("fps"), root.knob("format")) == ("23.976024", "64 48 0 0 64 48 1 kagezou_64x48")
    assert "nuke.script_directory()" in root.knobs["project_directory"]
    laid = [node for node in of_kind(nodes, "Merge2") if node.knob("name").startswith("Merge")]
    labels = [node.knob("label") for node in laid]
    assert labels == ["background", "主役 #1_shadow", "相棒_shadow", "主役 #1", "相棒"]
    assert [node.knobs["operation"] for node in laid] == ["over", "multiply", "over", "over", "over"]
    for node in of_kind(nodes, "Read"):
        file = node.knob("file")
        assert not Path(file).is_absolute()
        assert len(list((done.scene.parent / file).parent.glob("*.png"))) == LENGTH


def test_only_the_work_area_has_its_own_numbers(tmp_path: Path) -> None:
    done = made(rich_cut(tmp_path / "in"), tmp_path / "out", NUKE, frames=(3, 4))
    assert done.scene is not None
    root = nodes_of(done.scene.read_text(encoding="utf-8"))[0]
    assert (root.knob("first_frame"), root.knob("last_frame")) == ("103", "104")
    folder = tmp_path / "out" / "nuke_layers" / "background"
    assert [path.name for path in sorted(folder.iterdir())] == ["background_0103.png", "background_0104.png"]


def test_what_people_wrote_is_never_run() -> None:
    layer = StackLayer('[exit] $HOME "} {', "a", multiply=True, pictures=(1,), opacities=(0.5,))
    text = NUKE.write(Stack(NAME, 8, 8, 24, 1, 1, (layer,), every_frame=True)).text  # type: ignore[arg-type]
    assert r'label "\[exit] \$HOME \"} {"' in text
    assert "\n mix 0.5\n" in text
