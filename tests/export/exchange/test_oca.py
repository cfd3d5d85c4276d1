"""Open Cel Animation, written: what its frames say is the composite, in the words of its specification."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from kagezou.export.exchange.export import SceneMade
from kagezou.export.exchange.oca import OCA
from tests.export.exchange.cuts import LENGTH, composites, levels_apart, made, pixels_of, rich_cut, united_cut


def read(done: SceneMade) -> Any:
    assert done.scene is not None
    return json.loads(done.scene.read_text(encoding="utf-8"))


def laid(document: Any, folder: Path, frame: int) -> Any:
    """Return a frame, from 0, as its layers say: (H, W, 4), colours multiplied by alpha."""
    canvas = np.zeros((document["height"], document["width"], 4))
    for layer in document["layers"]:
        (shown,) = (
            each for each in layer["frames"] if each["frameNumber"] <= frame < each["frameNumber"] + each["duration"]
        )
        if shown["name"] == "_blank":
            assert shown["fileName"] == ""
            continue
        stored = pixels_of(folder / shown["fileName"])
        assert (stored.shape[1], stored.shape[0]) == (shown["width"], shown["height"])
        a, b = stored[..., 3:] * shown["opacity"], canvas[..., 3:].copy()
        over = stored[..., :3] * a
        multiplied = over * (1 - b) + canvas[..., :3] * (1 - a) + over * canvas[..., :3]
        plain = over + canvas[..., :3] * (1 - a)
        canvas[..., :3] = {"multiply": multiplied, "normal": plain}[layer["blendingMode"]]
        canvas[..., 3:] = a + b - a * b
    return canvas


@pytest.mark.parametrize("kind", ["rich", "clear", "united"])
def test_its_layers_make_the_composite(kind: str, tmp_path: Path) -> None:
    folder = tmp_path / "in"
    document = united_cut(folder) if kind == "united" else rich_cut(folder, background=kind == "rich")
    done = made(document, tmp_path / "新しい 場所", OCA)
    for place, picture in enumerate(composites(document, tmp_path / "ref")):
        wanted = np.concatenate([picture[..., :3] * picture[..., 3:], picture[..., 3:]], -1)
        assert levels_apart(laid(read(done), tmp_path / "新しい 場所", place), wanted) <= 1


def test_the_root_says_what_the_cut_is(tmp_path: Path) -> None:
    done = made(rich_cut(tmp_path / "in"), tmp_path / "out", OCA, depth=16)
    root = read(done)
    assert (root["ocaVersion"], root["originApp"], root["name"]) == ("1.1.0", "Kagezou", "カット 12")
    assert (root["width"], root["height"], root["startTime"], root["endTime"]) == (64, 48, 0, LENGTH)
    assert (root["frameRate"], root["colorDepth"]) == (pytest.approx(24000 / 1001), "U16")
    assert root["layers"][0]["name"] == "background"
    assert any("frame 0 is frame 101 here" in str(note) for note in done.notes)
    for layer in root["layers"]:
        assert sum(frame["duration"] for frame in layer["frames"]) == LENGTH
        assert layer["animated"] == (len(layer["frames"]) > 1)
        assert layer["opacity"] == layer["frames"][0]["opacity"]
    (buddy,) = (layer for layer in root["layers"] if layer["name"] == "相棒")
    assert [(frame["frameNumber"], frame["duration"], frame["name"]) for frame in buddy["frames"]] == [
        (0, 4, "相棒_0001"),
        (4, 2, "相棒_0002"),
        (6, 2, "_blank"),
    ]
