"""Scenes for Blender: what the script says, and what its shaders make of that."""

import ast
import json
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from kagezou.export.exchange.blender import BLENDER, rate_of
from tests.export.exchange.cuts import (
    composites,
    levels_apart,
    made,
    on_white,
    pixels_of,
    rich_cut,
    united_cut,
)


def cut_in(script: Path) -> Any:
    """Return what the script is to build, and see that it is whole Python."""
    text = script.read_text(encoding="ascii")
    for node in ast.parse(text).body:
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name) and node.targets[0].id == "CUT":
            assert isinstance(node.value, ast.Call)
            return json.loads(ast.literal_eval(node.value.args[0]))
    raise AssertionError("the script has no cut")


def held_at(keys: list[list[Any]], frame: int) -> Any:
    return next(value for at, value in reversed(keys) if at <= frame)


def laid(cut: Any, folder: Path, frame: int) -> Any:
    """Return what its cards show: each lets through, and adds, what its shader says."""
    canvas = np.ones((cut["height"], cut["width"], 3))
    for layer in cut["layers"]:
        first = folder / layer["first"]
        number = held_at(layer["pictures"], frame)
        pixels = pixels_of(first.with_name(first.name.replace("_0001.png", f"_{number:04d}.png")))
        amount = pixels[..., 3:] * held_at(layer["opacities"], frame)
        if layer["multiply"]:
            canvas *= 1 + amount * (pixels[..., :3] - 1)
        else:
            canvas = canvas * (1 - amount) + pixels[..., :3] * amount
    return canvas


@pytest.mark.parametrize("kind", ["rich", "clear", "united"])
def test_its_cards_make_the_composite(kind: str, tmp_path: Path) -> None:
    folder = tmp_path / "in"
    document = united_cut(folder) if kind == "united" else rich_cut(folder, background=kind == "rich")
    done = made(document, tmp_path / "out", BLENDER)
    assert done.scene is not None
    cut = cut_in(done.scene)
    for place, picture in enumerate(composites(document, tmp_path / "ref")):
        assert levels_apart(laid(cut, done.scene.parent, 101 + place), on_white(picture)) <= 1
    said = [str(note) for note in done.notes]
    assert any("Blender has white there" in each for each in said) == (kind == "clear")


def test_each_picture_is_there_once_and_held(tmp_path: Path) -> None:
    done = made(rich_cut(tmp_path / "in"), tmp_path / "out", BLENDER)
    assert done.scene is not None
    cut = cut_in(done.scene)
    assert (cut["first"], cut["last"], cut["fps"], cut["fps_base"]) == (101, 108, 24, 1.001)
    layers = {layer["name"]: layer for layer in cut["layers"]}
    assert layers["相棒"]["pictures"] == [[101, 1], [105, 2]]
    assert layers["相棒"]["opacities"] == [[101, 1.0], [107, 0.0]]
    assert layers["主役 #1"]["pictures"] == [[101, 1], [102, 2], [103, 3], [104, 4]]
    assert layers["background"]["pictures"] == [[101, 1]]
    for layer in cut["layers"]:
        files = sorted((done.scene.parent / layer["first"]).parent.iterdir())
        assert len(files) == len({number for _, number in layer["pictures"]})


@pytest.mark.parametrize(
    ("rate", "said"),
    [
        (Fraction(24), (24, 1.0)),
        (Fraction(24000, 1001), (24, 1.001)),
        (Fraction(30000, 1001), (30, 1.001)),
        (Fraction(25, 2), (25, 2.0)),
        (Fraction(2997, 100), (2997, 100.0)),
    ],
)
def test_any_rate_is_a_whole_number_and_what_it_is_divided_by(rate: Fraction, said: tuple[int, float]) -> None:
    assert rate_of(rate) == said


def test_the_script_is_whole_whatever_people_wrote(tmp_path: Path) -> None:
    document = rich_cut(tmp_path / "in")
    names = ('"""\n\\N{BELL}', "😀 {x}")
    layers = tuple(replace(each, name=name) for each, name in zip(document.layers, names, strict=True))
    done = made(replace(document, layers=layers), tmp_path / "out", BLENDER)
    assert done.scene is not None
    assert set(names) <= {layer["name"] for layer in cut_in(done.scene)["layers"]}
