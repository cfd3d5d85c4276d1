"""Scenes for Blender, built and rendered by Blender itself."""

from pathlib import Path

import pytest

from kagezou.export.exchange.blender import BLENDER
from tests.export.exchange.cuts import LENGTH, composites, levels_apart, made, on_white, pixels_of, rich_cut, united_cut
from tests.programs.programs import needs, ran


@needs("blender")
@pytest.mark.parametrize("kind", ["rich", "clear", "united"])
def test_blender_renders_the_composite(kind: str, tmp_path: Path) -> None:
    folder = tmp_path / "in"
    document = united_cut(folder) if kind == "united" else rich_cut(folder, background=kind == "rich")
    done = made(document, tmp_path / "新しい 場所", BLENDER)
    assert done.scene is not None
    script = done.scene.parent.rename(tmp_path / "moved") / done.scene.name
    words = ("--background", "--factory-startup", "--python", str(script), "--", "--render", str(tmp_path / "made"))
    said = ran(tmp_path / "home", "blender", *words)
    frames = sorted((tmp_path / "made").glob("*.png"))
    assert [path.name for path in frames] == [f"frame_{101 + each:04d}.png" for each in range(LENGTH)], said
    for path, picture in zip(frames, composites(document, tmp_path / "ref"), strict=True):
        assert levels_apart(pixels_of(path)[..., :3], on_white(picture)) <= 1
