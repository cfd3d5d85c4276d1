"""One frame by the window and by the command line: the same bytes (spec 7)."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np

from kagezou.document.address import resolve
from kagezou.document.edits import add_layer, set_constant
from kagezou.io.images.reading import read_cel
from kagezou.io.images.writing import write_rgba
from kagezou.tools.grounding import add_grounding
from kagezou.ui.window.main_window import MainWindow
from tests.ui.viewing import picture


def by_command_line(*arguments: str) -> None:
    """Run the program as a farm would: in a process of its own, with no display."""
    headless = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    subprocess.run([sys.executable, "-m", "kagezou", *arguments], check=True, env=headless)


def test_the_same_frame_by_window_and_by_command_line_is_the_same_bytes(walking: MainWindow, tmp_path: Path) -> None:
    ramp = np.zeros((200, 240, 4), np.uint8)
    ramp[..., 1] = np.arange(240)
    ramp[..., 3] = 255
    write_rgba(tmp_path / "ramp.png", ramp)
    open_project = walking.parts.open_project
    open_project.put_background(tmp_path / "ramp.png").at_once()
    document = open_project.bridge.document
    for point in ((108.0, 169.0), (132.0, 166.0)):
        document = add_grounding(document, document.layers[0].id, 1, point)
    open_project.bridge.session.edit("Ground", document)
    open_project.save(tmp_path / "cut.kage")
    open_project.bridge.session.go_to(3)
    shown = picture(walking.parts.viewport)

    by_command_line("render", str(tmp_path / "cut.kage"), "-o", str(tmp_path / "out"), "--frames", "3", "--composite")
    written = read_cel(tmp_path / "out" / "composite" / "composite_0003.png").rgba
    assert np.array_equal(shown, written)
    assert not np.array_equal(shown[..., :3], ramp[..., :3])


def test_what_characters_cast_on_each_other_is_the_same_in_every_view(walking: MainWindow, tmp_path: Path) -> None:
    open_project = walking.parts.open_project
    write_rgba(tmp_path / "paper.png", np.full((200, 240, 4), 255, np.uint8))
    open_project.put_background(tmp_path / "paper.png").at_once()
    document = open_project.bridge.document
    first = document.layers[0]
    document = add_layer(document, "Before", first.cels, first.figure)
    values = {
        f"layers.{first.name}.receives": True,
        f"layers.{first.name}.grounding": [[120.0, 160.0]],
        "layers.Before.grounding": [[118.0, 176.0]],
        "light.position": [90.0, 40.0, 260.0],
    }
    for path, value in values.items():
        document = set_constant(document, resolve(document, path), value)
    open_project.bridge.session.edit("Two", document)
    open_project.save(tmp_path / "cut.kage")
    shown = picture(walking.parts.viewport)
    walking.parts.actions["view_matte"].trigger()
    matte = picture(walking.parts.viewport)[..., 0]

    by_command_line("render", str(tmp_path / "cut.kage"), "-o", str(tmp_path / "out"), "--frames", "1", "--composite")
    composite = read_cel(tmp_path / "out" / "composite" / "composite_0001.png", white_is_clear=False)
    assert np.array_equal(shown, composite.rgba)
    written = read_cel(tmp_path / "out" / f"{first.name}_received" / f"{first.name}_received_0001.png").rgba[..., 3]
    assert (written > 0).sum() > 100
    assert (matte >= written).all()
