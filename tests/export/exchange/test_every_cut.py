"""Every scene against the picture, over what may come together in a cut: sets, received shadows, looks, blends."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from kagezou.document.model import Document, Exposure
from kagezou.export.exchange.blender import BLENDER
from kagezou.export.exchange.export import SceneMade
from kagezou.export.exchange.fusion import FUSION
from kagezou.export.exchange.natron import NATRON
from kagezou.export.exchange.nuke import NUKE
from kagezou.export.exchange.oca import OCA
from kagezou.export.exchange.opentoonz import OPENTOONZ
from kagezou.export.exchange.stack import SceneTarget, SceneText, Stack
from tests.export.exchange import test_blender, test_natron, test_oca, test_opentoonz
from tests.export.exchange.cuts import composites, levels_apart, made, on_white
from tests.export.exchange.nuke_script import nodes_of, shown
from tests.export.exchange.test_fusion import opened
from tests.export.hand_over_cuts import EVERY, FRAMES, Combination, combined
from tests.export.small_cuts import HEIGHT, WIDTH, with_key
from tests.export.test_hand_overs import covering

Pixels = NDArray[np.float64]
Seen = Callable[[int], Pixels]
"""What a frame, from 1, shows: colours multiplied by alpha, (H, W, 4), or on white, (H, W, 3)."""


def drawn(document: Document, folder: Path, *, every_frame: bool, separator: str = "_") -> Stack:
    """Draw the pictures of all layers once for scenes that want them alike."""
    kept: list[Stack] = []

    def write(stack: Stack) -> SceneText:
        kept.append(stack)
        return SceneText("")

    made(document, folder, SceneTarget(".txt", "layers", write, every_frame=every_frame, separator=separator))
    return kept[0]


def written(target: SceneTarget, stack: Stack, folder: Path) -> SceneMade:
    """Write a scene beside the pictures."""
    scene = folder / f"{target.write.__name__}{target.suffix}"
    scene.write_text(target.write(stack).text, encoding="utf-8")
    return SceneMade(scene, (), 0, (), 0.0)


def in_blender(stack: Stack, folder: Path) -> Seen:
    cut = test_blender.cut_in(written(BLENDER, stack, folder).scene or folder)
    return lambda frame: np.asarray(test_blender.laid(cut, folder, frame))


def in_nuke(stack: Stack, folder: Path) -> Seen:
    script = written(NUKE, stack, folder).scene or folder
    (last,) = (node for node in nodes_of(script.read_text(encoding="utf-8")) if node.kind == "Unpremult")
    return lambda frame: shown(last.inputs[0], folder, frame)


def in_natron(stack: Stack, folder: Path) -> Seen:
    last = test_natron.built(written(NATRON, stack, folder)).nodes[-1]
    return lambda frame: last.shown(frame, (WIDTH, HEIGHT))


def in_fusion(stack: Stack, folder: Path) -> Seen:
    comp = opened(written(FUSION, stack, folder))
    return lambda frame: comp.shown(comp.table["ActiveTool"], frame)[..., :3]


def in_oca(stack: Stack, folder: Path) -> Seen:
    root: Any = test_oca.read(written(OCA, stack, folder))
    return lambda frame: np.asarray(test_oca.laid(root, folder, frame - 1))


def in_opentoonz(stack: Stack, folder: Path) -> Seen:
    scene = test_opentoonz.opened(written(OPENTOONZ, stack, folder))
    return lambda frame: scene.shown(frame - 1)


SCENES = {False: (in_blender, in_oca), True: (in_nuke, in_natron, in_fusion)}
"""By whether they want a file for every frame."""


@pytest.mark.parametrize("wanted", covering(EVERY), ids=str)
def test_what_is_seen_goes_over(wanted: Combination, tmp_path: Path) -> None:
    document = combined(wanted, tmp_path)
    pictures = composites(document, tmp_path / "picture")
    for every_frame, scenes in SCENES.items():
        folder = tmp_path / f"every frame {every_frame}"
        stack = drawn(document, folder, every_frame=every_frame)
        for make in scenes:
            seen = make(stack, folder)
            for frame in range(1, FRAMES + 1):
                assert_alike(seen(frame), pictures[frame - 1], make.__name__)


def test_what_moves_goes_over(tmp_path: Path) -> None:
    document = combined(Combination("clay", "received", "joined", "unlike", "multiply"), tmp_path)
    for path, first, last in (
        ("layers.A.position", [32, 24], [40, 20]),
        ("layers.B.scale", [100, 100], [60, 140]),
        ("layers.C.rotation", 0, 25),
        ("background.position", [32, 24], [20, 30]),
    ):
        document = with_key(with_key(document, path, 1, first), path, FRAMES, last)
    behind = replace(document.behind, exposures=(*document.behind.exposures, Exposure(3, None)))
    document = replace(document, behind=behind)
    pictures = composites(document, tmp_path / "picture")
    for every_frame, scenes in SCENES.items():
        folder = tmp_path / f"every frame {every_frame}"
        stack = drawn(document, folder, every_frame=every_frame)
        for make in scenes:
            seen = make(stack, folder)
            for frame in range(1, FRAMES + 1):
                assert_alike(seen(frame), pictures[frame - 1], make.__name__)


@pytest.mark.parametrize("wanted", covering(EVERY)[:5], ids=str)
def test_in_opentoonz_it_does_where_something_fills_the_canvas(wanted: Combination, tmp_path: Path) -> None:
    document = combined(wanted, tmp_path)
    pictures = composites(document, tmp_path / "picture")
    seen = in_opentoonz(drawn(document, tmp_path / "out", every_frame=False, separator="."), tmp_path / "out")
    for frame in range(1, FRAMES + 1):
        # Its upper left corner is clear; what is laid on each other there, it mixes in its own way.
        assert_alike(seen(frame)[14:, 22:], pictures[frame - 1][14:, 22:], "OpenToonz")


def assert_alike(got: Pixels, picture: Pixels, name: str) -> None:
    """See that a scene shows the picture, within one level of 8 bit."""
    if got.shape[-1] == 3:
        assert levels_apart(got, on_white(picture)) <= 1, name
    else:
        assert levels_apart(got[..., 3], picture[..., 3]) <= 1, name
        assert levels_apart(on_white_of(got), on_white(picture)) <= 1, name


def on_white_of(multiplied: Pixels) -> Pixels:
    return multiplied[..., :3] + 1 - multiplied[..., 3:]
